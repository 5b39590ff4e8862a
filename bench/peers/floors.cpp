// What memory alone costs: no refinement is faster than writing its result.
// --bytes N says how many.
// --way triad:  STREAM's triad a = b + s c over arrays touched before, the three of them together so many bytes.
//       fresh:  the first store to every page of so many bytes; fresh_huge: the same after madvise(MADV_HUGEPAGE).
#include <sys/mman.h>

#include <algorithm>
#include <memory>

#include "bench/peers/harness.h"

namespace {

using namespace peers;

/// A small triad would stay in the cache: then the time is that of a large one, scaled.
Program triad(std::size_t bytes) {
  const std::size_t moved = std::max<std::size_t>(bytes, std::size_t{192} << 20);
  const std::size_t n = moved / (3 * sizeof(double));
  auto arrays = std::make_shared<std::vector<double>>(3 * n, 1.0);
  Program program;
  program.run = [arrays, n, s = 0.5]() mutable {
    double* a = arrays->data();
    const double *b = a + n, *c = b + n;
    for (std::size_t k = 0; k < n; ++k) a[k] = b[k] + s * c[k];
    s = a[n / 2] > 2 ? 0.25 : 0.5;  // the result is used: the loop stays
  };
  program.sizes = [moved] { return Sizes{0, 0, static_cast<std::int64_t>(moved)}; };
  program.result = [] { return Result{}; };
  return program;
}

Program fresh(std::size_t bytes, bool huge) {
  constexpr std::size_t step = std::size_t{2} << 20;
  const std::size_t whole = (bytes + step - 1) / step * step;
  auto block = std::make_shared<void*>(nullptr);
  Program program;
  program.drop = [block, whole] {
    if (*block) munmap(*block, whole + step);
    *block = nullptr;
  };
  program.run = [block, whole, bytes, huge] {
    *block = mmap(nullptr, whole + step, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (*block == MAP_FAILED) refuse("the system refuses the memory");
    const auto address = (reinterpret_cast<std::uintptr_t>(*block) + step - 1) / step * step;
    auto* data = reinterpret_cast<double*>(address);
    if (huge) madvise(data, whole, MADV_HUGEPAGE);
    std::fill(data, data + bytes / sizeof(double), 1.0);
  };
  program.sizes = [bytes] { return Sizes{0, 0, static_cast<std::int64_t>(bytes)}; };
  program.result = [] { return Result{}; };
  return program;
}

Program make(const Job& job, const Cage&) {
  const std::size_t bytes = static_cast<std::size_t>(job.bytes);
  if (job.way == "triad") return triad(bytes);
  if (job.way == "fresh" || job.way == "fresh_huge") return fresh(bytes, job.way == "fresh_huge");
  refuse("the floors are triad, fresh and fresh_huge");
}

}  // namespace

int main(int argc, char** argv) { return run_main(argc, argv, make); }
