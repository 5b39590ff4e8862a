// The word on regular parts of surfaces: its mask on the quad or triangle lattice, difference schemes, contractivity. Exact.
#pragma once

#include <array>
#include <optional>

#include "proofs/patch.h"

namespace udcp {

/// new point at y = sum of at(y - 2k) * old point at k, all in half steps; the coefficient number j*nx + i is the one at
/// (x0 + 2i, y0 + 2j).
template <class S>
struct LatticeMask {  // double too, for bounds
  int x0 = 0, y0 = 0, nx = 0, ny = 0;
  std::vector<S> coefficients;
  [[nodiscard]] S at(Place offset) const;  // 0 outside
};

/// The mask of the regular lattice, from the rows around a point of regular valence (rows within 6 half steps). Throws
/// Error{internal} if the valence is not the regular one.
template <class S>
LatticeMask<S> lattice_mask(const Patch<S>& regular);
/// The mask on the word's own lattice: quads, triangles or dual.
template <class S>
LatticeMask<S> lattice_mask(const Word& word);

/// a/(1 + z^d): the mask of the differences along d, which live at midpoints. Nothing if it does not divide. d in {-1, 0, 1}^2.
template <class S>
std::optional<LatticeMask<S>> difference_mask(const LatticeMask<S>& a, Place direction);
/// Sup norm of `length` rounds: the largest sum of moduli over one residue class modulo 2^length. Error{limit, "E_TOO_LARGE"}.
template <class S>
S contraction(const LatticeMask<S>& a, int length);
/// The mask of `length` rounds, for new points at y - 2^length k.
template <class S>
LatticeMask<S> iterated(const LatticeMask<S>& a, int length);

/// What makes a word C^1 on regular lattices, if it is factorable: the schemes of the divided differences along both axes and,
/// for each of them, its differences along every lattice direction that divides.
template <class S>
struct RegularPart {
  LatticeMask<S> mask;
  std::array<LatticeMask<S>, 2> derivative;                // 2 a/(1 + z1), 2 a/(1 + z2)
  std::array<std::vector<LatticeMask<S>>, 2> differences;  // of each
};
/// Nothing, and the reason in `why`, unless a has row sums 1, is divisible by 1 + z1 and 1 + z2, and each quotient is divisible
/// again along two directions.
template <class S>
std::optional<RegularPart<S>> regular_part(const LatticeMask<S>& mask, bool triangles, std::string* why = nullptr);
/// The least bound b such that each derivative scheme has two directions whose differences contract by b in `length` rounds:
/// below 1, the word is C^1 on regular lattices (Dyn: difference schemes).
template <class S>
S regular_bound(const RegularPart<S>& part, int length);

}  // namespace udcp
