// Exact rows of Loop's word, and enclosures of its patches.
#include "proofs/loop_facts.h"

#include <algorithm>
#include <set>

#include "operators/matrix.h"
#include "operators/methods/offset/loop_limit.h"
#include "operators/schemes.h"
#include "proofs/linear_algebra.h"

namespace udcp {
namespace {

std::size_t at(int k) { return static_cast<std::size_t>(k); }

std::vector<int> sorted_with_regular(std::vector<int> valences) {
  valences.push_back(6);
  std::ranges::sort(valences);
  valences.erase(std::unique(valences.begin(), valences.end()), valences.end());
  return valences;
}

}  // namespace

Json loop_word(std::vector<int> valences) {
  return to_json(static_limit(schemes::loop()), sorted_with_regular(std::move(valences)));
}

void require_loop_word(const Json& word, std::vector<int> valences) {
  require(word == loop_word(std::move(valences)), "word is not Loop's with the parameters at the valences in question");
}

Algebraic limit_weight(int valence) {
  const Surface<double> ring = ring_mesh(valence, 1, true);
  const Surface<Algebraic> exact{ring.mesh, Points<Algebraic>::Zero(ring.points.rows(), 1), {}, {}};
  const Points<Algebraic> rows = subdivision_matrix(schemes::loop(), exact);
  // New vertex 0 and the new points on its edges, which are its new ring.
  Points<Algebraic> step(valence + 1, valence + 1);
  step.row(0) = rows.row(0);
  for (int h = 0; h < ring.mesh->half_edges(); ++h) {
    const int a = ring.mesh->vertex[at(h)], b = ring.mesh->tip(h);
    if (a == 0) step.row(b) = rows.row(ring.mesh->vertices() + ring.mesh->edge[at(h)]);
  }
  const Algebraic w = step(1, 0) / step(0, 1);
  for (int j = 0; j <= valence; ++j) {
    Algebraic sum = w * step(0, j);
    for (int i = 1; i <= valence; ++i) sum += step(i, j);
    require(sum == (j == 0 ? w : Algebraic(1)), "(w, 1, .. 1) is no left eigenvector of the word");
  }
  return w;
}

std::string to_string(LocalSet set) { return set == LocalSet::pair ? "pair" : "star"; }

int largest_contraction_valence(LocalSet set) { return set == LocalSet::pair ? 200 : 24; }

Algebraic contraction_bound(int valence, LocalSet set) {
  const Surface<double> mesh = ring_mesh(valence, 3, true);
  std::vector<int> members{0};
  for (int v = 1; v <= (set == LocalSet::pair ? 1 : valence); ++v) members.push_back(v);
  const auto n = static_cast<Eigen::Index>(members.size());
  const Algebraic centre = limit_weight(valence), regular = limit_weight(6);
  Points<Algebraic> matrix = Points<Algebraic>::Zero(n, n), unit = Points<Algebraic>::Zero(n, 1);
  unit(0, 0) = Algebraic(1);
  for (int i = 0; i < static_cast<int>(n); ++i) {
    matrix(i, i) = i == 0 ? centre : regular;
    for (const int u : vertex_ring(*mesh.mesh, i))
      if (u < static_cast<int>(n)) matrix(i, u) += Algebraic(1);
  }
  const std::optional<Points<Algebraic>> row = solve(matrix, unit);  // symmetric: the first row of the inverse
  require(row.has_value(), "the local system is singular");
  std::map<int, Algebraic> outside;
  for (int i = 0; i < static_cast<int>(n); ++i)
    for (const int u : vertex_ring(*mesh.mesh, i))
      if (u >= static_cast<int>(n)) outside[u] += (*row)(i, 0);
  Algebraic sum;
  for (const auto& [u, coefficient] : outside) sum += coefficient.sign() < 0 ? -coefficient : coefficient;
  return sum;
}

LoopMesh checked_loop_mesh(std::shared_ptr<const Mesh> mesh, Points<Rational> points) {
  require(mesh->faces() <= most_faces, "the mesh has more than " + std::to_string(most_faces) + " faces");
  require(points.rows() == mesh->vertices(), "there must be one row of points per vertex");
  require(mesh->all_faces_have(3), "the faces must be triangles");
  for (const int twin : mesh->twin) require(twin >= 0, "the mesh must be closed");
  for (int v = 0; v < mesh->vertices(); ++v)
    require(mesh->valence(v) >= 3 && mesh->valence(v) <= largest_patch_valence,
            "valences must be from 3 to " + std::to_string(largest_patch_valence));
  return {std::move(mesh), std::move(points)};
}

std::vector<int> valences_of(const Mesh& mesh) {
  const std::set<int> all(mesh.valences.begin(), mesh.valences.end());
  return {all.begin(), all.end()};
}

Json triangles_to_json(const Mesh& mesh) {
  Json faces = Json::array();
  for (int f = 0; f < mesh.faces(); ++f)
    faces.push_back(Json::array({mesh.corners(f)[0], mesh.corners(f)[1], mesh.corners(f)[2]}));
  return faces;
}

Json exact_rows_to_json(const Points<Rational>& rows) {
  Json result = Json::array();
  for (Eigen::Index i = 0; i < rows.rows(); ++i) {
    std::vector<Rational> row;
    for (Eigen::Index j = 0; j < rows.cols(); ++j) row.push_back(rows(i, j));
    result.push_back(to_json(row));
  }
  return result;
}

std::shared_ptr<const Mesh> triangles_from(const Json& faces, int vertices) {
  require(faces.is_array() && !faces.empty() && faces.size() <= most_faces, "faces must be a list of 1 to 20000 faces");
  std::vector<std::vector<int>> cycles;
  for (const Json& face : faces) {
    require(face.is_array() && face.size() == 3, "a face must have three corners");
    std::vector<int> cycle;
    for (const Json& corner : face) cycle.push_back(integer_from(corner, 0, vertices - 1, "a corner"));
    cycles.push_back(std::move(cycle));
  }
  return std::make_shared<const Mesh>(make_mesh(vertices, cycles));
}

Points<Rational> exact_rows_from(const Json& rows, int columns, const std::string& where) {
  require(rows.is_array() && !rows.empty() && rows.size() <= most_faces, where + " must be a list of 1 to 20000 rows");
  Points<Rational> result(static_cast<Eigen::Index>(rows.size()), columns);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::vector<Rational> row = rationals_from(rows[i], where);
    require(row.size() == at(columns), where + " must have rows of " + std::to_string(columns) + " numbers");
    for (int j = 0; j < columns; ++j) result(static_cast<Eigen::Index>(i), j) = row[at(j)];
  }
  return result;
}

Points<Rational> exact_rows(const Points<double>& rows) {
  Points<Rational> result(rows.rows(), rows.cols());
  for (Eigen::Index k = 0; k < rows.size(); ++k) result.data()[k] = Rational::from_double(rows.data()[k]);
  return result;
}

EnclosedPatches enclosed_patches(const LoopMesh& surface, int rounds, const std::atomic<bool>* stop) {
  Surface<Interval> fine{surface.mesh, Points<Interval>(surface.points.rows(), surface.points.cols()), {}, {}};
  for (Eigen::Index k = 0; k < surface.points.size(); ++k) fine.points.data()[k] = Interval(surface.points.data()[k]);
  RunControl control;
  control.max_faces = 16LL * most_faces;
  control.stop = stop;
  fine = run(schemes::loop(), std::move(fine), rounds, control);
  EnclosedPatches result{fine.mesh, std::move(fine.points), {}, {}};
  for (int f = 0; f < result.mesh->faces(); ++f) {
    std::optional<LoopPatch> patch = loop_patch(*result.mesh, {}, f);
    require(patch.has_value(), "a face has more than one irregular vertex: more rounds are needed");
    result.net.push_back(patch_net(*patch, result.points));
    result.patch.push_back(std::move(*patch));
  }
  return result;
}

std::map<int, PatchStep<Interval>> enclosed_steps(const Mesh& mesh) {
  std::map<int, PatchStep<Interval>> steps;
  steps.emplace(6, patch_step<Interval>(6));
  for (const int n : valences_of(mesh))
    if (!steps.contains(n)) steps.emplace(n, patch_step<Interval>(n));
  return steps;
}

}  // namespace udcp
