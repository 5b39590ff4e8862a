// A word on a mesh by whatever way is fastest: a plan where one applies and pays, the atoms one by one elsewhere.
#pragma once

#include <variant>

#include "operators/plan/plan.h"

namespace udcp {

/// Flat where all faces have three or all have four corners, which is every primal word after its first round; otherwise (dual
/// words, n-gons) a surface with its limit points in place where they are asked for.
template <class R>
struct Refined {
  std::variant<FlatMesh<R>, Surface<double>> mesh;
  Points<double> normals;  // of a surface, if asked for
  [[nodiscard]] bool is_flat() const { return mesh.index() == 0; }
};

/// What run() and limit() give, to 1e-12 (double) or 1e-6 (float) of the size of the mesh, in the numbering of Plan where a plan
/// is used and in that of run() elsewhere; control vertices first in either. Throws what run() and, for limits and normals,
/// limit() throw.
template <class R>
Refined<R> refine(const Word& word, const Surface<double>& surface, int rounds, const PlanControl& control = {});

}  // namespace udcp
