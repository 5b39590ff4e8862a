// The handler does what a handler may: it looks at lock-free atomics and calls Session::interrupt, which sets one more.
#include "interpreter/interrupt.h"

namespace udcp {
namespace {

std::atomic<Session*> receiver{nullptr};
std::atomic<bool> stop_requested{false};
static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<Session*>::is_always_lock_free);

extern "C" void udcp_on_interrupt(int signal_number) {
  if (stop_requested.exchange(true)) {
    std::signal(signal_number, SIG_DFL);
    std::raise(signal_number);
    return;
  }
  if (Session* session = receiver.load()) session->interrupt();
}

}  // namespace

InterruptGuard::InterruptGuard(Session& session) : session_(session) {
  stop_requested = false;
  receiver = &session;
  struct sigaction action {};
  action.sa_handler = udcp_on_interrupt;
  sigemptyset(&action.sa_mask);
  action.sa_flags = SA_RESTART;
  sigaction(SIGINT, &action, &before_);
}

InterruptGuard::~InterruptGuard() {
  sigaction(SIGINT, &before_, nullptr);
  receiver = nullptr;
}

const std::atomic<bool>& InterruptGuard::stop() const { return stop_requested; }

void InterruptGuard::clear() {
  stop_requested = false;
  session_.clear_interrupt();
}

}  // namespace udcp
