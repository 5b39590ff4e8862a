// A word on a shape, and shapes between exact and double: run() with the limits and the stop flag of the session.
#pragma once

#include "interpreter/expressions.h"
#include "operators/run.h"

namespace udcp {

/// Curves, meshes, and lists of them. E_ROUNDS for a scheme without rounds, E_NOT_TRIANGLES, E_TYPE, and what run() throws.
Value apply(const WordValue&, Value shape, CallContext&);
/// `what` stands in progress messages.
RunControl run_control(const CallContext&, const std::string& what);

/// How many threads the settings stand for.
int thread_count(const Settings&);

/// Limit normals at the vertices of the result of so many rounds of a scheme; null where there are none, or they are too many to
/// be worth it.
std::shared_ptr<const Points<double>> limit_normals(const WordValue& word, int rounds, const Surface<double>& surface,
                                                    RunControl control);

/// The shape in double, whatever it was.
Surface<double> as_double(const MeshValue&);
/// The points as fractions, without attributes: the decimals of the file for points as they were loaded, doubles otherwise as the
/// dyadic numbers that they are. Error{not_exact}: E_NOT_EXACT for irrational coordinates, E_NOT_FINITE.
Surface<Rational> as_rational(const MeshValue&);
Polyline<double> as_double(const CurveValue&);

}  // namespace udcp
