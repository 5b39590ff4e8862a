// The field Q(cos(2 pi/N)) as polynomials modulo a minimal polynomial: the arithmetic inside Algebraic, for its source files
// only. c = 2 cos(2 pi/N) generates the field and e_k = 2 cos(2 pi k/N), so that e_0 = 2, e_1 = c and c e_k = e_{k+1} + e_{k-1}.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "operators/numbers/algebraic.h"

namespace udcp {

/// Immutable; N is odd or a multiple of 4 (other N give the field of N/2) and at least 5.
struct Algebraic::Field {
  static constexpr int largest_degree = 192;
  static constexpr int largest_order = 4000;  // every larger N has a degree above 192

  int order = 0;                  // N
  int degree = 0;                 // phi(N)/2
  std::vector<Rational> minimal;  // of c: monic with integer coefficients, degree + 1 entries, lowest first

  /// The field of this order, made once. Error{limit, "E_FIELD_DEGREE"} unless within_limit(order).
  static std::shared_ptr<const Field> of(int order);
  static bool within_limit(int order);

  /// Brings a polynomial in c to `degree` entries.
  void reduce(std::vector<Rational>& p) const;
  [[nodiscard]] std::vector<Rational> product(const std::vector<Rational>& a, const std::vector<Rational>& b) const;
  /// The sum of weight times e_k over the pairs (k >= 0, weight), as a polynomial in c.
  [[nodiscard]] std::vector<Rational> from_cosines(const std::vector<std::pair<int, Rational>>& terms) const;
};

/// The Moebius function of n >= 1.
int moebius(int n);

}  // namespace udcp
