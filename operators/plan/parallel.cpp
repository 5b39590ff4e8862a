// A counter per thread.
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

// Every thread begins with a share of its own and then helps with the others', and every share begins at another place in itself:
// threads that work side by side in fresh memory wait for the same pages, and pieces of different shares may lie side by side, as
// faces of different kinds do.
class Pieces {
 public:
  Pieces(std::int64_t pieces, std::size_t threads, const RunControl& control, const std::function<void(std::int64_t)>& work)
      : pieces_(pieces), shares_(threads), control_(control), work_(work) {}

  // Takes pieces until there are none, or until one failed. Thread 0 is the caller.
  void take(std::size_t thread) noexcept {
    try {
      for (std::size_t k = 0; k < shares_.size(); ++k) take_share((thread + k) % shares_.size(), thread == 0);
    } catch (...) {
      has_failed_ = true;
      const std::lock_guard lock(mutex_);
      if (!failure_) failure_ = std::current_exception();
    }
  }

  void rethrow() const {
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  struct alignas(64) Share {
    std::atomic<std::int64_t> taken{0};
  };

  [[nodiscard]] std::int64_t part(std::int64_t of, std::size_t shares) const {
    return of * static_cast<std::int64_t>(shares) / static_cast<std::int64_t>(shares_.size());
  }

  void take_share(std::size_t share, bool is_caller) {
    const std::int64_t first = part(pieces_, share), size = part(pieces_, share + 1) - first, start = part(size, share);
    for (std::int64_t k = shares_[share].taken++; k < size && !has_failed_; k = shares_[share].taken++) {
      throw_if_stopped(control_.stop);
      work_(first + (start + k) % size);
      const std::int64_t done = ++done_;
      if (is_caller && control_.progress) control_.progress(static_cast<double>(done) / static_cast<double>(pieces_));
    }
  }

  std::int64_t pieces_;
  std::vector<Share> shares_;
  const RunControl& control_;
  const std::function<void(std::int64_t)>& work_;
  std::atomic<std::int64_t> done_{0};
  std::atomic<bool> has_failed_{false};
  std::mutex mutex_;
  std::exception_ptr failure_;
};

}  // namespace

void for_each_piece(std::int64_t pieces, int threads, const RunControl& control, const std::function<void(std::int64_t)>& work) {
  const auto used = static_cast<std::size_t>(std::max<std::int64_t>(1, std::min<std::int64_t>(threads, pieces)));
  Pieces shared(pieces, used, control, work);
  std::vector<std::thread> others;
  try {
    for (std::size_t k = 1; k < used; ++k) others.emplace_back([&shared, k] { shared.take(k); });
  } catch (const std::system_error&) {
    // the system has no more threads; those that started do the work
  }
  shared.take(0);
  for (std::thread& other : others) other.join();
  shared.rethrow();
  if (control.progress) control.progress(1);
}

}  // namespace udcp
