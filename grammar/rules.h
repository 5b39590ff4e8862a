// The grammar, one rule a line. An operation is a flat row of operands and operators: the builder applies precedences and tells
// words from numbers, so no rule tries a bracket twice. After must<> stands a rule with an entry in messages.h. State:
// grammar/builder.h.
#pragma once

#include <tao/pegtl.hpp>
#include <tao/pegtl/contrib/analyze_traits.hpp>

namespace udcp::grammar::rules {

using namespace tao::pegtl;  // the vocabulary of the page

// ---- characters, comments and line breaks
struct small : sor<lower, one<'_'>> {};
struct name_tail : sor<small, digit> {};
template <class Letters>
struct key : seq<Letters, not_at<sor<name_tail, upper>>> {};
struct blank : one<' ', '\t'> {};
struct comment : seq<one<'#'>, until<at<eolf>>> {};
struct wide_gap : star<sor<blank, comment, eol>> {};
struct indented : seq<plus<star<blank>, opt<comment>, eol>, plus<blank>> {};
struct narrow_gap : seq<star<sor<blank, comment>>, opt<indented, at<sor<string<'|', '>'>, key<TAO_PEGTL_STRING("where")>>>>> {};
struct gap;  // wide inside brackets, narrow outside; defined below
struct separators : star<sor<blank, comment, eol, one<';'>>> {};

// ---- keywords and signs
struct kw_where : key<TAO_PEGTL_STRING("where")> {};
struct kw_on : key<TAO_PEGTL_STRING("on")> {};
struct kw_for : key<TAO_PEGTL_STRING("for")> {};
struct kw_in : key<TAO_PEGTL_STRING("in")> {};
struct kw_step : key<TAO_PEGTL_STRING("step")> {};
struct kw_frames : key<TAO_PEGTL_STRING("frames")> {};
struct kw_if : key<TAO_PEGTL_STRING("if")> {};
struct kw_then : key<TAO_PEGTL_STRING("then")> {};
struct kw_else : key<TAO_PEGTL_STRING("else")> {};
struct kw_and : key<TAO_PEGTL_STRING("and")> {};
struct kw_or : key<TAO_PEGTL_STRING("or")> {};
struct kw_not : key<TAO_PEGTL_STRING("not")> {};
struct kw_sweep : key<TAO_PEGTL_STRING("sweep")> {};
struct kw_animate : key<TAO_PEGTL_STRING("animate")> {};
struct kw_assert : key<TAO_PEGTL_STRING("assert")> {};
struct kw_check : key<TAO_PEGTL_STRING("check")> {};
struct kw_prove : key<TAO_PEGTL_STRING("prove")> {};
struct kw_verify : key<TAO_PEGTL_STRING("verify")> {};
struct kw_use : key<TAO_PEGTL_STRING("use")> {};
struct kw_set : key<TAO_PEGTL_STRING("set")> {};
struct kw_print : key<TAO_PEGTL_STRING("print")> {};
struct kw_save : key<TAO_PEGTL_STRING("save")> {};
struct kw_plot : key<TAO_PEGTL_STRING("plot")> {};
struct kw_triangles : key<TAO_PEGTL_STRING("triangles")> {};
struct part_keyword : sor<kw_where, kw_on, kw_for, kw_in, kw_step, kw_frames, kw_if, kw_then, kw_else, kw_and, kw_or, kw_not> {};
struct head_keyword
    : sor<kw_sweep, kw_animate, kw_assert, kw_check, kw_prove, kw_verify, kw_use, kw_set, kw_print, kw_save, kw_plot> {};
struct keyword : sor<part_keyword, head_keyword> {};
struct equals : seq<one<'='>, not_at<one<'='>>> {};
struct comma : seq<one<','>, wide_gap> {};
struct dots : two<'.'> {};
struct arrow : string<'-', '>'> {};
struct pipe_sign : string<'|', '>'> {};
struct open_bracket : one<'(', '['> {};
struct close_bracket : one<')', ']'> {};
struct open_call : one<'('> {};
struct close_call : one<')'> {};
struct open_item : one<'['> {};
struct close_item : one<']'> {};
struct open_bindings : one<'{'> {};
struct close_bindings : one<'}'> {};
struct open_block : one<'{'> {};
struct close_block : one<'}'> {};

// ---- numbers, names, texts, atoms
struct number_head : seq<not_at<one<'0'>, digit>, at<digit>> {};
struct fraction : plus<digit> {};
struct exponent : plus<digit> {};
struct number_end : not_at<sor<name_tail, seq<one<'.'>, digit>>> {};
struct exponent_part : seq<one<'e'>, opt<one<'+', '-'>>, must<exponent>> {};
struct number : seq<at<digit>, must<number_head>, plus<digit>, opt<one<'.'>, not_at<one<'.'>>, must<fraction>>,
                    opt<exponent_part>, must<number_end>> {};
struct greek_letter : utf8::one<0x3B1, 0x3B4, 0x3C0, 0x3C9> {};
struct greek_end : not_at<sor<name_tail, upper, greek_letter>> {};
struct greek_name : seq<sor<seq<utf8::one<0x3B1>, opt<one<'0'>>>, greek_letter>, must<greek_end>> {};
struct name_end : not_at<sor<upper, greek_letter>> {};
struct latin_name : seq<not_at<keyword>, small, star<name_tail>, must<name_end>> {};
struct name : sor<latin_name, greek_name> {};
struct valence : key<one<'N'>> {};
struct test_name : key<seq<one<'T'>, digit>> {};  // T2: a test of the regularity paper, as an argument
struct atom_end : not_at<name_tail> {};
struct atom : seq<one<'U', 'D', 'C', 'P'>, must<atom_end>> {};
struct text_character : sor<one<'\t'>, utf8::range<0x20, 0x21>, utf8::range<0x23, 0x5B>, utf8::range<0x5D, 0x10FFFF>> {};
struct escaped : one<'"', '\\', 'n', 't'> {};
struct text_end : one<'"'> {};
struct text : seq<one<'"'>, star<sor<text_character, seq<one<'\\'>, must<escaped>>>>, must<text_end>> {};

// ---- expressions
struct expression;
struct operation;
struct entry_value : seq<expression> {};
struct entry_sign : seq<equals, wide_gap> {};
struct entry_in : seq<kw_in, wide_gap> {};
struct entry_set : seq<expression> {};
struct entry : seq<expression, opt<sor<seq<entry_sign, must<entry_value>>, seq<entry_in, must<entry_set>>>>> {};
struct next_entry : seq<entry> {};
struct entries : opt<entry, star<comma, must<next_entry>>> {};
struct call : seq<open_call, gap, entries, must<close_call>> {};
struct item_arguments : seq<open_item, gap, entries, must<close_item>> {};
struct bracket_item : seq<expression> {};
struct next_bracket_item : seq<expression> {};
struct bracket : seq<open_bracket, gap, opt<bracket_item, star<comma, must<next_bracket_item>>>, must<close_bracket>> {};
struct condition : seq<operation> {};
struct then_value : seq<operation> {};
struct else_value : seq<operation> {};
struct then_part : seq<wide_gap, must<kw_then>, wide_gap, must<then_value>> {};
struct else_part : seq<wide_gap, must<kw_else>, wide_gap, must<else_value>> {};
struct conditional : seq<kw_if, wide_gap, must<condition>, then_part, else_part> {};
struct direction_name : sor<key<TAO_PEGTL_STRING("lat")>, key<TAO_PEGTL_STRING("lon")>, key<TAO_PEGTL_STRING("face")>> {};
struct direction : seq<one<'@'>, must<direction_name>> {};
struct called : seq<call> {};
struct named : seq<name, opt<direction>, opt<called>> {};
struct operand_head : sor<digit, seq<not_at<keyword>, small>, upper, greek_letter, one<'"', '(', '['>, kw_if> {};
struct operand : sor<atom, valence, test_name, number, text, bracket, conditional, named> {};
struct member_name : seq<latin_name> {};
struct member : seq<one<'.'>, at<small>, must<member_name>, opt<call>> {};
struct minus : seq<one<'-'>, not_at<one<'>'>>> {};
struct star_allowed;  // asks the builder whether a word stands before; defined below
struct star_sign : one<'*'> {};
struct star_ahead : seq<one<'*'>, not_at<one<'*'>>, not_at<gap, sor<operand_head, minus>>> {};
struct repeat : seq<at<star_ahead>, star_allowed, star_sign> {};
struct prefix : sor<minus, kw_not> {};
struct infix_dot : seq<one<'.'>, not_at<one<'.'>>> {};
struct comparison : sor<two<'='>, string<'!', '='>, string<'<', '='>, string<'>', '='>, one<'<', '>'>> {};
struct product_sign : seq<one<'*', '/'>, not_at<one<'*', '/'>>> {};
struct infix_sign : sor<comparison, product_sign, one<'+', '^'>, minus, kw_and, kw_or> {};
struct infix : sor<infix_sign, infix_dot> {};
struct postfix : sor<member, seq<gap, sor<item_arguments, repeat>>> {};
struct term : seq<star<prefix, wide_gap>, must<operand>, star<postfix>, gap> {};
struct right_side : seq<at<sor<operand_head, prefix>>, term> {};
struct neighbour : at<operand_head> {};
struct operation_begin : success {};
struct operation_end : success {};
struct next_term : sor<seq<infix, wide_gap, must<right_side>>, seq<neighbour, term>> {};
struct operation : seq<at<sor<operand_head, prefix>>, operation_begin, term, star<next_term>, operation_end> {};

// ---- values, bindings and pipes
struct range_last : seq<operation> {};
struct range_step : seq<operation> {};
struct range_tail : seq<dots, wide_gap, must<range_last>, opt<kw_step, wide_gap, must<range_step>>> {};
struct on_tail : seq<kw_on, wide_gap, must<kw_triangles>, gap> {};
struct bound_name : seq<operation> {};
struct binding_value : seq<operation> {};
struct binding_sign : seq<equals, wide_gap> {};
struct binding : seq<bound_name, wide_gap, must<binding_sign>, must<binding_value>> {};
struct bindings : seq<must<binding>, star<comma, must<binding>>> {};
struct braced_bindings : seq<open_bindings, gap, bindings, must<close_bindings>, gap> {};
struct where_begin : seq<kw_where, wide_gap> {};
struct where_tail : seq<where_begin, sor<braced_bindings, bindings>> {};
struct value : seq<operation, opt<range_tail>, opt<on_tail>, opt<where_tail>> {};
struct step_verb : sor<kw_save, kw_plot, kw_print> {};
struct verb_step : seq<step_verb, gap, opt<sor<text, call>>, gap> {};
struct stage : sor<verb_step, value> {};
struct next_stage : seq<stage> {};
struct pipe_tail : seq<pipe_sign, wide_gap, must<next_stage>> {};
struct expression : seq<stage, star<pipe_tail>> {};

// ---- statements
struct statement;
struct statement_end : at<sor<eolf, one<';', '}'>>> {};
struct block : seq<open_block, separators, star<statement, must<statement_end>, separators>, must<close_block>, gap> {};
struct loop_name : sor<name> {};
struct loop_range : seq<value> {};
struct frame_count : seq<operation> {};
struct loop_head : seq<wide_gap, must<loop_name>, wide_gap, must<kw_in>, wide_gap, must<loop_range>, wide_gap> {};
struct sweep : seq<kw_sweep, loop_head, must<block>> {};
struct animate : seq<kw_animate, loop_head, must<kw_frames>, wide_gap, must<frame_count>, wide_gap, must<block>> {};
struct printed : seq<expression> {};
struct print : seq<kw_print, wide_gap, must<printed>, star<comma, must<printed>>> {};
struct asserted : seq<expression> {};
struct assertion : seq<kw_assert, wide_gap, must<asserted>> {};
struct claimed : seq<expression> {};
struct certificate : seq<text, gap> {};
struct domain_name : sor<name, valence> {};
struct domain_set : seq<value> {};
struct domain : seq<must<domain_name>, wide_gap, must<kw_in>, wide_gap, must<domain_set>> {};
struct domains : seq<kw_for, wide_gap, domain, star<comma, domain>> {};
struct claim_tail : seq<wide_gap, must<claimed>, opt<domains>, opt<arrow, wide_gap, must<certificate>>> {};
struct check : seq<kw_check, claim_tail> {};
struct prove : seq<kw_prove, claim_tail> {};
struct path : seq<text, gap> {};
struct verify : seq<kw_verify, wide_gap, must<path>> {};
struct use : seq<kw_use, wide_gap, must<path>> {};
struct setting_name : sor<name> {};
struct setting_sign : seq<equals, wide_gap> {};
struct setting_value : seq<expression> {};
struct setting : seq<kw_set, wide_gap, must<setting_name>, wide_gap, must<setting_sign>, must<setting_value>> {};
struct defined_value : seq<expression> {};
struct definition_sign : seq<equals, wide_gap> {};
struct definition : seq<definition_sign, must<defined_value>> {};
struct plain : seq<expression, opt<definition>> {};
struct statement : sor<sweep, animate, print, assertion, check, prove, verify, use, setting, plain> {};
struct byte_order_mark : utf8::bom {};
struct end : eof {};
struct program : seq<opt<byte_order_mark>, separators, star<statement, must<statement_end>, separators>, must<end>> {};
struct lone_value : seq<expression> {};
struct lone_end : eof {};
struct lone_expression : seq<wide_gap, must<lone_value>, wide_gap, must<lone_end>> {};

// ---- the two rules that ask the builder
struct gap {
  using rule_t = gap;
  using subs_t = type_list<wide_gap, narrow_gap>;
  template <apply_mode A, rewind_mode M, template <class...> class Action, template <class...> class Control, class Input,
            class State>
  static bool match(Input& in, State& state) {
    if (state.inside_brackets()) return Control<wide_gap>::template match<A, M, Action, Control>(in, state);
    return Control<narrow_gap>::template match<A, M, Action, Control>(in, state);
  }
};
struct star_allowed {
  using rule_t = star_allowed;
  using subs_t = empty_list;
  template <apply_mode A, rewind_mode M, template <class...> class Action, template <class...> class Control, class Input,
            class State>
  static bool match(Input& in, State& state) {
    return state.star_may_stand(in.current());
  }
};

}  // namespace udcp::grammar::rules

namespace tao::pegtl {
template <class Name>
struct analyze_traits<Name, udcp::grammar::rules::gap> : analyze_opt_traits<> {};
template <class Name>
struct analyze_traits<Name, udcp::grammar::rules::star_allowed> : analyze_opt_traits<> {};
}  // namespace tao::pegtl
