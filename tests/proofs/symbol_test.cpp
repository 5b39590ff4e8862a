// Symbols of masks: the expected values of the specification, products of B-spline masks, and difference schemes against
// differences of data.
#include "proofs/symbol.h"

#include <doctest/doctest.h>

#include <fstream>

#include "proofs/static_word.h"
#include "tests/oracle/expected_curves.h"
#include "tests/oracle/inputs.h"
#include "tests/oracle/polynomial.h"

using namespace udcp;
using oracle::ratio;
using oracle::scheme;
using oracle::value;

namespace {

/// One round on sequences: new_i = sum a_(i - A j) old_j, where old starts at index `first`.
std::map<int, Rational> refined(const Mask<Rational>& mask, const std::map<int, Rational>& old) {
  std::map<int, Rational> result;
  for (const auto& [j, p] : old)
    for (std::size_t k = 0; k < mask.coefficients.size(); ++k)
      result[mask.arity * j + mask.first + static_cast<int>(k)] += mask.coefficients[k] * p;
  return result;
}

std::map<int, Rational> differences(std::map<int, Rational> p, int order) {
  for (int k = 0; k < order; ++k) {
    std::map<int, Rational> next;
    for (const auto& [i, x] : p) {
      next[i] += x;
      next[i + 1] -= x;
    }
    p = std::move(next);
  }
  std::erase_if(p, [](const auto& entry) { return entry.second.is_zero(); });
  return p;
}

Rational binomial(int n, int k) {
  Rational result(1);
  for (int i = 0; i < k; ++i) result *= ratio(n - i, i + 1);
  return result;
}

Json as_json(const std::optional<Stencil<Rational>>& stencil) {
  if (!stencil) return nullptr;
  Json result = Json::object();
  for (std::size_t k = 0; k < stencil->weights.size(); ++k)
    if (!stencil->weights[k].is_zero())
      result[std::to_string(stencil->first + static_cast<int>(k))] = to_json(stencil->weights[k]);
  return result;
}

}  // namespace

TEST_SUITE_BEGIN("proofs");

TEST_CASE("masks and their algebra are those of the specification") {
  for (const Json& record : oracle::expected_curves()["static"]) {
    CAPTURE(record["program"].get<std::string>());
    CAPTURE(record["params"].dump());
    const Mask<Rational> m = mask<Rational>(static_limit(oracle::expected_word(record)));
    CHECK(m.arity == record["arity"].get<int>());
    Json coefficients = Json::object();
    for (std::size_t k = 0; k < m.coefficients.size(); ++k)
      if (!m.coefficients[k].is_zero()) coefficients[std::to_string(m.first + static_cast<int>(k))] = to_json(m.coefficients[k]);
    CHECK(coefficients == record["mask"]);
    CHECK(sum_rules(m) == record["sum_rules"].get<int>());
    CHECK(to_json(parameter_shift(m)) == record["tau"]);
    CHECK(reproduction_degree(m) == record["reproduction_degree"].get<int>());
    if (record["stable"].is_boolean()) {
      CHECK((stability(m) == Stability::stable) == record["stable"].get<bool>());
    }
    if (record.contains("limit_position")) CHECK(as_json(position_stencil(m)) == record["limit_position"]);
    // null there also where the scheme is not C^1, which this algebra does not see
    if (record.contains("limit_tangent") && !record["limit_tangent"].is_null())
      CHECK(as_json(tangent_stencil(m)) == record["limit_tangent"]);
  }
}

TEST_CASE("U followed by m averages is the B-spline of degree m + 1") {
  for (int m = 1; m <= 12; ++m) {
    const Mask<Rational> spline = mask<Rational>(scheme("U" + std::string(static_cast<std::size_t>(m), 'D')));
    REQUIRE(spline.coefficients.size() == static_cast<std::size_t>(m) + 3);
    for (int i = 0; i <= m + 2; ++i)
      CHECK(spline.coefficients[static_cast<std::size_t>(i)] == binomial(m + 2, i) / pow(Rational(2), m + 1));
    CHECK(sum_rules(spline) == m + 2);
    CHECK(reproduction_degree(spline) == 1);
    CHECK(support(spline).upper - support(spline).lower == Rational(m + 2));
    const Mask<Rational> last = difference_mask(spline, m + 2);
    CHECK(last.coefficients == std::vector{pow(Rational(2), -m - 1)});
    CHECK(stability(spline) == Stability::stable);
  }
}

TEST_CASE("the scheme of j-th differences maps j-th differences to j-th differences") {
  oracle::Dice dice(11);
  for (const char* atoms : {"UCP", "UCCP", "U3CP", "UUCPD", "UDDD"}) {
    CAPTURE(atoms);
    const Mask<Rational> m = mask<Rational>(scheme(atoms, value(3, 2), value(2, 3), value(1, 5)));
    for (int order = 0; order <= sum_rules(m); ++order) {
      std::map<int, Rational> data;
      for (int i = -2; i < 4; ++i) data[i] = dice.fraction();
      // The mask a(z) ((1 - z)/(1 - z^A))^j on differences taken as x_i - x_(i-1), in powers of z and z^A.
      CHECK(differences(refined(m, data), order) == differences(refined(difference_mask(m, order), differences(data, order)), 0));
    }
    CHECK_THROWS_AS((void)difference_mask(m, sum_rules(m) + 1), Error);
  }
}

TEST_CASE("the mask of three rounds is the refinement of a refinement of a refinement") {
  for (const char* atoms : {"UCP", "U3C"}) {
    const Mask<Rational> m = mask<Rational>(scheme(atoms)), three = iterated(m, 3);
    const auto direct = refined(m, refined(m, refined(m, {{0, Rational(1)}})));
    CHECK(three.arity == m.arity * m.arity * m.arity);
    for (const auto& [i, c] : direct) CHECK(three.coefficients[static_cast<std::size_t>(i - three.first)] == c);
    CHECK(three.coefficients.size() == direct.size());
    CHECK(norm(three) <= norm(m) * norm(m) * norm(m));
  }
  CHECK_THROWS_AS((void)iterated(mask<Rational>(scheme("UCP")), 25), Error);
}

TEST_CASE("the symbol of a word is the product of the symbols of its parts") {
  const Mask<Rational> cubic = mask<Rational>(scheme("UC"));
  const auto split = oracle::Polynomial<Rational>{ratio(1, 2), Rational(1), ratio(1, 2)};
  const auto average = oracle::Polynomial<Rational>{ratio(1, 2), ratio(1, 2)};
  CHECK(symbol(cubic).coefficients == oracle::times(split, oracle::power(average, 2)));
}

TEST_CASE("interpolation and positivity are read off the mask") {
  CHECK(interpolates(mask<Rational>(scheme("UCP"))));
  CHECK(interpolates(mask<Rational>(scheme("U3CP"))));
  CHECK(interpolates(mask<Rational>(scheme("UP"))));
  CHECK_FALSE(interpolates(mask<Rational>(scheme("UC"))));
  CHECK_FALSE(interpolates(mask<Rational>(scheme("UCP", nullptr, nullptr, value(4, 5)))));
  CHECK(is_nonnegative(mask<Rational>(scheme("UC"))));
  CHECK_FALSE(is_nonnegative(mask<Rational>(scheme("UCP"))));
}

TEST_CASE("masks with irrational parameters keep their sum rules") {
  const KernelPtr root_two =
      formula([](const auto& c) { return sqrt(std::decay_t<decltype(c.alpha)>(2)); }, Needs{false, false, false});
  const KernelPtr golden =
      formula([](const auto& c) { return cos(std::decay_t<decltype(c.alpha)>::pi(Rational(2) / Rational(5))); },
              Needs{false, false, false});
  for (const KernelPtr& f : {root_two, golden}) {
    const ExactMask exact = exact_mask(scheme("UCP", f, value(1), value(1, 2)));
    REQUIRE(std::holds_alternative<Mask<Algebraic>>(exact));
    const auto& m = std::get<Mask<Algebraic>>(exact);
    CHECK(sum_rules(m) == 2);
    CHECK(parameter_shift(m).is_zero());
    CHECK(reproduction_degree(m) == 1);
    CHECK(stability(m) == Stability::stable);
    // One step of the theorem on UCP: the norm of first differences is 1/2 + 2b with b = delta/(8(1 + f)).
    const Algebraic factor = f->at(Context<Algebraic>{}).value();
    CHECK(norm(difference_mask(m, 1)) == Algebraic(ratio(1, 2)) + Algebraic(ratio(1, 8)) / (Algebraic(1) + factor));
    const auto tangent = tangent_stencil(m);
    REQUIRE(tangent);
    Algebraic slope;
    for (std::size_t k = 0; k < tangent->weights.size(); ++k)
      slope += Algebraic(tangent->first + static_cast<int>(k)) * tangent->weights[k];
    CHECK(slope == Algebraic(1));
  }
}

TEST_CASE("zeros z and -z on the unit circle and cycles of zeros are not stable") {
  const auto make = [](std::vector<Rational> c) { return Mask<Rational>{2, 0, Rational(0), std::move(c)}; };
  // (1 + z)^2 (1 + z^2)/4 vanishes at i and -i: the word UC with f = 0.
  CHECK(stability(mask<Rational>(scheme("UC", value(0)))) == Stability::unstable);
  // (1 + z)^2 (1 - z + z^2)/2: the sixth roots -w, -w^2 with w of order three. Shifts of its limit function sum to a gap.
  CHECK(stability(make({ratio(1, 2), ratio(1, 2), 0, ratio(1, 2), ratio(1, 2)})) == Stability::unstable);
  // a pair 1/2, -1/2 inside the circle does no harm: (1 + z)^2 (1 - 4 z^2)/-6 is stable by the theorem.
  CHECK(stability(make({ratio(-1, 6), ratio(-1, 3), ratio(1, 2), ratio(4, 3), ratio(2, 3)})) == Stability::stable);
  // (1 + z)^2 (1 + z + z^2)/6: zeros of order three on the circle, but no pair and no cycle at odd roots of -1.
  CHECK(stability(make({ratio(1, 6), ratio(1, 2), ratio(2, 3), ratio(1, 2), ratio(1, 6)})) == Stability::stable);
  // (5 - 6 z^2 + 5 z^4) has zeros of modulus 1 that are no roots of unity.
  CHECK(stability(make({ratio(5, 8), ratio(5, 4), ratio(-1, 8), ratio(-3, 2), ratio(-1, 8), ratio(5, 4), ratio(5, 8)})) ==
        Stability::unstable);
  CHECK(stability(mask<Rational>(scheme("U3C"))) == Stability::unknown);
}

TEST_CASE("a word with f the cosine of a quarter angle generates the cosine") {
  // U C^k P with f = cos(alpha/2) and omega = 1/f vanishes to order 2 at -1 and at -exp(i alpha/2), for every delta and k.
  const Rational f = ratio(3, 5), omega = Rational(1) / f;
  for (const char* atoms : {"UCP", "UCCP"}) {
    const Mask<Rational> m = mask<Rational>(scheme(atoms, constant(f), constant(omega), value(1, 3)));
    CHECK(exponential_order(m, f) >= 1);
    CHECK(exponential_order(m, Rational(1)) == 1);
    CHECK(exponential_order(m, ratio(1, 2)) == 0);
  }
  CHECK(exponential_order(mask<Rational>(scheme("UCP", constant(f))), f) == 0);
}

TEST_CASE("exponents have their shortest text") {
  CHECK(exponent_text(2, ratio(1, 4)) == "2");
  CHECK(exponent_text(2, ratio(3, 16)) == "3 - log2(3/2)");
  CHECK(exponent_text(4, ratio(1, 8)) == "3/2");
  CHECK(exponent_text(3, ratio(1, 6)) == "2 - log3(3/2)");
  CHECK(exponent_text(2, Algebraic::cosine(ratio(1, 5))).substr(0, 6) == "-log2(");
}

TEST_SUITE_END();
