// Kernels: one formula in every number type, what it says it needs, attributes.
#include "operators/kernel.h"

#include <doctest/doctest.h>

#include "tests/oracle/refusal.h"
#include "tests/oracle/words.h"

using namespace udcp;
using namespace udcp::oracle;

TEST_SUITE("operators") {
  TEST_CASE_TEMPLATE("a constant has its value in every number type and needs nothing", S, double, Rational, Algebraic,
                     Interval) {
    const KernelPtr kernel = constant(ratio(4, 5));
    CHECK(kernel->at(Context<S>{}).exact() == ratio(4, 5));
    CHECK(approximate(kernel->at(Context<S>{}).value()) == 0.8);
    CHECK_FALSE(kernel->needs().valence);
    CHECK_FALSE(kernel->needs().vertex);
    CHECK_FALSE(kernel->needs().round);
  }

  TEST_CASE_TEMPLATE("a formula sees alpha and N and h and the vertex", S, double, Rational, Algebraic, Interval) {
    const KernelPtr kernel = formula([](const auto& c) {
      return cos(c.alpha / Rational(2)) + Rational(c.valence) + Rational(10 * c.round) + Rational(100 * c.vertex);
    });
    Context<S> context;
    context.alpha = Quantity<S>::pi(ratio(2, 3));
    context.valence = 5;
    context.round = 2;
    context.vertex = 3;
    CHECK(kernel->at(context).exact() == ratio(651, 2));  // 1/2 + 5 + 20 + 300
    CHECK(kernel->needs().valence);
    CHECK(kernel->needs().round);
    CHECK_FALSE(kernel->needs().vertex);
  }

  TEST_CASE("a formula without a value in the number type says so") {
    Context<Rational> context;
    context.alpha = Quantity<Rational>::pi(ratio(2, 5));
    CHECK(refusal([&] { (void)half_cosine()->at(context); }).starts_with("E_NOT_EXACT"));
    Context<Algebraic> wider;
    wider.alpha = Quantity<Algebraic>::pi(ratio(2, 5));
    CHECK(half_cosine()->at(wider).value() == cosine<Algebraic>(ratio(1, 5)));
  }

  TEST_CASE("attributes are read at the point and their absence is an error") {
    const std::map<std::string, std::vector<Rational>> columns{{"w", {Rational(3), ratio(-1, 2)}}};
    Context<Rational> context;
    context.attributes = &columns;
    context.vertex = 1;
    CHECK(context.attribute("w").exact() == ratio(-1, 2));
    CHECK(refusal([&] { (void)context.attribute("u"); }) == "E_ATTRIBUTE: the points have no attribute 'u'");
    context.vertex = -1;
    CHECK(refusal([&] { (void)context.attribute("w"); }) == "E_ATTRIBUTE: the points have no attribute 'w'");
    CHECK(refusal([] { (void)Context<double>{}.attribute("w"); }) == "E_ATTRIBUTE: the points have no attribute 'w'");
  }

  TEST_CASE("a directional value answers per tag") {
    const Directional<int> d{1, 2, 3};
    CHECK(d.at(EdgeTag::none) == 1);
    CHECK(d.at(EdgeTag::latitude) == 2);
    CHECK(d.at(EdgeTag::longitude) == 3);
    CHECK(Directional<int>::all(7).at(EdgeTag::latitude) == 7);
  }
}
