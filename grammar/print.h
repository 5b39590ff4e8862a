// Syntax tree to canonical text: udcp fmt, and every place that shows a word or an expression.
#pragma once

#include <string>

#include "grammar/ast.h"

namespace udcp::grammar {

/// parse(to_string(p)) is the same program; to_string(parse(to_string(p))) is the same text. Comments and single blank lines
/// stay. Lines longer than 110 columns are broken before |> and where, and between the bindings of a where.
std::string to_string(const Program&);
/// On one line; where bindings stand in braces where a comma could follow.
std::string to_string(const Expr&);
std::string to_string(const WordExpr&);

}  // namespace udcp::grammar
