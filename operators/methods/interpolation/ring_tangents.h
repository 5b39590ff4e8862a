// Limit tangents at a vertex and the corrections of its ring that turn them: eqs. (5), (6) of the interpolation paper in the form
// "change both tangents by given vectors". Knows one vertex at a time.
#pragma once

#include <map>
#include <vector>

#include "operators/methods/interpolation/limit_masks.h"
#include "operators/methods/interpolation/quad_fans.h"
#include "operators/number.h"

namespace udcp {

/// The weights of the tangents on the points of a fan, e_0 .. then f_0 .., as differences from the vertex: that leaves its own
/// weight out, as all of them sum to 0. `first` x `second` points outward. On the boundary
/// `first` is the tangent of the boundary curve and `second` the one across; only what `movable` says may be moved, so that the
/// boundary curve stays. The sums of the movable weights' squares, which are those of both tangents inside.
struct RingWeights {
  std::vector<double> first, second;
  std::vector<char> movable;
  double squares = 0;
  double tied_squares = 0;  // of a_k = a^e_k + a^f_k; 0 on the boundary, where e and f do not pair off
};

struct RingTangents {
  Eigen::RowVector3d first, second;
};

/// How corrections are spread over the ring: over all its points, or the same for e_k and f_k.
enum class Spread { free, tied };

/// Weights by valence, each made once.
class RingMasks {
 public:
  /// Null on a boundary without a mask across: all but two or three faces.
  const RingWeights* weights(const Fan& fan);

 private:
  const RingWeights& inside(int valence);
  const RingWeights& boundary(int faces);
  LimitMasks masks_;
  std::map<int, RingWeights> inside_, boundary_;
};

/// Point k of a fan: e_0 .., then f_0 ...
inline int fan_point(const Fan& fan, std::size_t k) { return k < fan.e.size() ? fan.e[k] : fan.f[k - fan.e.size()]; }

RingTangents tangents_at(const Points<double>& points, int v, const Fan& fan, const RingWeights& weights);

/// Rows to add to the points of the fan so that the tangents change by `change`, with the least sum of squares. On the boundary
/// change.first is not looked at.
Points<double> ring_corrections(const Fan& fan, const RingWeights& weights, const RingTangents& change, Spread spread);

/// The change that projects both tangents onto the plane across `normal` (not 0).
RingTangents change_to_plane(const RingTangents& tangents, const Eigen::RowVector3d& normal);
/// The change that turns both tangents by the smallest rotation of first x second, which must not be 0, to the direction of
/// `normal`; by the half turn about the first tangent where they are opposite.
RingTangents change_by_turn(const RingTangents& tangents, const Eigen::RowVector3d& normal);

/// Angle between two vectors, neither of them 0; accurate near 0 and pi.
double angle_between(const Eigen::RowVector3d& a, const Eigen::RowVector3d& b);
/// The cross product; and whether it is 0 up to rounding.
Eigen::RowVector3d normal_of(const RingTangents& tangents);
bool is_degenerate(const RingTangents& tangents);

}  // namespace udcp
