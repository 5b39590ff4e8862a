// Certificates of fills: the ranks that floating point sees, for the checker to confirm.
#include "proofs/g2_fill.h"

#include "operators/interrupt.h"
#include "proofs/static_word.h"
#include "proofs/surface_facts.h"

namespace udcp {
namespace {

void check_valence(int valence) {
  if (valence < 3 || valence > largest_exact_fill)
    throw Error(
        ErrorKind::limit, "E_FILL_VALENCE",
        "exact fills are made for valences 3 to " + std::to_string(largest_exact_fill) + ", not " + std::to_string(valence), "");
}

}  // namespace

Result prove_g2(const Word& word, int valence, const SearchLimits& limits) {
  check_valence(valence);
  throw_if_stopped(limits.stop);
  const Interval::Precision precision(proof_precision);
  const std::string claim = "the fill of valence " + std::to_string(valence) + " joins with G2";
  Json json;
  try {
    const Word still = static_limit(word);
    json = to_json(still, valences_of(still, valence));
    require_bicubic_ring(json, valence);
  } catch (const Error& error) {
    if (error.kind == ErrorKind::interrupted) throw;
    return undecided(claim, error.what());
  } catch (const Rejected& reason) {
    return undecided(claim, reason.what());
  }
  const Rational mask_error = Rational::parse("1e-12");
  const std::string statement = g2_statement(json, valence, mask_error);
  Json ranks = Json::array();
  for (int f = 0; 2 * f <= valence; ++f) ranks.push_back(fill_rank(valence, f));
  Result result = concluded(
      Verdict::proved,
      "exactly: the equations of the joins are consistent at every frequency, their solutions meet them as "
      "polynomials, and so do the points that the ring fixes",
      seal("g2-fill", statement, {{"word", json}, {"valence", valence}, {"ranks", ranks}, {"mask_error", to_json(mask_error)}}));
  result.claim = statement;
  if (result.verdict == Verdict::proved) {
    int rank = 0;
    for (int f = 0; f < valence; ++f) rank += fill_rank(valence, f);
    result.details = {{"valence", valence}, {"ranks", ranks}, {"freedom", 25 * valence - rank}};
  }
  return result;
}

Result prove_g2_as_printed(int valence, Print print, const SearchLimits& limits) {
  check_valence(valence);
  throw_if_stopped(limits.stop);
  const std::string claim =
      "the fill of valence " + std::to_string(valence) + " joins with G2 with " + to_string(print) + " as printed";
  const std::string failure = print_failure(valence, print);
  if (failure.empty()) return undecided(claim, "the printed formula and the corrected one agree at this valence");
  Result result =
      concluded(Verdict::refuted, failure,
                seal("g2-print", print_statement(valence, print, failure), {{"valence", valence}, {"print", to_string(print)}}));
  result.claim = claim;
  result.witness = {{"valence", valence}, {"print", to_string(print)}, {"failure", failure}};
  return result;
}

}  // namespace udcp
