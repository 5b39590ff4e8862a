// C^1 at extraordinary points: expected verdicts, false claims, mutated certificates.
#include "proofs/surface_c1.h"

#include <doctest/doctest.h>

#include <cstdlib>

#include "proofs/checkers.h"
#include "proofs/closed_form.h"
#include "proofs/static_word.h"
#include "tests/proofs/surface_words.h"

using namespace udcp;
using oracle::ratio;
using oracle::value;

namespace {

void check_valence(const std::string& name, const Word& word, const Json& at) {
  const int n = at["n"];
  CAPTURE(name);
  CAPTURE(n);
  const Result result = prove_surface_c1(word, n);
  CAPTURE(result.reason);
  CHECK((result.verdict == Verdict::proved) == at["C1"].get<bool>());
  if (result.verdict != Verdict::proved) return;
  REQUIRE(result.certificate.has_value());
  CHECK(verify(*result.certificate).accepted);
  const double lambda = at["lambda"];
  CHECK(std::stod(result.details["lambda"]["lo"].get<std::string>()) == doctest::Approx(lambda).epsilon(1e-14));
  CHECK(std::stod(result.details["lambda"]["hi"].get<std::string>()) == doctest::Approx(lambda).epsilon(1e-14));
  CHECK(std::stod(result.details["others"].get<std::string>()) >= at["mu"].get<double>() * (1 - 1e-5));
  CHECK((*result.certificate)["data"]["regular"]["rounds"] == result.details["regular"]["rounds"]);
}

/// Table 1 of the push-back paper, row e: the static limit f = 1/100, omega = 1, delta = 4/5.
Word row_e() { return oracle::scheme("UCP", value(1, 100), value(1), value(4, 5)); }

/// Every number and every character of the data changed in turn, one at a time.
void for_each_change(const Json& data, const std::function<void(const Json&, const std::string&)>& visit) {
  const Json flat = data.flatten();
  for (const auto& [pointer, leaf] : flat.items()) {
    const Json::json_pointer where(pointer);
    Json changed = data;
    if (leaf.is_number()) {
      changed[where] = leaf.get<int>() + 1;
      visit(changed, pointer);
    } else if (leaf.is_boolean()) {
      changed[where] = !leaf.get<bool>();
      visit(changed, pointer);
    } else if (leaf.is_string()) {
      const auto text = leaf.get<std::string>();
      for (std::size_t k = 0; k < text.size(); ++k) {
        std::string other = text;
        other[k] = text[k] == '1'                    ? '0'
                   : text[k] == '0'                  ? '1'
                   : text[k] >= '2' && text[k] < '9' ? static_cast<char>(text[k] + 1)
                                                     : '4';
        changed[where] = other;
        visit(changed, pointer);
      }
      changed[where] = text + "0";
      visit(changed, pointer);
      changed[where] = nullptr;
      visit(changed, pointer);
    }
    changed = data;
    Json& parent = changed[where.parent_pointer()];
    if (parent.is_array())
      parent.push_back(leaf);
    else
      parent["more"] = leaf;
    visit(changed, pointer);
  }
}

void check_changes(const Result& result) {
  REQUIRE(result.certificate.has_value());
  const Json& sound = *result.certificate;
  REQUIRE(verify(sound).accepted);
  int changes = 0;
  for_each_change(sound["data"], [&](const Json& data, const std::string& pointer) {
    CAPTURE(pointer);
    CAPTURE(data.dump());
    ++changes;
    CHECK_FALSE(verify(seal(sound["kind"], sound["statement"], data)).accepted);
  });
  CHECK(changes > 10);
  Json unsealed = sound;
  unsealed["data"]["valence"] = 4;
  CHECK_FALSE(verify(unsealed).accepted);
}

}  // namespace

TEST_SUITE_BEGIN("proofs");

TEST_CASE("surfaces are C1 where they are expected to be") {
  // All expected values with UDCP_SLOW_TESTS set; otherwise those of the fast words, and the others at a few valences.
  const bool all = std::getenv("UDCP_SLOW_TESTS") != nullptr;
  const std::map<std::string, std::vector<int>> some{{"zorin-schroeder-4", {3, 5}},
                                                     {"zorin-schroeder-3", {3, 6}},
                                                     {"interpolating-k1", {3, 5}},
                                                     {"interpolating-k2", {4}},
                                                     {"half", {3, 8}},
                                                     {"interpolating-triangles", {3, 4}}};
  const auto words = oracle::surface_words();
  for (const auto& [name, values] : oracle::surface_values()["schemes"].items()) {
    const auto few = some.find(name);
    for (const auto& at : values["valence"]) {
      const bool listed = few == some.end() || std::count(few->second.begin(), few->second.end(), at["n"].get<int>()) > 0;
      if (all || listed) check_valence(name, words.at(name), at);
    }
  }
}

TEST_CASE("ranges of valences are proved one by one") {
  const std::vector<Result> results = prove_surface_c1(oracle::catmull_clark(), std::vector<int>{13, 20, 30});
  REQUIRE(results.size() == 3);
  for (const Result& result : results) CHECK(result.verdict == Verdict::proved);
  CHECK(results[1].claim.find("valence 20") != std::string::npos);
  CHECK(prove_surface_c1(oracle::loop(), 20).verdict == Verdict::proved);
}

TEST_CASE("a larger eigenvalue of frequency 0 refutes C1") {
  const Result refuted = prove_surface_c1(row_e(), 3);
  CHECK(refuted.verdict == Verdict::refuted);
  REQUIRE(refuted.certificate.has_value());
  CHECK((*refuted.certificate)["kind"] == "surface-spectrum");
  CHECK(refuted.claim.find("valence 3") != std::string::npos);
  CHECK(refute_surface_spectrum(row_e(), 3).verdict == Verdict::refuted);
  CHECK(prove_surface_c1(row_e(), 4).verdict == Verdict::proved);
  CHECK(refute_surface_spectrum(row_e(), 4).verdict == Verdict::undecided);
}

TEST_CASE("a double eigenvalue leaves C1 undecided with a certificate") {
  const Word word = oracle::on_triangles(oracle::scheme("UCP"));
  const Result result = prove_surface_c1(word, 3);
  CHECK(result.verdict == Verdict::undecided);
  CHECK(result.reason.find("1/4, a multiple eigenvalue") != std::string::npos);
  REQUIRE(result.certificate.has_value());
  CHECK(verify(*result.certificate).accepted);
  CHECK(refute_surface_spectrum(word, 3).verdict == Verdict::refuted);
}

TEST_CASE("words that are not C1 are not proved") {
  const auto verdict = [](const Word& word, int n) { return prove_surface_c1(word, n).verdict; };
  CHECK(verdict(oracle::scheme("U"), 5) == Verdict::undecided);  // bilinear patches
  CHECK(verdict(oracle::on_triangles(oracle::scheme("U")), 6) == Verdict::undecided);
  CHECK(verdict(oracle::scheme("UCP", nullptr, nullptr, value(4)), 4) != Verdict::proved);  // beyond w = 0.19 on curves
  CHECK(verdict(oracle::scheme("UCP", nullptr, value(2)), 5) != Verdict::proved);           // not factorable
  CHECK(verdict(oracle::scheme("UCUC"), 5) == Verdict::undecided);                          // two U
  CHECK(verdict(oracle::scheme("UC"), 2) == Verdict::undecided);
  CHECK(verdict(oracle::scheme("UC"), 100'000) == Verdict::undecided);
  CHECK(verdict(oracle::scheme("UCP", oracle::half_cosine()), 5) == Verdict::undecided);  // changes with the rounds
  CHECK(verdict(oracle::operation("UC"), 5) == Verdict::undecided);
  // Catmull-Clark with delta so large at valence 5 that the vertex runs away from its ring: frequency 0 dominates.
  const KernelPtr delta =
      formula([](const auto& c) { return c.valence == 4 ? Rational(0) : Rational(-3); }, {true, false, false});
  CHECK(verdict(oracle::scheme("UCP", nullptr, value(0), delta), 5) == Verdict::refuted);
}

TEST_CASE("certificates of surfaces with anything changed are rejected") {
  check_changes(prove_surface_c1(oracle::scheme("UD"), 3));
  check_changes(prove_surface_c1(oracle::catmull_clark(), 5));
  check_changes(prove_surface_c1(row_e(), 3));
  check_changes(prove_surface_c1(oracle::on_triangles(oracle::scheme("UCP")), 3));
}

TEST_CASE("certificates of one surface do not serve another") {
  Json data = (*prove_surface_c1(oracle::catmull_clark(), 5).certificate)["data"];
  const Json other = (*prove_surface_c1(oracle::scheme("UC"), 5).certificate)["data"];
  // UC has the same blocks but the one of frequency 0, and the same characteristic map: only the word tells them apart.
  CHECK(data["eigenpair"] == other["eigenpair"]);
  data["word"] = other["word"];
  CHECK(check_surface_c1(data) == check_surface_c1(other));
  data["valence"] = 6;
  CHECK_THROWS_AS((void)check_surface_c1(data), Rejected);
  const Json linear = {{"triangles", false}, {"items", {{{"atom", "U"}, {"sections", 2}}}}};
  data["valence"] = 5;
  data["word"] = linear;
  CHECK_THROWS_AS((void)check_surface_c1(data), Rejected);
  // A function of alpha that is 1 at alpha = 0 would have these very rows in the first round.
  const Word varying = oracle::scheme("UC", kernel_from("(cos (/ alpha 2))"));
  data["word"] = to_json(varying, {4});
  CHECK_THROWS_AS((void)check_surface_c1(data), Rejected);
}

TEST_CASE("searches on surfaces stop where they are told to") {
  const std::atomic<bool> stop{true};
  SearchLimits limits;
  limits.stop = &stop;
  CHECK_THROWS_AS((void)prove_surface_c1(oracle::scheme("UCP"), 5, limits), Error);
  limits.stop = nullptr;
  limits.seconds = 0;
  CHECK(prove_surface_c1(oracle::scheme("UCP"), 5, limits).verdict == Verdict::undecided);
  limits.seconds = 60;
  limits.nodes = 3;
  const Result result = prove_surface_c1(oracle::scheme("UCP"), 5, limits);
  CHECK(result.verdict == Verdict::undecided);
  CHECK(result.reason.find("limit of cells") != std::string::npos);
}

TEST_SUITE_END();
