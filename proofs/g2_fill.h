// The G2 fill of one valence, for every ring of points: in exact numbers, with the printed formulas that are wrong refuted.
#pragma once

#include "operators/word.h"
#include "proofs/fill_facts.h"
#include "proofs/verdict.h"

namespace udcp {

/// Around a vertex of this valence the patches of the fill exist for every ring, join with G2 with each other and with the
/// surface of `word` (bicubic where it is regular), and one choice is fairest. Certificate "g2-fill". Undecided for words with
/// another regular part. Throws Error{limit, "E_FILL_VALENCE"} outside 3 .. largest_exact_fill, Error{interrupted}.
[[nodiscard]] Result prove_g2(const Word& word, int valence, const SearchLimits& limits = {});
/// The same with one formula as printed: refuted with certificate "g2-print", undecided where the print is right at this valence.
[[nodiscard]] Result prove_g2_as_printed(int valence, Print print, const SearchLimits& limits = {});

}  // namespace udcp
