// What a search may still spend: SearchLimits with a clock running. Knows nothing of what is searched.
#pragma once

#include <chrono>

#include "operators/interrupt.h"
#include "proofs/verdict.h"

namespace udcp {

class Budget {
 public:
  explicit Budget(const SearchLimits& limits) : limits_(limits), nodes_(limits.nodes), start_(std::chrono::steady_clock::now()) {}

  /// Throws Error{interrupted} when told to stop.
  void check_stop() const { throw_if_stopped(limits_.stop); }
  /// Takes nodes; false once the nodes or the seconds are used up. Throws Error{interrupted} when told to stop.
  bool spend(int nodes = 1) {
    check_stop();
    if (nodes_ < nodes) return false;
    nodes_ -= nodes;
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count() < limits_.seconds;
  }

 private:
  SearchLimits limits_;
  int nodes_;
  std::chrono::steady_clock::time_point start_;
};

}  // namespace udcp
