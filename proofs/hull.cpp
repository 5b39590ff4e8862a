// The least sum |c| with x = sum c_j v_j by the simplex method, on bases of points: any basis will do to start with, as points
// may be used with either sign.
#include "proofs/hull.h"

#include <Eigen/LU>
#include <cmath>

namespace udcp {
namespace {

using Eigen::Index;

/// Independent points, each farthest from the span of those before.
std::vector<int> independent(const std::vector<Hull::Vector>& points) {
  const Index n = points.front().size();
  Eigen::MatrixXd rest(n, static_cast<Index>(points.size()));
  for (Index k = 0; k < rest.cols(); ++k) rest.col(k) = points[static_cast<std::size_t>(k)];
  std::vector<int> chosen;
  while (static_cast<Index>(chosen.size()) < n) {
    Index best = 0;
    const double length = rest.colwise().norm().maxCoeff(&best);
    if (!(length > 1e-9)) return {};
    chosen.push_back(static_cast<int>(best));
    const Eigen::VectorXd direction = rest.col(best) / length;
    const Eigen::RowVectorXd along = direction.transpose() * rest;
    rest -= direction * along;
  }
  return chosen;
}

/// The inverse of a basis after column `row` of it was exchanged for one with coordinates `entering`.
void exchange(Eigen::MatrixXd& inverse, const Hull::Vector& entering, Index row) {
  inverse.row(row) /= entering[row];
  for (Index i = 0; i < inverse.rows(); ++i)
    if (i != row) inverse.row(i) -= entering[i] * inverse.row(row);
}

}  // namespace

std::optional<Hull> Hull::of(std::vector<Vector> points) {
  if (points.empty()) return std::nullopt;
  Hull hull;
  hull.points_ = std::move(points);
  hull.start_ = independent(hull.points_);
  if (hull.start_.empty()) return std::nullopt;
  const auto n = static_cast<Index>(hull.start_.size());
  Eigen::MatrixXd basis(n, n);
  for (Index k = 0; k < n; ++k) basis.col(k) = hull.points_[static_cast<std::size_t>(hull.start_[static_cast<std::size_t>(k)])];
  hull.inverse_ = basis.inverse();
  return hull;
}

Hull::Inside Hull::measure(const Vector& x) const {
  const Index n = x.size();
  std::vector<int> basis = start_;
  Eigen::MatrixXd inverse = inverse_;
  Vector c = inverse * x;
  for (Index step = 0; step < 40 * n + 100; ++step) {
    const Vector signs = c.unaryExpr([](double value) { return value < 0 ? -1.0 : 1.0; });
    const Eigen::RowVectorXd prices = signs.transpose() * inverse;
    std::size_t entering = 0;
    double best = 0;
    for (std::size_t j = 0; j < points_.size(); ++j) {
      const double price = prices * points_[j];
      if (std::abs(price) <= std::abs(best)) continue;
      best = price;
      entering = j;
    }
    if (std::abs(best) <= 1 + 1e-10) break;
    Vector along = inverse * points_[entering];
    if (best < 0) along = -along;
    Index leaving = -1;
    double longest = 0;
    for (Index i = 0; i < n; ++i) {
      const double speed = signs[i] * along[i];
      if (speed < 1e-11) continue;
      const double way = std::abs(c[i]) / speed;
      if (leaving >= 0 && way >= longest) continue;
      longest = way;
      leaving = i;
    }
    if (leaving < 0) break;  // by rounding only: the sum of moduli cannot fall for ever
    if (best < 0) along = -along;
    exchange(inverse, along, leaving);
    basis[static_cast<std::size_t>(leaving)] = static_cast<int>(entering);
    c = inverse * x;
  }
  return {c.cwiseAbs().sum(), std::move(basis), std::move(c)};
}

}  // namespace udcp
