// The REPL without its editor: takes lines, answers on a console. Tests drive it directly; repl.cpp feeds it from libedit.
#pragma once

#include <functional>
#include <string>

#include "interpreter/console.h"
#include "interpreter/interrupt.h"

namespace udcp {

class ReplLoop {
 public:
  /// Results of the session go to `console` from now on. `after_error` runs after every failure (the REPL forgets a Ctrl-C
  /// there).
  ReplLoop(Session& session, Console& console, std::function<void()> after_error = {});

  /// "udcp> ", or "....> " while a statement is unfinished.
  [[nodiscard]] const char* prompt() const;
  /// Takes one line without its newline; false after :quit.
  bool line(const std::string& text);
  /// Ctrl-C at the prompt: forgets the unfinished statement.
  void abandon() { pending_.clear(); }

 private:
  void run(const std::string& text, const std::string& name, const std::filesystem::path& folder = {});
  bool command(const std::string& text);
  void guarded(const std::function<void()>& action);
  void show_type(const std::string& expression);
  void load(const std::string& file);
  void save(const std::string& file);
  void time(const std::string& statement);
  void set(const std::string& assignment);
  void undo();

  Session& session_;
  Console& console_;
  std::function<void()> after_error_;
  std::string pending_;
  bool muted_ = false;
};

/// What a bare word prints: its kind, bindings and defaults, and on curves its mask and support.
std::string describe_word(const WordValue& word, Session& session);
/// The text of :help; of a topic, a function or an error code. Empty if there is no such topic.
std::string help_topic(const std::string& topic);

struct ReplCommand {
  const char* name;      // ":load"
  const char* argument;  // "FILE"
  const char* help;
};
std::span<const ReplCommand> repl_commands();

/// Where the word that completions() replaces begins.
std::size_t completion_begin(const std::string& line, std::size_t cursor);

}  // namespace udcp
