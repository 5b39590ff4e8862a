// Attributes are columns, the atoms work on rows of points: from one to the other.
#pragma once

#include <vector>

#include "operators/number.h"

namespace udcp {

template <class S>
Points<S> as_rows(const std::vector<S>& column) {
  Points<S> rows(static_cast<Eigen::Index>(column.size()), 1);
  for (std::size_t i = 0; i < column.size(); ++i) rows(static_cast<Eigen::Index>(i), 0) = column[i];
  return rows;
}

template <class S>
std::vector<S> as_column(const Points<S>& rows) {
  return {rows.data(), rows.data() + rows.rows()};
}

}  // namespace udcp
