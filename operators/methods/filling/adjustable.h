// Adjustable Catmull-Clark: the scheme as a word, what is known of it in closed form, and the hybrid surfaces where every vertex
// has a parameter of its own. c = 1/2 is Catmull and Clark's; c in (0, 1], and c = 0 (bilinear) where one only refines.
// "Smooth connection near singular points on subdivision surfaces" (AAM 2017), as corrected there where the print is wrong.
#pragma once

#include <array>
#include <vector>

#include "operators/run.h"

namespace udcp {

namespace schemes {

/// (U C[ngon = classic] P)* where f = (1-c)/c, omega = 0, delta(N) = (N-4)/N; for c = 0, where f is infinite, (U)*. Throws
/// Error{input, "E_ADJUSTABLE_C"} for c outside [0, 1].
Word adjustable(const Rational& c);

}  // namespace schemes

/// The limit point of a vertex: weights of the vertex, of each edge neighbour and of each opposite corner of a face around it.
template <class S>
struct AdjustableLimit {
  S vertex, edge, diagonal;
};
/// Of an interior vertex of this valence in a quad mesh, 0 < c <= 1.
template <class S>
AdjustableLimit<S> adjustable_limit(const std::type_identity_t<S>& c, int valence);

/// The larger (or smaller) eigenvalue of frequency k >= 1 on edge and diagonal neighbours: both are real.
double adjustable_eigenvalue(double c, int valence, int frequency, bool larger = true);
/// The largest eigenvalue of frequency 0 besides 1.
double adjustable_cup_eigenvalue(double c, int valence);

/// Weights of a tangent: of edge neighbour i, and of the diagonal of the face between the neighbours i and i + 1.
struct AdjustableTangent {
  std::vector<double> edge, diagonal;
};
/// Two directions of the tangent plane; the first points to edge neighbour 0, the second is a quarter turn on.
std::array<AdjustableTangent, 2> adjustable_tangents(double c, int valence);

/// How long the tangents of a segment are: lambda(c) times the difference of the two neighbours, with lambda = c(2-c)/(1+c) as in
/// the paper, or 1/2, which is the derivative of the limit curve. They agree for c = 1/2 and c = 1.
enum class TangentFactor { paper, limit };

/// The cubic segment between points 1 and 2 of four, p(u) = (1, u, u^2, u^3) C (p0, p1, p2, p3)^T: the matrix C, 0 < c <= 1.
template <class S>
Points<S> segment_matrix(const std::type_identity_t<S>& c, TangentFactor tangents = TangentFactor::paper);

/// The bicubic Bezier points (row 4 j + k, j along u) of a face all of whose corners have valence 4, from its 4x4 net (row 4 a +
/// b) and the parameters of its corners (0,0), (0,1), (1,0), (1,1). Patches that share an edge share everything up to the
/// first derivatives there. All c = 1/2: the bicubic B-spline.
template <class S>
Points<S> hybrid_patch(const Points<S>& net, const std::array<S, 4>& c, TangentFactor tangents = TangentFactor::paper);

/// One step with a parameter per vertex, the column `name` of the attributes: a new vertex has the rule of its own parameter,
/// which is the vertex's, the mean of its edge's ends or of its face's corners; the result carries the new column. Throws
/// Error{input}: E_ATTRIBUTE without the column, "E_ADJUSTABLE_C" naming the vertex.
template <class S>
Surface<S> hybrid_step(const Surface<S>& surface, const std::string& name = "c", const RunControl& control = {});

/// The surface with its boundary vertices that have one face tagged as corners, which stay where they are.
template <class S>
Surface<S> with_corners(Surface<S> surface);

}  // namespace udcp
