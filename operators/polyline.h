// A curve: points in order, open or closed, one to three coordinates.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "operators/number.h"

namespace udcp {

template <class S>
struct Polyline {
  Points<S> points;
  bool closed = true;
  std::vector<char> corner;  // per point, 1: stays fixed; empty: none. The ends of an open curve always are.
  std::map<std::string, std::vector<S>> attributes;  // v.name, a column per name

  [[nodiscard]] int size() const { return static_cast<int>(points.rows()); }
  [[nodiscard]] int edges() const { return closed ? size() : size() - 1; }
  [[nodiscard]] bool is_corner(int i) const {
    if (!closed && (i == 0 || i == size() - 1)) return true;
    return !corner.empty() && corner[static_cast<std::size_t>(i)] != 0;
  }
};

/// Throws Error{input}: no column or more than three (E_DIMENSION), fewer than 2 points (3 if closed) (E_POINTS),
/// corners (E_TAGS) or attributes (E_ATTRIBUTE_SIZE) that do not fit the points.
template <class S>
void validate(const Polyline<S>& curve);
/// The same for any number of columns from one on: what run() asks for, as matrix.h runs words on unit vectors.
template <class S>
void validate_columns(const Polyline<S>& curve);

/// The same curve in another number type, as for surfaces.
template <class T, class S>
Polyline<T> convert(const Polyline<S>& curve);

}  // namespace udcp
