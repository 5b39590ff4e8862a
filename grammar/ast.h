// The syntax tree. Every node carries its Span (bytes of the source); equality ignores spans. Knows no geometry: names, numbers
// as text, words as they were written.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "grammar/source.h"

namespace udcp::grammar {

struct Expr;
using ExprPtr = std::shared_ptr<const Expr>;

/// "0.8", "12", "1e-3": text until the interpreter makes it exact; digits, one point with digits on both sides, an exponent.
struct Number {
  std::string text;
};
/// A text without its quotes and with escapes resolved; "{d}" is left in place.
struct Text {
  std::string raw;
};
/// Greek letters are spelled out already: omega, delta, alpha, alpha0, pi. N and oo are names.
struct Name {
  std::string name;
};
/// v.name
struct Attribute {
  std::string name;
};
/// "-", "not"
struct Unary {
  std::string op;
  ExprPtr operand;
};
/// + - * / ^ == != < <= > >= and or
struct Binary {
  std::string op;
  ExprPtr left, right;
};
/// if condition then a else b
struct Conditional {
  ExprPtr condition, then, otherwise;
};
/// [a, b]
struct List {
  std::vector<ExprPtr> items;
};
/// a .. b step s; step may be null.
struct Range {
  ExprPtr first, last, step;
};
/// (a, b], only as the set of a Domain.
struct Interval {
  ExprPtr lower, upper;
  bool lower_open = false, upper_open = false;
};

/// name = value, name@lat = value, name(alpha) = value.
struct Binding {
  std::string name;       // f, omega, delta, alpha0, rings, ngon
  std::string direction;  // "", "lat", "lon", "face"
  std::string parameter;  // the name in parentheses, or ""
  ExprPtr value;
  Span span;
};

/// An empty name marks a positional argument. name = value; or name in set, as in the domains of claims.
struct Argument {
  std::string name;
  ExprPtr value;
  Span span;
  bool in = false;  // name in set
};
struct Call {
  std::string name;
  std::vector<Argument> arguments;
};
/// object.name(arguments)
struct Method {
  ExprPtr object;
  std::string name;
  std::vector<Argument> arguments;
};
/// object[index]
struct Index {
  ExprPtr object;
  ExprPtr index;
};

struct WordExpr;
struct AtomItem {
  char letter = 'U';
};
struct GroupItem {
  std::shared_ptr<const WordExpr> word;
};
struct NamedItem {
  std::string name;
  bool has_arguments = false;
  std::vector<Argument> arguments;
};
/// One item of a word, with its arguments and repeat; at most one of `star` and `power` is set.
struct WordItem {
  using Atom = AtomItem;
  using Group = GroupItem;
  using Named = NamedItem;
  std::variant<Atom, Group, Named> what;
  ExprPtr sections;               // U[3]; only on the atom U
  std::vector<Binding> bindings;  // C[f = ...], P[delta = 1/2, omega = 1]
  bool star = false;              // only on the last item, never on an atom, and not inside a group
  ExprPtr power;                  // ^n
  Span span;
};
struct WordExpr {
  std::vector<WordItem> items;  // left to right, also when written P . C . U
  bool written_right_to_left = false;
  bool on_triangles = false;
  std::vector<Binding> where;
};

/// input |> step
struct Pipe {
  ExprPtr input;
  ExprPtr step;
};
/// save "x.glb", plot("x.svg", size = 3), print: `verb` is the name; save and plot have at least one argument.
struct Step {
  std::string verb;
  std::vector<Argument> arguments;
};

/// A name, a call and a power of them (catmull_clark, circle(5)^6) are Name, Call and Binary "^", and so is a scheme in brackets
/// with a power, ((UCP)*)^4. Whatever has an atom letter, a star, two items side by side, "where" or "on" is a WordExpr.
struct Expr {
  std::variant<Number, Text, Name, Attribute, Unary, Binary, Conditional, List, Range, Interval, Call, Method, Index, WordExpr,
               Pipe, Step>
      node;
  Span span;
};

/// One part of "for f in (0, oo), N in 3 .. 8": the set is an Interval, a Range, or any expression.
struct Domain {
  std::string name;
  ExprPtr set;
  Span span;
};

struct Statement;
/// name = value, name(p, q) = value
struct Define {
  std::string name;
  bool is_function = false;
  std::vector<std::string> parameters;
  ExprPtr value;
};
struct Evaluate {
  ExprPtr value;
};
struct Print {
  std::vector<ExprPtr> values;
};
/// sweep name in range { body }
struct Sweep {
  std::string name;
  ExprPtr range;
  std::vector<Statement> body;
  std::vector<std::string> comments_after;  // before the closing brace
};
/// animate name in range frames n { body }
struct Animate {
  std::string name;
  ExprPtr range;
  ExprPtr frames;
  std::vector<Statement> body;
  std::vector<std::string> comments_after;
};
struct Assert {
  ExprPtr condition;
};
/// check / prove claim for domains -> "certificate"
struct Claim {
  bool prove = false;
  ExprPtr claim;
  std::vector<Domain> domains;
  std::optional<std::string> certificate;
};
struct Verify {
  std::string path;
};
struct Use {
  std::string path;
};
/// set name = value
struct Set {
  std::string name;
  ExprPtr value;
};

/// Comments stand without their '#'; the entry "\n" is a blank line between or after them.
struct Statement {
  std::variant<Define, Evaluate, Print, Sweep, Animate, Assert, Claim, Verify, Use, Set> node;
  Span span;
  std::vector<std::string> comments_before;  // whole lines above
  std::string comment_after;                 // on the last line; empty: none
  bool blank_before = false;                 // one blank line or more stood before the comments
};

struct Program {
  std::vector<Statement> statements;
  std::vector<std::string> comments_after;  // at the end of the text
};

/// How deep expressions of a parsed text nest in each other, chains of operators included: recursion over a tree is safe.
inline constexpr std::size_t max_tree_depth = 500;

/// How strongly an operator binds; larger is stronger: or, and, not, comparisons, + and -, * and /, a sign, items side by side,
/// ^.
namespace precedence {
inline constexpr int disjunction = 1, conjunction = 2, negation = 3, comparison = 4, sum = 5, product = 6, sign = 7, items = 8,
                     power = 9;
}
/// The precedence of a Binary operator.
int precedence_of(const std::string& op);

bool same(const Expr&, const Expr&);        // equal up to spans
bool same(const Program&, const Program&);  // equal up to spans, comments and blank lines

}  // namespace udcp::grammar
