// Quantity in every number type: what stays exact, what becomes a number, what is refused.
#include "operators/quantity.h"

#define DOCTEST_CONFIG_SUPER_FAST_ASSERTS  // compiles twice as fast; nothing here is expected to throw unasked
#include <doctest/doctest.h>

#include <cstdint>
#include <limits>
#include <random>
#include <set>

using udcp::Algebraic;
using udcp::approximate;
using udcp::Error;
using udcp::ErrorKind;
using udcp::Interval;
using udcp::Jet;
using udcp::Parametric;
using udcp::Quantity;
using udcp::Rational;

namespace {

Rational fraction(long p, long q) { return Rational(p) / Rational(q); }

template <class S>
Quantity<S> pi(long p = 1, long q = 1) {
  return Quantity<S>::pi(fraction(p, q));
}

template <class S>
bool is_exactly(const Quantity<S>& x, const Rational& value) {
  return x.kind() == Quantity<S>::Kind::rational && x.exact() == value;
}

template <class S>
bool is_pi_times(const Quantity<S>& x, const Rational& factor) {
  return x.kind() == Quantity<S>::Kind::pi_multiple && x.exact() == factor;
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

// The weight of Loop's scheme as the language writes it.
template <class S>
Quantity<S> loop_delta(int n) {
  const Quantity<S> inner = Quantity<S>(fraction(3, 8)) + cos(2 * Quantity<S>::pi() / n) / 4;
  return 1 - fraction(8, 3) * (Quantity<S>(fraction(5, 8)) - pow(inner, Quantity<S>(2)));
}

}  // namespace

TEST_SUITE_BEGIN("operators");

#define UDCP_TEST_NUMBERS double, Rational, Algebraic, Interval, Parametric, Jet

TEST_CASE_TEMPLATE("rational operations stay rational", S, UDCP_TEST_NUMBERS) {
  using Q = Quantity<S>;
  CHECK(is_exactly(Q(1) / 3 + Rational::parse("0.25"), fraction(7, 12)));
  CHECK(is_exactly(-pow(Q(2), Q(2)), Rational(-4)));
  CHECK(is_exactly(pow(Q(2), Q(-3)), fraction(1, 8)));
  CHECK(is_exactly(pow(Q(0), Q(0)), Rational(1)));
  CHECK(is_exactly(pow(Q(4), Q(fraction(1, 2))), Rational(2)));
  CHECK(is_exactly(pow(Q(fraction(8, 27)), Q(fraction(-2, 3))), fraction(9, 4)));
  CHECK(is_exactly(sqrt(Q(fraction(9, 4))), fraction(3, 2)));
  CHECK(is_exactly(exp(Q(0)), Rational(1)));
  CHECK(is_exactly(log(Q(1)), Rational(0)));
  CHECK(is_exactly(abs(Q(fraction(-1, 3))), fraction(1, 3)));
  CHECK(is_exactly(min(Q(fraction(1, 3)), Q(fraction(1, 2))), fraction(1, 3)));
  CHECK(is_exactly(max(Q(fraction(1, 3)), Q(fraction(1, 2))), fraction(1, 2)));
  CHECK(is_exactly(min(Q(fraction(1, 3)), Q(fraction(1, 3))), fraction(1, 3)));
}

TEST_CASE_TEMPLATE("multiples of pi stay symbols", S, UDCP_TEST_NUMBERS) {
  using Q = Quantity<S>;
  CHECK(is_pi_times(pi<S>() / 6, fraction(1, 6)));
  CHECK(is_pi_times((2 * pi<S>() / 5) / 2, fraction(1, 5)));
  CHECK(is_pi_times(pi<S>(1, 3) + pi<S>(1, 6), fraction(1, 2)));
  CHECK(is_pi_times(-pi<S>(), Rational(-1)));
  CHECK(is_exactly(pi<S>(1, 3) - pi<S>(1, 3), Rational(0)));
  CHECK(is_exactly(pi<S>(2, 3) / pi<S>(), fraction(2, 3)));
  CHECK(is_exactly(pi<S>() * 0, Rational(0)));
  CHECK(is_pi_times(pi<S>() + 0, Rational(1)));
  CHECK(is_pi_times(abs(pi<S>(-1, 2)), fraction(1, 2)));
  CHECK(is_pi_times(max(pi<S>(), Q(fraction(22, 7))), Rational(1)) == false);  // 22/7 is larger
  CHECK(is_pi_times(max(pi<S>(), Q(fraction(333, 106))), Rational(1)));        // 333/106 is smaller
  CHECK(compare(pi<S>(), Q(Rational::parse("3.14159265358979323846264338327950288419716939937511"))) < 0);
  CHECK(compare(pi<S>(), Q(Rational::parse("3.14159265358979323846264338327950288419716939937510"))) > 0);
  CHECK(compare(pi<S>(-1), Q(-3)) < 0);
  CHECK(compare(Q(-3), pi<S>(-1)) > 0);
  CHECK(pi<S>(2, 5).to_string() == "2/5*pi");
}

TEST_CASE_TEMPLATE("cosines and sines that are rational are exact in every type", S, UDCP_TEST_NUMBERS) {
  using Q = Quantity<S>;
  CHECK(is_exactly(cos(2 * pi<S>() / 6), fraction(1, 2)));
  CHECK(is_exactly(cos(Q(0)), Rational(1)));
  CHECK(is_exactly(cos(pi<S>(1, 2)), Rational(0)));
  CHECK(is_exactly(cos(pi<S>(7)), Rational(-1)));
  CHECK(is_exactly(cos(pi<S>(-4, 3)), fraction(-1, 2)));
  CHECK(is_exactly(sin(pi<S>(1, 6)), fraction(1, 2)));
  CHECK(is_exactly(sin(pi<S>(1, 2)), Rational(1)));
  CHECK(is_exactly(sin(pi<S>(-1, 6)), fraction(-1, 2)));
  CHECK(is_exactly(sin(pi<S>(3)), Rational(0)));
  CHECK(is_exactly(tan(pi<S>(1, 4)), Rational(1)));
  CHECK(is_exactly(tan(pi<S>(-5, 4)), Rational(-1)));
  CHECK(is_exactly(tan(pi<S>(5)), Rational(0)));
  CHECK(is_exactly(loop_delta<S>(6), Rational(0)));
  CHECK(is_exactly(loop_delta<S>(3), fraction(-1, 2)));
  CHECK(code_of([] { tan(pi<S>(3, 2)); }) == "E_DIV0");
}

TEST_CASE_TEMPLATE("other cosines are numbers with the right value", S, double, Algebraic, Interval, Jet) {
  for (long q = 5; q < 30; ++q) {
    for (long p = 1; p < q; ++p) {
      CAPTURE(p);
      CAPTURE(q);
      const double angle = 3.14159265358979324 * static_cast<double>(p) / static_cast<double>(q);
      CHECK(approximate(cos(pi<S>(p, q)).value()) == doctest::Approx(std::cos(angle)).epsilon(1e-14));
      CHECK(approximate(sin(pi<S>(p, q)).value()) == doctest::Approx(std::sin(angle)).epsilon(1e-14));
      if (2 * p != q) CHECK(approximate(tan(pi<S>(p, q)).value()) == doctest::Approx(std::tan(angle)).epsilon(1e-13));
    }
  }
}

TEST_CASE("exact types refuse what they cannot hold") {
  const auto kind_of = [](auto function) {
    try {
      function();
    } catch (const Error& error) {
      return error.kind;
    }
    return ErrorKind::internal;
  };
  CHECK(kind_of([] { cos(pi<Rational>(1, 6)); }) == ErrorKind::not_exact);
  CHECK(code_of([] { cos(pi<Rational>(1, 6)); }) == "E_NOT_EXACT");
  CHECK(code_of([] { cos(Quantity<Algebraic>(1)); }) == "E_NOT_EXACT");
  CHECK(code_of([] { exp(Quantity<Rational>(1)); }) == "E_NOT_EXACT");
  CHECK(code_of([] { log(Quantity<Algebraic>(2)); }) == "E_NOT_EXACT");
  CHECK(code_of([] { sqrt(Quantity<Rational>(2)); }) == "E_NOT_EXACT");
  CHECK(code_of([] { sqrt(pi<Algebraic>()); }) == "E_NOT_EXACT");
  CHECK(code_of([] { return pi<Algebraic>().value(); }) == "E_NOT_EXACT");
  CHECK(code_of([] { pi<Rational>() + 1; }) == "E_NOT_EXACT");
  CHECK(code_of([] { pi<Algebraic>() * pi<Algebraic>(); }) == "E_NOT_EXACT");
  CHECK(code_of([] { pow(Quantity<Rational>(2), Quantity<Rational>(fraction(1, 2))); }) == "E_NOT_EXACT");
  CHECK(code_of([] { pow(Quantity<Algebraic>(2), Quantity<Algebraic>(fraction(1, 3))); }) == "E_NOT_EXACT");
}

TEST_CASE("Algebraic quantities collapse to fractions and keep square roots") {
  using Q = Quantity<Algebraic>;
  CHECK(is_exactly(cos(pi<Algebraic>(1, 5)) - cos(pi<Algebraic>(2, 5)), fraction(1, 2)));
  CHECK(is_exactly(pow(sqrt(Q(2)), Q(2)), Rational(2)));
  CHECK(is_exactly(pow(Q(2), Q(fraction(1, 2))) * sqrt(Q(8)), Rational(4)));
  CHECK(sqrt(Q(2)).value() == udcp::sqrt(Algebraic(2)));
  CHECK(compare(sqrt(Q(2)), Q(fraction(17, 12))) < 0);
  CHECK(compare(pi<Algebraic>(), sqrt(Q(2)) + sqrt(Q(3))) < 0);            // 3.1416 and 3.1463
  CHECK(loop_delta<Algebraic>(5).to_string() == "-17/48 + 5*sqrt(5)/48");  // by hand: c = (sqrt(5)-1)/4
}

TEST_CASE_TEMPLATE("forbidden operands are named", S, UDCP_TEST_NUMBERS) {
  using Q = Quantity<S>;
  CHECK(code_of([] { Q(1) / 0; }) == "E_DIV0");
  CHECK(code_of([] { pi<S>() / Q(0); }) == "E_DIV0");
  CHECK(code_of([] { pow(Q(0), Q(-1)); }) == "E_DIV0");
  CHECK(code_of([] { pow(Q(0), Q(fraction(-1, 2))); }) == "E_DIV0");
  CHECK(code_of([] { sqrt(Q(-1)); }) == "E_SQRT_NEGATIVE");
  CHECK(code_of([] { sqrt(pi<S>(-1)); }) == "E_SQRT_NEGATIVE");
  CHECK(code_of([] { log(Q(0)); }) == "E_LOG_DOMAIN");
  CHECK(code_of([] { log(Q(-2)); }) == "E_LOG_DOMAIN");
  CHECK(code_of([] { pow(Q(-2), Q(fraction(1, 2))); }) == "E_POWER_NEGATIVE");
  CHECK(code_of([] { pow(Q(2), Q(2'000'000'000)); }) == "E_POWER_SIZE");
  CHECK(code_of([] { pow(Q(2), Q(pow(Rational(10), 30))); }) == "E_POWER_SIZE");
  CHECK(is_exactly(pow(Q(-1), Q(pow(Rational(10), 30))), Rational(1)));
  CHECK(code_of([] { udcp::noise<S>(fraction(1, 2), 0, 0); }) == "E_NOISE_SEED");
}

TEST_CASE("doubles that are not finite are refused") {
  using Q = Quantity<double>;
  CHECK(code_of([] { Q::of(std::numeric_limits<double>::infinity()); }) == "E_NOT_FINITE");
  CHECK(code_of([] { exp(Q(1000)); }) == "E_NOT_FINITE");
  CHECK(code_of([] { return Q(pow(Rational(10), 400)).value(); }) == "E_NOT_FINITE");
  CHECK(code_of([] { Q(1) / Q::of(0.0); }) == "E_DIV0");
  CHECK(code_of([] { pow(Q::of(0.0), Q(-1)); }) == "E_DIV0");
  CHECK(code_of([] { sqrt(Q::of(-0.5)); }) == "E_SQRT_NEGATIVE");
  CHECK(code_of([] { log(Q::of(-0.5)); }) == "E_LOG_DOMAIN");
}

TEST_CASE("enclosures of functions contain the values and overlapping ones are not ordered") {
  using Q = Quantity<Interval>;
  const Interval two = pow(pow(Q(2), Q(fraction(1, 3))), Q(3)).value();
  CHECK(two.contains(Rational(2)));
  CHECK(two.width() < 1e-36);
  const Q wide = Q::of(Interval(Rational(0), Rational(2)));
  CHECK(code_of([&] { compare(wide, Q(1)); }) == "E_UNDECIDED");
  CHECK(compare(wide, Q(3)) == -1);
  CHECK(min(wide, Q(1)).value().contains(Interval(Rational(0), Rational(1))));
  CHECK(max(wide, Q(1)).value().contains(Interval(Rational(1), Rational(2))));
  CHECK(is_exactly(min(wide, Q(-1)), Rational(-1)));
  CHECK(code_of([&] { Q(1) / wide; }) == "E_DIV0");
}

TEST_CASE("noise is splitmix64 and the same dyadic number in every type") {
  // splitmix64 from the state 0 starts with 0xe220a8397b1dcdaf; noise(0) at h = 0, i = 0 is that word as 53 bits.
  const auto word = static_cast<std::int64_t>(UINT64_C(0xe220a8397b1dcdaf) >> 11);
  const Rational expected = Rational(static_cast<long>(word)) / pow(Rational(2), 52) - 1;
  CHECK(udcp::noise<Rational>(Rational(0), 0, 0).exact() == expected);
  // The second word of the same generator, and the same word from another seed: the state only adds up.
  const auto second = static_cast<std::int64_t>(UINT64_C(0x6e789e6aa1b965f4) >> 11);
  CHECK(udcp::noise<Rational>(Rational(0), 0, 1).exact() == Rational(static_cast<long>(second)) / pow(Rational(2), 52) - 1);
  std::set<double> values;
  double sum = 0;
  for (int i = 0; i < 2000; ++i) {
    const Rational seed(i % 7 - 3);
    const Rational exact = udcp::noise<Rational>(seed, i % 5, i).exact();
    CHECK(exact >= Rational(-1));
    CHECK(exact < Rational(1));
    CHECK(udcp::noise<Algebraic>(seed, i % 5, i).exact() == exact);
    CHECK(Rational::from_double(udcp::noise<double>(seed, i % 5, i).value()) == exact);
    const Interval point = udcp::noise<Interval>(seed, i % 5, i).value();
    CHECK(point.is_point());
    CHECK(point.contains(exact));
    CHECK(udcp::noise<Rational>(seed + pow(Rational(2), 64), i % 5, i).exact() == exact);
    values.insert(exact.to_double());
    sum += exact.to_double();
  }
  CHECK(values.size() == 2000);
  CHECK(std::abs(sum / 2000) < 5 / std::sqrt(3.0 * 2000));  // five standard deviations of the mean
}

TEST_CASE("quantities convert between number types") {
  using udcp::convert;
  const Quantity<Algebraic> root = sqrt(Quantity<Algebraic>(2));
  CHECK(convert<double>(root).value() == std::sqrt(2.0));
  CHECK((convert<Interval>(root) * convert<Interval>(root)).value().contains(Rational(2)));
  CHECK(convert<Algebraic>(root).value() == root.value());
  CHECK(code_of([&] { convert<Rational>(root); }) == "E_NOT_EXACT");
  CHECK(is_exactly(convert<double>(Quantity<Algebraic>(fraction(1, 3))), fraction(1, 3)));
  CHECK(is_pi_times(convert<Rational>(pi<double>(2, 7)), fraction(2, 7)));
  const Quantity<double> half = Quantity<double>::of(0.5);
  CHECK(convert<Interval>(half).value() == Interval(fraction(1, 2)));
  CHECK(code_of([&] { convert<Algebraic>(half); }) == "E_NOT_EXACT");
  CHECK(convert<double>(convert<Interval>(half)).value() == 0.5);
  CHECK(code_of([&] { convert<Rational>(convert<Interval>(half)); }) == "E_NOT_EXACT");
}

TEST_SUITE_END();
