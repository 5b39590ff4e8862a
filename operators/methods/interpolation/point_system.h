// The map from the points W of a mesh to the limits of their modified step, as a symmetric system over the mesh; its rows come
// from the running words.
#pragma once

#include "operators/methods/interpolation/interpolate_points.h"

namespace udcp {

/// One row of the map at a vertex inside: own v + edge sum e_j + face sum (means of the faces at v, v included). Limit of
/// modified_step.
struct LimitRow {
  Rational own, edge, face;
};
LimitRow limit_row_inside(const Rational& lambda, int valence);
/// On the boundary: own v + edge (e_0 + e_k).
LimitRow limit_row_on_boundary(const Rational& lambda);

/// W such that the limits of modified_step(W) are the points of `cage`, first along the boundary, which does not depend on the
/// rest, then inside. Vertices whose position is not prescribed, and corners, keep their points.
template <class S>
Points<S> solve_for_limits(const Surface<S>& cage, const PointOptions& options);

}  // namespace udcp
