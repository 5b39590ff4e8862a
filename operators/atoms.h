// All atoms: start reading here. Each is one free function per shape, generic in the number type S, and says what it computes as
// "row i of the result += weight * row j"; values in, values out. A word strings them together in run.h.
//
//   U  split        new points on edges and in faces, (bi)linear          curves, polygons, triangles
//   D  to_dual      vertices -> faces (mesh) or edges (curve)             curves, polygons
//      to_primal    and back: plain means
//   C  two D; on triangles an atom of its own (convolve)
//   P  push_back    towards the points before U
//
// Values in the dual state are rows in the order in which realise_dual numbers its vertices: faces, then boundary edges, then
// corners (on curves: along the curve).
#pragma once

#include <memory>
#include <vector>

#include "operators/polyline.h"
#include "operators/surface.h"
#include "operators/topology.h"
#include "operators/word.h"

namespace udcp {

/// A parameter at the points of a split shape: one value; or one per class of old vertices, the first class serving all others;
/// or one per point.
template <class S>
struct Parameter {
  std::vector<S> values;
  std::shared_ptr<const std::vector<int>> slot;  // per old vertex an index into values; null with several values: one per point
  [[nodiscard]] const S& operator[](int v) const {
    const auto i = static_cast<std::size_t>(v);
    if (slot) return values[i < slot->size() ? static_cast<std::size_t>((*slot)[i]) : 0];
    return values.size() == 1 ? values[0] : values[i];
  }
  [[nodiscard]] bool is_constant() const { return values.size() == 1; }
  static Parameter constant(S value) { return {{std::move(value)}, nullptr}; }
};

// ---- U
// ----------------------------------------------------------------------------------------------------------------------------

/// Rows at the points of U[d], linear in the rows at the old points. push-back, (1); on meshes (4). Also what P and attributes
/// use.
template <class S>
Points<S> split_points(const Polyline<S>& shape, const Points<S>& rows, int sections);
template <class S>
Points<S> split_points(const Mesh& mesh, const Points<S>& rows, Split split);

/// U: points, tags, corners and attributes on the split connectivity. Throws E_USPLIT (see Split), E_NOT_TRIANGLES.
template <class S>
Polyline<S> up(const Polyline<S>& shape, int sections = 2);
template <class S>
Surface<S> up(const Surface<S>& shape, Split split = {});

// ---- D
// ----------------------------------------------------------------------------------------------------------------------------

/// The kernel of D: f at the old vertices and at the points on old edges; everywhere else the weights are 1.
template <class S>
struct KernelWeights {
  Directional<Parameter<S>> f;
  Origin origin;     // of the vertices of a mesh
  int sections = 2;  // on curves every sections-th point is an old one, and only they are weighted
  /// f = 1 everywhere: plain means.
  [[nodiscard]] bool is_one() const {
    const auto one = [](const Parameter<S>& p) { return p.is_constant() && is_zero(S(p.values[0] - S(1))); };
    return one(f.plain) && one(f.latitude) && one(f.longitude);
  }
};

/// Primal to dual. `weights` null (or one everywhere): plain means. Throws Error{input, "E_WEIGHT"} naming the face or edge whose
/// weights sum to 0.
template <class S>
Points<S> to_dual(const Polyline<S>& shape, const KernelWeights<S>* weights);
template <class S>
Points<S> to_dual(const Surface<S>& shape, const KernelWeights<S>* weights);

/// Dual to primal: the mean of the two edges, or of the faces around a vertex.
template <class S>
Points<S> to_primal(const Polyline<S>& shape, const Points<S>& dual);
template <class S>
Points<S> to_primal(const Surface<S>& shape, const Points<S>& dual);

/// The dual as a shape of its own, with tags and attributes. Throws E_VALENCE2, E_CORNER naming the vertex.
template <class S>
Polyline<S> realise_dual(const Polyline<S>& shape, const Points<S>& dual);
template <class S>
Surface<S> realise_dual(const Surface<S>& shape, const Points<S>& dual);

// ---- C
// ----------------------------------------------------------------------------------------------------------------------------

/// C on polygons: D D, row by row, without the dual in between.
template <class S>
Points<S> convolve(const Surface<S>& shape, const KernelWeights<S>* weights);

/// C on triangles. `weights` as for D.
template <class S>
Points<S> convolve_triangles(const Surface<S>& shape, const KernelWeights<S>* weights);

/// C[ngon = classic] for the first C after U[2]: D D, except that the edge points next to a face that was not a quad become
/// (F1 + 2f E + F2)/(2 + 2f), with f at E across the edge. `before` is the mesh before U.
template <class S>
Points<S> convolve_classic(const Surface<S>& shape, const KernelWeights<S>& weights, const Mesh& before);

// ---- P
// ----------------------------------------------------------------------------------------------------------------------------

/// The parameters of one P, at the points of the refined shape: delta is read at old vertices, omega at the others.
template <class S>
struct PushBack {
  Parameter<S> delta;
  Directional<Parameter<S>> omega;
  bool has_omega_face = false;
  Parameter<S> omega_face;
  /// omega is 0 everywhere, as in Catmull-Clark and Loop: only old vertices move.
  [[nodiscard]] bool spreads_nothing() const {
    const auto zero = [](const Parameter<S>& p) { return p.is_constant() && is_zero(p.values[0]); };
    return zero(omega.plain) && zero(omega.latitude) && zero(omega.longitude) && (!has_omega_face || zero(omega_face));
  }
};

/// P: `current` holds the points on the U[d] of `before`; Delta = delta (old - current) at old vertices, 0 at corners, spread by
/// the weights of U and scaled by omega. push-back, (3); on meshes (8), (9).
template <class S>
Points<S> push_back(Points<S> current, const Polyline<S>& before, int sections, const PushBack<S>& parameters);
template <class S>
Points<S> push_back(Points<S> current, const Surface<S>& before, Split split, const PushBack<S>& parameters);

/// The ring pass for one direction (U[2], quads): the odd points of the rings become (1/2+w)(p1+p2) - w(p0+p3) of even ones,
/// where w = 1/(8c(1+c)) and c is `cosine_of_half_alpha` at the odd point. A point without a complete ring stays.
template <class S>
Points<S> ring_pass(Points<S> current, const Surface<S>& before, EdgeTag direction, const Parameter<S>& cosine_of_half_alpha);

}  // namespace udcp
