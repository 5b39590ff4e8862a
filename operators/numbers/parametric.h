// The field Q(x, y, ...) of rational functions in named parameters: atoms on symbols. A nonzero element is invertible, so a
// result holds wherever none of the denominators vanishes, as the generic formula does.
// Numerator and denominator are coprime polynomials with integer coefficients, so equal functions are equal member by member.
#pragma once

#include <iosfwd>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "operators/numbers/rational.h"

namespace udcp {

class Algebraic;
class Interval;
struct ParametricPolynomial;  // operators/numbers/parametric_polynomial.h

class Parametric {
 public:
  Parametric();
  Parametric(int value);              // NOLINT: integers convert
  Parametric(const Rational& value);  // NOLINT: so do rationals
  Parametric(double) = delete;
  Parametric(const Parametric&);
  Parametric(Parametric&&) noexcept;
  Parametric& operator=(const Parametric&);
  Parametric& operator=(Parametric&&) noexcept;
  ~Parametric();

  /// The parameter itself. Error{input, "E_NAME"} unless the name is letters, digits and _ without a digit in front.
  static Parametric variable(const std::string& name);
  /// p/q in lowest terms. E_DIV0 for q = 0.
  static Parametric quotient(const ParametricPolynomial& p, const ParametricPolynomial& q);

  // Error{limit, "E_PARAMETRIC_SIZE"} past 6 parameters, 2000 terms or degree 200 in a numerator or denominator.
  Parametric& operator+=(const Parametric&);
  Parametric& operator-=(const Parametric&);
  Parametric& operator*=(const Parametric&);
  Parametric& operator/=(const Parametric&);  // E_DIV0
  friend Parametric operator+(Parametric a, const Parametric& b) { return std::move(a += b); }
  friend Parametric operator-(Parametric a, const Parametric& b) { return std::move(a -= b); }
  friend Parametric operator*(Parametric a, const Parametric& b) { return std::move(a *= b); }
  friend Parametric operator/(Parametric a, const Parametric& b) { return std::move(a /= b); }
  Parametric operator-() const;

  /// -1, 0 or 1 where the difference is a number. Error{not_exact, "E_UNDECIDED"} where it depends on parameters.
  [[nodiscard]] int compare(const Parametric&) const;
  // Equality as functions; it is always decided.
  friend bool operator==(const Parametric& a, const Parametric& b) { return a.equals(b); }
  friend bool operator!=(const Parametric& a, const Parametric& b) { return !a.equals(b); }
  friend bool operator<(const Parametric& a, const Parametric& b) { return a.compare(b) < 0; }
  friend bool operator>(const Parametric& a, const Parametric& b) { return a.compare(b) > 0; }
  friend bool operator<=(const Parametric& a, const Parametric& b) { return a.compare(b) <= 0; }
  friend bool operator>=(const Parametric& a, const Parametric& b) { return a.compare(b) >= 0; }

  [[nodiscard]] bool is_zero() const { return !function_ && constant_.is_zero(); }
  [[nodiscard]] bool is_constant() const { return !function_; }
  [[nodiscard]] Rational constant() const;  // Error{not_exact, "E_NOT_EXACT"} unless is_constant()
  /// Coprime, with integer coefficients; the leading coefficient of the denominator is positive.
  [[nodiscard]] ParametricPolynomial numerator() const;
  [[nodiscard]] ParametricPolynomial denominator() const;
  [[nodiscard]] std::vector<std::string> variables() const;  // sorted

  /// The value at numbers of the parameters; the Interval encloses. Error{input}: E_NAME if a parameter has no value, E_DIV0
  /// where the denominator is (for an enclosure: may be) zero.
  [[nodiscard]] Rational at(const std::map<std::string, Rational>& values) const;
  [[nodiscard]] Algebraic at(const std::map<std::string, Algebraic>& values) const;
  [[nodiscard]] Interval at(const std::map<std::string, Interval>& values) const;
  /// One parameter replaced. E_DIV0 if the denominator becomes the function 0.
  [[nodiscard]] Parametric substitute(const std::string& name, const Parametric& value) const;
  [[nodiscard]] Parametric derivative(const std::string& name) const;

  [[nodiscard]] double to_double() const;       // of a constant; Error{not_exact, "E_NOT_EXACT"} otherwise
  [[nodiscard]] std::string to_string() const;  // "(3*delta*omega + 4)/(8*f + 8)", which the language reads
  [[nodiscard]] std::size_t bits() const;       // size of all coefficients

 private:
  struct Function;
  explicit Parametric(std::shared_ptr<const Function> function);  // never null; collapses to a number where it is one
  [[nodiscard]] bool equals(const Parametric&) const;
  template <class T>
  [[nodiscard]] T value_at(const std::map<std::string, T>& values) const;
  friend Parametric pow(const Parametric&, int exponent);

  std::shared_ptr<const Function> function_;  // null: the number constant_; otherwise not a number
  Rational constant_;
};

Parametric pow(const Parametric& base, int exponent);  // E_DIV0 for 0 to a negative power
/// Of constants only: as for Rational; otherwise Error{not_exact}, E_UNDECIDED for abs and E_NOT_EXACT for sqrt.
Parametric abs(const Parametric&);
Parametric sqrt(const Parametric&);
std::ostream& operator<<(std::ostream&, const Parametric&);

}  // namespace udcp
