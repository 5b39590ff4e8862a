// Convergence, C^k and Hoelder exponents of words: expected values of the specification and of the literature, false claims, and
// certificates with every number changed.
#include "proofs/curve_smoothness.h"

#include <doctest/doctest.h>

#include "proofs/polytope.h"
#include "proofs/static_word.h"
#include "tests/oracle/expected_curves.h"
#include "tests/oracle/leaves.h"

using namespace udcp;
using oracle::ratio;
using oracle::scheme;
using oracle::value;

namespace {

/// The generalised four-point scheme with tension w: UCP with omega = 16 w.
Word four_point(int p, int q) { return scheme("UCP", nullptr, value(16 * p, q), nullptr); }

void check_certified(const Result& result, Verdict verdict) {
  CAPTURE(result.claim);
  CAPTURE(result.reason);
  CHECK(result.verdict == verdict);
  REQUIRE(result.certificate);
  const Verification again = verify(Json::parse(result.certificate->dump()));
  CHECK(again.accepted);
  CHECK(again.statement == result.claim);
}

Json as_json(const std::optional<Stencil<Algebraic>>& stencil) {
  if (!stencil) return nullptr;
  Json result = Json::object();
  for (std::size_t k = 0; k < stencil->weights.size(); ++k)
    if (!stencil->weights[k].is_zero())
      result[std::to_string(stencil->first + static_cast<int>(k))] = to_json(stencil->weights[k]);
  return result;
}

}  // namespace

TEST_SUITE_BEGIN("proofs");

TEST_CASE("contraction numbers are the least ones of the specification") {
  for (const Json& record : oracle::expected_curves()["static"]) {
    CAPTURE(record["program"].get<std::string>());
    CAPTURE(record["params"].dump());
    const Mask<Rational> m = mask<Rational>(oracle::expected_word(record));
    std::size_t found = 0;
    for (int k = 0; k < 7; ++k) {
      Budget budget{SearchLimits{}};
      const auto c = contraction(m, k, m.arity == 2 ? 6 : 3, budget);
      if (!c) continue;
      REQUIRE(found < record["contractive"].size());
      const Json& expected = record["contractive"][found++];
      CHECK(expected["k"].get<int>() == k);
      CHECK(expected["L"].get<int>() == c->length);
      CHECK(expected["value"] == to_json(c->value));
    }
    CHECK(found == record["contractive"].size());
  }
}

TEST_CASE("smoothness and exponents of words are those of the specification") {
  for (const Json& record : oracle::expected_curves()["static"]) {
    CAPTURE(record["program"].get<std::string>());
    CAPTURE(record["params"].dump());
    const Word word = oracle::expected_word(record);
    const Regularity regularity = holder(word);
    check_certified(regularity.result, Verdict::proved);
    CHECK(regularity.smoothness == record["smooth_C"].get<int>());
    // The expected bracket has rounded ends.
    const double low = record["holder"][0].get<double>(), high = record["holder"][1].get<double>();
    CHECK(regularity.at_least.midpoint() >= low - 1e-12);
    CHECK(regularity.at_least.midpoint() <= high + 1e-12);
    CHECK(regularity.at_most.has_value() == (record["stable"] == true || record["program"] == "U[3]CP"));
    if (regularity.at_most) CHECK(regularity.at_most->midpoint() <= high + 1e-12);
    const int k = regularity.smoothness;
    check_certified(prove_smooth(word, k), Verdict::proved);
    const Result next = prove_smooth(word, k + 1);
    if (record["stable"] == true) {
      check_certified(next, Verdict::refuted);
    } else {
      CHECK(next.verdict != Verdict::proved);
    }
    const LimitStencils stencils = limit_stencils(word);
    if (record.contains("limit_position")) CHECK(as_json(stencils.position) == record["limit_position"]);
    if (record.contains("limit_tangent")) CHECK(as_json(stencils.tangent) == record["limit_tangent"]);
  }
}

TEST_CASE("the four-point scheme has exponent 2 and is not C^2") {
  const Regularity regularity = holder(four_point(1, 16));
  CHECK(regularity.exact == "2");
  REQUIRE(regularity.result.certificate);
  CHECK(regularity.result.certificate->at("statement") ==
        "(U C P)* where omega = 1, delta = 1 has the Hoelder exponent 2 on curves");
  check_certified(prove_smooth(four_point(1, 16), 1), Verdict::proved);
  check_certified(prove_smooth(four_point(1, 16), 2), Verdict::refuted);
}

TEST_CASE("the four-point family is C^1 below 0.19273 and not above") {
  // Hechler, Moessner, Reif, C1-continuity of the generalized four-point scheme; Powell's range of convergence |w| < 1/2.
  check_certified(prove_smooth(four_point(77, 400), 1), Verdict::proved);
  check_certified(prove_smooth(four_point(309, 1600), 1), Verdict::refuted);
  check_certified(prove_smooth(four_point(1, 1000), 1), Verdict::proved);
  check_certified(prove_smooth(four_point(0, 1), 1), Verdict::refuted);
  check_certified(prove_converges(four_point(49, 100)), Verdict::proved);
  check_certified(prove_converges(four_point(-49, 100)), Verdict::proved);
  check_certified(prove_converges(four_point(1, 2)), Verdict::refuted);
  check_certified(prove_converges(four_point(-1, 2)), Verdict::refuted);
  check_certified(prove_smooth(four_point(3, 5), 1), Verdict::refuted);
}

TEST_CASE("UCP with delta from -1/2 to 1 has exponent 3 - log2(1 + delta)") {
  for (const auto& [p, q, text] : {std::tuple{0, 1, "3"},
                                   {1, 4, "3 - log2(5/4)"},
                                   {1, 2, "3 - log2(3/2)"},
                                   {9, 10, "3 - log2(19/10)"},
                                   {-1, 4, "4 - log2(3/2)"},
                                   {1, 1, "2"},
                                   {-1, 2, "5"}}) {
    CHECK(holder(scheme("UCP", nullptr, nullptr, value(p, q))).exact == text);
  }
  // k = 2: 4 - log2(1 + 3 delta)
  for (const auto& [p, q, text] : {std::tuple{1, 3, "3"}, {1, 2, "3 - log2(5/4)"}, {1, 1, "2"}, {0, 1, "5"}})
    CHECK(holder(scheme("UCCP", nullptr, nullptr, value(p, q))).exact == text);
}

TEST_CASE("splines of degree m + 1 are C^m and nothing more") {
  for (int m = 1; m <= 9; ++m) {
    const Word word = scheme("U" + std::string(static_cast<std::size_t>(m), 'D'));
    CHECK(holder(word).exact == std::to_string(m + 1));
    check_certified(prove_smooth(word, m), Verdict::proved);
    check_certified(prove_smooth(word, m + 1), Verdict::refuted);
  }
}

TEST_CASE("the convergence of UCP needs |1 + delta (omega - 1)| < 4 (1 + f)") {
  const auto word = [](const Rational& omega) { return scheme("UCP", value(1, 2), constant(omega), value(1, 2)); };
  check_certified(prove_converges(word(ratio(109, 10))), Verdict::proved);  // (1 + omega)/2 < 6
  check_certified(prove_converges(word(Rational(11))), Verdict::refuted);
}

TEST_CASE("irrational parameters are proved with their own numbers") {
  const KernelPtr root_two =
      formula([](const auto& c) { return sqrt(std::decay_t<decltype(c.alpha)>(2)); }, Needs{false, false, false});
  const KernelPtr golden =
      formula([](const auto& c) { return cos(std::decay_t<decltype(c.alpha)>::pi(Rational(2) / Rational(5))); },
              Needs{false, false, false});
  for (const KernelPtr& f : {root_two, golden}) {
    const Word word = scheme("UCP", f, nullptr, value(4, 5));
    check_certified(prove_converges(word), Verdict::proved);
    check_certified(prove_smooth(word, 1), Verdict::proved);
    CHECK(prove_smooth(word, 2).verdict == Verdict::refuted);  // two sum rules
    const Regularity regularity = holder(word);
    check_certified(regularity.result, Verdict::proved);
    CHECK(regularity.at_most.has_value());
    CHECK(regularity.smoothness == 1);
    CHECK(limit_stencils(word).tangent.has_value());
  }
}

TEST_CASE("words that are out of reach say why") {
  const auto e = formula([](const auto& c) { return exp(std::decay_t<decltype(c.alpha)>(1)); }, Needs{false, false, false});
  const Result inexact = prove_converges(scheme("UCP", e));
  CHECK(inexact.verdict == Verdict::undecided);
  CHECK(inexact.reason.find("exact") != std::string::npos);
  const Result varying = prove_converges(oracle::circle(5, "UCP", Rational(1)));
  CHECK(varying.verdict == Verdict::undecided);
  CHECK(holder(oracle::circle(5, "UCP", Rational(1))).result.verdict == Verdict::undecided);
  check_certified(prove_smooth(static_limit(oracle::circle(5, "UCP", Rational(1))), 1), Verdict::proved);
  CHECK_THROWS_AS((void)prove_smooth(scheme("UC"), -1), Error);
  CHECK_THROWS_AS((void)prove_smooth(scheme("UC"), 1001), Error);
  CHECK_THROWS_AS((void)prove_converges(oracle::operation("UC")), Error);
  CHECK_THROWS_AS((void)prove_converges(scheme("UDP")), Error);
}

TEST_CASE("unstable words are not refuted by what needs stability") {
  const Word word = scheme("UC", value(0));  // (1 + z)^2 (1 + z^2)/4
  check_certified(prove_smooth(word, 1), Verdict::proved);
  const Result second = prove_smooth(word, 2);
  CHECK(second.verdict == Verdict::undecided);
  CHECK(second.reason.find("stable") != std::string::npos);
  const Regularity regularity = holder(word);
  CHECK(regularity.exact.empty());
  CHECK_FALSE(regularity.at_most.has_value());
  check_certified(regularity.result, Verdict::proved);
}

TEST_CASE("a refutation of the rounds does not refute a word with a head") {
  Word word = four_point(309, 1600);
  word.head = oracle::items("UC");
  CHECK(prove_smooth(word, 1).verdict == Verdict::undecided);
  CHECK_FALSE(holder(word).at_most.has_value());
  Word smooth = scheme("UC");
  smooth.head = oracle::items("UCP");
  check_certified(prove_smooth(smooth, 2), Verdict::proved);
}

TEST_CASE("large words end soon and without a crash") {
  SearchLimits limits;
  limits.seconds = 2;
  const Word spline = scheme("U" + std::string(60, 'C'));
  CHECK(holder(spline, limits).exact == "121");
  CHECK(prove_smooth(spline, 120, limits).verdict == Verdict::proved);
  CHECK(prove_smooth(scheme("U9U9C"), 1, limits).verdict == Verdict::proved);
  const Word wide = scheme("U" + std::string(20, 'C') + "P", value(1, 3), value(1), value(1, 2));
  CHECK(prove_converges(wide, limits).verdict == Verdict::proved);
  CHECK_FALSE(to_string(prove_smooth(wide, 7, limits).verdict).empty());
}

TEST_CASE("certificates of curves with one number or name changed are rejected") {
  std::vector<Json> sound;
  for (const Result& result : {prove_smooth(four_point(77, 400), 1), prove_smooth(four_point(1, 16), 1),
                               prove_smooth(four_point(309, 1600), 1), prove_smooth(scheme("UCP", value(2), nullptr, nullptr), 2),
                               prove_smooth(scheme("UDDD"), 3), holder(scheme("U3CP")).result, holder(scheme("UUC")).result,
                               holder(scheme("UCP", nullptr, nullptr, value(1, 2))).result}) {
    REQUIRE(result.certificate);
    sound.push_back(*result.certificate);
  }
  int changes = 0, still_proofs = 0;
  for (const Json& certificate : sound) {
    for (const std::string& pointer : oracle::leaves(certificate)) {
      for (const Json& other : oracle::other_values(certificate[Json::json_pointer(pointer)])) {
        CAPTURE(pointer);
        CAPTURE(other.dump());
        Json changed = certificate;
        changed[Json::json_pointer(pointer)] = other;
        CHECK_FALSE(verify(changed).accepted);  // the digest
        // The same with a new digest: a claim of the same sentence by other data, which then must prove it.
        if (pointer.rfind("/data", 0) != 0) continue;
        const Verification resealed = verify(seal(changed["kind"], changed["statement"], changed["data"]));
        ++changes;
        if (!resealed.accepted) continue;
        ++still_proofs;
        // Another combination for an image well inside, another product that is as good, another order: proofs as well.
        CHECK((pointer.find("/images/") != std::string::npos || pointer.find("/units/") != std::string::npos ||
               pointer.find("/product/") != std::string::npos || pointer == "/data/order"));
      }
    }
  }
  CHECK(changes > 500);
  CHECK(still_proofs * 4 < changes);
}

TEST_SUITE_END();
