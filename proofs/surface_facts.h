// What the theorem on extraordinary points needs to know of a word and a valence, derived from the running atoms: rows, regular
// part, ring. Shared by the proof and its checker; nothing here is found by trying.
#pragma once

#include "proofs/characteristic_map.h"
#include "proofs/static_word.h"

namespace udcp {

/// Rows around a point of one valence, exact and enclosed.
template <class S>
struct LocalFacts {
  Patch<S> patch;
  Patch<Interval> enclosed;
  int radius = 0;  // invariant
};
/// Checks that the rows sum to 1 and are mirror symmetric. At least the rows within `radius`. Throws Rejected with the reason
/// where a hypothesis does not hold.
template <class S>
LocalFacts<S> local_facts(const Word& word, int valence, int radius = 0);

template <class S>
struct SurfaceFacts {
  RegularPart<S> part;
  CellSets sets;
  Ring ring;
  LocalFacts<S> local;
};
/// Checks besides that the word is factorable and that the rows are regular on the ring. Throws Rejected.
template <class S>
SurfaceFacts<S> surface_facts(const Word& word, int valence);

/// A bound of the moduli of all eigenvalues but 1 and the pair, which belongs to frequency 1 (and n - 1). Only as sharp as it
/// takes to lie below the pair, if it does.
template <class S>
double other_eigenvalues_bound(const LocalFacts<S>& facts, const Eigenpair& pair);
/// Whether some eigenvalue of B_m (for m = 0: other than the 1 of the constants) is above all of B_1, by enclosures.
template <class S>
bool is_frequency_above(const LocalFacts<S>& facts, int frequency);
/// The control net of the characteristic map on the ring.
template <class S>
CharacteristicNet characteristic_net(const SurfaceFacts<S>& facts, const Eigenpair& pair);

/// The valences at which the parameters count: n and the regular one, rising; the regular one alone around faces.
std::vector<int> valences_of(const Word& word, int valence);
/// The word of a certificate. Throws Rejected unless the theorem covers it and its data are the canonical ones.
Word surface_word_from(const Json& json, int valence);
/// No parameter is irrational.
bool is_rational_word(const Json& word);
/// "(U C P)* where ... at vertices of valence 5"
std::string place_of(const Json& word, int valence);
std::string c1_statement(const Json& word, int valence);
std::string frequency_statement(const Json& word, int valence, int frequency);
std::string multiple_statement(const Json& word, int valence, const Rational& root);
/// Approximate eigenpairs as data.
Json to_json(const ApproximatePair& pair);
ApproximatePair pair_from(const Json& json);

/// Exact characteristic polynomials of the blocks take seconds, not hours.
bool has_small_polynomials(const Patch<Algebraic>& patch, int radius);
/// Whether condition 2 (one simple dominant eigenvalue in frequency 1, all others smaller) fails because `root` is the spectral
/// radius of B_1 and a multiple eigenvalue of it. Exact; false where the polynomials
/// are not small.
bool is_multiple_and_dominant(const Patch<Algebraic>& patch, int radius, const Rational& root);

inline constexpr int largest_proof_valence = 200;
inline constexpr int longest_contraction = 7;  // rounds in the proof of regular parts
inline constexpr int deepest_cell = 10;

}  // namespace udcp
