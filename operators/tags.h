// What a user marks on the elements of a shape: corners (points that stay fixed) and the direction of edges.
#pragma once

#include <vector>

namespace udcp {

/// longitude and latitude steer f, omega, alpha0 and the ring pass. U hands the tag of an edge to its
/// children.
enum class EdgeTag : char { none, longitude, latitude };

/// Empty vectors mean: nothing is tagged.
struct Tags {
  std::vector<EdgeTag> edge;  // per edge
  std::vector<char> corner;   // per vertex, 1 for a corner

  [[nodiscard]] EdgeTag of_edge(int e) const { return edge.empty() ? EdgeTag::none : edge[static_cast<std::size_t>(e)]; }
  [[nodiscard]] bool is_corner(int v) const { return !corner.empty() && corner[static_cast<std::size_t>(v)] != 0; }
};

}  // namespace udcp
