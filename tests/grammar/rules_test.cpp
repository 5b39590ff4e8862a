// The grammar as a grammar: no rule loops without progress, and every rule has a text that it accepts and one that it refuses.
#include "grammar/rules.h"

#include <doctest/doctest.h>

#include <string_view>
#include <tao/pegtl/contrib/analyze.hpp>

#include "grammar/parse.h"

using namespace udcp::grammar;

namespace {

bool accepts(std::string_view source) {
  try {
    static_cast<void>(parse(source));
    return true;
  } catch (const SyntaxError&) {
    return false;
  }
}

struct Sample {
  std::string_view rule, good, bad;
};
constexpr Sample samples[] = {
    {"comment", "x # c", "x // c"},
    {"wide_gap", "(a\n# c\n+ b)", "(a\n$)"},
    {"narrow_gap", "a\n  |> b", "a\n|> b"},
    {"separators", "a;\n;b", "a, b"},
    {"equals", "a = 1", "a == 1 = 2"},
    {"comma", "f(a,\nb)", "f(a b c,,)"},
    {"number", "1.5e-3", "1.5e-"},
    {"number_head", "0.5", "00.5"},
    {"fraction", "1.25", "1."},
    {"exponent", "1e5", "1e"},
    {"number_end", "1 + x", "1x"},
    {"greek_name", "α0 + ω", "αω"},
    {"latin_name", "a_1", "a_X"},
    {"keyword", "ifs = 1", "if = 1"},
    {"valence", "N + 1", "N1"},
    {"atom", "UDCP", "UDCX"},
    {"atom_end", "U c", "Uc"},
    {"text", "\"a\\n\"", "\"a\\x\""},
    {"text_end", "\"a\"", "\"a\n\""},
    {"entry", "f(a = 1)", "f(a = )"},
    {"entry_set", "f(a in [0, 1])", "f(a in )"},
    {"next_entry", "f(a, b)", "f(a, )"},
    {"call", "f()", "f("},
    {"item_arguments", "U[3]", "U[3"},
    {"bracket", "(a)", "(a"},
    {"next_bracket_item", "[a, b]", "[a, ]"},
    {"conditional", "if a then b else c", "if a then b"},
    {"condition", "if a == b then b else c", "if then b else c"},
    {"then_value", "if a then -b else c", "if a then else c"},
    {"else_value", "if a then b else -c", "if a then b else"},
    {"direction", "w where f@lat = 1", "w where f@up = 1"},
    {"named", "f(1)", "f@lat(1)"},
    {"operand", "-[1]", "-]"},
    {"member", "a.f()", "a.not()"},
    {"minus", "a - b", "a -> b"},
    {"repeat", "(UC)*", "(UC)*^"},
    {"star_ahead", "[(UC)*, a]", "[(UC)* a]"},
    {"prefix", "- -not a", "+a"},
    {"infix_dot", "P . C", "P .. . C"},
    {"comparison", "a <= b", "a =< b"},
    {"infix_sign", "a/b", "a % b"},
    {"postfix", "a[0].f()[1]", "a[0].f)"},
    {"next_term", "U C", "U ]"},
    {"operation", "a + b", "a +"},
    {"range_tail", "1 .. 2", "1 .."},
    {"range_step", "1 .. 2 step 3", "1 .. 2 step"},
    {"on_tail", "w on triangles", "w on"},
    {"binding", "w where f = 1", "w where f"},
    {"braced_bindings", "w where {f = 1}", "w where {f = 1"},
    {"where_tail", "w where f = 1, g = 2", "w where f = 1, g"},
    {"verb_step", "a |> save \"x\"", "a |> save x"},
    {"next_stage", "a |> b", "a |> + b"},
    {"statement_end", "a; b", "a } b"},
    {"block", "sweep n in 1 .. 2 { n }", "sweep n in 1 .. 2 n"},
    {"loop_head", "sweep n\nin [1] { n }", "sweep n from [1] { n }"},
    {"sweep", "sweep δ in 1 .. 2 { }", "sweep N in 1 .. 2 { }"},
    {"animate", "animate d in 0 .. 1 frames 3 { d }", "animate d in 0 .. 1 { d }"},
    {"print", "print a, b", "print a,"},
    {"assertion", "assert a == b", "assert a = b"},
    {"check", "check a", "check"},
    {"prove", "prove a for N in 3 .. 4", "prove a for N"},
    {"domain", "prove a for f in (0, 1], g in [0, 1)", "prove a for f in (0, 1, 2]"},
    {"certificate", "prove a -> \"c\"", "prove a -> c"},
    {"verify", "verify \"c\"", "verify c"},
    {"use", "use \"c\"", "use"},
    {"setting", "set a = 1", "set a 1"},
    {"definition", "a = b", "a ="},
    {"byte_order_mark",
     "\xEF\xBB\xBF"
     "a",
     "a\xEF\xBB\xBF"},
    {"end", "a\n\n# c\n", "a\n)"},
};

}  // namespace

TEST_SUITE_BEGIN("grammar");

TEST_CASE("no rule of the grammar can loop without progress") {
  CHECK(tao::pegtl::analyze<rules::program>() == 0);
  CHECK(tao::pegtl::analyze<rules::lone_expression>() == 0);
}

TEST_CASE("every rule accepts and refuses") {
  for (const Sample& sample : samples) {
    CAPTURE(sample.rule);
    CHECK(accepts(sample.good));
    CHECK_FALSE(accepts(sample.bad));
  }
}

TEST_SUITE_END();
