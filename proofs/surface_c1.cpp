// The search: dominant eigenpair in floating point, rounds of contraction, cells of the ring; and what went wrong if it fails.
#include "proofs/surface_c1.h"

#include <algorithm>
#include <chrono>

#include "operators/interrupt.h"
#include "proofs/characteristic_ring.h"
#include "proofs/eigenvalues.h"
#include "proofs/surface_facts.h"

namespace udcp {
namespace {

class Clock {
 public:
  explicit Clock(const SearchLimits& limits) : limits_(limits), begin_(std::chrono::steady_clock::now()) {}
  void check() const {
    throw_if_stopped(limits_.stop);
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begin_;
    require(passed.count() <= limits_.seconds, "the time limit of the search was reached");
  }
  void count_cell() {
    require(++cells_ <= limits_.nodes, "the limit of cells was reached before all of the ring had a positive bound");
    if (cells_ % 64 == 0) check();
  }
  [[nodiscard]] int cells() const { return cells_; }

 private:
  SearchLimits limits_;
  std::chrono::steady_clock::time_point begin_;
  int cells_ = 0;
};

/// The word as the certificate has it, and what else is the same for every proof about it at a valence.
struct Case {
  Json json;
  Word word;
  int valence;
};

Case case_of(const Word& word, int valence) {
  std::string why;
  require(has_one_split(word, &why), why);
  require(is_static(word), "the parameters change from round to round; this proof speaks of words with constant parameters");
  require(valence >= 3 && valence <= largest_proof_valence,
          "proofs cover valences from 3 to " + std::to_string(largest_proof_valence));
  Case result{to_json(static_limit(word), valences_of(word, valence)), {}, valence};
  result.word = word_from(result.json);
  return result;
}

Json data_of(const Case& c) { return {{"word", c.json}, {"valence", c.valence}}; }

Json enclosure(const Interval& x) { return {{"lo", x.lower_decimal(20)}, {"hi", x.upper_decimal(20)}}; }

// ---- Regular part and ring

template <class S>
Json find_contraction(const RegularPart<S>& part, const Clock& clock) {
  for (int rounds = 1; rounds <= longest_contraction; ++rounds) {
    clock.check();
    try {
      const S norm = regular_bound(part, rounds);
      if (norm < S(1)) return {{"rounds", rounds}, {"norm", to_json(norm)}};
    } catch (const Error& error) {
      if (error.kind != ErrorKind::limit) throw;
      break;
    }
  }
  throw Rejected("the difference schemes of the regular part did not contract in " + std::to_string(longest_contraction) +
                 " rounds, so it is not known to be C^1 on regular meshes");
}

void split_until_accepted(const RingTest& test, const RingTest::Cell& cell, int valence, int depth, Clock& clock,
                          std::string& code) {
  clock.count_cell();
  if (test.accepts(cell, valence)) {
    code += '0';
    return;
  }
  require(depth < deepest_cell, "a cell of the characteristic ring has no positive bound of the Jacobian");
  code += '1';
  for (int k = 0; k < 4; ++k) split_until_accepted(test, test.child(cell, k), valence, depth + 1, clock, code);
}

template <class S>
Json find_ring(const SurfaceFacts<S>& facts, const Eigenpair& pair, Clock& clock) {
  const CharacteristicNet net = characteristic_net(facts, pair);
  if (!net.sectors().triangles && is_bicubic(facts.part.mask)) {
    const BernsteinBounds bounds = bernstein_bounds(net);
    if (bounds.jacobian > Interval(0) && bounds.half_plane > Interval(0)) return {{"method", "bernstein"}};
  }
  const std::optional<RingTest> test = RingTest::of(facts.part, facts.sets);
  require(test.has_value(), "the limits over a cell cannot be bounded");
  Json cells = Json::array();
  for (const Place& corner : facts.ring.cells) {
    std::string code;
    split_until_accepted(*test, test->cell(net, corner), net.sectors().valence, 0, clock, code);
    cells.push_back(code);
  }
  return {{"method", "hull"}, {"cells", std::move(cells)}};
}

// ---- Spectrum

/// An eigenvalue of another frequency above everything of frequency 1, as a certificate.
template <class S>
std::optional<Json> find_other_frequency(const Case& c, const LocalFacts<S>& facts, const Clock& clock) {
  for (int m = 0; m <= c.valence / 2; ++m) {
    clock.check();
    if (m == 1 || !is_frequency_above(facts, m)) continue;
    Json data = data_of(c);
    data["frequency"] = m;
    return seal("surface-spectrum", frequency_statement(c.json, c.valence, m), std::move(data));
  }
  return std::nullopt;
}

/// A multiple rational eigenvalue of frequency 1 that is the largest, as a certificate. Looked for in exact numbers, where
/// floating point sees two eigenvalues close together.
std::optional<Json> find_multiple(const Case& c) {
  const LocalFacts<Algebraic> facts = local_facts<Algebraic>(c.word, c.valence);
  const std::vector<std::complex<double>> values = eigenvalues(block(facts.enclosed, facts.radius, 1));
  if (values.size() < 2 || std::abs(values[0] - values[1]) > 1e-4 * std::abs(values[0])) return std::nullopt;
  if (!has_small_polynomials(facts.patch, facts.radius)) return std::nullopt;
  for (const auto& [factor, multiplicity] : square_free_factors(block_polynomial(facts.patch, facts.radius, 1))) {
    if (multiplicity < 2 || factor.degree() != 1) continue;
    const Algebraic root = -factor.coefficients[0] / factor.coefficients[1];
    if (!root.is_rational() || !is_multiple_and_dominant(facts.patch, facts.radius, root.rational())) continue;
    Json data = data_of(c);
    data["multiple"] = to_json(root.rational());
    return seal("surface-spectrum", multiple_statement(c.json, c.valence, root.rational()), std::move(data));
  }
  return std::nullopt;
}

struct Dominant {
  ApproximatePair near;
  Eigenpair pair;
  double others = 0;
};

/// Throws Rejected where condition 2 cannot be certified.
template <class S>
Dominant find_dominant(const LocalFacts<S>& facts, const Clock& clock) {
  const Points<Interval> matrix = block(facts.enclosed, facts.radius, 1);
  const std::optional<ApproximatePair> near = approximate_eigenpair(matrix);
  require(near.has_value(), "frequency 1 has no simple real dominant eigenvalue (numerically)");
  std::optional<Eigenpair> pair = enclose_eigenpair(matrix, *near);
  require(pair.has_value(), "the dominant eigenvalue of frequency 1 cannot be enclosed as a simple one");
  require(pair->value > Interval(0) && pair->value < Interval(1), "the subdominant eigenvalue is not between 0 and 1");
  clock.check();
  const double others = other_eigenvalues_bound(facts, *pair);
  require(Interval::from_double(others) < pair->value, "the other eigenvalues are only bounded by " + to_text(others) +
                                                           ", not below the dominant one of frequency 1, " +
                                                           pair->value.lower_decimal(7));
  return {*near, std::move(*pair), others};
}

/// Why condition 2 fails, if a certificate says so: refuted, or undecided with a certificate.
template <class S>
std::optional<Result> failure_of_spectrum(const Case& c, const LocalFacts<S>& facts, const Clock& clock,
                                          const std::string& claim) {
  if (const std::optional<Json> other = find_other_frequency(c, facts, clock)) {
    Result result = concluded(Verdict::refuted, "", *other);
    if (result.verdict != Verdict::refuted) return result;
    result.reason =
        "condition 2 of the theorem of Reif, Peters and Zorin fails, and the normals do not converge in general: " + result.claim;
    result.witness = {{"valence", c.valence}, {"frequency", (*other)["data"]["frequency"]}};
    result.claim = claim;
    return result;
  }
  clock.check();
  if (const std::optional<Json> multiple = find_multiple(c)) {
    Result result = concluded(Verdict::undecided, "", *multiple);
    result.reason = "condition 2 of the theorem of Reif, Peters and Zorin fails: " + result.claim;
    result.claim = claim;
    return result;
  }
  return std::nullopt;
}

template <class S>
Result refute_spectrum(const Case& c, const SearchLimits& limits) {
  const Clock clock(limits);
  const std::string claim = "condition 2 (a simple dominant eigenvalue in frequency 1) holds for " + describe(c.json) + " " +
                            place_of(c.json, c.valence);
  const LocalFacts<S> facts = local_facts<S>(c.word, c.valence);
  std::optional<Result> failure = failure_of_spectrum(c, facts, clock, claim);
  if (!failure) return undecided(claim, "no failure of condition 2 was found");
  if (failure->certificate) failure->verdict = Verdict::refuted;
  return *failure;
}

template <class S>
Result prove_case(const Case& c, const SearchLimits& limits) {
  Clock clock(limits);
  const std::string claim = c1_statement(c.json, c.valence);
  const LocalFacts<S> local = local_facts<S>(c.word, c.valence);
  std::optional<Dominant> dominant;
  try {
    dominant = find_dominant(local, clock);
  } catch (const Rejected& reason) {
    std::optional<Result> failure = failure_of_spectrum(c, local, clock, claim);
    return failure ? *failure : undecided(claim, reason.what());
  }
  clock.check();
  const SurfaceFacts<S> facts = surface_facts<S>(c.word, c.valence);
  Json data = data_of(c);
  data["regular"] = find_contraction(facts.part, clock);
  data["eigenpair"] = to_json(dominant->near);
  data["ring"] = find_ring(facts, dominant->pair, clock);
  Json details = {{"valence", c.valence},
                  {"lambda", enclosure(dominant->pair.value)},
                  {"others", to_text(dominant->others)},
                  {"invariant_radius", (Rational(facts.local.radius) / Rational(2)).to_string()},
                  {"regular", data["regular"]},
                  {"ring", {{"method", data["ring"]["method"]}, {"first", facts.ring.first}, {"cells", clock.cells()}}}};
  Result result = concluded(Verdict::proved,
                            "by the theorem of Reif, Peters and Zorin: contractive differences on regular meshes, "
                            "certified eigenvalues, and a regular and injective characteristic map",
                            seal("surface-c1", claim, std::move(data)), limits.stop);
  result.details = std::move(details);
  return result;
}

std::string rough_claim(int valence) { return "the limit surfaces are C^1 at points of valence " + std::to_string(valence); }

/// Runs a proof over the smallest exact numbers that hold the word.
template <class Rationals, class Algebraics>
Result over_exact_numbers(const Word& word, int valence, Rationals&& over_rationals, Algebraics&& over_algebraics) {
  const Interval::Precision precision(proof_precision);
  std::optional<Case> c;
  try {
    c = case_of(word, valence);
    return is_rational_word(c->json) ? over_rationals(*c) : over_algebraics(*c);
  } catch (const Rejected& reason) {
    return undecided(c ? c1_statement(c->json, valence) : rough_claim(valence), reason.what());
  } catch (const Error& error) {
    if (error.kind != ErrorKind::limit) throw;
    return undecided(c ? c1_statement(c->json, valence) : rough_claim(valence), error.what());
  }
}

}  // namespace

Result prove_surface_c1(const Word& word, int valence, const SearchLimits& limits) {
  return over_exact_numbers(
      word, valence, [&](const Case& c) { return prove_case<Rational>(c, limits); },
      [&](const Case& c) { return prove_case<Algebraic>(c, limits); });
}

std::vector<Result> prove_surface_c1(const Word& word, const std::vector<int>& valences, const SearchLimits& limits) {
  std::vector<Result> result;
  for (const int n : valences) result.push_back(prove_surface_c1(word, n, limits));
  return result;
}

Result refute_surface_spectrum(const Word& word, int valence, const SearchLimits& limits) {
  return over_exact_numbers(
      word, valence, [&](const Case& c) { return refute_spectrum<Rational>(c, limits); },
      [&](const Case& c) { return refute_spectrum<Algebraic>(c, limits); });
}

}  // namespace udcp
