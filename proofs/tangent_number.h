// The numbers a + b A where A is the weight A_n of Catmull-Clark's tangents at valence n: the positive root of
// A^2 = 2 (1 + c) A + 8 (1 + c), c = cos(2 pi/n), over the field of c. Exact, with decided sign. Knows no mesh.
#pragma once

#include "operators/number.h"

namespace udcp {

class TangentNumber {
 public:
  TangentNumber(int value = 0) : a_(value) {}               // NOLINT: integers convert
  TangentNumber(const Rational& value) : a_(value) {}       // NOLINT: so do fractions
  TangentNumber(Algebraic value) : a_(std::move(value)) {}  // NOLINT: and numbers of the field of c
  /// A_n, n >= 3. Numbers of different n must not meet.
  static TangentNumber weight(int n);

  TangentNumber& operator+=(const TangentNumber&);
  TangentNumber& operator-=(const TangentNumber&);
  TangentNumber& operator*=(const TangentNumber&);
  friend TangentNumber operator+(TangentNumber x, const TangentNumber& y) { return std::move(x += y); }
  friend TangentNumber operator-(TangentNumber x, const TangentNumber& y) { return std::move(x -= y); }
  friend TangentNumber operator*(TangentNumber x, const TangentNumber& y) { return std::move(x *= y); }
  /// E_DIV0 if the norm over the field of c is 0.
  [[nodiscard]] TangentNumber inverse() const;

  [[nodiscard]] bool is_zero() const;  // exact, also where A_n lies in the field of c (n = 4: A = 4)
  [[nodiscard]] int sign() const;      // -1, 0 or 1; by enclosures of growing precision
  [[nodiscard]] double to_double() const { return enclosure().midpoint(); }

 private:
  [[nodiscard]] Algebraic norm() const;      // the product with the conjugate, where A is the other root
  [[nodiscard]] Interval enclosure() const;  // in the working precision of Interval
  Algebraic a_, b_;
  int n_ = 0;  // 0: no A is in it
};

}  // namespace udcp
