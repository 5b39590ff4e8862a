// Stability of the shifts of a basic limit function, from the zeros of its symbol on the unit circle. Exact; no search.
#include <algorithm>
#include <numeric>

#include "proofs/symbol.h"

namespace udcp {
namespace {

std::size_t index(int k) { return static_cast<std::size_t>(k); }

template <class S>
Polynomial<S> without_factor(Polynomial<S> p, const Polynomial<S>& factor) {
  for (;;) {
    auto [quotient, rest] = divide(p, factor);
    if (!rest.is_zero() || p.degree() < factor.degree()) return p;
    p = std::move(quotient);
  }
}

template <class S>
Polynomial<S> reversed(const Polynomial<S>& p) {
  std::vector<S> c = p.coefficients;
  std::reverse(c.begin(), c.end());
  return Polynomial<S>(std::move(c));
}

/// Does a polynomial have a zero of modulus 1? Those are common zeros with the reversed polynomial; without 1 and -1 what is
/// common is z^d q(z + 1/z), and zeros of modulus 1 are those of q between -2 and 2.
template <class S>
bool has_unit_zero(const Polynomial<S>& p) {
  if (p.at(S(1)).is_zero() || p.at(S(-1)).is_zero()) return true;
  Polynomial<S> common = gcd(p, reversed(p));
  const int half = common.degree() / 2;
  Polynomial<S> q, before({S(2)}), now({S(0), S(1)});  // now: z^k + z^-k as a polynomial in z + 1/z
  for (int k = 0; k <= half; ++k) {
    const S& c = common.coefficients[index(half - k)];
    q = q + Polynomial<S>({c}) * (k == 0 ? Polynomial<S>({S(1)}) : now);
    if (k > 0) before = std::exchange(now, Polynomial<S>({S(0), S(1)}) * now - before);
  }
  Rational width(1);
  for (;; width /= Rational(16)) {  // until no interval straddles 2 or -2, which are no zeros
    bool straddles = false;
    for (const RealRoot& root : real_roots(q, width)) {
      if (root.lower > Rational(-2) && root.upper < Rational(2)) return true;
      straddles = straddles || (root.upper > Rational(-2) && root.lower < Rational(2));
    }
    if (!straddles) return false;
  }
}

int totient(int n) {
  int result = n;
  for (int p = 2; p * p <= n; ++p) {
    if (n % p != 0) continue;
    result -= result / p;
    while (n % p == 0) n /= p;
  }
  return n > 1 ? result - result / n : result;
}

/// The polynomial of the primitive 2n-th roots of unity, n odd: z^n + 1 without those of the divisors of n.
template <class S>
Polynomial<S> cyclotomic_of_double(int n) {
  Polynomial<S> p = Polynomial<S>::monomial(S(1), n) + Polynomial<S>({S(1)});
  for (int d = 1; d < n; d += 2)
    if (n % d == 0) p = divide(p, cyclotomic_of_double<S>(d)).first;
  return p;
}

int field_degree(const Polynomial<Rational>&) { return 1; }
int field_degree(const Polynomial<Algebraic>& p) {
  int order = 1;
  for (const Algebraic& c : p.coefficients) order = std::lcm(order, c.field_order());
  return order > 2 ? totient(order) / 2 : 1;
}

}  // namespace

template <class S>
Stability stability(const Mask<S>& mask) {
  if (interpolates(mask)) return Stability::stable;
  if (mask.arity != 2 || mask.coefficients.empty()) return Stability::unknown;
  const Polynomial<S> a = symbol(mask);
  std::vector<S> mirrored = a.coefficients;  // a(-z)
  for (std::size_t k = 1; k < mirrored.size(); k += 2) mirrored[k] = -mirrored[k];
  const Polynomial<S> pairs = gcd(a, Polynomial<S>(std::move(mirrored)));  // in z^2
  std::vector<S> squares;
  for (std::size_t k = 0; k < pairs.coefficients.size(); k += 2) squares.push_back(pairs.coefficients[k]);
  if (has_unit_zero(Polynomial<S>(std::move(squares)))) return Stability::unstable;
  const Polynomial<S> rest = without_factor(a, Polynomial<S>({S(1), S(1)}));
  const int degree = rest.degree() * field_degree(rest);
  if (degree > 60) return Stability::unknown;
  for (int n = 3; n <= 2 * degree * degree; n += 2) {  // totient(n)^2 >= n/2
    if (totient(n) > degree) continue;
    const Polynomial<S> cycle = cyclotomic_of_double<S>(n), common = gcd(rest, cycle);
    if (common.degree() == cycle.degree()) return Stability::unstable;
    if (common.degree() > 0) return Stability::unknown;
  }
  return Stability::stable;
}

template Stability stability(const Mask<Rational>&);
template Stability stability(const Mask<Algebraic>&);

}  // namespace udcp
