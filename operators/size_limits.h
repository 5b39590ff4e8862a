// The refusals of results that would be too large, said in one way. Checked before anything is allocated.
#pragma once

#include <cstdint>
#include <string>

#include "operators/error.h"

namespace udcp {

/// Throws Error{limit, "E_MAX_FACES"}; `what` is "faces" or "points".
inline void check_elements(std::int64_t elements, const char* what, std::int64_t limit) {
  if (elements <= limit) return;
  throw Error(ErrorKind::limit, "E_MAX_FACES",
              "the result would have " + std::to_string(elements) + " " + what + "; the limit is " + std::to_string(limit),
              "apply fewer rounds, or raise the limit (--max-faces, set max_faces)");
}

/// Throws Error{limit, "E_MAX_MEMORY"}; no limit where it is 0.
inline void check_memory(std::int64_t needed, std::int64_t limit) {
  if (limit <= 0 || needed <= limit) return;
  throw Error(ErrorKind::limit, "E_MAX_MEMORY",
              "the result would need about " + std::to_string(needed >> 20) + " MiB; the limit is " +
                  std::to_string(limit >> 20) + " MiB",
              "apply fewer rounds");
}

}  // namespace udcp
