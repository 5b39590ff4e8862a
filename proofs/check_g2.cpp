// Checkers of fills: every exact computation once more, from the word and the functions that make the running masks.
#include "operators/interrupt.h"
#include "operators/methods/filling/fill_mask.h"
#include "proofs/checkers.h"
#include "proofs/fill_facts.h"
#include "proofs/spectrum.h"

namespace udcp {
namespace {

/// The masks that run are those of the fairest choice up to the bound.
void check_running_mask(int valence, const Rational& bound, StopFlag stop) {
  const Points<double> running = make_fill_mask(valence).weights;
  const Points<Algebraic> exact = exact_fill_mask(valence, stop);
  const Interval allowed(bound);
  for (Eigen::Index k = 0; k < exact.size(); ++k)
    require(abs(Interval::from_double(running.data()[k]) - exact.data()[k].enclosure()) <= allowed,
            "a weight of the running mask differs from the exact one by more than mask_error");
}

int valence_from(const Json& data) { return integer_from(data["valence"], 3, largest_exact_fill, "valence"); }

}  // namespace

std::string check_g2_fill(const Json& data, StopFlag stop) {
  require_entries(data, {"word", "valence", "ranks", "mask_error"}, "data");
  const Interval::Precision precision(proof_precision);
  const int valence = valence_from(data);
  require_bicubic_ring(data["word"], valence);
  const OuterSeries series = outer_series(valence);
  const Points<Algebraic> weights = weights_of(series);
  require(weights == outer_weights(outer_traces(outer_map<Algebraic>(Algebraic::cosine(Rational(2) / Rational(valence))))),
          "the weights of the running masks are not those of the outer map");
  require(is_regular_outside(series), "the outer map is not regular on the boundary");
  const std::string outer = outer_residual(series, weights);
  require(outer.empty(), outer);
  require(contradiction(valence, Print::none).empty(), "the flat surface does not meet (2)");
  require(conditions_mean_g2(valence), "the conditions of the joins do not say G2");
  const Json& ranks = data["ranks"];
  require(ranks.is_array() && static_cast<int>(ranks.size()) == valence / 2 + 1,
          "ranks must have an entry per frequency 0 .. n/2");
  for (int f = 0; 2 * f <= valence; ++f) {
    throw_if_stopped(stop);
    const std::string where = " at frequency " + std::to_string(f);
    const FrequencyFacts facts = frequency_facts(valence, f, weights);
    require(facts.rank == integer_from(ranks[static_cast<std::size_t>(f)], 0, 25, "ranks"),
            "the rank is not that of ranks" + where);
    require(facts.consistent, "the equations of the joins contradict each other" + where);
    require(facts.residuals_vanish, "a solution does not meet the joins as polynomials" + where);
    require(facts.fairness_decides, "the fairness leaves a choice" + where);
  }
  const Rational bound = rational_from(data["mask_error"], "mask_error");
  require(bound.sign() > 0 && bound < Rational(1), "mask_error must be between 0 and 1");
  check_running_mask(valence, bound, stop);
  return g2_statement(data["word"], valence, bound);
}

std::string check_g2_print(const Json& data, StopFlag) {
  require_entries(data, {"valence", "print"}, "data");
  const int valence = valence_from(data);
  require(data["print"].is_string(), "print must be a name");
  const std::optional<Print> print = print_named(data["print"].get<std::string>());
  require(print.has_value(), "print is no formula that was printed otherwise");
  const std::string failure = print_failure(valence, *print);
  require(!failure.empty(), "the printed formula is right at this valence");
  return print_statement(valence, *print, failure);
}

}  // namespace udcp
