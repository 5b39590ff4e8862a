// Checkers of certificates on interpolation: limits and tangents of the witness are computed again from the running words,
// exactly. They search for nothing.
#include <set>

#include "operators/interrupt.h"
#include "operators/methods/interpolation/interpolate_points.h"
#include "operators/methods/interpolation/quad_fans.h"
#include "operators/schemes.h"
#include "proofs/checkers.h"
#include "proofs/interpolation_facts.h"

namespace udcp {
namespace {

/// The control mesh on which step 2 works, after checking that its limits are the points.
Surface<Rational> second_refinement(const ExactInterpolation& what, const Json& control, StopFlag stop) {
  const int count = what.cage.mesh->vertices();
  const Surface<Rational> first = first_refinement(what, rows_from(control, count, "control"));
  std::set<int> valences(what.cage.mesh->valences.begin(), what.cage.mesh->valences.end());
  for (const int n : valences) {
    throw_if_stopped(stop);
    require(are_masks_eigenvectors(n), "the masks of valence " + std::to_string(n) + " are not those of the running word");
  }
  require(limit_points(first, count) == what.cage.points, "control does not have its limits at the vertices");
  return run(schemes::catmull_clark(), first, 1);
}

}  // namespace

std::string check_interpolation(const Json& data, StopFlag stop) {
  require_entries(data, {"mesh", "normals", "step1", "lambda", "step2", "control"}, "data");
  const ExactInterpolation what = interpolation_from(data);
  const Surface<Rational> fine = second_refinement(what, data["control"], stop);
  std::vector<char> owned(static_cast<std::size_t>(fine.mesh->vertices()), 0);
  Fan fan;
  for (int v = 0; v < what.cage.mesh->vertices(); ++v) {
    throw_if_stopped(stop);
    const std::string place = "vertex " + std::to_string(v);
    collect_fan(*fine.mesh, v, fan);
    for (const std::vector<int>* list : {&fan.e, &fan.f}) {
      for (const int i : *list) {
        require(owned[static_cast<std::size_t>(i)] == 0, "the ring of " + place + " meets another one");
        owned[static_cast<std::size_t>(i)] = 1;
      }
    }
    const ExactRing ring = exact_ring(fine, v, what.normals.row(v));
    require(ring.side.sign() > 0, "the normal at " + place + " is on the wrong side before step 2");
    const CorrectedRing after = corrected(ring, what.tied);
    require(after.keeps_limit, "step 2 moves the limit of " + place);
    require(is_flat(after.heights), "the tangents at " + place + " are not across its normal after step 2");
  }
  return interpolation_statement(data);
}

std::string check_interpolation_reversed(const Json& data, StopFlag stop) {
  require_entries(data, {"mesh", "normals", "step1", "lambda", "step2", "control", "vertex"}, "data");
  const ExactInterpolation what = interpolation_from(data);
  const int v = integer_from(data["vertex"], 0, what.cage.mesh->vertices() - 1, "vertex");
  const Surface<Rational> fine = second_refinement(what, data["control"], stop);
  require(exact_ring(fine, v, what.normals.row(v)).side.sign() <= 0, "the normal of the vertex is on the right side");
  return reversed_statement(data, v);
}

std::string check_interpolation_threshold(const Json& data, StopFlag stop) {
  require_entries(data, {"rows"}, "data");
  require(
      data["rows"].is_array() && !data["rows"].empty() && static_cast<int>(data["rows"].size()) <= largest_interpolation_valence,
      "rows must be a list");
  std::vector<int> valences;
  for (const Json& json : data["rows"]) {
    throw_if_stopped(stop);
    require_entries(json, {"valence", "own", "edge", "face"}, "a row");
    const int n = integer_from(json["valence"], valences.empty() ? 3 : valences.back() + 1, largest_interpolation_valence,
                               "valence (rising)");
    const ExactLimitRow row = exact_limit_row(n);
    require(json["own"] == to_json(row.own) && json["edge"] == to_json(row.edge) && json["face"] == to_json(row.face),
            "the row of valence " + std::to_string(n) + " is not that of the running word");
    require(has_lambda_bound(row, n), "the row of valence " + std::to_string(n) + " does not have the bound");
    valences.push_back(n);
  }
  return threshold_statement(valences);
}

std::string check_interpolation_checkerboard(const Json& data, StopFlag stop) {
  require_entries(data, {"vertices", "faces", "lambda", "colours", "quotient"}, "data");
  const Mesh mesh = mesh_from(data["vertices"], data["faces"]);
  for (const int n : mesh.valences) require(n <= largest_interpolation_valence, "a valence is too large");
  require(data["colours"].is_string(), "colours must be a text");
  throw_if_stopped(stop);
  const Rational lambda = rational_from(data["lambda"], "lambda");
  const Rational quotient = checkerboard_quotient(mesh, data["colours"].get<std::string>(), lambda);
  require(rational_from(data["quotient"], "quotient") == quotient, "the quotient of the colours is " + quotient.to_string());
  require(quotient.sign() <= 0, "the quotient of the colours is positive");
  return checkerboard_statement(data);
}

}  // namespace udcp
