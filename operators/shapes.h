// Simple shapes, exact where the number type can hold them.
#pragma once

#include "operators/polyline.h"
#include "operators/surface.h"

namespace udcp {

/// Regular polygon with `corners` >= 3 points on a circle round the origin, counter-clockwise from (radius, 0).
template <class S>
Polyline<S> polygon(int corners, const std::type_identity_t<S>& radius = S(1));

// All surfaces: outside is counter-clockwise. cube: [-1, 1]^3. tetrahedron: (1,1,1) and the even sign changes. octahedron: +-e_i.
template <class S>
Surface<S> cube();
template <class S>
Surface<S> tetrahedron();
template <class S>
Surface<S> octahedron();
/// The cyclic permutations of (0, +-1, +-golden ratio).
template <class S>
Surface<S> icosahedron();
/// nx by ny unit quads in the plane z = 0, vertices row by row.
template <class S>
Surface<S> grid(int nx, int ny);
/// A closed tube of m-gons: `profile` rows are (radius, height); latitude rings tagged lat, the other edges lon. closed: last
/// joins first.
template <class S>
Surface<S> tube(int m, const Points<S>& profile, bool closed = false);
/// m by k quads, tagged, radii R > r.
template <class S>
Surface<S> torus(int m, int k, const std::type_identity_t<S>& R, const std::type_identity_t<S>& r);
/// Every face cut into a fan of triangles from its first corner. Edge tags are dropped; corners and attributes stay.
template <class S>
Surface<S> triangulate(const Surface<S>& surface);

}  // namespace udcp
