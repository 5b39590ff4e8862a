// The envelope of certificates, the text of their numbers, and words as data.
#include <doctest/doctest.h>

#include "operators/matrix.h"
#include "proofs/static_word.h"
#include "proofs/verdict.h"
#include "tests/oracle/words.h"

using namespace udcp;

TEST_SUITE_BEGIN("proofs");

TEST_CASE("the digest is FNV-1a of 64 bits") {
  // Test vectors of the authors of the hash (Fowler, Noll, Vo).
  CHECK(digest("") == "cbf29ce484222325");
  CHECK(digest("a") == "af63dc4c8601ec8c");
  CHECK(digest("foobar") == "85944171f73967e8");
}

TEST_CASE("an envelope with anything changed is refused") {
  const Json sound = seal("kind", "a sentence", {{"x", "1/2"}});
  CHECK_NOTHROW(check_envelope(sound));
  Json changed = sound;
  changed["data"]["x"] = "1/3";
  CHECK_THROWS_AS(check_envelope(changed), Rejected);
  changed = sound;
  changed["statement"] = "another sentence";
  CHECK_THROWS_AS(check_envelope(changed), Rejected);
  changed = sound;
  changed["version"] = 2;
  CHECK_THROWS_AS(check_envelope(changed), Rejected);
  changed = sound;
  changed["more"] = 1;
  CHECK_THROWS_AS(check_envelope(changed), Rejected);
  CHECK_THROWS_AS(check_envelope(Json::array()), Rejected);
  CHECK_FALSE(verify(sound).accepted);  // a kind that nobody can check
}

TEST_CASE("numbers of certificates have one text each") {
  CHECK(rational_from("-3/4", "x") == Rational(-3) / Rational(4));
  for (const char* wrong : {"2/4", "+1", "1/-2", "0.5", "", "1/0", " 1", "-0"}) {
    CAPTURE(wrong);
    CHECK_THROWS_AS((void)rational_from(wrong, "x"), Rejected);
  }
  CHECK_THROWS_AS((void)rational_from(1, "x"), Rejected);
  const Algebraic golden = Algebraic::cosine(Rational(1) / Rational(5));
  CHECK(algebraic_from(to_json(golden), "x") == golden);
  CHECK_THROWS_AS((void)algebraic_from({{"order", 5}, {"coefficients", {"1/2"}}}, "x"), Rejected);  // that is a plain fraction
  CHECK_THROWS_AS((void)integer_from(std::uint64_t{18446744073709551615U}, -5, 5, "x"), Rejected);
}

TEST_CASE("a word comes back from its certificate with the same mask") {
  const KernelPtr half = constant(Rational(1) / Rational(2)), three = constant(Rational(3));
  for (const char* atoms : {"UCP", "UCCP", "UUCPD", "U3CP", "UD"}) {
    CAPTURE(atoms);
    const Word word = static_limit(oracle::scheme(atoms, three, half, half));
    const Word again = word_from(to_json(word, {4}));
    CHECK(mask<Rational>(again).coefficients == mask<Rational>(word).coefficients);
    CHECK(to_json(again, {4}) == to_json(word, {4}));
  }
}

TEST_CASE("certificates of constant words carry no functions of alpha") {
  Json word = to_json(static_limit(oracle::scheme("UC")), {4});
  CHECK_NOTHROW((void)word_from(word));
  word["items"][1]["f"] = Json{{"formula", "(- 1 (* 1000 alpha))"}};
  CHECK_THROWS_AS((void)word_from(word), Rejected);
}

TEST_CASE("a deeply nested certificate is refused") {
  Json deep = 1;
  for (int k = 0; k < 100'000; ++k) deep = Json::array({std::move(deep)});
  Json certificate = seal("kind", "a sentence", {{"x", "1/2"}});
  certificate["data"] = std::move(deep);
  CHECK_FALSE(verify(certificate).accepted);
}

TEST_CASE("a sentence about a word says which average has the kernel") {
  const Word first = static_limit(oracle::scheme("UCC", oracle::value(1, 2)));
  Word second = first;
  second.tail[1].f = Directional<KernelPtr>::all(nullptr);
  second.tail[2].f_everywhere = true;
  CHECK(describe(to_json(first, {4})) == "(U C C)* where f = 1/2");
  CHECK(describe(to_json(second, {4})) == "(U C C[f = 1/2])*");
}

TEST_CASE("the static limit puts alpha to zero") {
  const Word word = oracle::scheme("UCP", oracle::half_cosine(), oracle::inverse_half_cosine());
  CHECK_FALSE(is_static(word));
  const Word limit = static_limit(word);
  CHECK(is_static(limit));
  const Mask<Rational> four_point = mask<Rational>(limit);
  CHECK(four_point.first == -3);
  CHECK(four_point.coefficients.front() == Rational(-1) / Rational(16));
}

TEST_SUITE_END();
