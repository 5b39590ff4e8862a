// How much a Catmull-Clark surface stretches its parameters, at the points of its limit mesh: a picture in floating point that
// decides nothing.
#pragma once

#include "operators/limit.h"
#include "operators/surface.h"

namespace udcp {

struct JacobianSurface {
  Surface<double> surface;  // limit points after the steps, with the attribute "jacobian"
  Points<double> normals;   // of the limit, unit
};

/// In the plane det(S_u, S_v), counted positive where most of each component is, in space |S_u x S_v|; both for the unit
/// parameters of the faces that were given. Vertices at which these parameters have no derivative (interior ones without four
/// faces, boundary ones with three faces or more) have the mean of their neighbours. Boundary vertices of one face are corners.
/// Throws what QuadMesh and run() throw, and Error{input, "E_NOT_FINITE"} where the range of double is too small for a value; of
/// at most 250,000 faces.
JacobianSurface jacobian_surface(Surface<double> surface, int steps, RunControl control);

}  // namespace udcp
