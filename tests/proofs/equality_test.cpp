// Equal words, on curves and on meshes; and circles (Theorem 1 of the push-back paper).
#include <doctest/doctest.h>

#include "proofs/circle.h"
#include "proofs/closed_form.h"
#include "proofs/equality.h"
#include "tests/oracle/words.h"

using namespace udcp;
using oracle::ratio;

namespace {

Word fixed(const std::string& atoms, KernelPtr f = nullptr, KernelPtr omega = nullptr, KernelPtr delta = nullptr) {
  return static_limit(oracle::scheme(atoms, std::move(f), std::move(omega), std::move(delta)));
}

KernelPtr half_cosine() { return kernel_from("(cos (/ alpha 2))"); }
KernelPtr secant() { return kernel_from("(/ 1 (cos (/ alpha 2)))"); }

}  // namespace

TEST_SUITE_BEGIN("proofs");

TEST_CASE("two averages are a convolution everywhere") {
  CHECK(prove_equal(fixed("UDD"), fixed("UC"), {}).verdict == Verdict::proved);
  const Result meshes = prove_equal(fixed("UDD"), fixed("UC"), {3, 4, 5, 6});
  CHECK(meshes.verdict == Verdict::proved);
  REQUIRE(meshes.certificate);
  CHECK(verify(*meshes.certificate).accepted);
}

TEST_CASE("UCP and UCCP interpolate alike on curves and differ on meshes") {
  CHECK(prove_equal(fixed("UCP"), fixed("UCCP"), {}).verdict == Verdict::proved);
  const Result meshes = prove_equal(fixed("UCP"), fixed("UCCP"), {4});
  CHECK(meshes.verdict == Verdict::refuted);
  CHECK_FALSE(meshes.witness.is_null());
}

TEST_CASE("the push-back with delta -1/2 is the quintic B-spline") {
  CHECK(prove_equal(fixed("UCP", nullptr, nullptr, oracle::value(-1, 2)), fixed("UCC"), {}).verdict == Verdict::proved);
  CHECK(prove_equal(fixed("UCP", nullptr, nullptr, oracle::value(-1, 3)), fixed("UCC"), {}).verdict == Verdict::refuted);
}

TEST_CASE("two rounds of one word may be one round of another") {
  const Result result = prove_equal(fixed("UCUC"), fixed("UC"), {});
  CHECK(result.verdict == Verdict::proved);
  CHECK(prove_equal(fixed("UUC"), fixed("UC"), {}).verdict == Verdict::refuted);
  CHECK(prove_equal(fixed("U3C"), fixed("UC"), {}).verdict == Verdict::undecided);  // never as many points
}

TEST_CASE("with a symbol for f the identities hold for every f") {
  CHECK(prove_equal(fixed("UDD", symbol("x")), fixed("UC", symbol("x")), {}).verdict == Verdict::proved);
  CHECK(prove_equal(fixed("UDD", symbol("x")), fixed("UC", symbol("y")), {}).verdict == Verdict::refuted);
  const Word functions = oracle::scheme("UCP", half_cosine(), secant());
  CHECK(prove_equal(with_symbols(functions), with_symbols(functions), {}).verdict == Verdict::proved);
}

TEST_CASE("regular polygons become circles for every delta and any number of C") {
  for (const char* atoms : {"UCP", "UCCP", "UCCCP"}) {
    CAPTURE(atoms);
    const Result result = prove_circle(oracle::scheme(atoms, half_cosine(), secant(), symbol("delta")));
    CHECK(result.verdict == Verdict::proved);
    REQUIRE(result.certificate);
    CHECK(verify(*result.certificate).accepted);
  }
}

TEST_CASE("the radius factor is that of the theorem") {
  // rho + delta (1 - rho), rho = cos(alpha/2) cos(alpha/4)^(2(k - 1)), and cos(alpha/4)^2 = (1 + c)/2
  const Parametric c = Parametric::variable("X"), delta = Parametric::variable("delta");
  Parametric rho = c;
  for (const char* atoms : {"UCP", "UCCP", "UCCCP"}) {
    const CircleRound round = circle_round(oracle::scheme(atoms, half_cosine(), secant(), symbol("delta")));
    CHECK(round.factor == rho + delta * (Parametric(1) - rho));
    CHECK_FALSE(round.dual);
    rho = rho * (Parametric(1) + c) / Parametric(2);
  }
}

TEST_CASE("the limit radius is the value of the table and the sine formula") {
  const Interval pentagon = circle_radius(oracle::scheme("UCP", half_cosine(), secant(), oracle::value(4, 5)), 5);
  CHECK(pentagon.midpoint() == doctest::Approx(0.949262570531767).epsilon(1e-14));
  CHECK(pentagon.width() < 1e-30);
  // delta = 0: r sin(th)/th with th = 2 pi/K
  const Interval th = Interval(2) * Interval::pi() / Interval(7);
  const Interval spline = circle_radius(oracle::scheme("UC", half_cosine()), 7);
  CHECK((spline - sin(th) / th).contains_zero());
  const Interval cubic = circle_radius(oracle::scheme("UD", half_cosine()), 7);  // m = 1: one factor less
  CHECK((cubic - sin(th) / th * (th / Interval(2)) / sin(th / Interval(2))).contains_zero());
  CHECK(circle_radius(oracle::scheme("UCP", half_cosine(), secant()), 9) == Interval(1));
}

TEST_CASE("words that keep no circles are refuted") {
  CHECK(prove_circle(oracle::scheme("UCP", half_cosine(), half_cosine(), oracle::value(1, 2))).verdict == Verdict::refuted);
  CHECK(prove_circle(oracle::scheme("UC")).verdict == Verdict::refuted);
  CHECK(prove_circle(oracle::scheme("UD")).verdict == Verdict::refuted);
  CHECK(prove_circle(oracle::scheme("UC", kernel_from("(cos alpha)"))).verdict == Verdict::undecided);
  CHECK_THROWS_AS((void)circle_radius(oracle::scheme("UC"), 5), Error);
}

TEST_SUITE_END();
