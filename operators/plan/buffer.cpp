// Blocks of memory: small ones from the heap, large ones as pages of their own.
#include "operators/plan/buffer.h"

#include <cstdlib>
#include <new>
#include <string>

#include "operators/error.h"

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace udcp {
namespace {

[[noreturn]] void refused(std::size_t bytes) {
  throw Error(ErrorKind::limit, "E_MAX_MEMORY",
              "the result needs about " + std::to_string(bytes >> 20U) + " MiB, which the system does not have",
              "apply fewer rounds");
}

constexpr std::size_t huge_page = std::size_t{1} << 21U;
constexpr std::size_t alignment = 64;  // a cache line, the widest vector register

#if defined(__linux__)
// Maps one huge page more than needed and gives back what lies before and behind, so that the block starts on a huge page.
void* map_pages(std::size_t bytes) {
  const std::size_t wanted = (bytes + huge_page - 1) / huge_page * huge_page;
  void* mapped = mmap(nullptr, wanted + huge_page, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (mapped == MAP_FAILED) refused(bytes);
  auto* first = static_cast<char*>(mapped);
  const std::size_t before = (huge_page - reinterpret_cast<std::size_t>(first) % huge_page) % huge_page;
  if (before > 0) munmap(first, before);
  if (before < huge_page) munmap(first + before + wanted, huge_page - before);
  madvise(first + before, wanted, MADV_HUGEPAGE);  // a wish: without it everything works, a little slower
  return first + before;
}

void unmap_pages(void* block, std::size_t bytes) noexcept { munmap(block, (bytes + huge_page - 1) / huge_page * huge_page); }
#else
void* map_pages(std::size_t bytes) {
  void* block = ::operator new(bytes, std::align_val_t(alignment), std::nothrow);
  if (block == nullptr) refused(bytes);
  return block;
}

void unmap_pages(void* block, std::size_t) noexcept { ::operator delete(block, std::align_val_t(alignment)); }
#endif

}  // namespace

void* allocate_block(std::size_t bytes) {
  if (bytes == 0) return nullptr;
  if (bytes > (static_cast<std::size_t>(-1) >> 2U)) refused(bytes);
  if (bytes >= 2 * huge_page) return map_pages(bytes);
  void* block = ::operator new(bytes, std::align_val_t(alignment), std::nothrow);
  if (block == nullptr) refused(bytes);
  return block;
}

void free_block(void* block, std::size_t bytes) noexcept {
  if (block == nullptr) return;
  if (bytes >= 2 * huge_page) {
    unmap_pages(block, bytes);
  } else {
    ::operator delete(block, std::align_val_t(alignment));
  }
}

}  // namespace udcp
