// Whether the Catmull-Clark surface of a mesh is regular everywhere: patches by the adaptive decision, interior extraordinary
// vertices by rings. The search; its checker is check_regularity.cpp.
#pragma once

#include <functional>

#include "proofs/regularity/cone_tests.h"
#include "proofs/regularity/quad_mesh.h"
#include "proofs/verdict.h"

namespace udcp {

struct RegularityOptions {
  RegularityMode mode = RegularityMode::bspline;
  RegularityTest test = RegularityTest::t2;
  int depth = 6;                 // splits of a patch
  bool except_boundary = false;  // leave out the faces at boundary vertices that are not regular, and claim the rest
  int steps = 2;                 // refinements for that: the faces left out are those of this level, at most 6
  SearchLimits limits{600, 20'000'000, nullptr};                          // nodes: nets
  std::function<void(const std::string& what, double share)> progress{};  // share of the work, roughly
};

/// "The Catmull-Clark surface is regular" for exact points; corners are the tagged vertices. Meshes with extraordinary vertices,
/// or with faces that are no quads, are refined exactly until those are isolated. Proved with a certificate of the kind
/// "regular-surface"; refuted, with one of the kind "irregular-surface", by a point where S_u x S_v = 0 or, in the plane, by two
/// points of one connected part where the Jacobian has different signs. Undecided with the faces that nothing covers, and for
/// meshes without a patch. Throws what QuadMesh and cover throw (proofs/regularity/covered_surface.h).
Result prove_regular(const Surface<Rational>& surface, const RegularityOptions& options = {});

}  // namespace udcp
