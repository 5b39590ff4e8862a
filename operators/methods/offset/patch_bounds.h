// Bounds over single patches of a Loop surface and of its offset: lengths, errors, normal cones. The same code searches in double
// and decides in Interval (outward-rounded); in double rounding errors are not bounded.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "operators/methods/offset/loop_patch.h"

namespace udcp {

/// All unit normals of a patch are within the angle whose cosine is at least `cosine` (> 0) of the unit vector `axis`.
template <class S>
struct NormalCone {
  std::array<S, 3> axis;
  S cosine;
};

/// Bounds of the length of a field over a patch: by the convex hull of its control vectors (any patch), or for a regular one by
/// the Bernstein coefficients of its square.
template <class S>
struct LengthRange {
  S low, high;
};
template <class S>
LengthRange<S> length_by_hull(const Points<S>& vectors);
template <class S>
LengthRange<S> length_by_bernstein(const Points<S>& net);
/// max |length - |distance||.
template <class S>
S length_error(const LengthRange<S>& range, const S& distance);

/// The cone of a regular patch with 12 control points; none if the Bernstein coefficients of x_v cross x_w do not lie in one.
template <class S>
std::optional<NormalCone<S>> regular_cone(const Points<S>& net);

/// Bound of |delta - distance n| over a regular patch with control points `net` and control vectors `d`: from the angle between
/// delta and sign(distance) n and the length of delta. None if the patch must be split first.
template <class S>
std::optional<S> regular_error(const Points<S>& net, const Points<S>& d, const S& distance);
/// The same where the normals lie in a known cone; any patch.
template <class S>
S error_in_cone(const NormalCone<S>& cone, const Points<S>& d, const S& distance);

/// What bounds normals around an irregular vertex of one valence, by its characteristic map (Reif): eigenvectors for the
/// subdominant eigenvalue, the Jacobian of the characteristic ring, and a power of the rest that contracts.
template <class S>
class CornerAnalysis {
 public:
  /// Valences 3 .. largest_patch_valence. Error{limit, "E_NO_CONE"} where the ring has no positive Jacobian bound.
  explicit CornerAnalysis(int valence);
  /// The cone of all normals of the patch with these N + 6 control points, its corner included.
  [[nodiscard]] std::optional<NormalCone<S>> cone(const Points<S>& net) const;
  [[nodiscard]] const PatchStep<S>& step() const { return step_; }
  [[nodiscard]] const S& jacobian() const { return jacobian_; }
  [[nodiscard]] int rings() const { return rings_; }

 private:
  void find_eigenvectors();
  void bound_ring();
  void find_power();
  int valence_;
  PatchStep<S> step_;
  S lambda_, jacobian_, derivative_;
  Points<S> right_, left_;  // (N + 6) x 2 and 3 x (N + 6): limit, then the two tangents
  int rings_ = 0;           // s: rings bounded one by one
};

}  // namespace udcp
