// Floating-point eigenvalues of the Fourier blocks: evidence for reports and pictures, and approximations for proofs to start
// from. Nothing here decides anything.
#pragma once

#include <complex>

#include "proofs/blocks.h"
#include "proofs/spectrum.h"

namespace udcp {

/// By falling modulus; equal moduli by falling real part, then imaginary part.
std::vector<std::complex<double>> eigenvalues(const Points<Interval>& a);
/// Per frequency m = 0 .. floor(n/2), the eigenvalue 1 of the constants included. Multiple eigenvalues are ill-conditioned.
std::vector<std::vector<std::complex<double>>> eigenvalues_by_frequency(const Patch<Interval>& patch, int radius);

/// The real eigenvalue of largest modulus with its eigenvector, improved by the enclosure that it must have in the end; nothing
/// if the dominant eigenvalues are complex, multiple, or the vector vanishes in component 0.
std::optional<ApproximatePair> approximate_eigenpair(const Points<Interval>& a);

}  // namespace udcp
