// The real fields Q(cos(2 pi/N)): exact arithmetic with decided sign, for the cosines that subdivision schemes are made of.
// A value is a polynomial in 2 cos(2 pi/N) of degree below phi(N)/2, reduced; a null field means a plain fraction.
#pragma once

#include <iosfwd>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "operators/numbers/interval.h"
#include "operators/numbers/rational.h"

namespace udcp {

class Algebraic {
 public:
  Algebraic();
  Algebraic(int value);              // NOLINT: integers convert
  Algebraic(const Rational& value);  // NOLINT: so do rationals
  Algebraic(double) = delete;
  // Out of line, so that matrices of them stay cheap to compile.
  Algebraic(const Algebraic&);
  Algebraic(Algebraic&&) noexcept;
  Algebraic& operator=(const Algebraic&);
  Algebraic& operator=(Algebraic&&) noexcept;
  ~Algebraic();

  /// cos(q pi). Error{limit, "E_FIELD_DEGREE"} if the field would have a degree above 192.
  static Algebraic cosine(const Rational& q);

  // Operands from two fields meet in Q(cos(2 pi/lcm)), under the same degree limit. Comparisons that an enclosure decides need no
  // common field.
  Algebraic& operator+=(const Algebraic&);
  Algebraic& operator-=(const Algebraic&);
  Algebraic& operator*=(const Algebraic&);
  Algebraic& operator/=(const Algebraic&);  // E_DIV0
  friend Algebraic operator+(Algebraic a, const Algebraic& b) { return std::move(a += b); }
  friend Algebraic operator-(Algebraic a, const Algebraic& b) { return std::move(a -= b); }
  friend Algebraic operator*(Algebraic a, const Algebraic& b) { return std::move(a *= b); }
  friend Algebraic operator/(Algebraic a, const Algebraic& b) { return std::move(a /= b); }
  Algebraic operator-() const;

  [[nodiscard]] int sign() const;                     // exact: zero by coefficients, otherwise by enclosures of growing precision
  [[nodiscard]] int compare(const Algebraic&) const;  // -1, 0, 1
  friend bool operator==(const Algebraic& a, const Algebraic& b) { return a.equals(b); }
  friend bool operator!=(const Algebraic& a, const Algebraic& b) { return !a.equals(b); }
  friend bool operator<(const Algebraic& a, const Algebraic& b) { return a.compare(b) < 0; }
  friend bool operator>(const Algebraic& a, const Algebraic& b) { return a.compare(b) > 0; }
  friend bool operator<=(const Algebraic& a, const Algebraic& b) { return a.compare(b) <= 0; }
  friend bool operator>=(const Algebraic& a, const Algebraic& b) { return a.compare(b) >= 0; }

  [[nodiscard]] bool is_zero() const { return !field_ && rational_.is_zero(); }
  [[nodiscard]] bool is_rational() const { return !field_; }
  [[nodiscard]] Rational rational() const;   // Error{not_exact, "E_NOT_EXACT"} unless is_rational()
  [[nodiscard]] Interval enclosure() const;  // in the working precision of Interval
  [[nodiscard]] double to_double() const;    // the nearest double
  [[nodiscard]] int field_order() const;     // N of Q(cos(2 pi/N)), 1 for plain fractions
  /// Coefficients in powers of c = 2 cos(2 pi/N), lowest first; one entry for a plain fraction.
  [[nodiscard]] std::vector<Rational> coefficients() const;
  /// "p/q"; "a + b*sqrt(d)" where the value is quadratic; otherwise a polynomial in cos(2*pi/N) that the language reads back.
  [[nodiscard]] std::string to_string() const;

  /// a + b sqrt(d) with d > 1 square-free and b not 0.
  struct Quadratic {
    Rational a, b;
    int d = 1;
  };
  [[nodiscard]] std::optional<Quadratic> quadratic() const;  // nothing for fractions and higher degrees

  struct Field;

 private:
  using Polynomial = std::vector<Rational>;
  Algebraic(std::shared_ptr<const Field> field, Polynomial coefficients);  // collapses to a fraction where it is one
  static Algebraic root_of_integer(int d);                                 // sqrt(d), d square-free
  friend Algebraic sqrt(const Algebraic&);
  friend std::optional<Algebraic> root_of_fraction(const Rational&);
  [[nodiscard]] bool equals(const Algebraic&) const;
  [[nodiscard]] Algebraic inverse() const;
  [[nodiscard]] Polynomial lifted(const Field& field) const;
  template <class Operation>
  Algebraic& combine(const Algebraic& other, Operation operation);

  // With a field the value is irrational: at least one coefficient beyond the first is not 0. Without one, rational_ is the
  // value.
  std::shared_ptr<const Field> field_;
  Rational rational_;
  Polynomial coefficients_;
};

Algebraic abs(const Algebraic&);
/// E_DIV0 for 0 to a negative power; Error{limit, "E_POWER_SIZE"} past 10 million bits.
Algebraic pow(const Algebraic& base, int exponent);
/// Exact where the root is a + b sqrt(d) or a sum of two square roots that this class can name; Error{not_exact, "E_NOT_EXACT"}
/// otherwise, Error{input, "E_SQRT_NEGATIVE"} for negative values.
Algebraic sqrt(const Algebraic&);
std::ostream& operator<<(std::ostream&, const Algebraic&);

}  // namespace udcp
