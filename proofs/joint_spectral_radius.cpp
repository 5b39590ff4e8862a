// The search for bounds of joint spectral radii: products by enumeration, norms, and polytopes with less and less precision.
// Doubles propose; what is returned has passed the exact checks of polytope.h.
#include "proofs/joint_spectral_radius.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "proofs/hull.h"
#include "proofs/linear_algebra.h"
#include "proofs/symbol.h"

namespace udcp {
namespace {

using Real = Eigen::MatrixXd;

constexpr std::int64_t most_entries = 50'000;  // of all matrices: beyond, bounds come from norms only

/// The next word that is the least of its rotations and no power, of at most `longest` of `letters` letters (Duval).
bool next_word(std::vector<int>& word, int letters, std::size_t longest) {
  const std::size_t period = word.size();
  while (word.size() < longest) word.push_back(word[word.size() - period]);
  while (!word.empty() && word.back() == letters - 1) word.pop_back();
  if (word.empty()) return false;
  ++word.back();
  return true;
}

double spectral_radius(const Real& matrix) { return Eigen::EigenSolver<Real>(matrix, false).eigenvalues().cwiseAbs().maxCoeff(); }

/// The fraction with the least denominator, up to a million, that is the value up to rounding.
std::optional<Rational> simple_fraction(double value) {
  long long p = 1, p_before = 0, q = 0, q_before = 1;  // convergents of the continued fraction
  double rest = value;
  for (int step = 0; step < 30 && rest < 1e6; ++step) {
    const auto digit = static_cast<long long>(rest);
    p_before = std::exchange(p, digit * p + p_before);
    q_before = std::exchange(q, digit * q + q_before);
    if (q > 1'000'000 || p > 1'000'000'000) return std::nullopt;
    if (std::abs(static_cast<double>(p) / static_cast<double>(q) - value) <= 1e-13 * value) return Rational(p) / Rational(q);
    rest = 1 / (rest - static_cast<double>(digit));
  }
  return std::nullopt;
}

/// A fraction of twelve decimals (more for small values) just below, or above, the value.
Rational decimal(double value, bool up) {
  double unit = 1e12;
  while (value * unit < 1e11 && unit < 1e17) unit *= 10;
  const double scaled = value * unit;
  const auto digits = static_cast<long long>(up ? std::ceil(scaled) : std::floor(scaled));
  return Rational(digits) / Rational(static_cast<long long>(unit));
}

template <class S>
LowerRadius<S> lower_radius(const std::vector<Points<S>>& matrices, const LeadingProducts& leading) {
  std::vector<Rational> candidates;
  if (const auto simple = simple_fraction(leading.rate)) candidates.push_back(*simple);
  for (const double slack : {1e-12, 1e-9, 1e-6}) candidates.push_back(decimal(leading.rate * (1 - slack), false));
  for (const Rational& value : candidates)
    if (product_reaches<S>(matrices, leading.words.front(), S(value))) return {leading.words.front(), S(value)};
  return {leading.words.front(), S(0)};
}

/// Exact where the norm, or its negative, is an eigenvalue of a single matrix.
template <class S>
std::optional<std::vector<int>> letter_reaching(const std::vector<Points<S>>& matrices, const S& norm) {
  for (std::size_t e = 0; e < matrices.size(); ++e) {
    S row(0);  // only a matrix with that norm can have such an eigenvalue
    for (Eigen::Index i = 0; i < matrices[e].rows(); ++i) {
      S sum(0);
      for (Eigen::Index j = 0; j < matrices[e].cols(); ++j) sum += abs(matrices[e](i, j));
      if (sum > row) row = sum;
    }
    if (row != norm || matrices[e].rows() > most_rows) continue;
    const Polynomial<S> p = characteristic_polynomial(matrices[e]);
    if (p.at(norm).is_zero() || p.at(S(-norm)).is_zero()) return std::vector{static_cast<int>(e)};
  }
  return std::nullopt;
}

/// The best bound by norms of some rounds at once.
template <class S>
UpperRadius<S> upper_by_norms(const Mask<S>& mask, Budget& budget) {
  UpperRadius<S> best{norm(mask), 1, std::nullopt};
  Mask<S> rounds = mask;
  const std::size_t most = std::is_same_v<S, Rational> ? 40'000 : 4'000;
  for (int length = 2; length <= 12; ++length) {
    if (rounds.coefficients.size() * static_cast<std::size_t>(mask.arity) > most || !budget.spend(length)) break;
    rounds = iterated(mask, length);
    const S value = norm(rounds);
    const S bound(decimal(std::pow(approximate(value), 1.0 / length) * (1 + 1e-11), true));
    S power(1);
    for (int k = 0; k < length; ++k) power *= bound;
    if (power >= value && bound < best.value) best = {bound, length, std::nullopt};
  }
  return best;
}

template <class S>
std::optional<UpperRadius<S>> upper_by_polytopes(const std::vector<Points<S>>& matrices, const LeadingProducts& leading,
                                                 const LowerRadius<S>& lower, Budget& budget) {
  std::vector<Rational> bounds;
  if constexpr (std::is_same_v<S, Rational>) {
    if (lower.value.denominator() <= Rational(1'000'000)) bounds.push_back(lower.value);
  }
  for (const double slack : {5e-7, 1e-4, 1e-3, 5e-3}) bounds.push_back(decimal(leading.rate * (1 + slack), true));
  for (const Rational& bound : bounds)
    if (auto polytope = find_polytope(matrices, bound, leading, budget)) return UpperRadius<S>{S(bound), 1, std::move(polytope)};
  return std::nullopt;
}

}  // namespace

template <class S>
LeadingProducts leading_products(const std::vector<Points<S>>& matrices, Budget& budget) {
  const std::vector<Real> real = rounded(matrices);
  const auto letters = static_cast<int>(real.size());
  std::size_t longest = 0;
  for (std::int64_t words = 1; words * letters <= 1100 && longest < 10; words *= letters) ++longest;
  longest = std::max<std::size_t>(longest, 1);
  std::vector<std::pair<double, std::vector<int>>> found;
  std::vector<int> word{0};
  do {
    if (!budget.spend()) break;
    const double rate = std::pow(spectral_radius(product(real, word)), 1.0 / static_cast<double>(word.size()));
    if (std::isfinite(rate)) found.emplace_back(rate, word);
  } while (next_word(word, letters, longest));
  LeadingProducts result{0, {}};
  for (const auto& [rate, letters_of] : found) result.rate = std::max(result.rate, rate);
  for (const auto& [rate, letters_of] : found)
    if (rate >= result.rate * (1 - 1e-8) && result.words.size() < 16) result.words.push_back(letters_of);
  std::stable_sort(result.words.begin(), result.words.end(), [](const auto& a, const auto& b) { return a.size() < b.size(); });
  if (result.words.empty()) result.words.push_back({0});
  return result;
}

template <class S>
JointSpectralRadius<S> joint_spectral_radius(const Mask<S>& mask, Budget& budget) {
  const S bound = norm(mask);
  JointSpectralRadius<S> result{{{0}, S(0)}, {bound, 1, std::nullopt}};
  if (transition_size(mask) <= most_entries) {
    const std::vector<Points<S>> matrices = transition_matrices(mask);
    if (const auto letter = letter_reaching(matrices, bound)) {
      result.lower = {*letter, bound};
      return result;
    }
    const LeadingProducts leading = leading_products(matrices, budget);
    result.lower = lower_radius(matrices, leading);
    if (auto upper = upper_by_polytopes(matrices, leading, result.lower, budget)) {
      result.upper = std::move(*upper);
      return result;
    }
  }
  result.upper = upper_by_norms(mask, budget);
  return result;
}

template LeadingProducts leading_products(const std::vector<Points<Rational>>&, Budget&);
template LeadingProducts leading_products(const std::vector<Points<Algebraic>>&, Budget&);
template JointSpectralRadius<Rational> joint_spectral_radius(const Mask<Rational>&, Budget&);
template JointSpectralRadius<Algebraic> joint_spectral_radius(const Mask<Algebraic>&, Budget&);

}  // namespace udcp
