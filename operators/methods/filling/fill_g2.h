// A whole mesh as patches that join with G2: adjustable Catmull-Clark steps, bicubic B-splines at regular faces, and n patches of
// bidegree 7 around every other vertex. Here are the conditions under which that works, and the application of the masks.
#pragma once

#include "operators/methods/filling/fill_mask.h"
#include "operators/methods/filling/patch_surface.h"

namespace udcp {

struct FillOptions {
  /// The parameter of the steps: empty for 1/2, one entry for all vertices, or one per vertex (hybrid steps). After a step the
  /// surface is that of c = 1/2. Without steps the parameters stand, and must be 1/2 in the two rings of a filled vertex.
  std::vector<double> c;
  int steps = -1;                                 // negative: as few as the fill needs, and at least one where c is not 1/2
  TangentFactor tangents = TangentFactor::paper;  // of hybrid patches
  /// Leave faces without a patch at boundary vertices with more than two faces, where there is no fill, instead of an error.
  bool leave_out = false;
  FillMasks* masks = nullptr;  // to share masks between calls
  RunControl control{};
};

/// Boundary vertices with one face stay fixed; points with fewer than three columns get zeros. Throws Error{input}: what
/// validate throws, E_NOT_FINITE naming the vertex, E_ADJUSTABLE_C for c outside [0, 1] (or 0 without steps), E_FILL_C for a
/// parameter that is not 1/2 near a filled vertex, E_FILL_ISOLATED for a vertex that is not isolated enough (with the number of
/// steps that helps), E_FILL_BOUNDARY for a boundary vertex that no number of steps makes regular, E_FILL_VALENCE, E_FILL_STEPS.
PatchSurface fill_g2(const Surface<double>& surface, const FillOptions& options = {});

/// Catmull-Clark steps after which every interior vertex of another valence than 4 can be filled: 0, 1 (quads) or 2.
int fill_steps(const Mesh& mesh);

/// The surface without a fill: patches at the regular faces only, around extraordinary vertices after `steps` steps.
PatchSurface plain_surface(const Surface<double>& surface, int steps, const RunControl& control = {});

/// The 3n regular patches next to those around the vertex after 0, 1, .. levels Catmull-Clark steps: rings of the limit surface
/// that close in on the vertex. Only its three rings are refined; they must be there, of quads, and regular inside:
/// E_FILL_ISOLATED.
std::vector<std::vector<BezierPatch>> catmull_clark_rings(const Surface<double>& surface, int vertex, int levels);
/// Their curvature by level, on 3x3 samples of each patch.
std::vector<CurvatureExtrema> catmull_clark_curvature(const Surface<double>& surface, int vertex, int levels);

}  // namespace udcp
