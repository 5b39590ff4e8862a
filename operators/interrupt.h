// The flag by which a caller stops a long computation, and the one way in which it ends then.
#pragma once

#include <atomic>

#include "operators/error.h"

namespace udcp {

/// Throws Error{interrupted, "E_INTERRUPTED"} once the flag is set; null: never.
inline void throw_if_stopped(const std::atomic<bool>* stop) {
  if (stop != nullptr && stop->load()) throw Error(ErrorKind::interrupted, "E_INTERRUPTED", "interrupted");
}

}  // namespace udcp
