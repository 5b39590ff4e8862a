// Small dense linear systems in any number type: elimination with the largest pivot. Nothing is known here of where they come
// from.
#pragma once

#include <cmath>

#include "operators/number.h"

namespace udcp {

/// x with a x = b (a row of b per row of a). Error{input, "E_SINGULAR"} where no pivot is certainly other than zero.
template <class S>
Points<S> dense_solve(Points<S> a, Points<S> b) {
  const Eigen::Index n = a.rows();
  for (Eigen::Index k = 0; k < n; ++k) {
    Eigen::Index pivot = k;
    for (Eigen::Index i = k + 1; i < n; ++i)
      if (std::abs(approximate(a(i, k))) > std::abs(approximate(a(pivot, k)))) pivot = i;
    if (!is_nonzero(a(pivot, k))) throw Error(ErrorKind::input, "E_SINGULAR", "the linear system has no unique solution", "");
    a.row(k).swap(a.row(pivot));
    b.row(k).swap(b.row(pivot));
    for (Eigen::Index i = 0; i < n; ++i) {
      if (i == k || is_zero(a(i, k))) continue;
      const S factor = a(i, k) / a(k, k);
      for (Eigen::Index j = k; j < n; ++j) a(i, j) -= factor * a(k, j);
      for (Eigen::Index j = 0; j < b.cols(); ++j) b(i, j) -= factor * b(k, j);
    }
  }
  for (Eigen::Index k = 0; k < n; ++k)
    for (Eigen::Index j = 0; j < b.cols(); ++j) b(k, j) /= a(k, k);
  return b;
}

}  // namespace udcp
