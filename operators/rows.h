// Sums of rows at the speed of modelling. add() of number.h defines what an atom does; these do the same to the last bit, with
// loops over columns whose length the compiler knows where machine numbers come in threes.
#pragma once

#include <span>
#include <type_traits>

#include "operators/huge_pages.h"
#include "operators/number.h"

namespace udcp {

/// Rows whose values are yet to be written.
template <class S>
Points<S> fresh_rows(Eigen::Index rows, Eigen::Index columns) {
  Points<S> points(rows, columns);
  prefer_huge_pages(points.data(), static_cast<std::size_t>(points.size()) * sizeof(S));
  return points;
}
template <class S>
Points<S> zero_rows(Eigen::Index rows, Eigen::Index columns) {
  Points<S> points = fresh_rows<S>(rows, columns);
  points.setZero();
  return points;
}

/// Calls loop(columns) with the number of columns: a constant, which doubles the speed, for machine numbers in threes.
template <class S, class Loop>
inline void with_columns(Eigen::Index columns, Loop loop) {
  if constexpr (std::is_floating_point_v<S>) {
    if (columns == 3) return loop(std::integral_constant<Eigen::Index, 3>{});
  }
  loop(columns);
}

/// Row i of `to` += w times row j of `from`, another row.
template <class S>
inline void add_row(Points<S>& to, int i, const S& w, const Points<S>& from, int j) {
  with_columns<S>(to.cols(), [&w, i, j, all = to.data(), rows = from.data()](auto columns) {
    S* __restrict target = all + i * columns;
    const S* __restrict source = rows + j * columns;
    for (Eigen::Index c = 0; c < columns; ++c) target[c] += w * source[c];
  });
}

/// Row i of `to` becomes the sum of weight(k) times row rows[k] of `from`, another matrix, over all k in this order.
template <class S, class Weight>
inline void sum_rows(Points<S>& to, int i, Weight weight, const Points<S>& from, std::span<const int> rows) {
  with_columns<S>(to.cols(), [&weight, rows, i, all = to.data(), first = from.data()](auto columns) {
    S* __restrict target = all + i * columns;
    for (Eigen::Index c = 0; c < columns; ++c) target[c] = S(0);
    for (std::size_t k = 0; k < rows.size(); ++k) {
      const S& w = weight(k);
      const S* __restrict source = first + rows[k] * columns;
      for (Eigen::Index c = 0; c < columns; ++c) target[c] += w * source[c];
    }
  });
}

}  // namespace udcp
