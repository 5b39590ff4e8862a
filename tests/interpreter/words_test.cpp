// Words as written and words as run: expansion, bindings, places of errors.
#include <doctest/doctest.h>

#include "interpreter/session.h"
#include "interpreter/words.h"

namespace {

using namespace udcp;

struct Run {
  std::vector<std::string> warnings;
  Value value;
  ProgramError error{""};
};

Run run(const std::string& text) {
  Run result;
  Session session({}, {{}, [&](const std::string& warning) { result.warnings.push_back(warning); }, {}});
  session.load_prelude();
  try {
    result.value = session.run(text);
  } catch (const ProgramError& error) {
    result.error = error;
  }
  return result;
}

WordValue word(const std::string& text) {
  const Run result = run(text);
  REQUIRE(result.value.as<WordValue>());
  return *result.value.as<WordValue>();
}

/// The value of a kernel at alpha = 2, N = 5.
Rational at(const KernelPtr& kernel) {
  REQUIRE(kernel);
  Context<Rational> context;
  context.alpha = Quantity<Rational>(Rational(2));
  context.valence = 5;
  return kernel->at(context).exact();
}

std::string error_text(const ProgramError& error) {
  return error.source.substr(error.span.begin, error.span.end - error.span.begin);
}

}  // namespace

TEST_SUITE("interpreter") {
  TEST_CASE("groups and powers and names expand from left to right") {
    CHECK(atoms(word("U C^3 P").word, 1) == "UCCCP");
    CHECK(atoms(word("(UD)^2 (UCP)*").word, 2) == "UDUDUCP UCP");
    CHECK(atoms(word("a = UC\na a^2 (a P)*").word, 1) == "UCUCUCUCP");
    CHECK(atoms(word("P . C^2 . U").word, 1) == "UCCP");
    CHECK(atoms(finite(word("catmull_clark^3")), 1) == "UCPUCPUCP");
    CHECK(atoms(word("w = catmull_clark^2\nw (UD)*").word, 1) == "UCPUCPUD");
    CHECK(atoms(word("bspline(4)").word, 1) == "UDDDD");
    CHECK(word("catmull_clark^3").rounds == 3);
    CHECK(word("U[3] C").word.head[0].sections == 3);
    CHECK(word("n = 4\nU[n - 1] C").word.head[0].sections == 3);
  }

  TEST_CASE("an own argument wins over the where of its word and that over the where around it") {
    const Word inner =
        word("a = (UCP[delta = 1/2] CP where delta = 1/3, omega = 1/4)\n(a) where delta = 1/5, omega = 1/6, f = 1/7").word;
    CHECK(at(inner.head[2].delta) == Rational::parse("1/2"));
    CHECK(at(inner.head[4].delta) == Rational::parse("1/3"));
    CHECK(at(inner.head[2].omega.plain) == Rational::parse("1/4"));
    CHECK(at(inner.head[1].f.plain) == Rational::parse("1/7"));
    CHECK_FALSE(inner.head[1].f_everywhere);
    CHECK(word("U C[f = 3] P").word.head[1].f_everywhere);
  }

  TEST_CASE("a plain binding serves the directions that have none") {
    const Word w = word("(UCP)* where f = 1/2, f@lat = 1/3, omega@lon = 1/4, omega@face = 9, alpha0@lat = 5").word;
    CHECK(at(w.tail[1].f.plain) == Rational::parse("1/2"));
    CHECK(at(w.tail[1].f.latitude) == Rational::parse("1/3"));
    CHECK(at(w.tail[1].f.longitude) == Rational::parse("1/2"));
    CHECK(at(w.tail[2].omega.longitude) == Rational::parse("1/4"));
    CHECK_FALSE(w.tail[2].omega.plain);
    CHECK_FALSE(w.tail[2].omega.latitude);
    CHECK(at(w.tail[2].omega_face) == Rational(9));
    CHECK(at(w.alpha0.latitude) == Rational(5));
  }

  TEST_CASE("the parameter of a binding stands for the variable of the paper") {
    CHECK(at(word("(UC)* where f(x) = x/2").word.tail[1].f.plain) == Rational(1));
    CHECK(at(word("(UCP)* where delta(n) = n + 1").word.tail[2].delta) == Rational(6));
    CHECK(at(word("(UCP)* where delta(alpha) = alpha").word.tail[2].delta) == Rational(2));
    CHECK(at(word("s(N) = (UCP)* where delta = N\ns(8)").word.tail[2].delta) == Rational(8));
    CHECK(at(word("s(N) = (UCP)* where delta(N) = N\ns(8)").word.tail[2].delta) == Rational(5));
  }

  TEST_CASE("rings and triangles and n-gons are properties of the word") {
    CHECK(word("(UCP)* where rings = both").word.rings == Rings::both);
    CHECK(word("revolve(8)").word.rings == Rings::latitude);
    CHECK(word("loop").word.triangles);
    CHECK(word("catmull_clark").word.tail[1].ngon == Ngon::classic);
    CHECK(word("loop^2 loop").word.triangles);
    CHECK(run("loop^2 (UCP)*").error.code == "E_TRIANGLES_MIX");
    CHECK(run("a = (UCP where {rings = lat})\nb = (UCP where {rings = lon})\na b").error.code == "E_BINDING");
    CHECK(run("a = (UC where {f = alpha, alpha0 = 1})\nb = (UC where {f = alpha, alpha0 = 2})\na b").error.code == "E_BINDING");
  }

  TEST_CASE("the defaults of a word are listed") {
    CHECK(word("(UCP)*").defaults == std::vector<std::string>{"f = 1", "omega = 1", "delta = 1"});
    CHECK(word("(UCP)* where f = cos(alpha), omega = 1").defaults == std::vector<std::string>{"delta = 1", "alpha0 = 0"});
    CHECK(word("circle(5)").defaults.empty());
  }

  TEST_CASE("word errors point at the item") {
    const ProgramError dual = run("(UDP)*").error;
    CHECK(dual.code == "E_P_DUAL");
    CHECK(error_text(dual) == "P");
    const ProgramError later = run("x = UC\n(x x D P)*").error;
    CHECK(later.code == "E_P_DUAL");
    CHECK(later.span.begin == 14);
    const ProgramError name = run("(U smoth P)*").error;
    CHECK(name.code == "E_NAME");
    CHECK(error_text(name) == "smoth");
    const ProgramError binding = run("(UCP)* where omga = 1").error;
    CHECK(binding.code == "E_BINDING");
    CHECK(binding.help == "did you mean 'omega'?");
    CHECK(error_text(binding) == "omga = 1");
    const ProgramError turned = run("PCU").error;
    CHECK(turned.code == "E_P_NO_U");
    CHECK(turned.help ==
          "words are read from left to right, U first; did you mean the operator product P . C . U, which is the word UCP?");
  }

  TEST_CASE("wrong words are refused") {
    CHECK(run("(UC)* where ngon = classic").error.code == "E_BINDING");
    CHECK(run("(UC)* where rings = round").error.code == "E_BINDING");
    CHECK(run("(UCP)* where delta@lat = 1").error.code == "E_BINDING");
    CHECK(run("(UCP[f = 1])*").error.code == "E_BINDING");
    CHECK(run("x = 3\nU x").error.code == "E_TYPE");
    CHECK(run("U bspline").error.code == "E_TYPE");
    CHECK(run("chaikin U").error.code == "E_STAR");
    CHECK(run("U C^(1/2)").error.code == "E_TYPE");
    CHECK(run("(UC)^60000").error.code == "E_WORD_TOO_LONG");
    CHECK(run("w = UC\n((w^300)^300)^300").error.code == "E_WORD_TOO_LONG");
    CHECK(run("(UCP)* where delta = cube()").error.code == "E_NAME");
  }

  TEST_CASE("bindings without effect are warned about with their place") {
    const Run unused = run("(UC)* where omega = 1");
    REQUIRE(unused.warnings.size() == 1);
    CHECK(unused.warnings[0] == "<input>:1:13: omega has no effect: the word has no P");
    CHECK(run("(UD)* where f = 1").warnings.empty());
    CHECK(run("circle(5)").warnings.empty());
  }

  TEST_CASE("a word made by a function is shown as its call") {
    CHECK(word("circle(5)").source == "circle(5)");
    CHECK(word("four_point(1/16)").source == "four_point(1/16)");
    CHECK(word("circle(5)^3").source == "circle(5)^3");
  }
}
