// The equations of the G2 fill, in every number type: how the ring around a vertex is numbered, which Bezier points the ring
// fixes, and which linear conditions the others meet along the inner edges. No solving here; proofs use the same functions.
// "Smooth connection near singular points on subdivision surfaces" (AAM 2017), with Loop (SGP 2004); where the print is wrong the
// corrected form stands here.
#pragma once

#include <vector>

#include "operators/number.h"

namespace udcp {

/// n patches of bidegree 7 replace the n faces around a vertex of valence n. P_i(0,0) is the centre, v = 0 lies on spoke i, u = 0
/// on spoke i + 1; Bezier point (j,k) is row 8 j + k.
inline constexpr int fill_degree = 7;
inline constexpr int fill_points = 64;
/// Points with both indices up to here are free, the others belong to the outer boundary.
inline constexpr int last_free = 4;

/// Number of points of `rings` rings around a vertex: 1 + 2 n + 4 n + ...
int ring_size(int valence, int rings);
/// The number of point (j,k) of sector i, j steps along spoke i and k parallel to spoke i + 1; sectors are modulo n. The numbers
/// are those of ring_mesh. One index may be negative: (j,-1) is (1,j) of sector i - 1, and (-1,k) is (k,1) of sector i + 1.
int ring_number(int valence, int sector, int j, int k);
/// The points around a vertex from which everything follows: 0 the centre, then per sector 1 .. 6 for (1,0), (1,1), (2,0), (2,1),
/// (2,2), (1,2). Entry (a,b) of the 4x4 net of sector 0, as such a slot of another sector; (0,0) is used nowhere.
struct NetEntry {
  int sector = 0, slot = 0;
};
NetEntry net_entry(int a, int b);

/// y(u,v) = sum of Y_ij b_i(v) b_j(u), 4 in v and 3 in u, of the map psi = (x, y) with x(u,v) = y(v,u): 5x4 matrix Y by the
/// cosine of 2 pi/n. psi reparametrises the bicubic ring so that it fits the fill up to second order.
template <class S>
Points<S> outer_map(const std::type_identity_t<S>& cosine);

/// Polynomials in t, coefficients lowest first: psi and its derivatives by u on the side u = 1.
template <class S>
struct OuterTraces {
  std::vector<S> x_u, x_uu, y_u, y_uu;
};
template <class S>
OuterTraces<S> outer_traces(const Points<S>& map);

/// Rows: the Bezier points, 0 for the free ones; columns: the net of the hole face, 4 a + b. What the value and two derivatives
/// of the bicubic ring fix along u = 1 and v = 1.
template <class S>
Points<S> outer_weights(const OuterTraces<S>& traces);

/// 25 x 64 each: `here` acts on the points of patch i and `next` on those of patch i + 1, and the sum is 0 if and only if they
/// join along u = 0 of P_i and v = 0 of P_{i+1} with
///   P = Q,   c(1-t) (Q_u + P_v) = Q_v + P_u,
///   2 c^2 (1-t) (Q_v - P_u) + 2 c (1-t) g (Q_uv - P_uv) = g (Q_vv - P_uu),   g = 1 + c (1-t).
template <class S>
struct EdgeEquations {
  Points<S> here, next;
};
template <class S>
EdgeEquations<S> edge_equations(const std::type_identity_t<S>& cosine);

/// The 64 x 64 matrix of the integral of |d^4 P/du^4|^2 + |d^4 P/dv^4|^2, which is least.
template <class S>
Points<S> fairness();

/// The rank of the equations on the free points at this frequency (mod n).
int fill_rank(int valence, int frequency);

}  // namespace udcp
