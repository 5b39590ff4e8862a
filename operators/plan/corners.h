// The faces of a plan's result as closed formulas: no half-edge is walked. Knows no points.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "operators/mesh.h"

namespace udcp {

/// The numbering of Plan, for faces with N corners and `segments` segments per edge. Refers to mesh and `turn`, as in Plan.
template <int N>
class ResultNumbers {
 public:
  ResultNumbers(const Mesh& mesh, const std::vector<std::uint8_t>& turn, int segments);

  /// Numbers of the first point inside half-edge h (the others follow upwards or, against the direction of the edge, downwards)
  /// and inside face f.
  [[nodiscard]] std::uint32_t in_edge(int h) const {
    const std::uint32_t first = first_edge_ + static_cast<std::uint32_t>(mesh_.edge[Mesh::i(h)]) * (n_ - 1);
    return along(h) ? first : first + n_ - 2;
  }
  [[nodiscard]] bool along(int h) const { return mesh_.edge_half[Mesh::i(mesh_.edge[Mesh::i(h)])] == h; }
  [[nodiscard]] std::uint32_t in_face(int f) const { return first_face_ + static_cast<std::uint32_t>(f) * inside_; }

  /// Writes the corners of the faces that come from faces `first` .. `last` - 1 of the mesh.
  void write(int first, int last, std::uint32_t* corners) const;

 private:
  struct Patch {
    std::uint32_t at, border;  // entry of the block, place on its border
  };
  void write_border(int f, std::uint32_t* border) const;

  const Mesh& mesh_;
  const std::vector<std::uint8_t>& turn_;
  std::uint32_t n_, inside_, first_edge_, first_face_;
  std::array<std::vector<std::uint32_t>, N> interior_;  // per turn and corner of the n * n faces: its row inside
  std::vector<Patch> patches_;                          // and those on the border
};

}  // namespace udcp
