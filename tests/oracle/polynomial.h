// Laurent polynomials in one or two variables, for the symbols of masks: just enough to multiply, add and divide exactly.
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "operators/matrix.h"

namespace udcp::oracle {

template <class S>
using Polynomial = std::vector<S>;  // lowest first

template <class S>
Polynomial<S> times(const Polynomial<S>& a, const Polynomial<S>& b) {
  Polynomial<S> result(a.size() + b.size() - 1, S(0));
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j) result[i + j] += a[i] * b[j];
  return result;
}

template <class S>
Polynomial<S> power(const Polynomial<S>& a, int n) {
  Polynomial<S> result{S(1)};
  for (int k = 0; k < n; ++k) result = times(result, a);
  return result;
}

/// Remainder of a by a divisor with leading coefficient 1.
template <class S>
Polynomial<S> remainder(Polynomial<S> a, const Polynomial<S>& divisor) {
  while (a.size() >= divisor.size()) {
    const S lead = a.back();
    for (std::size_t k = 0; k < divisor.size(); ++k) a[a.size() - divisor.size() + k] -= lead * divisor[k];
    a.pop_back();
  }
  return a;
}

/// Exponents (x, y) to coefficients; zeros may be present.
template <class S>
using Laurent = std::map<std::pair<int, int>, S>;

template <class S>
Laurent<S> operator*(const Laurent<S>& a, const Laurent<S>& b) {
  Laurent<S> result;
  for (const auto& [p, s] : a)
    for (const auto& [q, t] : b) result[{p.first + q.first, p.second + q.second}] += s * t;
  return result;
}

template <class S>
Laurent<S> operator*(const S& factor, Laurent<S> a) {
  for (auto& [p, s] : a) s *= factor;
  return a;
}

template <class S>
Laurent<S> operator+(Laurent<S> a, const Laurent<S>& b) {
  for (const auto& [p, s] : b) a[p] += s;
  return a;
}

/// A mask as a polynomial in the first (0) or second (1) variable.
template <class S>
Laurent<S> symbol(const Mask<S>& mask, int variable) {
  Laurent<S> result;
  for (std::size_t k = 0; k < mask.coefficients.size(); ++k) {
    const int exponent = mask.first + static_cast<int>(k);
    result[variable == 0 ? std::pair{exponent, 0} : std::pair{0, exponent}] = mask.coefficients[k];
  }
  return result;
}

}  // namespace udcp::oracle
