// Which words a plan can serve, and how far around a face the rounds of a word look. Knows no mesh.
#pragma once

#include <optional>
#include <vector>

#include "operators/word.h"

namespace udcp {

/// Rounds of a word that only see connectivity and tags, so that faces that look alike have the same matrix.
struct RoundsAhead {
  Word word;           // a scheme without a head to come; the operator of a finite word as its tail
  int first_item = 0;  // of the first of the rounds, as in RunControl
  int rounds = 0;
  int arity = 2;           // segments that one round makes of an edge
  std::vector<int> rings;  // rings of faces that count before round 0, 1, .., and after the last

  [[nodiscard]] int item_of(int round) const { return first_item + round * static_cast<int>(word.tail.size()); }
  [[nodiscard]] int segments() const;  // of an edge after all rounds; a million where there are more
};

/// The scheme whose rounds are those of the word: the word itself, or the tail of a finite operator. Nothing where a plan cannot
/// serve: parameters that differ from point to point (noise, v.name, alpha0 by valence), dual results, rounds without U.
std::optional<Word> planned_word(const Word& word);

/// The rounds from item `first_item` on. `last_rings`: rings that are wanted after the last round.
RoundsAhead rounds_ahead(const Word& planned, int first_item, int rounds, int last_rings);

}  // namespace udcp
