// Deep, long and broken texts: a clear error or a result, quickly, never a crash.
#include <doctest/doctest.h>

#include <chrono>
#include <random>
#include <string>
#include <vector>

#include "grammar/parse.h"
#include "grammar/print.h"

using namespace udcp::grammar;

namespace {

struct Nest {
  const char *open, *middle, *close;
};
constexpr Nest brackets[] = {{"(", "U", ")"},
                             {"(", "1", ")"},
                             {"[", "1", "]"},
                             {"f(", "1", ")"},
                             {"(C ", "U", ")^2"},
                             {"a[", "0", "]"},
                             {"if a then b else ", "1", ""},
                             {"if ", "a", " then b else c"},
                             {"f(w where {f = ", "1", "})"},
                             {"P[f = ", "1", "]"},
                             {"save(", "\"x\"", ")"},
                             {"sweep n in 1 .. 2 { ", "a", " }"},
                             {"(0 .. ", "1", ")"}};
constexpr Nest chains[] = {{"-", "1", ""},  {"not ", "a", ""}, {"2^", "1", ""},    {"", "a", ".f(1)"}, {"", "a", "[0]"},
                           {"1+", "1", ""}, {"1 - ", "1", ""}, {"a |> ", "b", ""}, {"a and ", "b", ""}};

std::string nested(const Nest& nest, int depth) {
  std::string result;
  for (int i = 0; i < depth; ++i) result += nest.open;
  result += nest.middle;
  for (int i = 0; i < depth; ++i) result += nest.close;
  return result;
}

std::string code_of(const std::string& source) {
  try {
    static_cast<void>(parse(source));
  } catch (const SyntaxError& error) {
    CHECK(error.span.begin <= error.span.end);
    CHECK(error.span.begin <= source.size());
    return error.code;
  }
  return "";
}

}  // namespace

TEST_SUITE_BEGIN("grammar");

TEST_CASE("brackets of every kind nest 150 deep in no time") {
  const auto start = std::chrono::steady_clock::now();
  for (const Nest& nest : brackets) {
    CAPTURE(nest.open);
    const Program program = parse(nested(nest, 150));
    CHECK(same(program, parse(to_string(program))));
  }
  // Microseconds a level; a grammar that tries a bracket twice would need 2^150 steps.
  CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(10));
}

TEST_CASE("deeper nesting is refused and not followed") {
  for (const Nest& nest : brackets) {
    CAPTURE(nest.open);
    CHECK(code_of(nested(nest, 250)) == "E_DEPTH");
    CHECK(code_of(nested(nest, 100000)) == "E_DEPTH");
  }
}

TEST_CASE("chains of operations are long but finite") {
  for (const Nest& chain : chains) {
    CAPTURE(chain.open);
    const Program program = parse(nested(chain, 400));
    CHECK(same(program, parse(to_string(program))));
    CHECK(code_of(nested(chain, 100000)) == "E_DEPTH");
  }
  try {
    static_cast<void>(parse(nested({"1+", "1", ""}, 10000)));
    FAIL("no error");
  } catch (const SyntaxError& error) {
    CHECK(std::string(error.what()) == "this expression chains or nests more than 500 operations");
    CHECK(error.help == "split it into several definitions");
  }
  try {
    static_cast<void>(parse(std::string(300, '(')));
    FAIL("no error");
  } catch (const SyntaxError& error) {
    CHECK(std::string(error.what()) == "brackets, conditions or blocks nest more than 200 deep");
    CHECK(error.span == Span{200, 201});
    CHECK_FALSE(error.incomplete);
  }
}

TEST_CASE("words and lists and programs may be long") {
  CHECK(code_of(std::string(20000, 'U')) == "");
  CHECK(code_of(nested({"P . ", "U", ""}, 20000)) == "");
  CHECK(code_of("[" + nested({"1, ", "1", ""}, 20000) + "]") == "");
  CHECK(code_of(nested({"x = 1\n", "y", ""}, 20000)) == "");
  CHECK(code_of("x\n" + std::string(1000000, '\n') + "y") == "");
  CHECK(code_of("x # " + std::string(1000000, 'c') + "\n" + nested({"# c\n", "y", ""}, 20000)) == "");
}

TEST_CASE("too many parts and too much text are refused") {
  CHECK(code_of(std::string(250001, 'U')) == "E_LIMIT");
  CHECK(code_of(nested({"#\n", "", ""}, 250001)) == "E_LIMIT");
  CHECK(code_of(std::string((16U << 20U) + 1, ' ')) == "E_LIMIT");
  CHECK(code_of(std::string(1U << 20U, ' ')) == "");
}

TEST_CASE("texts that are no UTF-8 text are refused with the place") {
  try {
    static_cast<void>(parse(std::string_view("x = 1\n\0", 7)));
    FAIL("no error");
  } catch (const SyntaxError& error) {
    CHECK(error.code == "E_ENCODING");
    CHECK(std::string(error.what()) == "the program contains a NUL byte");
    CHECK(error.span == Span{6, 7});
  }
  try {
    static_cast<void>(parse("# \xFF"));
    FAIL("no error");
  } catch (const SyntaxError& error) {
    CHECK(error.code == "E_ENCODING");
    CHECK(std::string(error.what()) == "the program is not well-formed UTF-8");
    CHECK(error.help == "save the file as UTF-8 text");
    CHECK_FALSE(error.incomplete);
  }
}

TEST_CASE("truncated and mutated programs give a result or a syntax error") {
  const std::string program =
      "# note\nloop = (U C[f = 1/2] P)* on triangles where omega = 0, delta(N) = 1 - 8/3*(5/8 - cos(2*pi/N)^2)\n"
      "sweep n in 3 .. 12 step 2 { print n, [a, \"b {n}\"][0] }\ncube() |> loop^4 |> save \"x.glb\"\n"
      "prove c1((UCP)* where {f = 1}) for f in (0, oo], N in 3 .. 8 -> \"c\"\nx = if a and not b then P . C . U else -2^-3\n";
  for (std::size_t size = 0; size <= program.size(); ++size) static_cast<void>(code_of(program.substr(0, size)));
  const std::string signs = "()[]{}*^|>=,.-+\"#;@ \nUCPN0eif";
  std::mt19937 random(7);
  for (int round = 0; round < 5000; ++round) {
    std::string text = program;
    for (int i = 0; i < 3; ++i) text[random() % text.size()] = signs[random() % signs.size()];
    CAPTURE(text);
    try {
      const Program parsed = parse(text);
      CHECK(same(parsed, parse(to_string(parsed))));
    } catch (const SyntaxError& error) {
      CHECK(error.span.end <= text.size());
      CHECK(!error.code.empty());
    }
  }
}

TEST_SUITE_END();
