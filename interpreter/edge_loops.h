// Rings of edges that lie in a plane across an axis: what tag(lat, loops(axis = z)) marks.
#pragma once

#include <vector>

#include "operators/surface.h"

namespace udcp {

/// Edges of closed loops whose points share their coordinate along `axis` (0 x, 1 y, 2 z) within 1e-9 of the size of the mesh.
/// Level edges that hang together in any other way (a flat cap, an open line) are left out. Throws E_DIMENSION if there is no
/// such axis.
std::vector<int> planar_edge_loops(const Surface<double>& surface, int axis);

}  // namespace udcp
