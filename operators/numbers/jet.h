// Jets: enclosures of the value, the first and the second derivative of a function of one variable over a range of it, computed
// by the chain rule on outward rounded intervals. For monotonicity and curvature of masks as functions of alpha.
#pragma once

#include <iosfwd>
#include <string>
#include <utility>

#include "operators/numbers/interval.h"
#include "operators/numbers/rational.h"

namespace udcp {

class Jet {
 public:
  Jet();                                // 0
  Jet(int value);                       // NOLINT: integers convert, to constants
  Jet(double) = delete;                 // no number is a double by accident
  explicit Jet(const Rational& value);  // constants: their derivatives are 0
  explicit Jet(Interval value);
  /// The variable itself, on `range`. All jets of a computation have to be functions of the same variable on the same range.
  static Jet variable(Interval range);
  /// A function known by its enclosures.
  static Jet of(Interval value, Interval first, Interval second);
  // Out of line, so that matrices of them stay cheap to compile.
  Jet(const Jet&);
  Jet(Jet&&) noexcept;
  Jet& operator=(const Jet&);
  Jet& operator=(Jet&&) noexcept;
  ~Jet();

  [[nodiscard]] const Interval& value() const { return value_; }
  [[nodiscard]] const Interval& first() const { return first_; }
  [[nodiscard]] const Interval& second() const { return second_; }
  [[nodiscard]] bool is_constant() const { return constant_; }  // made from constants only
  [[nodiscard]] std::string to_string() const;                  // "[lo, hi]", and the derivatives unless it is a constant

  // Errors as for Interval: E_NOT_FINITE, and E_DIV0 if the value of the divisor contains 0.
  Jet& operator+=(const Jet&);
  Jet& operator-=(const Jet&);
  Jet& operator*=(const Jet&);
  Jet& operator/=(const Jet&);
  friend Jet operator+(Jet a, const Jet& b) { return std::move(a += b); }
  friend Jet operator-(Jet a, const Jet& b) { return std::move(a -= b); }
  friend Jet operator*(Jet a, const Jet& b) { return std::move(a *= b); }
  friend Jet operator/(Jet a, const Jet& b) { return std::move(a /= b); }
  Jet operator-() const;

  // Certainly true on the whole range and near it, so that a branch taken on them is the function whose derivatives are enclosed:
  // order needs separated values; equality, or <= on touching values, needs constants.
  friend bool operator==(const Jet& a, const Jet& b) { return a.certainly_equal(b); }
  friend bool operator!=(const Jet& a, const Jet& b) { return a.value_ != b.value_; }
  friend bool operator<(const Jet& a, const Jet& b) { return a.value_ < b.value_; }
  friend bool operator>(const Jet& a, const Jet& b) { return a.value_ > b.value_; }
  friend bool operator<=(const Jet& a, const Jet& b) { return a.certainly_less_equal(b); }
  friend bool operator>=(const Jet& a, const Jet& b) { return b.certainly_less_equal(a); }

 private:
  Jet(Interval value, Interval first, Interval second, bool constant);
  [[nodiscard]] bool certainly_equal(const Jet&) const;
  [[nodiscard]] bool certainly_less_equal(const Jet&) const;

  Interval value_, first_, second_;
  bool constant_ = true;  // then the derivatives are exactly 0
};

// Errors as for Interval; sqrt and log have derivatives only where the value is certainly positive (E_DIV0 for sqrt).
Jet cos(const Jet&);
Jet sin(const Jet&);
Jet tan(const Jet&);
Jet exp(const Jet&);
Jet log(const Jet&);
Jet sqrt(const Jet&);
Jet pow(const Jet&, int exponent);
/// Where the order is certain, or of constants; otherwise Error{not_exact, "E_UNDECIDED"}: there may be a kink.
Jet abs(const Jet&);
Jet min(const Jet&, const Jet&);
Jet max(const Jet&, const Jet&);
std::ostream& operator<<(std::ostream&, const Jet&);

}  // namespace udcp
