// The faces within a few rings of a face, found in an order that depends on their connectivity alone: where two faces look alike,
// the same local numbers come out. Works on meshes whose faces all have N corners.
#pragma once

#include <cstdint>
#include <vector>

#include "operators/mesh.h"
#include "operators/tags.h"

namespace udcp {

/// What is around one face, seen from one of its corners. Local vertices 0 .. N-1 are its own corners.
struct FaceRings {
  std::vector<int> vertex;  // per local vertex: its index in the mesh
  std::vector<int> half;    // per local face, the central one first: the half-edge in the mesh that its first corner leaves
  std::vector<int> code;    // per local face N local vertices, then the tags; equal codes: equal connectivity and tags
};

/// Walks one mesh; it keeps its marks from face to face, so that a walk costs no more than what it finds.
template <int N>
class RingWalker {
 public:
  /// The mesh must outlive the walker; all its faces have N corners. `rings` >= 0 rings of faces.
  RingWalker(const Mesh& mesh, const Tags& tags, int rings);

  /// The rings around the face of half-edge `start`, from the corner that it leaves. Valid until the next call.
  const FaceRings& around(int start);
  /// Local half-edges of the last walk: twins, -1 where there is none within the rings.
  [[nodiscard]] std::vector<int> twins() const;

 private:
  static std::size_t at(int k) { return static_cast<std::size_t>(k); }
  int find(int v);
  void add_face(int half);
  void expand(int k);
  void write_tags(int inner);

  const Mesh& mesh_;
  const Tags& tags_;
  int rings_;
  FaceRings found_;
  std::vector<int> first_half_;  // per local vertex
  struct Mark {
    std::uint32_t walk = 0;  // that found it last
    int local = 0;           // and its number then
  };
  std::vector<Mark> vertex_mark_, face_mark_;
  std::uint32_t walk_ = 0;
};

/// Per half-edge a number that depends on the connectivity and the tags near it, so that faces that look alike have the same N
/// numbers up to rotation: the corner with the smallest sequence is the one to start from. `rings` as for the walker.
template <int N>
class Starts {
 public:
  Starts(const Mesh& mesh, const Tags& tags, int rings);
  /// The half-edge of face f to start from.
  [[nodiscard]] int of_face(int f) const;

 private:
  std::vector<std::uint32_t> key_;  // per half-edge
};

}  // namespace udcp
