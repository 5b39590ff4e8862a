// Circles: regular polygons stay regular and on a circle in every round (Semi-stationary push-back subdivision, Theorem 1), as an
// identity in c = cos(alpha/2); and the radius of the limit.
#pragma once

#include "proofs/static_word.h"
#include "proofs/verdict.h"

namespace udcp {

/// One round on a regular polygon whose neighbours stand at the angle alpha: 2K corners on a circle, radius times `factor`
/// (a function of X = cos(alpha/2) and of the parameters of a claim), times cos(alpha/4) for dual words.
struct CircleRound {
  Parametric factor;
  bool dual = false;
};
/// Binary words with one U per round whose parameters are functions of cos(alpha/2). Throws Rejected with the reason if the round
/// keeps no circles or that is not shown.
CircleRound circle_round(const Word& word);

/// For every K >= 3: regular K-gons become circles if alpha0 = 2 pi/K. Certificate "circle"; refuted where the identity fails.
[[nodiscard]] Result prove_circle(const Word& word);

/// The radius of the limit of a regular K-gon of radius 1 with alpha0 = 2 pi/K, enclosed to about 1e-30. Throws Error{word,
/// "E_NO_CIRCLE"} if the word keeps no circles or its parameters have no values.
Interval circle_radius(const Word& word, int corners);

}  // namespace udcp
