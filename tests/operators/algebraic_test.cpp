// Algebraic: field axioms, identities between cosines, values known in radicals, and signs of very small numbers.
#include "operators/numbers/algebraic.h"

#include <doctest/doctest.h>

#include <cmath>
#include <random>
#include <vector>

#include "operators/error.h"

using udcp::Algebraic;
using udcp::Error;
using udcp::Interval;
using udcp::Rational;

namespace {

Rational fraction(long p, long q) { return Rational(p) / Rational(q); }

// cos(2 pi k/n)
Algebraic turn(long k, long n) { return Algebraic::cosine(fraction(2 * k, n)); }

Algebraic random_algebraic(std::mt19937_64& random, const std::vector<int>& orders) {
  Algebraic sum(fraction(static_cast<long>(random() % 41) - 20, static_cast<long>(random() % 9) + 1));
  for (int terms = static_cast<int>(random() % 3); terms >= 0; --terms) {
    const int n = orders[random() % orders.size()];
    sum += Algebraic(fraction(static_cast<long>(random() % 21) - 10, static_cast<long>(random() % 6) + 1)) *
           turn(static_cast<long>(random() % static_cast<unsigned>(n)), n);
  }
  return sum;
}

template <class Function>
std::string code_of(Function function) {
  try {
    function();
  } catch (const Error& error) {
    return error.code;
  }
  return "no error";
}

bool overlap(const Interval& a, const Interval& b) { return (a - b).contains_zero(); }

}  // namespace

TEST_SUITE_BEGIN("operators");

TEST_CASE("Algebraic is a field and agrees with its enclosures") {
  std::mt19937_64 random(1);
  const std::vector<int> orders{5, 7, 8, 9, 12, 15, 16};
  const Interval::Precision scope(256);
  for (int i = 0; i < 60; ++i) {
    const std::vector<int> family{orders[random() % orders.size()], orders[random() % 3]};
    const Algebraic a = random_algebraic(random, family);
    const Algebraic b = random_algebraic(random, family);
    const Algebraic c = random_algebraic(random, family);
    CAPTURE(a.to_string());
    CAPTURE(b.to_string());
    CAPTURE(c.to_string());
    CHECK(a + b == b + a);
    CHECK((a * b) * c == a * (b * c));
    CHECK(a * (b + c) == a * b + a * c);
    CHECK((a - a).is_zero());
    CHECK(overlap((a + b).enclosure(), a.enclosure() + b.enclosure()));
    CHECK(overlap((a * b).enclosure(), a.enclosure() * b.enclosure()));
    CHECK((a * b).enclosure().width() < 1e-60);
    if (!b.is_zero()) {
      CHECK(a / b * b == a);
      CHECK(overlap((a / b).enclosure(), a.enclosure() / b.enclosure()));
    }
    const Interval difference = a.enclosure() - b.enclosure();
    if (difference > Interval(0)) CHECK(a > b);
    if (difference < Interval(0)) CHECK(a < b);
  }
}

TEST_CASE("cosine lies where the enclosure of the cosine says") {
  for (long n = 1; n <= 40; ++n) {
    for (long k = -1; k <= n; ++k) {
      const Interval expected = cos(Interval(fraction(2 * k, n)) * Interval::pi());
      CAPTURE(k);
      CAPTURE(n);
      CHECK(overlap(turn(k, n).enclosure(), expected));
      CHECK(turn(k, n).enclosure().width() < 1e-30);
    }
  }
}

TEST_CASE("known cosines in radicals") {
  const Algebraic root2 = sqrt(Algebraic(2));
  const Algebraic root3 = sqrt(Algebraic(3));
  const Algebraic root5 = sqrt(Algebraic(5));
  CHECK(turn(1, 5) == (root5 - 1) / 4);
  CHECK(turn(2, 5) == (-root5 - 1) / 4);
  CHECK(Algebraic::cosine(fraction(1, 5)) == (root5 + 1) / 4);
  CHECK(turn(1, 8) == root2 / 2);
  CHECK(turn(1, 12) == root3 / 2);
  CHECK(turn(1, 24) == (root2 + root2 * root3) / 4);
  CHECK(turn(1, 1) == Algebraic(1));
  CHECK(turn(1, 2) == Algebraic(-1));
  CHECK(turn(1, 3) == Algebraic(fraction(-1, 2)));
  CHECK(turn(1, 4) == Algebraic(0));
  CHECK(turn(1, 6) == Algebraic(fraction(1, 2)));
  CHECK(turn(5, 6).is_rational());
}

TEST_CASE("the double angle formula holds across fields") {
  for (const long b : {3, 4, 5, 6, 7, 9, 10, 11, 12, 16, 21, 30, 45, 64, 97}) {
    for (const long a : {1, 2, 3, 5}) {
      const Algebraic c = Algebraic::cosine(fraction(a, b));
      CAPTURE(a);
      CAPTURE(b);
      CHECK(Algebraic::cosine(fraction(2 * a, b)) == c * c * 2 - 1);
      CHECK(Algebraic::cosine(fraction(3 * a, b)) == c * c * c * 4 - c * 3);
      CHECK(Algebraic::cosine(fraction(a, b) + 1) == -c);
      CHECK(Algebraic::cosine(fraction(-a, b) + 2000000) == c);
    }
  }
}

TEST_CASE("products of cosines from different fields are sums of cosines") {
  for (const auto& orders : std::vector<std::pair<long, long>>{{5, 7}, {8, 12}, {9, 15}, {7, 16}, {5, 20}, {11, 3}}) {
    const Rational x = fraction(2, orders.first);
    const Rational y = fraction(4, orders.second);
    CAPTURE(x.to_string());
    CAPTURE(y.to_string());
    CHECK(Algebraic::cosine(x) * Algebraic::cosine(y) * 2 == Algebraic::cosine(x + y) + Algebraic::cosine(x - y));
  }
}

TEST_CASE("the cosines of all n-th roots of unity sum to zero and collapse to fractions") {
  for (long n = 2; n <= 60; ++n) {
    Algebraic sum;
    for (long k = 0; k < n; ++k) sum += turn(k, n);
    CAPTURE(n);
    CHECK(sum.is_zero());
    CHECK(sum.field_order() == 1);
  }
  // Over the primitive ones the sum is the Moebius function; 30 has three primes, 7 has one, 12 has a square.
  const auto primitive = [](std::vector<long> units, long n) {
    Algebraic sum;
    for (const long k : units) sum += turn(k, n);
    return sum;
  };
  CHECK(primitive({1, 7, 11, 13, 17, 19, 23, 29}, 30) == Algebraic(-1));
  CHECK(primitive({1, 2, 3, 4, 5, 6}, 7) == Algebraic(-1));
  CHECK(primitive({1, 5, 7, 11}, 12).is_zero());
}

TEST_CASE("square roots of fractions are exact") {
  std::mt19937_64 random(2);
  for (int i = 0; i < 120; ++i) {
    const Rational x = fraction(static_cast<long>(random() % 60) + 1, static_cast<long>(random() % 3) + 1);
    const Algebraic root = sqrt(Algebraic(x));
    CAPTURE(x.to_string());
    CHECK(root * root == Algebraic(x));
    CHECK(root.sign() == 1);
  }
  CHECK(sqrt(Algebraic(fraction(9, 4))).is_rational());
  CHECK(sqrt(Algebraic(0)).is_zero());
}

TEST_CASE("square roots of quadratic numbers are found where they split") {
  const Algebraic golden = (sqrt(Algebraic(5)) + 1) / 2;
  CHECK(sqrt(golden * golden) == golden);
  CHECK(sqrt(golden + 1) == golden);
  const Algebraic x = sqrt(Algebraic(2)) - sqrt(Algebraic(3));
  CHECK(sqrt(x * x) == -x);
  CHECK(code_of([&] { sqrt(golden); }) == "E_NOT_EXACT");
  CHECK(code_of([] { sqrt(turn(1, 7)); }) == "E_NOT_EXACT");
  CHECK(code_of([] { sqrt(Algebraic(1009)); }) == "E_NOT_EXACT");  // its field has degree 504
  CHECK(code_of([] { sqrt(Algebraic(pow(Rational(2), 4001) + 1)); }) == "E_NOT_EXACT");
  CHECK(code_of([] { sqrt(turn(2, 5)); }) == "E_SQRT_NEGATIVE");
}

TEST_CASE("signs of very small numbers are decided") {
  // Convergents p/q of sqrt(2): |p - q sqrt(2)| < 1/q, alternating in sign.
  const Algebraic root2 = sqrt(Algebraic(2));
  Rational p(1);
  Rational q(1);
  for (int n = 0; n < 400; ++n) {
    CAPTURE(n);
    const Algebraic gap = Algebraic(p) - Algebraic(q) * root2;
    if (n % 40 == 0) CHECK(gap.sign() == (n % 2 == 0 ? -1 : 1));
    if (n % 40 == 1) CHECK(gap.sign() == 1);
    const Rational next = p + q * 2;
    q += p;
    p = next;
  }
  CHECK(Interval::precision() == 128);
  // The same number in two fields, and a neighbour of it.
  const Algebraic five = sqrt(Algebraic(5));
  const Algebraic hidden = five + turn(1, 7) - turn(1, 7);
  CHECK(hidden == five);
  CHECK(hidden.compare(five) == 0);
  CHECK(hidden + Algebraic(pow(Rational(2), -500)) > five);
  CHECK(hidden - Algebraic(pow(Rational(2), -500)) < five);
}

TEST_CASE("to_double is the nearest double") {
  CHECK(sqrt(Algebraic(2)).to_double() == std::sqrt(2.0));  // IEEE square roots are correctly rounded
  CHECK(sqrt(Algebraic(3)).to_double() == std::sqrt(3.0));
  CHECK(sqrt(Algebraic(105)).to_double() == std::sqrt(105.0));
  CHECK(Algebraic(fraction(1, 3)).to_double() == 1.0 / 3.0);
}

TEST_CASE("quadratic numbers print with one square root") {
  const Algebraic five = sqrt(Algebraic(5));
  CHECK((five * 5 / 48 - Algebraic(fraction(17, 48))).to_string() == "-17/48 + 5*sqrt(5)/48");
  CHECK(turn(1, 5).to_string() == "-1/4 + sqrt(5)/4");
  CHECK(turn(2, 5).to_string() == "-1/4 - sqrt(5)/4");
  CHECK((-five).to_string() == "-sqrt(5)");
  CHECK((sqrt(Algebraic(12)) * 5).to_string() == "10*sqrt(3)");
  CHECK(turn(1, 8).to_string() == "sqrt(2)/2");
  CHECK((turn(1, 7) + five - turn(1, 7)).to_string() == "sqrt(5)");
  CHECK(sqrt(Algebraic(fraction(21, 4))).to_string() == "sqrt(21)/2");
  CHECK(Algebraic(fraction(-3, 4)).to_string() == "-3/4");
}

TEST_CASE("other numbers print as a polynomial in one cosine") {
  const Algebraic c = turn(1, 7);
  CHECK((Algebraic(fraction(1, 2)) + c * 3 / 4 - c * c).to_string() == "1/2 + 3/4*cos(2*pi/7) - cos(2*pi/7)^2");
  CHECK((-c).to_string() == "-cos(2*pi/7)");
  CHECK((c * c * Algebraic(fraction(-5, 3))).to_string() == "-5/3*cos(2*pi/7)^2");
}

TEST_CASE("coefficients are those of the powers of twice the cosine") {
  const Algebraic x = turn(1, 7) * 6 + Algebraic(fraction(1, 3));
  CHECK(x.field_order() == 7);
  CHECK(x.coefficients() == std::vector<Rational>{fraction(1, 3), Rational(3), Rational(0)});
  CHECK(Algebraic(4).coefficients() == std::vector<Rational>{Rational(4)});
}

TEST_CASE("powers of Algebraic") {
  const Algebraic golden = (sqrt(Algebraic(5)) + 1) / 2;
  // Lucas numbers: golden^n + (-1/golden)^n = 1, 3, 4, 7, 11, ...
  CHECK(pow(golden, 10) + pow(golden, -10) == Algebraic(123));
  CHECK(pow(golden, 0) == Algebraic(1));
  CHECK(pow(Algebraic(fraction(2, 3)), -3) == Algebraic(fraction(27, 8)));
  CHECK(abs(turn(2, 5)) == -turn(2, 5));
  CHECK(code_of([] { pow(Algebraic(0), -1); }) == "E_DIV0");
  CHECK(code_of([&] { pow(golden, 2'000'000'000); }) == "E_POWER_SIZE");
}

TEST_CASE("Algebraic refuses what it cannot hold") {
  CHECK(code_of([] { turn(1, 1009); }) == "E_FIELD_DEGREE");
  CHECK(code_of([] { turn(1, 1000003); }) == "E_FIELD_DEGREE");
  CHECK(code_of([] { Algebraic::cosine(pow(Rational(10), -5000)); }) == "E_FIELD_DEGREE");
  CHECK(code_of([] { turn(1, 97) + turn(1, 89); }) == "E_FIELD_DEGREE");
  CHECK(code_of([] { turn(1, 5) / Algebraic(0); }) == "E_DIV0");
  CHECK(code_of([] { turn(1, 5) / (turn(1, 5) - turn(4, 5)); }) == "E_DIV0");
  CHECK(code_of([] { return turn(1, 5).rational(); }) == "E_NOT_EXACT");
  CHECK(turn(1, 97) > turn(1, 89));            // compared without a common field
  CHECK(turn(1, 1680).field_order() == 1680);  // degree 192, the largest
}

TEST_SUITE_END();
