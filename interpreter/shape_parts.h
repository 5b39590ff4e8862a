// Small helpers of the builtins that work on shapes.
#pragma once

#include "interpreter/expressions.h"

namespace udcp {

/// The edge between two vertices. Throws E_TAGS if there is none.
int find_edge(const Mesh&, int a, int b);
/// Of the edges without a tag, those that join two vertices with `tag` edges and are sides of quads next to such an edge get the
/// opposite tag.
void tag_crossing_edges(MeshValue&, EdgeTag tag);
/// Faces turned around, vertex order and tags kept.
template <class S>
Surface<S> reversed(const Surface<S>&);
template <class S>
Polyline<S> reversed(const Polyline<S>&);
/// A number for all, a number per point, or a function of one to three coordinates.
template <class S>
std::vector<S> attribute_column(const Points<S>&, const Value& values, CallContext&);

}  // namespace udcp
