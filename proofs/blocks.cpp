// Fourier blocks around an extraordinary point: enclosed in real coordinates, exact over the cosine of the frequency.
#include "proofs/blocks.h"

#include <algorithm>
#include <utility>

#include "proofs/linear_algebra.h"

namespace udcp {

Complex operator*(const Complex& a, const Complex& b) { return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re}; }
Complex operator+(const Complex& a, const Complex& b) { return {a.re + b.re, a.im + b.im}; }
Complex operator-(const Complex& a, const Complex& b) { return {a.re - b.re, a.im - b.im}; }

Complex unit(int numerator, int valence) {
  const Rational angle = Rational(numerator) / Rational(valence);
  return {cosine<Interval>(angle), cosine<Interval>(angle - Rational(1) / Rational(2))};
}

std::vector<Coordinate> coordinates(const Sectors& sectors, int radius) {
  std::vector<Coordinate> result;
  const int first = sectors.dual ? 1 : 0;
  for (int a = sectors.dual ? 1 : 2; a <= radius; a += 2) {
    for (int b = first; b <= a && sectors.radius({0, a, b}) <= radius; b += 2) {
      result.push_back({{0, a, b}, false});
      if (b != 0 && b != a) result.push_back({{0, a, b}, true});
    }
  }
  return result;
}

namespace {

/// The functionals "value of a net of frequency m after one round" over the coordinates of the net before.
class Functionals {
 public:
  Functionals(const Patch<Interval>& patch, int radius, int frequency)
      : patch_(patch), frequency_(frequency), names_(coordinates(patch.sectors, radius)) {
    for (std::size_t k = 0; k < names_.size(); ++k)
      if (!names_[k].imaginary) index_.emplace(names_[k].orbit, static_cast<int>(k));
    for (int q = 0; q < 2 * patch.sectors.valence; ++q) units_.push_back(unit(q, patch.sectors.valence));
  }

  [[nodiscard]] Points<Interval> matrix() const {
    const auto n = static_cast<Eigen::Index>(names_.size());
    Points<Interval> result = Points<Interval>::Zero(n, n);
    for (Eigen::Index k = 0; k < n; ++k) {
      const Coordinate& name = names_[static_cast<std::size_t>(k)];
      const bool diagonal = name.orbit.a == name.orbit.b;
      result.row(k) = functional(patch_.rows.at(name.orbit), diagonal ? frequency_ : 0, name.imaginary);
    }
    return frequency_ == 0 ? modulo_constants(result) : result;
  }

 private:
  /// The real or imaginary part of e^{-i pi turn/n} times the new value.
  [[nodiscard]] Points<Interval> functional(const Row<Interval>& row, int turn, bool imaginary) const {
    Points<Interval> result = Points<Interval>::Zero(1, static_cast<Eigen::Index>(names_.size()));
    const int n = patch_.sectors.valence;
    for (const auto& [label, weight] : row) {
      if (label.is_centre()) continue;
      const bool swapped = label.a < label.b, diagonal = label.a == label.b;
      const int angle = 2 * frequency_ * label.s + (diagonal ? frequency_ : swapped ? 2 * frequency_ : 0) - turn;
      const Complex& factor = units_[static_cast<std::size_t>(((angle % (2 * n)) + 2 * n) % (2 * n))];
      const int k = index_.at({0, std::max(label.a, label.b), std::min(label.a, label.b)});
      result(0, k) += weight * (imaginary ? factor.im : factor.re);
      if (diagonal || label.b == 0) continue;
      // factor * (x +- iy), with the minus for the swapped one of the pair
      const Interval of_y = weight * (imaginary ? factor.re : -factor.im);
      result(0, k + 1) += swapped ? -of_y : of_y;
    }
    return result;
  }

  [[nodiscard]] Points<Interval> modulo_constants(const Points<Interval>& all) const {
    const int dropped = patch_.sectors.dual ? 1 : 0;
    const Points<Interval> base = dropped != 0 ? Points<Interval>(all.row(0)) : functional(patch_.rows.at(Label{}), 0, false);
    Points<Interval> result = all;
    for (Eigen::Index k = 0; k < result.rows(); ++k)
      if (!names_[static_cast<std::size_t>(k)].imaginary) result.row(k) -= base;
    return result.bottomRightCorner(result.rows() - dropped, result.cols() - dropped);
  }

  const Patch<Interval>& patch_;
  int frequency_;
  std::vector<Coordinate> names_;
  std::map<Label, int> index_;
  std::vector<Complex> units_;
};

}  // namespace

Points<Interval> block(const Patch<Interval>& patch, int radius, int frequency) {
  return Functionals(patch, radius, frequency).matrix();
}

Complex value_at(const Patch<Interval>& patch, int frequency, const Label& label, const std::vector<Interval>& values,
                 const std::vector<Coordinate>& names) {
  if (label.is_centre()) return {Interval(0), Interval(0)};
  const Label orbit{0, std::max(label.a, label.b), std::min(label.a, label.b)};
  const auto found = std::find_if(names.begin(), names.end(), [&](const Coordinate& name) { return name.orbit == orbit; });
  const auto k = static_cast<std::size_t>(found - names.begin());
  const bool swapped = label.a < label.b, diagonal = label.a == label.b;
  const int angle = 2 * frequency * label.s + (diagonal ? frequency : swapped ? 2 * frequency : 0);
  const Complex factor = unit(angle, patch.sectors.valence);
  if (diagonal || label.b == 0) return {factor.re * values[k], factor.im * values[k]};
  return factor * Complex{values[k], swapped ? -values[k + 1] : values[k + 1]};
}

namespace {

using Exact = Points<Algebraic>;
using Index = Eigen::Index;

/// z^s = first + second z where z^2 = 2 c z - 1.
std::pair<Algebraic, Algebraic> power_of_unit(int s, const Algebraic& c) {
  std::pair<Algebraic, Algebraic> result{1, 0};
  for (int k = 0; k < std::abs(s); ++k) {
    const auto [x, y] = result;
    result = s > 0 ? std::pair{-y, x + Algebraic(2) * c * y} : std::pair{Algebraic(2) * c * x + y, -x};
  }
  return result;
}

/// The rows of sector 0 as sums over sectors: (row orbit, column orbit) -> weight per sector in (-n/2, n/2].
struct Sums {
  std::vector<Label> orbits;
  std::vector<std::map<std::pair<int, int>, std::map<int, Algebraic>>> rows;  // per orbit
};

Sums sums_of(const Patch<Algebraic>& patch, int radius) {
  const int n = patch.sectors.valence;
  Sums result{patch.orbits(radius), {}};
  for (const Label& orbit : result.orbits) {
    auto& row = result.rows.emplace_back();
    for (const auto& [label, weight] : patch.rows.at(orbit))
      if (!label.is_centre()) row[{label.a, label.b}][label.s > n / 2 ? label.s - n : label.s] += weight;
  }
  return result;
}

/// B(z) over the basis 1, z of the numbers x + y z: every eigenvalue of B(z) twice, for |z| = 1 and a real polynomial.
Exact doubled_block(const Sums& sums, const Algebraic& c) {
  const auto n = static_cast<Index>(sums.orbits.size());
  Exact result = Exact::Zero(2 * n, 2 * n);
  std::map<int, std::pair<Algebraic, Algebraic>> powers;
  for (Index i = 0; i < n; ++i) {
    for (Index j = 0; j < n; ++j) {
      const Label& orbit = sums.orbits[static_cast<std::size_t>(j)];
      const auto found = sums.rows[static_cast<std::size_t>(i)].find({orbit.a, orbit.b});
      if (found == sums.rows[static_cast<std::size_t>(i)].end()) continue;
      Algebraic x, y;
      for (const auto& [s, weight] : found->second) {
        const auto power = powers.try_emplace(s, power_of_unit(s, c)).first->second;
        x += weight * power.first;
        y += weight * power.second;
      }
      result(i, j) = x;
      result(i, n + j) = -y;
      result(n + i, j) = y;
      result(n + i, n + j) = x + Algebraic(2) * c * y;
    }
  }
  return result;
}

/// B at z = 1 or -1, with the centre first if z = 1 and there is one.
Exact real_block(const Patch<Algebraic>& patch, int radius, int z) {
  std::vector<Label> places = patch.orbits(radius);
  if (z == 1 && !patch.sectors.dual) places.insert(places.begin(), Label{});
  const auto n = static_cast<Index>(places.size());
  std::map<Label, Index> index;
  for (Index k = 0; k < n; ++k) index.emplace(places[static_cast<std::size_t>(k)], k);
  Exact result = Exact::Zero(n, n);
  for (Index k = 0; k < n; ++k) {
    for (const auto& [label, weight] : patch.rows.at(places[static_cast<std::size_t>(k)])) {
      const auto column = index.find({0, label.a, label.b});
      if (column != index.end()) result(k, column->second) += z == -1 && label.s % 2 != 0 ? -weight : weight;
    }
  }
  return result;
}

/// The monic square root of a monic square.
Polynomial<Algebraic> root_of(const Polynomial<Algebraic>& square) {
  const int n = square.degree() / 2;
  std::vector<Algebraic> root(static_cast<std::size_t>(n) + 1, Algebraic(0));
  const auto at = [&](int k) -> Algebraic& { return root[static_cast<std::size_t>(n - k)]; };
  at(0) = Algebraic(1);
  for (int k = 1; k <= n; ++k) {
    Algebraic rest = square.coefficients[static_cast<std::size_t>(2 * n - k)];
    for (int i = 1; i < k; ++i) rest -= at(i) * at(k - i);
    at(k) = rest / Algebraic(2);
  }
  Polynomial<Algebraic> result(std::move(root));
  if (!(result * result == square))
    throw Error(ErrorKind::internal, "E_INTERNAL", "the rows around a point are not mirror symmetric");
  return result;
}

bool is_real_frequency(const Patch<Algebraic>& patch, int frequency) { return 2 * frequency % patch.sectors.valence == 0; }

Algebraic cosine_of(const Patch<Algebraic>& patch, int frequency) {
  return Algebraic::cosine(Rational(2 * frequency) / Rational(patch.sectors.valence));
}

}  // namespace

Polynomial<Algebraic> block_polynomial(const Patch<Algebraic>& patch, int radius, int frequency) {
  if (is_real_frequency(patch, frequency))
    return characteristic_polynomial<Algebraic>(real_block(patch, radius, frequency == 0 ? 1 : -1));
  return root_of(characteristic_polynomial<Algebraic>(doubled_block(sums_of(patch, radius), cosine_of(patch, frequency))));
}

std::vector<int> block_jordan(const Patch<Algebraic>& patch, int radius, int frequency, const Algebraic& eigenvalue) {
  if (is_real_frequency(patch, frequency))
    return jordan_blocks<Algebraic>(real_block(patch, radius, frequency == 0 ? 1 : -1), eigenvalue);
  const std::vector<int> twice =
      jordan_blocks<Algebraic>(doubled_block(sums_of(patch, radius), cosine_of(patch, frequency)), eigenvalue);
  std::vector<int> result;
  for (std::size_t k = 0; k < twice.size(); k += 2) result.push_back(twice[k]);
  return result;
}

namespace {

/// The weight that every sector has counts nothing at frequencies other than 0. Returns the largest distance of what is left.
int drop_means(Sums& sums, int valence) {
  int span = 0;
  for (auto& row : sums.rows) {
    for (auto& [orbit, weights] : row) {
      if (weights.find(valence / 2) != weights.end()) {
        const Algebraic mean = weights.at(valence / 2);
        for (int s = valence / 2 - valence + 1; s <= valence / 2; ++s) weights[s] -= mean;
      }
      std::erase_if(weights, [](const auto& entry) { return entry.second.is_zero(); });
      for (const auto& [s, weight] : weights) span = std::max(span, std::abs(s));
    }
  }
  return span;
}

}  // namespace

std::vector<std::vector<Algebraic>> polynomial_in_cosine(const Patch<Algebraic>& patch, int radius) {
  Sums sums = sums_of(patch, radius);
  const int span = drop_means(sums, patch.sectors.valence), size = static_cast<int>(sums.orbits.size());
  if (4 * span >= patch.sectors.valence || size * span > 60)
    throw Error(ErrorKind::limit, "E_TOO_LARGE", "the rows reach too many sectors for one polynomial at all valences",
                "ask for the polynomial at one valence");
  const int degree = size * span;
  Exact powers(degree + 1, degree + 1), values(degree + 1, size + 1);
  for (int k = 0; k <= degree; ++k) {
    const Algebraic c = Algebraic(Rational(k - degree / 2) / Rational(2));
    for (int j = 0; j <= degree; ++j) powers(k, j) = j == 0 ? Algebraic(1) : powers(k, j - 1) * c;
    const Polynomial<Algebraic> p = root_of(characteristic_polynomial<Algebraic>(doubled_block(sums, c)));
    for (int i = 0; i <= size; ++i) values(k, i) = p.coefficients[static_cast<std::size_t>(i)];
  }
  const Exact coefficients = solve<Algebraic>(powers, values).value();
  std::vector<std::vector<Algebraic>> result;
  for (int i = 0; i <= size; ++i) {
    std::vector<Algebraic>& row = result.emplace_back();
    for (int j = 0; j <= degree; ++j) row.push_back(coefficients(j, i));
    while (!row.empty() && row.back().is_zero()) row.pop_back();
  }
  return result;
}

}  // namespace udcp
