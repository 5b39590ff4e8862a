// Semi-stationary words on curves: how fast the rounds approach the static limit, and which smoothness they inherit from it
// (Semi-stationary push-back subdivision, Theorem 3 and eq. (11), as corrected: convergence always, C^k under form I or II).
#pragma once

#include "proofs/static_word.h"
#include "proofs/verdict.h"

namespace udcp {

/// ||S(alpha) - S|| <= first * alpha and, if the masks are flat at 0, <= second/2 * alpha^2, for 0 <= alpha <= range: rounds h
/// with alpha_h = alpha_0/A^h <= range satisfy eq. (11) with gamma = 1/A, or 1/A^2 if flat.
struct AsymptoticBounds {
  Rational range;
  Rational first, second;  // upper bounds
  bool flat = false;       // every m_i'(0) is exactly 0
  int arity = 2;
  int exact_sum_rules = 0;  // of every round, whatever the values of f, omega and delta are
};

/// Run in jets over [0, range]. The word is a round whose parameters are functions of alpha (head ignored). Throws what the atoms
/// throw, E_MASK_VARIES, E_NO_STATIC_LIMIT, and Error{not_exact} where a kernel has no derivative.
AsymptoticBounds asymptotic_bounds(const Word& word, const Rational& range);
/// The same for the largest of 1, 1/2, 1/4, ... 1/1024 that works.
AsymptoticBounds asymptotic_bounds(const Word& word);
/// Up to which k the limits are C^k if the static limit is: form I (k < 2 if flat, else 0) or form II (k <= exact_sum_rules).
int inherited_smoothness(const AsymptoticBounds& bounds);

/// C^k of the limits of a semi-stationary word, for every alpha_0 for which all rounds exist. `static_part` is the result for its
/// static limit. Certificate "asymptotic".
[[nodiscard]] Result prove_asymptotic(const Word& word, int smoothness, const Result& static_part);

}  // namespace udcp
