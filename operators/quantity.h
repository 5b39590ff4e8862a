// Quantity: the value of a parameter while it is computed. It stays an exact rational, or a rational multiple of pi, as long as
// it can (so that cos(2*pi/6) is 1/2 in every number type), and becomes a number S only when it must.
#pragma once

#include "operators/number.h"

namespace udcp {

template <class S>
class Quantity {
 public:
  enum class Kind { rational, pi_multiple, number };

  Quantity() = default;                                   // 0
  Quantity(int value) : exact_(value) {}                  // NOLINT: integers convert
  Quantity(Rational value) : exact_(std::move(value)) {}  // NOLINT: so do rationals
  static Quantity pi(Rational times = Rational(1));       // times * pi; plain 0 if times is 0
  /// A computed number; exact ones that are rational become that kind. Error{input, "E_NOT_FINITE"} for an infinite double or
  /// NaN.
  static Quantity of(S value);

  [[nodiscard]] Kind kind() const { return kind_; }
  /// The rational, or the factor of pi. Only for those kinds.
  [[nodiscard]] const Rational& exact() const { return exact_; }
  /// The value in S. Error{not_exact, "E_NOT_EXACT"} for a multiple of pi in an exact type. A number of Parametric is never
  /// constant.
  [[nodiscard]] S value() const;
  [[nodiscard]] std::string to_string() const;  // "7/12", "2/5*pi", or the number as to_text says it

  template <class T>
  friend Quantity<T> operator+(const Quantity<T>&, const Quantity<T>&);
  template <class T>
  friend Quantity<T> operator-(const Quantity<T>&, const Quantity<T>&);
  template <class T>
  friend Quantity<T> operator*(const Quantity<T>&, const Quantity<T>&);
  template <class T>
  friend Quantity<T> operator/(const Quantity<T>&, const Quantity<T>&);  // E_DIV0; pi/pi is rational
  Quantity operator-() const;

 private:
  Kind kind_ = Kind::rational;
  Rational exact_;
  S number_{0};
};

// So that a formula can say `1 - 8/3*x`, `alpha / 2` with plain integers and fractions.
template <class S>
Quantity<S> operator+(const Quantity<S>& a, const Rational& b) {
  return a + Quantity<S>(b);
}
template <class S>
Quantity<S> operator+(const Rational& a, const Quantity<S>& b) {
  return Quantity<S>(a) + b;
}
template <class S>
Quantity<S> operator-(const Quantity<S>& a, const Rational& b) {
  return a - Quantity<S>(b);
}
template <class S>
Quantity<S> operator-(const Rational& a, const Quantity<S>& b) {
  return Quantity<S>(a) - b;
}
template <class S>
Quantity<S> operator*(const Quantity<S>& a, const Rational& b) {
  return a * Quantity<S>(b);
}
template <class S>
Quantity<S> operator*(const Rational& a, const Quantity<S>& b) {
  return Quantity<S>(a) * b;
}
template <class S>
Quantity<S> operator/(const Quantity<S>& a, const Rational& b) {
  return a / Quantity<S>(b);
}
template <class S>
Quantity<S> operator/(const Rational& a, const Quantity<S>& b) {
  return Quantity<S>(a) / b;
}

// Exact results stay exact (cos(pi/3), sqrt(9/4), exp(0), log(1)). What S cannot hold throws Error{not_exact, "E_NOT_EXACT"}; a
// double that is not finite throws Error{input, "E_NOT_FINITE"}; the others are named below.
template <class S>
Quantity<S> cos(const Quantity<S>&);
template <class S>
Quantity<S> sin(const Quantity<S>&);
template <class S>
Quantity<S> tan(const Quantity<S>&);  // E_DIV0 at odd multiples of pi/2
template <class S>
Quantity<S> sqrt(const Quantity<S>&);  // E_SQRT_NEGATIVE
template <class S>
Quantity<S> exp(const Quantity<S>&);
template <class S>
Quantity<S> log(const Quantity<S>&);  // E_LOG_DOMAIN unless positive
template <class S>
Quantity<S> abs(const Quantity<S>&);
// Of two enclosures that overlap, the enclosure of the minimum (maximum).
template <class S>
Quantity<S> min(const Quantity<S>&, const Quantity<S>&);
template <class S>
Quantity<S> max(const Quantity<S>&, const Quantity<S>&);
/// Exact for integer exponents and perfect roots; 0^0 is 1. E_DIV0 for 0 to a negative power, Error{limit, "E_POWER_SIZE"},
/// Error{input, "E_POWER_NEGATIVE"} for a negative base with an exponent that is no integer.
template <class S>
Quantity<S> pow(const Quantity<S>& base, const Quantity<S>& exponent);
/// -1, 0 or 1; Error{not_exact, "E_UNDECIDED"} where enclosures cannot tell, or where it depends on free parameters.
template <class S>
int compare(const Quantity<S>&, const Quantity<S>&);

/// noise(seed) at point i after h earlier U: uniform in [-1, 1), the same exact dyadic number on every machine.
/// Error{input, "E_NOISE_SEED"} unless the seed is an integer.
template <class S>
Quantity<S> noise(const Rational& seed, int h, int i);

/// The same quantity in another number type, from those that coordinates have: exact kinds carry over; a number by number<T> from
/// Algebraic, itself or the midpoint from Interval, exactly from double. Error{not_exact, "E_NOT_EXACT"} where T is exact and the
/// number is not.
template <class T, class S>
Quantity<T> convert(const Quantity<S>& value);

}  // namespace udcp
