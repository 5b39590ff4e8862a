// The number types that every atom runs over, rows of points, and the little that differs between the types.
// double models; Rational and Algebraic are exact; Interval encloses; Parametric computes with symbols, and Jet encloses
// derivatives. Nobody else lists number types.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <optional>
#include <string>
#include <type_traits>

#include "operators/error.h"
#include "operators/numbers/algebraic.h"
#include "operators/numbers/interval.h"
#include "operators/numbers/jet.h"
#include "operators/numbers/parametric.h"
#include "operators/numbers/rational.h"

/// Instantiates a template once per number type: `#define X(S) template ...; UDCP_FOR_EACH_NUMBER(X)`. Everything that a word
/// runs through: atoms, kernels and their formulas, run, matrices and masks. Coordinates of shapes in files, and values in the
/// language, are of the shorter list; symbols and jets come in through the parameters of a word.
#define UDCP_FOR_EACH_COORDINATE(X) X(double) X(udcp::Rational) X(udcp::Algebraic) X(udcp::Interval)
#define UDCP_FOR_EACH_NUMBER(X) UDCP_FOR_EACH_COORDINATE(X) X(udcp::Parametric) X(udcp::Jet)

namespace Eigen {
// What Eigen asks of a number. epsilon() is 0 for exact numbers, so that decompositions compare with zero exactly.
template <class S>
struct ExactNumTraits : GenericNumTraits<S> {
  enum { IsInteger = 0, IsSigned = 1, IsComplex = 0, RequireInitialization = 1, ReadCost = 10, AddCost = 50, MulCost = 100 };
  using Real = S;
  using NonInteger = S;
  using Nested = S;
  using Literal = S;
  static S epsilon() { return S(0); }
  static S dummy_precision() { return S(0); }
  static int digits10() { return 0; }
};
template <>
struct NumTraits<udcp::Rational> : ExactNumTraits<udcp::Rational> {};
template <>
struct NumTraits<udcp::Algebraic> : ExactNumTraits<udcp::Algebraic> {};
template <>
struct NumTraits<udcp::Interval> : ExactNumTraits<udcp::Interval> {};
template <>
struct NumTraits<udcp::Parametric> : ExactNumTraits<udcp::Parametric> {};
template <>
struct NumTraits<udcp::Jet> : ExactNumTraits<udcp::Jet> {};
}  // namespace Eigen

namespace udcp {

/// A row per point, a column per coordinate.
template <class S>
using Points = Eigen::Matrix<S, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Row i of `to` += w times row j of `from`. The one primitive of every atom.
template <class S>
inline void add(Points<S>& to, int i, const S& w, const Points<S>& from, int j) {
  const Eigen::Index columns = to.cols();
  S* target = to.data() + i * columns;
  const S* source = from.data() + j * columns;
  for (Eigen::Index c = 0; c < columns; ++c) target[c] += w * source[c];
}

/// The types whose every operation is exact. Where a formula has no value in them, Error{not_exact} is thrown.
template <class S>
inline constexpr bool is_exact = std::is_same_v<S, Rational> || std::is_same_v<S, Algebraic> || std::is_same_v<S, Parametric>;
/// The types that round outward.
template <class S>
inline constexpr bool is_enclosure = std::is_same_v<S, Interval> || std::is_same_v<S, Jet>;

/// The value of an exact rational in the number type: rounded to nearest (double), exact, or enclosed. Error{limit,
/// "E_NOT_FINITE"} beyond the largest double.
template <class S>
S number(const Rational& value);
/// The value of an algebraic number in the number type. Error{not_exact} if it is irrational and S is Rational or Parametric.
template <class S>
S number(const Algebraic& value);
/// The value of a double: exact as the dyadic number that it is for enclosures; Error{not_exact} for the exact types.
template <class S>
S number_from_double(double value);
/// cos(q pi): exact where the type can hold it, else Error{not_exact}; enclosed or rounded otherwise.
/// The double is the nearest one, so the same on every machine.
template <class S>
S cosine(const Rational& q);
/// cos(q pi) where it is rational: 0, 1/2, 1 and their negatives, nothing else (Niven).
std::optional<Rational> rational_cosine(const Rational& q);
/// The nearest double, or the midpoint of an enclosure: for pictures and messages. Error{not_exact} for a formula in parameters.
template <class S>
double approximate(const S& value);
/// "p/q" and the like for exact numbers, "[lo, hi]" for enclosures, the shortest digits that read back for double.
template <class S>
std::string to_text(const S& value);
/// Certainly zero; certainly not zero. Both are false for an enclosure that cannot tell. A formula in parameters is zero or not
/// as a function; a jet is zero only as a constant, not where a function happens to vanish.
template <class S>
bool is_zero(const S& value);
template <class S>
bool is_nonzero(const S& value);

}  // namespace udcp
