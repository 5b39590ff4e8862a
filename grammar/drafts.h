// Drafts: operands whose place in the row still decides what they are. Here a name, a group and an atom become items of a word,
// and a power or a star finds out what it repeats. Pure functions of drafts; errors are SyntaxError and quote the text.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "grammar/ast.h"

namespace udcp::grammar {

struct Draft {
  Expr expr;
  std::size_t depth = 1;   // of the tree
  bool bracketed = false;  // stands in ( ): a group, if it becomes an item of a word
  bool product = false;    // P . C . U, items still in written order
  std::string direction;   // name@lat: only a binding may have it
};

/// An operator in the row; prefix operators and the barrier in front of a row have no left operand.
struct Operator {
  enum class Kind { barrier, prefix, infix, neighbour, dot };
  Kind kind = Kind::barrier;
  std::string sign;
  int precedence = 0;
  Span span;
};

/// The word that an expression in the place of an item means: names, calls, powers of them, words. None for numbers and the rest.
std::optional<WordExpr> as_word(const Expr& expr);

/// Any operand as a word of its own items: a word stays as it is, names, calls and brackets become one item. E_SYNTAX for values.
WordExpr items_of(Draft&& draft, std::string_view text);
/// A whole value as the word that `on triangles` and `where` complete; brackets around it are dropped unless they hold bindings.
WordExpr completed_word(Draft&& draft, std::string_view text);

/// The end of a draft: stars are checked, products turned; directions and intervals have no meaning as values.
void seal(Draft& draft, std::string_view text);
/// The node on the heap; E_DEPTH when the tree is deeper than max_tree_depth.
ExprPtr node(Draft&& draft);

/// Applies `op` (not a barrier) to its operands; `left` is ignored for prefix operators.
Draft apply(const Operator& op, Draft left, Draft right, std::string_view text);
/// The operand followed by a star.
Draft repeat(Draft operand, Span star, std::string_view text);

/// The source under a span, shortened for a message.
std::string quote(std::string_view text, Span span);

}  // namespace udcp::grammar
