// The fill in exact numbers. Frequencies need w = exp(2 pi i/n): numbers a + b j with a, b in Q(cos(2 pi/n)) and
// j = i sin(2 pi/n), so that j^2 = cos^2 - 1 is in the field.
#include "proofs/fill_facts.h"

#include <algorithm>

#include "operators/interrupt.h"
#include "proofs/linear_algebra.h"

namespace udcp {
namespace {

using Number = Algebraic;
using Poly = Polynomial<Number>;
using Matrix = Points<Number>;
std::size_t at(int k) { return static_cast<std::size_t>(k); }

Number cosine_of(int valence, int multiple = 1) { return Number::cosine(Rational(2 * multiple) / Rational(valence)); }

/// w^k = re + im j.
struct Root {
  Number re, im;
};
Root root(int valence, int k) {
  const int p = ((k % valence) + valence) % valence;
  Number before(0), im(p == 0 ? 0 : 1);  // sin(p x)/sin(x) by its recursion
  for (int i = 1; i < p; ++i) {
    Number next = Number(2) * cosine_of(valence) * im - before;
    before = std::move(im);
    im = std::move(next);
  }
  return {cosine_of(valence, p), im};
}

/// re + im j, entry by entry.
struct Split {
  Matrix re, im;
  Split(Eigen::Index rows, Eigen::Index columns) : re(Matrix::Zero(rows, columns)), im(Matrix::Zero(rows, columns)) {}
};

const std::vector<int>& points_where(bool free) {
  static const auto lists = [] {
    std::array<std::vector<int>, 2> result;
    for (int i = 0; i < fill_points; ++i) result[i / 8 <= last_free && i % 8 <= last_free ? 1 : 0].push_back(i);
    return result;
  }();
  return lists[free ? 1 : 0];
}

/// here + w^f next on some of the points.
Split restricted(const EdgeEquations<Number>& edge, const Root& turn, const std::vector<int>& points) {
  Split result(edge.here.rows(), static_cast<Eigen::Index>(points.size()));
  for (std::size_t k = 0; k < points.size(); ++k) {
    for (Eigen::Index row = 0; row < edge.here.rows(); ++row) {
      const auto column = static_cast<Eigen::Index>(k);
      result.re(row, column) = edge.here(row, points[k]) + turn.re * edge.next(row, points[k]);
      result.im(row, column) = turn.im * edge.next(row, points[k]);
    }
  }
  return result;
}

/// a b for numbers re + im j.
Split product(const Split& a, const Split& b, const Number& square) {
  Split result(a.re.rows(), b.re.cols());
  const auto accumulate = [](Matrix& to, const Matrix& x, const Matrix& y, const Number& factor) {
    for (Eigen::Index i = 0; i < x.rows(); ++i)
      for (Eigen::Index k = 0; k < x.cols(); ++k)
        for (Eigen::Index j = 0; j < y.cols() && !x(i, k).is_zero(); ++j)
          if (!y(k, j).is_zero()) to(i, j) += factor * x(i, k) * y(k, j);
  };
  accumulate(result.re, a.re, b.re, Number(1));
  accumulate(result.re, a.im, b.im, square);
  accumulate(result.im, a.re, b.im, Number(1));
  accumulate(result.im, a.im, b.re, Number(1));
  return result;
}

/// Re and im parts below one another: the rows that a system over a + b j means for a and b. `real`: no j occurs.
Matrix stacked(const Split& a, const Number& square, bool real) {
  if (real) return a.re;
  Matrix result(2 * a.re.rows(), 2 * a.re.cols());
  for (Eigen::Index i = 0; i < a.re.rows(); ++i)
    for (Eigen::Index k = 0; k < a.re.cols(); ++k) {
      result(i, k) = result(a.re.rows() + i, a.re.cols() + k) = a.re(i, k);
      result(i, a.re.cols() + k) = square * a.im(i, k);
      result(a.re.rows() + i, k) = a.im(i, k);
    }
  return result;
}
Matrix stacked_columns(const Split& a, bool real) {
  if (real) return a.re;
  Matrix result(2 * a.re.rows(), a.re.cols());
  result.topRows(a.re.rows()) = a.re;
  result.bottomRows(a.re.rows()) = a.im;
  return result;
}
Split unstacked(const Matrix& a, bool real) {
  const Eigen::Index rows = real ? a.rows() : a.rows() / 2;
  Split result(rows, a.cols());
  result.re = a.topRows(rows);
  if (!real) result.im = a.bottomRows(rows);
  return result;
}

NetEntry entry_of(int a, int b, Print print) {
  return print == Print::net && a == 0 && b == 3 ? NetEntry{1, 6} : net_entry(a, b);
}

/// The fixed points by the six points of a sector, for frequency 0 also by the centre.
Split fixed_rows(int valence, int frequency, const Matrix& weights, Print print) {
  const std::vector<int>& fixed = points_where(false);
  Split rows(static_cast<Eigen::Index>(fixed.size()), frequency == 0 ? 7 : 6);
  for (int a = 0; a < 4; ++a) {
    for (int b = a == 0 ? 1 : 0; b < 4; ++b) {
      const NetEntry entry = entry_of(a, b, print);
      if (entry.slot == 0 && frequency != 0) continue;
      const Eigen::Index column = entry.slot == 0 ? 6 : entry.slot - 1;
      const Root turn = root(valence, frequency * entry.sector);
      for (std::size_t i = 0; i < fixed.size(); ++i) {
        rows.re(static_cast<Eigen::Index>(i), column) += turn.re * weights(fixed[i], 4 * a + b);
        rows.im(static_cast<Eigen::Index>(i), column) += turn.im * weights(fixed[i], 4 * a + b);
      }
    }
  }
  return rows;
}

/// sum of values[k] b_k of degree values.size() - 1.
Poly from_bernstein(const std::vector<Number>& values) {
  const int d = static_cast<int>(values.size()) - 1;
  Poly result;
  for (int k = 0; k <= d; ++k) {
    Rational choose(1);
    for (int i = 1; i <= k; ++i) choose *= Rational(d - k + i) / Rational(i);
    Poly term = Poly::monomial(Number(choose) * values[at(k)], k);
    const Poly other({Number(1), Number(-1)});
    for (int i = k; i < d; ++i) term = term * other;
    result = result + term;
  }
  return result;
}

/// A polynomial re + im j in t.
struct SplitPoly {
  Poly re, im;
};

/// Values and derivatives along one side of the patch whose points are a column.
class Side {
 public:
  /// P(0, t) for along_u = false, P(t, 0) otherwise.
  Side(const Split& points, Eigen::Index column, bool along_u) : points_(points), column_(column), along_u_(along_u) {}
  [[nodiscard]] SplitPoly value() const {
    return of([&](const Matrix& m) { return from_bernstein(row(m, 0)); });
  }
  [[nodiscard]] SplitPoly along() const {
    return of([&](const Matrix& m) { return from_bernstein(row(m, 0)).derivative(); });
  }
  [[nodiscard]] SplitPoly across() const {
    return of([&](const Matrix& m) { return seven() * (from_bernstein(row(m, 1)) - from_bernstein(row(m, 0))); });
  }
  [[nodiscard]] SplitPoly mixed() const {
    return of([&](const Matrix& m) { return (seven() * (from_bernstein(row(m, 1)) - from_bernstein(row(m, 0)))).derivative(); });
  }
  [[nodiscard]] SplitPoly across_twice() const {
    return of([&](const Matrix& m) {
      const Poly one = from_bernstein(row(m, 1));
      return Poly({Number(42)}) * (from_bernstein(row(m, 2)) - one - one + from_bernstein(row(m, 0)));
    });
  }

 private:
  static Poly seven() { return Poly({Number(7)}); }
  template <class F>
  SplitPoly of(F f) const {
    return {f(points_.re), f(points_.im)};
  }
  /// Bezier points at `step` rows away from the side.
  [[nodiscard]] std::vector<Number> row(const Matrix& m, int step) const {
    std::vector<Number> result;
    for (int k = 0; k < 8; ++k) result.push_back(m(along_u_ ? 8 * k + step : 8 * step + k, column_));
    return result;
  }

  const Split& points_;
  Eigen::Index column_;
  bool along_u_;
};

SplitPoly turned(const SplitPoly& p, const Root& turn, const Number& square) {
  const Poly re({turn.re}), im({turn.im}), both({turn.im * square});
  return {re * p.re + both * p.im, re * p.im + im * p.re};
}

/// (2), (3) and (4) for the patches z and w^f z, as polynomials.
bool residuals_vanish(const Split& points, int valence, const Root& turn, const Number& square) {
  const Number c = cosine_of(valence);
  const Poly s({c, -c}), g = Poly({Number(1)}) + s, twice({Number(2)}), c_poly({c});
  for (Eigen::Index column = 0; column < points.re.cols(); ++column) {
    const Side p(points, column, false), side(points, column, true);
    const auto zero = [&](auto f) {
      const auto part = [&](const Poly SplitPoly::*which) {
        const auto q = [&](const SplitPoly& x) { return turned(x, turn, square).*which; };
        return f(which, q);
      };
      return part(&SplitPoly::re).is_zero() && part(&SplitPoly::im).is_zero();
    };
    const bool two = zero([&](auto which, auto q) { return p.value().*which - q(side.value()); });
    const bool three =
        zero([&](auto which, auto q) { return s * (q(side.along()) + p.along().*which) - q(side.across()) - p.across().*which; });
    const bool four = zero([&](auto which, auto q) {
      return twice * c_poly * s * (q(side.across()) - p.across().*which) + twice * s * g * (q(side.mixed()) - p.mixed().*which) -
             g * (q(side.across_twice()) - p.across_twice().*which);
    });
    if (!two || !three || !four) return false;
  }
  return true;
}

/// Free and fixed points together, in their places.
Split assembled(const Split& free, const Split* fixed) {
  Split result(fill_points, free.re.cols());
  const auto put = [&](const Split& from, const std::vector<int>& points) {
    for (std::size_t k = 0; k < points.size(); ++k) {
      result.re.row(points[k]) = from.re.row(static_cast<Eigen::Index>(k));
      result.im.row(points[k]) = from.im.row(static_cast<Eigen::Index>(k));
    }
  };
  put(free, points_where(true));
  if (fixed != nullptr) put(*fixed, points_where(false));
  return result;
}

/// Some rows and columns of the fairness.
Matrix energy_of(const std::vector<int>& rows, const std::vector<int>& columns) {
  const Matrix energy = fairness<Number>();
  Matrix result(static_cast<Eigen::Index>(rows.size()), static_cast<Eigen::Index>(columns.size()));
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (std::size_t k = 0; k < columns.size(); ++k)
      result(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k)) = energy(rows[i], columns[k]);
  return result;
}

/// re(z)^T y_re + |j|^2 im(z)^T y_im: the real part of the product of vectors over a + b j.
Matrix inner(const Split& z, const Split& y, const Number& square) {
  Matrix result = z.re.transpose() * y.re;
  const Matrix other = z.im.transpose() * y.im;
  for (Eigen::Index k = 0; k < result.size(); ++k) result.data()[k] -= square * other.data()[k];
  return result;
}
Split times(const Matrix& a, const Split& b) {
  Split result(a.rows(), b.re.cols());
  result.re = a * b.re;
  result.im = a * b.im;
  return result;
}

/// What the equations of one frequency leave: solutions of the free points by the columns of `fixed`.
struct Solutions {
  Number square;  // j^2
  Root turn;
  bool real = false;
  int rank = 0;
  Split fixed{0, 0}, homogeneous{0, 0};
  std::optional<Split> particular;
  Matrix form;  // of the fairness on the homogeneous ones
};
Solutions solutions_of(int valence, int frequency, const Matrix& weights, Print print) {
  Solutions result;
  const Number c = cosine_of(valence);
  result.square = c * c - Number(1);
  const EdgeEquations<Number> edge = edge_equations<Number>(c);
  result.turn = root(valence, frequency);
  result.real = 2 * frequency % valence == 0;
  result.fixed = fixed_rows(valence, frequency, weights, print);
  const Matrix a = stacked(restricted(edge, result.turn, points_where(true)), result.square, result.real);
  Matrix right =
      stacked_columns(product(restricted(edge, result.turn, points_where(false)), result.fixed, result.square), result.real);
  for (Eigen::Index k = 0; k < right.size(); ++k) right.data()[k] = -right.data()[k];
  const Matrix homogeneous = kernel(a);
  result.rank = static_cast<int>(a.cols() - homogeneous.cols()) / (result.real ? 1 : 2);
  result.homogeneous = unstacked(homogeneous, result.real);
  const std::optional<Matrix> solution = solve(a, right);
  if (solution) result.particular = unstacked(*solution, result.real);
  result.form =
      inner(result.homogeneous, times(energy_of(points_where(true), points_where(true)), result.homogeneous), result.square);
  return result;
}

}  // namespace

FrequencyFacts frequency_facts(int valence, int frequency, const Matrix& weights, Print print) {
  const Solutions solutions = solutions_of(valence, frequency, weights, print);
  FrequencyFacts facts;
  facts.rank = solutions.rank;
  facts.consistent = solutions.particular.has_value();
  if (!facts.consistent) return facts;
  const auto vanish = [&](const Split& free, const Split* fixed) {
    return residuals_vanish(assembled(free, fixed), valence, solutions.turn, solutions.square);
  };
  facts.residuals_vanish = vanish(*solutions.particular, &solutions.fixed) && vanish(solutions.homogeneous, nullptr);
  facts.fairness_decides = rank(solutions.form) == solutions.form.rows();
  return facts;
}

Points<Algebraic> exact_fill_mask(int valence, const std::atomic<bool>* stop) {
  const Matrix weights = weights_of(outer_series(valence));
  Matrix mask = Matrix::Zero(fill_points, ring_size(valence, 2));
  static constexpr int places[6][2] = {{1, 0}, {1, 1}, {2, 0}, {2, 1}, {2, 2}, {1, 2}};
  for (int f = 0; 2 * f <= valence; ++f) {
    throw_if_stopped(stop);
    const Solutions solutions = solutions_of(valence, f, weights, Print::none);
    const std::vector<int>&free = points_where(true), &fixed = points_where(false);
    Split x = *solutions.particular, slope = times(energy_of(free, free), x);
    const Split other = times(energy_of(free, fixed), solutions.fixed);
    slope.re += other.re;
    slope.im += other.im;
    const std::optional<Matrix> step = solve(solutions.form, inner(solutions.homogeneous, slope, solutions.square));
    x.re -= solutions.homogeneous.re * *step;
    x.im -= solutions.homogeneous.im * *step;
    const Split all = assembled(x, &solutions.fixed);
    const Number share = Number(Rational(f == 0 || 2 * f == valence ? 1 : 2) / Rational(valence));
    for (int i = 0; i < fill_points; ++i) {
      if (f == 0) mask(i, 0) += all.re(i, 6);
      for (int s = 0; s < valence; ++s) {
        const Root turn = root(valence, -f * s);
        for (int k = 0; k < 6; ++k)
          mask(i, ring_number(valence, s, places[k][0], places[k][1])) +=
              share * (turn.re * all.re(i, k) + solutions.square * turn.im * all.im(i, k));
      }
    }
  }
  return mask;
}

bool conditions_mean_g2(int valence) {
  const Number c = cosine_of(valence);
  const Poly s({c, -c}), one({Number(1)}), two({Number(2)}), g = one + s;
  // On P_u, P_v, P_uu, P_uv, P_vv at (0, t); along the edge d/dt P_u = P_uv, d/dt P_v = P_vv, and Q_u = P_v by (2).
  using Form = std::array<Poly, 5>;
  const Form q_v{Poly() - one, two * s, {}, {}, {}};  // (3)
  Form q_uv;                                          // its derivative along the edge
  for (std::size_t k = 0; k < 2; ++k) {
    q_uv[k] = q_v[k].derivative();
    q_uv[3 + k] = q_v[k];
  }
  Form q_vv;  // times g, by (4)
  for (std::size_t k = 0; k < 5; ++k) q_vv[k] = two * Poly({c}) * s * q_v[k] + two * s * g * q_uv[k];
  q_vv[0] = q_vv[0] - two * Poly({c}) * s;
  q_vv[3] = q_vv[3] - two * s * g;
  q_vv[2] = q_vv[2] + g;
  const Poly du = q_v[0], dv = q_v[1];
  const bool second_order = q_vv[2] == g * du * du && q_vv[3] == two * g * du * dv && q_vv[4] == g * dv * dv;
  const bool same_side = (Poly() - du) == one;                                                     // det of (0, 1), (du, dv)
  return second_order && same_side && g.at(Number(0)) > Number(0) && g.at(Number(1)) > Number(0);  // g is linear
}

}  // namespace udcp
