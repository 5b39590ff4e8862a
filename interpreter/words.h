// Words as written become words that run: names and calls expanded, repeats unrolled, bindings closed over their formulas.
//
// Which binding wins: an atom's own argument, then the `where` of the word it is written in, then the `where` of the words around
// it: an outer `where` fills only what the inner word left open. alpha0 and rings belong to the whole word; two different values
// are an error.
#pragma once

#include "interpreter/expressions.h"

namespace udcp {

inline constexpr int max_word_items = 100'000;

/// Throws Located at the offending item: what validate throws, E_STAR, E_NAME, E_BINDING, E_TYPE, E_WORD_TOO_LONG,
/// E_TRIANGLES_MIX.
WordValue make_word(const grammar::WordExpr&, grammar::Span, CallContext&);

/// w^n: of a scheme, its head and n rounds; of an operator, n times.
WordValue power(const WordValue&, int n);
/// The word with its rounds written out: what a mask or a matrix is made of.
Word finite(const WordValue&);
/// Item by item and binding by binding; a missing binding equals its default.
bool same_word(const WordValue&, const WordValue&);
/// "omega = 1" for every parameter that the word uses and leaves open.
std::vector<std::string> defaults_of(const Word&);

}  // namespace udcp
