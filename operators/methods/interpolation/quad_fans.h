// The quads around a vertex in the notation of the interpolation papers: neighbours e_j counter-clockwise, f_j across the face of
// e_j and e_(j+1). Integers only.
#pragma once

#include <vector>

#include "operators/mesh.h"

namespace udcp {

/// Inside, as many f as e; on the boundary one e more, the first and the last e lying on the boundary.
struct Fan {
  bool inside = true;
  std::vector<int> e, f;
  [[nodiscard]] int faces() const { return static_cast<int>(f.size()); }
};

/// The fan of v, from the half-edge mesh.outgoing[v], into `fan` (whose memory is used again). All faces around v must be quads.
void collect_fan(const Mesh& mesh, int v, Fan& fan);

/// A vertex (number 0), inside or on the boundary, with `faces` quads around it and nothing else: e_j is number 1 + 2j, f_j
/// number 2 + 2j. At least three faces inside.
Mesh fan_mesh(int faces, bool inside);

}  // namespace udcp
