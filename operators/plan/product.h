// The inner loop: a small dense matrix times the points of one face, vectorised over the rows. Knows no mesh.
#pragma once

#include <vector>

#include "operators/number.h"
#include "operators/plan/buffer.h"

namespace udcp {

/// Rows in one panel: what fills one cache line per column.
template <class R>
inline constexpr int panel_rows = 64 / static_cast<int>(sizeof(R));

/// A matrix in panels: the rows of a panel lie side by side, column after column; the last panel is filled up with zeros. There
/// is no column for the first point: where points are given as differences to it, its weights have nothing to do.
template <class R>
struct PanelMatrix {
  int rows = 0, columns = 0;
  Buffer<R> values;
  [[nodiscard]] int panels() const { return (rows + panel_rows<R> - 1) / panel_rows<R>; }
  [[nodiscard]] const R* panel(int k) const {
    return values.data() + static_cast<std::size_t>(k) * static_cast<std::size_t>(panel_rows<R> * columns);
  }
};

/// Rows `first` .. `first` + `rows` - 1 of `matrix` and the columns after the first of those that are listed, rounded to R.
template <class R>
PanelMatrix<R> make_panels(const Points<double>& matrix, int first, int rows, const std::vector<int>& columns);

/// out = origin + panels `first` .. `last` - 1 of the matrix times the points: one row of x y z and a number that is not read per
/// column of the matrix; x y z x y z .. out, whole panels. Every row is summed in the order of the columns, with fused operations
/// where the processor has them: processors with and without may differ by a rounding, the same one never does.
template <class R>
void multiply(const PanelMatrix<R>& matrix, int first, int last, const R* points, const R* origin, R* out);

}  // namespace udcp
