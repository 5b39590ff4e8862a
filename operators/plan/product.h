// The inner loop: a small dense matrix times the points of one face, vectorised over the rows. Knows no mesh.
#pragma once

#include <vector>

#include "operators/number.h"
#include "operators/plan/buffer.h"

namespace udcp {

/// Rows in one panel: what fills one cache line per column.
template <class R>
inline constexpr int panel_rows = 64 / static_cast<int>(sizeof(R));

/// A matrix in panels: the rows of a panel lie side by side, column after column; the last panel is filled up with zeros.
template <class R>
struct PanelMatrix {
  int rows = 0, columns = 0;
  Buffer<R> values;
  [[nodiscard]] int panels() const { return (rows + panel_rows<R> - 1) / panel_rows<R>; }
  [[nodiscard]] const R* panel(int k) const {
    return values.data() + static_cast<std::size_t>(k) * static_cast<std::size_t>(panel_rows<R> * columns);
  }
};

/// The rows and columns of `matrix` that are listed, in that order, rounded to R.
template <class R>
PanelMatrix<R> make_panels(const Points<double>& matrix, const std::vector<int>& rows, const std::vector<int>& columns);

/// out = origin + panels `first` .. `last` - 1 of the matrix times the points, three coordinates each, x y z x y z ...; writes
/// whole panels. Every row is summed in the order of the columns without fused operations: the same bits with and without AVX2.
template <class R>
void multiply(const PanelMatrix<R>& matrix, int first, int last, const R* points, const R* origin, R* out);

/// Copies numbers past the caches, for memory that is not read soon: `count` of them if `to_end`, otherwise up to the last cache
/// line of the target that they fill. Returns how many. The target must have been written before: on fresh pages this is slower
/// than plain stores, as the system has just cleared them in the cache.
template <class R>
std::size_t stream_copy(R* to, const R* from, std::size_t count, bool to_end);

}  // namespace udcp
