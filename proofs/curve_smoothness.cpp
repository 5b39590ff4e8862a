// Proofs of smoothness of curves, cheapest first: sum rules, contraction, joint spectral radius.
#include "proofs/curve_smoothness.h"

#include "proofs/checkers.h"
#include "proofs/joint_spectral_radius.h"
#include "proofs/static_word.h"

namespace udcp {
namespace {

constexpr std::int64_t most_entries = 50'000;  // of transition matrices, as in the checker

std::string claim_of(const Json& word, int k) {
  return describe(word) + (k == 0 ? " converges on curves" : " is C^" + std::to_string(k) + " on curves");
}

/// The certificate with the statement that its checker derives.
Result conclude(Verdict verdict, const char* kind, const std::string& claim, const std::string& reason, Json data) {
  try {
    for (const Checker& checker : checkers()) {
      if (checker.kind != kind) continue;
      const std::string statement = checker.check(data, nullptr);
      return concluded(verdict, reason, seal(kind, statement, std::move(data)));
    }
  } catch (const Rejected& complaint) {
    return undecided(claim, std::string("the certificate did not pass its checker: ") + complaint.what());
  }
  return undecided(claim, "there is no checker for this kind of certificate");
}

/// The tail of the word without what means nothing on curves.
Word curve_word(const Word& word) {
  Word result = static_limit(word);
  for (Item& item : result.tail) {
    item.ngon = Ngon::dual;
    item.omega_face = nullptr;
  }
  return result;
}

/// Hands the word as JSON and its mask to the function, or says why there is none.
template <class Decide>
Result with_mask(const Word& word, const std::string& claim, Decide decide) {
  if (!is_static(word)) {
    validate_for_curve(word);
    return undecided(
        claim, "the parameters of the word change from round to round; this proof is for constant ones, as its static limit has");
  }
  const Word curve = curve_word(word);
  validate_for_curve(curve);
  try {
    const Json json = to_json(curve, {4});
    return std::visit([&](const auto& mask) { return decide(mask, json); }, exact_mask(curve));
  } catch (const Error& error) {
    if (error.kind != ErrorKind::not_exact && error.code != "E_F_BY_VALENCE") throw;
    return undecided(claim, std::string("a proof needs exact parameters: ") + error.what());
  }
}

Result smooth(const Json& word, int k, int order, Json bound, const std::string& reason) {
  Json details = {{"order", order}};
  for (const char* name : {"length", "value", "bound"})
    if (bound.contains(name)) details[name] = bound[name];
  Result result = conclude(Verdict::proved, "curve-smoothness", claim_of(word, k), reason,
                           {{"word", word}, {"smoothness", k}, {"order", order}, {"bound", std::move(bound)}});
  result.details = std::move(details);
  return result;
}

Result not_smooth(const Json& word, int k, Json reason, const std::string& text) {
  return conclude(Verdict::refuted, "curve-refutation", claim_of(word, k), text,
                  {{"word", word}, {"smoothness", k}, {"reason", std::move(reason)}});
}

template <class S>
std::optional<Result> by_contraction(const Mask<S>& mask, const Json& word, int k, int longest, Budget& budget) {
  const auto found = contraction(mask, k, longest, budget);
  if (!found) return std::nullopt;
  const std::string rounds = found->length == 1 ? "one round" : std::to_string(found->length) + " rounds";
  return smooth(word, k, k + 1, {{"kind", "norm"}, {"length", found->length}, {"value", to_json(found->value)}},
                "the scheme of differences of order " + std::to_string(k + 1) + ", times " + std::to_string(mask.arity) + "^" +
                    std::to_string(k) + " per round, contracts by " + to_text(found->value) + " in " + rounds);
}

template <class S>
std::optional<Result> by_product(const std::vector<Points<S>>& matrices, const LeadingProducts& leading, const Json& word, int k,
                                 int order, const S& target) {
  for (const std::vector<int>& letters : leading.words) {
    if (!product_reaches(matrices, letters, target)) continue;
    std::string text = "a product of transition matrices has an eigenvalue of modulus ";
    text += to_text(target) + (letters.size() == 1 ? "" : "^" + std::to_string(letters.size())) + " or more";
    return not_smooth(word, k, {{"kind", "product"}, {"order", order}, {"product", letters}}, text);
  }
  return std::nullopt;
}

template <class S>
std::optional<Result> by_polytope(const std::vector<Points<S>>& matrices, const LeadingProducts& leading, const Json& word, int k,
                                  int order, const Rational& target, Budget& budget) {
  const Rational rate = Rational::from_double(leading.rate), unit(1'000'000'000'000LL);
  for (const int tenths : {9, 5, 2}) {  // of the way from the rate to the target: the farther, the fewer vectors
    Rational bound = ((rate + (target - rate) * Rational(tenths) / Rational(10)) * unit).floor() / unit;
    for (Rational coarse(10); coarse < unit; coarse *= Rational(10)) {  // as few digits as will do
      const Rational shorter = (bound * coarse).floor() / coarse;
      if (shorter - rate < (target - rate) / Rational(10)) continue;
      bound = shorter;
      break;
    }
    if (auto polytope = find_polytope(matrices, bound, leading, budget))
      return smooth(word, k, order, to_json(*polytope),
                    "the joint spectral radius of the differences of order " + std::to_string(order) + " is at most " +
                        bound.to_string() + ", below " + target.to_string() + ", by a polytope with " +
                        std::to_string(2 * polytope->vectors.size()) + " corners");
  }
  return std::nullopt;
}

/// By bounds of the joint spectral radius of the differences of full order: at least 1 refutes convergence; C^k needs it below
/// A^-k.
template <class S>
Result by_radius(const Mask<S>& mask, const Json& word, int k, int order, bool stable, Budget& budget) {
  const std::string claim = claim_of(word, k);
  const Mask<S> differences = difference_mask(mask, order);
  if (order == 0 || transition_size(differences) > most_entries)
    return undecided(claim, "the transition matrices are too large for a search");
  const std::vector<Points<S>> matrices = transition_matrices(differences);
  const LeadingProducts leading = leading_products(matrices, budget);
  if (leading.rate > 1 - 1e-9)
    if (auto refuted = by_product(matrices, leading, word, k, order, S(1))) return std::move(*refuted);
  if (order <= k) return undecided(claim, "the mask has only " + std::to_string(order) + " sum rules");
  const Rational target = pow(Rational(1) / Rational(mask.arity), k);
  if (leading.rate < target.to_double() * (1 - 1e-9)) {
    if (auto proof = by_polytope(matrices, leading, word, k, order, target, budget)) return std::move(*proof);
    return undecided(claim, "no polytope was found within the limits of the search; more time or nodes may help");
  }
  if (k > 0 && !stable)
    return undecided(
        claim, "the difference schemes do not contract, but the shifts are not known to be stable, so this refutes nothing");
  if (auto refuted = by_product(matrices, leading, word, k, order, S(target))) return std::move(*refuted);
  return undecided(
      claim, "the joint spectral radius is too close to " + target.to_string() + " for this search, or too costly to bound");
}

template <class S>
Result decide_smooth(const Mask<S>& mask, const Json& word, int k, Budget& budget) {
  if (auto proof = by_contraction(mask, word, k, mask.arity == 2 ? 6 : 3, budget)) return std::move(*proof);
  const int order = sum_rules(mask);
  const bool stable = stability(mask) == Stability::stable;
  Result result = by_radius(mask, word, k, order, stable, budget);
  if (result.verdict != Verdict::undecided) return result;
  if (order > k) {
    if (auto proof = by_contraction(mask, word, k, 14, budget)) return std::move(*proof);
    return result;
  }
  const std::string count = "C^" + std::to_string(k) + " of a stable scheme needs " + std::to_string(k + 1) +
                            " sum rules; the mask has " + std::to_string(order);
  if (stable) return not_smooth(word, k, {{"kind", "sum rules"}}, count);
  result.reason = count + ", but its shifts are not known to be stable, so this refutes nothing";
  return result;
}

/// -log_A of a radius.
template <class S>
Interval exponent(int arity, const S& radius) {
  return -log(number<Interval>(radius)) / log(Interval(arity));
}

template <class S>
Result decide_holder(const Mask<S>& mask, const Json& word, bool whole, Budget& budget, Regularity& answer) {
  const std::string claim = describe(word) + " has a positive Hoelder exponent on curves";
  const int order = sum_rules(mask);
  const Mask<S> differences = difference_mask(mask, order);
  const auto radius = joint_spectral_radius(differences, budget);
  if (!(radius.upper.value < S(1))) {
    if (radius.lower.value < S(1) || !whole)
      return undecided(claim, "no bound of the joint spectral radius below 1 was found, so the scheme may not even converge");
    return decide_smooth(mask, word, 0, budget);
  }
  const bool stable = stability(mask) == Stability::stable, above = whole && stable && radius.lower.value.sign() > 0;
  Json upper, lower = nullptr;
  if (radius.upper.polytope) {
    upper = to_json(*radius.upper.polytope);
  } else {
    const S value = norm(iterated(differences, radius.upper.length));
    upper = {
        {"kind", "norm"}, {"length", radius.upper.length}, {"value", to_json(value)}, {"bound", to_json(radius.upper.value)}};
  }
  if (above) lower = {{"product", radius.lower.product}, {"value", to_json(radius.lower.value)}};
  Result result =
      conclude(Verdict::proved, "curve-regularity", claim,
               "the joint spectral radius of the differences of order " + std::to_string(order) + " is " +
                   (radius.exact() ? to_text(radius.upper.value) : "bounded by a product and by a polytope or a norm"),
               {{"word", word}, {"upper", upper}, {"lower", lower}});
  if (result.verdict != Verdict::proved) return result;
  answer.at_least = exponent(mask.arity, radius.upper.value);
  if (above) answer.at_most = exponent(mask.arity, radius.lower.value);
  if (above && radius.exact()) answer.exact = exponent_text(mask.arity, radius.upper.value);
  for (S scaled = radius.upper.value; scaled < S(1); scaled *= S(mask.arity)) ++answer.smoothness;
  result.details = {{"sum_rules", order}, {"stable", stable}, {"smoothness", answer.smoothness}};
  result.details["exponent"] = {{"lo", answer.at_least.lower_decimal(17)}, {"hi", nullptr}};
  if (answer.at_most) result.details["exponent"]["hi"] = answer.at_most->upper_decimal(17);
  if (!answer.exact.empty()) result.details["exact"] = answer.exact;
  return result;
}

std::string plain_claim(const Word& word, const std::string& what) { return "(" + atoms(word, 1) + ")* " + what + " on curves"; }

}  // namespace

template <class S>
std::optional<Contraction<S>> contraction(const Mask<S>& mask, int k, int longest, Budget& budget) {
  if (sum_rules(mask) <= k) return std::nullopt;
  const Mask<S> differences = difference_mask(mask, k + 1);
  const S factor = S(pow(Rational(mask.arity), k));
  Mask<S> rounds{1, 0, Rational(0), {S(1)}};
  S scale(1);
  for (int length = 1; length <= longest; ++length) {
    const std::size_t size =
        rounds.coefficients.size() + differences.coefficients.size() * static_cast<std::size_t>(rounds.arity);
    if ((length > 1 && size > 20'000) || !budget.spend(length)) return std::nullopt;
    rounds = iterated(differences, length);
    scale *= factor;
    const S value = scale * norm(rounds);
    if (value < S(1)) return Contraction<S>{length, value};
  }
  return std::nullopt;
}

Result prove_smooth(const Word& word, int k, const SearchLimits& limits) {
  if (k < 0 || k > 1000)
    throw Error(ErrorKind::input, "E_ARGUMENTS", "smoothness C^k needs k from 0 to 1000, not " + std::to_string(k));
  Budget budget(limits);
  const std::string claim = plain_claim(word, k == 0 ? "converges" : "is C^" + std::to_string(k));
  Result result =
      with_mask(word, claim, [&](const auto& mask, const Json& json) { return decide_smooth(mask, json, k, budget); });
  if (result.verdict != Verdict::refuted || word.head.empty()) return result;
  Result open = undecided(result.claim,
                          "the rounds alone fail, as " + result.reason + "; behind the head of the word this refutes nothing");
  open.witness = std::move(result.witness);
  return open;
}

Result prove_converges(const Word& word, const SearchLimits& limits) { return prove_smooth(word, 0, limits); }

Regularity holder(const Word& word, const SearchLimits& limits) {
  Budget budget(limits);
  Regularity answer;
  const bool whole = word.head.empty();
  const auto decide = [&](const auto& mask, const Json& json) { return decide_holder(mask, json, whole, budget, answer); };
  answer.result = with_mask(word, plain_claim(word, "has a positive Hoelder exponent"), decide);
  return answer;
}

LimitStencils limit_stencils(const Word& word, const SearchLimits& limits) {
  LimitStencils result;
  const auto algebraic = [](const auto& stencil) -> std::optional<Stencil<Algebraic>> {
    if (!stencil) return std::nullopt;
    return Stencil<Algebraic>{stencil->first, {stencil->weights.begin(), stencil->weights.end()}};
  };
  Budget budget(limits);
  (void)with_mask(word, "", [&](const auto& mask, const Json& json) {
    if (decide_smooth(mask, json, 0, budget).verdict != Verdict::proved) return Result();
    result.position = algebraic(position_stencil(mask));
    auto tangent = tangent_stencil(mask);
    if (tangent && decide_smooth(mask, json, 1, budget).verdict == Verdict::proved) result.tangent = algebraic(tangent);
    return Result();
  });
  return result;
}

template std::optional<Contraction<Rational>> contraction(const Mask<Rational>&, int, int, Budget&);
template std::optional<Contraction<Algebraic>> contraction(const Mask<Algebraic>&, int, int, Budget&);

}  // namespace udcp
