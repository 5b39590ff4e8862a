// Exact polynomials: identities of division, factors put together again, roots that were put in.
#include "proofs/polynomial.h"

#include <doctest/doctest.h>

#include "tests/oracle/inputs.h"
#include "tests/oracle/refusal.h"

using namespace udcp;
using oracle::Dice;

namespace {

Rational ratio(int p, int q) { return Rational(p) / Rational(q); }

template <class S>
S random_number(Dice& dice);
template <>
Rational random_number<Rational>(Dice& dice) {
  return dice.fraction();
}
template <>
Algebraic random_number<Algebraic>(Dice& dice) {
  return Algebraic(dice.fraction()) + Algebraic(dice.between(-2, 2)) * Algebraic::cosine(ratio(2, 5));
}

template <class S>
Polynomial<S> random_polynomial(Dice& dice, int degree) {
  std::vector<S> c;
  for (int k = 0; k <= degree; ++k) c.push_back(random_number<S>(dice));
  return Polynomial<S>(c);
}

template <class S>
Polynomial<S> linear(const S& root) {
  return Polynomial<S>({S(-root), S(1)});
}

}  // namespace

TEST_SUITE_BEGIN("proofs");

TEST_CASE("the top coefficient of a polynomial is not zero") {
  CHECK(Polynomial<Rational>({1, 2, 0, 0}).degree() == 1);
  CHECK(Polynomial<Rational>({0, 0}).is_zero());
  CHECK(Polynomial<Rational>().degree() == -1);
  const Polynomial<Rational> p({1, 2});
  CHECK((p - p).is_zero());
  CHECK(Polynomial<Rational>::monomial(ratio(1, 2), 3) == Polynomial<Rational>({0, 0, 0, ratio(1, 2)}));
}

TEST_CASE_TEMPLATE("quotient times divisor plus remainder is the dividend", S, Rational, Algebraic) {
  Dice dice(1);
  for (int k = 0; k < 20; ++k) {
    const auto a = random_polynomial<S>(dice, dice.below(7)), b = random_polynomial<S>(dice, dice.below(5));
    if (b.is_zero()) continue;
    const auto [quotient, rest] = divide(a, b);
    CHECK(quotient * b + rest == a);
    CHECK(rest.degree() < b.degree());
  }
  CHECK(oracle::refusal([] { (void)divide(Polynomial<S>({S(1)}), Polynomial<S>()); }) ==
        "E_DIV0: division of a polynomial by the zero polynomial");
}

TEST_CASE_TEMPLATE("a common factor that was put in is the greatest common divisor", S, Rational, Algebraic) {
  Dice dice(2);
  const auto common = linear(S(3)) * linear(S(ratio(1, 2))), a = common * linear(S(1)), b = common * linear(S(-7)) * linear(S(2));
  CHECK(gcd(a, b) == common);
  CHECK(gcd(a, Polynomial<S>()) == a);
  CHECK(gcd(Polynomial<S>(), Polynomial<S>()).is_zero());
  const auto p = random_polynomial<S>(dice, 3), q = random_polynomial<S>(dice, 2), r = random_polynomial<S>(dice, 3);
  const auto g = gcd(p * q, r * q);
  CHECK(divide(g, q).second.is_zero());
  CHECK(divide(p * q, g).second.is_zero());
}

TEST_CASE("square-free factors keep their multiplicities") {
  const auto x = Polynomial<Rational>({0, 1}), one = linear(Rational(1)), quadratic = Polynomial<Rational>({-2, 0, 1});
  const auto p = Polynomial<Rational>({5}) * x * one * one * one * quadratic * quadratic * quadratic;
  const auto factors = square_free_factors(p);
  REQUIRE(factors.size() == 2);
  CHECK(factors[0] == std::pair{x, 1});
  CHECK(factors[1] == std::pair{one * quadratic, 3});
  CHECK(square_free_factors(Polynomial<Rational>({7})).empty());
}

TEST_CASE("every real root is found once with its multiplicity") {
  Dice dice(3);
  for (int round = 0; round < 10; ++round) {
    std::map<Rational, int> roots;
    auto p = Polynomial<Rational>({2, 1, 1});  // no real root
    for (int k = 0; k < 4; ++k) {
      const Rational root = dice.fraction();
      const int multiplicity = dice.between(1, 3);
      roots[root] += multiplicity;
      for (int m = 0; m < multiplicity; ++m) p = p * linear(root);
    }
    const auto found = real_roots(p, ratio(1, 1000));
    REQUIRE(found.size() == roots.size());
    std::size_t k = 0;
    for (const auto& [root, multiplicity] : roots) {
      CHECK(found[k].lower <= root);
      CHECK(found[k].upper >= root);
      CHECK(found[k].upper - found[k].lower <= ratio(1, 1000));
      CHECK(found[k].multiplicity == multiplicity);
      if (k > 0) CHECK(found[k].lower > found[k - 1].upper);
      ++k;
    }
  }
}

TEST_CASE("roots between rationals have opposite signs at their ends") {
  const auto p = Polynomial<Rational>({-1, 4, 0, 32});  // the C1 bound of the four-point family, 0.19273 rounded
  const auto roots = real_roots(p, ratio(1, 1'000'000));
  REQUIRE(roots.size() == 1);
  CHECK(p.at(roots[0].lower).sign() * p.at(roots[0].upper).sign() < 0);
  CHECK(roots[0].lower > ratio(19272, 100000));
  CHECK(roots[0].upper < ratio(19274, 100000));
  CHECK(p.at(Interval(roots[0].lower, roots[0].upper)).contains_zero());
  CHECK_FALSE(p.at(Interval(ratio(1, 5))).contains_zero());
}

TEST_CASE("a dyadic root is found exactly") {
  const auto roots = real_roots(linear(ratio(3, 8)) * linear(ratio(1, 3)), ratio(1, 100));
  REQUIRE(roots.size() == 2);
  CHECK(roots[1].lower == ratio(3, 8));
  CHECK(roots[1].upper == ratio(3, 8));
}

TEST_CASE("roots of a polynomial with irrational coefficients") {
  const Algebraic root_two = sqrt(Algebraic(2));
  const auto p = linear(root_two) * linear(root_two) * linear(Algebraic(ratio(3, 2)));
  const auto roots = real_roots(p, ratio(1, 10000));
  REQUIRE(roots.size() == 2);
  CHECK(Algebraic(roots[0].lower) < root_two);
  CHECK(Algebraic(roots[0].upper) > root_two);
  CHECK(roots[0].multiplicity == 2);
  CHECK(roots[1].multiplicity == 1);
  CHECK(real_roots(Polynomial<Algebraic>({Algebraic(2), Algebraic(), Algebraic(1)}), ratio(1, 2)).empty());
}

TEST_CASE("the Chebyshev polynomial of degree 12 has twelve roots inside (-1 and 1)") {
  Polynomial<Rational> before({1}), now({0, 1});
  for (int k = 1; k < 12; ++k) before = std::exchange(now, Polynomial<Rational>({0, 2}) * now - before);
  const auto roots = real_roots(now, ratio(1, 1000));
  REQUIRE(roots.size() == 12);
  for (std::size_t k = 0; k < 12; ++k) {
    const Algebraic expected = Algebraic::cosine(ratio(23 - 2 * static_cast<int>(k), 24));
    CHECK(Algebraic(roots[k].lower) <= expected);
    CHECK(Algebraic(roots[k].upper) >= expected);
  }
}

TEST_SUITE_END();
