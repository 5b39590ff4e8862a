// Matrices in the Matrix Market exchange format: decimals for other programs, exact values in comments.
#pragma once

#include <string>

#include "operators/number.h"

namespace udcp {

enum class MatrixLayout { coordinate, array };  // entries that are not zero, one a line; or all entries column by column

/// `comment` may have several lines. Numbers are the nearest doubles (midpoints of enclosures), written so that they read back to
/// the same double; the exact entry or the enclosure stands in a comment line "% (row, column) = 3/16", counted from 1. Throws
/// Error{input, "E_NOT_FINITE"} naming the entry.
template <class S>
std::string matrix_market(const Points<S>& matrix, MatrixLayout layout = MatrixLayout::coordinate,
                          const std::string& comment = {});

}  // namespace udcp
