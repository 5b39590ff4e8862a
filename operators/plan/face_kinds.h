// The kinds of neighbourhoods that the faces of a mesh have, and all of them side by side as one mesh. Knows no points.
#pragma once

#include <atomic>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "operators/plan/face_rings.h"

namespace udcp {

/// One neighbourhood for all faces that look like it.
struct FaceKind {
  std::vector<int> code, twin;
  std::vector<char> corner;   // per local vertex; empty where nothing is tagged
  std::vector<EdgeTag> edge;  // per local half-edge; empty where nothing is tagged
  int vertices = 0;           // columns of its matrix
  std::uint64_t faces = 0;    // how many look like it
};

/// The kinds met so far, numbered in the order of their first appearance.
template <int N>
class FaceKinds {
 public:
  /// The kind of what `walker` found last on the mesh with these tags; a new one where none has the same code.
  int add(const FaceRings& rings, const RingWalker<N>& walker, const Tags& tags, const Mesh& mesh);

  [[nodiscard]] int size() const { return static_cast<int>(kinds_.size()); }
  [[nodiscard]] const FaceKind& operator[](int kind) const { return kinds_[static_cast<std::size_t>(kind)]; }
  [[nodiscard]] int most_vertices() const;

  /// All kinds as one mesh, one beside the other; the central face of kind k is the first of its faces.
  struct Sheet {
    Mesh mesh;
    Tags tags;
    std::vector<int> first_vertex, first_face;  // per kind, and one past the last
  };
  [[nodiscard]] Sheet sheet() const;

 private:
  [[nodiscard]] int find(const std::vector<int>& code, std::vector<int>*& candidates);

  std::vector<FaceKind> kinds_;
  std::unordered_map<std::uint64_t, std::vector<int>> by_hash_;
  int last_ = 0;  // the kind met last: neighbours tend to look alike
};

/// The faces of a mesh by kind. Vertices are numbers of the mesh.
template <int N>
struct FaceGroups {
  FaceKinds<N> kinds;
  std::vector<int> kind, start;           // per face: its kind, and the half-edge from which it was walked
  std::vector<std::uint32_t> vertex;      // per face the vertices of its neighbourhood, in local order
  std::vector<std::size_t> first_vertex;  // per face, and one past the last
};
/// Ends, with the groups so far, at the first face that makes more than `most_kinds` kinds. Throws E_INTERRUPTED.
template <int N>
FaceGroups<N> group_faces(const Mesh& mesh, const Tags& tags, int rings, int most_kinds, const std::atomic<bool>* stop = nullptr);

}  // namespace udcp
