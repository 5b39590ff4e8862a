// Two ways of interpolating on the first refinement, for study: the paper's repeated sweeps, which diverge on many meshes, and
// all conditions at once by the shortest correction, which can be huge. interpolation.h has the method to use.
#pragma once

#include <vector>

#include "operators/methods/interpolation/interpolate_normals.h"
#include "operators/methods/interpolation/interpolate_points.h"
#include "operators/methods/interpolation/ring_tangents.h"

namespace udcp {

/// What the points and normals of a sweep are based on: jacobi, all corrections on the same mesh, added; gauss, vertex by vertex
/// in the order of indices; average, jacobi divided by the number of corrections at a point.
enum class SweepOrder { jacobi, gauss, average };

struct SweepOptions {
  PointOptions points;           // lambda of the start, the modified step of the cage
  Spread spread = Spread::tied;  // the paper's choice
  SweepOrder order = SweepOrder::jacobi;
  int sweeps = 5;
  std::vector<char> skipped_normals;
};

struct Sweeps {
  Surface<double> control;                  // one step fine, after the last sweep
  std::vector<InterpolationErrors> errors;  // after each sweep
  // The change by the last sweep that was more than rounding, against that by the one before: above 1 the sweeps diverge. After
  // many sweeps it tends to the spectral radius of the sweep, if the start has any of its leading mode.
  double growth = 0;
};
/// Each sweep is step 1 in closed form for all vertices, then step 2 for all. Stops early only where coordinates leave the range
/// of double. Throws Error{input, "E_NOT_CLOSED"} naming a boundary vertex, and what check_cage and check_normals throw.
Sweeps sweep(const Surface<double>& cage, const Points<double>& normals, const SweepOptions& options = {});

struct LeastCorrection {
  Surface<double> control;                            // one step fine
  int rank = 0, rows = 0;                             // of the conditions
  double squared_displacement = 0, displacement = 0;  // summed, largest
};
/// The shortest corrections of interpolate_points(cage) by which all positions and the planes of all normals become right; the
/// sides of the normals are not controlled. step is global or local. Throws as sweep, and Error{limit, "E_TOO_LARGE"} beyond
/// 5,000 vertices.
LeastCorrection least_correction(const Surface<double>& cage, const Points<double>& normals, const PointOptions& options = {},
                                 const std::vector<char>& skipped_normals = {});

}  // namespace udcp
