// The read-eval-print loop on libedit.
#pragma once

#include "interpreter/session.h"

namespace udcp {

struct ReplOptions {
  bool colour = false;
  bool json = false;
};
/// Runs until :quit or Ctrl-D; returns the exit code. History lies in $XDG_STATE_HOME/udcp (or ~/.local/state/udcp).
int repl(Session& session, const ReplOptions& options);

/// What the editor offers for the word before the cursor: names, keywords, arguments of known functions, files inside quotes,
/// :commands.
std::vector<std::string> completions(const Session& session, const std::string& line, std::size_t cursor);

}  // namespace udcp
