// The frequency method: a cyclic shift of the patches is a factor w^f, so that 25 n equations fall apart into n small systems,
// which are rank deficient but consistent. SVD gives a solution and the freedom; the fairness decides the freedom.
#include "operators/methods/filling/fill_mask.h"

#include <Eigen/Cholesky>
#include <Eigen/SVD>
#include <array>
#include <complex>
#include <string>

namespace udcp {
namespace {

using Matrix = Eigen::MatrixXcd;
using Index = Eigen::Index;
constexpr int free_points = (last_free + 1) * (last_free + 1), fixed_points = fill_points - free_points;

[[noreturn]] void internal(int valence, const std::string& what) {
  throw Error(ErrorKind::internal, "E_INTERNAL", "the fill of valence " + std::to_string(valence) + ": " + what);
}

// What all frequencies of a valence share.
struct Equations {
  int valence;
  Points<double> outer, energy;
  EdgeEquations<double> edge;
  std::vector<int> free, fixed;             // Bezier points
  std::vector<std::complex<double>> roots;  // of unity

  explicit Equations(int n) : valence(n) {
    const double c = cosine<double>(Rational(2) / Rational(n));
    outer = outer_weights(outer_traces(outer_map<double>(c)));
    energy = fairness<double>();
    edge = edge_equations<double>(c);
    for (int row = 0; row < edge.here.rows(); ++row) {
      const double norm = std::hypot(edge.here.row(row).norm(), edge.next.row(row).norm());
      edge.here.row(row) /= norm;
      edge.next.row(row) /= norm;
    }
    for (int k = 0; k < n; ++k) {
      const Rational angle = Rational(2 * k) / Rational(n);
      roots.emplace_back(cosine<double>(angle), cosine<double>(angle - Rational(1) / Rational(2)));
    }
    for (int i = 0; i < fill_points; ++i) (i / 8 <= last_free && i % 8 <= last_free ? free : fixed).push_back(i);
  }
  [[nodiscard]] const std::complex<double>& root(int power) const {
    return roots[static_cast<std::size_t>(((power % valence) + valence) % valence)];
  }
};

// The fixed points by the six points of a sector, and by the centre for frequency 0.
Matrix fixed_rows(const Equations& e, int frequency) {
  Matrix rows = Matrix::Zero(fixed_points, frequency == 0 ? 7 : 6);
  for (int a = 0; a < 4; ++a) {
    for (int b = a == 0 ? 1 : 0; b < 4; ++b) {
      const NetEntry entry = net_entry(a, b);
      if (entry.slot == 0 && frequency != 0) continue;
      const Index column = entry.slot == 0 ? 6 : entry.slot - 1;
      const std::complex<double> turn = e.root(frequency * entry.sector);
      for (int i = 0; i < fixed_points; ++i) rows(i, column) += turn * e.outer(e.fixed[static_cast<std::size_t>(i)], 4 * a + b);
    }
  }
  return rows;
}

Matrix columns_of(const Equations& e, int frequency, const std::vector<int>& points) {
  const std::complex<double> turn = e.root(frequency);
  Matrix result(e.edge.here.rows(), static_cast<Index>(points.size()));
  for (std::size_t k = 0; k < points.size(); ++k)
    for (Index row = 0; row < result.rows(); ++row)
      result(row, static_cast<Index>(k)) = e.edge.here(row, points[k]) + turn * e.edge.next(row, points[k]);
  return result;
}

Matrix energy_of(const Equations& e, const std::vector<int>& rows, const std::vector<int>& columns) {
  Matrix result(static_cast<Index>(rows.size()), static_cast<Index>(columns.size()));
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (std::size_t j = 0; j < columns.size(); ++j)
      result(static_cast<Index>(i), static_cast<Index>(j)) = e.energy(rows[i], columns[j]);
  return result;
}

// The free points of one frequency, by the same columns as fixed_rows.
Matrix solve_frequency(const Equations& e, int frequency, const Matrix& fixed, FillMask& mask) {
  const Matrix a = columns_of(e, frequency, e.free);
  const Matrix right = -columns_of(e, frequency, e.fixed) * fixed;
  const Eigen::JacobiSVD<Matrix, Eigen::NoQRPreconditioner> svd(a, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Eigen::VectorXd& sigma = svd.singularValues();
  Index rank = 0;
  while (rank < sigma.size() && sigma[rank] > 1e-9 * sigma[0]) ++rank;
  mask.ranks.push_back(static_cast<int>(rank));
  mask.least_kept = std::min(mask.least_kept, sigma[rank - 1] / sigma[0]);
  if (rank < sigma.size()) mask.most_dropped = std::max(mask.most_dropped, sigma[rank] / sigma[0]);
  if (rank != fill_rank(e.valence, frequency))
    internal(e.valence, "rank " + std::to_string(rank) + " at frequency " + std::to_string(frequency));
  const Matrix kept = svd.matrixU().leftCols(rank).adjoint() * right;
  const Matrix particular = svd.matrixV().leftCols(rank) * sigma.head(rank).cwiseInverse().asDiagonal() * kept;
  if ((a * particular - right).norm() > 1e-10 * std::max(1.0, right.norm()))
    internal(e.valence, "the equations contradict each other");
  const Matrix z = svd.matrixV().rightCols(free_points - rank);
  const Matrix inner = energy_of(e, e.free, e.free);
  const Matrix slope = z.adjoint() * (inner * particular + energy_of(e, e.free, e.fixed) * fixed);
  return particular - z * Eigen::LDLT<Matrix>(z.adjoint() * inner * z).solve(slope);
}

// Row 1 + 6 s + k of the result: the share of point k of sector s in patch 0; row 0: that of the centre.
void add_frequency(const Equations& e, int frequency, const Matrix& x, const std::vector<int>& points, Points<double>& weights) {
  const bool is_single = frequency == 0 || 2 * frequency == e.valence;  // otherwise n - f is its conjugate
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto row = static_cast<Index>(i);
    if (frequency == 0) weights(points[i], 0) += x(row, 6).real();
    for (int s = 0; s < e.valence; ++s) {
      const std::complex<double> turn = e.root(-frequency * s) * ((is_single ? 1.0 : 2.0) / e.valence);
      static constexpr std::array<std::array<int, 2>, 6> places{{{1, 0}, {1, 1}, {2, 0}, {2, 1}, {2, 2}, {1, 2}}};
      for (std::size_t k = 0; k < places.size(); ++k)
        weights(points[i], ring_number(e.valence, s, places[k][0], places[k][1])) +=
            (turn * x(row, static_cast<Index>(k))).real();
    }
  }
}

// The fixed points directly, without the detour over frequencies.
void add_fixed(const Equations& e, Points<double>& weights) {
  for (const int point : e.fixed)
    for (int a = 0; a < 4; ++a)
      for (int b = a == 0 ? 1 : 0; b < 4; ++b)
        weights(point, ring_number(e.valence, 0, a - 1, b - 1)) += e.outer(point, 4 * a + b);
}

}  // namespace

FillMask make_fill_mask(int valence) {
  if (valence < 3 || valence > largest_fill_valence)
    throw Error(
        valence < 3 ? ErrorKind::input : ErrorKind::limit, "E_FILL_VALENCE",
        "there is no fill for valence " + std::to_string(valence) + ", only for 3 to " + std::to_string(largest_fill_valence),
        "");
  const Equations equations(valence);
  FillMask mask;
  mask.valence = valence;
  mask.weights = Points<double>::Zero(fill_points, ring_size(valence, 2));
  add_fixed(equations, mask.weights);
  int rank = 0;
  for (int f = 0; 2 * f <= valence; ++f) {
    const Matrix x = solve_frequency(equations, f, fixed_rows(equations, f), mask);
    add_frequency(equations, f, x, equations.free, mask.weights);
    rank += mask.ranks.back() * (f == 0 || 2 * f == valence ? 1 : 2);
  }
  mask.freedom = free_points * valence - rank;
  return mask;
}

const FillMask& FillMasks::of(int valence) {
  const std::lock_guard lock(mutex_);
  const auto found = masks_.find(valence);
  return found != masks_.end() ? found->second : masks_.emplace(valence, make_fill_mask(valence)).first->second;
}

Points<double> apply(const FillMask& mask, const Points<double>& ring) {
  const int n = mask.valence;
  const Index columns = ring.cols();
  Points<double> turned(ring.rows(), columns * n);  // the ring as each patch sees it, side by side
  for (int i = 0; i < n; ++i) {
    turned.block(0, columns * i, 1, columns) = ring.row(0);
    for (int r = 1; r <= 2; ++r) {
      const int first = ring_size(n, r - 1), length = 2 * n * r, shift = 2 * r * i;
      turned.block(first, columns * i, length - shift, columns) = ring.middleRows(first + shift, length - shift);
      turned.block(first + length - shift, columns * i, shift, columns) = ring.middleRows(first, shift);
    }
  }
  const Points<double> together = mask.weights * turned;
  Points<double> result(fill_points * n, columns);
  for (int i = 0; i < n; ++i) result.middleRows(fill_points * i, fill_points) = together.middleCols(columns * i, columns);
  return result;
}

}  // namespace udcp
