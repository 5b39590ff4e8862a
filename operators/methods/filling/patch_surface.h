// A surface made of patches, one per face of a quad mesh: bicubic ones at regular faces, and what a method puts at the others.
// Knows how patches meet along the edges of the mesh, but not how the others are made.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "operators/methods/filling/adjustable.h"
#include "operators/methods/filling/bezier_patch.h"
#include "operators/surface.h"

namespace udcp {

struct PatchSurface {
  Surface<double> cage;  // quads; three columns
  /// Per face; one without points where there is none. Patch f runs along half-edge first[f]: its tail is (0,0), its tip (1,0).
  std::vector<BezierPatch> patches;
  std::vector<int> first;
  std::vector<int> filled;  // vertices of the cage around which the patches are a fill
  int steps = 0;            // of subdivision that led to the cage

  [[nodiscard]] bool has_patch(int f) const { return patches[Mesh::i(f)].points.size() != 0; }
};

/// The 4x4 net (rows 4 a + b) of a face, a along half-edge `first`; beyond a boundary the net goes on by reflection, as the curve
/// rules of the boundary ask. Nothing if the face or one next to it is no quad, or a corner is neither an interior vertex of
/// valence 4 nor a boundary vertex with two faces, or one (a fixed corner).
std::optional<Points<double>> regular_net(const Surface<double>& surface, int first);

/// Patches at all regular faces: bicubic B-splines, or hybrid ones by a parameter per vertex (empty: 1/2).
PatchSurface regular_patches(Surface<double> cage, const std::vector<double>& c = {},
                             TangentFactor tangents = TangentFactor::paper);

/// The parameters (u, v) of patch f at the fraction t of half-edge h of its face.
std::array<double, 2> on_side(const PatchSurface& surface, int h, double t);

/// How well patches meet along the edges that have a patch on both sides, in samples of each, its ends included.
struct JoinDefects {
  long long edges = 0;
  double gap = 0;           // largest distance of the two sides
  double normal = 0;        // largest distance of unit normals
  double curvature = 0;     // largest distance of curvature tensors (Frobenius), relative to the larger one or to 1/size
  long long irregular = 0;  // samples without a normal on some side
  int worst_edge = -1;      // where `curvature` is
};
/// `size`: the length that the cage is measured by; its bounding box's diagonal is size_of(cage).
JoinDefects join_defects(const PatchSurface& surface, int samples = 11);
/// Diagonal of the bounding box of the points.
double size_of(const Surface<double>& surface);

/// The faces around a vertex, counter-clockwise, and the n + 2n = 3n faces around those (each once).
struct FaceRings {
  std::vector<int> inner, outer;
};
FaceRings face_rings(const Mesh& mesh, int v);

/// Numbers of the points in `rings` rings around the vertex that half-edge `start` leaves, as ring_number counts them; needs that
/// many rings of quads, regular inside.
std::vector<int> ring_vertices(const Mesh& mesh, int start, int rings);

/// n x n quads per patch, with shared vertices where patches meet, the attributes "gaussian" and "mean", and unit normals;
/// at shared vertices the means of the patches that meet there. Faces without a patch are left open. Throws Error{limit,
/// "E_MAX_FACES"}.
struct Tessellation {
  Surface<double> surface;
  Points<double> normals;
};
Tessellation tessellate(const PatchSurface& surface, int n, const RunControl& control = {});

}  // namespace udcp
