// Interval against exact rational arithmetic: every result must contain every exact result, and be tight where it is promised.
#include "operators/numbers/interval.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <random>
#include <utility>
#include <vector>

#include "operators/error.h"

using udcp::Error;
using udcp::Interval;
using udcp::Rational;

namespace {

Rational random_rational(std::mt19937_64& random) {
  const auto numerator = static_cast<long>(random() % 4001) - 2000;
  const auto denominator = static_cast<long>(random() % 997) + 1;
  const int shift = static_cast<int>(random() % 41) - 20;
  return Rational(numerator) / Rational(denominator) * pow(Rational(2), shift);
}

struct Sample {
  Interval enclosure;
  std::vector<Rational> members;  // both end points and points between them
};

Sample random_sample(std::mt19937_64& random) {
  Rational a = random_rational(random);
  Rational b = random() % 4 == 0 ? a : random_rational(random);
  if (b < a) std::swap(a, b);
  const Rational t = Rational(static_cast<long>(random() % 101)) / 100;
  return {Interval(a, b), {a, b, a + (b - a) * t}};
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

// A rational within 2^-200 of the cosine (or sine) of x with |x| <= 4, by the alternating series.
Rational trigonometric_series(const Rational& x, bool cosine) {
  Rational term = cosine ? Rational(1) : x;
  Rational sum = term;
  for (int n = cosine ? 1 : 2; n < 120; n += 2) {
    term *= -x * x / Rational(n * (n + 1));
    sum += term;
  }
  return sum;
}

}  // namespace

TEST_SUITE_BEGIN("operators");

TEST_CASE("every operation of Interval contains the exact results") {
  std::mt19937_64 random(1);
  for (const int bits : {2, 5, 24, 53, 128}) {
    const Interval::Precision scope(bits);
    for (int i = 0; i < 150; ++i) {
      const Sample a = random_sample(random);
      const Sample b = random_sample(random);
      CAPTURE(bits);
      CAPTURE(a.enclosure.to_string());
      CAPTURE(b.enclosure.to_string());
      for (const Rational& x : a.members) {
        CHECK(a.enclosure.contains(x));
        CHECK((-a.enclosure).contains(-x));
        CHECK(abs(a.enclosure).contains(abs(x)));
        for (int n = 0; n < 6; ++n) CHECK(pow(a.enclosure, n).contains(pow(x, n)));
        if (!a.enclosure.contains_zero()) {
          for (int n = 1; n < 4; ++n) CHECK(pow(a.enclosure, -n).contains(pow(x, -n)));
        }
        for (const Rational& y : b.members) {
          CHECK((a.enclosure + b.enclosure).contains(x + y));
          CHECK((a.enclosure - b.enclosure).contains(x - y));
          CHECK((a.enclosure * b.enclosure).contains(x * y));
          if (!b.enclosure.contains_zero()) CHECK((a.enclosure / b.enclosure).contains(x / y));
          CHECK(min(a.enclosure, b.enclosure).contains(x < y ? x : y));
          CHECK(max(a.enclosure, b.enclosure).contains(x < y ? y : x));
          CHECK(Interval::hull(a.enclosure, b.enclosure).contains(y));
          if (a.enclosure < b.enclosure) CHECK(x < y);
          if (a.enclosure <= b.enclosure) CHECK(x <= y);
          if (a.enclosure == b.enclosure) CHECK(x == y);
          if (a.enclosure != b.enclosure) CHECK(x != y);
        }
      }
    }
  }
}

TEST_CASE("square roots enclose and are monotone") {
  std::mt19937_64 random(2);
  for (int i = 0; i < 300; ++i) {
    const Rational x = abs(random_rational(random));
    const Interval root = sqrt(Interval(x));
    CAPTURE(x.to_string());
    CHECK(root.lower() * root.lower() <= x);
    CHECK(root.upper() * root.upper() >= x);
    CHECK(sqrt(Interval(x * x)).contains(x));
  }
}

TEST_CASE("cosine and sine enclose their series") {
  std::mt19937_64 random(3);
  const Rational error = pow(Rational(2), -200);
  for (int i = 0; i < 40; ++i) {
    const Rational x = Rational(static_cast<long>(random() % 8001) - 4000) / 1000;
    const Rational c = trigonometric_series(x, true);
    const Rational s = trigonometric_series(x, false);
    CAPTURE(x.to_string());
    CHECK(cos(Interval(x)).lower() <= c + error);
    CHECK(cos(Interval(x)).upper() >= c - error);
    CHECK(sin(Interval(x)).lower() <= s + error);
    CHECK(sin(Interval(x)).upper() >= s - error);
    CHECK(cos(Interval(x)).width() < 1e-36);
    CHECK((cos(Interval(x)) * cos(Interval(x)) + sin(Interval(x)) * sin(Interval(x))).contains(Rational(1)));
    if (!cos(Interval(x)).contains_zero()) CHECK((tan(Interval(x)) * cos(Interval(x)) - sin(Interval(x))).contains_zero());
  }
  CHECK(cos(Interval(Rational(3), Rational(4))).lower() == Rational(-1));  // pi lies inside
  CHECK(sin(Interval(Rational(1), Rational(2))).upper() == Rational(1));   // pi/2 lies inside
  CHECK(cos(Interval(Rational(-1), Rational(7))).contains(Interval(Rational(-1), Rational(1))));
}

TEST_CASE("exp and log enclose and invert each other") {
  std::mt19937_64 random(4);
  for (int i = 0; i < 100; ++i) {
    const Rational x = Rational(static_cast<long>(random() % 20001) - 10000) / 1000;
    CAPTURE(x.to_string());
    CHECK(log(exp(Interval(x))).contains(x));
    CHECK((exp(Interval(x)) * exp(Interval(-x))).contains(Rational(1)));
    if (x.sign() > 0) CHECK(exp(log(Interval(x))).contains(x));
  }
  // 2.7182818284590452353602874713526624977572 < e < ...573
  CHECK(exp(Interval(1)).lower() < Rational::parse("2.7182818284590452353602874713526624977573"));
  CHECK(exp(Interval(1)).upper() > Rational::parse("2.7182818284590452353602874713526624977572"));
  CHECK(Interval::pi().lower() < Rational::parse("3.1415926535897932384626433832795028841972"));
  CHECK(Interval::pi().upper() > Rational::parse("3.1415926535897932384626433832795028841971"));
}

TEST_CASE("the enclosure of a fraction is the tightest one") {
  const Interval::Precision scope(64);
  const Interval third(Rational(1) / 3);
  CHECK(third.upper() - third.lower() == pow(Rational(2), -65));  // neighbours of 1/3, which lies between 2^-2 and 2^-1
  CHECK(third.lower() < Rational(1) / 3);
  CHECK(third.upper() > Rational(1) / 3);
  CHECK(Interval(Rational(3) / 8).is_point());
  CHECK(Interval(Rational(3) / 8) == Interval::from_double(0.375));
}

TEST_CASE("decimals round outward") {
  std::mt19937_64 random(5);
  for (int i = 0; i < 500; ++i) {
    const Sample a = random_sample(random);
    for (const int digits : {1, 2, 5, 17, 60}) {
      const std::string lower = a.enclosure.lower_decimal(digits);
      const std::string upper = a.enclosure.upper_decimal(digits);
      CAPTURE(lower);
      CAPTURE(upper);
      CHECK(Rational::parse(lower) <= a.enclosure.lower());
      CHECK(Rational::parse(upper) >= a.enclosure.upper());
    }
  }
  CHECK(Interval(Rational(1) / 3).to_string(3) == "[0.333, 0.334]");
  CHECK(Interval(Rational(-1) / 3).to_string(3) == "[-0.334, -0.333]");
  CHECK(Interval(1000000).to_string(2) == "[1e6, 1e6]");
  CHECK(Interval(1234).to_string() == "[1234, 1234]");
  CHECK(Interval(Rational::parse("-0.001953125")).to_string() == "[-0.001953125, -0.001953125]");
  CHECK(Interval(0).to_string() == "[0, 0]");
}

TEST_CASE("width is an upper bound and midpoint lies inside") {
  std::mt19937_64 random(6);
  for (int i = 0; i < 500; ++i) {
    const Sample a = random_sample(random);
    const Rational width = a.enclosure.upper() - a.enclosure.lower();
    CHECK(Rational::from_double(a.enclosure.width()) >= width);
    const Rational middle = (a.enclosure.lower() + a.enclosure.upper()) / 2;
    CHECK(a.enclosure.midpoint() == middle.to_double());
  }
}

TEST_CASE("precision belongs to new values and the scope restores it") {
  CHECK(Interval::precision() == 128);
  Interval coarse;
  {
    const Interval::Precision scope(16);
    coarse = Interval(Rational(1) / 3);
  }
  CHECK(Interval::precision() == 128);
  CHECK(coarse.width() > 1e-7);
  Interval point = Interval(1);
  {
    const Interval::Precision scope(300);
    point /= Interval(3);  // made now: in 300 bits, although the operand had 128
    CHECK(point.width() < 1e-89);
  }
  CHECK(point.contains(Rational(1) / 3));
  CHECK(code_of([] { Interval::set_precision(1); }) == "E_PRECISION");
  CHECK(code_of([] { Interval::set_precision(1'000'001); }) == "E_PRECISION");
  CHECK(Interval::precision() == 128);
}

TEST_CASE("Interval never holds NaN or infinity") {
  const Interval around_zero(Rational(-1), Rational(1));
  CHECK(code_of([&] { Interval(1) / around_zero; }) == "E_DIV0");
  CHECK(code_of([&] { Interval(1) / Interval(0); }) == "E_DIV0");
  CHECK(code_of([&] { pow(around_zero, -2); }) == "E_DIV0");
  CHECK(code_of([] { tan(Interval(Rational(1), Rational(2))); }) == "E_DIV0");
  CHECK(code_of([&] { log(around_zero); }) == "E_LOG_DOMAIN");
  CHECK(code_of([] { log(Interval(0)); }) == "E_LOG_DOMAIN");
  CHECK(code_of([&] { sqrt(around_zero); }) == "E_SQRT_NEGATIVE");
  CHECK(code_of([] { Interval(Rational(1), Rational(0)); }) == "E_INTERVAL_ORDER");
  CHECK(code_of([] { Interval::from_double(std::nan("")); }) == "E_NOT_FINITE");
  CHECK(code_of([] { Interval::from_double(std::numeric_limits<double>::infinity()); }) == "E_NOT_FINITE");
  CHECK(code_of([] { exp(Interval(pow(Rational(10), 30))); }) == "E_NOT_FINITE");
  Interval growing(3);
  CHECK(code_of([&growing] {
          for (int i = 0; i < 100; ++i) growing *= growing;
        }) == "E_NOT_FINITE");
}

TEST_CASE("gigantic arguments are answered at once") {
  Interval huge(3);
  for (int i = 0; i < 28; ++i) huge *= huge;
  CHECK_FALSE(cos(huge) == cos(huge));
  CHECK(cos(huge).contains(Interval(Rational(-1), Rational(1))));
  CHECK(code_of([&huge] { return huge.upper(); }) == "E_NUMBER_SIZE");
  CHECK(code_of([&huge] { tan(huge); }) == "E_DIV0");
  CHECK_FALSE(huge.to_string().empty());
}

TEST_CASE("Interval survives moves and containers") {
  Interval a(Rational(1) / 3);
  Interval b(std::move(a));
  a = Interval(7);
  CHECK(a == Interval(7));
  std::swap(a, b);
  CHECK(b == Interval(7));
  std::vector<Interval> row(4, a);
  row.erase(row.begin());
  CHECK(row[2].contains(Rational(1) / 3));
  a = *&a;
  CHECK(a.contains(Rational(1) / 3));
}

TEST_SUITE_END();
