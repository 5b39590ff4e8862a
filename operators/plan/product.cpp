// Written once with the vectors of gcc and clang, compiled for the baseline and for AVX2, chosen when the program runs.
#include "operators/plan/product.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <utility>

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace udcp {
namespace {

// Inlined into functions for wider vectors than the file is compiled for.
#define UDCP_INLINE __attribute__((always_inline)) inline

template <class R, int W>
struct Vector {
  typedef R Type __attribute__((vector_size(W * sizeof(R))));
  typedef R Unaligned __attribute__((vector_size(W * sizeof(R)), aligned(alignof(R)), may_alias));
};

// Number l of vector v of x0 y0 z0 x1 y1 .. : coordinate g % 3 of point g / 3 where g = v W + l.
template <int W, int v, int... lane>
struct Interleave {
  static constexpr int from(int l) { return (v * W + l) / 3; }
  static constexpr int coordinate(int l) { return (v * W + l) % 3; }
  template <class V>
  static UDCP_INLINE void store(const V& x, const V& y, const V& z, V& out) {
    const V xy = __builtin_shufflevector(x, y, (coordinate(lane) == 0 ? from(lane) : W + from(lane))...);
    out = __builtin_shufflevector(xy, z, (coordinate(lane) == 2 ? W + from(lane) : lane)...);
  }
};

template <class R, int W, int... lane>
UDCP_INLINE void store_interleaved(const typename Vector<R, W>::Type& x, const typename Vector<R, W>::Type& y,
                                   const typename Vector<R, W>::Type& z, R* out, std::integer_sequence<int, lane...>) {
  using V = typename Vector<R, W>::Type;
  using Target = typename Vector<R, W>::Unaligned;
  V v;
  Interleave<W, 0, lane...>::store(x, y, z, v);
  *reinterpret_cast<Target*>(out) = v;
  Interleave<W, 1, lane...>::store(x, y, z, v);
  *reinterpret_cast<Target*>(out + W) = v;
  Interleave<W, 2, lane...>::store(x, y, z, v);
  *reinterpret_cast<Target*>(out + 2 * W) = v;
}

template <class R, int W>
UDCP_INLINE void multiply_panels(const R* matrix, int columns, int panels, const R* points, const R* origin, R* out) {
  using V = typename Vector<R, W>::Type;
  constexpr int parts = panel_rows<R> / W;
  for (int panel = 0; panel < panels; ++panel) {
    V x[parts] = {}, y[parts] = {}, z[parts] = {};
    for (int k = 0; k < columns; ++k, matrix += panel_rows<R>) {
      const R* p = points + 3 * k;
      for (int part = 0; part < parts; ++part) {
        const V weight = *reinterpret_cast<const V*>(matrix + part * W);
        x[part] += weight * p[0];
        y[part] += weight * p[1];
        z[part] += weight * p[2];
      }
    }
    for (int part = 0; part < parts; ++part, out += 3 * W)
      store_interleaved<R, W>(x[part] + origin[0], y[part] + origin[1], z[part] + origin[2], out,
                              std::make_integer_sequence<int, W>{});
  }
}

template <class R>
using Multiply = void (*)(const R*, int, int, const R*, const R*, R*);

template <class R>
void multiply_baseline(const R* matrix, int columns, int panels, const R* points, const R* origin, R* out) {
  multiply_panels<R, 16 / sizeof(R)>(matrix, columns, panels, points, origin, out);
}

#if defined(__x86_64__)
template <class R>
__attribute__((target("avx2"))) void multiply_avx2(const R* matrix, int columns, int panels, const R* points, const R* origin,
                                                   R* out) {
  multiply_panels<R, 32 / sizeof(R)>(matrix, columns, panels, points, origin, out);
}

template <class R>
Multiply<R> best_multiply() {
  return __builtin_cpu_supports("avx2") != 0 ? multiply_avx2<R> : multiply_baseline<R>;
}
#else
template <class R>
Multiply<R> best_multiply() {
  return multiply_baseline<R>;
}
#endif

#undef UDCP_INLINE

}  // namespace

template <class R>
PanelMatrix<R> make_panels(const Points<double>& matrix, const std::vector<int>& rows, const std::vector<int>& columns) {
  PanelMatrix<R> result{static_cast<int>(rows.size()), static_cast<int>(columns.size()), {}};
  constexpr std::size_t height = panel_rows<R>;
  const auto panels = static_cast<std::size_t>(result.panels());
  result.values = Buffer<R>(panels * height * columns.size());
  R* out = result.values.data();
  for (std::size_t first = 0; first < panels * height; first += height)
    for (const int column : columns)
      for (std::size_t row = first; row < first + height; ++row)
        *out++ = row < rows.size() ? static_cast<R>(matrix(rows[row], column)) : R(0);
  return result;
}

template <class R>
void multiply(const PanelMatrix<R>& matrix, int first, int last, const R* points, const R* origin, R* out) {
  static const Multiply<R> chosen = best_multiply<R>();
  chosen(matrix.panel(first), matrix.columns, last - first, points, origin, out);
}

template <class R>
std::size_t stream_copy(R* to, const R* from, std::size_t count, bool to_end) {
#if defined(__x86_64__)
  constexpr std::size_t line = 64;
  const std::size_t before = std::min(count, (line - reinterpret_cast<std::uintptr_t>(to) % line) % line / sizeof(R));
  const std::size_t lines = (count - before) * sizeof(R) / line, end = before + lines * line / sizeof(R);
  std::memcpy(to, from, before * sizeof(R));
  auto* target = reinterpret_cast<__m128i*>(to + before);
  const auto* source = reinterpret_cast<const __m128i*>(from + before);
  for (std::size_t k = 0; k < lines * line / sizeof(__m128i); ++k) _mm_stream_si128(target + k, _mm_loadu_si128(source + k));
  if (!to_end) return end;
  std::memcpy(to + end, from + end, (count - end) * sizeof(R));
#else
  (void)to_end;
  std::memcpy(to, from, count * sizeof(R));
#endif
  return count;
}

#define UDCP_INSTANTIATE(R)                                                                                     \
  template PanelMatrix<R> make_panels(const Points<double>&, const std::vector<int>&, const std::vector<int>&); \
  template void multiply(const PanelMatrix<R>&, int, int, const R*, const R*, R*);                              \
  template std::size_t stream_copy(R*, const R*, std::size_t, bool);
UDCP_INSTANTIATE(float)
UDCP_INSTANTIATE(double)
#undef UDCP_INSTANTIATE

}  // namespace udcp
