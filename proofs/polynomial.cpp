// Polynomials over exact fields: Euclid's algorithm, Yun's square-free factors, Sturm's theorem for real roots. Knows no matrices
// and rounds nothing but the enclosure at(Interval).
#include "proofs/polynomial.h"

#include <algorithm>

namespace udcp {
namespace {

std::size_t index(int k) { return static_cast<std::size_t>(k); }

template <class S>
Polynomial<S> scaled(Polynomial<S> p, const S& factor) {
  for (S& c : p.coefficients) c *= factor;
  return Polynomial<S>(std::move(p.coefficients));
}

template <class S>
Rational upper_bound(const S& value) {
  if constexpr (std::is_same_v<S, Rational>)
    return abs(value);
  else
    return abs(value.enclosure()).upper();
}

/// A power of two above the modulus of every root (Cauchy's bound).
template <class S>
Rational root_bound(const Polynomial<S>& p) {
  Rational most(1);
  for (const S& c : p.monic().coefficients) most = std::max(most, upper_bound(c));
  Rational bound(2);
  while (bound < most + Rational(1)) bound *= Rational(2);
  return bound;
}

/// Sturm's chain of a square-free polynomial; members are scaled by positive numbers only.
template <class S>
class SturmChain {
 public:
  explicit SturmChain(const Polynomial<S>& p) : chain_{p, p.derivative()} {
    while (!chain_.back().is_zero()) {
      Polynomial<S> rest = divide(chain_[chain_.size() - 2], chain_.back()).second;
      if (!rest.is_zero()) {
        const S& lead = rest.coefficients.back();
        rest = scaled(rest, S(S(-1) / (lead.sign() < 0 ? S(-lead) : lead)));
      }
      chain_.push_back(std::move(rest));
    }
    chain_.pop_back();
  }
  [[nodiscard]] int sign(const Rational& x) const { return chain_.front().at(S(x)).sign(); }
  /// Sign changes along the chain: those at a minus those at b are the roots in (a, b].
  [[nodiscard]] int changes(const Rational& x) const {
    int count = 0, before = 0;
    for (const Polynomial<S>& p : chain_) {
      const int now = p.at(S(x)).sign();
      if (now != 0 && before != 0 && now != before) ++count;
      if (now != 0) before = now;
    }
    return count;
  }

 private:
  std::vector<Polynomial<S>> chain_;
};

/// Appends an interval for each of the roots between a and b, where the polynomial is not zero.
template <class S>
void isolate(const SturmChain<S>& chain, const Rational& a, int changes_a, const Rational& b, int changes_b,
             std::vector<RealRoot>& roots) {
  if (changes_a == changes_b) return;
  if (changes_a - changes_b == 1) {
    roots.push_back({a, b, 1});
    return;
  }
  const Rational middle = (a + b) / Rational(2);
  if (chain.sign(middle) != 0) {
    const int changes = chain.changes(middle);
    isolate(chain, a, changes_a, middle, changes, roots);
    isolate(chain, middle, changes, b, changes_b, roots);
    return;
  }
  // The middle is a root: cut a piece out around it that has no other.
  Rational low, high, reach = (b - a) / Rational(4);
  int changes_low = 0, changes_high = 0;
  do {
    low = middle - reach;
    high = middle + reach;
    changes_low = chain.changes(low);
    changes_high = chain.changes(high);
    reach /= Rational(2);
  } while (changes_low - changes_high != 1 || chain.sign(low) == 0 || chain.sign(high) == 0);
  isolate(chain, a, changes_a, low, changes_low, roots);
  roots.push_back({middle, middle, 1});
  isolate(chain, high, changes_high, b, changes_b, roots);
}

template <class S>
void halve(const SturmChain<S>& chain, RealRoot& root) {
  const Rational middle = (root.lower + root.upper) / Rational(2);
  const int sign = chain.sign(middle);
  if (sign == 0)
    root.lower = root.upper = middle;
  else if (sign == chain.sign(root.lower))
    root.lower = middle;
  else
    root.upper = middle;
}

}  // namespace

template <class S>
Polynomial<S>::Polynomial(std::vector<S> lowest_first) : coefficients(std::move(lowest_first)) {
  while (!coefficients.empty() && coefficients.back().is_zero()) coefficients.pop_back();
}

template <class S>
Polynomial<S> Polynomial<S>::monomial(const S& coefficient, int degree) {
  std::vector<S> result(index(degree) + 1, S(0));
  result.back() = coefficient;
  return Polynomial(std::move(result));
}

template <class S>
S Polynomial<S>::at(const S& x) const {
  S result(0);
  for (std::size_t k = coefficients.size(); k-- > 0;) result = result * x + coefficients[k];
  return result;
}

template <class S>
Interval Polynomial<S>::at(const Interval& x) const {
  Interval result(0);
  for (std::size_t k = coefficients.size(); k-- > 0;) result = result * x + number<Interval>(coefficients[k]);
  return result;
}

template <class S>
Polynomial<S> Polynomial<S>::derivative() const {
  std::vector<S> result;
  for (std::size_t k = 1; k < coefficients.size(); ++k) result.push_back(coefficients[k] * S(static_cast<int>(k)));
  return Polynomial(std::move(result));
}

template <class S>
Polynomial<S> Polynomial<S>::monic() const {
  return is_zero() ? *this : scaled(*this, S(S(1) / coefficients.back()));
}

template <class S>
Polynomial<S> operator+(const Polynomial<S>& a, const Polynomial<S>& b) {
  std::vector<S> sum = a.coefficients;
  sum.resize(std::max(sum.size(), b.coefficients.size()), S(0));
  for (std::size_t k = 0; k < b.coefficients.size(); ++k) sum[k] += b.coefficients[k];
  return Polynomial<S>(std::move(sum));
}

template <class S>
Polynomial<S> operator-(const Polynomial<S>& a, const Polynomial<S>& b) {
  return a + scaled(b, S(-1));
}

template <class S>
Polynomial<S> operator*(const Polynomial<S>& a, const Polynomial<S>& b) {
  if (a.is_zero() || b.is_zero()) return {};
  std::vector<S> product(a.coefficients.size() + b.coefficients.size() - 1, S(0));
  for (std::size_t i = 0; i < a.coefficients.size(); ++i) {
    if (a.coefficients[i].is_zero()) continue;
    for (std::size_t j = 0; j < b.coefficients.size(); ++j) product[i + j] += a.coefficients[i] * b.coefficients[j];
  }
  return Polynomial<S>(std::move(product));
}

template <class S>
std::pair<Polynomial<S>, Polynomial<S>> divide(const Polynomial<S>& a, const Polynomial<S>& b) {
  if (b.is_zero()) throw Error(ErrorKind::input, "E_DIV0", "division of a polynomial by the zero polynomial");
  if (a.degree() < b.degree()) return {Polynomial<S>(), a};
  std::vector<S> rest = a.coefficients, quotient(index(a.degree() - b.degree()) + 1, S(0));
  const S inverse = S(1) / b.coefficients.back();
  for (std::size_t k = quotient.size(); k-- > 0;) {
    quotient[k] = rest[k + index(b.degree())] * inverse;
    if (quotient[k].is_zero()) continue;
    for (std::size_t j = 0; j < b.coefficients.size(); ++j) rest[k + j] -= quotient[k] * b.coefficients[j];
  }
  return {Polynomial<S>(std::move(quotient)), Polynomial<S>(std::move(rest))};
}

template <class S>
Polynomial<S> gcd(const Polynomial<S>& a, const Polynomial<S>& b) {
  Polynomial<S> x = a.monic(), y = b.monic();
  while (!y.is_zero()) {
    Polynomial<S> rest = divide(x, y).second.monic();
    x = std::exchange(y, std::move(rest));
  }
  return x;
}

template <class S>
std::vector<std::pair<Polynomial<S>, int>> square_free_factors(const Polynomial<S>& p) {
  std::vector<std::pair<Polynomial<S>, int>> result;
  if (p.degree() < 1) return result;
  const Polynomial<S> monic = p.monic(), slope = monic.derivative(), common = gcd(monic, slope);
  Polynomial<S> rest = divide(monic, common).first;
  Polynomial<S> defect = divide(slope, common).first - rest.derivative();
  for (int multiplicity = 1; rest.degree() > 0; ++multiplicity) {
    const Polynomial<S> factor = gcd(rest, defect);
    rest = divide(rest, factor).first;
    defect = divide(defect, factor).first - rest.derivative();
    if (factor.degree() > 0) result.emplace_back(factor, multiplicity);
  }
  return result;
}

template <class S>
std::vector<RealRoot> real_roots(const Polynomial<S>& p, const Rational& width) {
  if (width.sign() <= 0)
    throw Error(ErrorKind::internal, "E_INTERNAL", "real_roots needs a positive width, not " + width.to_string());
  const auto factors = square_free_factors(p);
  std::vector<RealRoot> roots;
  if (factors.empty()) return roots;
  Polynomial<S> product({S(1)});
  for (const auto& [factor, multiplicity] : factors) product = product * factor;
  const SturmChain<S> chain(product);
  const Rational bound = root_bound(product);
  isolate(chain, Rational(-bound), chain.changes(-bound), bound, chain.changes(bound), roots);
  for (std::size_t k = 0; k < roots.size(); ++k) {
    while (roots[k].upper - roots[k].lower > width ||
           (k > 0 && roots[k].lower == roots[k - 1].upper && roots[k].lower != roots[k].upper))
      halve(chain, roots[k]);
  }
  for (RealRoot& root : roots) {
    for (const auto& [factor, multiplicity] : factors) {
      const int low = factor.at(S(root.lower)).sign();
      if (low == 0 || low != factor.at(S(root.upper)).sign()) root.multiplicity = multiplicity;
    }
  }
  return roots;
}

#define UDCP_INSTANTIATE(S)                                                                            \
  template struct Polynomial<S>;                                                                       \
  template Polynomial<S> operator+(const Polynomial<S>&, const Polynomial<S>&);                        \
  template Polynomial<S> operator-(const Polynomial<S>&, const Polynomial<S>&);                        \
  template Polynomial<S> operator*(const Polynomial<S>&, const Polynomial<S>&);                        \
  template std::pair<Polynomial<S>, Polynomial<S>> divide(const Polynomial<S>&, const Polynomial<S>&); \
  template Polynomial<S> gcd(const Polynomial<S>&, const Polynomial<S>&);                              \
  template std::vector<std::pair<Polynomial<S>, int>> square_free_factors(const Polynomial<S>&);       \
  template std::vector<RealRoot> real_roots(const Polynomial<S>&, const Rational&);
UDCP_INSTANTIATE(Rational)
UDCP_INSTANTIATE(Algebraic)
#undef UDCP_INSTANTIATE

}  // namespace udcp
