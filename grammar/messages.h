// What the committing rules say, one entry a rule: message, label behind the caret, help. must<> without an entry does not
// compile.
#pragma once

#include "grammar/diagnosis.h"
#include "grammar/rules.h"

namespace udcp::grammar {

using Kind = Message::Kind;

template <class Rule>
inline constexpr Message message{};

#define UDCP_MESSAGE(rule, kind, text, label, help) \
  template <>                                       \
  inline constexpr Message message<rules::rule> {   \
    Kind::kind, text, label, help                   \
  }

UDCP_MESSAGE(number_head, number, "a number does not begin with a superfluous 0", "leading zero",
             "write 8 for 08, and 0.8 for 4/5");
UDCP_MESSAGE(fraction, number, "digits are missing after the point", "a digit is expected",
             "write 1.0 or 1, and 1 .. 3 for a range");
UDCP_MESSAGE(exponent, number, "digits are missing in the exponent", "a digit is expected", "write 1e-3");
UDCP_MESSAGE(number_end, number, "a number ends in the middle of a word or of another number", "not part of a number",
             "write one decimal point only, and * for a product: 2*x");
UDCP_MESSAGE(greek_end, letters, "a Greek letter stands alone as a name", "not part of a name",
             "the Greek names are ω, δ, α, α0 and π; other names use a-z, 0-9 and _");
UDCP_MESSAGE(name_end, letters, "a name is written in small letters", "capitals are atoms",
             "write names with a-z, 0-9 and _; leave a blank between a name and an atom");
UDCP_MESSAGE(atom_end, letters, "an atom stands alone, without letters or digits after it", "not part of an atom",
             "write U[2] for sections, U^2 for a repetition; names use small letters");
UDCP_MESSAGE(escaped, letters, "this escape has no meaning", "unknown escape", "the escapes in a text are \\\" \\\\ \\n \\t");
UDCP_MESSAGE(text_end, letters, "the text is not closed on its line", "a \" is expected",
             "close the text with \"; \\n in it starts a new line");

UDCP_MESSAGE(operand, value, "a value or a word is expected", "here",
             "write a number, a name, a word such as (UCP)*, or an expression");
UDCP_MESSAGE(right_side, value, "a value is expected after the operator", "here",
             "write a number, a name or an expression on both sides");
UDCP_MESSAGE(entry_set, value, "a set is expected after in", "here", "write name in 0 .. 1 or name in (0, 1)");
UDCP_MESSAGE(entry_value, value, "a value is expected after =", "here", "write name = value");
UDCP_MESSAGE(next_entry, value, "an argument is expected after the comma", "here",
             "write a value or name = value, or leave the comma out");
UDCP_MESSAGE(next_bracket_item, value, "a value is expected after the comma", "here", "write a value, or leave the comma out");
UDCP_MESSAGE(close_call, bracket, "the arguments go on with , or end with )", "not an argument",
             "write , between two arguments and ) behind the last");
UDCP_MESSAGE(close_item, bracket, "the arguments go on with , or end with ]", "not an argument",
             "write , between two arguments and ] behind the last");
UDCP_MESSAGE(close_bracket, bracket, "a bracket goes on with an operator, an item, or its end", "not expected inside brackets",
             "close the bracket, or write a value");
UDCP_MESSAGE(condition, value, "a condition is expected after if", "here", "write if N == 4 then 0 else 1");
UDCP_MESSAGE(kw_then, sign, "then is missing after the condition", "then is expected", "write if N == 4 then 0 else 1");
UDCP_MESSAGE(then_value, value, "a value is expected after then", "here", "write if N == 4 then 0 else 1");
UDCP_MESSAGE(kw_else, sign, "else is missing: every if has both values", "else is expected", "write if N == 4 then 0 else 1");
UDCP_MESSAGE(else_value, value, "a value is expected after else", "here", "write if N == 4 then 0 else 1");
UDCP_MESSAGE(direction_name, value, "a direction is expected after @", "here",
             "the directions are lat and lon, and omega@face for face points");
UDCP_MESSAGE(member_name, letters, "this word of the language cannot be the name of a method", "a keyword",
             "write the name of a function after the point");

UDCP_MESSAGE(range_last, value, "the end of the range is expected after ..", "here", "write 0 .. 1 or 0 .. 1 step 1/4");
UDCP_MESSAGE(range_step, value, "a value is expected after step", "here", "write 0 .. 1 step 1/4");
UDCP_MESSAGE(kw_triangles, value, "triangles is expected after on", "here", "write (UCP)* on triangles; quads need no mark");
UDCP_MESSAGE(binding, value, "a binding is expected", "here", "write where f = 1, omega(alpha) = 1/cos(alpha/2)");
UDCP_MESSAGE(binding_sign, sign, "a binding needs = and a value", "= is expected",
             "write f = 1; inside an argument list put the bindings into braces: where {f = 1}");
UDCP_MESSAGE(binding_value, value, "a value is expected after =", "here", "write f = 1 or f(alpha) = cos(alpha/2)");
UDCP_MESSAGE(close_bindings, bracket, "the bindings go on with , or end with }", "not a binding",
             "write , between two bindings and } behind the last");
UDCP_MESSAGE(next_stage, value, "a step is expected after |>", "here",
             "write a word with a power, a function, or save \"file.obj\"");

UDCP_MESSAGE(statement_end, sign, "the statement should end here", "not expected",
             "write one statement a line, or ; between two");
UDCP_MESSAGE(lone_end, sign, "the expression should end here", "not expected",
             "write one word or expression and nothing after it");
UDCP_MESSAGE(end, sign, "a statement is expected", "here", "begin with a name, a word, a value or a statement such as print");
UDCP_MESSAGE(lone_value, value, "a word or an expression is expected", "here", "write a word such as (UCP)*");
UDCP_MESSAGE(block, sign, "the statements of a loop stand in braces", "{ is expected", "write sweep n in 3 .. 8 { print n }");
UDCP_MESSAGE(close_block, bracket, "a block goes on with a statement or ends with }", "not a statement",
             "close the block with }");
UDCP_MESSAGE(loop_name, value, "the name of the variable is expected", "here", "write sweep n in 3 .. 8 { print n }");
UDCP_MESSAGE(kw_in, sign, "in is missing after the variable", "in is expected", "write n in 3 .. 8");
UDCP_MESSAGE(loop_range, value, "a range or a list is expected after in", "here", "write n in 3 .. 8 or d in 0 .. 1 step 1/4");
UDCP_MESSAGE(kw_frames, sign, "frames is missing after the range", "frames is expected",
             "write animate d in 0 .. 1 frames 60 { ... }");
UDCP_MESSAGE(frame_count, value, "the number of frames is expected", "here", "write animate d in 0 .. 1 frames 60 { ... }");
UDCP_MESSAGE(printed, value, "a value to print is expected", "here", "write print n, mask((UCP)*)");
UDCP_MESSAGE(asserted, value, "a condition is expected after assert", "here", "write assert a == b");
UDCP_MESSAGE(claimed, value, "a claim is expected", "here", "write prove converges((UCP)*) for f in (0, oo)");
UDCP_MESSAGE(domain_name, value, "the name of a variable is expected after for", "here", "write for f in (0, oo), N in 3 .. 8");
UDCP_MESSAGE(domain_set, value, "an interval or a range is expected after in", "here",
             "write f in (0, oo), delta in [0, 1] or N in 3 .. 8");
UDCP_MESSAGE(certificate, value, "the name of the certificate is expected after ->", "a text is expected",
             "write -> \"cc.cert.json\"");
UDCP_MESSAGE(path, value, "the name of a file is expected", "a text is expected",
             "write the name in double quotes: \"file.udcp\"");
UDCP_MESSAGE(setting_name, value, "the name of a setting is expected after set", "here", "write set precision = 256");
UDCP_MESSAGE(setting_sign, sign, "a setting needs = and a value", "= is expected", "write set precision = 256");
UDCP_MESSAGE(setting_value, value, "a value is expected after =", "here", "write set precision = 256");
UDCP_MESSAGE(defined_value, value, "a value is expected after =", "here", "write name = value");

#undef UDCP_MESSAGE

}  // namespace udcp::grammar
