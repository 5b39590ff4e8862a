// Signs of polynomials on boxes that may be open or infinite.
#include <doctest/doctest.h>

#include <random>

#include "proofs/bernstein.h"

using namespace udcp;

namespace {

Rational ratio(int p, int q) { return Rational(p) / Rational(q); }

BoxPolynomial random_polynomial(std::mt19937& random, const std::vector<int>& degrees) {
  std::size_t size = 1;
  for (const int d : degrees) size *= static_cast<std::size_t>(d) + 1;
  BoxPolynomial p{degrees, {}};
  for (std::size_t k = 0; k < size; ++k)
    p.coefficients.push_back(ratio(static_cast<int>(random() % 19) - 9, 1 + static_cast<int>(random() % 5)));
  return p;
}

}  // namespace

TEST_SUITE_BEGIN("proofs");

TEST_CASE("products and sums of box polynomials agree with their values") {
  std::mt19937 random(1);
  for (int n = 0; n < 50; ++n) {
    const BoxPolynomial a = random_polynomial(random, {2, 1}), b = random_polynomial(random, {1, 3});
    const std::vector<Rational> x{ratio(static_cast<int>(random() % 9) - 4, 3), ratio(static_cast<int>(random() % 9) - 4, 5)};
    CHECK((a * b).at(x) == a.at(x) * b.at(x));
    CHECK((a + b).at(x) == a.at(x) + b.at(x));
    CHECK((a - b).at(x) == a.at(x) - b.at(x));
  }
}

TEST_CASE("x^2 - x + 1/4 + e is positive on [0 1] and x^2 - x + 1/4 is not") {
  // (x - 1/2)^2 has a zero inside, however small the cell around it.
  const std::vector<Side> unit{{Rational(0), Rational(1), false, false}};
  CHECK_FALSE(positive_on({{2}, {ratio(1, 4), Rational(-1), Rational(1)}}, unit));
  const std::vector<Side> near{{ratio(49, 100), ratio(51, 100), false, false}};
  CHECK_FALSE(positive_on({{2}, {ratio(1, 4), Rational(-1), Rational(1)}}, near));
  CHECK(positive_on({{2}, {ratio(1, 4) + ratio(1, 100), Rational(-1), Rational(1)}}, near));
}

TEST_CASE("a polynomial that vanishes at an end is positive only if the end is left out") {
  const BoxPolynomial x{{1}, {Rational(0), Rational(1)}};
  CHECK(positive_on(x, {{Rational(0), Rational(1), true, false}}));
  CHECK_FALSE(positive_on(x, {{Rational(0), Rational(1), false, false}}));
  // x y on (0, 1] x [0, 1]: zero on the side y = 0, which belongs to the box
  const BoxPolynomial xy{{1, 1}, {Rational(0), Rational(0), Rational(0), Rational(1)}};
  CHECK_FALSE(positive_on(xy, {{Rational(0), Rational(1), true, false}, {Rational(0), Rational(1), false, false}}));
  CHECK(positive_on(xy, {{Rational(0), Rational(1), true, false}, {Rational(0), Rational(1), true, false}}));
}

TEST_CASE("what is called positive has positive values at random points") {
  std::mt19937 random(2);
  int positive = 0;
  for (int n = 0; n < 400; ++n) {
    const BoxPolynomial p = random_polynomial(random, {2, 2});
    const std::vector<Side> box{{ratio(-1, 3), ratio(1, 2), n % 2 == 0, false}, {Rational(1), Rational(2), false, n % 3 == 0}};
    if (!positive_on(p, box)) continue;
    ++positive;
    for (int k = 0; k <= 10; ++k) {
      for (int l = 0; l <= 10; ++l) {
        if ((n % 2 == 0 && k == 0) || (n % 3 == 0 && l == 10)) continue;
        const Rational x = ratio(-1, 3) + ratio(5, 6) * ratio(k, 10), y = Rational(1) + ratio(l, 10);
        CHECK(p.at({x, y}) > Rational(0));
      }
    }
  }
  CHECK(positive > 20);
}

TEST_CASE("half-infinite ranges keep signs and points") {
  // x - 3 on (3, oo), and 1/(x-3) is no polynomial: x^2 - 9 likewise
  const ParameterBox up{{"x", Rational(3), std::nullopt, true, true}};
  const ParameterBox down{{"x", std::nullopt, Rational(-3), true, true}};
  for (const ParameterBox& box : {up, down}) {
    const BoxPolynomial p = in_finite_coordinates({{2}, {Rational(-9), Rational(0), Rational(1)}}, box);
    CHECK(positive_on(p, {finite_side(box[0])}));
    const BoxPolynomial q = in_finite_coordinates({{2}, {Rational(-10), Rational(0), Rational(1)}}, box);
    CHECK_FALSE(positive_on(q, {finite_side(box[0])}));
    for (int k = 1; k <= 10; ++k) {
      const Rational g = ratio(k, 10), x = from_finite(box[0], g);
      CHECK(p.at({g}).sign() == (x * x - Rational(9)).sign());
    }
  }
  CHECK_THROWS_AS((void)finite_side({"x", std::nullopt, std::nullopt, true, true}), Error);
}

TEST_SUITE_END();
