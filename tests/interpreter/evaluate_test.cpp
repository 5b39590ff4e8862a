// Expressions in the number types: exactness, closures, limits.
#include <doctest/doctest.h>

#include "grammar/parse.h"
#include "interpreter/evaluate.h"
#include "interpreter/session.h"

namespace {

using namespace udcp;

Environment scope_of(const std::string& definitions) {
  static std::vector<Session> sessions;
  sessions.emplace_back();
  sessions.back().run(definitions);
  Environment scope;
  for (const std::string& name : sessions.back().names()) scope.names.emplace(name, *sessions.back().find(name));
  return scope;
}

template <class S>
Quantity<S> value(const std::string& text, const Context<S>& context = {}, const Environment& scope = {}) {
  return evaluate(*grammar::parse_expression(text), context, scope);
}

std::string code_of(const std::string& text, const Environment& scope = {}) {
  try {
    (void)value<Algebraic>(text, {}, scope);
  } catch (const Error& error) {
    return error.code;
  }
  return "";
}

KernelPtr kernel(const std::string& text, const std::string& definitions = "") {
  auto scope = std::make_shared<Environment>(scope_of(definitions));
  return make_kernel({grammar::parse_expression(text), scope, "", "", nullptr, {}});
}

}  // namespace

TEST_SUITE("interpreter") {
  TEST_CASE_TEMPLATE("rational expressions have the same value in every number type", S, double, Rational, Algebraic, Interval) {
    CHECK(value<S>("1/3 + 0.25").exact() == Rational(7) / Rational(12));
    CHECK(value<S>("-2^2").exact() == Rational(-4));
    CHECK(value<S>("2^-3").exact() == Rational(1) / Rational(8));
    CHECK(value<S>("cos(2*pi/6)").exact() == Rational(1) / Rational(2));
    CHECK(value<S>("if 1 < 2 and not 3 == 4 then 5 else 6").exact() == Rational(5));
    CHECK(value<S>("min(3, 1, 2) + max(4, 5)").exact() == Rational(6));
    CHECK(value<S>("[7, 8, 9][1]").exact() == Rational(8));
  }

  TEST_CASE("variables come from the context") {
    Context<Rational> context;
    context.alpha = Quantity<Rational>(Rational(3));
    context.valence = 5;
    context.round = 2;
    const std::map<std::string, std::vector<Rational>> attributes = {{"w", {Rational(10), Rational(20)}}};
    context.attributes = &attributes;
    context.vertex = 1;
    CHECK(value("alpha + N/h + v.w", context).exact() == Rational(3) + Rational(5) / Rational(2) + Rational(20));
  }

  TEST_CASE("parameters of calls go before the variables of formulas and other bindings after them") {
    Context<Rational> context;
    context.valence = 7;
    Environment scope = scope_of("k = 2\nN = 3");
    CHECK(value("N + k", context, scope).exact() == Rational(9));
    scope.frame = true;
    CHECK(value("N + k", context, scope).exact() == Rational(5));
  }

  TEST_CASE("user functions run inside formulas") {
    const Environment scope = scope_of("g(x) = x/2\nf(n) = if n == 0 then 1 else n*f(n - 1)\nlist = [1, 4, 9]");
    CHECK(value<Rational>("g(g(8))", {}, scope).exact() == Rational(2));
    CHECK(value<Rational>("f(10)", {}, scope).exact() == Rational(3628800));
    CHECK(value<Rational>("list[2]", {}, scope).exact() == Rational(9));
  }

  TEST_CASE("a function without an end is stopped") {
    CHECK(code_of("f(1)", scope_of("f(n) = f(n + 1)")) == "E_CALL_DEPTH");
    CHECK(code_of("f(0)", scope_of("f(n) = if n > 60 then 1 else f(n + 1) + f(n + 1)")) == "E_STEPS");
  }

  TEST_CASE("a function that squares without end is stopped before memory is") {
    CHECK(code_of("f(3, 0)", scope_of("f(x, n) = if n > 100 then x else f(x*x, n + 1)")) == "E_NUMBER_SIZE");
  }

  TEST_CASE("errors of formulas carry their place") {
    try {
      (void)value<Rational>("1 + 2/(3 - 3)");
      FAIL("no error");
    } catch (const Located& error) {
      CHECK(error.code == "E_DIV0");
      CHECK(error.span == grammar::Span{4, 13});
    }
    CHECK(code_of("foo + 1") == "E_NAME");
    CHECK(code_of("1 + (2 < 3)") == "E_TYPE");
    CHECK(code_of("if 1 then 2 else 3") == "E_TYPE");
    CHECK(code_of("cos(1, 2)") == "E_ARGUMENTS");
    CHECK(code_of("g(1)", scope_of("g(x, y) = x")) == "E_ARGUMENTS");
    CHECK(code_of("[1, 2][2]") == "E_INDEX");
    CHECK(code_of("noise(1)") == "E_NAME");
  }

  TEST_CASE("a kernel says what it depends on") {
    CHECK_FALSE(kernel("1/2")->needs().valence);
    CHECK_FALSE(kernel("1/2")->needs().round);
    CHECK(kernel("(N - 4)/N")->needs().valence);
    CHECK(kernel("g(1)", "g(x) = x + N")->needs().valence);
    CHECK(kernel("v.w")->needs().vertex);
    CHECK(kernel("1 + noise(7)")->needs().vertex);
    CHECK(kernel("cos(alpha)")->needs().round);
    CHECK(uses(*kernel("2^h")).round);
    CHECK_FALSE(uses(*kernel("2^h")).alpha);
  }

  TEST_CASE("the same formulas are recognised") {
    CHECK(same_kernel(kernel("1/2"), kernel("2/4"), 1));
    CHECK(same_kernel(kernel("1"), nullptr, 1));
    CHECK_FALSE(same_kernel(kernel("2"), nullptr, 1));
    CHECK(same_kernel(kernel("16*w*N", "w = 1/16"), kernel("16*w*N", "w = 1/16"), 1));
    CHECK_FALSE(same_kernel(kernel("16*w*N", "w = 1/16"), kernel("16*w*N", "w = 1/8"), 1));
    CHECK_FALSE(same_kernel(kernel("g(N)", "g(x) = x"), kernel("g(N)", "g(x) = 2*x"), 1));
  }

  TEST_CASE("an unknown name gets the nearest known one as a suggestion") {
    CHECK(did_you_mean("catmul_clark", {"cube", "catmull_clark"}) == "did you mean 'catmull_clark'?");
    CHECK(did_you_mean("cbue", {"cube"}) == "did you mean 'cube'?");
    CHECK(did_you_mean("xyz", {"cube"}).empty());
  }

  TEST_CASE("noise is the reproducible sequence of the specification shifted by the seed of the session") {
    Context<Rational> context;
    context.vertex = 3;
    context.round = 1;
    const auto at = [&](const std::string& text, std::uint64_t seed) {
      return evaluate(*grammar::parse_expression(text), context, Environment{}, Bounds{seed, nullptr}).exact();
    };
    CHECK(at("noise(7)", 0) == noise<Rational>(Rational(7), 1, 3).exact());
    CHECK(at("noise(7)", 5) == at("noise(12)", 0));
    CHECK(at("noise(7)", 0) != at("noise(8)", 0));
  }
}
