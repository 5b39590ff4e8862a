// Comments and blank lines find their statements. Works on a finished program and the places of its comments; knows no grammar.
#pragma once

#include <string_view>
#include <vector>

#include "grammar/ast.h"

namespace udcp::grammar {

/// Puts every comment at a statement or at the end of a block, by place: on the last line of a statement, above it, or, from
/// inside it, above it too. Comments come in order of place; their spans begin at '#'.
void place_comments(Program& program, std::string_view text, const std::vector<Span>& comments);

}  // namespace udcp::grammar
