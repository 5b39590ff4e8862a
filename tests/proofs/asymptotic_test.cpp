// Theorem 3 of the push-back paper: rounds that approach a static limit, and what the limits inherit.
#include <doctest/doctest.h>

#include <fstream>

#include "operators/matrix.h"
#include "proofs/asymptotic.h"
#include "proofs/closed_form.h"
#include "proofs/curve_smoothness.h"
#include "tests/oracle/words.h"

using namespace udcp;
using oracle::ratio;

namespace {

/// The golden file writes formulas as the language does; these are all of them.
KernelPtr kernel_of(const std::string& text) {
  if (text == "cos(alpha/2)") return kernel_from("(cos (/ alpha 2))");
  if (text == "1/cos(alpha/2)") return kernel_from("(/ 1 (cos (/ alpha 2)))");
  if (text == "1+alpha/4") return kernel_from("(+ 1 (/ alpha 4))");
  return constant(Rational::parse(text));
}

Word word_of(const Json& record) {
  const auto parameter = [&](const char* name) -> KernelPtr {
    return record["params"].contains(name) ? kernel_of(record["params"][name]) : nullptr;
  };
  return oracle::scheme(record["program"], parameter("f"), parameter("omega"), parameter("delta"));
}

Word circle_word(const Rational& delta) {
  return oracle::scheme("UCP", kernel_from("(cos (/ alpha 2))"), kernel_from("(/ 1 (cos (/ alpha 2)))"), constant(delta));
}

}  // namespace

TEST_SUITE_BEGIN("proofs");

TEST_CASE("semi-stationary words inherit what the table says") {
  std::ifstream in(UDCP_TEST_DATA "/curve-proofs.json");
  const Json golden = Json::parse(in);
  REQUIRE(golden["semi_stationary"].size() == 5);
  for (const Json& record : golden["semi_stationary"]) {
    CAPTURE(record.dump());
    const Word word = word_of(record);
    const AsymptoticBounds bounds = asymptotic_bounds(word, Rational::parse(record["alpha_max"].get<std::string>()));
    CHECK(bounds.first.to_double() >= record["sampled_ratio1"].get<double>() * (1 - 1e-9));
    if (record["flat_at_0"].get<bool>())
      CHECK(bounds.second.to_double() >= 2 * record["sampled_ratio2"].get<double>() * (1 - 1e-9));
    CHECK(bounds.flat == record["flat_at_0"].get<bool>());
    CHECK(Rational(1) / Rational(bounds.flat ? 4 : 2) == Rational::parse(record["gamma"].get<std::string>()));
    CHECK(bounds.exact_sum_rules == record["exact_sum_rules_all_h"].get<int>());
    const int k = record["certified_C"];
    const Result proved = prove_asymptotic(word, k, prove_smooth(static_limit(word), k));
    CHECK(proved.verdict == Verdict::proved);
    const Result more = prove_asymptotic(word, k + 1, prove_smooth(static_limit(word), k + 1));
    CHECK(more.verdict != Verdict::proved);
  }
}

TEST_CASE("the bounds hold at sampled alpha") {
  const Word word = circle_word(ratio(4, 5));
  const AsymptoticBounds bounds = asymptotic_bounds(word, Rational(1));
  const Mask<Interval> limit = mask<Interval>(static_limit(word));
  for (int n = 1; n <= 10; ++n) {
    const Rational alpha = ratio(n, 10);
    Word at = word;
    at.alpha0 = Directional<KernelPtr>::all(constant(alpha));
    const Mask<Interval> here = mask<Interval>(at);
    REQUIRE(here.coefficients.size() == limit.coefficients.size());
    for (int residue = 0; residue < 2; ++residue) {
      Interval distance(0);
      for (std::size_t k = 0; k < here.coefficients.size(); ++k) {
        if ((here.first + static_cast<int>(k) + 10) % 2 == residue) distance += abs(here.coefficients[k] - limit.coefficients[k]);
      }
      CHECK(distance.lower() <= bounds.second / Rational(2) * alpha * alpha);
      CHECK(distance.lower() <= bounds.first * alpha);
    }
  }
}

TEST_CASE("certificates of Theorem 3 fall with their numbers") {
  const Word word = circle_word(Rational(1));
  const Result result = prove_asymptotic(word, 1, prove_smooth(static_limit(word), 1));
  REQUIRE(result.certificate);
  const Json sound = *result.certificate;
  for (const char* name : {"first", "second", "range"}) {
    Json data = sound["data"];
    data[name] = "1/3";
    CHECK_FALSE(verify(seal("asymptotic", sound["statement"], data)).accepted);
  }
  Json data = sound["data"];
  data["smoothness"] = 2;
  CHECK_FALSE(verify(seal("asymptotic", sound["statement"], data)).accepted);
  data = sound["data"];
  data["word"]["items"][1]["f"]["formula"] = "(cos alpha)";
  CHECK_FALSE(verify(seal("asymptotic", sound["statement"], data)).accepted);
}

TEST_CASE("words without a limit near alpha = 0 are not proved") {
  // sqrt(alpha) has no bounded derivative at 0, so eq. (11) is not shown this way.
  const Word rough = oracle::scheme("UC", kernel_from("(+ 1 (sqrt alpha))"));
  CHECK(prove_asymptotic(rough, 0, prove_smooth(static_limit(rough), 0)).verdict == Verdict::undecided);
  // A static limit that diverges decides nothing about the word itself.
  const Word wild = oracle::scheme("UCP", kernel_from("(cos (/ alpha 2))"), constant(Rational(9)), nullptr);
  CHECK(prove_asymptotic(wild, 0, prove_smooth(static_limit(wild), 0)).verdict == Verdict::undecided);
}

TEST_CASE("prefix formulas have one text and refuse everything else") {
  CHECK(kernel_from("(+ 1   (/ alpha 2/4) )")->closed_form() == "(+ 1 (/ alpha 1/2))");
  CHECK(kernel_from("(min N 3)")->needs().valence);
  CHECK(kernel_from("(cos (/ pi 3))")->at(Context<Rational>{}).value() == ratio(1, 2));
  for (const char* wrong : {"", "(", "(+ 1)", "(+ 1 2 3)", "(foo 1)", "beta", "(cos alpha", "1 2", "(cos (/ alpha 0x2))"}) {
    CAPTURE(wrong);
    CHECK_THROWS_AS((void)kernel_from(wrong), Error);
  }
  CHECK_THROWS_AS((void)kernel_from(std::string(200, '(')), Error);
}

TEST_SUITE_END();
