// Offsets of Loop surfaces: the Loop surface F on the mesh of S whose points at control vertices lie exactly at the distance
// ("Offset approximation of Loop subdivision surfaces", Ding, Hu and Zhou), refined until an error is small enough.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "operators/methods/offset/offset_error.h"
#include "operators/methods/offset/offset_system.h"

namespace udcp {

struct OffsetOptions {
  double distance = 0;              // positive to the side from which faces are counter-clockwise
  std::optional<double> tolerance;  // of max |eps|, sampled: refine S until it is met
  int max_level = 5;                // Loop steps of S at most, with a tolerance
  int sample_rounds = 2;            // further rounds on which the error is sampled
  bool local = false;               // after a step, solve only around faces whose error was above the tolerance
  int pad = 1;                      // by so many rings of faces
  bool fit = false;                 // try the normal-weighted fit with alpha 0.1 and 0.01 and keep the smallest max |eps|
  SolveOptions solve;
  RunControl control;  // its stop and progress serve the solver too
};

struct OffsetLevel {
  int level = 0, vertices = 0, unknowns = 0;
  double eps = 0;
};

struct OffsetResult {
  Surface<double> base;     // S, refined `log.back().level` times
  Points<double> d;         // control vectors of F - S
  Surface<double> surface;  // F: the mesh of base
  std::vector<OffsetLevel> log;
  OffsetSolver solver = OffsetSolver::direct;
  int iterations = 0;     // of the last solve
  double residual = 0;    // of the last solve; of the interpolation, also where a fit replaced it
  double fit_weight = 0;  // alpha, or 0 where the interpolation was kept
  OffsetErrors errors;    // sampled
  int worst_face = 0;     // face of `base` with the largest |eps|
};

/// The tolerance was not met by max_level, or by as many levels as the largest number of faces allows; `best` is the result of
/// the level with the smallest error.
struct ToleranceError : Error {
  ToleranceError(const std::string& message, std::shared_ptr<const OffsetResult> result)
      : Error(ErrorKind::limit, "E_OFFSET_LEVELS", message, "raise the tolerance or max_level, or refine creases by hand"),
        best(std::move(result)) {}
  std::shared_ptr<const OffsetResult> best;
};

/// Throws what validate_control_mesh, limit_normals, solve_offset and run throw; Error{input}: E_NOT_FINITE for the distance,
/// E_TOLERANCE unless the tolerance is positive and finite, E_OPTION for levels, rounds or distances out of range (0 .. 12, 0 ..
/// 6, 1e-100 .. 1e100); and ToleranceError.
OffsetResult offset(const Surface<double>& surface, const OffsetOptions& options);

/// Both offsets, by distance and by -distance, with the boundaries of an open mesh joined by strips of triangles: the control
/// mesh of a closed body of thickness 2 |distance|, faces outwards. `inner` and `outer` are control meshes on the same
/// connectivity.
Surface<double> shell(const Surface<double>& outer, const Surface<double>& inner);

}  // namespace udcp
