// Symbols of masks: sum rules, polynomials generated and reproduced, difference schemes and their norms, stability, limit
// stencils. Exact algebra on one mask; no search and no claim about limits (curve_smoothness.h proves those). S is Rational or
// Algebraic.
#pragma once

#include <optional>
#include <variant>

#include "operators/matrix.h"
#include "proofs/polynomial.h"

namespace udcp {

/// The mask of one round of a scheme in the smallest exact type that holds it. Throws what mask() throws; Error{not_exact} if a
/// parameter has no algebraic value.
using ExactMask = std::variant<Mask<Rational>, Mask<Algebraic>>;
ExactMask exact_mask(const Word& word);

/// a(z) = sum a_i z^i, times z^-first so that it is a polynomial. Empty for the zero mask.
template <class S>
Polynomial<S> symbol(const Mask<S>& mask);

/// The largest m with ((1 - z^A)/(1 - z))^m dividing a(z); 0 unless a(1) = A. A convergent scheme has 1 or more and generates
/// polynomials of degree m - 1.
template <class S>
int sum_rules(const Mask<S>& mask);
/// tau = a'(1)/A, the shift of the parametrisation (-1/2 for dual words). For a(1) = A.
template <class S>
S parameter_shift(const Mask<S>& mask);
/// The largest degree of polynomials reproduced in the parametrisation shifted by tau: a^(k)(1) = A tau (tau - 1) .. (tau - k +
/// 1) for all k up to it, below the number of sum rules (Conti and Hormann, Polynomial reproduction for univariate subdivision
/// schemes of any arity); -1 if not even constants.
template <class S>
int reproduction_degree(const Mask<S>& mask);

/// Where the basic limit function lives, in units of the old points: [first, last]/(A - 1).
struct Support {
  Rational lower, upper;
};
template <class S>
Support support(const Mask<S>& mask);

/// The scheme S_j of j-th differences: the mask a(z) ((1 - z)/(1 - z^A))^j. Error{internal} for j above the number of sum rules.
template <class S>
Mask<S> difference_mask(const Mask<S>& mask, int order);
/// The mask of so many rounds at once: a(z) a(z^A) a(z^(A^2)) .. . Error{limit, "E_ARITY"} past a million coefficients.
template <class S>
Mask<S> iterated(const Mask<S>& mask, int rounds);
/// The norm of the scheme on bounded sequences: the largest sum of moduli over a residue class of the arity.
template <class S>
S norm(const Mask<S>& mask);

/// -log_A(radius) as text: "2", "3/2", "3 - log2(3/2)", or "-log2(..)" of an irrational radius. For radius > 0.
template <class S>
std::string exponent_text(int arity, const S& radius);

/// a_0 = 1 and a_(A j) = 0 else: old points stay.
template <class S>
bool interpolates(const Mask<S>& mask);
/// No negative coefficient: limit curves lie in the convex hull of their points.
template <class S>
bool is_nonnegative(const Mask<S>& mask);
/// How often 1 + 2 c z + z^2 divides a(z), c = cos(theta): generation of cos(2 theta x) and sin(2 theta x) by one binary round.
template <class S>
int exponential_order(const Mask<S>& mask, const S& cosine);

/// Are the integer shifts of the basic limit function stable? Interpolating masks: yes. Binary ones: if and only if a(z) has no
/// pair z, -z of zeros on the unit circle and no cycle of zeros at odd roots of -1 (Jia and Wang, Stability and linear
/// independence associated with wavelet decompositions). `unknown` for other arities, and where an irrational mask has some of
/// the zeros of a cyclotomic polynomial.
enum class Stability { stable, unstable, unknown };
template <class S>
Stability stability(const Mask<S>& mask);

/// For masks symmetric about 0: the weights of old points in the limit point (the derivative per old unit) at an old point,
/// if the scheme converges (to C^1): left eigenvectors of the local subdivision matrix for the eigenvalues 1 and 1/A. Nothing
/// unless the eigenvalue is simple, nor for masks wider than 48 old points.
template <class S>
std::optional<Stencil<S>> position_stencil(const Mask<S>& mask);
template <class S>
std::optional<Stencil<S>> tangent_stencil(const Mask<S>& mask);

}  // namespace udcp
