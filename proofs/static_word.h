// Words whose parameters are constant numbers, possibly one per valence: what the theorems about schemes speak of. A word with
// kernel functions has its static limit, the word at alpha = 0.
#pragma once

#include <vector>

#include "operators/word.h"
#include "proofs/certificate.h"

namespace udcp {

/// True if no parameter of the tail depends on alpha, h or the point: the word is its own static limit.
bool is_static(const Word& word);

/// One round of the word at alpha = 0 as a scheme without head. Parameters may still depend on the valence. Throws Error{word}:
/// E_MASK_VARIES for parameters that differ from point to point, E_NO_STATIC_LIMIT for h on its own (its limit is unknown) and
/// for parameters without a value at alpha = 0, E_NOT_A_SCHEME for finite operators.
Word static_limit(const Word& word);

/// One round with a variable in place of every function of alpha, the same one for the same closed form at the same level of U:
/// what holds for it holds in every round, whatever alpha0 is. Throws what static_limit throws, and Error{not_exact} for
/// functions without a closed form.
Word with_symbols(const Word& word);

/// {"triangles": bool, "items": [{"atom": "U", "sections": 2}, {"atom": "C", "f": "1", "ngon": "dual"}, {"atom": "D", "f": ..},
/// {"atom": "P", "omega": .., "omega_face": .. or null, "delta": {"4": .., "5": ..}}]} with the exact values of all parameters,
/// delta and the others at the given valences. `word` is a static_limit(). Throws Error{not_exact} where a value is neither
/// algebraic nor a rational function of parameters, and Error{word, "E_F_BY_VALENCE"} if f or omega depend on the valence.
Json to_json(const Word& word, const std::vector<int>& valences);
/// The word back again; its delta knows the listed valences only. Throws Rejected.
Word word_from(const Json& json);

/// "U C P with f = 1, omega = 1, delta = 1 (N = 4), 2 (N = 5)", from the JSON: for statements.
std::string describe(const Json& word);

}  // namespace udcp
