// Limit points and tangents of Catmull-Clark as weights on the quads around a vertex, taken from the running word: unit vectors
// go through run() once per valence, and the left eigenvectors are those of what comes out. Knows no points.
#pragma once

#include <array>
#include <map>
#include <vector>

#include "operators/word.h"

namespace udcp {

/// One round of a primal word around a vertex inside. Entry j of edge (face) is the new e_j (f_j); its three weights are those of
/// v, of e_0 and of f_0. By rotation the weight of e_i in the new e_j is edge[j - i][1].
struct RingResponse {
  std::array<Rational, 3> vertex;
  std::vector<std::array<Rational, 3>> edge, face;
};
/// From run() on the ring of `valence` >= 3 quads. The rows of the word there must be rational.
RingResponse ring_response(const Word& word, int valence);
/// The same on the boundary curve: the weights of v and e_0 in the new v and in the new e_0 (the other end is the mirror image).
struct BoundaryResponse {
  std::array<Rational, 2> vertex, end;
};
BoundaryResponse boundary_response(const Word& word);

/// Inside: the limit of v is vertex v + edge sum e_j + face sum f_j. On the boundary: vertex v + edge (e_0 + e_k).
struct PointMask {
  Rational vertex, edge, face;
};

/// Inside, with theta = 2 pi/n: the tangents are C2 = sum [edge cos(j theta) e_j + face cos((j + 1/2) theta) f_j], and C3 with
/// sines. face = 2 cos(theta/2), so that edge is A_n of the closed form: C2 x C3 points outward.
struct TangentMask {
  double edge = 0, face = 0;
  double eigenvalue = 0;  // lambda2: what one round leaves of both
};

/// On a boundary with k = 2 or 3 faces and theta = pi/k: the tangent along is e_0 - e_k, the one across into the surface is
/// vertex v + end (e_0 + e_k) + sum [edge sin(j theta) e_j + face sin((j + 1/2) theta) f_j], with edge and face of
/// inside.
struct AcrossMask {
  TangentMask inside;
  double vertex = 0, end = 0;
};

/// The masks of schemes::catmull_clark(), each computed when first asked for. At a boundary vertex of one face the tangent plane
/// is that of the boundary curve, and at a corner that of both its boundary edges: there is no mask across. With k >= 4 faces the
/// mode sin(2 j theta), whose eigenvalue is that of valence k inside, is no weaker than the tangent along (1/2): the boundary
/// rule leaves no tangent plane there (known since Biermann, Levin and Zorin 2000, who change the rule).
class LimitMasks {
 public:
  const PointMask& inside(int valence);
  const PointMask& boundary();
  const TangentMask& tangents(int valence);
  const AcrossMask& across(int faces);

 private:
  const RingResponse& response(int valence);

  std::map<int, RingResponse> responses_;
  std::map<int, PointMask> inside_;
  std::map<int, TangentMask> tangents_;
  std::map<int, AcrossMask> across_;
  std::vector<PointMask> boundary_;
};

}  // namespace udcp
