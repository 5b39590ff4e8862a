// Jets of masks over [0, range], and sum rules with symbols in place of the kernels.
#include "proofs/asymptotic.h"

#include <algorithm>

#include "operators/matrix.h"
#include "proofs/checkers.h"

namespace udcp {
namespace {

/// One round with alpha over [0, range].
Word round_over(const Word& word, const Rational& range) {
  Word result;
  result.tail = word.tail;
  result.triangles = word.triangles;
  result.alpha0 = Directional<KernelPtr>::all(variable(Interval(Rational(0), range)));
  return result;
}

Rational largest(const Interval& x) {
  const Interval modulus = abs(x);
  return modulus.upper();
}

/// The largest sum over a residue class: the norm of the operator with these entries.
Rational largest_row(const std::vector<Rational>& entries, int first, int arity) {
  std::vector<Rational> rows(static_cast<std::size_t>(arity));
  for (std::size_t k = 0; k < entries.size(); ++k) {
    const int residue = ((first + static_cast<int>(k)) % arity + arity) % arity;
    rows[static_cast<std::size_t>(residue)] += entries[k];
  }
  return *std::max_element(rows.begin(), rows.end());
}

/// Rounded up to four significant bits more than needed: certificates stay short.
Rational rounded_up(const Rational& x) {
  const Rational scale(1'000'000);
  return -((-x * scale).floor()) / scale;
}

/// The largest m with ((1 - z^A)/(1 - z))^m dividing the symbol and a(1) = A.
int order_of_sum_rules(const Mask<Parametric>& mask) {
  std::vector<Parametric> a = mask.coefficients;
  Parametric sum(0);
  for (const Parametric& c : a) sum += c;
  if (sum != Parametric(mask.arity)) return 0;
  const auto n = static_cast<std::size_t>(mask.arity);
  for (int order = 0;; ++order) {
    std::vector<Parametric> quotient;
    for (std::size_t k = 0; k + n <= a.size(); ++k) {
      const Parametric q = a[k];
      for (std::size_t j = 0; j < n; ++j) a[k + j] -= q;
      quotient.push_back(q);
    }
    if (std::any_of(a.begin(), a.end(), [](const Parametric& c) { return !c.is_zero(); })) return order;
    a = std::move(quotient);
    if (a.empty()) return order;
  }
}

int exact_sum_rules(const Word& word) {
  try {
    return order_of_sum_rules(mask<Parametric>(with_symbols(word)));
  } catch (const Error& error) {
    if (error.kind != ErrorKind::not_exact && error.kind != ErrorKind::limit && error.kind != ErrorKind::input) throw;
    return 0;  // not shown
  }
}

}  // namespace

AsymptoticBounds asymptotic_bounds(const Word& word, const Rational& range) {
  (void)static_limit(word);                  // refuses what has none
  const Interval::Precision precision(128);  // the checker must find the same bounds
  AsymptoticBounds bounds;
  bounds.range = range;
  const Mask<Jet> jets = mask<Jet>(round_over(word, range));
  const Mask<Jet> at_zero = mask<Jet>(round_over(word, Rational(0)));
  bounds.arity = jets.arity;
  std::vector<Rational> first, second;
  for (const Jet& entry : jets.coefficients) {
    first.push_back(largest(entry.first()));
    second.push_back(largest(entry.second()));
  }
  bounds.first = rounded_up(largest_row(first, jets.first, jets.arity));
  bounds.second = rounded_up(largest_row(second, jets.first, jets.arity));
  bounds.flat = std::all_of(at_zero.coefficients.begin(), at_zero.coefficients.end(),
                            [](const Jet& entry) { return entry.first() == Interval(0); });
  bounds.exact_sum_rules = exact_sum_rules(word);
  return bounds;
}

AsymptoticBounds asymptotic_bounds(const Word& word) {
  Rational range(1);
  for (int k = 0;; ++k, range /= Rational(2)) {
    try {
      return asymptotic_bounds(word, range);
    } catch (const Error& error) {
      const bool too_wide = error.code == "E_DIV0" || error.code == "E_NOT_FINITE" || error.code == "E_UNDECIDED" ||
                            error.code == "E_SQRT_NEGATIVE" || error.code == "E_LOG_DOMAIN";
      if (!too_wide || k == 10) throw;
    }
  }
}

int inherited_smoothness(const AsymptoticBounds& bounds) { return std::max(bounds.flat ? 1 : 0, bounds.exact_sum_rules); }

Result prove_asymptotic(const Word& word, int smoothness, const Result& static_part) {
  const std::string claim = "the limits of the word with its functions of alpha are C^" + std::to_string(smoothness);
  if (static_part.verdict != Verdict::proved || !static_part.certificate) {
    Result result =
        undecided(claim, "the static limit is not shown to be C^" + std::to_string(smoothness) + ": " + static_part.reason);
    if (static_part.verdict == Verdict::refuted) {
      result.reason = "the static limit is not C^" + std::to_string(smoothness) + ", which does not decide the word itself";
      result.witness = static_part.witness;
    }
    return result;
  }
  AsymptoticBounds bounds;
  try {
    bounds = asymptotic_bounds(word);
  } catch (const Error& error) {
    if (error.kind == ErrorKind::interrupted) throw;
    return undecided(
        claim, std::string("eq. (11) is not shown, as the masks have no bounded derivatives near alpha = 0: ") + error.what());
  }
  if (smoothness > inherited_smoothness(bounds))
    return undecided(claim, "eq. (11) holds with gamma = 1/" +
                                std::to_string(bounds.flat ? bounds.arity * bounds.arity : bounds.arity) + ", which hands on C^" +
                                std::to_string(inherited_smoothness(bounds)) + " only; exact sum rules of order " +
                                std::to_string(smoothness) + " in every round would decide it");
  Word tail;
  tail.tail = word.tail;
  const Json data = {{"word", to_json(tail, {4})},
                     {"smoothness", smoothness},
                     {"range", to_json(bounds.range)},
                     {"first", to_json(bounds.first)},
                     {"second", to_json(bounds.second)},
                     {"static", {{"kind", (*static_part.certificate)["kind"]}, {"data", (*static_part.certificate)["data"]}}}};
  std::string statement;
  try {
    statement = check_asymptotic(data);
  } catch (const Rejected& rejected) {
    return undecided(claim, rejected.what());
  }
  Result result = concluded(
      Verdict::proved,
      bounds.exact_sum_rules >= smoothness && smoothness > (bounds.flat ? 1 : 0)
          ? "every round keeps sum rules of order " + std::to_string(bounds.exact_sum_rules) + " exactly, and eq. (11) holds"
          : "eq. (11) holds, and sum A^(kh) ||S_h - S|| is finite",
      seal("asymptotic", statement, data));
  result.details = {
      {"M1", to_json(bounds.first)},
      {"M2", to_json(bounds.second)},
      {"flat_at_0", bounds.flat},
      {"gamma", bounds.flat ? "1/" + std::to_string(bounds.arity * bounds.arity) : "1/" + std::to_string(bounds.arity)},
      {"alpha_max", to_json(bounds.range)},
      {"exact_sum_rules", bounds.exact_sum_rules}};
  return result;
}

}  // namespace udcp
