// The outer side of the fill in exact numbers: the bicubic ring over psi as a series across the boundary; and the printed
// formulas that contradict themselves or flat surfaces.
#include "proofs/fill_facts.h"
#include "proofs/static_word.h"
#include "proofs/surface_facts.h"

namespace udcp {
namespace {

using Number = Algebraic;
using Poly = Polynomial<Number>;
using Series = std::array<Poly, 3>;  // powers of h, without h^3 and on
std::size_t at(int k) { return static_cast<std::size_t>(k); }

struct Name {
  Print print;
  const char* name;
};
constexpr Name names[] = {{Print::psi_x_u, "psi_x_u"},
                          {Print::psi_y_u, "psi_y_u"},
                          {Print::psi_x_uu, "psi_x_uu"},
                          {Print::psi_y_uu, "psi_y_uu"},
                          {Print::net, "net"},
                          {Print::phi, "phi"},
                          {Print::points, "points"},
                          {Print::power_basis, "power_basis"},
                          {Print::psi_symmetry, "psi_symmetry"}};

Number cosine_of(int valence) { return Number::cosine(Rational(2) / Rational(valence)); }
Number ratio(int p, int q) { return Number(Rational(p) / Rational(q)); }
int binomial(int n, int k) {
  int result = 1;
  for (int i = 1; i <= k; ++i) result = result * (n - k + i) / i;
  return result;
}

Poly power(const Poly& p, int exponent) {
  Poly result({Number(1)});
  for (int i = 0; i < exponent; ++i) result = result * p;
  return result;
}

/// C(d,k) t^k (1-t)^(d-k).
Poly bernstein(int d, int k) {
  return Poly({Number(binomial(d, k))}) * power(Poly({Number(0), Number(1)}), k) * power(Poly({Number(1), Number(-1)}), d - k);
}

/// b_k at 1 - h.
std::array<Number, 3> bernstein_near_one(int d, int k) {
  std::array<Number, 3> result{Number(0), Number(0), Number(0)};
  const int low = d - k;  // C(d,k) h^low (1-h)^k
  for (int power_of_h = low; power_of_h < 3; ++power_of_h) {
    const int m = power_of_h - low;
    if (m <= k) result[at(power_of_h)] = Number(binomial(d, k) * binomial(k, m) * (m % 2 == 0 ? 1 : -1));
  }
  return result;
}

Series operator*(const Series& a, const Series& b) {
  Series result;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; i + k < 3; ++k) result[i + k] = result[i + k] + a[i] * b[k];
  return result;
}

/// The spline N_a of the uniform cubic B-spline segment.
Series spline(int a, const Series& x) {
  static constexpr int coefficients[4][4] = {{1, -3, 3, -1}, {4, 0, -6, 3}, {1, 3, 3, -3}, {0, 0, 0, 1}};
  Series sum;
  for (int i = 3; i >= 0; --i) {
    sum = sum * x;
    sum[0] = sum[0] + Poly({ratio(coefficients[a][i], 6)});
  }
  return sum;
}

/// The printed derivative of psi on u = 1.
Poly printed_trace(const Number& c, Print print) {
  const Number two = c - Number(2), three = Number(2) * c - Number(3), half = ratio(1, 2);
  const auto term = [](const Number& factor, int t, int s) {
    return Poly({factor}) * power(Poly({Number(0), Number(1)}), t) * power(Poly({Number(1), Number(-1)}), s);
  };
  switch (print) {
    case Print::psi_x_u:
      return term(-half, 0, 3) + term(ratio(-3, 2) * (c + Number(1)), 1, 2) + term(ratio(-3, 2) * (c + Number(1)), 2, 1) +
             term(-half, 3, 0);
    case Print::psi_y_u:
      return term((c - c * c) / two, 1, 3) + term((Number(-2) * c * c + ratio(33, 2) * c - Number(27)) / two, 2, 2) +
             term(ratio(-3, 2) * (c + Number(9)), 3, 1);
    case Print::psi_x_uu:
      return term(Number(-9), 0, 3) + term(Number(-3) * (c + Number(9)), 1, 2) +
             term(Number(3) * (c * c + Number(3) * c - Number(6)) / two, 2, 1) + term(Number(-9), 3, 0);
    default:  // psi_y_uu
      return term((Number(2) * c * c * c + Number(2) * c * c) / (two * three), 1, 3) + term(Number(-2) * c * c / two, 2, 2) +
             term(Number(-3) * c, 3, 1);
  }
}

/// The coefficients of a polynomial, at least one.
std::vector<Number> coefficients(const Poly& p) { return p.is_zero() ? std::vector<Number>{Number(0)} : p.coefficients; }

/// Sums of weights times b_k over the rows `row(k)`.
template <class Row>
Poly side_of(const Points<Number>& weights, int column, Row row) {
  Poly sum;
  for (int k = 0; k <= fill_degree; ++k) sum = sum + Poly({weights(row(k), column)}) * bernstein(fill_degree, k);
  return sum;
}

/// The patch next to a side as a series, from the rows of Bezier points 7, 6 and 5.
template <class Row>
Series patch_series(const Points<Number>& weights, int column, Row row) {
  const Poly p7 = side_of(weights, column, [&](int k) { return row(7, k); });
  const Poly p6 = side_of(weights, column, [&](int k) { return row(6, k); });
  const Poly p5 = side_of(weights, column, [&](int k) { return row(5, k); });
  return {p7, Poly({Number(-7)}) * (p7 - p6), Poly({Number(21)}) * (p7 - p6 - p6 + p5)};
}

}  // namespace

std::string to_string(Print print) {
  for (const Name& entry : names)
    if (entry.print == print) return entry.name;
  return {};
}

std::optional<Print> print_named(const std::string& name) {
  for (const Name& entry : names)
    if (name == entry.name) return entry.print;
  return std::nullopt;
}

std::vector<std::string> print_names() {
  std::vector<std::string> result;
  for (const Name& entry : names) result.emplace_back(entry.name);
  return result;
}

OuterSeries outer_series(int valence, Print print) {
  const Number c = cosine_of(valence);
  const Points<Number> map = outer_map<Number>(c);
  OuterSeries result;
  for (int i = 0; i < 5; ++i) {
    for (int j = 0; j < 4; ++j) {
      const auto across_x = bernstein_near_one(4, i), across_y = bernstein_near_one(3, j);
      for (std::size_t h = 0; h < 3; ++h) {  // x(u, v) = y(v, u)
        result.x[h] = result.x[h] + Poly({map(i, j) * across_x[h]}) * bernstein(3, j);
        result.y[h] = result.y[h] + Poly({map(i, j) * across_y[h]}) * bernstein(4, i);
      }
    }
  }
  const Poly minus({Number(-1)}), half({ratio(1, 2)});
  if (print == Print::psi_x_u) result.x[1] = minus * printed_trace(c, print);
  if (print == Print::psi_y_u) result.y[1] = minus * printed_trace(c, print);
  if (print == Print::psi_x_uu) result.x[2] = half * printed_trace(c, print);
  if (print == Print::psi_y_uu) result.y[2] = half * printed_trace(c, print);
  return result;
}

Points<Number> weights_of(const OuterSeries& series) {
  const Poly minus({Number(-1)}), two({Number(2)});
  return outer_weights(OuterTraces<Number>{coefficients(minus * series.x[1]), coefficients(two * series.x[2]),
                                           coefficients(minus * series.y[1]), coefficients(two * series.y[2])});
}

std::string outer_residual(const OuterSeries& series, const Points<Number>& weights) {
  for (int a = 0; a < 4; ++a) {
    for (int b = 0; b < 4; ++b) {
      const int column = 4 * a + b;
      const std::string where = "point (" + std::to_string(a) + "," + std::to_string(b) + ") of the net: the ";
      static constexpr const char* order[] = {"value", "first derivative", "second derivative"};
      const Series right = patch_series(weights, column, [](int j, int k) { return 8 * j + k; });
      const Series expected_right = spline(a, series.x) * spline(b, series.y);
      const Series top = patch_series(weights, column, [](int j, int k) { return 8 * k + j; });
      const Series expected_top = spline(a, series.y) * spline(b, series.x);
      for (std::size_t h = 0; h < 3; ++h) {
        if (!(right[h] == expected_right[h])) return where + order[h] + " on u = 1 is not that of the ring";
        if (!(top[h] == expected_top[h])) return where + order[h] + " on v = 1 is not that of the ring";
      }
    }
  }
  return {};
}

bool is_regular_outside(const OuterSeries& series) {
  if (!(series.x[0] == Poly({Number(1)})) || !(series.y[0] == Poly({Number(0), Number(1)}))) return false;
  const Poly x_u = Poly({Number(-1)}) * series.x[1];
  const int d = std::max(0, x_u.degree());
  for (int k = 0; k <= d; ++k) {  // Bernstein coefficients
    Number value(0);
    for (int i = 0; i <= k && i <= x_u.degree(); ++i) value += ratio(binomial(k, i), binomial(d, i)) * x_u.coefficients[at(i)];
    if (!(value > Number(0))) return false;
  }
  return true;
}

namespace {

/// A point with its second coordinate over sin(2 pi/n): all in the field.
struct Flat {
  Number x, y;
};
Flat turn(const Flat& p, const Number& c) { return {c * p.x + (c * c - Number(1)) * p.y, p.x + c * p.y}; }

/// A map of the square, bilinear: coefficients of 1, u, v, uv.
struct Bilinear {
  std::array<Number, 4> x, y;
  [[nodiscard]] Flat at(const Number& u, const Number& v) const {
    const auto value = [&](const std::array<Number, 4>& a) { return a[0] + a[1] * u + a[2] * v + a[3] * u * v; };
    return {value(x), value(y)};
  }
};
Bilinear inner_map(const Number& c) {
  const Number zero(0), one(1);
  return {{zero, one, c, -c}, {zero, zero, one, one / (one + c) - one}};
}

/// (2) for the patches that a map and its rotations are: both sides are linear in t.
std::string position_residual(const Bilinear& map, const Number& c) {
  for (const int t : {0, 1}) {
    const Flat p = map.at(Number(0), Number(t)), q = turn(map.at(Number(t), Number(0)), c);
    if (p.x != q.x || p.y != q.y) return "P_i(0,t) and P_(i+1)(t,0) differ at t = " + std::to_string(t) + " on the flat surface";
  }
  return {};
}

/// The Bezier points of a flat fill: p of a patch, q of the next.
struct FlatPoints {
  Bilinear map;
  Number c;
  [[nodiscard]] Flat p(int j, int k) const { return map.at(ratio(j, 7), ratio(k, 7)); }
  [[nodiscard]] Flat q(int j, int k) const { return turn(p(j, k), c); }
};

std::string power_basis_residual(const FlatPoints& flat) {
  // The equation of t^1 at points that are all 1: c(-7 alpha1 - 8 alpha2 + 2 alpha3) + (7 beta1 - beta2), the betas being
  // differences.
  if (!(flat.c * (Number(-7) * Number(-14) - Number(8) * Number(14) + Number(2) * Number(42))).is_zero())
    return "the equation of t fails where all points coincide, as its weights do not sum to 0";
  // The equation of t^0: c(alpha1 + alpha2) - beta1.
  const Number alpha = Number(7) * (flat.q(1, 0).x + flat.p(0, 1).x - flat.q(0, 0).x - flat.p(0, 0).x);
  const Number beta = Number(7) * (flat.q(0, 0).x - flat.q(0, 1).x + flat.p(1, 0).x - flat.p(0, 0).x);
  return (flat.c * alpha - beta).is_zero() ? "" : "the equation of t^0 fails on the flat surface";
}

}  // namespace

std::string contradiction(int valence, Print print) {
  const Number c = cosine_of(valence), zero(0), one(1);
  const FlatPoints flat{inner_map(c), c};
  if (print == Print::none) return position_residual(flat.map, c);
  if (print == Print::phi) {
    if (c.is_zero()) return "sec(2 pi/4) is infinite";
    return position_residual({{one, zero, c, -c}, {zero, zero, one, one / c - one}}, c);
  }
  if (print == Print::points) {
    const Flat p = flat.p(0, 0), q = flat.q(0, 7);
    return p.x == q.x && p.y == q.y ? "" : "the centre of the flat surface is not a point of its outer boundary";
  }
  if (print == Print::power_basis) return power_basis_residual(flat);
  if (print == Print::psi_symmetry) {
    // y(1, t) and y(t, 1) from the matrix
    const OuterSeries series = outer_series(valence);
    return series.y[0] == series.x[0] ? ""
                                      : "psi is the identity on u = 1 and on v = 1, so y(1,t) = t and y(t,1) = 1 would be equal";
  }
  return {};
}

void require_bicubic_ring(const Json& json, int valence) {
  const Word word = surface_word_from(json, valence);
  require(!word.triangles && is_rational_word(json), "the word must have rational parameters and act on quads");
  const SurfaceFacts<Rational> facts = surface_facts<Rational>(word, valence);
  require(is_bicubic(facts.part.mask), "the limit surface of the word is not bicubic where it is regular");
}

std::string g2_statement(const Json& word, int valence, const Rational& mask_error) {
  return "around vertices of valence " + std::to_string(valence) +
         " patches of bidegree 7 join with G2 with each other and with the " + "bicubic limit surface of " + describe(word) +
         " wherever they are regular; they exist for every ring of points, one choice is fairest, and the weights of the masks "
         "in " +
         "double precision are those of that choice up to " + mask_error.to_string();
}

std::string print_failure(int valence, Print print) {
  std::string failure = contradiction(valence, print);
  if (!failure.empty()) return failure;
  const OuterSeries series = outer_series(valence, print);
  const Points<Algebraic> weights = weights_of(series);
  failure = outer_residual(series, weights);
  if (!failure.empty()) return failure;
  for (int f = 0; 2 * f <= valence; ++f)
    if (!frequency_facts(valence, f, weights, print).consistent)
      return "the equations of the joins contradict each other at frequency " + std::to_string(f);
  return {};
}

std::string print_statement(int valence, Print print, const std::string& failure) {
  return "with " + to_string(print) + " as printed there is no G2 fill of valence " + std::to_string(valence) + ": " + failure;
}

}  // namespace udcp
