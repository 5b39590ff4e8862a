// Written once with the vectors of gcc and clang, compiled for the baseline and for AVX2, chosen when the program runs.
#include "operators/plan/product.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <utility>

namespace udcp {
namespace {

// Inlined into functions for wider vectors than the file is compiled for.
#define UDCP_INLINE __attribute__((always_inline)) inline

template <class R, int W>
struct Vector {
  typedef R Type __attribute__((vector_size(W * sizeof(R))));
};

// Vectors of W numbers consist of groups of G = 16 bytes, and instructions that stay inside the groups are the fast ones. This
// one makes each group of `a` and of `b` into one: first the numbers i of a, then the numbers i of b.
template <int W, int G, int... i, class V, int... lane>
UDCP_INLINE void pick(const V& a, const V& b, V& out, std::integer_sequence<int, lane...>) {
  constexpr int from[] = {i...};
  out = __builtin_shufflevector(a, b, (lane / G * G + from[lane % G] + (lane % G < G / 2 ? 0 : W))...);
}

// Writes x y z x y z .. of W points.
template <class R, int W>
UDCP_INLINE void store_interleaved(const typename Vector<R, W>::Type& x, const typename Vector<R, W>::Type& y,
                                   const typename Vector<R, W>::Type& z, R* out) {
  constexpr int G = 16 / sizeof(R);
  constexpr auto lanes = std::make_integer_sequence<int, W>{};
  typename Vector<R, W>::Type first, second, third;
  if constexpr (G == 4) {
    typename Vector<R, W>::Type xy, yz, zx;
    pick<W, G, 0, 2, 0, 2>(x, y, xy, lanes);
    pick<W, G, 1, 3, 1, 3>(y, z, yz, lanes);
    pick<W, G, 0, 2, 1, 3>(z, x, zx, lanes);
    pick<W, G, 0, 2, 0, 2>(xy, zx, first, lanes);   // x0 y0 z0 x1
    pick<W, G, 0, 2, 1, 3>(yz, xy, second, lanes);  // y1 z1 x2 y2
    pick<W, G, 1, 3, 1, 3>(zx, yz, third, lanes);   // z2 x3 y3 z3
  } else {
    pick<W, G, 0, 0>(x, y, first, lanes);
    pick<W, G, 0, 1>(z, x, second, lanes);
    pick<W, G, 1, 1>(y, z, third, lanes);
  }
  for (int group = 0; group < W / G; ++group, out += 3 * G) {
    std::memcpy(out, reinterpret_cast<const R*>(&first) + group * G, 16);
    std::memcpy(out + G, reinterpret_cast<const R*>(&second) + group * G, 16);
    std::memcpy(out + 2 * G, reinterpret_cast<const R*>(&third) + group * G, 16);
  }
}

// Twelve sums at a time for vectors of W numbers: what fills the registers and hides how long an addition takes.
template <class R, int W, int panels>
UDCP_INLINE void multiply_at_once(const R* matrix, int columns, const R* points, const R* origin, R* out) {
  using V = typename Vector<R, W>::Type;
  constexpr int parts = panel_rows<R> / W;
  V x[panels * parts] = {}, y[panels * parts] = {}, z[panels * parts] = {};
  const std::size_t size = static_cast<std::size_t>(columns) * panel_rows<R>;
  // Where the product after a few more will go: the processor's own foresight ends at pages and begins anew with every face.
  constexpr int size_out = panels * panel_rows<R> * 3;
#pragma GCC unroll 8
  for (int k = 0; k < size_out; k += 64 / static_cast<int>(sizeof(R))) __builtin_prefetch(out + 4 * size_out + k, 1);
  for (int k = 0; k < columns; ++k, matrix += panel_rows<R>, points += 4) {
#pragma GCC unroll 4
    for (int part = 0; part < panels * parts; ++part) {
      const V weight = *reinterpret_cast<const V*>(matrix + (part < parts ? 0 : size) + part % parts * W);
      x[part] += weight * points[0];
      y[part] += weight * points[1];
      z[part] += weight * points[2];
    }
  }
#pragma GCC unroll 4
  for (int part = 0; part < panels * parts; ++part, out += 3 * W)
    store_interleaved<R, W>(x[part] + origin[0], y[part] + origin[1], z[part] + origin[2], out);
}

template <class R, int W>
UDCP_INLINE void multiply_panels(const R* matrix, int columns, int panels, const R* points, const R* origin, R* out) {
  constexpr int most = 4 * W / panel_rows<R>;
  const std::ptrdiff_t size = std::ptrdiff_t{panel_rows<R>} * columns;
  for (; panels >= most; panels -= most, matrix += most * size, out += most * 3 * panel_rows<R>)
    multiply_at_once<R, W, most>(matrix, columns, points, origin, out);
  if (panels > 0) multiply_at_once<R, W, 1>(matrix, columns, points, origin, out);
}

template <class R>
using Multiply = void (*)(const R*, int, int, const R*, const R*, R*);

template <class R>
void multiply_baseline(const R* matrix, int columns, int panels, const R* points, const R* origin, R* out) {
  multiply_panels<R, 16 / sizeof(R)>(matrix, columns, panels, points, origin, out);
}

#if defined(__x86_64__)
template <class R>
__attribute__((target("avx2,fma"))) void multiply_avx2(const R* matrix, int columns, int panels, const R* points, const R* origin,
                                                       R* out) {
  multiply_panels<R, 32 / sizeof(R)>(matrix, columns, panels, points, origin, out);
}

template <class R>
Multiply<R> best_multiply() {
  const bool wide = __builtin_cpu_supports("avx2") != 0 && __builtin_cpu_supports("fma") != 0;
  return wide ? multiply_avx2<R> : multiply_baseline<R>;
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
PanelMatrix<R> make_panels(const Points<double>& matrix, int first, int rows, const std::vector<int>& columns) {
  PanelMatrix<R> result{rows, static_cast<int>(columns.size()) - 1, {}};
  const int end = result.panels() * panel_rows<R>;
  result.values = Buffer<R>(static_cast<std::size_t>(end) * (columns.size() - 1));
  R* out = result.values.data();
  for (int panel = 0; panel < end; panel += panel_rows<R>)
    for (std::size_t k = 1; k < columns.size(); ++k)
      for (int row = panel; row < panel + panel_rows<R>; ++row)
        *out++ = row < rows ? static_cast<R>(matrix(first + row, columns[k])) : R(0);
  return result;
}

template <class R>
void multiply(const PanelMatrix<R>& matrix, int first, int last, const R* points, const R* origin, R* out) {
  static const Multiply<R> chosen = best_multiply<R>();
  chosen(matrix.panel(first), matrix.columns, last - first, points, origin, out);
}

#define UDCP_INSTANTIATE(R)                                                                      \
  template PanelMatrix<R> make_panels(const Points<double>&, int, int, const std::vector<int>&); \
  template void multiply(const PanelMatrix<R>&, int, int, const R*, const R*, R*);
UDCP_INSTANTIATE(float)
UDCP_INSTANTIATE(double)
#undef UDCP_INSTANTIATE

}  // namespace udcp
