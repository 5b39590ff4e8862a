// Single patches of Loop surfaces: a triangle (c, r_0, r_1) where only c may be irregular, with its N + 6 control points, as in
// Stam's evaluation. Bezier form, refinement and evaluation; every matrix is what the word does to unit vectors.
// Parameters: v belongs to r_0, w to r_1, u = 1 - v - w to c. S is double, Rational or Interval.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "operators/surface.h"

namespace udcp {

/// A control point of a patch: a vertex, or beyond a boundary edge (a, b) of the face (a, b, minus) the point a + b - minus, with
/// which the regular rules give the boundary rules.
struct PatchPoint {
  int a = -1, b = -1, minus = -1;
};
/// Control points in this order: c; its ring r_0 .. r_{N-1}, counter-clockwise; a_0, a_1, a_2, the neighbours of r_0 that follow
/// r_{N-1}; a_3, a_4, the neighbours of r_1 that follow a_2. Regular patches have N = 6.
struct LoopPatch {
  int valence = 6;
  int half_edge = -1;  // from c to r_0
  std::vector<PatchPoint> points;
};
/// The patch of a face, with the irregular vertex as c. Interior vertices of valence 6 and smooth boundary vertices with 4
/// neighbours are regular; none if more than one vertex is irregular, or one that lies on the boundary.
std::optional<LoopPatch> loop_patch(const Mesh& mesh, const Tags& tags, int face);
/// The control points of the patch as rows.
template <class S>
Points<S> patch_net(const LoopPatch& patch, const Points<S>& field);

/// Rows (i, j, k) of triangular Bernstein forms of degree n = i + j + k in v, w, u: i slowest, then j.
int bernstein_size(int degree);
int bernstein_index(int degree, int i, int j);

/// The 15 Bezier points of a regular patch, from its 12 control points: 15 x 12, times 24 integers.
const Points<Rational>& box_spline_bezier();
/// Bezier points of the patch with the 12 control points in the rows of `net`.
template <class S>
Points<S> bezier_points(const Points<S>& net);

/// One step of refinement: the N + 6 points of the child at c, and the 12 points of the children (e_0, r_0', e_01),
/// (e_1, e_01, r_1') and (e_01, e_1, e_0).
template <class S>
struct PatchStep {
  Points<S> inner;                   // (N + 6) x (N + 6)
  std::array<Points<S>, 3> regular;  // 12 x (N + 6)
};
/// Error{limit, "E_TOO_LARGE"} above the largest valence.
inline constexpr int largest_patch_valence = 64;
template <class S>
PatchStep<S> patch_step(int valence);

/// Six rows: position, x_v, x_w, x_vv, x_vw, x_ww of the regular patch at (v, w).
template <class S>
Points<S> evaluate_regular(const Points<S>& net, const std::type_identity_t<S>& v, const std::type_identity_t<S>& w);
/// The same of any patch with v, w >= 0, v + w <= 1; an irregular one is refined until the point lies in a regular child, at most
/// 60 times. Where that does not end, at v = w = 0, there is the position only (one row).
template <class S>
Points<S> evaluate_patch(const Points<S>& net, const PatchStep<S>& step, std::type_identity_t<S> v, std::type_identity_t<S> w);

/// Derivatives after a linear change of parameters: (v', w') = jacobian (v, w) + shift; rows as above, in v and w.
template <class S>
void change_parameters(Points<S>& values, const std::array<std::array<std::type_identity_t<S>, 2>, 2>& jacobian);

}  // namespace udcp
