// Catmull-Clark surfaces through given points with given normals: "Catmull-Clark Subdivision Interpolation Based on Vertex Normal
// Vector Constraint", corrected. The paper corrects the first refinement, where neighbouring rings share points, so that no pass
// interpolates; here the normals are turned one refinement later, where the rings of different vertices are disjoint:
//   M1 = step 1 of the cage (interpolate_points.h), M2 = one ordinary step of M1, then step 2 (interpolate_normals.h) on the
//   rings of the cage's vertices in M2. Limit points stay, so positions and normals are both exact after this one pass.
#pragma once

#include <string>
#include <vector>

#include "operators/methods/interpolation/interpolation_study.h"

namespace udcp {

enum class InterpolationMethod { two_level, literal, kkt };

struct InterpolateOptions {
  PointStep step1 = PointStep::global;
  Rational lambda = Rational(7) / Rational(10);
  NormalStep step2 = NormalStep::automatic;
  InterpolationMethod method = InterpolationMethod::two_level;
  SweepOrder order = SweepOrder::jacobi;              // literal
  int sweeps = 5;                                     // literal
  bool flip = false;                                  // turn all faces over first
  std::vector<char> skipped_points, skipped_normals;  // per vertex, 1: not prescribed; empty: all are
  RunControl control;                                 // max_faces bounds the 16 |F| faces of the result
};

struct Interpolation {
  Surface<double> control;  // M2 (M1 for literal and kkt); its first vertices are those of the cage, in their order
  int rounds = 2;           // steps from the cage to `control`
  std::vector<VertexReport> vertices;
  double signed_volume = 0;  // of the cage if it is closed, faces as planar fans; negative: its faces point inward
  bool is_closed = true;
  InterpolationErrors errors;               // measured on `control`
  std::vector<InterpolationErrors> sweeps;  // literal
  double growth = 0;                        // literal: above 1 the sweeps diverge
  int rank = 0, rows = 0;                   // kkt
  std::vector<std::string> notes;           // what the user should know: faces inward, angles above 90 degrees, divergence
};

/// Interpolates all vertices of `cage` with the rows of `normals` (none at all for zero rows). Attributes are interpolated by U.
/// Throws what interpolate_points, turn_normals, sweep and least_correction throw; Error{input, "E_ARGUMENTS"} for skipped lists
/// of a wrong length and rotate with literal; and Error{interrupted}.
Interpolation interpolate(const Surface<double>& cage, const Points<double>& normals, const InterpolateOptions& options = {});

/// The same surface with all faces turned over; the tags follow their edges.
Surface<double> flipped(const Surface<double>& surface);
/// Volume enclosed by a closed mesh, faces as fans about their means; positive if they are counter-clockwise from outside.
double signed_volume(const Surface<double>& surface);

}  // namespace udcp
