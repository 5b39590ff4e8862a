// Catmull-Clark surfaces around one interior vertex, of valence 4 or not: the rings of regular patches that shrink to it, and the
// inequality after which all further rings are regular, with the tangent plane of the vertex in the limit. Spectral analysis as
// by Reif (A unified approach to subdivision algorithms near extraordinary vertices); difference vectors as in "On Regularity of
// Catmull-Clark Subdivision Surfaces". Serves search and checker, and searches for nothing.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "operators/surface.h"
#include "proofs/patch.h"
#include "proofs/regularity/bicubic_net.h"

namespace udcp {

inline constexpr int largest_ring_valence = 30;
inline constexpr int largest_ring_level = 40;
/// Bits of all enclosures below.
inline constexpr int ring_precision = 192;

/// The number of a lattice point (whole steps along the spokes s and s + 1 are two half steps of the label) in ring_mesh: the
/// centre, then ring by ring.
int ring_index(int valence, const Label& label);
/// The control net of patch `patch` of a ring, as numbers of points of the three rings around the vertex. Patch 3 s + k lies in
/// sector s at (i, j) = (1, 0), (1, 1), (0, 1) for k = 0, 1, 2: u runs along spoke s from i to i + 1, v along spoke s + 1.
std::array<int, 16> ring_net(int valence, int patch);

/// a b, by the entries of a that are not 0. S is Rational or Interval.
template <class S>
Points<S> sparse_product(const Points<Rational>& a, const Points<S>& b);

/// What depends on the valence n alone. X are the points of two rings around the vertex, 1 + 6 n rows; A takes X to the next
/// level, and w, L are its left, 1, E its right eigenvectors: w A = w, L A = lambda L, A E = lambda E, L E = I. Norms of matrices
/// are largest row sums of absolute values. Every enclosure holds the exact number, and all that follows from them is proved by
/// the construction: lambda is the double eigenvalue below 1 and above the moduli of all others, and the characteristic map is
/// regular and injective.
struct RingConstants {
  int valence = 0;
  Points<Rational> outer;  // X -> three rings of the next level, 1 + 12 n rows, of which A are the first 1 + 6 n
  Points<Rational> mean;   // w, one row
  Interval lambda;
  Points<Interval> left;   // L, two rows
  Points<Interval> right;  // E, two columns; the points next to the vertex on the spokes have length 1
  int splits = 0;          // how often every patch of the ring is split for the constants below
  Interval kappa;          // the least det(c, d) over differences c in u and d in v of one patch of the ring of E, positive
  Interval size;           // G: the largest |c| and |d|
  Rational difference;     // D: not below the norm of any such difference of the next ring as a row over X
  int power = 0;           // K: the first power of B = (A - 1 w - lambda E L)/lambda with a norm of at most 1/2
  Interval contraction;    // that norm
  Interval tail;           // C: the largest norm of (I - 1 w - E L) B^r for r < K, and so for all r
};
/// For 3 <= n <= largest_ring_valence, else Error{limit, "E_TOO_LARGE"}. Computed once per valence.
std::shared_ptr<const RingConstants> ring_constants(int valence);

/// The rings around one vertex, from exact points. Ring m = 1, 2, .. consists of the 3 n patches of level m whose faces touch a
/// neighbour of the vertex but not the vertex; together they cover the n faces at the vertex, without the vertex.
class VertexRings {
 public:
  /// Two rings, 1 + 6 n rows in the order of ring_mesh, of one to three coordinates. Throws Rejected for another number of rows
  /// or columns, or a valence that ring_constants has not.
  explicit VertexRings(const Points<Rational>& two_rings);
  /// Around vertex v; sector s lies in the face of half-edge spokes()[s], the first being mesh.outgoing[v]. Throws Rejected
  /// unless v is inside, its faces are quads, and the other corners of these are inside, of valence 4 and in quads only; nor may
  /// any of them be tagged.
  static VertexRings around(const Surface<Rational>& surface, int v);

  [[nodiscard]] const RingConstants& constants() const { return *constants_; }
  [[nodiscard]] int valence() const { return constants_->valence; }
  /// Half-edges that leave the vertex, counter-clockwise; empty if the rings come from points.
  [[nodiscard]] const std::vector<int>& spokes() const { return spokes_; }
  /// A^level X, exact, three columns. 0 <= level <= largest_ring_level, else Rejected.
  const Points<Rational>& points(int level);
  /// The 3 n nets of ring 1 <= ring <= largest_ring_level in the order of ring_net, times one positive number so that they are
  /// integers. Else Rejected.
  std::vector<BicubicNet> nets(int ring);

  /// N = p1 x p2 for p = L X is certainly not 0: the surface has a tangent plane at the vertex, N being normal to it.
  [[nodiscard]] bool has_normal() const;
  /// Certainly |N| kappa > 2 G sigma eta + eta^2 at this level, where sigma is the norm of p and eta = D C max |row of R|,
  /// R = lambda^-level (A^level X - 1 w X) - E p: every patch of every ring above `level`, split as often as constants() says,
  /// has all its u x v in the open half space of N and so is regular. If the rings up to `level` are regular too, the surface is
  /// regular around the vertex, and a regular C^1 surface there. Level 0 needs no ring. Rejected like points().
  bool closes_at(int level);

 private:
  std::shared_ptr<const RingConstants> constants_;
  std::vector<int> spokes_;
  std::vector<Points<Rational>> levels_;
  Points<Rational> middle_;    // w X, the limit of the vertex
  Points<Interval> tangents_;  // p
};

/// A point of a ring as a point of the face at the vertex that it came from: u, v in the frame of that face, which is the one of
/// its first corner.
struct FacePoint {
  int face = 0;
  Rational u, v;
};
/// The point (u, v) of patch `patch` of ring `ring`, around a vertex of this mesh with these spokes.
FacePoint face_point(const Mesh& mesh, const std::vector<int>& spokes, int ring, int patch, const Rational& u, const Rational& v);

}  // namespace udcp
