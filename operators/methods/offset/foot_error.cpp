// Distances from F to S: nearest triangle of the samples, then a Newton step on the surface.
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "operators/interrupt.h"
#include "operators/methods/offset/box_tree.h"
#include "operators/methods/offset/loop_evaluation.h"
#include "operators/methods/offset/offset_error.h"

namespace udcp {
namespace {

/// The distance from a point to the surface near the parameters of a face.
double distance_near(const LoopEvaluation& surface, const Points<double>& points, int face, double v, double w,
                     const Eigen::Vector3d& target) {
  double least = HUGE_VAL;
  for (int step = 0; step < 3; ++step) {
    const LoopPoint at = surface.at(points, face, v, w);
    const Eigen::Vector3d rest = target - Eigen::Vector3d(at.values.row(0).transpose());
    least = std::min(least, rest.norm());
    if (!at.has_derivatives) break;
    const auto row = [&](Eigen::Index k) { return Eigen::Vector3d(at.values.row(k).transpose()); };
    Eigen::Matrix2d hessian;  // of |rest|^2/2
    hessian << row(1).dot(row(1)) - rest.dot(row(3)), row(1).dot(row(2)) - rest.dot(row(4)),
        row(1).dot(row(2)) - rest.dot(row(4)), row(2).dot(row(2)) - rest.dot(row(5));
    if (!(hessian.determinant() > 0)) break;
    const Eigen::Vector2d move = hessian.inverse() * Eigen::Vector2d(rest.dot(row(1)), rest.dot(row(2)));
    v = std::max(0.0, v + move[0]);
    w = std::max(0.0, w + move[1]);
    if (v + w > 1) v /= v + w, w = 1 - v;
  }
  return least;
}

}  // namespace

double foot_error(const OffsetSamples& samples, double distance, const RunControl& control) {
  const Mesh& mesh = *samples.surface.mesh;
  const auto corners = [&](int f) {
    const auto c = mesh.corners(f);
    const auto row = [&](int v) { return Eigen::Vector3d(samples.position.row(v).transpose()); };
    return std::array<Eigen::Vector3d, 3>{row(c[0]), row(c[1]), row(c[2])};
  };
  std::vector<SpaceBox> boxes(static_cast<std::size_t>(mesh.faces()));
  for (int f = 0; f < mesh.faces(); ++f)
    for (const Eigen::Vector3d& corner : corners(f)) boxes[static_cast<std::size_t>(f)].include(corner.array());
  const BoxTree tree(std::move(boxes));
  const LoopEvaluation evaluation(samples.surface.mesh, samples.surface.tags);
  double worst = 0;
  for (Eigen::Index s = 0; s < samples.delta.rows(); ++s) {
    throw_if_stopped(control.stop);
    const Eigen::Vector3d target = (samples.position.row(s) + samples.delta.row(s)).transpose();
    const auto foot = [&](int f) {
      const auto t = corners(f);
      const Eigen::Vector3d weights = nearest_in_triangle(target, t);
      return std::pair{weights, (weights[0] * t[0] + weights[1] * t[1] + weights[2] * t[2] - target).norm()};
    };
    const int f = tree.nearest(target, [&](int face) { return foot(face).second; });
    const Eigen::Vector3d weights = foot(f).first;
    const double v = std::max(0.0, weights[1]), w = std::min(std::max(0.0, weights[2]), 1 - v);
    const double reached = distance_near(evaluation, samples.surface.points, f, v, w, target);
    worst = std::max(worst, std::abs(reached - std::abs(distance)));
  }
  return worst;
}

}  // namespace udcp
