// Where the command writes: results on one stream, diagnostics and progress on the other, as text or as JSON lines.
#pragma once

#include <chrono>
#include <iosfwd>
#include <string>

#include "interpreter/report.h"

namespace udcp {

/// A bar that appears once a task has run for a second, redraws at most ten times a second and leaves nothing behind.
class ProgressBar {
 public:
  using Clock = std::chrono::steady_clock;
  explicit ProgressBar(std::ostream& stream) : stream_(stream) {}
  /// `fraction` from 0 to 1; a new `what` or a smaller fraction is a new task.
  void update(const std::string& what, double fraction, Clock::time_point now = Clock::now());
  void erase();

 private:
  std::ostream& stream_;
  std::string what_;
  double fraction_ = 2;
  Clock::time_point begin_, drawn_;
  bool visible_ = false;
};

struct ConsoleOptions {
  bool json = false;
  bool quiet = false;  // neither warnings nor progress
  bool colour = false;
  bool progress = false;  // the stream of diagnostics is a terminal
};

class Console {
 public:
  Console(std::ostream& out, std::ostream& err, const ConsoleOptions& options)
      : out_(out), err_(err), options_(options), progress_(err) {}

  void value(const Value& value);  // Nothing prints nothing
  void text(const std::string& line);
  void warning(const std::string& message);
  void error(const ProgramError& error);
  void progress(const std::string& what, double fraction);
  void erase_progress() { progress_.erase(); }

  /// Callbacks into this console, which must outlive the session they are given to.
  [[nodiscard]] Output output();
  [[nodiscard]] const ConsoleOptions& options() const { return options_; }
  [[nodiscard]] std::ostream& out() { return out_; }
  /// Set once the results can no longer be written, with errno of that moment: EPIPE when the reader went away.
  [[nodiscard]] bool failed() const { return failed_; }
  [[nodiscard]] int failure() const { return failure_; }
  /// Called once when a result could not be written.
  std::function<void()> on_failure;
  void flush();

 private:
  std::ostream& out_;
  std::ostream& err_;
  ConsoleOptions options_;
  ProgressBar progress_;
  bool failed_ = false;
  int failure_ = 0;
};

}  // namespace udcp
