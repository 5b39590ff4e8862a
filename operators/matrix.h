// Masks and subdivision matrices: run() on unit vectors, so that they are the running code and nothing else.
#pragma once

#include <vector>

#include "operators/run.h"

namespace udcp {

/// Rows: points after one round that starts as round `round` (after the head); columns: points before. Throws E_NO_ROUND.
template <class S>
Points<S> subdivision_matrix(const Word& word, const Polyline<S>& curve, int round = 0);
template <class S>
Points<S> subdivision_matrix(const Word& word, const Surface<S>& surface, int round = 0);

/// The mask of one round on curves of regular points: p_new[k] = sum_i coefficient(k - arity*i) p_old[i], where coefficient(k) is
/// coefficients[k - first]. New point k lies at (k + shift)/arity between the old points, which lie at the integers.
template <class S>
struct Mask {
  int arity = 2;
  int first = 0;
  Rational shift;
  std::vector<S> coefficients;  // no zeros at the ends
};
/// Round `round` of a scheme, after its head; the whole of a finite operator. Throws Error{word, "E_MASK_VARIES"} for parameters
/// that differ from point to point, E_NO_ROUND for round > 0 of a finite operator, Error{limit, "E_ARITY"}.
template <class S>
Mask<S> mask(const Word& word, int round = 0);

/// The rows that a mask stands for, one per residue r = 0 .. arity - 1: p_new[arity*j + r] = sum_i weights[i] p_old[j + first +
/// i].
template <class S>
struct Stencil {
  int first = 0;
  std::vector<S> weights;
};
template <class S>
std::vector<Stencil<S>> stencils(const Mask<S>& mask);

/// New points that one old point (index 0) can influence in one round, from the atoms alone; omega = 0 is taken into account.
struct Reach {
  int low = 0, high = 0;
};
Reach reach_of_round(const Word& word);

/// Arity of a round on curves: the product of the section numbers of its U.
int arity(const Word& word);

/// `rings` rings of quads (triangles) around a vertex of valence >= 3, flat in the plane z = 0. Vertex 0 is the centre; then ring
/// by ring, counter-clockwise from spoke 0. With (s, i, j) = i steps along spoke s and j along spoke s + 1, ring r of sector s
/// holds (s,r,0), (s,r,1) .. (s,r,r), (s,r-1,r) .. (s,1,r); on triangles (s,r,0), (s,r-1,1) .. (s,1,r-1). Throws E_RING_MESH.
Surface<double> ring_mesh(int valence, int rings, bool triangles = false);

}  // namespace udcp
