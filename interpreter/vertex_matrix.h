// The subdivision matrix of a mesh word at a vertex: square, on the smallest neighbourhood that maps to itself.
#pragma once

#include "interpreter/value.h"

namespace udcp {

struct VertexMatrix {
  int rings = 0;
  MatrixValue matrix;  // rows and columns: centre, then ring by ring, as ring_mesh numbers them
};

/// One round that starts as round `round`, at a vertex of valence N in a regular neighbourhood. `rings` 0: as few as possible.
/// Exact where the word is, else enclosures. Throws Error{word}: E_MATRIX_DUAL for words that end in the dual state,
/// E_MATRIX_RINGS if the points of these rings depend on points outside of them (or no number of rings up to 6 is enough).
VertexMatrix vertex_matrix(const Word& word, int valence, int rings, int round);

/// f<Algebraic>() where that is exact, else f<Interval>().
template <class F>
auto exact_or_enclosed(F f)
    -> std::variant<decltype(f(std::type_identity<Algebraic>{})), decltype(f(std::type_identity<Interval>{}))> {
  try {
    return f(std::type_identity<Algebraic>{});
  } catch (const Error& error) {
    if (error.kind != ErrorKind::not_exact && error.code != "E_FIELD_DEGREE") throw;
  }
  return f(std::type_identity<Interval>{});
}

}  // namespace udcp
