// Sparse arithmetic on sorted terms, and the common divisor by evaluation at large integers (the heuristic GCD of Char, Geddes
// and Gonnet): a candidate is read from the digits of an integer and accepted only after it has divided both polynomials.
#include "operators/numbers/parametric_polynomial.h"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <utility>

#include "operators/error.h"
#include "operators/numbers/algebraic.h"
#include "operators/numbers/interval.h"
#include "operators/numbers/parametric.h"

namespace udcp {
namespace {

using Term = ParametricPolynomial::Term;
using Exponents = ParametricPolynomial::Exponents;
using Terms = std::vector<Term>;  // sorted, for names agreed on elsewhere

constexpr std::size_t kVariables = ParametricPolynomial::most_names;

[[noreturn]] void too_large(const std::string& what) {
  throw Error(ErrorKind::limit, "E_PARAMETRIC_SIZE", "a formula in free parameters has " + what,
              "give some of the parameters values, or use a shorter word");
}

[[noreturn]] void too_many_terms() { too_large("more than " + std::to_string(ParametricPolynomial::most_terms) + " terms"); }

int total(const Exponents& e) { return std::accumulate(e.begin(), e.end(), 0); }

struct Before {  // the order of terms
  bool operator()(const Exponents& a, const Exponents& b) const {
    const int left = total(a), right = total(b);
    return left != right ? left > right : a > b;
  }
};
using Sum = std::map<Exponents, Rational, Before>;

void accumulate(Sum& sum, const Exponents& exponents, const Rational& value) {
  const auto [place, is_new] = sum.try_emplace(exponents, value);
  if (is_new) return;
  place->second += value;
  if (place->second.is_zero()) sum.erase(place);
}

Terms terms_of(Sum&& sum) {
  if (sum.size() > ParametricPolynomial::most_terms) too_many_terms();
  Terms result;
  result.reserve(sum.size());
  for (auto& [exponents, coefficient] : sum) result.push_back({exponents, std::move(coefficient)});
  return result;
}

int degree_in(const Terms& p, std::size_t variable) {
  int degree = 0;
  for (const Term& term : p) degree = std::max(degree, static_cast<int>(term.exponents[variable]));
  return degree;
}

Exponents product(const Exponents& a, const Exponents& b) {
  Exponents result;
  for (std::size_t k = 0; k < kVariables; ++k) result[k] = static_cast<std::uint8_t>(a[k] + b[k]);
  return result;
}

std::optional<Exponents> quotient(const Exponents& a, const Exponents& b) {
  Exponents result;
  for (std::size_t k = 0; k < kVariables; ++k) {
    if (a[k] < b[k]) return std::nullopt;
    result[k] = static_cast<std::uint8_t>(a[k] - b[k]);
  }
  return result;
}

Terms add(const Terms& a, const Terms& b, const Rational& factor) {
  Terms result;
  std::size_t i = 0, j = 0;
  const Before before;
  while (i < a.size() || j < b.size()) {
    if (j == b.size() || (i < a.size() && before(a[i].exponents, b[j].exponents))) {
      result.push_back(a[i++]);
    } else if (i == a.size() || before(b[j].exponents, a[i].exponents)) {
      result.push_back({b[j].exponents, factor * b[j].coefficient});
      ++j;
    } else {
      Rational sum = a[i].coefficient + factor * b[j].coefficient;
      if (!sum.is_zero()) result.push_back({a[i].exponents, std::move(sum)});
      ++i, ++j;
    }
  }
  if (result.size() > ParametricPolynomial::most_terms) too_many_terms();
  return result;
}

Terms multiply(const Terms& a, const Terms& b) {
  if (a.empty() || b.empty()) return {};
  if (total(a.front().exponents) + total(b.front().exponents) > ParametricPolynomial::largest_degree)
    too_large("a degree above " + std::to_string(ParametricPolynomial::largest_degree));
  Sum sum;
  for (const Term& left : a) {
    for (const Term& right : b) accumulate(sum, product(left.exponents, right.exponents), left.coefficient * right.coefficient);
    if (sum.size() > 10 * ParametricPolynomial::most_terms) too_many_terms();  // few of them can cancel
  }
  return terms_of(std::move(sum));
}

// Fails at the first leading term that b's does not divide.
std::optional<Terms> divide(const Terms& a, const Terms& b) {
  for (std::size_t k = 0; k < kVariables; ++k)
    if (degree_in(a, k) < degree_in(b, k) && !a.empty()) return std::nullopt;
  Sum rest;
  for (const Term& term : a) rest.emplace(term.exponents, term.coefficient);
  Terms result;
  while (!rest.empty()) {
    const std::optional<Exponents> exponents = quotient(rest.begin()->first, b.front().exponents);
    if (!exponents) return std::nullopt;
    if (result.size() == ParametricPolynomial::most_terms) too_many_terms();
    const Rational factor = rest.begin()->second / b.front().coefficient;
    for (const Term& term : b) accumulate(rest, product(*exponents, term.exponents), -factor * term.coefficient);
    result.push_back({*exponents, factor});
  }
  return result;
}

// ---- the greatest common divisor, on integer coefficients

Rational gcd(const Rational& a, const Rational& b) {
  if (a.is_zero() || b.is_zero()) return abs(a + b);
  return abs(a / (a / b).numerator());
}

Rational integer_content(const Terms& p) {
  Rational result;
  for (const Term& term : p) {
    result = gcd(result, term.coefficient);
    if (result == Rational(1)) break;
  }
  return result;
}

Terms scaled(Terms p, const Rational& factor) {
  for (Term& term : p) term.coefficient *= factor;
  return p;
}

/// Coprime integers, the leading one positive.
Terms primitive(Terms p) {
  if (p.empty()) return p;
  const Rational content = integer_content(p);
  const Rational divisor = p.front().coefficient.sign() < 0 ? -content : content;
  return divisor == Rational(1) ? p : scaled(std::move(p), Rational(1) / divisor);
}

/// p as a polynomial in one variable: its coefficients, lowest first.
std::vector<Terms> coefficients_in(const Terms& p, std::size_t variable) {
  std::vector<Terms> result(static_cast<std::size_t>(degree_in(p, variable)) + 1);
  for (Term term : p) {
    const std::size_t power = std::exchange(term.exponents[variable], std::uint8_t{0});
    result[power].push_back(std::move(term));
  }
  return result;  // the order among terms of one power is that of p
}

Terms evaluated(const Terms& p, std::size_t variable, const Rational& x) {
  Terms result;
  const std::vector<Terms> coefficients = coefficients_in(p, variable);
  for (std::size_t k = coefficients.size(); k-- > 0;) result = add(coefficients[k], result, x);
  return result;
}

/// The polynomial of degree at most `degree` in the variable whose value at x is `value` and whose coefficients are at most x/2.
std::optional<Terms> from_digits(Terms value, std::size_t variable, const Rational& x, int degree) {
  Sum sum;
  for (int power = 0; !value.empty(); ++power) {
    if (power > degree) return std::nullopt;
    Terms rest;
    for (const Term& term : value) {
      Rational higher = (term.coefficient / x + Rational(1) / Rational(2)).floor();
      Exponents exponents = term.exponents;
      exponents[variable] = static_cast<std::uint8_t>(power);
      const Rational digit = term.coefficient - higher * x;
      if (!digit.is_zero()) accumulate(sum, exponents, digit);
      if (!higher.is_zero()) rest.push_back({term.exponents, std::move(higher)});
    }
    value = std::move(rest);
  }
  return terms_of(std::move(sum));
}

Terms common_divisor(const Terms& a, const Terms& b);

Terms common_divisor_by_evaluation(const Terms& a, const Terms& b, std::size_t variable) {
  const auto largest = [](const Terms& p) {
    Rational result;
    for (const Term& term : p) result = std::max(result, abs(term.coefficient));
    return result;
  };
  const int degree = std::min(degree_in(a, variable), degree_in(b, variable));
  const int highest = std::max(degree_in(a, variable), degree_in(b, variable));
  Rational x = Rational(2) * std::min(largest(a), largest(b)) + Rational(29);
  for (int attempt = 0; attempt < 40 && x.bits() * static_cast<std::size_t>(highest) < 1'000'000; ++attempt) {
    const Terms value = common_divisor(evaluated(a, variable, x), evaluated(b, variable, x));
    if (std::optional<Terms> candidate = from_digits(value, variable, x, degree)) {
      Terms result = primitive(std::move(*candidate));
      if (divide(a, result) && divide(b, result)) return result;
    }
    x = (x * Rational(73794) / Rational(27011)).floor();  // no simple ratio, so that unlucky factors do not come back
  }
  too_large("numbers too large for a common divisor");
}

Terms common_divisor(const Terms& a, const Terms& b) {
  if (a.empty()) return b.empty() || b.front().coefficient.sign() > 0 ? b : scaled(b, Rational(-1));
  if (b.empty()) return common_divisor(b, a);
  const Rational content = gcd(integer_content(a), integer_content(b));
  for (std::size_t k = kVariables; k-- > 0;) {
    const int left = degree_in(a, k), right = degree_in(b, k);
    if (left == 0 && right == 0) continue;
    if (left > 0 && right > 0) return scaled(common_divisor_by_evaluation(primitive(a), primitive(b), k), content);
    Terms result = left == 0 ? a : b;  // the variable of one side only: a divisor of every coefficient there
    for (const Terms& coefficient : coefficients_in(left == 0 ? b : a, k)) {
      if (!coefficient.empty()) result = common_divisor(result, coefficient);
    }
    return result;
  }
  return {{Exponents{}, content}};
}

// ---- names

/// The terms of p for a longer list of names.
Terms spread(const ParametricPolynomial& p, const std::vector<std::string>& names) {
  if (p.names == names) return p.terms;
  Terms result = p.terms;
  for (Term& term : result) {
    Exponents moved{};
    for (std::size_t k = 0; k < p.names.size(); ++k) {
      const auto place = std::lower_bound(names.begin(), names.end(), p.names[k]) - names.begin();
      moved[static_cast<std::size_t>(place)] = term.exponents[k];
    }
    term.exponents = moved;
  }
  return result;  // still in order: the names keep theirs
}

std::vector<std::string> joined_names(const ParametricPolynomial& a, const ParametricPolynomial& b) {
  if (a.names == b.names) return a.names;
  std::vector<std::string> names;
  std::set_union(a.names.begin(), a.names.end(), b.names.begin(), b.names.end(), std::back_inserter(names));
  if (names.size() > kVariables) too_large("more than " + std::to_string(kVariables) + " parameters");
  return names;
}

/// Drops the names that no term has.
ParametricPolynomial with_names(Terms terms, const std::vector<std::string>& names) {
  std::vector<std::size_t> used;
  for (std::size_t k = 0; k < names.size(); ++k)
    if (degree_in(terms, k) > 0) used.push_back(k);
  ParametricPolynomial result;
  for (const std::size_t k : used) result.names.push_back(names[k]);
  if (used.size() < names.size()) {
    for (Term& term : terms) {
      Exponents moved{};
      for (std::size_t k = 0; k < used.size(); ++k) moved[k] = term.exponents[used[k]];
      term.exponents = moved;
    }
  }
  result.terms = std::move(terms);
  return result;
}

template <class Operation>
ParametricPolynomial combine(const ParametricPolynomial& a, const ParametricPolynomial& b, Operation operation) {
  const std::vector<std::string> names = joined_names(a, b);
  return with_names(operation(spread(a, names), spread(b, names)), names);
}

}  // namespace

ParametricPolynomial::ParametricPolynomial(const Rational& value) {
  if (!value.is_zero()) terms.push_back({Exponents{}, value});
}

ParametricPolynomial ParametricPolynomial::variable(std::string name) {
  ParametricPolynomial result;
  result.names.push_back(std::move(name));
  result.terms.push_back({Exponents{1}, Rational(1)});
  return result;
}

Rational ParametricPolynomial::constant() const {
  return !terms.empty() && total(terms.back().exponents) == 0 ? terms.back().coefficient : Rational(0);
}

int ParametricPolynomial::degree() const { return terms.empty() ? -1 : total(terms.front().exponents); }

int ParametricPolynomial::degree(const std::string& name) const {
  if (terms.empty()) return -1;
  const auto found = std::find(names.begin(), names.end(), name);
  return found == names.end() ? 0 : degree_in(terms, static_cast<std::size_t>(found - names.begin()));
}

ParametricPolynomial ParametricPolynomial::derivative(const std::string& name) const {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) return {};
  const auto k = static_cast<std::size_t>(found - names.begin());
  Sum sum;
  for (Term term : terms) {
    const int power = term.exponents[k];
    if (power == 0) continue;
    --term.exponents[k];
    sum.emplace(term.exponents, term.coefficient * Rational(power));
  }
  return with_names(terms_of(std::move(sum)), names);
}

template <class T>
T ParametricPolynomial::at(const std::map<std::string, T>& values) const {
  std::vector<const T*> points;
  for (const std::string& name : names) {
    const auto found = values.find(name);
    if (found == values.end())
      throw Error(ErrorKind::input, "E_NAME", "the parameter '" + name + "' has no value", "give a value to every parameter");
    points.push_back(&found->second);
  }
  T result(0);
  for (const Term& term : terms) {
    T product(term.coefficient);
    for (std::size_t k = 0; k < points.size(); ++k)
      if (term.exponents[k] > 0) product *= pow(*points[k], term.exponents[k]);
    result += product;
  }
  return result;
}

std::string ParametricPolynomial::to_string() const {
  std::string text;
  for (const Term& term : terms) {
    std::string factors;
    for (std::size_t k = 0; k < names.size(); ++k) {
      if (term.exponents[k] == 0) continue;
      factors.append(factors.empty() ? "" : "*").append(names[k]);
      if (term.exponents[k] > 1) factors.append("^").append(std::to_string(term.exponents[k]));
    }
    const bool negative = term.coefficient.sign() < 0;
    text.append(text.empty() ? (negative ? "-" : "") : (negative ? " - " : " + "));
    const Rational size = abs(term.coefficient);
    if (factors.empty() || size != Rational(1)) text.append(size.to_string()).append(factors.empty() ? "" : "*");
    text.append(factors);
  }
  return text.empty() ? "0" : text;
}

ParametricPolynomial operator+(const ParametricPolynomial& a, const ParametricPolynomial& b) {
  return combine(a, b, [](const Terms& x, const Terms& y) { return add(x, y, Rational(1)); });
}

ParametricPolynomial operator-(const ParametricPolynomial& a, const ParametricPolynomial& b) {
  return combine(a, b, [](const Terms& x, const Terms& y) { return add(x, y, Rational(-1)); });
}

ParametricPolynomial operator*(const ParametricPolynomial& a, const ParametricPolynomial& b) { return combine(a, b, multiply); }

std::optional<ParametricPolynomial> divide_exactly(const ParametricPolynomial& a, const ParametricPolynomial& b) {
  if (b.is_zero()) throw Error(ErrorKind::input, "E_DIV0", "division of a polynomial by zero");
  const std::vector<std::string> names = joined_names(a, b);
  std::optional<Terms> result = divide(spread(a, names), spread(b, names));
  if (!result) return std::nullopt;
  return with_names(std::move(*result), names);
}

ParametricPolynomial gcd(const ParametricPolynomial& a, const ParametricPolynomial& b) { return combine(a, b, common_divisor); }

Rational content(const ParametricPolynomial& p) {
  if (p.is_zero()) return 1;
  Rational numerators, denominators(1);
  for (const Term& term : p.terms) {
    numerators = gcd(numerators, term.coefficient.numerator());
    const Rational next = term.coefficient.denominator();
    denominators *= next / gcd(denominators, next);
  }
  return numerators / denominators;
}

template Rational ParametricPolynomial::at(const std::map<std::string, Rational>&) const;
template Algebraic ParametricPolynomial::at(const std::map<std::string, Algebraic>&) const;
template Interval ParametricPolynomial::at(const std::map<std::string, Interval>&) const;
template Parametric ParametricPolynomial::at(const std::map<std::string, Parametric>&) const;

}  // namespace udcp
