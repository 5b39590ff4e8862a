// Bounds of joint spectral radii, searched for in double precision and established exactly, with the data of their certificates.
// What the bounds mean for schemes is curve_smoothness.h's. S is Rational or Algebraic.
#pragma once

#include <optional>

#include "proofs/budget.h"
#include "proofs/polytope.h"

namespace udcp {

/// product_reaches(matrices, product, value).
template <class S>
struct LowerRadius {
  std::vector<int> product;
  S value;
};
/// The bound of the polytope; without one, value^length >= norm of so many rounds.
template <class S>
struct UpperRadius {
  S value;
  int length = 1;
  std::optional<Polytope> polytope;
};
template <class S>
struct JointSpectralRadius {
  LowerRadius<S> lower;
  UpperRadius<S> upper;
  [[nodiscard]] bool exact() const { return lower.value == upper.value; }
};

/// The product of matrices with the largest |eigenvalue|^(1/length), up to rounding, among all of length up to 10 for two
/// matrices (6 for three, 5 for four, .. 1), and those that come within 1e-8 of it.
struct LeadingProducts {
  double rate = 0;
  std::vector<std::vector<int>> words;  // the best first
};
template <class S>
LeadingProducts leading_products(const std::vector<Points<S>>& matrices, Budget& budget);

/// A polytope that shows that the joint spectral radius of all these matrices is at most the bound (Guglielmi and Protasov, Exact
/// computation of joint spectral characteristics of linear operators); it has passed check_polytope. Nothing where the search
/// fails. For a box of parameters on which the matrices are multi-affine pass those of all corners.
template <class S>
std::optional<Polytope> find_polytope(const std::vector<Points<S>>& matrices, const Rational& bound, Budget& budget);
/// The same with leading_products(matrices) known already.
template <class S>
std::optional<Polytope> find_polytope(const std::vector<Points<S>>& matrices, const Rational& bound,
                                      const LeadingProducts& leading, Budget& budget);

/// Bounds for the transition matrices of a mask: equal where the norm is an eigenvalue or the search closes exactly, otherwise
/// about 1e-6 apart, wider where the search fails. Never without a bound.
template <class S>
JointSpectralRadius<S> joint_spectral_radius(const Mask<S>& mask, Budget& budget);

}  // namespace udcp
