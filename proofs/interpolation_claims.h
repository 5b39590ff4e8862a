// Theorems on Catmull-Clark surfaces through given points with given normals: that the two-level method interpolates a given mesh
// exactly, and what lambda does to the iteration over a whole mesh. The proofs; their checker is check_interpolation.cpp.
#pragma once

#include "proofs/interpolation_facts.h"
#include "proofs/verdict.h"

namespace udcp {

/// "The surface passes exactly through every vertex and has there exactly the direction and side of its normal", for exact input.
/// Proved by the claims that Catmull-Clark is C^1 at the valences that occur and by a certificate of the kind "interpolation",
/// whose witness are the control points. Refuted, by one of the kind "interpolation-reversed", at a vertex whose limit normal is
/// 90 degrees off or more before step 2. Undecided with the reason for meshes that not_covered speaks of and for linear systems
/// that are too large. Throws Error{interrupted}.
Result prove_interpolation(const ExactInterpolation& what, const SearchLimits& limits = {});

/// "For 7/20 < lambda <= 1 the iteration converges on every closed quad mesh of these valences", with a certificate of the kind
/// "interpolation-threshold".
Result prove_lambda_range(std::vector<int> valences);
/// Whether the iteration W += V - limits(modified step of W) converges on this mesh for all V: proved by prove_lambda_range, or
/// refuted for lambda <= 7/20 on closed quad meshes that are two-colourable, with a certificate of the kind
/// "interpolation-checkerboard"; else undecided.
Result prove_iteration_converges(const Mesh& mesh, const Rational& lambda);

}  // namespace udcp
