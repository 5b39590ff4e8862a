// Cells of Catmull-Clark curves: one linear system for the cell between regular points, its halves for those at fixed ends.
#include "proofs/regularity/cell_weights.h"

#include <algorithm>

#include "operators/matrix.h"
#include "operators/schemes.h"
#include "proofs/linear_algebra.h"

namespace udcp {
namespace {

using Index = Eigen::Index;
using Weights = std::vector<Polynomial<Rational>>;

[[noreturn]] void not_determined() {
  throw Error(ErrorKind::internal, "E_INTERNAL", "the refinement equation does not determine the weights of the cell");
}

Rational half_to_the(int k) { return pow(Rational(1) / Rational(2), k); }

Rational binomial(int n, int k) {
  Rational result(1);
  for (int i = 0; i < k; ++i) result *= Rational(n - i) / Rational(i + 1);
  return result;
}

/// Weights of the points after a linear map of the points: the row of polynomials times the matrix.
Weights times(const Weights& weights, const Points<Rational>& matrix) {
  Weights result(static_cast<std::size_t>(matrix.cols()));
  for (Index j = 0; j < matrix.cols(); ++j)
    for (Index i = 0; i < matrix.rows(); ++i)
      result[static_cast<std::size_t>(j)] =
          result[static_cast<std::size_t>(j)] + Polynomial<Rational>({matrix(i, j)}) * weights[static_cast<std::size_t>(i)];
  return result;
}

Weights composed(Weights weights, const Rational& a, const Rational& b) {
  for (Polynomial<Rational>& p : weights) p = udcp::composed(p, a, b);
  return weights;
}

/// N with N(t/2) = N(t) A_0, N((1 + t)/2) = N(t) A_1 and sum 1: a linear system for the coefficients of four cubic polynomials,
/// number 4 k + i for t^k in N_i.
Weights regular_weights() {
  constexpr int degree = 3, n = degree + 1;
  const Points<Rational> first = half_cell_matrix(false, false, 0), second = half_cell_matrix(false, false, 1);
  Points<Rational> system = Points<Rational>::Zero(2 * n * n + 1, n * n), right = Points<Rational>::Zero(2 * n * n + 1, 1);
  for (int m = 0; m < n; ++m) {
    for (int j = 0; j < n; ++j) {
      const Index row = n * m + j, next = n * n + row;
      system(row, row) += half_to_the(m);
      for (int k = m; k < n; ++k) system(next, n * k + j) += binomial(k, m) * half_to_the(k);
      for (int i = 0; i < n; ++i) {
        system(row, n * m + i) -= first(i, j);
        system(next, n * m + i) -= second(i, j);
      }
    }
  }
  for (int i = 0; i < n; ++i) system(2 * n * n, i) = Rational(1);
  right(2 * n * n, 0) = Rational(1);
  const std::optional<Points<Rational>> solution = solve(system, right);
  if (!solution || rank(system) < n * n) not_determined();
  Weights weights;
  for (int i = 0; i < n; ++i) {
    std::vector<Rational> coefficients;
    for (int k = 0; k < n; ++k) coefficients.push_back((*solution)(n * k + i, 0));
    weights.emplace_back(std::move(coefficients));
  }
  return weights;
}

/// A half of a cell at a fixed end is farther from it: the same polynomials, seen from there.
Weights point_weights(bool fixed_start, bool fixed_end) {
  const Rational two(2);
  if (fixed_start)
    return composed(times(point_weights(false, fixed_end), half_cell_matrix(true, fixed_end, 1)), Rational(-1), two);
  if (fixed_end) return composed(times(point_weights(false, false), half_cell_matrix(false, true, 0)), Rational(0), two);
  return regular_weights();
}

/// Both halves of the cell are cells of the refined curve.
bool is_refinable(const Weights& weights, bool fixed_start, bool fixed_end) {
  const Rational half = half_to_the(1);
  return composed(weights, Rational(0), half) ==
             times(point_weights(fixed_start, false), half_cell_matrix(fixed_start, fixed_end, 0)) &&
         composed(weights, half, half) == times(point_weights(false, fixed_end), half_cell_matrix(fixed_start, fixed_end, 1));
}

}  // namespace

Points<Rational> half_cell_matrix(bool fixed_start, bool fixed_end, int half) {
  const int points = 4 - (fixed_start ? 1 : 0) - (fixed_end ? 1 : 0);
  Polyline<Rational> curve;
  curve.closed = false;
  curve.points = Points<Rational>::Zero(points, 1);
  const Points<Rational> fine = subdivision_matrix(schemes::catmull_clark(), curve);
  // The ends of the polyline are fixed, but where the cell goes on nobody reads the rows that know it.
  const int start = (fixed_start ? 0 : 2) + half;
  const int before = fixed_start && half == 0 ? 0 : 1, after = fixed_end && half == 1 ? 0 : 1;
  return fine.middleRows(start - before, before + 2 + after);
}

CellWeights cell_weights(bool fixed_start, bool fixed_end) {
  CellWeights result{point_weights(fixed_start, fixed_end), {}};
  if (!is_refinable(result.points, fixed_start, fixed_end)) not_determined();
  // Summation by parts; the derivatives of the weights sum to 0.
  Polynomial<Rational> sum;
  for (std::size_t i = 0; i + 1 < result.points.size(); ++i) {
    sum = sum - result.points[i].derivative();
    result.differences.push_back(sum);
  }
  return result;
}

Polynomial<Rational> composed(const Polynomial<Rational>& p, const Rational& a, const Rational& b) {
  const Polynomial<Rational> inner({a, b});
  Polynomial<Rational> result;
  for (auto c = p.coefficients.rbegin(); c != p.coefficients.rend(); ++c) result = result * inner + Polynomial<Rational>({*c});
  return result;
}

std::vector<Rational> bernstein_coefficients(const Polynomial<Rational>& p, int degree) {
  if (p.degree() > degree)
    throw Error(ErrorKind::internal, "E_INTERNAL", "a polynomial has more than the degree it is said to have");
  std::vector<Rational> result;
  for (int i = 0; i <= degree; ++i) {
    Rational sum;
    for (int k = 0; k <= std::min(i, p.degree()); ++k)
      sum += binomial(i, k) / binomial(degree, k) * p.coefficients[static_cast<std::size_t>(k)];
    result.push_back(sum);
  }
  return result;
}

bool are_convex(const std::vector<Polynomial<Rational>>& weights) {
  Polynomial<Rational> sum;
  for (const Polynomial<Rational>& w : weights) {
    sum = sum + w;
    const std::vector<Rational> coefficients = bernstein_coefficients(w, std::max(0, w.degree()));
    if (std::any_of(coefficients.begin(), coefficients.end(), [](const Rational& c) { return c.sign() < 0; })) return false;
  }
  return sum == Polynomial<Rational>({Rational(1)});
}

}  // namespace udcp
