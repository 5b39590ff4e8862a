// Limit points, tangents and normals of Loop surfaces at their control vertices, for fields of any number of columns. The weights
// are read off the rows that the word gives to unit vectors on a fan; only which of them are eigenvectors is known here.
#pragma once

#include <map>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "operators/surface.h"

namespace udcp {

/// Neighbours of a vertex, counter-clockwise: all of an interior one from any start; p_1 .. p_K of one on the boundary, where p_1
/// and p_K are its neighbours along the boundary.
std::vector<int> vertex_ring(const Mesh& mesh, int v);
/// The rings of all vertices in one list.
class VertexRings {
 public:
  explicit VertexRings(const Mesh& mesh);
  [[nodiscard]] std::span<const int> of(int v) const {
    const auto begin = static_cast<std::size_t>(begin_[static_cast<std::size_t>(v)]);
    return {neighbour_.data() + begin, static_cast<std::size_t>(begin_[static_cast<std::size_t>(v) + 1]) - begin};
  }

 private:
  std::vector<int> begin_, neighbour_;
};

/// What a mesh must be for Loop's rules with boundaries: triangles (E_NOT_TRIANGLES), interior vertices of valence >= 3
/// (E_VALENCE2), corners on the boundary (E_CORNER_INSIDE); the first of these in this order. make_mesh has checked the rest.
void validate_loop_mesh(const Mesh& mesh, const Tags& tags);
/// The same and finite coordinates (E_NOT_FINITE, before the others), at least one face (E_NO_FACES), three columns
/// (E_DIMENSION).
void validate_control_mesh(const Surface<double>& surface);
/// Boundary vertices where the plain Loop rules have a limit normal: fewer than 8 neighbours if smooth, fewer than 5 at a corner.
/// Throws E_BOUNDARY_VALENCE naming the first other vertex.
void validate_boundary_normals(const Mesh& mesh, const Tags& tags);

/// w of an interior vertex: its limit point is (w v + sum of the ring)/(w + N). Equal to 24 N/(40 - (3 + 2 cos(2 pi/N))^2).
template <class S>
S loop_weight(int valence);
/// Weights of a smooth boundary vertex and of each of its two neighbours along the boundary in its limit point.
template <class S>
struct BoundaryWeights {
  S centre, end;
};
template <class S>
BoundaryWeights<S> loop_boundary_weights();
/// Weights of v, p_1 .. p_K (K >= 2) in the tangent across a smooth boundary, which points inwards: the left eigenvector for
/// 3/8 + cos(pi/(K-1))/4.
template <class S>
std::vector<S> loop_boundary_tangent(int neighbours);

/// Limit masks of all vertices of a mesh. Holds the mesh and its rings; costs O(vertices).
template <class S>
class LoopLimit {
 public:
  /// Throws what validate_loop_mesh throws; Error{not_exact} where a weight has no value in S.
  LoopLimit(std::shared_ptr<const Mesh> mesh, Tags tags);

  [[nodiscard]] const Mesh& mesh() const { return *mesh_; }
  [[nodiscard]] const Tags& tags() const { return tags_; }
  [[nodiscard]] const VertexRings& rings() const { return rings_; }
  [[nodiscard]] bool is_interior(int v) const { return !mesh_->on_boundary(v); }
  /// w of an interior vertex.
  [[nodiscard]] const S& weight(int v) const { return weights_.at(mesh_->valence(v)); }
  [[nodiscard]] const BoundaryWeights<S>& boundary_weights() const { return boundary_; }

  /// Rows: limit points of the field (a row per vertex, any columns).
  [[nodiscard]] Points<S> points(const Points<S>& field) const;
  /// Six columns: two tangents of a field with three columns. A boundary vertex has the one along the boundary first.
  [[nodiscard]] Points<S> tangents(const Points<S>& field) const;

 private:
  std::shared_ptr<const Mesh> mesh_;
  Tags tags_;
  VertexRings rings_;
  std::map<int, S> weights_;  // by valence
  BoundaryWeights<S> boundary_;
};

/// The limit matrix M of a small mesh, row sums 1: limit points = M times control points. Throws Error{limit, "E_TOO_LARGE"}
/// above 2000 vertices.
template <class S>
Points<S> limit_matrix(const LoopLimit<S>& limit);

/// Unit normals from tangents (six columns); to the side from which faces are counter-clockwise. For double and Interval. Throws
/// E_ZERO_NORMAL naming the vertex where tangents are parallel or vanish: |t1 x t2| <= 1e-13 |t1| |t2|, or not certainly above.
template <class S>
Points<S> normals_of(const Points<S>& tangents);
/// Normals of a surface with three columns. Throws what validate_boundary_normals and normals_of throw.
template <class S>
Points<S> limit_normals(const LoopLimit<S>& limit, const Points<S>& points);

}  // namespace udcp
