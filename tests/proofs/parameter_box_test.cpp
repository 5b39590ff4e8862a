// Theorem 2 of the push-back paper and other claims over boxes of parameters.
#include <doctest/doctest.h>

#include "operators/matrix.h"
#include "proofs/parameter_box.h"
#include "tests/oracle/words.h"

using namespace udcp;
using oracle::ratio;

namespace {

Word ucp() { return static_limit(oracle::scheme("UCP", symbol("f"), symbol("omega"), symbol("delta"))); }

/// omega = 16 w
Word four_point() {
  const KernelPtr w = symbol("w");
  const KernelPtr omega = formula([w](const auto& c) { return w->at(c) * Rational(16); }, Needs{false, false, false});
  return static_limit(oracle::scheme("UCP", nullptr, omega, nullptr));
}

ParameterBox theorem_2(int omega_to) {
  return {{"f", Rational(0), std::nullopt, true, true},
          {"omega", Rational(-2), Rational(omega_to), true, true},
          {"delta", Rational(0), Rational(1), false, false}};
}

ParameterBox w_range(const Rational& lower, const Rational& upper) { return {{"w", lower, upper, false, false}}; }

SearchLimits brief(double seconds) {
  SearchLimits limits;
  limits.seconds = seconds;
  return limits;
}

}  // namespace

TEST_SUITE_BEGIN("proofs");

TEST_CASE("Theorem 2 holds on its whole open box") {
  const Result result = prove_smooth_on_box(ucp(), 0, theorem_2(2), brief(20));
  CHECK(result.verdict == Verdict::proved);
  REQUIRE(result.certificate);
  CHECK(verify(*result.certificate).accepted);
  CHECK((*result.certificate)["data"]["cells"] == Json{{"norm", 1}});  // one step does, as in the paper
}

TEST_CASE("Theorem 2 is not proved on the closed box where the norm reaches 1") {
  // f -> 0, omega = 2, delta = 1: the row sum is exactly 1 in the limit; with f = 0 allowed one step is not enough.
  ParameterBox box = theorem_2(2);
  box[0].lower_open = false;
  box[1].upper_open = false;
  BoxScheme scheme = difference_scheme_on_box(ucp(), 0, box);
  CHECK_FALSE(contracts_on(scheme, 1, scheme.box));
}

TEST_CASE("a wider box is not proved in one step and names where it stopped") {
  const Result result = prove_smooth_on_box(ucp(), 0, theorem_2(5), brief(2));
  CHECK(result.verdict != Verdict::proved);
  CHECK(result.witness.contains("parameters"));
}

TEST_CASE("the four-point scheme is C1 for tensions from 1/1000 to 19/100") {
  const Result result = prove_smooth_on_box(four_point(), 1, w_range(ratio(1, 1000), ratio(19, 100)), brief(60));
  CHECK(result.verdict == Verdict::proved);
  REQUIRE(result.certificate);
  CHECK(verify(*result.certificate).accepted);
}

TEST_CASE("the four-point scheme is not C1 for all tensions up to 1/5") {
  const Result result = prove_smooth_on_box(four_point(), 1, w_range(ratio(1, 10), ratio(1, 5)), brief(60));
  CHECK(result.verdict == Verdict::refuted);
  REQUIRE(result.witness["parameters"].contains("w"));
  // Hechler, Moessner and Reif: C^1 exactly below the root of 32 w^3 + 4 w - 1.
  const Rational w = rational_from(result.witness["parameters"]["w"], "w");
  CHECK(Rational(32) * w * w * w + Rational(4) * w - Rational(1) >= Rational(0));
}

TEST_CASE("a region brackets the tension where C1 is lost") {
  const std::vector<RegionCell> cells = region_of_smoothness(four_point(), 1, w_range(ratio(3, 16), ratio(1, 5)), 6, brief(30));
  const auto defect = [](const Rational& w) { return Rational(32) * w * w * w + Rational(4) * w - Rational(1); };
  bool proved = false, refuted = false;
  for (const RegionCell& cell : cells) {
    if (cell.verdict == Verdict::proved) CHECK(defect(cell.upper[0]) <= Rational(0));
    if (cell.verdict == Verdict::refuted) CHECK(defect(cell.lower[0]) >= Rational(0));
    proved = proved || cell.verdict == Verdict::proved;
    refuted = refuted || cell.verdict == Verdict::refuted;
  }
  CHECK(proved);
  CHECK(refuted);
}

TEST_CASE("the difference scheme over a box is that of every word in it") {
  const ParameterBox box{{"f", ratio(1, 2), Rational(2), false, false},
                         {"omega", Rational(-1), Rational(3), false, false},
                         {"delta", Rational(-1), Rational(1), false, false}};
  const BoxScheme scheme = difference_scheme_on_box(ucp(), 1, box);
  for (int n = 0; n < 20; ++n) {
    const std::vector<Rational> x{ratio(1, 2) + ratio(3 * n, 40), Rational(-1) + ratio(n * n % 20, 5),
                                  Rational(-1) + ratio(7 * n % 20, 10)};
    const Mask<Rational> m = mask<Rational>(static_limit(oracle::scheme("UCP", constant(x[0]), constant(x[1]), constant(x[2]))));
    // Multiplied back by (1 + z)^2, the difference mask is the mask.
    std::vector<Rational> c;
    for (const BoxPolynomial& p : scheme.numerators) c.push_back(p.at(x) / scheme.denominator.at(x));
    for (int twice = 0; twice < 2; ++twice) {
      c.push_back(Rational(0));
      for (std::size_t k = c.size() - 1; k > 0; --k) c[k] += c[k - 1];
    }
    while (c.size() > m.coefficients.size() && c.back().is_zero() && c.front().is_zero()) {
      c.pop_back();
      c.erase(c.begin());
    }
    CHECK(c == m.coefficients);
  }
}

TEST_CASE("certificates over boxes fall with any of their numbers") {
  const Result result = prove_smooth_on_box(four_point(), 1, w_range(ratio(1, 20), ratio(1, 10)), brief(30));
  REQUIRE(result.certificate);
  const Json sound = *result.certificate;
  const auto resealed = [&](Json data) { return seal("curve-box", sound["statement"].get<std::string>(), std::move(data)); };
  REQUIRE(verify(resealed(sound["data"])).accepted);
  Json data = sound["data"];
  data["smoothness"] = 2;
  CHECK_FALSE(verify(resealed(data)).accepted);
  data = sound["data"];
  data["box"][0]["upper"] = "1/5";
  CHECK_FALSE(verify(resealed(data)).accepted);
  data = sound["data"];
  data["box"][0]["upper_open"] = true;  // another statement
  CHECK_FALSE(verify(resealed(data)).accepted);
  data = sound["data"];
  data["cells"] = Json{{"norm", 1}};
  CHECK_FALSE(verify(resealed(data)).accepted);
  data = sound["data"];
  data["word"]["items"].erase(2);
  CHECK_FALSE(verify(resealed(data)).accepted);
}

TEST_SUITE_END();
