// Connectivity of a polygon mesh: half-edges, consecutive per face, so that next and prev are arithmetic. Knows no points.
// A Mesh is an oriented 2-manifold, boundary allowed, every vertex in some face; make_mesh refuses anything else.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "operators/error.h"

namespace udcp {

struct Mesh {
  std::vector<int> face_begin;  // F + 1 entries; the half-edges of face f are face_begin[f] .. face_begin[f+1] - 1
  std::vector<int> vertex;      // per half-edge: the vertex it leaves
  std::vector<int> twin;        // per half-edge: the opposite one; -1 on the boundary
  std::vector<int> edge;        // per half-edge: its edge, numbered by first appearance
  std::vector<int> face;        // per half-edge: its face
  std::vector<int> edge_half;   // per edge: the half-edge of its first appearance, which gives its direction
  std::vector<int> outgoing;  // per vertex: the half-edge of lowest index that leaves it; on the boundary the one without a twin
  std::vector<int> valences;  // per vertex: number of edges

  [[nodiscard]] int vertices() const { return static_cast<int>(outgoing.size()); }
  [[nodiscard]] int edges() const { return static_cast<int>(edge_half.size()); }
  [[nodiscard]] int faces() const { return static_cast<int>(face_begin.size()) - 1; }
  [[nodiscard]] int half_edges() const { return static_cast<int>(vertex.size()); }
  [[nodiscard]] int size(int f) const { return face_begin[i(f) + 1] - face_begin[i(f)]; }
  [[nodiscard]] int next(int h) const { return h + 1 == face_begin[i(face[i(h)]) + 1] ? face_begin[i(face[i(h)])] : h + 1; }
  [[nodiscard]] int prev(int h) const { return h == face_begin[i(face[i(h)])] ? face_begin[i(face[i(h)]) + 1] - 1 : h - 1; }
  [[nodiscard]] int tip(int h) const { return vertex[i(next(h))]; }
  [[nodiscard]] int valence(int v) const { return valences[i(v)]; }
  [[nodiscard]] bool on_boundary(int v) const { return twin[i(outgoing[i(v)])] < 0; }
  [[nodiscard]] bool is_boundary_edge(int e) const { return twin[i(edge_half[i(e)])] < 0; }
  /// The next half-edge that leaves the same vertex, counter-clockwise; -1 past the last one on a boundary.
  [[nodiscard]] int around(int h) const { return twin[i(prev(h))]; }
  /// The half-edge that arrives at a boundary vertex along the boundary (its edge has no other face).
  [[nodiscard]] int boundary_arrival(int v) const;
  [[nodiscard]] bool all_faces_have(int corners) const;
  [[nodiscard]] std::span<const int> corners(int f) const {
    return {vertex.data() + face_begin[i(f)], static_cast<std::size_t>(size(f))};
  }

  static std::size_t i(int k) { return static_cast<std::size_t>(k); }  // index of a vector
};

/// What make_mesh throws, with the places for whoever knows more about them (readers add the file and the line): the face that is
/// named first, and the second one or -1, both counted from 0.
struct MeshError : Error {
  MeshError(std::string error_code, const std::string& message, std::string error_help, int first_face = -1, int second_face = -1)
      : Error(ErrorKind::input, std::move(error_code), message, std::move(error_help)),
        face(first_face),
        other_face(second_face) {}
  int face, other_face;
};

/// Fills edge, edge_half, outgoing and valences of a mesh of `vertices` vertices from face_begin, vertex, twin and face. Linear.
void complete_mesh(Mesh& mesh, int vertices);

/// Builds the connectivity from index cycles, `corners` concatenated, face f being corners[begin[f]] .. corners[begin[f+1]-1].
/// Throws MeshError (kind input) naming the face, edge or vertex: an index out of range (E_INDEX), fewer than three corners
/// (E_FACE_SIZE), a repeated vertex (E_FACE_REPEATS), the same face twice (E_DUPLICATE_FACE), an edge with more than two faces
/// (E_EDGE_FACES), two faces that run along an edge in the same direction (E_ORIENTATION, or E_NOT_ORIENTABLE when no choice of
/// orientations is consistent), fans that meet in a vertex (E_VERTEX_FANS), a vertex in no face (E_ISOLATED); the first of these
/// in this order that applies. A mesh without faces is E_NO_FACES, one past 2^31 - 1 half-edges Error{limit, "E_TOO_LARGE"}. Two
/// faces with the same corners in opposite order are a duplicate only if a third face meets their edges: alone they are a pillow,
/// which is closed and legal. Vertices and faces count from 0 in the messages unless `first_index` says 1. Linear in the size of
/// the mesh.
Mesh make_mesh(int vertices, std::vector<int> begin, std::vector<int> corners, int first_index = 0);

/// For lists of faces in programs and tests.
Mesh make_mesh(int vertices, const std::vector<std::vector<int>>& faces);

}  // namespace udcp
