// Exact half-space routines: do finitely many vectors lie in one open half space? The answer is a normal, which is its own proof.
#pragma once

#include <optional>
#include <span>

#include "proofs/regularity/vector3.h"

namespace udcp {

/// n with n.w > 0 for all w, none of which may be zero, or nothing if there is none; an empty set has the normal (0, 0, 1).
/// Exact: floating point only proposes normals, whose signs are then checked. For vectors of integers.
std::optional<Vector3> half_space(std::span<const Vector3> vectors);
/// n.w > 0 for all w.
bool is_positive_on(const Vector3& n, std::span<const Vector3> vectors);

}  // namespace udcp
