// Ties rules, messages and builder together: one action a rule that matters, one place that raises errors.
#include "grammar/parse.h"

#include <tao/pegtl.hpp>
#include <tao/pegtl/contrib/limit_depth.hpp>

#include "grammar/builder.h"
#include "grammar/messages.h"
#include "grammar/rules.h"

namespace udcp::grammar {
namespace {

namespace pegtl = tao::pegtl;
using Input = pegtl::memory_input<pegtl::tracking_mode::lazy>;

constexpr std::size_t longest_text = 16U << 20U;
constexpr std::size_t deepest_nesting = 200;

template <class Rule>
struct control : pegtl::normal<Rule> {
  [[noreturn]] static void raise(const Input& in, Builder& builder) {
    static_assert(message<Rule>.text != nullptr, "a committing rule needs a message");
    throw diagnose(message<Rule>, builder.text(), static_cast<std::size_t>(in.current() - builder.text().data()),
                   builder.open_bracket());
  }
};

template <class Rule>
struct action : pegtl::nothing<Rule> {};

// UDCP_TOKEN: the method gets the place of the match; UDCP_DONE: its parts are on the stack already.
#define UDCP_TOKEN(rule, method)                                                          \
  template <>                                                                             \
  struct action<rules::rule> {                                                            \
    template <class Match>                                                                \
    static void apply(const Match& match, Builder& builder) {                             \
      const auto begin = static_cast<std::size_t>(match.begin() - builder.text().data()); \
      builder.method({begin, begin + match.size()});                                      \
    }                                                                                     \
  }
#define UDCP_DONE(rule, call)                              \
  template <>                                              \
  struct action<rules::rule> {                             \
    static void apply0(Builder& builder) { builder.call; } \
  }

UDCP_TOKEN(comment, comment);
UDCP_TOKEN(number, number);
UDCP_TOKEN(text, string);
UDCP_TOKEN(latin_name, name);
UDCP_TOKEN(greek_name, greek_name);
UDCP_TOKEN(valence, name);
UDCP_TOKEN(test_name, name);
UDCP_TOKEN(atom, atom);
UDCP_TOKEN(direction, direction);
UDCP_TOKEN(open_bracket, open);
UDCP_TOKEN(close_bracket, close);
UDCP_TOKEN(open_call, open);
UDCP_TOKEN(close_call, close);
UDCP_TOKEN(open_item, open);
UDCP_TOKEN(close_item, close);
UDCP_TOKEN(open_bindings, open);
UDCP_TOKEN(close_bindings, close);
UDCP_DONE(entry_sign, entry_sign());
UDCP_DONE(entry_in, entry_in());
UDCP_DONE(entry, entry());
UDCP_DONE(binding_sign, entry_sign());
UDCP_DONE(binding, entry());
UDCP_DONE(call, call_done());
UDCP_DONE(called, called());
UDCP_DONE(bracket, bracket());
UDCP_DONE(item_arguments, item_arguments());
UDCP_DONE(member, member());
UDCP_TOKEN(conditional, conditional);

UDCP_DONE(operation_begin, operation_begin());
UDCP_TOKEN(prefix, prefix);
UDCP_TOKEN(infix_sign, infix);
UDCP_TOKEN(infix_dot, dot);
UDCP_DONE(neighbour, neighbour());
UDCP_TOKEN(star_sign, star);
UDCP_DONE(operation_end, operation_end());

UDCP_DONE(range_last, range_last());
UDCP_DONE(range_step, range_step());
UDCP_TOKEN(kw_triangles, on_triangles);
UDCP_TOKEN(where_begin, where_begin);
UDCP_DONE(where_tail, where_end());
UDCP_TOKEN(step_verb, verb);
UDCP_DONE(pipe_tail, pipe());

UDCP_TOKEN(open_block, block_begin);
UDCP_TOKEN(close_block, block_end);
UDCP_DONE(sweep, sweep());
UDCP_DONE(animate, animate());
UDCP_DONE(printed, printed());
UDCP_DONE(print, print());
UDCP_DONE(assertion, assertion());
UDCP_DONE(domain, domain());
UDCP_DONE(certificate, certificate());
UDCP_DONE(check, claim(false));
UDCP_DONE(prove, claim(true));
UDCP_DONE(verify, verify());
UDCP_DONE(use, use());
UDCP_DONE(setting, setting());
UDCP_DONE(definition, define());
UDCP_DONE(plain, evaluate());
UDCP_TOKEN(statement, statement);

#undef UDCP_TOKEN
#undef UDCP_DONE

// Every recursion of the grammar passes through one of these three.
template <>
struct action<rules::operation> : pegtl::limit_depth<deepest_nesting> {};
template <>
struct action<rules::block> : pegtl::limit_depth<deepest_nesting> {};
template <>
struct action<rules::verb_step> : pegtl::limit_depth<deepest_nesting> {
  static void apply0(Builder& builder) { builder.verb_step(); }
};

void check_text(std::string_view text) {
  if (text.size() > longest_text) {
    throw SyntaxError("E_LIMIT", "the program is longer than 16 MiB", {0, 0}, "read large data from a file with load",
                      "too long");
  }
  const std::size_t bad = find_bad_byte(text);
  if (bad == std::string_view::npos) return;
  const bool null = text[bad] == '\0';
  throw SyntaxError("E_ENCODING", null ? "the program contains a NUL byte" : "the program is not well-formed UTF-8",
                    {bad, bad + 1}, "save the file as UTF-8 text", null ? "NUL byte" : "not UTF-8");
}

template <class Rule>
void run(std::string_view text, Builder& builder) {
  check_text(text);
  Input in(text.data(), text.data() + text.size(), "");
  try {
    static_cast<void>(pegtl::parse<Rule, action, control>(in, builder));
  } catch (const pegtl::parse_error& error) {
    // Only limit_depth throws this: our own control throws SyntaxError.
    const std::size_t place = error.positions().front().byte;
    throw SyntaxError("E_DEPTH", "brackets, conditions or blocks nest more than " + std::to_string(deepest_nesting) + " deep",
                      {place, place + 1}, "give names to the inner parts", "too deep");
  }
}

}  // namespace

Program parse(std::string_view source) {
  Builder builder(source);
  run<rules::program>(source, builder);
  return builder.program();
}

ExprPtr parse_expression(std::string_view source) {
  Builder builder(source);
  run<rules::lone_expression>(source, builder);
  return builder.expression();
}

}  // namespace udcp::grammar
