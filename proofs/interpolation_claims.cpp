// Finds the witnesses: control points, valences, colours.
#include "proofs/interpolation_claims.h"

#include <algorithm>
#include <set>

#include "operators/methods/interpolation/point_system.h"
#include "operators/schemes.h"
#include "proofs/budget.h"
#include "proofs/surface_c1.h"

namespace udcp {
namespace {

std::size_t at(int k) { return static_cast<std::size_t>(k); }

std::vector<int> valences_of(const Mesh& mesh) {
  const std::set<int> set(mesh.valences.begin(), mesh.valences.end());
  return {set.begin(), set.end()};
}

Points<Rational> find_witness(const ExactInterpolation& what, const SearchLimits& limits) {
  PointOptions options;
  options.control.stop = limits.stop;
  if (!what.global) {
    options.step = PointStep::local;
    return interpolate_points(what.cage, options).points.topRows(what.cage.mesh->vertices());
  }
  options.lambda = what.lambda;
  return solve_for_limits(what.cage, options);
}

// The first vertex whose normal is 90 degrees off or more; -1: none; -2: the limits were reached.
int find_reversed(const ExactInterpolation& what, const Points<Rational>& witness, const SearchLimits& limits) {
  Budget budget(limits);
  const Surface<Rational> fine = run(schemes::catmull_clark(), first_refinement(what, witness), 1);
  for (int v = 0; v < what.cage.mesh->vertices(); ++v) {
    if (!budget.spend()) return -2;
    if (exact_ring(fine, v, what.normals.row(v)).side.sign() <= 0) return v;
  }
  return -1;
}

}  // namespace

Result prove_interpolation(const ExactInterpolation& what, const SearchLimits& limits) {
  const std::string claim = "the surface passes exactly through every vertex and has there exactly its normal";
  const std::string reason = not_covered(what);
  if (!reason.empty()) return undecided(claim, reason);
  Points<Rational> witness;
  try {
    witness = find_witness(what, limits);
  } catch (const Error& error) {
    if (error.kind != ErrorKind::limit) throw;
    return undecided(claim, error.what());
  }
  const int reversed = find_reversed(what, witness, limits);
  if (reversed == -2) return undecided(claim, "the limits of the search were reached");
  Json data = to_json(what);
  data["control"] = to_json(witness);
  if (reversed >= 0) {
    data["vertex"] = reversed;
    Result result = concluded(Verdict::refuted, "the sign of (C2 x C3) . N before step 2, which projections keep",
                              seal("interpolation-reversed", reversed_statement(data, reversed), data));
    result.witness = Json{{"vertex", reversed}};
    return result;
  }
  std::vector<Result> parts = prove_surface_c1(schemes::catmull_clark(), valences_of(*what.cage.mesh), limits);
  parts.push_back(concluded(Verdict::proved, "exact points, and tangents in the field of their weights",
                            seal("interpolation", interpolation_statement(data), data), limits.stop));
  return all_of(std::move(parts));
}

Result prove_lambda_range(std::vector<int> valences) {
  std::sort(valences.begin(), valences.end());
  valences.erase(std::unique(valences.begin(), valences.end()), valences.end());
  const std::string claim = "the iteration converges for 7/20 < lambda <= 1";
  if (valences.empty() || valences.front() < 3 || valences.back() > largest_interpolation_valence)
    return undecided(claim, "the theorem is checked for valences from 3 to " + std::to_string(largest_interpolation_valence));
  Json rows = Json::array();
  for (const int n : valences) {
    const ExactLimitRow row = exact_limit_row(n);
    rows.push_back(Json{{"valence", n}, {"own", to_json(row.own)}, {"edge", to_json(row.edge)}, {"face", to_json(row.face)}});
  }
  Json data{{"rows", std::move(rows)}};
  Result result = concluded(Verdict::proved, "the rows are symmetric after scaling, and every quad gives at least -|x|^2",
                            seal("interpolation-threshold", threshold_statement(valences), std::move(data)));
  for (const int n : valences) result.details["bound at valence " + std::to_string(n)] = lambda_bound(n).to_string();
  return result;
}

namespace {

// 0 and 1 by vertex so that every edge has both; empty if there is no such colouring. The mesh may have several parts.
std::string two_colours(const Mesh& mesh) {
  std::string colours(at(mesh.vertices()), ' ');
  std::vector<int> open;
  for (int start = 0; start < mesh.vertices(); ++start) {
    if (colours[at(start)] != ' ') continue;
    colours[at(start)] = '0';
    open.push_back(start);
    while (!open.empty()) {
      const int v = open.back(), first = mesh.outgoing[at(v)];
      open.pop_back();
      for (int h = first; h >= 0;) {
        const int w = mesh.tip(h);
        if (colours[at(w)] == colours[at(v)]) return {};
        if (colours[at(w)] == ' ') {
          colours[at(w)] = colours[at(v)] == '0' ? '1' : '0';
          open.push_back(w);
        }
        h = mesh.around(h);
        if (h == first) break;
      }
    }
  }
  return colours;
}

std::string why_not_a_closed_quad_mesh(const Mesh& mesh) {
  for (int e = 0; e < mesh.edges(); ++e)
    if (mesh.is_boundary_edge(e)) return "the mesh is open";
  for (int f = 0; f < mesh.faces(); ++f)
    if (mesh.size(f) != 4) return "face " + std::to_string(f) + " is no quad";
  for (int v = 0; v < mesh.vertices(); ++v)
    if (mesh.valence(v) < 3) return "vertex " + std::to_string(v) + " has two edges";
  return {};
}

}  // namespace

Result prove_iteration_converges(const Mesh& mesh, const Rational& lambda) {
  const std::string claim = "the iteration over the mesh converges for lambda = " + lambda.to_string();
  const std::string reason = why_not_a_closed_quad_mesh(mesh);
  if (!reason.empty()) return undecided(claim, reason + "; the theorem is for closed quad meshes");
  const Rational threshold = Rational(7) / Rational(20);
  if (lambda > Rational(1)) return undecided(claim, "the theorem is for lambda up to 1");
  if (lambda > threshold) return prove_lambda_range(valences_of(mesh));
  if (mesh.vertices() > 1'000'000 ||
      *std::max_element(mesh.valences.begin(), mesh.valences.end()) > largest_interpolation_valence)
    return undecided(claim, "the mesh or a valence is too large");
  const std::string colours = two_colours(mesh);
  if (colours.empty())
    return undecided(claim, "lambda is not above 7/20, but the mesh is not two-colourable, so the bound need not be attained");
  const Rational quotient = checkerboard_quotient(mesh, colours, lambda);
  const Json data{{"vertices", mesh.vertices()},
                  {"faces", faces_to_json(mesh)},
                  {"lambda", to_json(lambda)},
                  {"colours", colours},
                  {"quotient", to_json(quotient)}};
  Result result = concluded(Verdict::refuted, "the vector of 1 and -1 by colour has the quotient " + quotient.to_string(),
                            seal("interpolation-checkerboard", checkerboard_statement(data), data));
  result.witness = Json{{"colours", colours}};
  return result;
}

}  // namespace udcp
