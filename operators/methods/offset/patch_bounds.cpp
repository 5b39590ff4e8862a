// Everything is a bound of Bernstein coefficients; where a condition is not certain there is no bound.
#include "operators/methods/offset/patch_bounds.h"

#include <cmath>
#include <string>

#include "operators/methods/offset/bernstein_triangle.h"
#include "operators/methods/offset/dense_solve.h"
#include "operators/methods/offset/loop_limit.h"

namespace udcp {
namespace {

std::size_t at(Eigen::Index k) { return static_cast<std::size_t>(k); }

template <class S>
using Vector = std::array<S, 3>;

template <class S>
S dot(const Vector<S>& a, const Vector<S>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
template <class S>
Vector<S> row_of(const Points<S>& rows, Eigen::Index k) {
  return {rows(k, 0), rows(k, 1), rows(k, 2)};
}
template <class S>
Vector<S> cross(const Vector<S>& a, const Vector<S>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
/// Square of the length of a row; of an enclosure never below 0.
template <class S>
S square(const Points<S>& rows, Eigen::Index k) {
  using std::abs;
  S sum(0);
  for (Eigen::Index c = 0; c < rows.cols(); ++c) {
    const S x = abs(rows(k, c));
    sum += x * x;
  }
  return sum;
}

template <class S>
S root(const S& x) {
  using std::max;
  using std::sqrt;
  return sqrt(max(x, S(0)));
}

/// The direction of the sum of rows; none if it is not certainly other than zero.
template <class S>
std::optional<Vector<S>> mean_direction(const Points<S>& rows) {
  Vector<S> sum{S(0), S(0), S(0)};
  for (Eigen::Index k = 0; k < rows.rows(); ++k)
    for (std::size_t c = 0; c < 3; ++c) sum[c] += rows(k, static_cast<Eigen::Index>(c));
  const S length = dot(sum, sum);
  if (!(length > S(0))) return std::nullopt;
  for (S& x : sum) x /= root(length);
  return sum;
}

/// The smallest cosine between the axis and the rows; none unless certainly positive, for then no combination leaves the cone.
template <class S>
std::optional<S> least_cosine(const Vector<S>& axis, const Points<S>& rows) {
  using std::min;
  S least(1);
  for (Eigen::Index k = 0; k < rows.rows(); ++k) {
    const S length = square(rows, k);
    if (!(length > S(0))) return std::nullopt;
    least = min(least, S(dot(axis, row_of(rows, k)) / root(length)));
  }
  if (!(least > S(0))) return std::nullopt;
  return least;
}

/// Bernstein coefficients of x_v cross x_w, degree 6.
template <class S>
Points<S> normal_form(const Points<S>& net) {
  const Points<S> b = bezier_points(net);
  return cross_product(derivative(b, 4, 0), 3, derivative(b, 4, 1), 3);
}

template <class S>
Points<S> product(const Points<S>& a, const Points<S>& b) {
  Points<S> result = Points<S>::Zero(a.rows(), b.cols());
  for (int i = 0; i < a.rows(); ++i)
    for (int j = 0; j < a.cols(); ++j)
      if (!is_zero(a(i, j))) add(result, i, a(i, j), b, j);
  return result;
}

template <class S>
S largest_square(const Points<S>& rows) {
  using std::max;
  S most(0);
  for (Eigen::Index k = 0; k < rows.rows(); ++k) most = max(most, square(rows, k));
  return most;
}

template <class S>
S row_sum_norm(const Points<S>& a) {
  using std::abs;
  using std::max;
  S most(0);
  for (Eigen::Index i = 0; i < a.rows(); ++i) {
    S sum(0);
    for (Eigen::Index j = 0; j < a.cols(); ++j) sum += abs(a(i, j));
    most = max(most, sum);
  }
  return most;
}

}  // namespace

template <class S>
LengthRange<S> length_by_hull(const Points<S>& vectors) {
  using std::max;
  using std::min;
  LengthRange<S> range{S(0), root(largest_square(vectors))};
  const std::optional<Vector<S>> axis = mean_direction(vectors);
  if (!axis) return range;
  S least = dot(*axis, row_of(vectors, 0));
  for (Eigen::Index k = 1; k < vectors.rows(); ++k) least = min(least, S(dot(*axis, row_of(vectors, k))));
  range.low = max(S(0), least);
  return range;
}

template <class S>
LengthRange<S> length_by_bernstein(const Points<S>& net) {
  const Points<S> b = bezier_points(net);
  const BernsteinTriangle<S> squared = dot_product(b, 4, b, 4);
  return {root(least_coefficient(squared)), root(greatest_coefficient(squared))};
}

template <class S>
S length_error(const LengthRange<S>& range, const S& distance) {
  using std::abs;
  using std::max;
  return max(S(range.high - abs(distance)), S(abs(distance) - range.low));
}

template <class S>
std::optional<NormalCone<S>> regular_cone(const Points<S>& net) {
  const Points<S> normals = normal_form(net);
  const std::optional<Vector<S>> axis = mean_direction(normals);
  if (!axis) return std::nullopt;
  const std::optional<S> cosine = least_cosine(*axis, normals);
  if (!cosine) return std::nullopt;
  return NormalCone<S>{*axis, *cosine};
}

template <class S>
std::optional<S> regular_error(const Points<S>& net, const Points<S>& d, const S& distance) {
  using std::abs;
  using std::min;
  const Points<S> normal = normal_form(net), delta = bezier_points(d);
  // |x_v cross x_w| is at least its least product with a unit vector; that side is forward for a positive distance.
  const std::optional<Vector<S>> axis = mean_direction(normal);
  if (!axis) return std::nullopt;
  S least_normal = dot(*axis, row_of(normal, 0));
  for (Eigen::Index k = 1; k < normal.rows(); ++k) least_normal = min(least_normal, S(dot(*axis, row_of(normal, k))));
  const BernsteinTriangle<S> delta_square = dot_product(delta, 4, delta, 4), along = dot_product(delta, 4, normal, 6);
  const S least_delta = least_coefficient(delta_square), greatest_delta = greatest_coefficient(delta_square);
  const S forward = distance < S(0) ? S(-greatest_coefficient(along)) : least_coefficient(along);
  if (!(least_delta > S(0)) || !(least_normal > S(0)) || !(forward > S(0))) return std::nullopt;
  const S sine = largest_square(cross_product(delta, 4, normal, 6)) / (least_delta * least_normal * least_normal);  // squared
  if (!(sine < S(1))) return std::nullopt;
  const S length = length_error(LengthRange<S>{root(least_delta), root(greatest_delta)}, distance);
  return root(S(length * length + S(2) * abs(distance) * root(greatest_delta) * sine / (S(1) + root(S(S(1) - sine)))));
}

template <class S>
S error_in_cone(const NormalCone<S>& cone, const Points<S>& d, const S& distance) {
  using std::abs;
  Points<S> difference = d;
  for (Eigen::Index k = 0; k < d.rows(); ++k)
    for (Eigen::Index c = 0; c < 3; ++c) difference(k, c) -= distance * cone.axis[at(c)];
  return root(largest_square(difference)) + abs(distance) * root(S(S(2) - S(2) * cone.cosine));
}

template <class S>
CornerAnalysis<S>::CornerAnalysis(int valence) : valence_(valence), step_(patch_step<S>(valence)) {
  find_eigenvectors();
  bound_ring();
  find_power();
}

template <class S>
void CornerAnalysis<S>::find_eigenvectors() {
  const int n = valence_, size = n + 6;
  lambda_ = S(3) / S(8) + cosine<S>(Rational(2) / Rational(n)) / S(4);
  const S w = loop_weight<S>(n);
  right_ = Points<S>::Zero(size, 2);
  left_ = Points<S>::Zero(3, size);
  left_(0, 0) = w / (w + S(n));
  for (int j = 0; j < n; ++j) {
    const Rational angle = Rational(2 * j) / Rational(n);
    right_(1 + j, 0) = cosine<S>(angle);
    right_(1 + j, 1) = cosine<S>(Rational(1) / Rational(2) - angle);
    left_(0, 1 + j) = S(1) / (w + S(n));
    for (int k = 0; k < 2; ++k) left_(1 + k, 1 + j) = S(2) / S(n) * right_(1 + j, k);
  }
  // (lambda - A_22) X_out = A_21 X_in.
  Points<S> matrix = Points<S>::Zero(5, 5);
  for (int i = 0; i < 5; ++i)
    for (int j = 0; j < 5; ++j) matrix(i, j) = (i == j ? lambda_ : S(0)) - step_.inner(n + 1 + i, n + 1 + j);
  const Points<S> inner_rows = step_.inner.bottomLeftCorner(5, n + 1), inner = right_.topRows(n + 1);
  right_.bottomRows(5) = dense_solve(matrix, product(inner_rows, inner));
}

template <class S>
void CornerAnalysis<S>::bound_ring() {
  using std::max;
  using std::min;
  bool first = true;
  derivative_ = S(0);
  for (const Points<S>& child : step_.regular) {
    const Points<S> b = bezier_points(product(child, right_));
    const Points<S> by_v = derivative(b, 4, 0), by_w = derivative(b, 4, 1);
    derivative_ = max(derivative_, root(max(largest_square(by_v), largest_square(by_w))));
    const Points<S> determinant = cross_product(by_v, 3, by_w, 3);
    for (Eigen::Index k = 0; k < determinant.rows(); ++k, first = false)
      jacobian_ = first ? determinant(k, 0) : min(jacobian_, determinant(k, 0));
  }
  if (!(jacobian_ > S(0)))
    throw Error(ErrorKind::limit, "E_NO_CONE", "no positive Jacobian bound at valence " + std::to_string(valence_), "");
}

// The rest A - 1 l_0 - lambda X l contracts relative to lambda: the power s with norm at most lambda^s/100.
template <class S>
void CornerAnalysis<S>::find_power() {
  constexpr int most = 200;
  Points<S> rest = step_.inner;
  for (Eigen::Index i = 0; i < rest.rows(); ++i)
    for (Eigen::Index j = 0; j < rest.cols(); ++j)
      rest(i, j) -= left_(0, j) + lambda_ * (right_(i, 0) * left_(1, j) + right_(i, 1) * left_(2, j));
  Points<S> power = rest;
  S bound = lambda_ / S(100);
  for (rings_ = 1; rings_ <= most; ++rings_, power = product(power, rest), bound *= lambda_)
    if (row_sum_norm(power) <= bound) return;
  throw Error(ErrorKind::limit, "E_NO_CONE", "the rings around valence " + std::to_string(valence_) + " do not contract", "");
}

template <class S>
std::optional<NormalCone<S>> CornerAnalysis<S>::cone(const Points<S>& net) const {
  using std::max;
  using std::min;
  const Points<S> moments = product(left_, net);  // limit, tau_1, tau_2
  const Vector<S> normal = cross(row_of(moments, 1), row_of(moments, 2));
  const S area = dot(normal, normal);
  if (!(area > S(0))) return std::nullopt;
  NormalCone<S> result{normal, S(1)};
  for (S& x : result.axis) x /= root(area);
  Points<S> ring = net, rest = net;
  for (Eigen::Index i = 0; i < net.rows(); ++i)
    for (Eigen::Index c = 0; c < 3; ++c)
      rest(i, c) -= moments(0, c) + right_(i, 0) * moments(1, c) + right_(i, 1) * moments(2, c);
  S scale(1), rho(0);  // lambda^-j
  for (int j = 0; j < rings_; ++j) {
    for (const Points<S>& child : step_.regular) {
      const std::optional<S> cosine = least_cosine(result.axis, normal_form(product(child, ring)));
      if (!cosine) return std::nullopt;
      result.cosine = min(result.cosine, *cosine);
    }
    rho = max(rho, S(scale * root(largest_square(rest))));
    ring = product(step_.inner, ring);
    rest = product(step_.inner, rest);
    scale /= lambda_;
  }
  // Later rings: derivatives are those of X tau up to e, so normals are those of tau up to 2 B e + e^2.
  const S e = S(2) / S(25) * rho;                                       // differences of points, at most 1/100 rho long, times 4
  const S tangents = root(S(square(moments, 1) + square(moments, 2)));  // at least the spectral norm of tau
  const S b = derivative_ * tangents;
  const S sine = (S(2) * b * e + e * e) / (jacobian_ * root(area));
  if (!(sine < S(1))) return std::nullopt;
  result.cosine = min(result.cosine, root(S(S(1) - sine * sine)));
  if (!(result.cosine > S(0))) return std::nullopt;
  return result;
}

#define UDCP_INSTANTIATE(S)                                                              \
  template LengthRange<S> length_by_hull(const Points<S>&);                              \
  template LengthRange<S> length_by_bernstein(const Points<S>&);                         \
  template S length_error(const LengthRange<S>&, const S&);                              \
  template std::optional<NormalCone<S>> regular_cone(const Points<S>&);                  \
  template std::optional<S> regular_error(const Points<S>&, const Points<S>&, const S&); \
  template S error_in_cone(const NormalCone<S>&, const Points<S>&, const S&);            \
  template class CornerAnalysis<S>;
UDCP_INSTANTIATE(double)
UDCP_INSTANTIATE(Interval)
#undef UDCP_INSTANTIATE

}  // namespace udcp
