// The limit of Catmull-Clark curves on one cell as polynomials, solved for from the refinement equation of the running word: the
// B-spline functions of degree 3 and, for the derivative, 2, also next to fixed ends. A regular patch is their tensor product.
// Knows curves only.
#pragma once

#include "proofs/polynomial.h"

namespace udcp {

/// c(t) = sum points[i](t) p_i and c'(t) = sum differences[j](t) (p_{j+1} - p_j), t in [0, 1], where the p_i are the two ends of
/// the cell and their other neighbours (none beyond a fixed end): four points, three or two.
struct CellWeights {
  std::vector<Polynomial<Rational>> points;
  std::vector<Polynomial<Rational>> differences;
};

/// The weights on a cell whose start (end) is a fixed end of the curve, which is also the rule normal to the boundary of a
/// surface. Throws Error{internal} if the refinement equation of the word does not determine them.
CellWeights cell_weights(bool fixed_start, bool fixed_end);

/// Rows: the points of the half `half` (0 or 1) of a cell, columns: those of the cell; one round of the word.
Points<Rational> half_cell_matrix(bool fixed_start, bool fixed_end, int half);

/// p(a + b t).
Polynomial<Rational> composed(const Polynomial<Rational>& p, const Rational& a, const Rational& b);

/// The coefficients of p, of degree at most `degree`, over the Bernstein polynomials on [0, 1].
std::vector<Rational> bernstein_coefficients(const Polynomial<Rational>& p, int degree);

/// All weights of a cell have Bernstein coefficients >= 0 and sum to 1: then the values are convex combinations everywhere on
/// the cell, and so are tensor products ("On Regularity of Catmull-Clark Subdivision Surfaces", Theorems 1 and 2, for every
/// point).
bool are_convex(const std::vector<Polynomial<Rational>>& weights);

}  // namespace udcp
