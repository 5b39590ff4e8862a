// The convex hull of points and their negatives in double precision: a search tool that decides nothing.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "operators/number.h"

namespace udcp {

class Hull {
 public:
  using Vector = Eigen::VectorXd;
  /// Nothing unless the points span the space (in a basis that is not too skew to compute with).
  static std::optional<Hull> of(std::vector<Vector> points);

  void append(const Vector& point) { points_.push_back(point); }
  [[nodiscard]] const std::vector<Vector>& points() const { return points_; }

  /// x as a combination of a basis of points with sum of moduli `gauge`: at most 1 inside. The least one, up to rounding.
  struct Inside {
    double gauge = 0;
    std::vector<int> basis;
    Vector weights;
  };
  [[nodiscard]] Inside measure(const Vector& x) const;

 private:
  std::vector<Vector> points_;
  std::vector<int> start_;   // a basis of points
  Eigen::MatrixXd inverse_;  // of the matrix with those columns
};

/// Matrices in double precision.
template <class S>
std::vector<Eigen::MatrixXd> rounded(const std::vector<Points<S>>& matrices) {
  std::vector<Eigen::MatrixXd> result;
  for (const Points<S>& matrix : matrices) {
    Eigen::MatrixXd real(matrix.rows(), matrix.cols());
    for (Eigen::Index i = 0; i < matrix.rows(); ++i)
      for (Eigen::Index j = 0; j < matrix.cols(); ++j) real(i, j) = approximate(matrix(i, j));
    result.push_back(std::move(real));
  }
  return result;
}
/// The product of the matrices with these indices, in this order.
inline Eigen::MatrixXd product(const std::vector<Eigen::MatrixXd>& matrices, const std::vector<int>& letters) {
  Eigen::MatrixXd result = Eigen::MatrixXd::Identity(matrices.front().rows(), matrices.front().rows());
  for (const int e : letters) result = (result * matrices[static_cast<std::size_t>(e)]).eval();
  return result;
}

}  // namespace udcp
