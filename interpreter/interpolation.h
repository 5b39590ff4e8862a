// Interpolation of points and normals as the language asks for it: arguments to options, and what came out as meshes and tables.
#pragma once

#include "interpreter/apply.h"
#include "interpreter/arguments.h"
#include "operators/methods/interpolation/interpolation.h"

namespace udcp {

/// The names of arguments that interpolate, interpolation_report and interpolation_figure share.
inline const std::vector<std::string_view> interpolation_arguments{"normals", "lambda", "step1", "step2",       "method",
                                                                   "order",   "sweeps", "flip",  "free_points", "free_normals"};

/// lambda, step1, step2, method, order, sweeps, flip, free_points, free_normals. Throws E_TYPE for other names, E_INDEX.
InterpolateOptions interpolation_options(const Arguments& a, int vertices, CallContext& context);

/// The argument `normals` in S: no (zero rows); yes, also if it is left away (the attributes nx, ny, nz that files with normals
/// bring, else sums of the area vectors of faces); from("n") (attributes nx, ny, nz, or of any other beginning); a list of [x, y,
/// z]; or a function of x, y and z. Throws E_ATTRIBUTE, E_DIMENSION, E_TYPE; Error{not_exact} where S is exact and a number is
/// not.
template <class S>
Points<S> normals_argument(const Arguments& a, const Surface<S>& surface, const MeshValue& mesh, CallContext& context);

/// Runs it all with the limits of the session, in double; notes become warnings.
struct InterpolationRun {
  Surface<double> cage;
  Points<double> normals;  // zero rows: none asked for
  InterpolateOptions options;
  Interpolation result;
};
InterpolationRun run_interpolation(const Arguments& a, CallContext& context);

/// A line per vertex: angle before, correction, displacement; the most remarkable ones first where there are many.
ReportValue interpolation_table(const InterpolationRun& run);

/// Side by side: the cage, plain Catmull-Clark, and the interpolating surface with a spike for each normal; both surfaces
/// `rounds` rounds fine. The attribute "part" is 0, 1, 2, and 3 for the spikes. `length` of the spikes; 0: by the size of the
/// mesh and its edges.
Surface<double> interpolation_figure(const InterpolationRun& run, int rounds, double length, const RunControl& control);
/// Thin pyramids from points along normals.
Surface<double> spikes(const Points<double>& points, const Points<double>& normals, double length);

/// The claims interpolates(mesh, normals = ..., step1 = global | local, lambda, step2 = free | tied), and
/// iteration_converges(mesh, lambda = 7/10) or, for all lambda in (7/20, 1], iteration_converges() for N in 3..8.
Value claim_interpolates(CallContext&, const Arguments&);
Value claim_iteration_converges(CallContext&, const Arguments&);

}  // namespace udcp
