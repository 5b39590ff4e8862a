// Connectivity of U and of the dual: integers only. Closed formulas on half-edges, no search.
#pragma once

#include <memory>

#include "operators/mesh.h"
#include "operators/tags.h"

namespace udcp {

/// Which split U makes. Quad version: every face of n corners into n quads (d = 2), quads into d*d (d > 2). Triangles: d*d each.
struct Split {
  int sections = 2;
  bool triangles = false;
};

/// Where the vertices of a split mesh come from: index < old_vertices: V; < old_vertices + edge_points: E; else F.
struct Origin {
  int old_vertices = 0;
  int edge_points = 0;
  [[nodiscard]] bool is_old(int v) const { return v < old_vertices; }
  [[nodiscard]] bool is_in_face(int v) const { return v >= old_vertices + edge_points; }
};
Origin origin_of_split(const Mesh& before, Split split);

/// New vertices: old, then (d-1) per edge in edge direction, then inner points per face. Throws Error{word, "E_USPLIT"} for a
/// face that U[d] cannot split, E_NOT_TRIANGLES for a face that is no triangle, Error{limit, "E_TOO_LARGE"} past 2^31 half-edges.
Mesh split_mesh(const Mesh& mesh, Split split);
/// Tags of the split mesh: children inherit, an edge from an E point into a face gets the opposite direction.
Tags split_tags(const Mesh& mesh, const Tags& tags, const Mesh& refined, Split split);

/// Quad faces whose four edges are tagged alternately, one entry per face.
bool is_alternately_tagged(const Mesh& mesh, const Tags& tags, int face);

/// The dual mesh: vertices are the faces, the boundary edges and the corners of `mesh`. Throws E_VALENCE2 (interior vertex of
/// valence 2), E_CORNER (corner inside).
struct DualMesh {
  Mesh mesh;
  Tags tags;
};
DualMesh dual_mesh(const Mesh& mesh, const Tags& tags);
/// Rows of a dual: faces + boundary edges + boundary corners.
int dual_rows(const Mesh& mesh, const Tags& tags);

EdgeTag opposite(EdgeTag tag);

}  // namespace udcp
