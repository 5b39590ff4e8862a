// Claims over boxes of parameters: subdivision of the box into cells on which one exact bound serves all parameters, or a point
// where the claim is refuted (Semi-stationary push-back subdivision, Theorem 2, and what goes beyond it).
#pragma once

#include "proofs/box_scheme.h"
#include "proofs/verdict.h"

namespace udcp {

/// C^k (k = 0: convergence) on curves for all parameters of the box; the word's parameters are rational functions of them. The
/// certificate "curve-box" is a tree of cells; refuted with a point of the box and the certificate of the refutation there.
[[nodiscard]] Result prove_smooth_on_box(const Word& word, int smoothness, const ParameterBox& box, const SearchLimits& limits);

/// The word with numbers in place of its parameters.
Word at_point(const Word& word, const std::map<std::string, Rational>& values);

/// T_e of all corners of a cell, divided by the denominator: a body that all of them shrink is shrunk by every parameter of the
/// cell. Throws Rejected if the scheme is not multi-affine or unbounded there.
std::vector<Points<Rational>> transitions_on(const BoxScheme& scheme, const std::vector<Side>& cell);

/// One cell of a region, in the coordinates of its parameters.
struct RegionCell {
  std::vector<Rational> lower, upper;
  Verdict verdict = Verdict::undecided;
};
/// The box cut into cells on which the claim is proved, refuted (one product of transition matrices has an eigenvalue beyond
/// A^-k on the whole cell) or undecided; cells are not made smaller than 2^-depth of the box. Finite boxes only.
std::vector<RegionCell> region_of_smoothness(const Word& word, int smoothness, const ParameterBox& box, int depth,
                                             const SearchLimits& limits);

}  // namespace udcp
