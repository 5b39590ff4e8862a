// Text to syntax tree.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

#include "grammar/ast.h"

namespace udcp::grammar {

/// `incomplete`: the text ended where more was expected, so a REPL asks for a further line instead of failing.
struct SyntaxError : std::runtime_error {
  SyntaxError(std::string error_code, const std::string& message, Span error_span, std::string error_help = {},
              std::string error_label = {})
      : std::runtime_error(message),
        code(std::move(error_code)),
        help(std::move(error_help)),
        label(std::move(error_label)),
        span(error_span) {}
  std::string code;  // symbolic: E_SYNTAX, E_NUMBER, E_STAR, E_DEPTH, E_LIMIT, E_ENCODING
  std::string help;
  std::string label;  // stands after the caret
  Span span;
  bool incomplete = false;
};

/// Throws SyntaxError. Refused are texts above 16 MiB or 250000 parts, invalid UTF-8 and NUL bytes, brackets above 200 levels and
/// trees deeper than max_tree_depth. Time and memory grow in proportion to the text.
Program parse(std::string_view source);
/// One expression or word, nothing after it: for `udcp apply 'WORD'`.
ExprPtr parse_expression(std::string_view source);

}  // namespace udcp::grammar
