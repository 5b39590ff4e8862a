// A refined mesh as flat arrays: what a plan makes, and what writers and viewers take. Knows no half-edges.
#pragma once

#include <cstdint>

#include "operators/plan/buffer.h"

namespace udcp {

/// R = float or double. All faces have the same number of corners.
template <class R>
struct FlatMesh {
  Buffer<R> points;               // three per vertex, x y z x y z ...
  Buffer<R> normals;              // empty, or three per vertex: unit, or 0 0 0 where there is no tangent plane
  Buffer<std::uint32_t> corners;  // corners_per_face per face, counter-clockwise
  int corners_per_face = 4;       // 4 or 3

  [[nodiscard]] std::int64_t vertices() const { return static_cast<std::int64_t>(points.size() / 3); }
  [[nodiscard]] std::int64_t faces() const {
    return static_cast<std::int64_t>(corners.size()) / (corners_per_face > 0 ? corners_per_face : 1);
  }
};

}  // namespace udcp
