// The minimal polynomial of 2 cos(2 pi/N) from the N-th cyclotomic polynomial, and products and sums of cosines modulo it.
#include "operators/numbers/field.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <mutex>

#include "operators/error.h"

namespace udcp {
namespace {

using Polynomial = std::vector<Rational>;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

int totient(int n) {
  int count = n;
  for (int p = 2, rest = n; p <= rest; ++p) {
    if (rest % p != 0) continue;
    count -= count / p;
    while (rest % p == 0) rest /= p;
  }
  return count;
}

// The sum of weights[k] e_k, with weights[0] counting the number 1, as a polynomial in c; reduce(p) keeps the degree down.
template <class Reduce>
Polynomial expand(const Polynomial& weights, std::size_t size, Reduce reduce) {
  Polynomial sum(size);
  Polynomial before{Rational(2)};
  Polynomial current{Rational(0), Rational(1)};
  sum[0] = weights[0];
  for (std::size_t k = 1; k < weights.size(); ++k) {
    for (std::size_t i = 0; i < current.size() && !weights[k].is_zero(); ++i) sum[i] += weights[k] * current[i];
    Polynomial next(current);
    next.insert(next.begin(), Rational(0));
    for (std::size_t i = 0; i < before.size(); ++i) next[i] -= before[i];
    reduce(next);
    before = std::move(current);
    current = std::move(next);
  }
  return sum;
}

// The first half of the N-th cyclotomic polynomial as a power series: the product of (1 - z^d)^moebius(N/d). Unsigned arithmetic
// wraps, which is harmless: the result is right modulo 2^64 and small.
std::vector<std::uint64_t> half_cyclotomic(int order, int degree) {
  std::vector<std::uint64_t> series(at(degree + 1), 0);
  series[0] = 1;
  for (int d = 1; d <= std::min(order, degree); ++d) {
    const int power = order % d == 0 ? moebius(order / d) : 0;
    if (power > 0) {
      for (int i = degree; i >= d; --i) series[at(i)] -= series[at(i - d)];
    } else if (power < 0) {
      for (int i = d; i <= degree; ++i) series[at(i)] += series[at(i - d)];
    }
  }
  return series;
}

}  // namespace

int moebius(int n) {
  int sign = 1;
  for (int p = 2; p <= n; ++p) {
    if (n % p != 0) continue;
    n /= p;
    if (n % p == 0) return 0;
    sign = -sign;
  }
  return sign;
}

bool Algebraic::Field::within_limit(int order) { return order <= largest_order && totient(order) / 2 <= largest_degree; }

void Algebraic::Field::reduce(Polynomial& p) const {
  for (std::size_t top = p.size(); top-- > at(degree);) {
    const Rational lead = p[top];
    if (lead.is_zero()) continue;
    for (std::size_t i = 0; i < at(degree); ++i) {
      if (!minimal[i].is_zero()) p[top - at(degree) + i] -= lead * minimal[i];
    }
  }
  p.resize(at(degree));
}

Polynomial Algebraic::Field::product(const Polynomial& a, const Polynomial& b) const {
  Polynomial result(a.size() + b.size() - 1);
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i].is_zero()) continue;
    for (std::size_t j = 0; j < b.size(); ++j) result[i + j] += a[i] * b[j];
  }
  reduce(result);
  return result;
}

Polynomial Algebraic::Field::from_cosines(const std::vector<std::pair<int, Rational>>& terms) const {
  int last = 1;
  const auto folded = [this](int k) { return std::min(k % order, order - k % order); };
  for (const auto& [k, weight] : terms) last = std::max(last, folded(k));
  Polynomial weights(at(last + 1));
  for (const auto& [k, weight] : terms) weights[at(folded(k))] += folded(k) == 0 ? Rational(2) * weight : weight;
  return expand(weights, at(degree), [this](Polynomial& p) {
    if (p.size() > at(degree)) reduce(p);
  });
}

std::shared_ptr<const Algebraic::Field> Algebraic::Field::of(int order) {
  if (!within_limit(order)) {
    throw Error(ErrorKind::limit, "E_FIELD_DEGREE",
                "the exact numbers with cos(2*pi/" + std::to_string(order) + ") form a field of a degree above " +
                    std::to_string(largest_degree),
                "use fewer different cosines together, or compute in enclosures or floating point");
  }
  // Immutable fields, made once: a cache, not state.
  static std::mutex mutex;
  static std::map<int, std::shared_ptr<const Field>> fields;
  const std::scoped_lock lock(mutex);
  std::shared_ptr<const Field>& known = fields[order];
  if (!known) {
    auto field = std::make_shared<Field>();
    field->order = order;
    field->degree = totient(order) / 2;
    const std::vector<std::uint64_t> series = half_cyclotomic(order, field->degree);
    Polynomial weights(series.size());
    for (std::size_t k = 0; k < series.size(); ++k) weights[k] = Rational(static_cast<long>(series[series.size() - 1 - k]));
    field->minimal = expand(weights, weights.size(), [](const Polynomial&) {});
    known = std::move(field);
  }
  return known;
}

}  // namespace udcp
