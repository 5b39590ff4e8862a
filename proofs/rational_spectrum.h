// Matrices over the fractions all of whose eigenvalues are fractions: eigenvalues, Jordan blocks, vectors on both sides, limits
// of powers. Exact; knows no scheme, and is of no use where an eigenvalue is irrational.
#pragma once

#include "proofs/linear_algebra.h"

namespace udcp {

struct RationalEigenvalue {
  Rational value;
  int multiplicity = 0;     // in the characteristic polynomial
  std::vector<int> blocks;  // sizes of the Jordan blocks, largest first
  Points<Rational> right;   // columns: a basis of the solutions of a x = value x
  Points<Rational> left;    // rows: a basis of the solutions of x a = value x
};

struct RationalSpectrum {
  Polynomial<Rational> polynomial;         // det(x - a)
  std::vector<RationalEigenvalue> values;  // falling
  [[nodiscard]] bool is_diagonalisable() const;
};

/// Throws Error{not_exact, "E_NOT_EXACT"} unless every eigenvalue is a fraction.
RationalSpectrum rational_spectrum(const Points<Rational>& a);

/// The limit of the powers of a. Throws Error{input, "E_DOMAIN"} if there is none: an eigenvalue of modulus above 1, -1, or a
/// Jordan block of 1.
Points<Rational> limit_of_powers(const RationalSpectrum& spectrum);

/// The tensor product: entry (i k, j l) is a(i, j) b(k, l), pairs row by row.
Points<Rational> tensor(const Points<Rational>& a, const Points<Rational>& b);

}  // namespace udcp
