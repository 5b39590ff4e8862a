// The checkers of certificates about curves: the mask is derived again from the word by running its atoms, then sum rules, norms,
// products and polytopes are checked exactly. Searches for nothing.
#include <cmath>

#include "proofs/checkers.h"
#include "proofs/polytope.h"
#include "proofs/static_word.h"
#include "proofs/symbol.h"

namespace udcp {
namespace {

constexpr int most_smooth = 1000;
constexpr std::int64_t most_entries = 50'000;  // of transition matrices

/// Hands the mask of the word of the data to the function, in the smallest exact type that holds it.
template <class F>
std::string with_mask(const Json& data, F check) {
  const Json& json = entry(data, "word");
  const Word word = word_from(json);
  require(to_json(word, {4}) == json, "the word is not in the form that this program writes");
  require(!word.triangles, "a word for curves does not run on triangles");
  for (const Item& item : word.tail)
    require(item.ngon == Ngon::dual && !item.omega_face, "ngon and omega_face mean nothing on curves");
  return std::visit([&](const auto& mask) { return check(mask); }, exact_mask(word));
}

template <class S>
S number_from(const Json& value, const std::string& where) {
  if constexpr (std::is_same_v<S, Rational>)
    return rational_from(value, where);
  else
    return algebraic_from(value, where);
}

template <class S>
S power(const S& base, int exponent) {
  S result(1);
  for (int k = 0; k < exponent; ++k) result *= base;
  return result;
}

/// The difference scheme of the order that an entry names, from `least` to the number of sum rules.
template <class S>
Mask<S> differences(const Mask<S>& mask, const Json& order, int least) {
  return difference_mask(mask, integer_from(order, least, sum_rules(mask), "the order of the difference scheme"));
}

template <class S>
std::vector<Points<S>> matrices_of(const Mask<S>& differences) {
  require(transition_size(differences) <= most_entries, "the transition matrices are too large");
  return transition_matrices(differences);
}

std::vector<int> product_from(const Json& json, std::size_t matrices) {
  require(json.is_array() && !json.empty() && json.size() <= 20, "a product is a list of 1 to 20 letters");
  std::vector<int> result;
  for (const Json& letter : json)
    result.push_back(integer_from(letter, 0, static_cast<int>(matrices) - 1, "a letter of the product"));
  return result;
}

template <class S>
std::string smoothness(const Mask<S>& mask, const Json& data) {
  const int k = integer_from(entry(data, "smoothness"), 0, most_smooth, "smoothness");
  const Mask<S> scheme = differences(mask, entry(data, "order"), k + 1);
  const Json& bound = entry(data, "bound");
  if (entry(bound, "kind") == "norm") {
    require_entries(bound, {"kind", "length", "value"}, "the bound");
    const int length = integer_from(entry(bound, "length"), 1, 40, "the number of rounds");
    const double entries = static_cast<double>(scheme.coefficients.size()) * std::pow(mask.arity, length);
    require(entries <= (std::is_same_v<S, Rational> ? 100'000 : 10'000), "so many rounds are too long to check");
    const S value = power(S(mask.arity), k * length) * norm(iterated(scheme, length));
    require(value == number_from<S>(entry(bound, "value"), "value"), "the norm of the difference scheme is another");
    require(value < S(1), "the difference scheme does not contract");
  } else {
    const Polytope polytope = polytope_from(bound);
    check_polytope(matrices_of(scheme), polytope);
    require(power(Rational(mask.arity), k) * polytope.bound < Rational(1), "the bound of the joint spectral radius is too large");
  }
  return describe(entry(data, "word")) + (k == 0 ? " converges on curves" : " is C^" + std::to_string(k) + " on curves");
}

template <class S>
std::string refutation(const Mask<S>& mask, const Json& data) {
  const int k = integer_from(entry(data, "smoothness"), 0, most_smooth, "smoothness");
  const Json& reason = entry(data, "reason");
  if (entry(reason, "kind") == "sum rules") {
    require_entries(reason, {"kind"}, "the reason");
    require(sum_rules(mask) <= k, "the mask has enough sum rules");
    require(stability(mask) == Stability::stable, "the shifts are not known to be stable");
  } else {
    require_entries(reason, {"kind", "order", "product"}, "the reason");
    require(entry(reason, "kind") == "product", "the kind of the reason is neither \"product\" nor \"sum rules\"");
    const std::vector<Points<S>> matrices = matrices_of(differences(mask, entry(reason, "order"), 1));
    const std::vector<int> letters = product_from(entry(reason, "product"), matrices.size());
    if (!product_reaches(matrices, letters, S(1))) {  // the scheme may converge
      require(k > 0 && stability(mask) == Stability::stable, "the shifts are not known to be stable");
      require(integer_from(reason["order"], 1, most_smooth, "order") > k, "the order is too small for this smoothness");
      require(product_reaches(matrices, letters, S(S(1) / power(S(mask.arity), k))), "the product has no such eigenvalue");
    }
  }
  return describe(entry(data, "word")) +
         (k == 0 ? " does not converge on curves" : " is not C^" + std::to_string(k) + " on curves");
}

/// The bound of the joint spectral radius, which the data prove.
template <class S>
S upper_radius(const Mask<S>& scheme, const Json& upper) {
  if (entry(upper, "kind") == "polytope") {
    const Polytope polytope = polytope_from(upper);
    check_polytope(matrices_of(scheme), polytope);
    return S(polytope.bound);
  }
  require_entries(upper, {"kind", "length", "value", "bound"}, "the upper bound");
  require(entry(upper, "kind") == "norm", "the kind of the upper bound is neither \"norm\" nor \"polytope\"");
  const int length = integer_from(entry(upper, "length"), 1, 40, "the number of rounds");
  const S value = norm(iterated(scheme, length)), bound = number_from<S>(entry(upper, "bound"), "bound");
  require(value == number_from<S>(entry(upper, "value"), "value"), "the norm of the difference scheme is another");
  require(bound.sign() > 0 && value <= power(bound, length), "the bound is smaller than the norm allows");
  return bound;
}

template <class S>
std::string regularity(const Mask<S>& mask, const Json& data) {
  const Mask<S> scheme = difference_mask(mask, sum_rules(mask));
  const S upper = upper_radius(scheme, entry(data, "upper"));
  require(upper < S(1), "the bound does not show that the scheme converges");
  const std::string claim = describe(entry(data, "word")) + " has the Hoelder exponent ",
                    least = exponent_text(mask.arity, upper);
  const Json& lower = entry(data, "lower");
  if (lower.is_null()) return claim + "at least " + least + " on curves";
  require(stability(mask) == Stability::stable, "the shifts are not known to be stable");
  require_entries(lower, {"product", "value"}, "the lower bound");
  const std::vector<Points<S>> matrices = matrices_of(scheme);
  const S value = number_from<S>(entry(lower, "value"), "value");
  require(value.sign() > 0 && product_reaches(matrices, product_from(entry(lower, "product"), matrices.size()), value),
          "the product has no such eigenvalue");
  if (value == upper) return claim + least + " on curves";
  return claim + "between " + least + " and " + exponent_text(mask.arity, value) + " on curves";
}

}  // namespace

std::string check_curve_smoothness(const Json& data, StopFlag) {
  require_entries(data, {"word", "smoothness", "order", "bound"}, "the data");
  return with_mask(data, [&](const auto& mask) { return smoothness(mask, data); });
}

std::string check_curve_refutation(const Json& data, StopFlag) {
  require_entries(data, {"word", "smoothness", "reason"}, "the data");
  return with_mask(data, [&](const auto& mask) { return refutation(mask, data); });
}

std::string check_curve_regularity(const Json& data, StopFlag) {
  require_entries(data, {"word", "upper", "lower"}, "the data");
  return with_mask(data, [&](const auto& mask) { return regularity(mask, data); });
}

}  // namespace udcp
