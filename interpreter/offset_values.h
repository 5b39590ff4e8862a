// Offsets of Loop surfaces as the language asks for them: arguments to options, results as meshes and tables. What the functions
// of builtins_offset.cpp share.
#pragma once

#include "interpreter/apply.h"
#include "interpreter/arguments.h"
#include "operators/methods/offset/offset.h"
#include "operators/methods/offset/self_intersection.h"

namespace udcp {

/// Meshes in the plane lie at z = 0.
template <class S>
Surface<S> three_columns(Surface<S> surface) {
  if (surface.points.cols() >= 3) return surface;
  Points<S> points = Points<S>::Zero(surface.points.rows(), 3);
  points.leftCols(surface.points.cols()) = surface.points;
  surface.points = std::move(points);
  return surface;
}

/// Four digits, for texts.
std::string short_number(double x);

/// distance, tolerance, max_level, solver, fit, local, pad, samples. Throws E_ARGUMENTS without a distance, E_TYPE.
OffsetOptions offset_options(const Arguments& a, CallContext& context);

/// S and F on one mesh, from the arguments `mesh` and `offset`: S is refined by Loop until it has the faces of F. Throws
/// Error{input, "E_OFFSET_MESH"} where that does not happen.
struct OffsetPair {
  Surface<double> surface;
  Points<double> d;
  int level = 0;  // rounds of S
};
OffsetPair offset_pair(const Arguments& a, CallContext& context);

/// A control mesh of a Loop surface as a value: glTF files show its limit surface, all else the mesh.
Value control_mesh(Surface<double> surface);
/// The limit surface of a control mesh, after so many rounds that it looks smooth, with its normals.
MeshValue limit_surface(const MeshValue& control, CallContext& context);
/// Limit points with a value per vertex in the attribute `name`, which pictures show.
Value coloured_surface(const Surface<double>& limit, Points<double> normals, const std::string& name, std::vector<double> values);

/// A warning where the exact offset folds, naming the place.
void warn_of_folds(const Surface<double>& surface, double distance, CallContext& context);

/// Tables with the numbers as JSON.
ReportValue error_report(const OffsetPair& pair, const Arguments& a, CallContext& context);
ReportValue intersection_report(const OffsetPair& pair, int rounds, CallContext& context);
/// What offset did: levels, unknowns, solver, errors and bounds.
ReportValue offset_table(const OffsetResult& result, const OffsetOptions& options);

/// The claims offset_contracts(valence), offset_definite(valence), offset_within(mesh, offset, distance, bound) and
/// embedded(mesh).
Value claim_offset_contracts(CallContext&, const Arguments&);
Value claim_offset_definite(CallContext&, const Arguments&);
Value claim_offset_within(CallContext&, const Arguments&);
Value claim_embedded(CallContext&, const Arguments&);

}  // namespace udcp
