// Work in pieces: all of it, once, whatever the number of threads, and its errors.
#include "operators/plan/parallel.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <atomic>
#include <stdexcept>
#include <thread>
#include <vector>

#include "operators/run.h"
#include "tests/oracle/refusal.h"

using namespace udcp;

TEST_SUITE("operators") {
  TEST_CASE("every piece of work is done once by any number of threads") {
    for (const int threads : {0, 1, 2, 3, 8}) {
      for (const int pieces : {0, 1, 2, 7, 100}) {
        std::vector<std::atomic<int>> done(static_cast<std::size_t>(pieces));
        for_each_piece(pieces, threads, {}, [&](std::int64_t piece) { ++done[static_cast<std::size_t>(piece)]; });
        for (const auto& count : done) CHECK(count == 1);
      }
    }
  }

  TEST_CASE("progress rises to its end and comes from the caller") {
    const auto caller = std::this_thread::get_id();
    std::vector<double> said;
    std::atomic<int> by_others = 0;
    RunControl control;
    control.progress = [&](double fraction) {
      if (std::this_thread::get_id() == caller) {
        said.push_back(fraction);
      } else {
        ++by_others;
      }
    };
    std::atomic<bool> other_worked = false;  // the caller waits for it with its first piece
    for_each_piece(50, 2, control, [&](std::int64_t) {
      if (std::this_thread::get_id() != caller) other_worked = true;
      while (!other_worked) std::this_thread::yield();
    });
    CHECK(by_others == 0);
    CHECK(std::is_sorted(said.begin(), said.end()));
    REQUIRE_FALSE(said.empty());
    CHECK(said.back() == 1);
  }

  TEST_CASE("the first failure of a piece ends the work and reaches the caller") {
    for (const int threads : {1, 2, 4}) {
      std::atomic<int> done = 0;
      const auto work = [&](std::int64_t piece) {
        if (piece == 3) throw std::runtime_error("piece 3");
        ++done;
      };
      CHECK_THROWS_WITH(for_each_piece(100'000, threads, {}, work), "piece 3");
      if (threads == 1) CHECK(done == 3);
    }
    std::atomic<bool> stop = true;
    RunControl control;
    control.stop = &stop;
    CHECK(oracle::refusal([&] { for_each_piece(10, 2, control, [](std::int64_t) {}); }).starts_with("E_INTERRUPTED"));
  }
}
