// Polynomials with rational coefficients in a few named parameters: the numerators and denominators of Parametric.
// Sparse terms in one fixed order, so that equal polynomials are equal member by member.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "operators/numbers/rational.h"

namespace udcp {

struct ParametricPolynomial {
  static constexpr int largest_degree = 200;  // total degree
  static constexpr int most_terms = 2000;
  static constexpr int most_names = 6;
  using Exponents = std::array<std::uint8_t, most_names>;

  struct Term {
    Exponents exponents{};  // of names[0], names[1], ...; 0 beyond them
    Rational coefficient;   // not 0
    friend bool operator==(const Term&, const Term&) = default;
  };

  std::vector<std::string> names;  // sorted; every one of them occurs in a term
  std::vector<Term> terms;         // the higher total degree first, among equals the higher power of the earlier name

  ParametricPolynomial() = default;             // 0
  ParametricPolynomial(const Rational& value);  // NOLINT: numbers convert
  static ParametricPolynomial variable(std::string name);

  [[nodiscard]] bool is_zero() const { return terms.empty(); }
  [[nodiscard]] bool is_constant() const { return names.empty(); }
  [[nodiscard]] Rational constant() const;                  // the term without names
  [[nodiscard]] int degree() const;                         // total degree; -1 for 0
  [[nodiscard]] int degree(const std::string& name) const;  // 0 for a name that does not occur; -1 for 0
  [[nodiscard]] ParametricPolynomial derivative(const std::string& name) const;
  /// The value at numbers of the parameters, T = Rational, Algebraic, Interval (encloses) or Parametric. Error{input, "E_NAME"}
  /// if a name has no value.
  template <class T>
  [[nodiscard]] T at(const std::map<std::string, T>& values) const;
  [[nodiscard]] std::string to_string() const;  // "3*delta*omega + 4", as the language reads it
  friend bool operator==(const ParametricPolynomial&, const ParametricPolynomial&) = default;
};

// Error{limit, "E_PARAMETRIC_SIZE"} past the sizes above.
ParametricPolynomial operator+(const ParametricPolynomial& a, const ParametricPolynomial& b);
ParametricPolynomial operator-(const ParametricPolynomial& a, const ParametricPolynomial& b);
ParametricPolynomial operator*(const ParametricPolynomial& a, const ParametricPolynomial& b);
/// a / b where it is a polynomial. Error{input, "E_DIV0"} for b = 0.
std::optional<ParametricPolynomial> divide_exactly(const ParametricPolynomial& a, const ParametricPolynomial& b);
/// The greatest common divisor over the integers, with a positive leading coefficient; all coefficients have to be integers.
ParametricPolynomial gcd(const ParametricPolynomial& a, const ParametricPolynomial& b);
/// The positive number whose quotient has coprime integers as coefficients; 1 for the polynomial 0.
Rational content(const ParametricPolynomial& p);

}  // namespace udcp
