// The difference schemes of Catmull-Clark surfaces on regular meshes, from unit vectors run through the word: new differences as
// combinations of old ones, inside, at boundaries and at corners, and their limits ("On Regularity of Catmull-Clark Subdivision
// Surfaces", sections 1.1 and 1.2). Knows nothing of what the paper prints.
#pragma once

#include <string>

#include "proofs/rational_spectrum.h"

namespace udcp {

/// A grid of points p_ij, row i in v direction and column j in u direction, both from 1, after some rounds of the word; its four
/// corners are fixed. Every point is a row of weights of the old points, numbered row by row.
class RefinedGrid {
 public:
  /// At least two rows and columns, at most eight rounds.
  RefinedGrid(int rows, int columns, int rounds);
  [[nodiscard]] int rows() const { return rows_; }
  [[nodiscard]] int columns() const { return columns_; }
  /// The point i and j steps of the new grid from p_11; 2^rounds of them are one of the old. Points are found by where a linear
  /// function puts them, which the rules reproduce.
  [[nodiscard]] Points<Rational> point(int i, int j) const;
  /// The point p'_ij of the paper after one round (p''_ij after two): p'_11 is the new face point next to p_11.
  [[nodiscard]] Points<Rational> printed_point(int i, int j) const;

 private:
  int rows_, columns_, rounds_;
  Points<Rational> weights_;
  std::vector<int> places_;  // row of weights_ by place
};

enum class Direction { u, v };
/// The forward differences of a grid of old points, p_{i,j+1} - p_ij (u) or p_{i+1,j} - p_ij (v), as rows of weights.
Points<Rational> difference_rows(int rows, int columns, Direction direction);
/// The same rows of weights of points as weights of old differences, which are independent, so this is unique. Throws
/// Error{internal} if a row is no combination of them.
Points<Rational> in_differences(const Points<Rational>& forms, int rows, int columns, Direction direction);

/// The univariate rows: averaging of three points and differences of them, between regular points and at a fixed end.
struct UnivariateRows {
  Points<Rational> averaging;            // V: p'_1, p'_2, p'_3 from p_1, p_2, p_3
  Points<Rational> differences;          // D2: p'_2 - p'_1, p'_3 - p'_2 from two old differences
  Points<Rational> differences_of_four;  // D3: and p'_4 - p'_3, from three
  Points<Rational> boundary_averaging;   // the same from the fixed end p_0 on
  Points<Rational> boundary_differences;
};
UnivariateRows univariate_rows();

struct DifferenceSchemes {
  Points<Rational> xi;     // 6 x 6: the rows xi_1 .. xi_6 of the forward differences, which are the rows of the matrix S
  Points<Rational> alpha;  // 4 x 9: the rows of the central differences at p'_13, p'_12, p'_23, p'_22
  Points<Rational> s9;     // 9 x 9: the nine forward differences of 3 x 4 points
  // Six rows each. At the middle of a boundary in u direction, points 3 x 3, the first row on it: along it, and across. At a
  // corner: the u-differences and the v-differences.
  Points<Rational> along, across, corner_u, corner_v;
  RationalSpectrum twice_xi, twice_s9;  // of 2 S and 2 S_9
  Points<Rational> limit, limit9;       // lim (2 S)^n, lim (2 S_9)^n
  Points<Rational> omega;               // xi lim (2 S)^n, a row per k
  Points<Rational> alpha_limit;         // alpha lim (2 S_9)^n
};
DifferenceSchemes difference_schemes();

/// The tangent at the vertex around which a scheme of forward differences works, as weights of old differences: the row that all
/// rows of lim (2 scheme)^n are. Throws what limit_of_powers throws, and Error{internal} if the rows differ.
Points<Rational> tangent_row(const Points<Rational>& scheme);

/// A sentence about these matrices, and whether exact computation says that it holds.
struct DifferenceFact {
  std::string sentence;
  bool holds = false;
};
/// Weights, sums, tensor products, limits; and Theorems 1 and 2 of the paper for every point: a refined grid, boundary and
/// corners included, is the tensor product of refined curves, and the weights of a cell (cell_weights.h) are non-negative with
/// sum 1.
std::vector<DifferenceFact> difference_facts(const DifferenceSchemes& schemes, const UnivariateRows& rows);

/// All entries are >= 0 and every row has this sum.
bool has_rows_of(const Points<Rational>& weights, const Rational& sum);
/// The one row that all rows of the matrix are. Throws Error{internal} if they differ.
Points<Rational> common_row(const Points<Rational>& matrix);

}  // namespace udcp
