// Exact linear algebra, instantiated here alone: everyone else calls these functions. S is Rational or Algebraic.
#pragma once

#include <optional>
#include <vector>

#include "proofs/polynomial.h"

namespace udcp {

template <class S>
int rank(const Points<S>& a);
/// Columns: a basis of the solutions of a x = 0.
template <class S>
Points<S> kernel(const Points<S>& a);
/// A solution x of a x = b (columns), if there is one; with rank(a) < columns, free variables are 0.
template <class S>
std::optional<Points<S>> solve(const Points<S>& a, const Points<S>& b);
/// det(x - a), monic. Division-free (Berkowitz) or fraction-free; square a only.
template <class S>
Polynomial<S> characteristic_polynomial(const Points<S>& a);
/// Sizes of the Jordan blocks of the eigenvalue, largest first; empty if it is none.
template <class S>
std::vector<int> jordan_blocks(const Points<S>& a, const S& eigenvalue);

}  // namespace udcp
