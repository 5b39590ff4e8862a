// The paper's own test over a whole mesh (T1): all edges of a component in one frame, Theorem 3 of "On Regularity of
// Catmull-Clark Subdivision Surfaces" in its corrected form. It speaks of patch faces only, and a rectangle that passes is
// embedded.
#pragma once

#include "proofs/regularity/cone_tests.h"
#include "proofs/regularity/quad_mesh.h"

namespace udcp {

/// no_frame: the faces have no consistent u and v, as around most extraordinary vertices.
enum class GlobalStatus { pass, fail, no_frame };
std::string to_string(GlobalStatus);

struct GlobalResult {
  GlobalStatus status = GlobalStatus::fail;
  std::vector<RegularityWitness> components;  // n and m of each component; only if all pass
};
GlobalResult test_globally(const QuadMesh& mesh);

/// All edges of each component as differences in u and v, zeros included, an edge once; nothing without a global frame.
std::optional<std::vector<Differences>> edge_differences(const QuadMesh& mesh);

/// One component, all vertices regular (interior, boundary or corner) and exactly four corners: by the angle sum a full rectangle
/// of quads.
bool is_rectangle(const QuadMesh& mesh);

}  // namespace udcp
