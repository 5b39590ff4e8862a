// Limit triangles against one another, normals against triangles, tangents of F against those of S.
#include "operators/methods/offset/self_intersection.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

#include "operators/interrupt.h"
#include "operators/methods/offset/box_tree.h"
#include "operators/methods/offset/loop_evaluation.h"
#include "operators/methods/offset/loop_limit.h"
#include "operators/schemes.h"

namespace udcp {
namespace {

std::size_t at(int k) { return static_cast<std::size_t>(k); }

using Vector = Eigen::Vector3d;

Vector row_of(const Points<double>& points, int v) { return points.row(v).transpose(); }

std::array<Vector, 3> triangle(const Surface<double>& surface, int f) {
  const auto c = surface.mesh->corners(f);
  return {row_of(surface.points, c[0]), row_of(surface.points, c[1]), row_of(surface.points, c[2])};
}

/// The patch of a face lies in the box of its Bezier points, or of the control points around it.
SpaceBox patch_box(const Surface<double>& control, const VertexRings& rings, int f) {
  SpaceBox box;
  const std::optional<LoopPatch> patch = loop_patch(*control.mesh, control.tags, f);
  if (patch && patch->valence == 6) {
    const Points<double> bezier = bezier_points(patch_net(*patch, control.points));
    for (Eigen::Index k = 0; k < bezier.rows(); ++k) box.include(bezier.row(k).transpose().array());
    return box;
  }
  for (const int v : control.mesh->corners(f)) {
    box.include(row_of(control.points, v).array());
    for (const int u : rings.of(v)) box.include(row_of(control.points, u).array());
  }
  return box;
}

bool have_common_vertex(const Mesh& mesh, int f, int g) {
  for (const int v : mesh.corners(f))
    for (const int u : mesh.corners(g))
      if (u == v) return true;
  return false;
}

void find_hits(const Surface<double>& control, const VertexRings& rings, int most, const std::atomic<bool>* stop,
               SelfIntersection& result) {
  std::vector<SpaceBox> boxes;
  for (int f = 0; f < control.mesh->faces(); ++f) boxes.push_back(patch_box(control, rings, f));
  const BoxTree tree(std::move(boxes));
  tree.pairs([&](int f, int g) {
    throw_if_stopped(stop);
    if (have_common_vertex(*control.mesh, f, g)) return true;
    if (!triangles_meet(triangle(result.surface, f), triangle(result.surface, g))) return true;
    if (static_cast<int>(result.hits.size()) >= most)
      throw Error(ErrorKind::limit, "E_MAX_HITS", "more than " + std::to_string(most) + " pairs of faces meet",
                  "test fewer rounds, or a smaller distance");
    result.hits.emplace_back(f, g);
    return true;
  });
  std::ranges::sort(result.hits);
}

void find_folds(const Points<double>& tangents, SelfIntersection& result) {
  const Mesh& mesh = *result.surface.mesh;
  std::vector<char> folded(at(mesh.vertices()), 0);
  for (int f = 0; f < mesh.faces(); ++f) {
    const std::array<Vector, 3> t = triangle(result.surface, f);
    const Vector normal = (t[1] - t[0]).cross(t[2] - t[0]);
    for (const int v : mesh.corners(f)) {
      const Vector first = tangents.row(v).head(3).transpose(), second = tangents.row(v).tail(3).transpose();
      if (!(normal.dot(first.cross(second)) > 0)) folded[at(v)] = 1;
    }
  }
  for (int v = 0; v < mesh.vertices(); ++v)
    if (folded[at(v)] != 0) result.folds.push_back(v);
}

void find_inverted(const Points<double>& of_s, const Points<double>& of_f, SelfIntersection& result) {
  for (int v = 0; v < result.surface.mesh->vertices(); ++v) {
    Eigen::Matrix<double, 3, 2> s, f;
    s << of_s.row(v).head(3).transpose(), of_s.row(v).tail(3).transpose();
    f << of_f.row(v).head(3).transpose(), of_f.row(v).tail(3).transpose();
    const Eigen::Matrix2d a = (s.transpose() * s).inverse() * (s.transpose() * f);
    if (!(a.determinant() > 0) || !(a.trace() > 0)) result.inverted.push_back(v);
  }
}

}  // namespace

std::string_view name_of(OffsetVerdict verdict) {
  static constexpr std::array<std::string_view, 4> names{"clean", "inverted", "folded", "self-intersecting"};
  return names[static_cast<std::size_t>(verdict)];
}

SelfIntersection find_self_intersections(const Surface<double>& surface, const Points<double>& d, int rounds,
                                         const RunControl& control, int most_hits) {
  Surface<double> both{surface.mesh, Points<double>(d.rows(), 6), surface.tags, {}};
  both.points << surface.points, surface.points + d;
  both = run(schemes::loop(), std::move(both), rounds, control);
  const LoopLimit<double> limit(both.mesh, both.tags);
  const Points<double> s = both.points.leftCols(3), f = both.points.rightCols(3);
  validate_boundary_normals(*both.mesh, both.tags);
  const Points<double> of_s = limit.tangents(s), of_f = limit.tangents(f);
  normals_of(of_s);  // throws where S has no normal
  SelfIntersection result;
  result.rounds = rounds;
  result.surface = {both.mesh, limit.points(f), both.tags, {}};
  find_hits({both.mesh, f, both.tags, {}}, limit.rings(), most_hits, control.stop, result);
  find_folds(of_f, result);
  find_inverted(of_s, of_f, result);
  result.verdict = !result.hits.empty()       ? OffsetVerdict::self_intersecting
                   : !result.folds.empty()    ? OffsetVerdict::folded
                   : !result.inverted.empty() ? OffsetVerdict::inverted
                                              : OffsetVerdict::clean;
  return result;
}

std::vector<std::pair<int, int>> coarse_hits(const SelfIntersection& found) {
  std::vector<std::pair<int, int>> result;
  for (const auto& [f, g] : found.hits) result.emplace_back(std::minmax(f >> (2 * found.rounds), g >> (2 * found.rounds)));
  std::ranges::sort(result);
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

std::vector<double> marks(const SelfIntersection& found) {
  std::vector<double> result(at(found.surface.mesh->vertices()), 0.0);
  for (const int v : found.folds) result[at(v)] = 0.5;
  for (const int v : found.inverted) result[at(v)] = 0.5;
  for (const auto& [f, g] : found.hits) {
    for (const int v : found.surface.mesh->corners(f)) result[at(v)] = 1;
    for (const int v : found.surface.mesh->corners(g)) result[at(v)] = 1;
  }
  return result;
}

/// None where the surface has no normal.
static std::optional<Curvature> curvature_if_any(const Points<double>& values) {
  try {
    return curvature(values);
  } catch (const Error&) {
    return std::nullopt;
  }
}

CurvatureRange curvature_range(const Surface<double>& surface, const RunControl& control) {
  constexpr int steps = 8;
  const Mesh& mesh = *surface.mesh;
  const LoopEvaluation evaluation(surface.mesh, surface.tags);
  const auto is_wild = [&](int v) {
    const int n = mesh.valence(v);
    return mesh.on_boundary(v) ? n != 4 : n == 3 || n >= 7;
  };
  CurvatureRange range{HUGE_VAL, -HUGE_VAL, 0, 0, {}, {}, 0};
  for (int v = 0; v < mesh.vertices(); ++v) range.excluded += is_wild(v);
  for (int f = 0; f < mesh.faces(); ++f) {
    const auto corners = mesh.corners(f);
    for (int i = 0; i <= steps; ++i) {
      for (int j = 0; i + j <= steps; ++j) {
        throw_if_stopped(control.stop);  // each sample beside a large valence takes long
        const std::array<int, 3> weight{steps - i - j, i, j};
        bool left_out = false;
        for (std::size_t k = 0; k < 3; ++k) left_out |= weight[k] > steps - steps / 8 && is_wild(corners[k]);
        if (left_out) continue;
        const LoopPoint point = evaluation.at(surface.points, f, static_cast<double>(i) / steps, static_cast<double>(j) / steps);
        if (!point.has_derivatives) continue;
        const std::optional<Curvature> found = curvature_if_any(point.values);
        if (!found) continue;
        const Curvature& k = *found;
        if (k.least < range.least) range.least = k.least, range.least_face = f, range.least_place = k.position;
        if (k.greatest > range.greatest) range.greatest = k.greatest, range.greatest_face = f, range.greatest_place = k.position;
      }
    }
  }
  if (range.least > range.greatest) range.least = range.greatest = 0;
  return range;
}

}  // namespace udcp
