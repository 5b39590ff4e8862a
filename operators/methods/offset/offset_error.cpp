// Samples and per-face bounds.
#include "operators/methods/offset/offset_error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "operators/methods/offset/loop_limit.h"
#include "operators/methods/offset/loop_patch.h"
#include "operators/methods/offset/patch_bounds.h"
#include "operators/schemes.h"

namespace udcp {
namespace {

std::size_t at(int k) { return static_cast<std::size_t>(k); }

/// S and delta side by side, six columns.
Surface<double> paired(const Surface<double>& surface, const Points<double>& d) {
  if (surface.points.cols() != 3 || d.cols() != 3 || d.rows() != surface.points.rows())
    throw Error(ErrorKind::input, "E_POINTS", "there must be one control vector of three coordinates per vertex", "");
  Surface<double> both{surface.mesh, Points<double>(d.rows(), 6), surface.tags, {}};
  both.points << surface.points, d;
  return both;
}

/// The vertices of the union of the one-rings of a face's corners, each once.
std::vector<int> around_face(const VertexRings& rings, std::span<const int> corners) {
  std::vector<int> vertices(corners.begin(), corners.end());
  for (const int v : corners) vertices.insert(vertices.end(), rings.of(v).begin(), rings.of(v).end());
  std::ranges::sort(vertices);
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

LengthRange<double> range_in_box(const Points<double>& vectors) {
  const Eigen::RowVectorXd low = vectors.colwise().minCoeff(), high = vectors.colwise().maxCoeff();
  const Eigen::RowVectorXd nearest = low.cwiseMax(0.0) + high.cwiseMin(0.0);
  return {nearest.norm(), low.cwiseAbs().cwiseMax(high.cwiseAbs()).norm()};
}

bool needs_separation(const Mesh& mesh) {
  for (int f = 0; f < mesh.faces(); ++f) {
    int irregular = 0;
    for (const int v : mesh.corners(f)) irregular += mesh.valence(v) != (mesh.on_boundary(v) ? 4 : 6);
    if (irregular > 1) return true;
  }
  return false;
}

}  // namespace

Surface<double> separated(const Surface<double>& surface, const RunControl& control) {
  return needs_separation(*surface.mesh) ? run(schemes::loop(), surface, 1, control) : surface;
}

OffsetSamples sample_offset(const Surface<double>& surface, const Points<double>& d, int rounds, const RunControl& control) {
  Surface<double> fine = run(schemes::loop(), paired(surface, d), rounds, control);
  OffsetSamples samples;
  samples.surface = {fine.mesh, fine.points.leftCols(3), fine.tags, {}};
  samples.control = fine.points.rightCols(3);
  const LoopLimit<double> limit(fine.mesh, fine.tags);
  samples.position = limit.points(samples.surface.points);
  samples.delta = limit.points(samples.control);
  samples.normal = limit_normals(limit, samples.surface.points);
  return samples;
}

std::string_view name_of(OffsetMeasure measure) {
  static constexpr std::array<std::string_view, 4> names{"eps", "full", "normal", "slip"};
  return names[static_cast<std::size_t>(measure)];
}

std::string_view name_of(OffsetBound kind) {
  static constexpr std::array<std::string_view, 3> names{"aabb", "hull", "bernstein"};
  return names[static_cast<std::size_t>(kind)];
}

std::vector<double> measure_offset(const OffsetSamples& samples, double distance, OffsetMeasure measure) {
  std::vector<double> result;
  result.reserve(static_cast<std::size_t>(samples.delta.rows()));
  for (Eigen::Index v = 0; v < samples.delta.rows(); ++v) {
    const Eigen::RowVector3d delta = samples.delta.row(v), n = samples.normal.row(v), e = delta - distance * n;
    const double along = e.dot(n);
    result.push_back(measure == OffsetMeasure::eps      ? delta.norm() - std::abs(distance)
                     : measure == OffsetMeasure::full   ? e.norm()
                     : measure == OffsetMeasure::normal ? along
                                                        : (e - along * n).norm());
  }
  return result;
}

OffsetErrors offset_errors(const OffsetSamples& samples, double distance) {
  OffsetErrors errors;
  const auto largest = [](const std::vector<double>& values) {
    double most = 0;
    for (const double x : values) most = std::max(most, std::abs(x));
    return most;
  };
  const std::vector<double> eps = measure_offset(samples, distance, OffsetMeasure::eps);
  const std::vector<double> full = measure_offset(samples, distance, OffsetMeasure::full);
  errors.eps = largest(eps);
  errors.full = largest(full);
  errors.normal = largest(measure_offset(samples, distance, OffsetMeasure::normal));
  errors.slip = largest(measure_offset(samples, distance, OffsetMeasure::slip));
  for (const double x : full) errors.rms += x * x;
  errors.rms = std::sqrt(errors.rms / static_cast<double>(full.size()));
  const auto [least, greatest] = std::ranges::minmax_element(eps);
  errors.least_eps = *least;
  errors.greatest_eps = *greatest;
  errors.worst = static_cast<int>((errors.greatest_eps >= -errors.least_eps ? greatest : least) - eps.begin());
  return errors;
}

std::vector<double> errors_by_face(const OffsetSamples& samples, double distance, int rounds) {
  const std::vector<double> eps = measure_offset(samples, distance, OffsetMeasure::eps);
  const Mesh& mesh = *samples.surface.mesh;
  std::vector<double> result(at(mesh.faces() >> (2 * rounds)), 0.0);
  for (int h = 0; h < mesh.half_edges(); ++h) {
    double& worst = result[at(mesh.face[at(h)] >> (2 * rounds))];
    worst = std::max(worst, std::abs(eps[at(mesh.vertex[at(h)])]));
  }
  return result;
}

BoundedError bound_offset_error(const Surface<double>& surface, const Points<double>& d, double distance, OffsetBound kind,
                                int rounds, const RunControl& control) {
  Surface<double> both = paired(surface, d);
  int steps = rounds;
  if (kind == OffsetBound::bernstein && needs_separation(*both.mesh)) ++steps;
  both = run(schemes::loop(), std::move(both), steps, control);
  const VertexRings rings(*both.mesh);
  const Points<double> vectors = both.points.rightCols(3);
  BoundedError result{-1, 0};
  for (int f = 0; f < both.mesh->faces(); ++f) {
    LengthRange<double> range;
    const std::optional<LoopPatch> patch = kind == OffsetBound::bernstein ? loop_patch(*both.mesh, both.tags, f) : std::nullopt;
    if (patch && patch->valence == 6) {
      range = length_by_bernstein(patch_net(*patch, vectors));
    } else {
      const std::vector<int> near = around_face(rings, both.mesh->corners(f));
      Points<double> local(static_cast<Eigen::Index>(near.size()), 3);
      for (std::size_t k = 0; k < near.size(); ++k) local.row(static_cast<Eigen::Index>(k)) = vectors.row(near[k]);
      range = kind == OffsetBound::aabb ? range_in_box(local) : length_by_hull(local);
    }
    const double bound = length_error(range, distance);
    if (bound > result.bound) result = {bound, f >> (2 * steps)};
  }
  return result;
}

}  // namespace udcp
