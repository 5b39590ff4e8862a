// Enclosures of eigenpairs and bounds of spectral radii, checked without an eigenvalue solver. Knows nothing of where the
// matrices come from and searches for nothing.
#pragma once

#include <optional>
#include <vector>

#include "operators/number.h"

namespace udcp {

/// An eigenvalue and its eigenvector, component 0 of which is 1.
struct Eigenpair {
  Interval value;
  std::vector<Interval> vector;
};
/// The precision of all enclosures in these proofs, in bits: set it for the time of a proof (Interval::Precision).
inline constexpr int proof_precision = 128;
/// What a proof starts from: multiples of 2^-eigenpair_bits.
struct ApproximatePair {
  Rational value;
  std::vector<Rational> vector;
};
inline constexpr int eigenpair_bits = 40;

/// The one real eigenpair of the real matrix near the approximation, by the theorem of Newton and Kantorovich in the form
/// alpha + beta rho + gamma rho^2/2 <= rho, beta + gamma rho < 1 for F(v, lambda) = (a v - lambda v, v_0 - 1); nothing if the
/// conditions do not hold.
std::optional<Eigenpair> enclose_eigenpair(const Points<Interval>& a, const ApproximatePair& near);
/// Whether every number of the approximation is the multiple of 2^-eigenpair_bits next to the enclosed one (up to 1/1000 of it):
/// so an approximation is not the right one after any change.
bool is_nearest(const ApproximatePair& approximation, const Eigenpair& exact);

/// a - lambda v e_0^T: the eigenvalues of a with one lambda replaced by 0 (Wielandt), as v_0 = 1.
Points<Interval> deflated(const Points<Interval>& a, const Eigenpair& pair);
/// An upper bound of the spectral radius: the least of ||a^(2^p)||^(1/2^p), p <= 14, in row-sum norms; or the first below
/// `target`.
double spectral_radius_bound(const Points<Interval>& a, double target = 0);
/// A lower bound: the largest of (|trace a^(2^p)|/n)^(1/2^p).
double spectral_radius_lower_bound(const Points<Interval>& a);
/// A double that is not below (above) anything in the enclosure.
double upper_bound(const Interval& x);
double lower_bound(const Interval& x);

}  // namespace udcp
