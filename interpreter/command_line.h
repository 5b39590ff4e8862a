// What the user typed, taken apart: options and the action they ask for. Runs nothing.
#pragma once

#include <iosfwd>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "interpreter/session.h"

namespace udcp {

enum class Action { program, apply, prove, verify, format, explain, help, version };
enum class Corners { none, one_face, tagged };

struct CommandLine {
  Action action = Action::program;
  Settings settings;
  bool json = false;
  std::string colour = "auto";  // auto, always, never

  std::optional<std::string> code;  // -e
  std::vector<std::string> files;   // program, certificate, or files to format; empty: standard input
  std::string word, input;          // apply
  std::optional<int> rounds;
  std::string output, format;  // apply; certificate of prove
  Corners corners = Corners::tagged;
  bool limit = false;
  std::string claim;   // prove
  bool check = false;  // fmt --check
  std::string explain;
};

/// A mistake in the command line itself, as one sentence.
struct UsageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Throws UsageError.
CommandLine parse_command_line(int argc, const char* const* argv);

const char* help_text();     // one page
const char* version_text();  // "udcp 0.1.0"

}  // namespace udcp
