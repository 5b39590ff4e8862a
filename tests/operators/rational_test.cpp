// Rational against Boost's own integer arithmetic (which shares no code with GMP), strtod, and the field axioms.
#include "operators/numbers/rational.h"

#include <doctest/doctest.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <random>
#include <vector>

#include "operators/error.h"

using udcp::Error;
using udcp::Rational;
using Oracle = boost::multiprecision::cpp_rational;

namespace {

// Fractions of very different sizes: single digits, near the edge of 64 bits, and beyond it.
Rational random_rational(std::mt19937_64& random) {
  const auto part = [&random](bool positive) {
    const int shift = static_cast<int>(random() % 64);
    const auto size = static_cast<long>(random() >> (1 + shift % 63));
    Rational value(random() % 2 == 0 && !positive ? -size : size);
    if (random() % 8 == 0) value *= Rational(static_cast<long>(random() >> 1));
    if (random() % 8 == 0) value += Rational(std::numeric_limits<long>::max());
    return positive && value.sign() <= 0 ? Rational(1) : value;
  };
  const Rational numerator = part(false);
  return random() % 4 == 0 ? numerator : numerator / part(true);
}

Oracle oracle(const Rational& value) { return Oracle(value.to_string()); }

std::string text(const Oracle& value) { return value.str(); }

template <class Function>
std::string code_of(Function function) {
  try {
    function();
  } catch (const Error& error) {
    return error.code;
  }
  return "no error";
}

}  // namespace

TEST_SUITE_BEGIN("operators");

TEST_CASE("Rational agrees with an independent implementation on random operations") {
  std::mt19937_64 random(1);
  for (int i = 0; i < 3000; ++i) {
    const Rational a = random_rational(random);
    const Rational b = random_rational(random);
    CAPTURE(a.to_string());
    CAPTURE(b.to_string());
    CHECK((a + b).to_string() == text(oracle(a) + oracle(b)));
    CHECK((a - b).to_string() == text(oracle(a) - oracle(b)));
    CHECK((a * b).to_string() == text(oracle(a) * oracle(b)));
    if (!b.is_zero()) CHECK((a / b).to_string() == text(oracle(a) / oracle(b)));
    CHECK((-a).to_string() == text(-oracle(a)));
    CHECK(a.compare(b) == (oracle(a) < oracle(b) ? -1 : (oracle(a) > oracle(b) ? 1 : 0)));
    CHECK(a.floor() <= a);
    CHECK(a < a.floor() + 1);
    CHECK(a.floor().is_integer());
    CHECK(a.numerator() / a.denominator() == a);
    CHECK(a.denominator().sign() == 1);
    CHECK(Rational::parse(a.to_string()) == a);
  }
}

TEST_CASE("Rational is a field") {
  std::mt19937_64 random(2);
  for (int i = 0; i < 1000; ++i) {
    const Rational a = random_rational(random);
    const Rational b = random_rational(random);
    const Rational c = random_rational(random);
    CAPTURE(a.to_string());
    CAPTURE(b.to_string());
    CAPTURE(c.to_string());
    CHECK(a + b == b + a);
    CHECK((a + b) + c == a + (b + c));
    CHECK((a * b) * c == a * (b * c));
    CHECK(a * (b + c) == a * b + a * c);
    CHECK((a - a).is_zero());
    if (!a.is_zero()) CHECK(a / a == Rational(1));
    CHECK((a < b) == ((a - b).sign() < 0));
  }
}

TEST_CASE("Rational operands may be the same object") {
  for (const char* value : {"3/7", "-123456789012345678901234567890/7"}) {
    Rational a = Rational::parse(value);
    const Rational copy = a;
    const Rational& same = a;
    a += same;
    CHECK(a == copy * 2);
    a *= same;
    CHECK(a == copy * copy * 4);
    a /= same;
    CHECK(a == Rational(1));
    a -= same;
    CHECK(a == Rational(0));
  }
}

TEST_CASE("Rational crosses the border of 64 bits both ways") {
  const Rational most(std::numeric_limits<long>::max());
  const Rational least(std::numeric_limits<long>::min());
  CHECK(most.to_string() == "9223372036854775807");
  CHECK(least.to_string() == "-9223372036854775808");
  CHECK((most + 1).to_string() == "9223372036854775808");
  CHECK(least == -(most + 1));
  CHECK(most + 1 - 1 == most);
  CHECK((most * most / most) == most);
  CHECK((Rational(1) / least).to_string() == "-1/9223372036854775808");
  CHECK((least / least) == Rational(1));
  CHECK(Rational(-1).low_bits() == ~std::uint64_t{0});
  CHECK((pow(Rational(2), 64) + 5).low_bits() == 5);
  CHECK((-pow(Rational(2), 70) - 1).low_bits() == ~std::uint64_t{0});
}

TEST_CASE("a Rational that was moved from can be assigned and destroyed") {
  Rational big = pow(Rational(3), 100);
  Rational other(std::move(big));
  big = Rational(5);
  CHECK(big == Rational(5));
  big = std::move(other);
  CHECK(big == pow(Rational(3), 100));
  std::vector<Rational> row(3, big);
  row.insert(row.begin(), Rational(1));
  row.erase(row.begin() + 1);
  CHECK(row[1] == big);
  CHECK(row.size() == 3);
}

TEST_CASE("to_double rounds to the nearest double as strtod does") {
  std::mt19937_64 random(3);
  const auto check = [](const std::string& decimal) {
    CAPTURE(decimal);
    CHECK(Rational::parse(decimal).to_double() == std::strtod(decimal.c_str(), nullptr));
  };
  for (int i = 0; i < 4000; ++i) {
    std::string decimal = std::to_string(random() >> (random() % 60));
    if (random() % 2 == 0) decimal.append(".").append(std::to_string(random()));
    decimal.append("e").append(std::to_string(static_cast<int>(random() % 700) - 360));
    if (random() % 2 == 0) decimal.insert(0, 1, '-');
    check(decimal);
  }
  for (const char* tie :
       {"9007199254740993", "9007199254740995", "9007199254740993.000000000000000001", "4.9406564584124654e-324",
        "2.4703282292062327e-324", "2.4703282292062328e-324", "2.2250738585072011e-308", "1.7976931348623157e308",
        "1.7976931348623158e308", "1.7976931348623159e308", "1e309", "-1e400", "1e-400", "0"}) {
    check(tie);
  }
  CHECK((pow(Rational(2), 53) + 1).to_double() == std::ldexp(1.0, 53));        // a tie: to even
  CHECK((pow(Rational(2), 53) + 3).to_double() == std::ldexp(1.0, 53) + 4);    // a tie: to even
  CHECK(pow(Rational(2), -1075).to_double() == 0.0);                           // half the least subnormal: to even
  CHECK((pow(Rational(2), -1075) * 3).to_double() == std::ldexp(1.0, -1073));  // one and a half of it: to even
}

TEST_CASE("every finite double survives the way through Rational") {
  std::mt19937_64 random(4);
  for (int i = 0; i < 3000; ++i) {
    const double value = std::ldexp(static_cast<double>(random()), static_cast<int>(random() % 2100) - 1130);
    if (!std::isfinite(value)) continue;
    CAPTURE(value);
    CHECK(Rational::from_double(value).to_double() == value);
    CHECK(Rational::from_double(-value).to_double() == -value);
  }
  CHECK(code_of([] { Rational::from_double(std::numeric_limits<double>::infinity()); }) == "E_NOT_FINITE");
  CHECK(code_of([] { Rational::from_double(std::nan("")); }) == "E_NOT_FINITE");
}

TEST_CASE("parse reads integers and fractions and decimals exactly") {
  CHECK(Rational::parse("12") == Rational(12));
  CHECK(Rational::parse("-3/4") == Rational(-3) / 4);
  CHECK(Rational::parse("6/8") == Rational(3) / 4);
  CHECK(Rational::parse("0.8") == Rational(4) / 5);
  CHECK(Rational::parse("1.5e-3") == Rational(3) / 2000);
  CHECK(Rational::parse("1.5E+3") == Rational(1500));
  CHECK(Rational::parse("+1") == Rational(1));
  CHECK(Rational::parse("5.") == Rational(5));
  CHECK(Rational::parse(".5") == Rational(1) / 2);
  CHECK(Rational::parse("-0") == Rational(0));
  CHECK(Rational::parse("1e10000") == pow(Rational(10), 10000));
  CHECK(Rational::parse("1e-00010000") == pow(Rational(10), -10000));
}

TEST_CASE("parse refuses what is not a number") {
  for (const char* bad :
       {"",   "-",   "+",     ".",  "+-1",  "--1", " 1",    "1 ",  "1/",  "/2",    "1/-2",  "1/2/3",    "1.5/2",
        "1e", "1e+", "1e1.5", "e5", "0x10", "1,5", "1.2.3", "inf", "nan", "1_000", "1/2e3", "\xC2\xBD", "1e--1"}) {
    CAPTURE(bad);
    CHECK(code_of([bad] { Rational::parse(bad); }) == "E_NUMBER");
  }
  CHECK(code_of([] { Rational::parse(std::string_view("1\0", 2)); }) == "E_NUMBER");
  CHECK(code_of([] { Rational::parse("1/0"); }) == "E_DIV0");
  CHECK(code_of([] { Rational::parse("1/000"); }) == "E_DIV0");
  CHECK(code_of([] { Rational::parse("1e10001"); }) == "E_NUMBER_SIZE");
  CHECK(code_of([] { Rational::parse("1e-99999999999999999999"); }) == "E_NUMBER_SIZE");
  CHECK(code_of([] { Rational::parse(std::string(100'001, '1')); }) == "E_NUMBER_SIZE");
}

TEST_CASE("powers and roots of Rational are exact or refused") {
  const Rational x = Rational(-2) / 3;
  Rational product(1);
  for (int n = 0; n < 80; ++n) {
    CHECK(pow(x, n) == product);
    CHECK(pow(x, -n) == Rational(1) / product);
    CHECK(sqrt(product * product) == abs(product));
    product *= x;
  }
  CHECK(pow(Rational(0), 0) == Rational(1));
  CHECK(pow(Rational(-1), std::numeric_limits<int>::min()) == Rational(1));
  CHECK(*udcp::exact_root(Rational(27) / 64, 3) == Rational(3) / 4);
  CHECK_FALSE(udcp::exact_root(Rational(27) / 65, 3).has_value());
  CHECK(code_of([] { pow(Rational(0), -1); }) == "E_DIV0");
  CHECK(code_of([] { pow(Rational(3), std::numeric_limits<int>::min()); }) == "E_POWER_SIZE");
  CHECK(code_of([] { pow(Rational(3), 2'000'000'000); }) == "E_POWER_SIZE");
  CHECK(code_of([] { sqrt(Rational(2)); }) == "E_NOT_EXACT");
  CHECK(code_of([] { sqrt(Rational(-4)); }) == "E_SQRT_NEGATIVE");
  CHECK(code_of([] { Rational(1) / Rational(0); }) == "E_DIV0");
}

TEST_SUITE_END();
