// Pairs of numbers of Q(cos(2 pi/n)).
#include "proofs/tangent_number.h"

namespace udcp {
namespace {

Algebraic one_plus_cosine(int n) { return Algebraic(1) + Algebraic::cosine(Rational(2) / Rational(n)); }

// Both roots of x^2 - 2 (1 + c) x - 8 (1 + c).
Interval root(int n, bool positive) {
  const Interval half = one_plus_cosine(n).enclosure(), radical = sqrt(half * half + Interval(8) * half);
  return positive ? half + radical : half - radical;
}

}  // namespace

TangentNumber TangentNumber::weight(int n) {
  TangentNumber result;
  result.b_ = Algebraic(1);
  result.n_ = n;
  return result;
}

TangentNumber& TangentNumber::operator+=(const TangentNumber& other) {
  a_ += other.a_;
  b_ += other.b_;
  if (n_ == 0) n_ = other.n_;
  return *this;
}

TangentNumber& TangentNumber::operator-=(const TangentNumber& other) {
  a_ -= other.a_;
  b_ -= other.b_;
  if (n_ == 0) n_ = other.n_;
  return *this;
}

TangentNumber& TangentNumber::operator*=(const TangentNumber& other) {
  if (n_ == 0) n_ = other.n_;
  const Algebraic squares = b_ * other.b_;
  const Algebraic mixed = a_ * other.b_ + b_ * other.a_;
  a_ *= other.a_;
  b_ = mixed;
  if (squares.is_zero()) return *this;
  const Algebraic factor = squares * one_plus_cosine(n_);
  a_ += Algebraic(8) * factor;
  b_ += Algebraic(2) * factor;
  return *this;
}

// (a + b A)(a + b A') with A + A' = 2 (1 + c), A A' = -8 (1 + c).
Algebraic TangentNumber::norm() const {
  if (b_.is_zero()) return a_ * a_;
  const Algebraic half = one_plus_cosine(n_);
  return a_ * a_ + Algebraic(2) * a_ * b_ * half - Algebraic(8) * b_ * b_ * half;
}

TangentNumber TangentNumber::inverse() const {
  const Algebraic scale = Algebraic(1) / norm();
  TangentNumber conjugate = *this;
  if (!b_.is_zero()) conjugate.a_ += Algebraic(2) * b_ * one_plus_cosine(n_);
  conjugate.a_ *= scale;
  conjugate.b_ = -b_ * scale;
  return conjugate;
}

Interval TangentNumber::enclosure() const {
  if (b_.is_zero()) return a_.enclosure();
  return a_.enclosure() + b_.enclosure() * root(n_, true);
}

// If the norm is 0, one of both conjugates is 0, and not both: b is not 0 and the roots differ.
bool TangentNumber::is_zero() const {
  if (b_.is_zero()) return a_.is_zero();
  if (!norm().is_zero()) return false;
  for (int bits = 128;; bits *= 2) {
    const Interval::Precision precision(bits);
    if (!enclosure().contains_zero()) return false;
    if (!(a_.enclosure() + b_.enclosure() * root(n_, false)).contains_zero()) return true;
  }
}

int TangentNumber::sign() const {
  if (b_.is_zero()) return a_.sign();
  if (is_zero()) return 0;
  for (int bits = 128;; bits *= 2) {
    const Interval::Precision precision(bits);
    const Interval value = enclosure();
    if (!value.contains_zero()) return value > Interval(0) ? 1 : -1;
  }
}

}  // namespace udcp
