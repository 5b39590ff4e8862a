// Equality of words: do they make the same points out of every input? Decided from matrices and masks of the running atoms.
#pragma once

#include <vector>

#include "proofs/static_word.h"
#include "proofs/verdict.h"

namespace udcp {

/// A round of one scheme may be several of the other: so many rounds of each have the same arity.
struct RoundsToCompare {
  int first = 1, second = 1;
};

/// Are the schemes the same operator? `valences` empty: on curves; otherwise on meshes around vertices of these valences and
/// faces with so many corners, boundaries included. The words are static_limit()s; parameters may be variables (Parametric), then
/// the answer holds for all their values. Certificate "equality". Refuted with a new point whose weights differ.
[[nodiscard]] Result prove_equal(const Word& first, const Word& second, const std::vector<int>& valences);

namespace equality {
/// The first place where the operators differ, as text; empty if nowhere. Exact. Throws what run() throws.
std::string difference_on_curves(const Word& first, const Word& second, RoundsToCompare rounds);
std::string difference_on_meshes(const Word& first, const Word& second, RoundsToCompare rounds, int valence);
}  // namespace equality

}  // namespace udcp
