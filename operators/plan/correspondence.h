// Two meshes that are the same but for their numbering.
#pragma once

#include <vector>

#include "operators/mesh.h"
#include "operators/plan/flat_mesh.h"

namespace udcp {

/// The half-edges of a flat mesh, with its numbering. Throws what make_mesh throws.
template <class R>
Mesh half_edges_of(const FlatMesh<R>& flat);

/// Per vertex of `a` its counterpart in `b`, walking both from half-edges that correspond; empty where the meshes differ or are
/// not connected. Linear.
std::vector<int> correspondence(const Mesh& a, int half_a, const Mesh& b, int half_b);

/// The half-edge of a plan's result that leaves the first corner of the first face of the mesh planned for, in the faces that
/// come from that face; -1 where there is none. It corresponds to half-edge 0 of what run() makes.
int first_half(const Mesh& result, const Mesh& planned);

}  // namespace udcp
