// The Catmull-Clark surface of a mesh as claims about its regularity speak of it: refined to the level at which patches and rings
// cover it, what covers each face, and the sentence. Shared by the search and its checker; nothing here is found by trying.
#pragma once

#include "operators/run.h"
#include "proofs/certificate.h"
#include "proofs/regularity/quad_mesh.h"

namespace udcp {

std::string to_string(RegularityMode);

/// The surface after `steps` exact rounds of the running word, and what covers its faces. Vertices and faces count from 0.
struct CoveredSurface {
  QuadMesh mesh;  // of level `steps`
  RegularityMode mode = RegularityMode::bspline;
  int steps = 0;
  bool has_quads = true;              // level 0, so that face f there became the faces f 4^steps and on
  std::vector<int> patches;           // faces that are regular patches
  std::vector<int> rings;             // extraordinary vertices whose faces are covered by rings
  std::vector<int> uncovered;         // faces that nothing covers
  std::vector<int> uncovered_around;  // the vertices to blame
};
/// Runs the word and sorts the faces. Points of a plane are taken in coordinates of that plane. Modes other than bspline allow
/// steps for closed meshes only, as they have no boundary rule. Throws Error{input, "E_NOT_QUADS"} for faces that are no quads at
/// level `steps`, Rejected for steps that the mode does not allow, Error{limit, "E_TOO_LARGE"} past most_regularity_faces, and
/// Error{interrupted}.
CoveredSurface cover(const Surface<Rational>& surface, RegularityMode mode, int steps, const RunControl& control = {});
inline constexpr std::int64_t most_regularity_faces = 4'000'000;
inline constexpr int most_regularity_steps = 6;

/// Every extraordinary vertex has regular neighbours only, and some face is a patch.
bool is_isolated(const CoveredSurface& surface);
bool is_closed(const Mesh& mesh);

/// Only vertices on the boundary leave faces uncovered.
bool leaves_out_boundary_only(const CoveredSurface& surface);

/// "the Catmull-Clark surface of the mesh with 8 vertices and 6 faces (digest ..)"; the digest is that of its JSON.
std::string name_of_surface(const Json& mesh, RegularityMode mode);
/// What is proved; uncovered faces are its exception.
std::string regular_statement(const Json& mesh, const CoveredSurface& surface, bool embedded);
std::string irregular_statement(const Json& mesh, RegularityMode mode);

}  // namespace udcp
