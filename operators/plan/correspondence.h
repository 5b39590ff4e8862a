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

/// Per vertex of what run() makes of `planned` its number in what a plan makes of it; empty where the faces differ. Both order
/// faces by the face that they come from, and run() starts with the one at its first corner; points that should be the same
/// tell whether that holds. Linear.
std::vector<int> numbers_in_plan(const Mesh& made_by_run, const Mesh& made_by_plan, const Mesh& planned);

}  // namespace udcp
