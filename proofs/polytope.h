// Bounds of joint spectral radii as exact checks: transition matrices, products with a large eigenvalue, polytopes that all
// matrices shrink. Knows no search; checkers use it. S is Rational or Algebraic.
#pragma once

#include <vector>

#include "operators/matrix.h"
#include "proofs/certificate.h"
#include "proofs/polynomial.h"

namespace udcp {

/// T_0 .. T_(A-1) of a mask c with indices shifted to 0 .. N: (T_e)_(s,t) = c_(A t + e - s), s, t < M = max(1, ceil(N/(A - 1))).
/// Their joint spectral radius is lim norm(S^L)^(1/L) (Daubechies and Lagarias, Two-scale difference equations II).
template <class S>
std::vector<Points<S>> transition_matrices(const Mask<S>& mask);
/// A M^2: what they hold, to be looked at before making them.
template <class S>
std::int64_t transition_size(const Mask<S>& mask);
/// T_w1 T_w2 .. of the word w. Letters are indices of matrices.
template <class S>
Points<S> product(const std::vector<Points<S>>& matrices, const std::vector<int>& letters);

/// Do all zeros, complex ones too, have moduli below the radius? (Schur and Cohn.) Not for the zero polynomial.
template <class S>
bool zeros_within(const Polynomial<S>& p, const S& radius);
/// Is the spectral radius of the product at least bound^length? Then bound is a lower bound of the joint spectral radius. False,
/// without a look, for matrices with more than `most_rows` rows, whose polynomials would take too long.
constexpr int most_rows = 24;
template <class S>
bool product_reaches(const std::vector<Points<S>>& matrices, const std::vector<int>& letters, const S& bound);

/// Points v_i, with their negatives the corners of a body B that spans the space, and combinations of them that show that every
/// matrix takes B into bound B, so that the joint spectral radius is at most the bound. A combination sum w_j v_j need not be x
/// exactly: with the gauge of B, gauge(x) <= sum |w_j| + gauge(rest), and gauge(rest) <= reach |rest|_1.
struct Polytope {
  struct Term {
    int vector = 0;
    Rational weight;
  };
  using Combination = std::vector<Term>;
  Rational bound;
  std::vector<std::vector<Rational>> vectors;
  std::vector<Combination> units;                // one for every unit vector; they bound `reach`
  std::vector<std::vector<Combination>> images;  // images[e][i] for T_e v_i
};
/// The sum of moduli of the coordinates of x minus the combination.
template <class S>
S rest_of(const Polytope& polytope, const Polytope::Combination& combination, const std::vector<S>& x);
/// At least gauge(x) for all x with |x|_1 = 1. Rejected unless the units show that the vectors span the space: with e_i = V b_i +
/// r_i and |r_i|_1 <= r < 1, V has a right inverse, and the largest gauge of a unit vector is at most max |b_i|_1/(1 - r).
Rational reach_of(const Polytope& polytope, std::size_t dimension);
/// Throws Rejected with the first condition that fails. Holding for two matrices it holds for what lies between them: for masks
/// that are multi-affine in parameters, test the corners of a box of parameters.
template <class S>
void check_polytope(const std::vector<Points<S>>& matrices, const Polytope& polytope);
template <class S>
bool polytope_holds(const std::vector<Points<S>>& matrices, const Polytope& polytope);

/// {"kind": "polytope", "bound", "vectors", "units", "images"}; a combination is {"3": "1/2", "5": "-1/8"}.
Json to_json(const Polytope& polytope);
Polytope polytope_from(const Json& json);

}  // namespace udcp
