// Vectors of three exact numbers, and their products. In the plane the third number is 0. Knows no geometry beyond that.
#pragma once

#include <array>
#include <vector>

#include "operators/numbers/rational.h"

namespace udcp {

using Vector3 = std::array<Rational, 3>;

inline Vector3 operator+(const Vector3& a, const Vector3& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
inline Vector3 operator-(const Vector3& a, const Vector3& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline Vector3 operator-(const Vector3& a) { return {-a[0], -a[1], -a[2]}; }
inline Vector3 operator*(const Rational& s, const Vector3& a) { return {s * a[0], s * a[1], s * a[2]}; }
inline Rational dot(const Vector3& a, const Vector3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Vector3 cross(const Vector3& a, const Vector3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline bool is_zero(const Vector3& a) { return a[0].is_zero() && a[1].is_zero() && a[2].is_zero(); }

/// Of integers, not negative; gcd(0, 0) = 0.
Rational greatest_common_divisor(const Rational& a, const Rational& b);
/// Of integers other than 0.
Rational least_common_multiple(const Rational& a, const Rational& b);
/// The integer vector of coprime entries on the same ray; zero stays zero.
Vector3 primitive(const Vector3& a);

}  // namespace udcp
