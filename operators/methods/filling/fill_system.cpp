// Numbering and equations of the fill. Polynomials here are plain lists of coefficients, lowest first.
#include "operators/methods/filling/fill_system.h"

#include <array>

namespace udcp {
namespace {

std::size_t at(int k) { return static_cast<std::size_t>(k); }

template <class S>
using Poly = std::vector<S>;

template <class S>
Poly<S> product(const Poly<S>& a, const Poly<S>& b) {
  Poly<S> result(a.size() + b.size() - 1, S(0));
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j) result[i + j] += a[i] * b[j];
  return result;
}

// sum += w * p
template <class S>
void accumulate(Poly<S>& sum, const S& w, const Poly<S>& p) {
  if (sum.size() < p.size()) sum.resize(p.size(), S(0));
  for (std::size_t i = 0; i < p.size(); ++i) sum[i] += w * p[i];
}

template <class S>
Poly<S> derivative(const Poly<S>& p) {
  Poly<S> result;
  for (std::size_t i = 1; i < p.size(); ++i) result.push_back(S(static_cast<int>(i)) * p[i]);
  return result;
}

int binomial(int n, int k) {
  int result = 1;
  for (int i = 1; i <= k; ++i) result = result * (n - k + i) / i;
  return result;
}

template <class S>
S fraction(int p, int q) {
  return S(p) / S(q);
}

/// sum of values[k] b_k as a power series.
template <class S>
Poly<S> from_bernstein(const std::vector<S>& values) {
  const int d = static_cast<int>(values.size()) - 1;
  Poly<S> result(values.size(), S(0));
  for (int k = 0; k <= d; ++k)
    for (int i = k; i <= d; ++i)
      result[at(i)] += S((i - k) % 2 == 0 ? 1 : -1) * S(binomial(d, k) * binomial(d - k, i - k)) * values[at(k)];
  return result;
}

/// Bernstein coefficient k in degree 7. Coefficients past t^7 are dropped: they vanish (and are rounding noise in double).
template <class S>
S bernstein(const Poly<S>& p, int k) {
  S result(0);
  for (int i = 0; i <= k && i < static_cast<int>(p.size()); ++i)
    result += fraction<S>(binomial(k, i), binomial(fill_degree, i)) * p[at(i)];
  return result;
}

}  // namespace

int ring_size(int valence, int rings) { return 1 + valence * rings * (rings + 1); }

int ring_number(int valence, int sector, int j, int k) {
  if (j == 0 && k == 0) return 0;
  if (k < 0) return ring_number(valence, sector - 1, -k, j);
  if (j < 0) return ring_number(valence, sector + 1, k, -j);
  if (j == 0) return ring_number(valence, sector + 1, k, 0);
  const int r = std::max(j, k), m = k == r && j < r ? 2 * r - j : k;
  const int i = (sector % valence + valence) % valence;
  return 1 + valence * r * (r - 1) + 2 * r * i + m;
}

NetEntry net_entry(int a, int b) {
  int sector = 0, j = a - 1, k = b - 1;
  if (k < 0) {
    const int old = j;
    --sector, j = -k, k = old;
  } else if (j < 0) {
    const int old = j;
    ++sector, j = k, k = -old;
  }
  if (j == 0 && k == 0) return {0, 0};
  if (j == 0) ++sector, j = k, k = 0;
  static constexpr std::array<std::array<int, 3>, 3> slots{{{0, 0, 0}, {1, 2, 6}, {3, 4, 5}}};
  return {sector, slots[at(j)][at(k)]};
}

template <class S>
Points<S> outer_map(const std::type_identity_t<S>& c) {
  const S two = c - S(2), three = S(2) * c - S(3);
  Points<S> y = Points<S>::Zero(5, 4);
  for (int i = 0; i < 5; ++i) y(i, 0) = y(i, 3) = fraction<S>(i, 4);
  y(1, 1) = (S(5) * c * c * c - S(3) * c * c - S(15) * c + S(18)) / (S(12) * two * three);
  y(1, 2) = (c * c + S(2) * c - S(6)) / (S(12) * two);
  y(2, 1) = (c + S(3)) / S(6);
  y(2, 2) = (c * c + S(3) * c - S(9)) / (S(9) * two);
  y(3, 1) = y(3, 2) = (c + S(9)) / S(12);
  y(4, 1) = y(4, 2) = S(1);
  y(0, 3) = S(0), y(4, 0) = S(1);
  return y;
}

template <class S>
OuterTraces<S> outer_traces(const Points<S>& map) {
  std::vector<S> x_u, x_uu, y_u, y_uu;
  for (int j = 0; j < 4; ++j) {  // x(u, t) = y(t, u): derivatives by the argument of degree 4, at its end 1
    x_u.push_back(S(4) * (map(4, j) - map(3, j)));
    x_uu.push_back(S(12) * (map(4, j) - S(2) * map(3, j) + map(2, j)));
  }
  for (int i = 0; i < 5; ++i) {
    y_u.push_back(S(3) * (map(i, 3) - map(i, 2)));
    y_uu.push_back(S(6) * (map(i, 3) - S(2) * map(i, 2) + map(i, 1)));
  }
  return {from_bernstein(x_u), from_bernstein(x_uu), from_bernstein(y_u), from_bernstein(y_uu)};
}

template <class S>
Points<S> outer_weights(const OuterTraces<S>& traces) {
  static constexpr int splines[4][4] = {{1, -3, 3, -1}, {4, 0, -6, 3}, {1, 3, 3, -3}, {0, 0, 0, 1}};
  // values at 1 of the four splines and of their derivatives, times 6
  static constexpr int value[4] = {0, 1, 4, 1}, first[4] = {0, -3, 0, 3}, second[4] = {0, 6, -12, 6};
  Points<S> result = Points<S>::Zero(fill_points, 16);
  for (int a = 0; a < 4; ++a) {
    for (int b = 0; b < 4; ++b) {
      Poly<S> n;
      for (const int coefficient : splines[b]) n.push_back(fraction<S>(coefficient, 6));
      const Poly<S> n1 = derivative(n), n2 = derivative(n1);
      const S v = fraction<S>(value[a], 6), v1 = fraction<S>(first[a], 6), v2 = fraction<S>(second[a], 6);
      Poly<S> d0, d1, d2;
      accumulate(d0, v, n);
      accumulate(d1, v1, product(n, traces.x_u));
      accumulate(d1, v, product(n1, traces.y_u));
      accumulate(d2, v2, product(n, product(traces.x_u, traces.x_u)));
      accumulate(d2, S(S(2) * v1), product(n1, product(traces.x_u, traces.y_u)));
      accumulate(d2, v, product(n2, product(traces.y_u, traces.y_u)));
      accumulate(d2, v1, product(n, traces.x_uu));
      accumulate(d2, v, product(n1, traces.y_uu));
      for (int k = 0; k <= fill_degree; ++k) {
        const S p7 = bernstein(d0, k), p6 = p7 - bernstein(d1, k) / S(7), p5 = bernstein(d2, k) / S(42) - p7 + S(2) * p6;
        const S* const rows[3] = {&p5, &p6, &p7};
        for (int j = 5; j <= fill_degree; ++j) {
          result(8 * j + k, 4 * a + b) = *rows[j - 5];
          if (k <= last_free) result(8 * k + j, 4 * b + a) = *rows[j - 5];  // on j, k >= 5 both sides agree
        }
      }
    }
  }
  return result;
}

namespace {

/// A linear form in the points of the two patches at an edge.
template <class S>
struct Form {
  std::vector<S> here = std::vector<S>(fill_points, S(0)), next = here;

  static Form p(int j, int k) {
    Form form;
    form.here[at(8 * j + k)] = S(1);
    return form;
  }
  static Form q(int j, int k) {
    Form form;
    form.next[at(8 * j + k)] = S(1);
    return form;
  }
  Form& add(const S& w, const Form& other) {
    for (std::size_t i = 0; i < here.size(); ++i) {
      here[i] += w * other.here[i];
      next[i] += w * other.next[i];
    }
    return *this;
  }
};

template <class S>
class EdgeForms {
 public:
  explicit EdgeForms(const S& cosine) : c(cosine) {}

  Form<S> position(int k) const { return Form<S>(p(0, k)).add(S(-1), q(k, 0)); }

  Form<S> tangent(int k) const {
    Form<S> form;
    if (k < 7) {
      const S w = c * S(7 - k);
      form.add(w, q(k + 1, 0)).add(S(-w), q(k, 0)).add(w, p(0, k + 1)).add(S(-w), p(0, k));
    }
    return form.add(S(-7), q(k, 1)).add(S(7), q(k, 0)).add(S(-7), p(1, k)).add(S(7), p(0, k));
  }

  Form<S> curvature(int k) const {
    Form<S> form;
    if (k < 8) form.add(S(14) * c * c * S(8 - k), slope(k)).add(S((S(1) + c) * S(8 - k)), bend(k));
    if (k > 0) form.add(S(k), bend(k - 1));
    return form;
  }

 private:
  static Form<S> p(int j, int k) { return Form<S>::p(j, k); }
  static Form<S> q(int j, int k) { return Form<S>::q(j, k); }
  static Form<S> slope(int k) { return Form<S>(q(k, 1)).add(S(-1), q(k, 0)).add(S(-1), p(1, k)).add(S(1), p(0, k)); }
  Form<S> bend(int k) const {
    Form<S> form;
    if (k < 7) form.add(S(14) * c * S(7 - k), slope(k + 1)).add(S(-14) * c * S(7 - k), slope(k));
    form.add(S(-42), q(k, 2)).add(S(84), q(k, 1)).add(S(-42), q(k, 0));
    return form.add(S(42), p(2, k)).add(S(-84), p(1, k)).add(S(42), p(0, k));
  }

  S c;
};

}  // namespace

template <class S>
EdgeEquations<S> edge_equations(const std::type_identity_t<S>& cosine) {
  const EdgeForms<S> forms(cosine);
  std::vector<Form<S>> rows;
  for (int k = 0; k < 8; ++k) rows.push_back(forms.position(k));
  for (int k = 0; k < 8; ++k) rows.push_back(forms.tangent(k));
  for (int k = 0; k < 9; ++k) rows.push_back(forms.curvature(k));
  EdgeEquations<S> result{Points<S>(25, fill_points), Points<S>(25, fill_points)};
  for (int row = 0; row < 25; ++row) {
    for (int i = 0; i < fill_points; ++i) {
      result.here(row, i) = rows[at(row)].here[at(i)];
      result.next(row, i) = rows[at(row)].next[at(i)];
    }
  }
  return result;
}

template <class S>
Points<S> fairness() {
  // Gram matrices of the Bernstein polynomials of degree 7 and, through fourth differences, of their fourth derivatives.
  const auto gram = [](int d, int i, int j) {
    return fraction<S>(binomial(d, i) * binomial(d, j), (2 * d + 1) * binomial(2 * d, i + j));
  };
  Points<S> g = Points<S>::Zero(8, 8), k = Points<S>::Zero(8, 8);
  for (int i = 0; i < 8; ++i)
    for (int j = 0; j < 8; ++j) g(i, j) = gram(7, i, j);
  for (int r = 0; r < 4; ++r)
    for (int s = 0; s < 4; ++s)
      for (int i = 0; i < 5; ++i)
        for (int j = 0; j < 5; ++j)
          k(r + i, s + j) += S(840 * 840 * ((i + j) % 2 == 0 ? 1 : -1) * binomial(4, i) * binomial(4, j)) * gram(3, r, s);
  Points<S> result(fill_points, fill_points);
  for (int a = 0; a < fill_points; ++a)
    for (int b = 0; b < fill_points; ++b) result(a, b) = k(a / 8, b / 8) * g(a % 8, b % 8) + g(a / 8, b / 8) * k(a % 8, b % 8);
  return result;
}

int fill_rank(int valence, int frequency) {
  const int f = (frequency % valence + valence) % valence;
  if (valence == 4) return f == 0 ? 12 : 13;
  const auto is = [&](int g) { return f == ((g % valence) + valence) % valence; };
  int result = 16 - (is(0) ? 2 : 0) - (is(1) ? 1 : 0) - (is(-1) ? 1 : 0) - (is(2) ? 1 : 0) - (is(-2) ? 1 : 0);
  if (valence == 3 || valence == 6) result -= is(3) ? 1 : 0;
  return result;
}

#define UDCP_INSTANTIATE(S)                                                    \
  template Points<S> outer_map<S>(const std::type_identity_t<S>&);             \
  template OuterTraces<S> outer_traces(const Points<S>&);                      \
  template Points<S> outer_weights(const OuterTraces<S>&);                     \
  template EdgeEquations<S> edge_equations<S>(const std::type_identity_t<S>&); \
  template Points<S> fairness<S>();
UDCP_FOR_EACH_COORDINATE(UDCP_INSTANTIATE)
#undef UDCP_INSTANTIATE

}  // namespace udcp
