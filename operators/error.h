// The one error type of the library below the grammar. Library code throws it and never prints.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>

namespace udcp {

/// Decides the exit code of the command: input, word and not_exact 2; limit 4; file 5; interrupted 130.
enum class ErrorKind { input, word, not_exact, limit, file, interrupted, internal };

/// `code` is the symbolic name of the specification, such as "E_P_DUAL"; interpreter/report.cpp maps it to the printed code.
/// `message` names the thing and what was expected; `help` says what to do (may be empty).
struct Error : std::runtime_error {
  Error(ErrorKind error_kind, std::string error_code, const std::string& message, std::string error_help = {})
      : std::runtime_error(message), kind(error_kind), code(std::move(error_code)), help(std::move(error_help)) {}

  ErrorKind kind;
  std::string code;
  std::string help;
  std::string label;  // two or three words for beside the caret; may be empty
  int item = -1;      // index of the word item that is meant, counted over head then tail; -1: none
};

}  // namespace udcp
