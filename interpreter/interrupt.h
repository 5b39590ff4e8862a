// Ctrl-C: the first SIGINT asks the running computation to stop, the second one ends the process.
#pragma once

#include <atomic>
#include <csignal>

#include "interpreter/session.h"

namespace udcp {

/// While it lives, SIGINT goes to `session` and sets `stop()`. One at a time; the handler before it comes back at the end. The
/// handler needs process-wide state (there is no other way to reach it), which is private to interrupt.cpp.
class InterruptGuard {
 public:
  explicit InterruptGuard(Session& session);
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;

  /// For computations that run outside the session.
  [[nodiscard]] const std::atomic<bool>& stop() const;
  /// Forgets an interrupt, so that the next computation runs and the next Ctrl-C is a first one again.
  void clear();

 private:
  Session& session_;
  struct sigaction before_ {};
};

}  // namespace udcp
