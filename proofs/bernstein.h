// Polynomials in several variables on a box: exact signs from Bernstein coefficients. Everything is rational; the box may be open
// at some of its sides, and infinite, after a change of variable that this file makes.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "operators/number.h"

namespace udcp {

/// One parameter of a claim: lower and upper end, infinite if there is none. An infinite end is open.
struct ParameterRange {
  std::string name;
  std::optional<Rational> lower, upper;
  bool lower_open = false, upper_open = false;
};
using ParameterBox = std::vector<ParameterRange>;

/// A dense polynomial in n variables: the coefficient of x0^i0 x1^i1 ... stands at ((i0 (d1 + 1) + i1) (d2 + 1) + ...).
struct BoxPolynomial {
  std::vector<int> degrees;  // n entries
  std::vector<Rational> coefficients;

  static BoxPolynomial constant(const Rational& value, std::size_t variables);
  [[nodiscard]] bool is_zero() const;
  [[nodiscard]] Rational at(const std::vector<Rational>& point) const;
};
BoxPolynomial operator+(const BoxPolynomial& a, const BoxPolynomial& b);
BoxPolynomial operator*(const Rational& factor, BoxPolynomial a);
BoxPolynomial operator-(const BoxPolynomial& a, const BoxPolynomial& b);
/// Throws Error{limit, "E_PARAMETRIC_SIZE"} if the product would have more than 200,000 coefficients.
BoxPolynomial operator*(const BoxPolynomial& a, const BoxPolynomial& b);

/// An end of a range in coordinates where every range is finite: x itself for finite ranges; g in (0, 1) with x = lower - 1 + 1/g
/// or x = upper + 1 - 1/g for half-infinite ones. A range without any end is refused: split it at 0 first.
struct Side {
  Rational lower, upper;
  bool lower_open = false, upper_open = false;
};
Side finite_side(const ParameterRange& range);
/// p in the finite coordinates, times a positive function of them (a power of every g): the sign is kept.
BoxPolynomial in_finite_coordinates(BoxPolynomial p, const ParameterBox& box);
/// The value of the parameter at a point of the finite coordinates; g must not be 0.
Rational from_finite(const ParameterRange& range, const Rational& value);

/// True only if p > 0 everywhere on the box: all Bernstein coefficients are >= 0, and not all 0 on any face that belongs to the
/// box (then p is a positive combination of basis functions that are positive there). False says nothing.
bool positive_on(const BoxPolynomial& p, const std::vector<Side>& box);
/// True only if p >= 0 everywhere on the closed box.
bool non_negative_on(const BoxPolynomial& p, const std::vector<Side>& box);

}  // namespace udcp
