// From a place where a committed rule failed to a SyntaxError: what was expected comes from the table, what stands there is
// looked at here (the end, a stray character, a keyword, the wrong bracket). Knows the characters of the language and no rules.
#pragma once

#include <cstddef>
#include <string_view>

#include "grammar/parse.h"

namespace udcp::grammar {

/// What a committing rule says when it fails. `kind` tells what can be wrong besides:
/// value and sign: something else stands there, or the text ended; bracket: the same, and a bracket is open;
/// letters: the token before is malformed, so more text does not help; number: the same with code E_NUMBER.
struct Message {
  enum class Kind { value, sign, bracket, letters, number };
  Kind kind = Kind::value;
  const char* text = nullptr;
  const char* label = nullptr;
  const char* help = nullptr;
};

/// `open` is the innermost open bracket, or nullptr.
SyntaxError diagnose(const Message& message, std::string_view text, std::size_t place, const Span* open);

}  // namespace udcp::grammar
