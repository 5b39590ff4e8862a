// The claims about words: which proof is meant, on curves or at vertices, for one word or over a box of parameters.
#include <algorithm>

#include "interpreter/builtins.h"
#include "interpreter/claims.h"
#include "interpreter/formula.h"
#include "proofs/asymptotic.h"
#include "proofs/circle.h"
#include "proofs/curve_smoothness.h"
#include "proofs/equality.h"
#include "proofs/parameter_box.h"
#include "proofs/surface_c1.h"

namespace udcp {
namespace {

const ClaimDomain& domain_of(const CallContext& context) {
  static const ClaimDomain none;
  return context.domain ? *context.domain : none;
}

/// The valences that the claim speaks of: from `for N in ..` or from N = 5 among its arguments.
std::vector<int> valences_of(const CallContext& context, const Arguments& a) {
  if (!a.find("N")) return domain_of(context).valences;
  const Value& n = *a.find("N");
  std::vector<int> valences;
  if (const auto* list = n.as<ListValue>()) {
    for (const Value& item : list->items) valences.push_back(whole_number(item, "the valence N", 3, 1000));
  } else {
    valences.push_back(whole_number(n, "the valence N", 3, 1000));
  }
  return valences;
}

}  // namespace

Word with_parameters(Word word, const ClaimDomain& domain) {
  std::map<std::string, KernelPtr> kernels;
  for (const ParameterRange& range : domain.box) kernels[range.name] = symbol(range.name);
  for (const auto& [name, value] : domain.fixed) kernels[name] = constant(value);
  for (const auto& [name, kernel] : kernels) {
    const auto fill = [&, &parameter = name, &variable = kernel](KernelPtr& slot) {
      if (slot) return;
      slot = variable;
      domain.filled.insert(parameter);
    };
    for (std::vector<Item>* items : {&word.head, &word.tail}) {
      for (Item& item : *items) {
        if (name == "f" && (item.atom == Atom::average || item.atom == Atom::convolve)) {
          for (KernelPtr* slot : {&item.f.plain, &item.f.latitude, &item.f.longitude}) fill(*slot);
        }
        if (item.atom != Atom::push_back) continue;
        if (name == "omega") {
          for (KernelPtr* slot : {&item.omega.plain, &item.omega.latitude, &item.omega.longitude}) fill(*slot);
        }
        if (name == "delta") fill(item.delta);
      }
    }
  }
  return word;
}

std::string not_on_meshes(const Word& word) {
  if (!word.head.empty()) return "claims about meshes speak of the repeated part of a word; leave the prefix away";
  if (word.rings != Rings::off) return "rings are not covered: claims about meshes speak of untagged edges";
  const auto directed = [](const Directional<KernelPtr>& k) { return k.latitude != k.plain || k.longitude != k.plain; };
  for (const Item& item : word.tail) {
    if (directed(item.f) || directed(item.omega))
      return "parameters by direction are not covered: claims about meshes speak of untagged edges";
  }
  return directed(word.alpha0) ? "alpha0 by direction is not covered: claims about meshes speak of untagged edges" : "";
}

namespace {

Word scheme_of(const CallContext& context, const Arguments& a, std::size_t position) {
  const WordValue& value = need_word(a, position);
  if (!value.word.is_scheme() || value.rounds)
    throw Error(ErrorKind::word, "E_NOT_A_SCHEME", "a claim about limits needs a word that repeats for ever, but this one ends",
                "write (UCP)*");
  return with_parameters(value.word, domain_of(context));
}

std::string smoothness_text(int k) { return k == 0 ? "the scheme converges" : "the limits are C^" + std::to_string(k); }

/// The rounds before alpha is small must exist too.
std::string missing_round(const Word& word, const Rational& range) {
  for (int h = 0; h < 60; ++h) {
    try {
      (void)mask<Interval>(word, h);
    } catch (const Error& error) {
      if (error.kind == ErrorKind::interrupted) throw;
      return "round " + std::to_string(h) + " does not exist: " + error.what();
    }
    const Interval alpha = word.alpha0.plain->at(Context<Interval>{{}, 4, 0, -1, nullptr}).value();
    Rational divisor(1);
    for (int k = 0; k < h; ++k) divisor *= Rational(arity(word));
    if (abs(alpha).upper() / divisor <= range) return {};
  }
  return "alpha0 is too large";
}

Result semi_stationary(const Word& word, int k, const Result& static_part) {
  Result result = prove_asymptotic(word, k, static_part);
  if (result.verdict != Verdict::proved) return result;
  const Interval alpha = word.alpha0.plain->at(Context<Interval>{{}, 4, 0, -1, nullptr}).value();
  if (!(alpha >= Interval(0))) return undecided(result.claim, "eq. (11) is shown for alpha0 >= 0 only");
  const std::string missing = missing_round(word, rational_from(result.details["alpha_max"], "alpha_max"));
  return missing.empty() ? result : undecided(result.claim, missing);
}

/// What speaks for and against at points of the domain; numbers of a short search, no proof.
Result evidence_on_curves(const Word& word, int k, const ParameterBox& box, const SearchLimits& limits) {
  Result evidence;
  evidence.evidence = true;
  evidence.claim = smoothness_text(k);
  evidence.verdict = Verdict::proved;
  SearchLimits brief = limits;
  brief.seconds = 0.5;
  const int points = box.empty() ? 1 : 20;
  for (int i = 0; i < points; ++i) {
    std::map<std::string, Rational> values;
    Json at = Json::object();
    for (std::size_t v = 0; v < box.size(); ++v) {  // a sequence that fills the box evenly
      const Side side = finite_side(box[v]);
      const Rational share = Rational((i * static_cast<int>(2 * v + 7)) % points * 2 + 1) / Rational(2 * points);
      values[box[v].name] = from_finite(box[v], side.lower + share * (side.upper - side.lower));
      at[box[v].name] = to_json(values[box[v].name]);
    }
    const Result here = prove_smooth(box.empty() ? word : at_point(word, values), k, brief);
    if (here.verdict == Verdict::proved) continue;
    evidence.verdict = here.verdict;
    evidence.reason = here.reason;
    evidence.witness = {{"parameters", at}, {"found", here.witness}};
    if (here.verdict == Verdict::refuted) break;
  }
  if (evidence.verdict == Verdict::proved)
    evidence.reason = box.empty() ? "a short search found a contraction; prove writes the certificate"
                                  : "holds at " + std::to_string(points) + " points of the domain; prove covers all of it";
  return evidence;
}

Result smooth_on_curves(const Word& word, int k, const CallContext& context) {
  const ClaimDomain& domain = domain_of(context);
  validate_for_curve(word);
  const Word fixed = static_limit(word);
  if (domain.evidence_only) return evidence_on_curves(fixed, k, domain.box, search_limits(context));
  const bool stationary = is_static(word) || !word.alpha0.plain;
  if (!domain.box.empty()) {
    if (!stationary)
      return undecided(smoothness_text(k),
                       "parameters and functions of alpha together are not decided; give the parameters values");
    return prove_smooth_on_box(fixed, k, domain.box, search_limits(context));
  }
  Result static_part = prove_smooth(fixed, k, search_limits(context));
  return stationary ? static_part : semi_stationary(word, k, static_part);
}

Result smooth_at_vertices(const Word& word, int k, const std::vector<int>& valences, const CallContext& context) {
  const std::string claim = smoothness_text(k) + " at extraordinary vertices";
  if (const std::string why = not_on_meshes(word); !why.empty()) return undecided(claim, why);
  if (k != 1) return undecided(claim, "on surfaces only C^1 at extraordinary vertices is decided; write c1(w)");
  if (valences.empty()) return undecided(claim, "a claim about surfaces needs valences; write for N in 3 .. 20");
  if (!domain_of(context).box.empty())
    return undecided(claim, "parameters that run over intervals are decided on curves only; give them values");
  const Word fixed = static_limit(word);
  if (!is_static(word) && word.alpha0.plain)
    return undecided(claim, "for words with functions of alpha only the static limit is decided on surfaces: write alpha0 = 0");
  std::vector<Result> results;
  for (const int n : valences) results.push_back(prove_surface_c1(fixed, n, search_limits(context)));
  Result all = all_of(std::move(results));
  if (domain_of(context).evidence_only) all.evidence = true;
  return all;
}

Value claim_smooth(CallContext& context, const Arguments& a, std::size_t position, int k) {
  const Word word = scheme_of(context, a, position);
  const std::vector<int> valences = valences_of(context, a);
  if (word.triangles || !valences.empty()) return claim_value(smooth_at_vertices(word, k, valences, context));
  return claim_value(smooth_on_curves(word, k, context));
}

}  // namespace

Value claim_converges(CallContext& context, const Arguments& a) { return claim_smooth(context, a, 0, 0); }
Value claim_c1(CallContext& context, const Arguments& a) { return claim_smooth(context, a, 0, 1); }

/// c(w, k) and c(k, w)
Value claim_c(CallContext& context, const Arguments& a) {
  const bool word_first = a.positional.at(0).as<WordValue>() != nullptr;
  const int k = need_whole(a, word_first ? 1 : 0, "k", 0, 20);
  return claim_smooth(context, a, word_first ? 0 : 1, k);
}

namespace {

/// With functions of alpha: equal for all values of the functions is equal; a round with certainly different masks is different.
Result equal_functions(const Word& first, const Word& second, const std::vector<int>& valences) {
  if (!same_kernel(first.alpha0.plain, second.alpha0.plain, 0))
    return undecided("the words are the same operator", "they start with different alpha0, which is not compared");
  try {
    Result symbolic = prove_equal(with_symbols(first), with_symbols(second), valences);
    if (symbolic.verdict == Verdict::proved) return symbolic;
  } catch (const Error& error) {
    if (error.kind != ErrorKind::not_exact) throw;
  }
  Result result = undecided("the words are the same operator",
                            "their weights differ as functions of f, omega and delta, but may agree for these");
  const auto a = mask<Interval>(first), b = mask<Interval>(second);
  bool differ = a.arity == b.arity && a.coefficients.size() == b.coefficients.size() && a.first != b.first;
  for (std::size_t k = 0; a.arity == b.arity && a.first == b.first && k < std::min(a.coefficients.size(), b.coefficients.size());
       ++k)
    differ = differ || a.coefficients[k] != b.coefficients[k];
  if (differ) {
    result.verdict = Verdict::refuted;
    result.reason = "the masks of round 0 differ, in enclosures";
    result.witness = {{"round", 0}};
  }
  return result;
}

}  // namespace

Value claim_equal(CallContext& context, const Arguments& a) {
  const Word first = scheme_of(context, a, 0), second = scheme_of(context, a, 1);
  std::vector<int> valences = valences_of(context, a);
  if (valences.empty() && (first.triangles || second.triangles)) valences = {3, 4, 5, 6, 7};
  for (const Word* word : {&first, &second}) {
    const std::string why =
        valences.empty() ? (word->head.empty() ? "" : "only the repeated parts of words are compared; leave the prefixes away")
                         : not_on_meshes(*word);
    if (!why.empty()) return claim_value(undecided("the words are the same operator", why));
  }
  for (const ParameterRange& range : domain_of(context).box) {
    if (range.lower && range.upper && *range.lower == *range.upper)
      return claim_value(undecided("the words are the same operator",
                                   "the domain of '" + range.name + "' is a point; write its value into the words"));
  }
  const auto stationary = [](const Word& word) { return is_static(word) || !word.alpha0.plain; };
  if (!stationary(first) || !stationary(second)) return claim_value(equal_functions(first, second, valences));
  return claim_value(prove_equal(static_limit(first), static_limit(second), valences));
}

/// circle(w), circle(w, N = corners)
Value claim_circle(CallContext& context, const Arguments& a) {
  const Word word = scheme_of(context, a, 0);
  if (!word.head.empty())
    return claim_value(
        undecided("regular polygons become circles", "the claim speaks of the repeated part of a word; leave the prefix away"));
  return claim_value(prove_circle(word));
}

}  // namespace udcp
