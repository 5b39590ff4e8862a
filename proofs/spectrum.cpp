// Newton-Kantorovich inclusion of an eigenpair; spectral radii from powers of a matrix.
#include "proofs/spectrum.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

namespace udcp {
namespace {

using Index = Eigen::Index;

Interval row_sum_norm(const Points<Interval>& a) {
  Interval result(0);
  for (Index i = 0; i < a.rows(); ++i) {
    Interval sum(0);
    for (Index j = 0; j < a.cols(); ++j) sum += abs(a(i, j));
    result = max(result, sum);
  }
  return result;
}

/// Jacobian of F at the approximation: [a - lambda, -v; e_0^T, 0].
Points<Interval> jacobian(const Points<Interval>& a, const Interval& value, const Points<Interval>& vector) {
  const Index n = a.rows();
  Points<Interval> result = Points<Interval>::Zero(n + 1, n + 1);
  result.topLeftCorner(n, n) = a;
  for (Index i = 0; i < n; ++i) {
    result(i, i) -= value;
    result(i, n) = -vector(i, 0);
  }
  result(n, 0) = Interval(1);
  return result;
}

/// A floating-point inverse; whatever it is worth, the proof decides.
Points<Interval> rough_inverse(const Points<Interval>& a) {
  Eigen::MatrixXd middle(a.rows(), a.cols());
  for (Index i = 0; i < a.rows(); ++i)
    for (Index j = 0; j < a.cols(); ++j) middle(i, j) = a(i, j).midpoint();
  const Eigen::MatrixXd inverse = middle.partialPivLu().inverse();
  Points<Interval> result = Points<Interval>::Zero(a.rows(), a.cols());
  if (!inverse.allFinite()) return result;
  for (Index i = 0; i < a.rows(); ++i)
    for (Index j = 0; j < a.cols(); ++j) result(i, j) = Interval::from_double(inverse(i, j));
  return result;
}

Interval around_zero(const Interval& radius) { return Interval::hull(-radius, radius); }

}  // namespace

double upper_bound(const Interval& x) { return std::nextafter(x.upper().to_double(), std::numeric_limits<double>::infinity()); }
double lower_bound(const Interval& x) { return std::nextafter(x.lower().to_double(), -std::numeric_limits<double>::infinity()); }

std::optional<Eigenpair> enclose_eigenpair(const Points<Interval>& a, const ApproximatePair& near) {
  const Index n = a.rows();
  if (n == 0 || static_cast<Index>(near.vector.size()) != n) return std::nullopt;
  const Interval value(near.value);
  Points<Interval> vector(n, 1), residual = Points<Interval>::Zero(n + 1, 1);
  for (Index i = 0; i < n; ++i) vector(i, 0) = Interval(near.vector[static_cast<std::size_t>(i)]);
  residual.topRows(n) = a * vector - value * vector;
  residual(n, 0) = vector(0, 0) - Interval(1);
  const Points<Interval> slope = jacobian(a, value, vector), inverse = rough_inverse(slope);
  const Points<Interval> step = inverse * residual;
  const Points<Interval> defect = Points<Interval>::Identity(n + 1, n + 1) - inverse * slope;
  const Interval alpha = row_sum_norm(step), beta = row_sum_norm(defect), norm = row_sum_norm(inverse);
  if (!(beta < Interval(1))) return std::nullopt;
  const Interval rho(Interval(2) * Interval(alpha.upper()) / (Interval(1) - Interval(beta.upper())));
  const Interval change = beta * rho + norm * rho * rho;  // gamma/2 is the norm of the inverse
  if (!(alpha + change <= Interval(rho.lower())) || !(beta + Interval(2) * norm * rho < Interval(1))) return std::nullopt;
  Eigenpair result{value - step(n, 0) + around_zero(change), {}};
  for (Index i = 0; i < n; ++i) result.vector.push_back(vector(i, 0) - step(i, 0) + around_zero(change));
  return result;
}

bool is_nearest(const ApproximatePair& approximation, const Eigenpair& exact) {
  const Rational step = pow(Rational(2), -eigenpair_bits), half = step * Rational(501) / Rational(1000);
  const auto near = [&](const Rational& number, const Interval& x) {
    return (number / step).is_integer() && abs(x - Interval(number)) <= Interval(half);
  };
  if (approximation.vector.size() != exact.vector.size() || !near(approximation.value, exact.value)) return false;
  for (std::size_t k = 0; k < exact.vector.size(); ++k)
    if (!near(approximation.vector[k], exact.vector[k])) return false;
  return true;
}

Points<Interval> deflated(const Points<Interval>& a, const Eigenpair& pair) {
  Points<Interval> result = a;
  for (Index i = 0; i < a.rows(); ++i) result(i, 0) -= pair.value * pair.vector[static_cast<std::size_t>(i)];
  return result;
}

namespace {

constexpr int most_squares = 14;

/// a^(2^p) = 2^exponent x for p = 0, 1, ..: hands x and the root of a norm of it to `visit`, until that says true or x is 0.
/// Enclosures in many digits, because with every squaring the relative error grows by twice the condition of the dominant part.
template <class Visit>
void for_powers(const Points<Interval>& a, Visit visit) {
  Points<Interval> x = a;
  double exponent = 0;
  for (int p = 0; p <= most_squares; ++p) {
    // (2^exponent value)^(1/2^p). The power and the logarithm of the library are off by a few units in the last place at most,
    // which the callers cover.
    if (visit(x, [&](double value) { return value > 0 ? std::exp2((std::log2(value) + exponent) / std::ldexp(1.0, p)) : 0; }))
      return;
    const double size = upper_bound(row_sum_norm(x));
    if (!std::isfinite(size) || size < 1e-250) return;
    int scale = 0;
    (void)std::frexp(size, &scale);
    exponent = 2 * (exponent + scale);
    const Points<Interval> scaled = Interval(pow(Rational(2), -scale)) * x;
    x = scaled * scaled;
  }
}

}  // namespace

double spectral_radius_bound(const Points<Interval>& a, double target) {
  if (a.rows() == 0) return 0;
  double best = std::numeric_limits<double>::infinity();
  for_powers(a, [&](const Points<Interval>& x, auto root) {
    best = std::min(best, root(upper_bound(row_sum_norm(x))) * (1 + 1e-11));
    return best < target;
  });
  return best;
}

double spectral_radius_lower_bound(const Points<Interval>& a) {
  double best = 0;
  if (a.rows() == 0) return best;
  const Interval length(static_cast<int>(a.rows()));
  for_powers(a, [&](const Points<Interval>& x, auto root) {
    Interval trace(0);  // the sum of the eigenvalues, each at most the spectral radius in modulus
    for (Index i = 0; i < x.rows(); ++i) trace += x(i, i);
    best = std::max(best, root(lower_bound(abs(trace) / length)));
    return false;
  });
  return best / (1 + 1e-11);
}

}  // namespace udcp
