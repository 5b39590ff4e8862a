// The 4 x 4 control net of one regular patch of a Catmull-Clark surface, a uniform bicubic B-spline patch, up to a common
// positive factor: corners, refinement, Bezier form and difference vectors ("On Regularity of Catmull-Clark Subdivision
// Surfaces", sections 1.1 and 1.2). Weights come from the running atoms. Knows no mesh and decides nothing.
#pragma once

#include <array>
#include <vector>

#include "proofs/regularity/vector3.h"

namespace udcp {

/// Sides of a patch: v = 0, u = 1, v = 1, u = 0.
enum class PatchSide { bottom, right, top, left };

/// Point (i, j), number 4 i + j, is in row i (v direction) and column j (u direction); the patch lies over the inner four. A side
/// is flagged where it is a boundary: its outer row or column is the reflection 2 (first) - (second) of the ones inside.
struct BicubicNet {
  std::array<Vector3, 16> points;
  std::array<bool, 4> flagged{};  // by PatchSide
  [[nodiscard]] const Vector3& at(int i, int j) const { return points[static_cast<std::size_t>(4 * i + j)]; }
  [[nodiscard]] Vector3& at(int i, int j) { return points[static_cast<std::size_t>(4 * i + j)]; }
  [[nodiscard]] bool is_flagged(PatchSide side) const { return flagged[static_cast<std::size_t>(side)]; }
};

/// Fills the outer rows and columns of the flagged sides from the points inside.
void reflect(BicubicNet& net);

/// The net of the quarter number 2 r + c: u in [c, c+1]/2, v in [r, r+1]/2. Points are multiplied by 64, so integers stay so.
BicubicNet child(const BicubicNet& net, int number);
std::array<BicubicNet, 4> children(const BicubicNet& net);
/// The net along a path of child digits '0' .. '3'. Throws Rejected for other characters and for more than 60 of them.
BicubicNet descendant(BicubicNet net, const std::string& path);

/// S, S_u and S_v at the corner u = c, v = r (0 or 1), times 36, 12 and 12 (unit parameters per face).
struct CornerValues {
  Vector3 point, du, dv;
};
CornerValues corner(const BicubicNet& net, int r, int c);

/// Differences in u and in v direction that the convex combinations of Theorems 1 and 2 of the paper need, in rows: all 12 + 12
/// of the net, but those along a flagged outer row and those across a flagged side. Zeros included.
struct Differences {
  std::vector<Vector3> u, v;
};
Differences differences(const BicubicNet& net);
/// Every corner of the patch keeps a non-zero difference of each kind in its stencil, so that zeros elsewhere may be ignored.
bool has_full_corners(const BicubicNet& net);

/// The Bezier control points (times 36), numbered like the points of the net.
BicubicNet bezier(const BicubicNet& net);
/// The 36 Bernstein coefficients of S_u x S_v, bidegree (5, 5), number 6 l + k for row l in v and column k in u; times one
/// positive factor, 100 * 12^2.
std::array<Vector3, 36> normal_net(const BicubicNet& net);

}  // namespace udcp
