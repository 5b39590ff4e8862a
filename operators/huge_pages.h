// A wish to the system about fresh memory. Changes no result.
#pragma once

#include <cstddef>
#include <cstdint>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace udcp {

/// Asks for huge pages behind memory that nobody has written yet: first writes then fault 512 times less often, which is a third
/// of the time of a large refinement. Nothing happens for small blocks and on other systems.
inline void prefer_huge_pages([[maybe_unused]] void* data, [[maybe_unused]] std::size_t bytes) {
#if defined(__linux__)
  constexpr std::size_t huge = std::size_t{1} << 21;
  if (bytes < 2 * huge) return;
  const auto address = reinterpret_cast<std::uintptr_t>(data);
  const std::uintptr_t first = (address + huge - 1) / huge * huge, end = (address + bytes) / huge * huge;
  madvise(static_cast<char*>(data) + (first - address), end - first, MADV_HUGEPAGE);
#endif
}

}  // namespace udcp
