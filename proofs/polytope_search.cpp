// The search for invariant polytopes: leading eigenvectors and small unit vectors, closed under all matrices in double precision,
// then checked exactly.
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "proofs/hull.h"
#include "proofs/joint_spectral_radius.h"
#include "proofs/linear_algebra.h"

namespace udcp {
namespace {

using Eigen::Index;
using Real = Eigen::MatrixXd;
using Vector = Hull::Vector;

constexpr std::size_t most_points = 300;

/// A point of a polytope and its rational coordinates.
struct Corner {
  Vector approximation;
  std::vector<Rational> exact;
};

Corner corner(const Vector& point, double unit) {
  Corner result{point, {}};
  const auto denominator = static_cast<long long>(std::llround(1 / unit));
  for (Index i = 0; i < point.size(); ++i) {
    const long long numerator = std::llround(point[i] / unit);
    result.approximation[i] = static_cast<double>(numerator) / static_cast<double>(denominator);
    result.exact.push_back(Rational(numerator) / Rational(denominator));
  }
  return result;
}

bool contains(const std::vector<Corner>& corners, const Vector& point) {
  return std::any_of(corners.begin(), corners.end(), [&](const Corner& c) {
    return (c.approximation - point).norm() < 1e-9 || (c.approximation + point).norm() < 1e-9;
  });
}

std::optional<Hull> hull_of(const std::vector<Corner>& corners, std::size_t without = most_points + 1) {
  std::vector<Vector> points;
  for (std::size_t k = 0; k < corners.size(); ++k)
    if (k != without) points.push_back(corners[k].approximation);
  return Hull::of(std::move(points));
}

/// How finely a polytope is made: new points are moved outward by `inflation` and rounded to multiples of `unit`.
struct Grain {
  double inflation = 1e-8, unit = 1e-12, inside = 1 - 1e-10;
};

Grain grain(double slack) {
  if (slack < 1e-9) return {1e-8, 1e-12, 1 + 1e-11};  // points of the leading product map onto each other exactly
  Grain result;
  while (result.inflation * 1000 < slack && result.unit < 1e-8) {
    result.inflation *= 10;
    result.unit *= 10;
  }
  return result;
}

/// Adds images of corners until all are inside, then drops corners that are not needed.
bool close(std::vector<Corner>& corners, const std::vector<Real>& matrices, double bound, const Grain& grain, Budget& budget) {
  std::optional<Hull> hull = hull_of(corners);
  if (!hull) return false;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    for (const Real& matrix : matrices) {
      if (!budget.spend()) return false;
      const Vector image = matrix * corners[i].approximation / bound;
      if (!(image.cwiseAbs().maxCoeff() < 1e4)) return false;
      if (hull->measure(image).gauge <= grain.inside) continue;
      if (corners.size() >= most_points) return false;
      corners.push_back(corner(image * (1 + grain.inflation), grain.unit));
      hull->append(corners.back().approximation);
    }
  }
  for (std::size_t k = corners.size(); k-- > 0;) {
    if (!budget.spend()) return false;
    const std::optional<Hull> others = hull_of(corners, k);
    if (others && others->measure(corners[k].approximation).gauge < 1 - 1e-9)
      corners.erase(corners.begin() + static_cast<std::ptrdiff_t>(k));
  }
  return true;
}

/// The eigenvectors of the leading words and their images under the letters, exact if the bound is the rate itself.
template <class S>
class Seeds {
 public:
  Seeds(const std::vector<Points<S>>& matrices, const std::vector<Real>& real, const Rational& bound, bool exact, double unit)
      : matrices_(matrices), real_(real), bound_(bound), exact_(exact), unit_(unit) {}

  std::vector<Corner> of(const LeadingProducts& leading) {
    for (const std::vector<int>& word : leading.words) exact_ ? exact_orbit(word) : orbit(word, leading.rate);
    const Index n = real_.front().rows();
    for (Index i = 0; i < n; ++i) corners_.push_back(corner(Vector::Unit(n, i) / 1000, unit_));
    return std::move(corners_);
  }

 private:
  void orbit(const std::vector<int>& word, double rate) {
    const Eigen::EigenSolver<Real> solver(product(real_, word));
    Index best = 0;
    solver.eigenvalues().cwiseAbs().maxCoeff(&best);
    const Eigen::VectorXcd vector = solver.eigenvectors().col(best);
    for (Vector v : {Vector(vector.real()), Vector(vector.imag())}) {
      if (!(v.norm() > 1e-6 * vector.norm())) continue;
      v /= v.cwiseAbs().maxCoeff();
      for (std::size_t k = word.size(); k-- > 0;) {
        if (!contains(corners_, v)) corners_.push_back(corner(v, unit_));
        v = real_[static_cast<std::size_t>(word[k])] * v / rate;
      }
    }
  }

  void exact_orbit(const std::vector<int>& word) {
    if constexpr (std::is_same_v<S, Rational>) {
      const Points<Rational> whole = product(matrices_, word);
      for (const int sign : {1, -1}) {
        Points<Rational> shifted = whole;
        for (Index i = 0; i < whole.rows(); ++i) shifted(i, i) -= Rational(sign) * pow(bound_, static_cast<int>(word.size()));
        const Points<Rational> basis = kernel(shifted);
        for (Index column = 0; column < basis.cols(); ++column) {
          Points<Rational> v = basis.col(column);
          Rational most(0);
          for (Index i = 0; i < v.rows(); ++i) most = std::max(most, abs(v(i, 0)));
          v /= most;
          for (std::size_t k = word.size(); k-- > 0;) {
            add_exact(v);
            v = (matrices_[static_cast<std::size_t>(word[k])] * v / bound_).eval();
          }
        }
      }
    }
  }

  void add_exact(const Points<Rational>& v) {
    Corner result{Vector(v.rows()), {}};
    for (Index i = 0; i < v.rows(); ++i) {
      result.approximation[i] = v(i, 0).to_double();
      result.exact.push_back(v(i, 0));
    }
    if (!contains(corners_, result.approximation)) corners_.push_back(std::move(result));
  }

  const std::vector<Points<S>>& matrices_;
  const std::vector<Real>& real_;
  const Rational& bound_;
  bool exact_;
  double unit_;
  std::vector<Corner> corners_;
};

/// The combination that the hull proposes, with as many decimals as it takes to keep sum |w| + reach |rest|_1 within the limit.
template <class S>
std::optional<Polytope::Combination> combination(const Polytope& polytope, const Hull& hull, const Vector& approximation,
                                                 const std::vector<S>& x, const S& reach, const S& limit) {
  const Hull::Inside inside = hull.measure(approximation);
  std::vector<std::pair<int, double>> terms;
  for (std::size_t k = 0; k < inside.basis.size(); ++k)
    terms.emplace_back(inside.basis[k], inside.weights[static_cast<Index>(k)]);
  std::sort(terms.begin(), terms.end());
  for (const double scale : {1e2, 1e3, 1e4, 1e6, 1e8, 1e10, 1e12, 1e14, 1e16}) {
    Polytope::Combination result;
    S sum(0);
    for (const auto& [vector, weight] : terms) {
      if (!(std::abs(weight * scale) < 9e18)) return std::nullopt;
      const Rational rounded = Rational(std::llround(weight * scale)) / Rational(static_cast<long long>(scale));
      if (rounded.is_zero()) continue;
      result.push_back({vector, rounded});
      sum += abs(S(rounded));
    }
    if (sum + reach * rest_of(polytope, result, x) <= limit) return result;
  }
  return std::nullopt;
}

/// The image of a corner that is a corner again, times the bound: exactly so for the leading words of an exact bound.
template <class S>
std::optional<Polytope::Combination> same_corner(const Polytope& polytope, const std::vector<S>& image) {
  for (std::size_t k = 0; k < polytope.vectors.size(); ++k) {
    for (const Rational& weight : {polytope.bound, Rational(-polytope.bound)}) {
      const Polytope::Combination one{{static_cast<int>(k), weight}};
      if (rest_of(polytope, one, image).is_zero()) return one;
    }
  }
  return std::nullopt;
}

/// The corners as vectors of a polytope with the combinations that prove it; nothing if one cannot be found.
template <class S>
std::optional<Polytope> with_combinations(const std::vector<Corner>& corners, const std::vector<Points<S>>& matrices,
                                          const std::vector<Real>& real, const Rational& bound, bool exact, Budget& budget) {
  Polytope result{bound, {}, {}, {}};
  for (const Corner& c : corners) result.vectors.push_back(c.exact);
  const std::optional<Hull> hull = hull_of(corners);
  if (!hull) return std::nullopt;
  const auto n = static_cast<std::size_t>(matrices.front().rows());
  for (std::size_t i = 0; i < n; ++i) {
    std::vector<Rational> unit(n, Rational(0));
    unit[i] = Rational(1);
    // |b|_1 is at most 2000 with the unit vectors over 1000 among the corners; a rest of 1/2 doubles it.
    const Vector direction = Vector::Unit(static_cast<Index>(n), static_cast<Index>(i));
    auto found = combination<Rational>(result, *hull, direction, unit, Rational(1'000'000), Rational(500'000));
    if (!found || !budget.spend()) return std::nullopt;
    result.units.push_back(std::move(*found));
  }
  const S reach(reach_of(result, n)), limit(bound);
  for (std::size_t e = 0; e < matrices.size(); ++e) {
    result.images.emplace_back();
    for (const Corner& c : corners) {
      std::vector<S> image(n, S(0));
      for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j) image[i] += matrices[e](static_cast<Index>(i), static_cast<Index>(j)) * S(c.exact[j]);
      auto found = exact ? same_corner(result, image) : std::nullopt;
      if (!found) found = combination<S>(result, *hull, real[e] * c.approximation, image, reach, limit);
      if (!found || !budget.spend()) return std::nullopt;
      result.images.back().push_back(std::move(*found));
    }
  }
  return result;
}

template <class S>
std::optional<Polytope> search(const std::vector<Points<S>>& matrices, const std::vector<Real>& real, const Rational& bound,
                               const LeadingProducts& leading, bool exact, Budget& budget) {
  const Grain fine = grain(exact ? 0 : bound.to_double() / leading.rate - 1);
  std::vector<Corner> corners = Seeds<S>(matrices, real, bound, exact, fine.unit).of(leading);
  if (corners.size() >= most_points || !close(corners, real, bound.to_double(), fine, budget)) return std::nullopt;
  auto result = with_combinations(corners, matrices, real, bound, exact, budget);
  return result && polytope_holds(matrices, *result) ? std::move(result) : std::nullopt;
}

}  // namespace

template <class S>
std::optional<Polytope> find_polytope(const std::vector<Points<S>>& matrices, const Rational& bound,
                                      const LeadingProducts& leading, Budget& budget) {
  const double slack = bound.to_double() / leading.rate - 1;
  if (!(slack > -1e-12)) return std::nullopt;
  const std::vector<Real> real = rounded(matrices);
  if (slack > 1e-9) return search(matrices, real, bound, leading, false, budget);
  return std::is_same_v<S, Rational> ? search(matrices, real, bound, leading, true, budget) : std::nullopt;
}

template <class S>
std::optional<Polytope> find_polytope(const std::vector<Points<S>>& matrices, const Rational& bound, Budget& budget) {
  return find_polytope(matrices, bound, leading_products(matrices, budget), budget);
}

#define UDCP_INSTANTIATE(S)                                                                                \
  template std::optional<Polytope> find_polytope(const std::vector<Points<S>>&, const Rational&, Budget&); \
  template std::optional<Polytope> find_polytope(const std::vector<Points<S>>&, const Rational&, const LeadingProducts&, Budget&);
UDCP_INSTANTIATE(Rational)
UDCP_INSTANTIATE(Algebraic)
#undef UDCP_INSTANTIATE

}  // namespace udcp
