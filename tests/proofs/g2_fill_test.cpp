// The G2 fill in exact numbers: proofs by valence, printed formulas refuted, and certificates in which every entry counts.
#include "proofs/g2_fill.h"

#include <doctest/doctest.h>

#include <cmath>
#include <fstream>

#include "operators/methods/filling/fill_mask.h"
#include "operators/schemes.h"
#include "tests/oracle/words.h"

using namespace udcp;

namespace {

/// The certificate with other data, sealed again.
bool accepted(const Json& certificate, const Json& data) {
  return verify(seal(certificate["kind"].get<std::string>(), certificate["statement"].get<std::string>(), data)).accepted;
}

Points<Algebraic> exact_weights(int n) { return weights_of(outer_series(n)); }

}  // namespace

TEST_SUITE("proofs") {
  TEST_CASE("the fill of Catmull-Clark joins with G2 for valences 3 to 8") {
    const std::vector<int> freedom{34, 49, 51, 61, 69, 78};  // the table of ranks, from 60 digits
    for (int n = 3; n <= 8; ++n) {
      CAPTURE(n);
      const Result result = prove_g2(schemes::catmull_clark(), n);
      CAPTURE(result.reason);
      REQUIRE(result.verdict == Verdict::proved);  // only after the checker has accepted the certificate
      CHECK(result.details["freedom"] == freedom[static_cast<std::size_t>(n - 3)]);
      CHECK(result.details["freedom"] == make_fill_mask(n).freedom);
      CHECK(result.claim.find("around vertices of valence " + std::to_string(n)) == 0);
    }
  }

  TEST_CASE("the equations at every frequency have the ranks of the table and solutions that meet the joins") {
    const std::vector<std::vector<int>> table{{13, 14}, {12, 13, 13}, {14, 15, 15}, {14, 15, 15, 15}};
    for (int n = 3; n <= 6; ++n) {
      CAPTURE(n);
      for (int f = 0; 2 * f <= n; ++f) {
        const FrequencyFacts facts = frequency_facts(n, f, exact_weights(n));
        CHECK(facts.rank == table[static_cast<std::size_t>(n - 3)][static_cast<std::size_t>(f)]);
        CHECK(facts.consistent);
        CHECK(facts.residuals_vanish);
        CHECK(facts.fairness_decides);
      }
    }
  }

  TEST_CASE("a word with another regular part has no proof") {
    const Word interpolating = oracle::scheme("UCP", oracle::value(1), oracle::value(1), oracle::value(1));
    CHECK(prove_g2(interpolating, 5).verdict == Verdict::undecided);
    CHECK(prove_g2(schemes::loop(), 5).verdict == Verdict::undecided);
    // adjustable with c = 1/4: cubic joins of order 1 only
    Word adjustable = schemes::catmull_clark();
    adjustable.tail[1].f = Directional<KernelPtr>::all(oracle::value(3));
    CHECK(prove_g2(adjustable, 5).verdict == Verdict::undecided);
    // another rule for extraordinary vertices has the same ring, so the same fill
    Word other = schemes::catmull_clark();
    other.tail[2].delta =
        formula([](const auto& c) { return decltype(c.alpha)(c.valence - 4) / (2 * c.valence); }, {true, false, false});
    CHECK(prove_g2(other, 5).verdict == Verdict::proved);
  }

  TEST_CASE("formulas as printed are refuted at every valence where they differ") {
    for (int n = 3; n <= 8; ++n) {
      for (const std::string& name : print_names()) {
        CAPTURE(n);
        CAPTURE(name);
        const Result result = prove_g2_as_printed(n, *print_named(name));
        // cos(2 pi/4) is 0, so that -3c and -2c are the same
        if (n == 4 && name == "psi_y_uu") {
          CHECK(result.verdict == Verdict::undecided);
          CHECK(result.reason == "the printed formula and the corrected one agree at this valence");
          continue;
        }
        REQUIRE(result.verdict == Verdict::refuted);
        CHECK(verify(*result.certificate).accepted);
        CHECK(result.witness["failure"] == result.reason);
      }
    }
    CHECK_FALSE(print_named("psi").has_value());
    CHECK(contradiction(5, Print::none).empty());
    CHECK(outer_residual(outer_series(5), exact_weights(5)).empty());
  }

  TEST_CASE("refutations name what fails") {
    CHECK(prove_g2_as_printed(5, Print::net).reason == "the equations of the joins contradict each other at frequency 0");
    CHECK(prove_g2_as_printed(4, Print::phi).reason == "sec(2 pi/4) is infinite");
    CHECK(prove_g2_as_printed(5, Print::phi).reason == "P_i(0,t) and P_(i+1)(t,0) differ at t = 0 on the flat surface");
    CHECK(prove_g2_as_printed(5, Print::psi_y_uu).reason ==
          "point (1,1) of the net: the first derivative on v = 1 is not that of the ring");
  }

  TEST_CASE("the printed derivative of psi begins with -1/2 where the matrix of psi gives 1") {
    const OuterSeries printed = outer_series(5, Print::psi_x_u), right = outer_series(5);
    CHECK(printed.x[1].at(Algebraic(0)) == Algebraic(Rational(1) / Rational(2)));  // -x_u
    CHECK(right.x[1].at(Algebraic(0)) == Algebraic(-1));
    CHECK_FALSE(is_regular_outside(printed));
    CHECK(is_regular_outside(right));
  }

  TEST_CASE("the exact mask of valence 3 is that of the reference fractions") {
    const Json data = Json::parse(std::ifstream(UDCP_TEST_DATA "/g2-filling.json"));
    const Points<Algebraic> mask = exact_fill_mask(3);
    int compared = 0;
    for (const auto& [row, weights] : data["g2"][0]["mask_patch0_exact"].items())
      for (std::size_t k = 0; k < weights.size(); ++k, ++compared)
        CHECK(mask(std::stoi(row), static_cast<Eigen::Index>(k)) == Algebraic(Rational::parse(weights[k].get<std::string>())));
    CHECK(compared == 3 * 19);
  }

  TEST_CASE("rows of exact masks sum to 1 and the running masks are near them") {
    for (const int n : {3, 4, 5, 6, 8}) {
      CAPTURE(n);
      const Points<Algebraic> mask = exact_fill_mask(n);
      const Points<double> running = make_fill_mask(n).weights;
      double worst = 0;
      for (Eigen::Index row = 0; row < mask.rows(); ++row) {
        Algebraic sum(0);
        for (Eigen::Index k = 0; k < mask.cols(); ++k) {
          sum += mask(row, k);
          worst = std::max(worst, std::abs(mask(row, k).to_double() - running(row, k)));
        }
        CHECK(sum == Algebraic(1));
      }
      CHECK(worst <= 2e-13);  // double precision against 60 digits: about 1e-13
    }
  }

  TEST_CASE("every wrong weight and every wrong equation is noticed") {
    Points<Algebraic> weights = exact_weights(5);
    for (const int point : {56 + 3, 48 + 2, 40 + 4, 3 * 8 + 5, 7 * 8 + 7}) {
      Points<Algebraic> changed = weights;
      changed(point, 5) += Algebraic(Rational(1) / Rational(1'000'000'000));
      CHECK_FALSE(outer_residual(outer_series(5), changed).empty());
    }
    // Boundary data that do not fit inside: the corner of the hole lifted alone.
    weights(56, 9) += Algebraic(1);
    CHECK_FALSE(frequency_facts(5, 0, weights).consistent);
  }

  TEST_CASE("the conditions of the joins mean G2 for every valence") {
    for (int n = 3; n <= 10; ++n) CHECK(conditions_mean_g2(n));
  }

  TEST_CASE("certificates of fills do not survive changes") {
    const Json certificate = *prove_g2(schemes::catmull_clark(), 6).certificate;
    const Json& data = certificate["data"];
    REQUIRE(accepted(certificate, data));
    const auto changed = [&](auto change) {
      Json other = data;
      change(other);
      return accepted(certificate, other);
    };
    for (std::size_t f = 0; f < 4; ++f) {
      CHECK_FALSE(changed([&](Json& d) { d["ranks"][f] = d["ranks"][f].get<int>() + 1; }));
      CHECK_FALSE(changed([&](Json& d) { d["ranks"][f] = d["ranks"][f].get<int>() - 1; }));
    }
    CHECK_FALSE(changed([](Json& d) { d["valence"] = 7; }));
    CHECK_FALSE(changed([](Json& d) { d["valence"] = 2; }));
    CHECK_FALSE(changed([](Json& d) { d["valence"] = "5"; }));
    CHECK_FALSE(changed([](Json& d) { d["ranks"].push_back(16); }));
    CHECK_FALSE(changed([](Json& d) { d["ranks"] = 14; }));
    for (const char* bound : {"1/100000000000000000", "0", "-1", "2", "2/1000", "1/1000", "1/10000000000000"})
      CHECK_FALSE(changed([&](Json& d) { d["mask_error"] = bound; }));
    CHECK_FALSE(changed([](Json& d) { d["more"] = 1; }));
    CHECK_FALSE(changed([](Json& d) { d.erase("ranks"); }));
    CHECK_FALSE(changed([](Json& d) { d["word"]["items"][1]["f"] = "2"; }));
    CHECK_FALSE(changed([](Json& d) { d["word"]["items"][2]["omega"] = "1"; }));
    CHECK_FALSE(changed([](Json& d) { d["word"]["triangles"] = true; }));
    const Json print = *prove_g2_as_printed(5, Print::psi_y_uu).certificate;
    REQUIRE(accepted(print, print["data"]));
    const auto print_changed = [&](const Json& other) { return accepted(print, other); };
    CHECK_FALSE(print_changed({{"valence", 4}, {"print", "psi_y_uu"}}));
    CHECK_FALSE(print_changed({{"valence", 5}, {"print", "psi_x_u"}}));
    CHECK_FALSE(print_changed({{"valence", 5}, {"print", ""}}));
    CHECK_FALSE(print_changed({{"valence", 5}, {"print", 3}}));
    CHECK_FALSE(print_changed({{"valence", 5}}));
    CHECK(verify(seal("g2-print", print_statement(4, Print::psi_y_uu, ""), {{"valence", 4}, {"print", "psi_y_uu"}})).accepted ==
          false);
  }

  TEST_CASE("valences without an exact fill are refused and a proof stops when told to") {
    for (const int n : {2, 11}) CHECK_THROWS_AS((void)prove_g2(schemes::catmull_clark(), n), Error);
    const std::atomic<bool> stop = true;
    SearchLimits limits;
    limits.stop = &stop;
    CHECK_THROWS_AS((void)prove_g2(schemes::catmull_clark(), 5, limits), Error);
    CHECK_THROWS_AS((void)prove_g2_as_printed(5, Print::net, limits), Error);
  }
}
