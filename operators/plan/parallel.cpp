// One counter, a few threads.
#include "operators/plan/parallel.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

#include "operators/interrupt.h"
#include "operators/run.h"

namespace udcp {
namespace {

class Pieces {
 public:
  Pieces(std::int64_t pieces, const RunControl& control, const std::function<void(std::int64_t)>& work)
      : pieces_(pieces), control_(control), work_(work) {}

  // Takes pieces until there are none, or until one failed.
  void take(bool is_caller) noexcept {
    try {
      for (std::int64_t piece = next_++; piece < pieces_; piece = next_++) {
        throw_if_stopped(control_.stop);
        work_(piece);
        if (is_caller && control_.progress) control_.progress(static_cast<double>(piece) / static_cast<double>(pieces_));
      }
    } catch (...) {
      next_ = pieces_;
      const std::lock_guard lock(mutex_);
      if (!failure_) failure_ = std::current_exception();
    }
  }

  void rethrow() const {
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  std::int64_t pieces_;
  const RunControl& control_;
  const std::function<void(std::int64_t)>& work_;
  std::atomic<std::int64_t> next_{0};
  std::mutex mutex_;
  std::exception_ptr failure_;
};

}  // namespace

void for_each_piece(std::int64_t pieces, int threads, const RunControl& control, const std::function<void(std::int64_t)>& work) {
  Pieces shared(pieces, control, work);
  std::vector<std::thread> others;
  const std::int64_t helpers = std::min<std::int64_t>(threads, pieces) - 1;
  try {
    for (std::int64_t k = 0; k < helpers; ++k) others.emplace_back([&shared] { shared.take(false); });
  } catch (const std::system_error&) {
    // the system has no more threads; those that started do the work
  }
  shared.take(true);
  for (std::thread& other : others) other.join();
  shared.rethrow();
  if (control.progress) control.progress(1);
}

}  // namespace udcp
