// Proofs that the limit surfaces of a word are C^1 at extraordinary points, one valence at a time: Reif's theorem in the form of
// Peters, Reif and Zorin. The search for certificates; their checker is check_surface.cpp.
#pragma once

#include "operators/word.h"
#include "proofs/verdict.h"

namespace udcp {

/// "C^1 at vertices (faces, for an odd number of D) of this valence for almost all control nets", for static words (is_static)
/// with one U[2] per round. Proved with a certificate of the kind "surface-c1". Refuted, with one of the kind "surface-spectrum",
/// if the dominant eigenvalue below 1 has another frequency than 1 and n - 1; if it is multiple, undecided with such a
/// certificate. Otherwise undecided with the reason. Throws Error{interrupted, "E_INTERRUPTED"} and Error{not_exact} for
/// parameters that are not algebraic.
Result prove_surface_c1(const Word& word, int valence, const SearchLimits& limits = {});
/// One result per valence; the limits hold for each.
std::vector<Result> prove_surface_c1(const Word& word, const std::vector<int>& valences, const SearchLimits& limits = {});

/// Whether condition 2 of the theorem fails at this valence: refuted with a certificate of the kind "surface-spectrum", or
/// undecided.
Result refute_surface_spectrum(const Word& word, int valence, const SearchLimits& limits = {});

}  // namespace udcp
