// Polynomials in one variable over an exact field: division, common divisors, square-free factors, real roots isolated and
// enclosed. S is Rational or Algebraic; nothing is rounded.
#pragma once

#include <utility>
#include <vector>

#include "operators/number.h"

namespace udcp {

/// Coefficients lowest first; the last one is not zero. The zero polynomial has none.
template <class S>
struct Polynomial {
  std::vector<S> coefficients;

  Polynomial() = default;
  Polynomial(std::vector<S> lowest_first);  // NOLINT: coefficients convert; zeros at the top are dropped
  static Polynomial monomial(const S& coefficient, int degree);

  [[nodiscard]] int degree() const { return static_cast<int>(coefficients.size()) - 1; }  // -1 for zero
  [[nodiscard]] bool is_zero() const { return coefficients.empty(); }
  [[nodiscard]] S at(const S& x) const;
  [[nodiscard]] Interval at(const Interval& x) const;  // encloses
  [[nodiscard]] Polynomial derivative() const;
  [[nodiscard]] Polynomial monic() const;
  friend bool operator==(const Polynomial& a, const Polynomial& b) { return a.coefficients == b.coefficients; }
};
template <class S>
Polynomial<S> operator+(const Polynomial<S>& a, const Polynomial<S>& b);
template <class S>
Polynomial<S> operator-(const Polynomial<S>& a, const Polynomial<S>& b);
template <class S>
Polynomial<S> operator*(const Polynomial<S>& a, const Polynomial<S>& b);
/// Quotient and remainder. Error{input, "E_DIV0"} for the zero divisor.
template <class S>
std::pair<Polynomial<S>, Polynomial<S>> divide(const Polynomial<S>& a, const Polynomial<S>& b);
/// Monic greatest common divisor.
template <class S>
Polynomial<S> gcd(const Polynomial<S>& a, const Polynomial<S>& b);

/// Monic, pairwise coprime square-free factors with their multiplicities (Yun), constant factor dropped.
template <class S>
std::vector<std::pair<Polynomial<S>, int>> square_free_factors(const Polynomial<S>& p);

/// A real root between two rationals of the square-free `factor`, which has no other root in [lower, upper] and opposite signs
/// at the ends; or lower == upper, the root itself.
struct RealRoot {
  Rational lower, upper;
  int multiplicity = 1;
};
/// All real roots, rising, each in an interval at most `width` wide (Sturm). Isolating intervals are disjoint.
template <class S>
std::vector<RealRoot> real_roots(const Polynomial<S>& p, const Rational& width);

}  // namespace udcp
