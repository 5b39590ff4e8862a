// Difference schemes of words whose parameters run over a box: exact bounds that hold for all of them at once. Used by the search
// and by the checker of "curve-box"; searches for nothing itself.
#pragma once

#include <vector>

#include "proofs/bernstein.h"
#include "proofs/static_word.h"

namespace udcp {

/// The mask of S_{k+1}, which acts on (k+1)-th differences, as polynomials over one positive denominator, in the finite
/// coordinates of the box (bernstein.h).
struct BoxScheme {
  int arity = 2;
  int smoothness = 0;                     // k
  std::vector<BoxPolynomial> numerators;  // entry i of the mask, shifted to start at 0, times the denominator
  BoxPolynomial denominator;              // positive on the box
  std::vector<Side> box;
};

/// Throws Rejected: a parameter outside the box, sum rules of order below k + 1, a denominator that is not shown to keep its
/// sign.
BoxScheme difference_scheme_on_box(const Word& word, int smoothness, const ParameterBox& box);

/// True only if A^{kL} ||S_{k+1}^L|| < 1 for all parameters of the cell (push-back, section 4; Dyn's contractivity).
bool contracts_on(const BoxScheme& scheme, int length, const std::vector<Side>& cell);

/// The transition matrices T_0 .. T_{A-1} of S_{k+1} times the denominator, and the denominator, at a point of the coordinates.
struct ScaledTransitions {
  std::vector<Points<Rational>> matrices;
  Rational denominator;
};
ScaledTransitions transitions_at(const BoxScheme& scheme, const std::vector<Rational>& point);
/// Numerators and denominator are of degree at most 1 in every coordinate: then what holds at the corners of a cell for a convex
/// condition holds inside.
bool is_multi_affine(const BoxScheme& scheme);
std::vector<std::vector<Rational>> corners_of(const std::vector<Side>& cell);

}  // namespace udcp
