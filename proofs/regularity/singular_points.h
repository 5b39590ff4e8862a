// Points of a Catmull-Clark surface that refute its regularity, from their data: exact derivatives there, and words for what they
// show. Shared by the search and its checker; nothing here is found by trying.
#pragma once

#include <atomic>

#include "proofs/certificate.h"
#include "proofs/regularity/bicubic_net.h"

namespace udcp {

/// S, S_u, S_v at dyadic u, v in [0, 1] of a patch, each up to a positive factor. Throws Rejected for other u and v.
CornerValues values_at(const BicubicNet& net, Rational u, Rational v);

/// {"mesh", "mode", "steps", "ring": null or {"vertex", "ring"}, "points": [{"face", "u", "v"}, ..]}: faces of the mesh after the
/// steps, or patches of the ring. One point where S_u x S_v is zero, or two points in the plane of one connected part with
/// different signs. Returns a sentence on what happens there; throws Rejected where nothing is refuted,
/// and Error{interrupted}.
std::string describe_singularity(const Json& data, const std::atomic<bool>* stop = nullptr);

}  // namespace udcp
