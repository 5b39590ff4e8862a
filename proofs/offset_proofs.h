// Theorems about offsets of Loop surfaces: the iteration contracts and the system is positive definite at a valence; an offset
// stays within a bound of the exact one; a surface does not meet itself. Searches; the checkers are in check_offset.cpp.
#pragma once

#include <optional>

#include "operators/surface.h"
#include "proofs/loop_facts.h"
#include "proofs/verdict.h"

namespace udcp {

/// The edge iteration of "Offset approximation of Loop subdivision surfaces" contracts at vertices of this valence with regular
/// neighbours. Certificate "offset-contraction"; refuted where the bound is 1 or more (pair at valences 3 and 4), with the bound
/// as witness. Error{input, "E_DOMAIN"} for valences out of range.
[[nodiscard]] Result prove_offset_contraction(int valence, LocalSet set);

/// K = W + A is positive definite as far as vertices of this valence are concerned: w > N/2, so that eigenvalues of the limit
/// matrix are at least (w - N/2)/(w + N). Certificate "offset-definite".
[[nodiscard]] Result prove_offset_definite(int valence);

/// Everywhere |delta - distance n| <= bound (full) or ||delta| - |distance|| <= bound: S has the control points of `surface`,
/// delta the control vectors d, both as the exact numbers that the doubles are. Closed meshes. Without a bound, one that is 1.25
/// times the largest sample. Certificate "offset-error".
[[nodiscard]] Result prove_offset_error(const Surface<double>& surface, const Points<double>& d, const Rational& distance,
                                        bool full, std::optional<Rational> bound = std::nullopt, const SearchLimits& limits = {});

/// The Loop surface with these control points does not meet itself. Closed meshes. Certificate "embedded-surface".
[[nodiscard]] Result prove_embedded(const Surface<Rational>& surface, const SearchLimits& limits = {});
/// With the control points as the exact numbers that the doubles are.
[[nodiscard]] Result prove_embedded(const Surface<double>& surface, const SearchLimits& limits = {});

}  // namespace udcp
