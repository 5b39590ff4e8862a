// Unit vectors in floating point, for pictures and degrees. Decides nothing.
#pragma once

#include <array>
#include <cmath>

namespace udcp {

using Direction = std::array<double, 3>;

inline double dot(const Direction& a, const Direction& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Direction cross(const Direction& a, const Direction& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
/// Of length 1, but not of the zero vector.
inline Direction unit(Direction d) {
  const double length = std::sqrt(dot(d, d));
  for (double& x : d) x /= length;
  return d;
}

}  // namespace udcp
