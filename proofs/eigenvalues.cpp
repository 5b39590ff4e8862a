// Eigen's solvers on the midpoints of enclosed blocks.
#include "proofs/eigenvalues.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <tuple>

namespace udcp {
namespace {

Eigen::MatrixXd middle(const Points<Interval>& a) {
  Eigen::MatrixXd result(a.rows(), a.cols());
  for (Eigen::Index i = 0; i < a.rows(); ++i)
    for (Eigen::Index j = 0; j < a.cols(); ++j) result(i, j) = a(i, j).midpoint();
  return result;
}

Rational rounded(const Rational& x) {
  const Rational step = pow(Rational(2), -eigenpair_bits);
  return (x / step + Rational(1) / Rational(2)).floor() * step;
}

ApproximatePair rounded(const Rational& value, const std::vector<Rational>& vector) {
  ApproximatePair result{rounded(value), {}};
  for (const Rational& x : vector) result.vector.push_back(rounded(x));
  return result;
}

Rational middle_of(const Interval& x) { return (x.lower() + x.upper()) / Rational(2); }

}  // namespace

std::vector<std::complex<double>> eigenvalues(const Points<Interval>& a) {
  if (a.rows() == 0) return {};
  const Eigen::VectorXcd found = middle(a).eigenvalues();
  std::vector<std::complex<double>> result(found.data(), found.data() + found.size());
  std::sort(result.begin(), result.end(), [](const auto& x, const auto& y) {
    return std::tuple(std::abs(x), x.real(), x.imag()) > std::tuple(std::abs(y), y.real(), y.imag());
  });
  return result;
}

std::vector<std::vector<std::complex<double>>> eigenvalues_by_frequency(const Patch<Interval>& patch, int radius) {
  std::vector<std::vector<std::complex<double>>> result;
  for (int m = 0; m <= patch.sectors.valence / 2; ++m) {
    result.push_back(eigenvalues(block(patch, radius, m)));
    if (m == 0) result.back().emplace(result.back().begin(), 1.0);
  }
  return result;
}

std::optional<ApproximatePair> approximate_eigenpair(const Points<Interval>& a) {
  if (a.rows() == 0) return std::nullopt;
  const Eigen::EigenSolver<Eigen::MatrixXd> solver(middle(a));
  Eigen::Index best = 0;
  for (Eigen::Index k = 1; k < a.rows(); ++k)
    if (std::abs(solver.eigenvalues()[k]) > std::abs(solver.eigenvalues()[best])) best = k;
  const std::complex<double> value = solver.eigenvalues()[best];
  const Eigen::VectorXcd found = solver.eigenvectors().col(best);
  if (value.imag() != 0 || std::abs(found[0]) < 1e-6 * found.cwiseAbs().maxCoeff()) return std::nullopt;
  const Eigen::VectorXd vector = (found / found[0]).real();
  if (!vector.allFinite()) return std::nullopt;
  std::vector<Rational> exact;
  for (Eigen::Index k = 0; k < vector.size(); ++k) exact.push_back(Rational::from_double(vector[k]));
  const std::optional<Eigenpair> enclosed = enclose_eigenpair(a, rounded(Rational::from_double(value.real()), exact));
  if (!enclosed) return std::nullopt;
  for (std::size_t k = 0; k < exact.size(); ++k) exact[k] = middle_of(enclosed->vector[k]);
  return rounded(middle_of(enclosed->value), exact);
}

}  // namespace udcp
