// One line from the terminal: libedit with history and completion. Knows nothing of sessions.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace udcp {

/// $XDG_STATE_HOME/udcp/history, or ~/.local/state/udcp/history; empty if neither is known.
std::filesystem::path history_file();

class LineEditor {
 public:
  struct Completion {
    std::size_t begin = 0;  // where the replaced word starts
    std::vector<std::string> words;
  };
  using Complete = std::function<Completion(const std::string& line, std::size_t cursor)>;
  enum class Read { line, interrupted, end };

  /// History is loaded from `history` (none if empty) and kept there, folder 0700 and file 0600.
  LineEditor(std::filesystem::path history, Complete complete);
  ~LineEditor();
  LineEditor(const LineEditor&) = delete;
  LineEditor& operator=(const LineEditor&) = delete;

  /// The line without its newline. Ctrl-C is `interrupted`, Ctrl-D on an empty line `end`.
  Read read(const std::string& prompt, std::string& line);
  /// Empty, or why the history cannot be kept; said once.
  std::string history_problem();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace udcp
