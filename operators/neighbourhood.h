// The faces within a few rings of a vertex as a mesh of their own, numbered the same way wherever they look the same.
#pragma once

#include <vector>

#include "operators/mesh.h"
#include "operators/tags.h"

namespace udcp {

struct Neighbourhood {
  Mesh mesh;  // face 0 starts with the centre, which is vertex 0; its outermost vertices lie on a rim that may be no
  Tags tags;  // boundary of the original, and may not even be manifold
  std::vector<int> vertex;     // per local vertex its index in the original
  std::vector<int> signature;  // equal signatures: equal mesh, tags and boundary within the rings
};

/// `rings` >= 1 rings of faces around the vertex that half-edge `start` leaves; on a boundary `start` must be mesh.outgoing.
/// Two neighbourhoods with the same signature correspond vertex by vertex.
Neighbourhood neighbourhood(const Mesh& mesh, const Tags& tags, int start, int rings);

}  // namespace udcp
