// Expressions and words as text: the half of print.h that knows no statements.
#pragma once

#include <string>

#include "grammar/ast.h"

namespace udcp::grammar {

/// How an expression is laid out.
struct Layout {
  bool braces = false;     // a where stands in braces, because a comma or a keyword may follow
  bool broken = false;     // line breaks before |> and where outside brackets
  std::size_t indent = 0;  // of the statement, in blanks
};

/// What may stand in a place without brackets: everything, all but pipes, or an operation.
enum class Position { expression, value, operation };

void print(std::string& out, const Expr& expr, Position position, const Layout& layout);
void print(std::string& out, const WordExpr& word, const Layout& layout);
/// In double quotes, with escapes.
std::string quoted(const std::string& text);

inline constexpr std::size_t widest_line = 110;

}  // namespace udcp::grammar
