// Exact algebra on masks: sum rules, difference schemes, norms, reproduction and limit stencils.
#include "proofs/symbol.h"

#include <algorithm>

#include "proofs/linear_algebra.h"

namespace udcp {
namespace {

std::size_t index(int k) { return static_cast<std::size_t>(k); }

int floor_div(int a, int b) { return a >= 0 ? a / b : -((-a + b - 1) / b); }

template <class S>
int last_of(const Mask<S>& mask) {
  return mask.first + static_cast<int>(mask.coefficients.size()) - 1;
}

template <class S>
S coefficient(const Mask<S>& mask, int k) {
  return k < mask.first || k > last_of(mask) ? S(0) : mask.coefficients[index(k - mask.first)];
}

/// a(z) (1 - z)/(1 - z^A), if that is a polynomial.
template <class S>
std::optional<std::vector<S>> divided(const std::vector<S>& a, int arity) {
  const std::size_t step = index(arity);
  if (a.size() < step) return std::nullopt;
  std::vector<S> quotient(a.size() + 1, S(0));
  for (std::size_t i = 0; i <= a.size(); ++i) {
    if (i < a.size()) quotient[i] += a[i];
    if (i > 0) quotient[i] -= a[i - 1];
    if (i >= step) quotient[i] += quotient[i - step];
  }
  const auto degree = static_cast<std::ptrdiff_t>(a.size() - step + 1);
  if (std::any_of(quotient.begin() + degree, quotient.end(), [](const S& c) { return !c.is_zero(); })) return std::nullopt;
  quotient.resize(static_cast<std::size_t>(degree));
  return quotient;
}

template <class S>
std::optional<Stencil<S>> left_eigenvector(const Mask<S>& mask, const S& eigenvalue, bool tangent) {
  const int last = last_of(mask), reach = (last + mask.arity - 2) / (mask.arity - 1);
  if (mask.coefficients.empty() || mask.first != -last || reach > 24) return std::nullopt;
  for (int k = 1; k <= last; ++k)
    if (coefficient(mask, k) != coefficient(mask, -k)) return std::nullopt;
  const int n = 2 * reach + 1;
  Points<S> transposed(n, n);
  for (int i = -reach; i <= reach; ++i)
    for (int j = -reach; j <= reach; ++j) transposed(j + reach, i + reach) = coefficient(mask, i - mask.arity * j);
  for (int i = 0; i < n; ++i) transposed(i, i) -= eigenvalue;
  const Points<S> basis = kernel(transposed), right = kernel<S>(transposed.transpose());
  if (basis.cols() != 1) return std::nullopt;
  S pairing(0);  // zero in a Jordan block of two or more
  for (int i = 0; i < n; ++i) pairing += basis(i, 0) * right(i, 0);
  if (pairing.is_zero()) return std::nullopt;
  S scale(0);
  for (int i = 0; i < n; ++i) scale += (tangent ? S(i - reach) : S(1)) * basis(i, 0);
  if (scale.is_zero()) return std::nullopt;
  int low = 0, high = n - 1;
  while (basis(low, 0).is_zero()) ++low;
  while (basis(high, 0).is_zero()) --high;
  Stencil<S> result{low - reach, {}};
  for (int i = low; i <= high; ++i) result.weights.push_back(basis(i, 0) / scale);
  return result;
}

}  // namespace

ExactMask exact_mask(const Word& word) {
  try {
    return mask<Rational>(word);
  } catch (const Error& error) {
    if (error.kind != ErrorKind::not_exact) throw;
  }
  return mask<Algebraic>(word);
}

template <class S>
Polynomial<S> symbol(const Mask<S>& mask) {
  return Polynomial<S>(mask.coefficients);
}

template <class S>
int sum_rules(const Mask<S>& mask) {
  S sum(0);
  for (const S& c : mask.coefficients) sum += c;
  if (sum != S(mask.arity)) return 0;
  int order = 0;
  for (auto quotient = divided(mask.coefficients, mask.arity); quotient; quotient = divided(*quotient, mask.arity)) ++order;
  return order;
}

template <class S>
S parameter_shift(const Mask<S>& mask) {
  S slope(0);
  for (std::size_t k = 0; k < mask.coefficients.size(); ++k) slope += S(mask.first + static_cast<int>(k)) * mask.coefficients[k];
  return slope / S(mask.arity);
}

template <class S>
int reproduction_degree(const Mask<S>& mask) {
  const int order = sum_rules(mask);
  const S tau = parameter_shift(mask);
  std::vector<S> terms = mask.coefficients;  // a_i i (i - 1) .. (i - k + 1)
  S expected(mask.arity);
  for (int k = 0; k < order; ++k) {
    S derivative(0);
    for (const S& term : terms) derivative += term;
    if (derivative != expected) return k - 1;
    expected *= tau - S(k);
    for (std::size_t i = 0; i < terms.size(); ++i) terms[i] *= S(mask.first + static_cast<int>(i) - k);
  }
  return order - 1;
}

template <class S>
Support support(const Mask<S>& mask) {
  const Rational scale(mask.arity - 1);
  return {Rational(mask.first) / scale, Rational(last_of(mask)) / scale};
}

template <class S>
Mask<S> difference_mask(const Mask<S>& mask, int order) {
  Mask<S> result = mask;
  for (int j = 0; j < order; ++j) {
    auto quotient = divided(result.coefficients, mask.arity);
    if (!quotient)
      throw Error(ErrorKind::internal, "E_INTERNAL",
                  "the mask has no " + std::to_string(order) + " sum rules, so no scheme for differences of that order");
    result.coefficients = std::move(*quotient);
  }
  return result;
}

template <class S>
Mask<S> iterated(const Mask<S>& mask, int rounds) {
  std::size_t size = mask.coefficients.size();
  for (int round = 0; round < rounds; ++round) {
    size *= index(mask.arity);
    if (size > 1'000'000)
      throw Error(ErrorKind::limit, "E_ARITY",
                  "the mask of " + std::to_string(rounds) + " rounds has more than 1000000 coefficients");
  }
  Mask<S> result{1, 0, Rational(0), {S(1)}};
  for (int round = 0; round < rounds; ++round) {
    const std::size_t stride = index(result.arity);
    // The last factor of the product is the mask spread by the arity so far.
    std::vector<S> next((mask.coefficients.size() - 1) * stride + result.coefficients.size(), S(0));
    for (std::size_t i = 0; i < mask.coefficients.size(); ++i) {
      if (mask.coefficients[i].is_zero()) continue;
      for (std::size_t j = 0; j < result.coefficients.size(); ++j)
        next[i * stride + j] += mask.coefficients[i] * result.coefficients[j];
    }
    result.coefficients = std::move(next);
    result.first += result.arity * mask.first;
    result.shift += Rational(result.arity) * mask.shift;
    result.arity *= mask.arity;
  }
  return result;
}

template <class S>
S norm(const Mask<S>& mask) {
  S most(0);
  for (std::size_t r = 0; r < index(mask.arity); ++r) {
    S sum(0);
    for (std::size_t k = r; k < mask.coefficients.size(); k += index(mask.arity)) sum += abs(mask.coefficients[k]);
    if (sum > most) most = sum;
  }
  return most;
}

template <class S>
std::string exponent_text(int arity, const S& radius) {
  const std::string log = "log" + std::to_string(arity) + "(";
  if constexpr (std::is_same_v<S, Algebraic>) {
    if (!radius.is_rational()) return "-" + log + radius.to_string() + ")";
    return exponent_text(arity, radius.rational());
  } else {
    int whole = 0;
    Rational rest = radius;  // radius = rest/A^whole with 1 <= rest < A
    for (; rest < Rational(1); ++whole) rest *= Rational(arity);
    for (; rest >= Rational(arity); --whole) rest /= Rational(arity);
    if (rest == Rational(1)) return std::to_string(whole);
    for (int root = 2; (1 << root) <= arity; ++root) {  // A = base^root
      const auto base = exact_root(Rational(arity), root);
      for (int k = 1; base && k < root; ++k)
        if (pow(*base, k) == rest) return (Rational(whole) - Rational(k) / Rational(root)).to_string();
    }
    return (whole == 0 ? "-" : std::to_string(whole) + " - ") + log + rest.to_string() + ")";
  }
}

template <class S>
bool interpolates(const Mask<S>& mask) {
  for (int k = mask.arity * floor_div(mask.first, mask.arity); k <= last_of(mask); k += mask.arity)
    if (coefficient(mask, k) != S(k == 0 ? 1 : 0)) return false;
  return coefficient(mask, 0) == S(1);
}

template <class S>
bool is_nonnegative(const Mask<S>& mask) {
  return std::none_of(mask.coefficients.begin(), mask.coefficients.end(), [](const S& c) { return c.sign() < 0; });
}

template <class S>
int exponential_order(const Mask<S>& mask, const S& cosine) {
  const Polynomial<S> factor({S(1), S(2) * cosine, S(1)});
  Polynomial<S> rest = symbol(mask);
  for (int order = 0; !rest.is_zero(); ++order) {
    auto [quotient, remainder] = divide(rest, factor);
    if (!remainder.is_zero()) return order;
    rest = std::move(quotient);
  }
  return 0;
}

template <class S>
std::optional<Stencil<S>> position_stencil(const Mask<S>& mask) {
  return left_eigenvector(mask, S(1), false);
}

template <class S>
std::optional<Stencil<S>> tangent_stencil(const Mask<S>& mask) {
  return left_eigenvector(mask, S(S(1) / S(mask.arity)), true);
}

#define UDCP_INSTANTIATE(S)                                            \
  template Polynomial<S> symbol(const Mask<S>&);                       \
  template int sum_rules(const Mask<S>&);                              \
  template S parameter_shift(const Mask<S>&);                          \
  template int reproduction_degree(const Mask<S>&);                    \
  template Support support(const Mask<S>&);                            \
  template Mask<S> difference_mask(const Mask<S>&, int);               \
  template Mask<S> iterated(const Mask<S>&, int);                      \
  template S norm(const Mask<S>&);                                     \
  template std::string exponent_text(int, const S&);                   \
  template bool interpolates(const Mask<S>&);                          \
  template bool is_nonnegative(const Mask<S>&);                        \
  template int exponential_order(const Mask<S>&, const S&);            \
  template std::optional<Stencil<S>> position_stencil(const Mask<S>&); \
  template std::optional<Stencil<S>> tangent_stencil(const Mask<S>&);
UDCP_INSTANTIATE(Rational)
UDCP_INSTANTIATE(Algebraic)
#undef UDCP_INSTANTIATE

}  // namespace udcp
