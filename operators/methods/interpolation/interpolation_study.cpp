// Sweeps and the shortest correction on the first refinement, where the rings of neighbours share points.
#include "operators/methods/interpolation/interpolation_study.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "operators/interrupt.h"
#include "operators/methods/interpolation/limit_masks.h"
#include "operators/methods/interpolation/mesh_system.h"
#include "operators/methods/sparse_solvers.h"

namespace udcp {
namespace {

std::size_t at(int k) { return Mesh::i(k); }

bool is_skipped(const std::vector<char>& skipped, int v) { return !skipped.empty() && skipped[at(v)] != 0; }

void check_closed(const Surface<double>& cage) {
  for (int v = 0; v < cage.mesh->vertices(); ++v)
    if (cage.mesh->on_boundary(v) || cage.tags.is_corner(v))
      throw Error(ErrorKind::input, "E_NOT_CLOSED",
                  "vertex " + std::to_string(v) + (cage.mesh->on_boundary(v) ? " lies on the boundary" : " is a corner") +
                      "; this method is for closed meshes without corners",
                  "method = two_level interpolates other meshes too");
}

void check_input(const Surface<double>& cage, const Points<double>& normals, const std::vector<char>& skipped) {
  check_cage(cage);
  if (cage.points.cols() != 3) throw Error(ErrorKind::input, "E_DIMENSION", "normals need points of three coordinates", "");
  check_closed(cage);
  check_normals(normals, cage.mesh->vertices(), skipped);
}

// Step 2 for every vertex on one mesh; corrections are added at once (gauss) or at the end.
Points<double> normal_sweep(const Surface<double>& fine, const Points<double>& normals, const SweepOptions& options) {
  Points<double> points = fine.points, sum = Points<double>::Zero(points.rows(), 3);
  Eigen::VectorXd times = Eigen::VectorXd::Zero(points.rows());
  RingMasks masks;
  Fan fan;
  for (int v = 0; v < static_cast<int>(normals.rows()); ++v) {
    if (is_skipped(options.skipped_normals, v)) continue;
    collect_fan(*fine.mesh, v, fan);
    const RingWeights& weights = *masks.weights(fan);
    const RingTangents change = change_to_plane(tangents_at(points, v, fan, weights), normals.row(v));
    const Points<double> rows = ring_corrections(fan, weights, change, options.spread);
    Points<double>& target = options.order == SweepOrder::gauss ? points : sum;
    for (Eigen::Index k = 0; k < rows.rows(); ++k) {
      const int i = fan_point(fan, static_cast<std::size_t>(k));
      target.row(i) += rows.row(k);
      times[i] += 1;
    }
  }
  if (options.order == SweepOrder::average) sum = (times.cwiseMax(1).cwiseInverse().asDiagonal() * sum).eval();
  return points + sum;
}

}  // namespace

Sweeps sweep(const Surface<double>& cage, const Points<double>& normals, const SweepOptions& options) {
  check_input(cage, normals, options.skipped_normals);
  Sweeps result{modified_step(cage, options.points.lambda, options.points.control), {}, 0};
  double last_change = 0;
  for (int k = 0; k < options.sweeps; ++k) {
    throw_if_stopped(options.points.control.stop);
    const Points<double> before = result.control.points;
    result.control = put_limits(std::move(result.control), cage.points, options.points.skipped);
    result.control.points = normal_sweep(result.control, normals, options);
    if (!(result.control.points.cwiseAbs().maxCoeff() < 1e100)) break;
    result.errors.push_back(
        interpolation_errors(result.control, cage.points, normals, options.points.skipped, options.skipped_normals));
    const double change = (result.control.points - before).norm();
    const bool is_rounding = change <= 1e-14 * result.control.points.norm();
    if (last_change > 0 && !is_rounding) result.growth = change / last_change;
    last_change = change;
    if (options.points.control.progress) options.points.control.progress(static_cast<double>(k + 1) / options.sweeps);
  }
  return result;
}

namespace {

constexpr int largest_least_norm = 5000;

// The conditions on the corrections of all points, coordinate by coordinate.
class Conditions {
 public:
  Conditions(const Surface<double>& fine, const Points<double>& targets, const Points<double>& normals)
      : fine_(fine), targets_(targets), limits_(limit_points(fine, static_cast<int>(targets.rows()))), normals_(normals) {}

  void add_position(int v) {
    collect_fan(*fine_.mesh, v, fan_);
    const PointMask& mask = masks_.inside(fan_.faces());
    for (int c = 0; c < 3; ++c) {
      const auto put = [&](int i, const Rational& weight) { entries_.push_back({rows_, 3 * i + c, weight.to_double()}); };
      put(v, mask.vertex);
      for (const int e : fan_.e) put(e, mask.edge);
      for (const int f : fan_.f) put(f, mask.face);
      right_.push_back(targets_(v, c) - limits_(v, c));
      ++rows_;
    }
  }

  void add_normal(int v) {
    collect_fan(*fine_.mesh, v, fan_);
    const RingWeights& weights = *ring_masks_.weights(fan_);
    const RingTangents tangents = tangents_at(fine_.points, v, fan_, weights);
    const Eigen::RowVector3d n = normals_.row(v) / normals_.row(v).stableNorm();
    for (const bool first : {true, false}) {
      const std::vector<double>& weight = first ? weights.first : weights.second;
      for (std::size_t k = 0; k < weight.size(); ++k)
        for (int c = 0; c < 3; ++c) entries_.push_back({rows_, 3 * fan_point(fan_, k) + c, weight[k] * n[c]});
      right_.push_back(-(first ? tangents.first : tangents.second).dot(n));
      ++rows_;
    }
  }

  [[nodiscard]] LeastNorm solve() const {
    const Eigen::VectorXd right = Eigen::VectorXd::Map(right_.data(), static_cast<Eigen::Index>(right_.size()));
    return least_norm_solution(rows_, 3 * static_cast<int>(fine_.points.rows()), entries_, right);
  }
  [[nodiscard]] int rows() const { return rows_; }

 private:
  const Surface<double>& fine_;
  const Points<double>& targets_;
  Points<double> limits_;
  const Points<double>& normals_;
  LimitMasks masks_;
  RingMasks ring_masks_;
  Fan fan_;
  std::vector<Entry> entries_;
  std::vector<double> right_;
  int rows_ = 0;
};

}  // namespace

LeastCorrection least_correction(const Surface<double>& cage, const Points<double>& normals, const PointOptions& options,
                                 const std::vector<char>& skipped_normals) {
  check_input(cage, normals, skipped_normals);
  if (options.step == PointStep::plain)
    throw Error(ErrorKind::input, "E_ARGUMENTS", "the shortest correction works on the first refinement, and plain needs two",
                "step1 = global or local");
  if (cage.mesh->vertices() > largest_least_norm)
    throw Error(ErrorKind::limit, "E_TOO_LARGE",
                "all conditions at once would take too long for " + std::to_string(cage.mesh->vertices()) +
                    " vertices; the limit is " + std::to_string(largest_least_norm),
                "method = two_level has no such limit");
  LeastCorrection result{interpolate_points(cage, options)};
  Conditions conditions(result.control, cage.points, normals);
  for (int v = 0; v < cage.mesh->vertices(); ++v) {
    throw_if_stopped(options.control.stop);
    if (!is_skipped(options.skipped, v)) conditions.add_position(v);
    if (!is_skipped(skipped_normals, v)) conditions.add_normal(v);
  }
  result.rows = conditions.rows();
  if (result.rows == 0) return result;
  const LeastNorm solution = conditions.solve();
  throw_if_stopped(options.control.stop);
  result.rank = solution.rank;
  for (Eigen::Index i = 0; i < result.control.points.rows(); ++i) {
    const Eigen::RowVector3d row = solution.x.segment<3>(3 * i).transpose();
    result.control.points.row(i) += row;
    result.displacement = std::max(result.displacement, row.norm());
    result.squared_displacement += row.squaredNorm();
  }
  return result;
}

}  // namespace udcp
