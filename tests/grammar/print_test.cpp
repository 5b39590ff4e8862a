// The printer: canonical texts, and round trips over samples and over random programs.
#include "grammar/print.h"

#include <doctest/doctest.h>

#include <fstream>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "grammar/parse.h"

using namespace udcp::grammar;

namespace {

std::string formatted(const std::string& source) { return to_string(parse(source)); }

/// parse(to_string(p)) is p, and printing again changes nothing.
void check_round_trip(const std::string& source) {
  CAPTURE(source);
  const Program program = parse(source);
  const std::string text = to_string(program);
  CAPTURE(text);
  Program again;
  REQUIRE_NOTHROW(again = parse(text));
  CHECK(same(program, again));
  CHECK(to_string(again) == text);
}

/// Random program texts: valid by construction, with more brackets and blanks than needed.
class Writer {
 public:
  explicit Writer(unsigned seed) : random_(seed) {}

  std::string program() {
    std::string result;
    for (int i = pick(4); i >= 0; --i) result += statement(2) + end();
    return result;
  }

 private:
  int pick(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }
  template <class... T>
  std::string one_of(T... options) {
    const std::vector<std::string> list{options...};
    return list[static_cast<std::size_t>(pick(static_cast<int>(list.size())))];
  }
  std::string end() { return one_of("\n", "\n", "\n\n", " # note\n", "\n\n# above\n", "\n# one\n\n\n# two\n\n", " ; ", "\n#\n"); }
  std::string name() { return one_of("a", "b_2", "catmull_clark", "α0", "omega", "n", "step_size", "format"); }
  std::string number() { return one_of("0", "1", "12", "0.8", "3e-2", "1.5e7"); }
  std::string text() { return one_of("\"a {n}\"", "\"\"", "\"\\\"q\\\\ \\n\\t ω\""); }
  std::string gap() { return one_of("", "", " ", "  "); }

  std::string list(int depth, bool named) {
    std::string result;
    for (int i = pick(3); i >= 0; --i) {
      if (named && pick(3) == 0) result += std::string("x") + std::to_string(i) + " = ";
      result += one_of(value(depth - 1), "(" + value(depth - 1) + (pick(2) == 0 ? " |> " + value(depth - 1) : "") + ")");
      if (i > 0) result += gap() + "," + one_of(" ", "\n", " # c\n");
    }
    return result;
  }

  std::string operand(int depth) {
    if (depth <= 0) return one_of(name(), number(), std::string("N"), std::string("v.delta"), text());
    switch (pick(9)) {
      case 0:
        return name() + "(" + list(depth, true) + ")";
      case 1:
        return "[" + list(depth, false) + "]";
      case 2:
        return "(" + operation(depth - 1) + ")";
      case 3:
        return name() + "[" + operation(depth - 1) + "]";
      case 4:
        return "(" + operation(depth - 1) + ").go(" + list(depth, true) + ")";
      case 5:
        return "(if " + operation(depth - 1) + " then " + operation(depth - 1) + " else " + operation(depth - 1) + ")";
      case 6:
        return "(" + word(depth - 1) + one_of(" on triangles", " where {f = 1, omega(alpha) = -alpha}", "") + ")";
      case 7:
        return name() + "()";
      default:
        return operand(0);
    }
  }

  std::string operation(int depth) {
    switch (pick(7)) {
      case 0:
        return operand(depth) + " " + one_of("+", "-", "/") + gap() + operand(depth);
      case 5:
        return operand(depth) + one_of("^", "^-", " ^ - -") + operand(0);
      case 1:
        return one_of("-", "not ", "- -") + operand(depth);
      case 2:
        return operand(depth) + gap() + one_of("==", "!=", "<", "<=", ">", ">=") + gap() + operand(depth);
      case 3:
        return operand(depth) + one_of(" and ", " or ", " - -") + operand(depth);
      case 4:
        return number() + gap() + "*" + gap() + one_of(name(), number(), "(" + name() + " + " + operand(0) + ")");
      default:
        return operand(depth);
    }
  }

  std::string item(int depth) {
    const std::string power = one_of("", "", "^2", "^m ", "^(n + 1)", "^-1");
    switch (pick(depth > 0 ? 7 : 3)) {
      case 0:
        return one_of("U", "C", "D", "P", "UC", "UCCP") + power;
      case 1:
        return one_of("U[3]", "U[n]", "C[f = 1/2]", "D[ f(alpha) = cos(alpha) ]", "P[delta = -1/10, omega@lat = 2]") + power;
      case 2:
        return " " + name() + power + " ";
      case 3:
        return "(" + word(depth - 1) + " where {delta = v.x})" + power;
      case 4:
        return " " + name() + "(" + list(depth, true) + ")" + power + " ";
      default:
        return "(" + word(depth - 1) + ")" + power;
    }
  }
  std::string word(int depth) {
    if (pick(5) == 0) return "P . C^2" + one_of(" . U", " . (UC)^3 . U", " . n . " + name());
    std::string result = one_of("U", "U ");
    for (int i = pick(3); i >= 0; --i) result += item(depth);
    return result;
  }
  std::string scheme(int depth) { return one_of("", "UC ", "(U P[delta = 1])^2 ") + "(" + word(depth) + ")*"; }

  std::string value(int depth) {
    switch (pick(5)) {
      case 0:
        return operation(depth) + gap() + " .. " + operation(depth) + one_of(std::string(), " step " + operation(0));
      case 1:
        return word(depth);
      case 2:
        return scheme(depth) + one_of("", " on triangles", " where {rings = lat}", " where{f@lat(alpha) = 1, f@lon = 2}");
      default:
        return operation(depth);
    }
  }

  std::string pipeline(int depth) {
    std::string result = value(depth);
    for (int i = pick(3); i > 0; --i) {
      result += one_of(" |> ", "\n  |> ", " |>\n") +
                one_of(value(depth), std::string("save \"a.obj\""), std::string("print"), "plot(" + list(1, true) + ")");
    }
    return result;
  }

  std::string statement(int depth) {
    switch (pick(depth > 0 ? 12 : 9)) {
      case 0:
        return name() + " = " + pipeline(depth);
      case 1:
        return "f(p, q) =\n" + pipeline(depth);
      case 2:
        return "print " + list(depth, false);
      case 3:
        return "assert " + operation(depth);
      case 4:
        return one_of("check ", "prove ") + operation(depth) +
               one_of("", " for f in (0, oo), N in 3 .. 8, x in [1, 2)", " for δ in [1, n]") + one_of("", " -> \"c.json\"");
      case 5:
        return one_of("verify \"c.json\"", "use \"a.udcp\"", "set precision = 256", "set seed = -n");
      case 6:
        return "w = " + scheme(depth) + "\n  where f = " + operation(depth) + ", omega(alpha) = " + operation(depth) +
               ",\n delta = 1";
      case 9:
        return "sweep n in " + value(1) + " {" + one_of("\n", " ", " # in\n") + body(depth) + "}";
      case 10:
        return "animate d in 0 .. 1 frames " + operand(1) + "\n{" + body(depth) + one_of("", "# last\n") + "}";
      default:
        return pipeline(depth);
    }
  }
  std::string body(int depth) {
    std::string result;
    for (int i = pick(3); i > 0; --i) result += statement(depth - 1) + end();
    return result;
  }

  std::mt19937 random_;
};

}  // namespace

TEST_SUITE_BEGIN("grammar");

TEST_CASE("the canonical text of expressions") {
  const auto canonical = [](const std::string& source) { return to_string(*parse_expression(source)); };
  CHECK(canonical("( ( 1+2 ) )*3") == "(1 + 2)*3");
  CHECK(canonical("-(2^2)") == "-2^2");
  CHECK(canonical("(-2)^2") == "(-2)^2");
  CHECK(canonical("2^(-3)") == "2^-3");
  CHECK(canonical("(2^3)^2") == "(2^3)^2");
  CHECK(canonical("a-(b-c)") == "a - (b - c)");
  CHECK(canonical("(a and b)or not(c or d)") == "a and b or not (c or d)");
  CHECK(canonical("f( a,x=[1 ,2] ) [0].g( )") == "f(a, x = [1, 2])[0].g()");
  CHECK(canonical("(if a then b else c)+1") == "(if a then b else c) + 1");
  CHECK(canonical("α0+2*π") == "alpha0 + 2*pi");
  CHECK(canonical("(3).f()") == "(3).f()");
  CHECK(canonical("f(a |> b, (c .. d))") == "f(a |> b, c .. d)");
  CHECK(canonical("[(a |> b) + 1]") == "[(a |> b) + 1]");
}

TEST_CASE("the canonical text of words") {
  const auto canonical = [](const std::string& source) { return to_string(*parse_expression(source)); };
  CHECK(canonical("U C C P") == "UCCP");
  CHECK(canonical("UC^3P") == "U C^3 P");
  CHECK(canonical("UC(UCP)*") == "UC (UCP)*");
  CHECK(canonical("(UCP[ delta=-1/10 ])^2(UCP)*") == "(UCP[delta = -1/10])^2 (UCP)*");
  CHECK(canonical("U C[ngon=classic]P") == "U C[ngon = classic] P");
  CHECK(canonical("P.C.U") == "P . C . U");
  CHECK(canonical("(UCP)*^4") == "((UCP)*)^4");
  CHECK(canonical("(UCP)* where f@lat(alpha)=1") == "(UCP)* where f@lat(alpha) = 1");
  CHECK(canonical("equal((UCP)* where omega = 1/2)") == "equal((UCP)* where {omega = 1/2})");
  CHECK(to_string(std::get<WordExpr>(parse_expression("UC P")->node)) == "UCP");
}

TEST_CASE("statements and comments and blank lines keep their order") {
  CHECK(formatted("# head\n\n\n# about x\nx=1   # note\n\n\n\ny=2;z=3\n# end") ==
        "# head\n\n# about x\nx = 1  # note\n\ny = 2\nz = 3\n# end\n");
  CHECK(formatted("f(a, # inner\n b)\n") == "# inner\nf(a, b)\n");
  CHECK(formatted("sweep n in 1..2{print n}") == "sweep n in 1 .. 2 { print n }\n");
  CHECK(formatted("sweep n in 1 .. 2 { # in\n\n x = 1\n\n y = 2\n # last\n} # after\n") ==
        "sweep n in 1 .. 2 {\n  # in\n\n  x = 1\n\n  y = 2\n  # last\n}  # after\n");
  CHECK(formatted("animate d in 0 .. 1 frames 60 { }\n\n# end") == "animate d in 0 .. 1 frames 60 { }\n\n# end\n");
  CHECK(formatted("prove c1( w )for N in 3..8,f in(0,oo)->\"c\"") == "prove c1(w) for N in 3 .. 8, f in (0, oo) -> \"c\"\n");
  CHECK(formatted("").empty());
  CHECK(formatted("# only\n") == "# only\n");
  CHECK(formatted("(print \"x\")") == "(print \"x\")\n");
}

TEST_CASE("long lines are broken before where and pipes and between bindings") {
  const std::string source =
      "pipe(k) = (UCP)* where f@lat(alpha) = cos(alpha/2), f@lon = 1, omega@lat(alpha) = 1/cos(alpha/2), omega@lon = 1, alpha0 = "
      "2*pi/k";
  CHECK(formatted(source) ==
        "pipe(k) = (UCP)*\n"
        "  where f@lat(alpha) = cos(alpha/2), f@lon = 1, omega@lat(alpha) = 1/cos(alpha/2), omega@lon = 1,\n"
        "        alpha0 = 2*pi/k\n");
  const std::string name(60, 'a');
  CHECK(formatted(name + "() |> " + name + " |> save \"x\"") == name + "()\n  |> " + name + "\n  |> save \"x\"\n");
  check_round_trip("sweep n in 1 .. 2 { " + name + "() |> " + name + " |> save \"x\" }");
}

TEST_CASE("the programs of the language survive a round trip") {
  std::ifstream in(std::string(UDCP_TEST_DATA) + "/grammar/language_programs.udcp");
  REQUIRE(in.good());
  std::ostringstream text;
  text << in.rdbuf();
  check_round_trip(text.str());
}

TEST_CASE("random programs survive a round trip") {
  for (unsigned seed = 0; seed < 800; ++seed) {
    CAPTURE(seed);
    check_round_trip(Writer(seed).program());
  }
}

TEST_CASE("equality ignores spans and comments but no content") {
  CHECK(same(parse("x = 1 # a"), parse("\n\nx   =   1")));
  for (const auto& pair : {std::pair{"x = 1", "y = 1"},
                           {"x = 1", "x = 1.0"},
                           {"a + b", "b + a"},
                           {"UC", "CU"},
                           {"U", "U[2]"},
                           {"U^2 C", "U^3 C"},
                           {"(UC)*", "(UC)^2 U"},
                           {"f(a)", "f(x = a)"},
                           {"P . C . U", "UCP"},
                           {"w where f = 1", "w where f@lat = 1"},
                           {"w on triangles", "w where f = 1"},
                           {"print a", "print a, a"},
                           {"a .. b", "a .. b step 1"},
                           {"f() U", "f U"},
                           {"check a for x in (0, 1)", "check a for x in [0, 1)"},
                           {"prove a", "check a"},
                           {"use \"a\"", "use \"b\""}}) {
    const std::string a = pair.first, b = pair.second;
    CAPTURE(a);
    CAPTURE(b);
    CHECK_FALSE(same(parse(a), parse(b)));
    CHECK(same(parse(a), parse(a)));
  }
}

TEST_SUITE_END();
