// Facts about a word at a valence, and the sentences that are proved from them.
#include "proofs/surface_facts.h"

#include <algorithm>

namespace udcp {

template <class S>
LocalFacts<S> local_facts(const Word& word, int valence, int radius) {
  const Reach reach = reach_of_round(word);
  LocalFacts<S> result{patch<S>(word, valence, std::max(radius, reach.high - reach.low + 2)), {}, 0};
  require(reproduces_constants(result.patch), "the rows around the point do not sum to 1");
  require(is_mirror_symmetric(result.patch), "the rows around the point are not mirror symmetric");
  result.enclosed = converted<Interval>(result.patch);
  result.radius = invariant_radius(result.patch);
  const double size = static_cast<double>(result.patch.orbits(result.radius).size());
  require(size * size * size * valence <= 1e7, "the blocks of the subdivision matrix are too large for a proof");
  return result;
}

template <class S>
SurfaceFacts<S> surface_facts(const Word& word, int valence) {
  std::string why;
  const LatticeMask<S> mask = lattice_mask<S>(word);
  std::optional<RegularPart<S>> part = regular_part(mask, word.triangles, &why);
  require(part.has_value(), why);
  const Sectors sectors = sectors_of(word, valence);
  CellSets sets = cell_sets(*part, sectors.dual);
  std::optional<Ring> ring = ring_of(sets);
  require(ring.has_value(), "the mask is too wide for a ring of regular cells");
  const int rows = rows_needed(sectors, sets, *ring);
  SurfaceFacts<S> result{std::move(*part), std::move(sets), std::move(*ring), local_facts<S>(word, valence, rows)};
  require(rows_are_regular(result.local.patch, mask, result.sets, result.ring),
          "rows near the extraordinary point differ from the regular ones on the ring");
  return result;
}

template <class S>
double other_eigenvalues_bound(const LocalFacts<S>& facts, const Eigenpair& pair) {
  const double target = lower_bound(pair.value);
  double result = spectral_radius_bound(deflated(block(facts.enclosed, facts.radius, 1), pair), target);
  for (int m = 0; m <= facts.enclosed.sectors.valence / 2 && result < target; ++m)
    if (m != 1) result = std::max(result, spectral_radius_bound(block(facts.enclosed, facts.radius, m), target));
  return result;
}

template <class S>
bool is_frequency_above(const LocalFacts<S>& facts, int frequency) {
  const double bound = spectral_radius_lower_bound(block(facts.enclosed, facts.radius, frequency));
  return spectral_radius_bound(block(facts.enclosed, facts.radius, 1), bound) < bound;
}

template <class S>
CharacteristicNet characteristic_net(const SurfaceFacts<S>& facts, const Eigenpair& pair) {
  return {facts.local.enclosed, facts.local.radius, pair, net_needed(facts.local.patch.sectors, facts.sets, facts.ring)};
}

std::vector<int> valences_of(const Word& word, int valence) {
  const Sectors sectors = sectors_of(word, valence);
  const int regular = sectors.regular_valence();
  if (sectors.dual || valence == regular) return {regular};
  return {std::min(valence, regular), std::max(valence, regular)};
}

Word surface_word_from(const Json& json, int valence) {
  Word word = word_from(json);
  std::string why;
  require(has_one_split(word, &why), "the word of the certificate: " + why);
  require(is_static(word), "the word of the certificate has parameters that change from round to round");
  require(to_json(word, valences_of(word, valence)) == json,
          "the word of the certificate must list its parameters at the valences that count and no others");
  return word;
}

bool is_rational_word(const Json& word) {
  for (const Json& item : entry(word, "items")) {
    for (const auto& [name, value] : item.items()) {
      if (name == "delta") {
        if (std::any_of(value.begin(), value.end(), [](const Json& v) { return v.is_object(); })) return false;
      } else if (value.is_object()) {
        return false;
      }
    }
  }
  return true;
}

std::string place_of(const Json& word, int valence) {
  const auto& items = entry(word, "items");
  const auto averages = std::count_if(items.begin(), items.end(), [](const Json& item) { return item.at("atom") == "D"; });
  return averages % 2 != 0 ? "at interior faces of " + std::to_string(valence) + " corners"
                           : "at interior vertices of valence " + std::to_string(valence);
}

std::string c1_statement(const Json& word, int valence) {
  return "the limit surfaces of " + describe(word) + " are C^1 " + place_of(word, valence) + " for almost all control nets";
}

std::string frequency_statement(const Json& word, int valence, int frequency) {
  return "the subdivision matrix of " + describe(word) + " " + place_of(word, valence) + " has an eigenvalue of frequency " +
         std::to_string(frequency) + ", other than the 1 of the constants, above all eigenvalues of the frequencies 1 and " +
         std::to_string(valence - 1) + ": the limit surfaces are not C^1 there in general";
}

std::string multiple_statement(const Json& word, int valence, const Rational& root) {
  return "the largest modulus of the eigenvalues of frequency 1 of the subdivision matrix of " + describe(word) + " " +
         place_of(word, valence) + " is " + root.to_string() + ", a multiple eigenvalue: the theorem on C^1 does not apply";
}

Json to_json(const ApproximatePair& pair) { return {{"lambda", to_json(pair.value)}, {"vector", to_json(pair.vector)}}; }

ApproximatePair pair_from(const Json& json) {
  require_entries(json, {"lambda", "vector"}, "eigenpair");
  return {rational_from(json["lambda"], "eigenpair.lambda"), rationals_from(json["vector"], "eigenpair.vector")};
}

namespace {

Points<Interval> companion(const Polynomial<Algebraic>& monic) {
  const Eigen::Index n = monic.degree();
  Points<Interval> result = Points<Interval>::Zero(n, n);
  for (Eigen::Index k = 0; k < n; ++k) {
    if (k + 1 < n) result(k + 1, k) = Interval(1);
    result(k, n - 1) = -number<Interval>(monic.coefficients[static_cast<std::size_t>(k)]);
  }
  return result;
}

}  // namespace

bool has_small_polynomials(const Patch<Algebraic>& patch, int radius) {
  const double size = 2 * static_cast<double>(patch.orbits(radius).size()), degree = std::max(1.0, patch.sectors.valence / 4.0);
  return size * size * size * size * degree * degree <= 5e7;
}

bool is_multiple_and_dominant(const Patch<Algebraic>& patch, int radius, const Rational& root) {
  if (root.sign() <= 0 || !has_small_polynomials(patch, radius)) return false;
  const Polynomial<Algebraic> factor({Algebraic(-root), Algebraic(1)});
  Polynomial<Algebraic> rest = block_polynomial(patch, radius, 1);
  int multiplicity = 0;
  while (rest.degree() > 0 && rest.at(Algebraic(root)).is_zero()) {
    rest = divide(rest, factor).first;
    ++multiplicity;
  }
  return multiplicity >= 2 && Interval::from_double(spectral_radius_bound(companion(rest))) < Interval(root);
}

#define UDCP_INSTANTIATE(S)                                                        \
  template LocalFacts<S> local_facts(const Word&, int, int);                       \
  template SurfaceFacts<S> surface_facts(const Word&, int);                        \
  template double other_eigenvalues_bound(const LocalFacts<S>&, const Eigenpair&); \
  template bool is_frequency_above(const LocalFacts<S>&, int);                     \
  template CharacteristicNet characteristic_net(const SurfaceFacts<S>&, const Eigenpair&);
UDCP_INSTANTIATE(Rational)
UDCP_INSTANTIATE(Algebraic)
#undef UDCP_INSTANTIATE

}  // namespace udcp
