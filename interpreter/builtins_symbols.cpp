// What the symbol of a static word says: sum rules, polynomials, limit stencils, norms, stability; and circles and kernels near
// alpha = 0. Exact, from proofs/symbol.h; nothing is decided about limits here.
#include "interpreter/analysis.h"
#include "interpreter/arguments.h"
#include "interpreter/claims.h"
#include "interpreter/report.h"
#include "proofs/asymptotic.h"
#include "proofs/circle.h"
#include "proofs/static_word.h"
#include "proofs/symbol.h"

namespace udcp {
namespace {

Word static_word(const Arguments& a) {
  const WordValue& value = need_word(a, 0);
  if (!value.word.is_scheme() || value.rounds)
    throw Error(ErrorKind::word, "E_NOT_A_SCHEME", "this speaks of a word that repeats for ever, but the word ends",
                "write (UCP)*");
  validate_for_curve(value.word);
  return static_limit(value.word);
}

Value number_text(const Rational& value) { return number_of(Algebraic(value)); }
Value number_text(const Algebraic& value) { return number_of(value); }

template <class S>
std::vector<Value> weights_of(const std::vector<S>& numbers) {
  std::vector<Value> values;
  for (const S& n : numbers) values.push_back(number_text(n));
  return values;
}

Json json_of(const std::vector<Value>& values) {
  Json json = Json::array();
  for (const Value& v : values) json.push_back(to_json(v)["value"]);
  return json;
}

Value show_sum_rules(CallContext&, const Arguments& a) {
  return std::visit([](const auto& m) { return whole_value(sum_rules(m)); }, exact_mask(static_word(a)));
}

/// The degree of polynomials in the space of limits: one less than the number of sum rules.
Value show_generation(CallContext&, const Arguments& a) {
  return std::visit([](const auto& m) { return whole_value(sum_rules(m) - 1); }, exact_mask(static_word(a)));
}

Value show_reproduction(CallContext&, const Arguments& a) {
  return std::visit([](const auto& m) { return whole_value(reproduction_degree(m)); }, exact_mask(static_word(a)));
}

Value show_shift(CallContext&, const Arguments& a) {
  return std::visit([](const auto& m) { return number_text(parameter_shift(m)); }, exact_mask(static_word(a)));
}

Value show_stability(CallContext&, const Arguments& a) {
  return std::visit(
      [](const auto& m) {
        const Stability s = stability(m);
        return Value{TextValue{s == Stability::stable ? "stable" : s == Stability::unstable ? "unstable" : "unknown"}};
      },
      exact_mask(static_word(a)));
}

/// The mask of the scheme of k-th differences.
Value show_difference(CallContext&, const Arguments& a) {
  const Word word = static_word(a);
  const int k = whole_or(a, 1, "k", 1, 0, 1000);
  return std::visit(
      [&](const auto& m) {
        if (k > sum_rules(m))
          throw Error(ErrorKind::word, "E_SUM_RULES",
                      "there is no scheme for differences of order " + std::to_string(k) +
                          ": the mask satisfies sum rules of order " + std::to_string(sum_rules(m)),
                      "sum_rules(word) is the largest order");
        const auto d = difference_mask(m, k);
        ReportValue report;
        report.parts = weights_of(d.coefficients);
        report.text =
            to_text(Value{ListValue{report.parts}}) + "  from offset " + std::to_string(d.first) + ", norm " + to_text(norm(d));
        report.json = Json{{"kind", "mask"},
                           {"arity", d.arity},
                           {"first", d.first},
                           {"norm", to_text(norm(d))},
                           {"coefficients", json_of(report.parts)}};
        return Value{std::move(report)};
      },
      exact_mask(word));
}

/// The position stencil, or with derivative = 1 the tangent stencil, at an old point.
Value show_limit_stencil(CallContext&, const Arguments& a) {
  const Word word = static_word(a);
  const bool tangent = whole_or(a, 1, "derivative", 0, 0, 1) == 1;
  return std::visit(
      [&](const auto& m) {
        const auto stencil = tangent ? tangent_stencil(m) : position_stencil(m);
        if (!stencil)
          throw Error(ErrorKind::word, "E_NO_STENCIL",
                      std::string("the word has no ") + (tangent ? "tangent" : "limit") +
                          " stencil: its mask is not symmetric about an old point, or the eigenvalue " +
                          (tangent ? "1/arity" : "1") + " is not simple",
                      "primal words (an even number of D) with a symmetric mask have one where they converge");
        ReportValue report;
        report.parts = weights_of(stencil->weights);
        report.text = to_text(Value{ListValue{report.parts}}) + "  from point " + std::to_string(stencil->first);
        report.json = Json{{"kind", "stencil"}, {"first", stencil->first}, {"weights", json_of(report.parts)}};
        return Value{std::move(report)};
      },
      exact_mask(word));
}

Value show_asymptotic(CallContext&, const Arguments& a) {
  const WordValue& value = need_word(a, 0);
  (void)static_word(a);
  Word tail;
  tail.tail = value.word.tail;
  const AsymptoticBounds bounds = asymptotic_bounds(tail);
  const std::string gamma = "1/" + std::to_string(bounds.flat ? bounds.arity * bounds.arity : bounds.arity);
  const std::string c =
      bounds.flat ? (bounds.second / Rational(2)).to_string() + "*alpha0^2" : bounds.first.to_string() + "*alpha0";
  ReportValue report;
  report.text = "||S_h - S|| <= " + c + " * (" + gamma + ")^h once alpha <= " + bounds.range.to_string() +
                "; sum rules of order " + std::to_string(bounds.exact_sum_rules) + " hold exactly in every round; hands on C^" +
                std::to_string(inherited_smoothness(bounds));
  report.json = Json{{"kind", "asymptotic"},
                     {"gamma", gamma},
                     {"M1", bounds.first.to_string()},
                     {"M2", bounds.second.to_string()},
                     {"flat_at_0", bounds.flat},
                     {"alpha_max", bounds.range.to_string()},
                     {"exact_sum_rules", bounds.exact_sum_rules}};
  return Value{std::move(report)};
}

Value show_radius(CallContext&, const Arguments& a) {
  const WordValue& value = need_word(a, 0);
  return number_of(circle_radius(value.word, need_whole(a, 1, "corners", 3, 1'000'000)));
}

}  // namespace

std::vector<Builtin> builtins_symbols() {
  return {
      {"sum_rules",
       "sum_rules(word)",
       "How often (1 + z + ...)/.. divides the symbol; one more than the degree generated.",
       1,
       1,
       {},
       show_sum_rules},
      {"generation", "generation(word)", "The largest degree of polynomials among the limits.", 1, 1, {}, show_generation},
      {"reproduction",
       "reproduction(word)",
       "The largest degree of polynomials that the scheme reproduces.",
       1,
       1,
       {},
       show_reproduction},
      {"shift", "shift(word)", "The shift of the parametrisation, a'(1)/arity.", 1, 1, {}, show_shift},
      {"stability",
       "stability(word)",
       "Whether the integer shifts of the basic limit function are stable.",
       1,
       1,
       {},
       show_stability},
      {"difference",
       "difference(word, k = 1)",
       "The mask of the scheme of k-th differences, and its norm.",
       1,
       2,
       {"k"},
       show_difference},
      {"difference_schemes",
       "difference_schemes()",
       "Catmull-Clark differences, their limits, and what the paper on regularity prints about them: agreed or corrected.",
       0,
       0,
       {},
       show_difference_schemes},
      {"limit_stencil",
       "limit_stencil(word, derivative = 0)",
       "Weights of the old points in a limit point, or in its tangent.",
       1,
       2,
       {"derivative"},
       show_limit_stencil},
      {"asymptotic", "asymptotic(word)", "How fast the rounds approach the static limit.", 1, 1, {}, show_asymptotic},
      {"radius",
       "radius(word, corners)",
       "The radius of the circle that a regular polygon of radius 1 becomes.",
       2,
       2,
       {},
       show_radius},
  };
}

}  // namespace udcp
