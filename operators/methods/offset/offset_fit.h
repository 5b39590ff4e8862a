// The fit of control vectors that weighs normal errors above tangential slip, on the mesh of S.
#pragma once

#include "operators/run.h"

namespace udcp {

/// d that minimises sum_s a_s [(delta_s . n_s - distance)^2 + alpha |tangential part of delta_s|^2] over the vertices s of the
/// twice refined mesh, where a_s is a third of the area of the limit triangles around s, divided by the mean. alpha > 0. The rows
/// of delta_s come from the word on unit vectors, many of which share a column. Throws Error{limit, "E_TOO_LARGE"} beyond 200
/// million weights, and what limit_normals throws.
Points<double> fit_offset(const Surface<double>& surface, double distance, double alpha, const RunControl& control = {});

}  // namespace udcp
