// Jets against exact derivatives of rational functions, mean values of functions, and masks at single values of alpha.
#include "operators/numbers/jet.h"

#include <doctest/doctest.h>

#include "operators/matrix.h"
#include "operators/numbers/parametric.h"
#include "tests/oracle/inputs.h"
#include "tests/oracle/refusal.h"
#include "tests/oracle/words.h"

using namespace udcp;
using namespace udcp::oracle;

namespace {

Interval between(const Rational& low, const Rational& high) { return {low, high}; }

/// A random rational function of x in both types. No divisor vanishes on [1, 2].
struct Both {
  Parametric exact;
  Jet jet;
};
Both random_function(Dice& dice, const Jet& x, int depth) {
  if (depth == 0) {
    if (dice.one_in(3)) {
      const Rational number = dice.fraction();
      return {number, Jet(number)};
    }
    return {Parametric::variable("x"), x};
  }
  const Both a = random_function(dice, x, depth - 1), b = random_function(dice, x, depth - 1);
  switch (dice.below(5)) {
    case 0:
      return {a.exact + b.exact, a.jet + b.jet};
    case 1:
      return {a.exact - b.exact, a.jet - b.jet};
    case 2:
      return {a.exact * b.exact, a.jet * b.jet};
    case 3: {
      const int n = dice.between(-2, 3);
      return n < 0 ? Both{pow(Parametric::variable("x"), n), pow(x, n)} : Both{pow(a.exact, n), pow(a.jet, n)};
    }
    default:
      return {a.exact / (Parametric::variable("x") + 1), a.jet / (x + 1)};
  }
}

/// Two enclosures of one number.
bool overlap(const Interval& a, const Interval& b) { return !(a != b); }

/// The mean value theorem on [low, high], where `f` takes Jet and Interval: the difference quotients of first and second order
/// between end points and middle are values of the derivatives.
template <class F>
void check_mean_values(const F& f, const Rational& low, const Rational& high) {
  const Jet jet = f(Jet::variable(between(low, high)));
  const Rational middle = (low + high) / 2, step = middle - low;
  Interval at_low, at_middle, at_high;
  {
    const Interval::Precision scope(400);
    at_low = f(Interval(low));
    at_middle = f(Interval(middle));
    at_high = f(Interval(high));
    const Interval slope = (at_high - at_low) / Interval(high - low);
    const Interval bend = (at_low - Interval(2) * at_middle + at_high) / Interval(step * step);
    CAPTURE(jet);
    for (const Interval& value : {at_low, at_middle, at_high}) CHECK(jet.value().contains(value));
    CHECK(overlap(jet.first(), slope));
    CHECK(overlap(jet.second(), bend));
  }
}

/// On wide and on narrow ranges; on the narrow ones the enclosures leave no room for a wrong derivative.
template <class F>
void check_function(const std::string& name, const F& f, const Rational& low, const Rational& high) {
  CAPTURE(name);
  check_mean_values(f, low, high);
  const int pieces = 7;
  const Rational width = Rational(1) / Rational(1L << 30);
  for (int k = 0; k <= pieces; ++k) {
    const Rational at = low + (high - low) * ratio(k, pieces + 1);
    CAPTURE(at);
    check_mean_values(f, at, at + width);
    const Jet narrow = f(Jet::variable(between(at, at + width)));
    CHECK(narrow.first().width() < 2e-3);  // the derivatives below change by less than 10^6 per unit
    CHECK(narrow.second().width() < 2e-3);
  }
  const Jet constant = f(Jet(between(low, high)));
  CHECK(constant.is_constant());
  CHECK(constant.value().contains(f(Interval(low))));
  CHECK(constant.first() == Interval(0));
}

Word uc_with_variable(const Interval& range) {
  Word word = scheme("UC", half_cosine());
  word.alpha0 = Directional<KernelPtr>::all(variable(range));
  return word;
}

}  // namespace

TEST_SUITE("operators") {
  TEST_CASE("jets of rational functions contain the exact value and both derivatives") {
    Dice dice(711);
    for (int trial = 0; trial < 150; ++trial) {
      const Rational low = Rational(1) + ratio(dice.below(50), 100), high = low + ratio(dice.below(50), 100);
      const Both f = random_function(dice, Jet::variable(between(low, high)), 3);
      const Parametric first = f.exact.derivative("x"), second = first.derivative("x");
      CAPTURE(f.exact);
      CAPTURE(f.jet);
      for (int k = 0; k <= 4; ++k) {
        const std::map<std::string, Rational> x{{"x", low + (high - low) * ratio(k, 4)}};
        CHECK(f.jet.value().contains(f.exact.at(x)));
        CHECK(f.jet.first().contains(first.at(x)));
        CHECK(f.jet.second().contains(second.at(x)));
      }
      if (low == high) {  // nothing but roundings at 128 bits is left
        CHECK(f.jet.first().width() < 1e-20);
        CHECK(f.jet.second().width() < 1e-20);
      }
    }
  }

  TEST_CASE("the derivatives of polynomials are exact at dyadic points") {
    const Jet x = Jet::variable(Interval(ratio(3, 2)));
    const Jet p = pow(x, 3) - 2 * x * x + x / 4 - 7;  // p' = 3x^2 - 4x + 1/4, p'' = 6x - 4
    CHECK(p.value() == Interval(Rational::parse("-7.75")));
    CHECK(p.first() == Interval(1));
    CHECK(p.second() == Interval(5));
    CHECK((x / x).second() == Interval(0));
    CHECK(pow(x, 0).is_constant());
    CHECK(pow(Jet::variable(Interval(2)), -1).second() == Interval(ratio(1, 4)));
  }

  TEST_CASE("jets of functions contain the difference quotients of the function") {
    const Rational low = ratio(1, 5), high = ratio(6, 5);
    check_function(
        "cos", [](const auto& x) { return cos(x); }, low, high);
    check_function(
        "sin", [](const auto& x) { return sin(x); }, -high, high);
    check_function(
        "tan", [](const auto& x) { return tan(x); }, -high, high);
    check_function(
        "exp", [](const auto& x) { return exp(x); }, -high, high);
    check_function(
        "log", [](const auto& x) { return log(x); }, low, high);
    check_function(
        "sqrt", [](const auto& x) { return sqrt(x); }, low, high);
    check_function(
        "power", [](const auto& x) { return pow(x, -3); }, low, high);
    check_function(
        "abs", [](const auto& x) { return abs(x); }, -high, -low);
    check_function(
        "min", [](const auto& x) { return min(x, std::decay_t<decltype(x)>(7)); }, low, high);
    check_function(
        "max", [](const auto& x) { return max(std::decay_t<decltype(x)>(-7), x); }, low, high);
    check_function(
        "composition",
        [](const auto& x) {
          using T = std::decay_t<decltype(x)>;
          return T(1) / (T(2) + cos(x / T(2))) - x * sqrt(exp(x) + sin(x * x)) + pow(log(x + T(1)), 2);
        },
        low, high);
  }

  TEST_CASE("comparisons of jets hold near the range as well") {
    const Jet x = Jet::variable(between(0, 1)), zero = Jet::variable(Interval(0));
    CHECK(x < Jet(2));
    CHECK(x != Jet(2));
    CHECK_FALSE(x < Jet(1));
    CHECK_FALSE(x <= Jet(1));  // touching: min(x, 1) has a kink there
    CHECK_FALSE(zero == Jet(0));
    CHECK_FALSE(is_zero(zero));
    CHECK_FALSE(is_nonzero(zero));
    CHECK(is_zero(zero * 0));
    CHECK(Jet(ratio(1, 2)) == Jet(1) / 2);
    CHECK(Jet(1) <= Jet(1));
    CHECK(refusal([&] { (void)abs(x); }) == "E_UNDECIDED: abs may have a kink where its argument is in [0, 1]");
    CHECK(refusal([&] { (void)max(x, Jet(ratio(1, 2))); }).starts_with("E_UNDECIDED: min or max may have a kink"));
    CHECK(refusal([&] { (void)(1 / x); }).starts_with("E_DIV0"));
    CHECK(refusal([&] { (void)sqrt(x); }).starts_with("E_DIV0"));
    CHECK(refusal([&] { (void)log(x); }).starts_with("E_LOG_DOMAIN"));
    CHECK(refusal([&] { (void)pow(x, -1'000'000'001); }).starts_with("E_"));
    CHECK(to_text(x) == "[0, 1] with derivatives [1, 1] and [0, 0]");
    CHECK(to_text(Jet(2)) == "[2, 2]");
    CHECK(approximate(x) == 0.5);
    using Q = Quantity<Jet>;
    CHECK(refusal([&] { (void)compare(Q::of(x), Q(1)); }).starts_with("E_UNDECIDED"));
    CHECK(refusal([&] { (void)min(Q::of(x), Q(ratio(1, 2))); }).starts_with("E_UNDECIDED"));
    CHECK(min(Q::of(x), Q(2)).value().first() == Interval(1));
    CHECK(pow(Q::of(x + 1), Q(ratio(1, 2))).value().first().contains(ratio(1, 2)));
  }

  TEST_CASE("the mask of UC in a variable alpha encloses its values and derivatives") {
    const Mask<Jet> jets = mask<Jet>(uc_with_variable(between(0, 1)));
    CHECK(jets.first == -2);
    REQUIRE(jets.coefficients.size() == 5);
    std::vector<Mask<Interval>> samples;
    const Interval::Precision scope(300);
    for (int k = 0; k <= 8; ++k) samples.push_back(mask<Interval>(uc_with_variable(Interval(ratio(k, 8)))));
    for (std::size_t i = 0; i < 5; ++i) {
      CAPTURE(i);
      for (std::size_t k = 0; k < samples.size(); ++k) {
        CAPTURE(k);
        const Interval& here = samples[k].coefficients[i];
        CHECK(jets.coefficients[i].value().contains(here));
        for (std::size_t m = 0; m < k; ++m) {
          const Interval slope = (here - samples[m].coefficients[i]) / Interval(ratio(static_cast<int>(k - m), 8));
          CHECK(overlap(jets.coefficients[i].first(), slope));
        }
        if (k < 2) continue;
        const Interval& middle = samples[k - 1].coefficients[i];
        const Interval bend = (samples[k - 2].coefficients[i] - Interval(2) * middle + here) * Interval(64);
        CHECK(overlap(jets.coefficients[i].second(), bend));
      }
    }
  }

  TEST_CASE("the derivatives of the mask of UC are those of its formula in f") {
    // By hand from the formula of C on curves: (1 + 2f)/(2 + 2f) in the middle, 1/(4 + 4f) at the ends, 1/2 between, with f =
    // cos(alpha/2). At alpha = 0 all slopes vanish and f = 1, f'' = -1/4, so a second derivative is -1/4 times the slope in f.
    const Mask<Jet> jets = mask<Jet>(uc_with_variable(Interval(0)));
    const Rational second[] = {ratio(1, 64), 0, ratio(-1, 32), 0, ratio(1, 64)};
    const int values[] = {1, 4, 6, 4, 1};
    REQUIRE(jets.coefficients.size() == 5);
    CAPTURE(jets.coefficients[0]);
    CAPTURE(jets.coefficients[1]);
    CAPTURE(jets.coefficients[2]);
    for (std::size_t i = 0; i < 5; ++i) {
      CAPTURE(i);
      CHECK(jets.coefficients[i].value() == Interval(ratio(values[i], 8)));
      CHECK(jets.coefficients[i].first() == Interval(0));
      CHECK(jets.coefficients[i].second().contains(second[i]));
      CHECK(jets.coefficients[i].second().width() < 1e-30);
    }
  }

  TEST_CASE("in later rounds the variable is halved and so are the slopes") {
    const Word word = uc_with_variable(between(0, 1));
    const Mask<Interval> ends[] = {mask<Interval>(uc_with_variable(Interval(ratio(1, 4)))),
                                   mask<Interval>(uc_with_variable(Interval(0)))};
    const Mask<Jet> later = mask<Jet>(word, 2);
    for (std::size_t i = 0; i < 5; ++i) {
      CAPTURE(i);
      CHECK(later.coefficients[i].value().contains(ends[0].coefficients[i]));
      CHECK(later.coefficients[i].first().contains(ends[0].coefficients[i] - ends[1].coefficients[i]));
    }
    CHECK(variable(between(0, 1))->at(Context<double>{}).value() == 0.5);
    CHECK(refusal([] { (void)variable(between(0, 1))->at(Context<Rational>{}); }) ==
          "E_NOT_EXACT: a variable on [0, 1] has no value in this number type");
  }
}
