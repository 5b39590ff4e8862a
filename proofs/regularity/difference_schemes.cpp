// Unit vectors on small grids through the word, and linear systems for the weights of old differences.
#include "proofs/regularity/difference_schemes.h"

#include "operators/matrix.h"
#include "operators/schemes.h"
#include "operators/shapes.h"
#include "proofs/regularity/cell_weights.h"

namespace udcp {
namespace {

using Index = Eigen::Index;

void expect(bool condition, const char* what) {
  if (!condition) throw Error(ErrorKind::internal, "E_INTERNAL", what);
}

Points<Rational> stacked(const std::vector<Points<Rational>>& rows) {
  Points<Rational> result(static_cast<Index>(rows.size()), rows.front().cols());
  for (std::size_t i = 0; i < rows.size(); ++i) result.row(static_cast<Index>(i)) = rows[i];
  return result;
}

Points<Rational> transposed(const Points<Rational>& a) { return a.transpose().eval(); }

Points<Rational> doubled(const Points<Rational>& a) {
  Points<Rational> result = a;
  for (Index k = 0; k < result.size(); ++k) result.data()[k] *= Rational(2);
  return result;
}

/// The open polyline of so many points after one round; its ends are fixed.
Points<Rational> refined_curve(int points) {
  Polyline<Rational> curve;
  curve.closed = false;
  curve.points = Points<Rational>::Zero(points, 1);
  return subdivision_matrix(schemes::catmull_clark(), curve);
}

Points<Rational> steps(const Points<Rational>& points) {
  const Index n = points.rows() - 1;
  return points.bottomRows(n) - points.topRows(n);
}

/// The differences between rows of weights of points on a curve, in old differences.
Points<Rational> curve_differences(const Points<Rational>& points) {
  return in_differences(steps(points), 1, static_cast<int>(points.cols()), Direction::u);
}

/// The new differences in one direction in the block of new points i .. i + 2, j .. j + columns - 1, in old ones.
Points<Rational> new_differences(const RefinedGrid& grid, int i0, int j0, int columns, Direction direction) {
  const bool u = direction == Direction::u;
  std::vector<Points<Rational>> rows;
  for (int i = i0; i < i0 + (u ? 3 : 2); ++i)
    for (int j = j0; j < j0 + (u ? columns - 1 : columns); ++j)
      rows.emplace_back(grid.point(u ? i : i + 1, u ? j + 1 : j) - grid.point(i, j));
  return in_differences(stacked(rows), grid.rows(), grid.columns(), direction);
}

/// The central differences at p'_13, p'_12, p'_23 and p'_22 (section 1.2.2).
Points<Rational> central_differences(const RefinedGrid& grid) {
  std::vector<Points<Rational>> rows;
  for (const auto& [i, j] : {std::pair{1, 3}, std::pair{1, 2}, std::pair{2, 3}, std::pair{2, 2}})
    rows.emplace_back(grid.printed_point(i, j + 1) - grid.printed_point(i, j - 1));
  return in_differences(stacked(rows), grid.rows(), grid.columns(), Direction::u);
}

bool has_equal_rows(const Points<Rational>& matrix) {
  for (Index i = 1; i < matrix.rows(); ++i)
    if (matrix.row(i) != matrix.row(0)) return false;
  return true;
}

/// Of every point of a 4 x 4 grid after a round: surfaces have no rules but those of curves.
bool is_tensor_product_of_curves() {
  const RefinedGrid grid(4, 4, 1);
  const Points<Rational> curve = refined_curve(4);
  const Points<Rational> expected = tensor(curve, curve);
  for (int i = 0; i < 7; ++i)
    for (int j = 0; j < 7; ++j)
      if (grid.point(i, j) != expected.row(7 * i + j)) return false;
  return true;
}

/// The products of eigenvectors on the right are eigenvectors for the products of the eigenvalues. All of them, if the factors
/// are diagonalisable, as they are as many as rows.
bool has_tensor_eigenvectors(const Points<Rational>& matrix, const RationalSpectrum& first, const RationalSpectrum& second) {
  Index found = 0;
  for (const RationalEigenvalue& x : first.values) {
    for (const RationalEigenvalue& y : second.values) {
      const Points<Rational> vectors = tensor(x.right, y.right);
      if (matrix * vectors != x.value * y.value * vectors) return false;
      found += vectors.cols();
    }
  }
  return found == matrix.rows();
}

/// Tensor products of weights that are convex are convex.
bool has_convex_cells() {
  for (const bool start : {false, true}) {
    for (const bool end : {false, true}) {
      const CellWeights weights = cell_weights(start, end);
      if (!are_convex(weights.points) || !are_convex(weights.differences)) return false;
    }
  }
  return true;
}

}  // namespace

RefinedGrid::RefinedGrid(int rows, int columns, int rounds) : rows_(rows), columns_(columns), rounds_(rounds) {
  Surface<Rational> surface = grid<Rational>(columns - 1, rows - 1);
  const Index n = surface.points.rows();
  Points<Rational> points = Points<Rational>::Zero(n, n + 2);
  points.leftCols(n) = Points<Rational>::Identity(n, n);
  points.rightCols(2) = surface.points.leftCols(2);
  surface.points = std::move(points);
  surface.tags.corner.assign(static_cast<std::size_t>(n), 0);
  for (const int v : {0, columns - 1, (rows - 1) * columns, rows * columns - 1})
    surface.tags.corner[static_cast<std::size_t>(v)] = 1;
  const Surface<Rational> fine = run(schemes::catmull_clark(), std::move(surface), rounds);
  weights_ = fine.points.leftCols(n);
  const int across = ((columns - 1) << rounds) + 1;
  places_.assign(static_cast<std::size_t>(fine.points.rows()), -1);
  const Rational scale(1 << rounds);
  for (Index v = 0; v < fine.points.rows(); ++v) {
    const Rational x = scale * fine.points(v, n), y = scale * fine.points(v, n + 1);
    expect(x.fits_int() && y.fits_int(), "a refined grid point is not where a linear function puts it");
    places_.at(static_cast<std::size_t>(y.to_int() * across + x.to_int())) = static_cast<int>(v);
  }
}

Points<Rational> RefinedGrid::point(int i, int j) const {
  const int across = ((columns_ - 1) << rounds_) + 1;
  const int place = places_.at(static_cast<std::size_t>(i * across + j));
  expect(place >= 0, "a refined grid has no point at a place");
  return weights_.row(place);
}

// Each round begins at the point that the round before calls 1: one step from p_11, then twice that and one more.
Points<Rational> RefinedGrid::printed_point(int i, int j) const {
  int first = 0;
  for (int round = 0; round < rounds_; ++round) first = 2 * first + 1;
  return point(first + i - 1, first + j - 1);
}

Points<Rational> difference_rows(int rows, int columns, Direction direction) {
  const int right = direction == Direction::u ? 1 : 0, up = 1 - right;
  Points<Rational> result = Points<Rational>::Zero(static_cast<Index>(rows - up) * (columns - right), rows * columns);
  Index row = 0;
  for (int i = 0; i < rows - up; ++i) {
    for (int j = 0; j < columns - right; ++j) {
      result(row, i * columns + j) = Rational(-1);
      result(row++, (i + up) * columns + j + right) = Rational(1);
    }
  }
  return result;
}

Points<Rational> in_differences(const Points<Rational>& forms, int rows, int columns, Direction direction) {
  const Points<Rational> old = transposed(difference_rows(rows, columns, direction));
  const std::optional<Points<Rational>> weights = solve(old, transposed(forms));
  expect(weights.has_value() && rank(old) == old.cols(), "a new difference is no combination of the old ones");
  return transposed(*weights);
}

UnivariateRows univariate_rows() {
  const Points<Rational> three = refined_curve(3), four = refined_curve(4);
  UnivariateRows rows;
  rows.averaging = three.middleRows(1, 3);
  rows.differences = curve_differences(rows.averaging);
  rows.differences_of_four = curve_differences(four.middleRows(1, 4));
  rows.boundary_averaging = three.topRows(3);
  rows.boundary_differences = curve_differences(rows.boundary_averaging);
  return rows;
}

DifferenceSchemes difference_schemes() {
  const RefinedGrid three(3, 3, 1), four(3, 4, 1);
  DifferenceSchemes s;
  s.xi = new_differences(three, 1, 1, 3, Direction::u);
  s.alpha = central_differences(four);
  s.s9 = new_differences(four, 1, 1, 4, Direction::u);
  s.along = new_differences(three, 0, 1, 3, Direction::u);
  s.across = new_differences(three, 0, 1, 3, Direction::v);
  s.corner_u = new_differences(three, 0, 0, 3, Direction::u);
  s.corner_v = new_differences(three, 0, 0, 3, Direction::v);
  s.twice_xi = rational_spectrum(doubled(s.xi));
  s.twice_s9 = rational_spectrum(doubled(s.s9));
  s.limit = limit_of_powers(s.twice_xi);
  s.limit9 = limit_of_powers(s.twice_s9);
  s.omega = s.xi * s.limit;
  s.alpha_limit = s.alpha * s.limit9;
  return s;
}

Points<Rational> tangent_row(const Points<Rational>& scheme) {
  return common_row(limit_of_powers(rational_spectrum(doubled(scheme))));
}

std::vector<DifferenceFact> difference_facts(const DifferenceSchemes& s, const UnivariateRows& r) {
  const Rational half = Rational(1) / Rational(2);
  const Points<Rational>&v = r.averaging, &d = r.differences, &vb = r.boundary_averaging, &db = r.boundary_differences;
  return {
      {"every row of S and S_9 has weights >= 0 and sum 1/2", has_rows_of(s.xi, half) && has_rows_of(s.s9, half)},
      {"every alpha_k has weights >= 0 and sum 1", has_rows_of(s.alpha, Rational(1))},
      {"S = V x D2 and S_9 = V x D3", s.xi == tensor(v, d) && s.s9 == tensor(v, r.differences_of_four)},
      {"2 S and 2 S_9 are diagonalisable", s.twice_xi.is_diagonalisable() && s.twice_s9.is_diagonalisable()},
      {"their eigenvectors are the tensor products of those of V with those of 2 D2 and 2 D3",
       has_tensor_eigenvectors(doubled(s.xi), rational_spectrum(v), rational_spectrum(doubled(d))) &&
           has_tensor_eigenvectors(doubled(s.s9), rational_spectrum(v), rational_spectrum(doubled(r.differences_of_four)))},
      {"omega_k is one row for all k, and so is alpha_k lim (2 S_9)^n", has_equal_rows(s.omega) && has_equal_rows(s.alpha_limit)},
      {"at a boundary the schemes are Vb x D2 along it and Db x V across, with weights >= 0 and sum 1/2",
       s.along == tensor(vb, d) && s.across == tensor(db, v) && has_rows_of(s.along, half) && has_rows_of(s.across, half)},
      {"at a corner they are Vb x Db and Db x Vb, with weights >= 0 and sum 1/2",
       s.corner_u == tensor(vb, db) && s.corner_v == tensor(db, vb) && has_rows_of(s.corner_u, half) &&
           has_rows_of(s.corner_v, half)},
      {"a refined grid, boundary and corners included, is the tensor product of refined curves", is_tensor_product_of_curves()},
      {"at every point of a patch S_u (S_v) is a convex combination of the u- (v-) differences of its net, at boundaries of "
       "those "
       "between points of the mesh (Theorems 1 and 2 in full)",
       has_convex_cells()},
  };
}

bool has_rows_of(const Points<Rational>& weights, const Rational& sum) {
  for (Index i = 0; i < weights.rows(); ++i) {
    Rational total;
    for (Index j = 0; j < weights.cols(); ++j) {
      if (weights(i, j).sign() < 0) return false;
      total += weights(i, j);
    }
    if (total != sum) return false;
  }
  return true;
}

Points<Rational> common_row(const Points<Rational>& matrix) {
  expect(has_equal_rows(matrix), "the rows of a limit differ");
  return matrix.topRows(1);
}

}  // namespace udcp
