// Arithmetic of reduced fractions of polynomials. Sums and products take common divisors of the parts that can have one only
// (Henrici), so that denominators such as (1 + f)^k stay as small as they are.
#include "operators/numbers/parametric.h"

#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <ostream>

#include "operators/error.h"
#include "operators/numbers/algebraic.h"
#include "operators/numbers/interval.h"
#include "operators/numbers/parametric_polynomial.h"

namespace udcp {

struct Parametric::Function {
  ParametricPolynomial numerator, denominator;
};

namespace {

using Polynomial = ParametricPolynomial;

[[noreturn]] void division_by_zero() {
  throw Error(ErrorKind::input, "E_DIV0", "division by zero among formulas in free parameters", "check the denominator");
}

std::string shorten(const std::string& text) { return text.size() <= 80 ? text : text.substr(0, 77) + "..."; }

Polynomial without(const Polynomial& p, const Polynomial& divisor) {
  return divisor == Polynomial(Rational(1)) ? p : divide_exactly(p, divisor).value();
}

std::size_t bits_of(const Polynomial& p) {
  std::size_t bits = 0;
  for (const Polynomial::Term& term : p.terms) bits += term.coefficient.bits();
  return bits;
}

Polynomial power(const Polynomial& base, int exponent) {
  Polynomial result(Rational(1));
  for (int k = 0; k < exponent; ++k) result = result * base;
  return result;
}

/// "x", or "(x + y)" where a product or quotient needs it.
std::string as_factor(const Polynomial& p, bool as_divisor) {
  const bool product =
      p.terms.size() == 1 && !p.is_constant() && (p.names.size() > 1 || p.terms.front().coefficient != Rational(1));
  return p.terms.size() > 1 || (product && as_divisor) ? "(" + p.to_string() + ")" : p.to_string();
}

}  // namespace

// ---- making values

Parametric::Parametric() = default;
Parametric::Parametric(const Parametric&) = default;
Parametric::Parametric(Parametric&&) noexcept = default;
Parametric& Parametric::operator=(const Parametric&) = default;
Parametric& Parametric::operator=(Parametric&&) noexcept = default;
Parametric::~Parametric() = default;
Parametric::Parametric(int value) : constant_(value) {}
Parametric::Parametric(const Rational& value) : constant_(value) {}

Parametric::Parametric(std::shared_ptr<const Function> function) {
  if (function->numerator.is_constant() && function->denominator.is_constant()) {
    constant_ = function->numerator.constant() / function->denominator.constant();
  } else {
    function_ = std::move(function);
  }
}

Parametric Parametric::variable(const std::string& name) {
  const auto allowed = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; };
  const bool good = !name.empty() && name.size() <= 60 && allowed(name.front()) &&
                    std::all_of(name.begin(), name.end(), [&](char c) { return allowed(c) || (c >= '0' && c <= '9'); });
  if (!good)
    throw Error(ErrorKind::input, "E_NAME", "'" + shorten(name) + "' is no name for a parameter",
                "use at most 60 letters, digits and _, without a digit in front");
  return Parametric(std::make_shared<const Function>(Function{Polynomial::variable(name), Rational(1)}));
}

Parametric Parametric::quotient(const Polynomial& p, const Polynomial& q) {
  if (q.is_zero()) division_by_zero();
  if (p.is_zero()) return {};
  const Rational scale = content(p) / content(q);
  Polynomial numerator = p * Polynomial(scale.numerator() / content(p));
  Polynomial denominator = q * Polynomial(scale.denominator() / content(q));
  const Polynomial divisor = gcd(numerator, denominator);
  numerator = without(numerator, divisor);
  denominator = without(denominator, divisor);
  if (denominator.terms.front().coefficient.sign() < 0) {
    numerator = Polynomial() - numerator;
    denominator = Polynomial() - denominator;
  }
  return Parametric(std::make_shared<const Function>(Function{std::move(numerator), std::move(denominator)}));
}

Polynomial Parametric::numerator() const { return function_ ? function_->numerator : Polynomial(constant_.numerator()); }
Polynomial Parametric::denominator() const { return function_ ? function_->denominator : Polynomial(constant_.denominator()); }

Rational Parametric::constant() const {
  if (!function_) return constant_;
  throw Error(ErrorKind::not_exact, "E_NOT_EXACT", shorten(to_string()) + " is a formula in free parameters, not a number",
              "give its parameters values");
}

std::vector<std::string> Parametric::variables() const {
  if (!function_) return {};
  std::vector<std::string> result;
  const auto &left = function_->numerator.names, &right = function_->denominator.names;
  std::set_union(left.begin(), left.end(), right.begin(), right.end(), std::back_inserter(result));
  return result;
}

// ---- arithmetic

Parametric& Parametric::operator+=(const Parametric& other) {
  if (!function_ && !other.function_) {
    constant_ += other.constant_;
    return *this;
  }
  if (other.is_zero()) return *this;
  if (is_zero()) return *this = other;
  const Polynomial denominator = this->denominator(), other_denominator = other.denominator();
  const Polynomial common = denominator == other_denominator ? denominator : gcd(denominator, other_denominator);
  const Polynomial mine = without(denominator, common), others = without(other_denominator, common);
  const Polynomial sum = numerator() * others + other.numerator() * mine;
  if (sum.is_zero()) return *this = Parametric();
  const Polynomial divisor = gcd(sum, common);  // all that the sum can have in common with the product of the denominators
  return *this = Parametric(
             std::make_shared<const Function>(Function{without(sum, divisor), without(common, divisor) * mine * others}));
}

Parametric& Parametric::operator-=(const Parametric& other) {
  if (other.is_zero()) return *this;
  return *this += -other;
}

Parametric& Parametric::operator*=(const Parametric& other) {
  if (!function_ && !other.function_) {
    constant_ *= other.constant_;
    return *this;
  }
  if (is_zero() || other == Parametric(1)) return *this;
  if (other.is_zero() || *this == Parametric(1)) return *this = other;
  const Polynomial p = numerator(), q = denominator(), r = other.numerator(), s = other.denominator();
  const Polynomial first = gcd(p, s), second = gcd(r, q);
  return *this = Parametric(std::make_shared<const Function>(
             Function{without(p, first) * without(r, second), without(q, second) * without(s, first)}));
}

Parametric& Parametric::operator/=(const Parametric& other) {
  if (other.is_zero()) division_by_zero();
  if (!other.function_) return *this *= Parametric(Rational(1) / other.constant_);
  Function inverse{other.function_->denominator, other.function_->numerator};
  if (inverse.denominator.terms.front().coefficient.sign() < 0) {
    inverse.numerator = Polynomial() - inverse.numerator;
    inverse.denominator = Polynomial() - inverse.denominator;
  }
  return *this *= Parametric(std::make_shared<const Function>(std::move(inverse)));
}

Parametric Parametric::operator-() const {
  if (!function_) return -constant_;
  return Parametric(std::make_shared<const Function>(Function{Polynomial() - function_->numerator, function_->denominator}));
}

bool Parametric::equals(const Parametric& other) const {
  if (function_ == other.function_) return constant_ == other.constant_;
  return function_ && other.function_ && function_->numerator == other.function_->numerator &&
         function_->denominator == other.function_->denominator;
}

int Parametric::compare(const Parametric& other) const {
  const Parametric difference = *this - other;
  if (difference.is_constant()) return difference.constant_.sign();
  throw Error(ErrorKind::not_exact, "E_UNDECIDED",
              "the sign of " + shorten(difference.to_string()) + " depends on its parameters",
              "give the parameters values, or write the formula without the comparison");
}

// ---- values and functions

template <class T>
T Parametric::value_at(const std::map<std::string, T>& values) const {
  if (!function_) return T(constant_);
  const T divisor = function_->denominator.at(values);
  if (divisor == T(0)) division_by_zero();
  return function_->numerator.at(values) / divisor;
}

Rational Parametric::at(const std::map<std::string, Rational>& values) const { return value_at(values); }
Algebraic Parametric::at(const std::map<std::string, Algebraic>& values) const { return value_at(values); }
Interval Parametric::at(const std::map<std::string, Interval>& values) const { return value_at(values); }

Parametric Parametric::substitute(const std::string& name, const Parametric& value) const {
  std::map<std::string, Parametric> values;
  for (const std::string& other : variables()) values.emplace(other, other == name ? value : variable(other));
  return value_at(values);
}

Parametric Parametric::derivative(const std::string& name) const {
  if (!function_) return {};
  const auto& [p, q] = *function_;
  return quotient(p.derivative(name) * q - p * q.derivative(name), q * q);
}

double Parametric::to_double() const { return constant().to_double(); }

std::string Parametric::to_string() const {
  if (!function_) return constant_.to_string();
  const auto& [p, q] = *function_;
  if (q == Polynomial(Rational(1))) return p.to_string();
  return as_factor(p, false) + "/" + as_factor(q, true);
}

std::size_t Parametric::bits() const {
  return function_ ? bits_of(function_->numerator) + bits_of(function_->denominator) : constant_.bits();
}

Parametric pow(const Parametric& base, int exponent) {
  if (base.is_constant()) return pow(base.constant_, exponent);
  const auto& [p, q] = *base.function_;
  const long long size = std::llabs(exponent);
  if (std::max(p.degree(), q.degree()) * size > Polynomial::largest_degree)
    throw Error(ErrorKind::limit, "E_PARAMETRIC_SIZE",
                "a power of " + shorten(base.to_string()) + " has a degree above " + std::to_string(Polynomial::largest_degree),
                "use a smaller exponent");
  const Parametric result(std::make_shared<const Parametric::Function>(
      Parametric::Function{power(p, static_cast<int>(size)), power(q, static_cast<int>(size))}));
  return exponent < 0 ? Parametric(1) / result : result;
}

Parametric abs(const Parametric& x) { return x.compare(Parametric()) < 0 ? -x : x; }

Parametric sqrt(const Parametric& x) {
  if (x.is_constant()) return sqrt(x.constant());
  throw Error(ErrorKind::not_exact, "E_NOT_EXACT",
              "sqrt(" + shorten(x.to_string()) + ") is no rational function of its parameters", "give the parameters values");
}

std::ostream& operator<<(std::ostream& out, const Parametric& value) { return out << value.to_string(); }

}  // namespace udcp
