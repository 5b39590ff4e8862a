// Session: the bindings of a program or a REPL, and the one way to run source text. Never prints by itself: results go to
// `output`.
#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "grammar/parse.h"
#include "interpreter/value.h"

namespace udcp {

struct Settings {
  int precision = 128;  // bits of enclosures
  std::int64_t max_faces = 50'000'000;
  std::int64_t max_bytes = 0;  // 0: three quarters of the physical memory
  int threads = 0;             // that plans are executed on; 0: all
  std::uint64_t seed = 0;      // added to every noise seed
  bool quiet = false;
};

/// What a session tells its surroundings. Any member may be empty.
struct Output {
  std::function<void(const Value&)> value;                  // a printed value
  std::function<void(const std::string& message)> warning;  // one sentence, with place where known
  std::function<void(const std::string& what, double fraction)> progress;
};

/// An error with the text it belongs to, ready for a caret: what run() throws for every failure inside a program.
struct ProgramError : std::runtime_error {
  ProgramError(const std::string& message) : std::runtime_error(message) {}
  ErrorKind kind = ErrorKind::internal;
  bool syntax = false, incomplete = false;
  std::string code;  // symbolic
  std::string help, label, file;
  std::string source;  // whole text
  grammar::Span span;  // in it
};

/// The worst outcome so far decides the exit code: 0 done, 1 an assertion or claim is false, 3 undecided.
enum class Outcome { done, refuted, undecided };

class Session {
 public:
  explicit Session(Settings settings = {}, Output output = {});

  /// Runs a program; `name` stands in diagnostics ("tour.udcp", "<command line>"); relative paths start at `folder`. Returns the
  /// value of the last statement, or Nothing. Throws ProgramError; bindings made by earlier statements stay.
  Value run(std::string_view source, const std::string& name = "<input>", const std::filesystem::path& folder = {});
  void load_prelude();
  /// Takes back the last successful run() that changed bindings; false if there is none.
  bool undo();
  /// Safe to call from a signal handler: the running computation ends with Error{interrupted}.
  void interrupt() noexcept;
  void clear_interrupt() noexcept;

  [[nodiscard]] Outcome outcome() const;
  [[nodiscard]] const Settings& settings() const;
  Settings& settings();
  [[nodiscard]] Output& output();
  [[nodiscard]] const Value* find(const std::string& name) const;
  /// Names for completion, prelude included.
  [[nodiscard]] std::vector<std::string> names() const;
  /// The statements that ran without error since the prelude, as a program that runs again.
  [[nodiscard]] std::string program() const;

 private:
  struct State;
  std::shared_ptr<State> state_;
};

}  // namespace udcp
