// Rational eigenvalues by the rational root theorem on square-free factors; vectors as kernels.
#include "proofs/rational_spectrum.h"

#include <algorithm>

namespace udcp {
namespace {

using Index = Eigen::Index;

Rational least_common_denominator(const Polynomial<Rational>& p) {
  Rational common(1);
  for (const Rational& c : p.coefficients) common *= (common * c).denominator();
  return common;
}

/// A root is p/q with q dividing the leading coefficient of the integer multiple: in an interval of half a step there is one
/// candidate.
std::vector<Rational> rational_roots(const Polynomial<Rational>& factor) {
  const Rational leading = abs(least_common_denominator(factor) * factor.coefficients.back());
  std::vector<Rational> roots;
  for (const RealRoot& root : real_roots(factor, Rational(1) / (Rational(2) * leading))) {
    const Rational middle = (root.lower + root.upper) / Rational(2);
    const Rational candidate = (leading * middle + Rational(1) / Rational(2)).floor() / leading;
    if (factor.at(candidate).is_zero()) roots.push_back(candidate);
  }
  return roots;
}

Points<Rational> transposed(const Points<Rational>& a) {
  Points<Rational> result(a.cols(), a.rows());
  for (Index i = 0; i < a.rows(); ++i)
    for (Index j = 0; j < a.cols(); ++j) result(j, i) = a(i, j);
  return result;
}

RationalEigenvalue eigenvalue(const Points<Rational>& a, const Rational& value, int multiplicity) {
  Points<Rational> shifted = a;
  for (Index i = 0; i < a.rows(); ++i) shifted(i, i) -= value;
  return {value, multiplicity, jordan_blocks(a, value), kernel(shifted), transposed(kernel(transposed(shifted)))};
}

}  // namespace

bool RationalSpectrum::is_diagonalisable() const {
  return std::all_of(values.begin(), values.end(),
                     [](const RationalEigenvalue& v) { return v.blocks.empty() || v.blocks.front() == 1; });
}

RationalSpectrum rational_spectrum(const Points<Rational>& a) {
  RationalSpectrum result{characteristic_polynomial(a), {}};
  int found = 0;
  for (const auto& [factor, multiplicity] : square_free_factors(result.polynomial)) {
    for (const Rational& root : rational_roots(factor)) {
      result.values.push_back(eigenvalue(a, root, multiplicity));
      found += multiplicity;
    }
  }
  if (found != result.polynomial.degree())
    throw Error(ErrorKind::not_exact, "E_NOT_EXACT", "the matrix has eigenvalues that are not rational");
  std::sort(result.values.begin(), result.values.end(), [](const auto& x, const auto& y) { return x.value > y.value; });
  return result;
}

Points<Rational> limit_of_powers(const RationalSpectrum& spectrum) {
  const Index n = spectrum.polynomial.degree();
  Points<Rational> limit = Points<Rational>::Zero(n, n);
  for (const RationalEigenvalue& v : spectrum.values) {
    if (abs(v.value) < Rational(1)) continue;
    if (v.value != Rational(1) || v.blocks.front() != 1)
      throw Error(ErrorKind::input, "E_DOMAIN", "the powers of the matrix have no limit");
    // The projection along the other eigenspaces: right (left right)^-1 left.
    const Points<Rational> pairing = v.left * v.right;
    limit = v.right * solve(pairing, v.left).value();
  }
  return limit;
}

Points<Rational> tensor(const Points<Rational>& a, const Points<Rational>& b) {
  Points<Rational> result(a.rows() * b.rows(), a.cols() * b.cols());
  for (Index i = 0; i < result.rows(); ++i)
    for (Index j = 0; j < result.cols(); ++j) result(i, j) = a(i / b.rows(), j / b.cols()) * b(i % b.rows(), j % b.cols());
  return result;
}

}  // namespace udcp
