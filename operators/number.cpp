// What differs between the number types: conversion from exact values, cosines of rational multiples of pi, text, zero tests.
#include "operators/number.h"

#include <charconv>

namespace udcp {
namespace {

template <class S>
inline constexpr bool is_double = std::is_same_v<S, double>;

// What a type shows of itself as one number.
template <class S>
const S& shown(const S& value) {
  return value;
}
const Interval& shown(const Jet& value) { return value.value(); }

}  // namespace

template <class S>
S number(const Rational& value) {
  if constexpr (is_double<S>) {
    const double nearest = value.to_double();
    if (std::isfinite(nearest)) return nearest;
    throw Error(ErrorKind::limit, "E_NOT_FINITE",
                "a number of " + std::to_string(value.bits()) + " bits is beyond the floating-point range",
                "compute exactly or in enclosures");
  } else {
    return S(value);
  }
}

template <class S>
S number(const Algebraic& value) {
  if constexpr (std::is_same_v<S, Algebraic>) {
    return value;
  } else if constexpr (is_double<S>) {
    return value.is_rational() ? number<double>(value.rational()) : value.to_double();
  } else if constexpr (is_enclosure<S>) {
    return S(value.enclosure());
  } else {
    return value.rational();
  }
}

template <class S>
S number_from_double(double value) {
  if constexpr (is_double<S>) {
    return value;
  } else if constexpr (is_enclosure<S>) {
    return S(Interval::from_double(value));
  } else {
    throw Error(ErrorKind::not_exact, "E_NOT_EXACT", "the floating-point number " + to_text(value) + " stands for no exact value",
                "write the number as a fraction or a decimal, or compute in floating point");
  }
}

std::optional<Rational> rational_cosine(const Rational& q) {
  const Rational twelfths = (q / Rational(2) - (q / Rational(2)).floor()) * Rational(12);  // of a turn
  if (!twelfths.is_integer()) return std::nullopt;
  switch (twelfths.to_int()) {
    case 0:
      return Rational(1);
    case 2:
    case 10:
      return Rational(1) / Rational(2);
    case 3:
    case 9:
      return Rational(0);
    case 4:
    case 8:
      return Rational(-1) / Rational(2);
    case 6:
      return Rational(-1);
    default:
      return std::nullopt;
  }
}

template <class S>
S cosine(const Rational& q) {
  if (const std::optional<Rational> exact = rational_cosine(q)) return number<S>(*exact);
  if constexpr (is_enclosure<S>) {
    const Rational folded = q - Rational(2) * (q / Rational(2)).floor();  // exactly, so that no precision is lost for large q
    return S(cos(Interval(folded) * Interval::pi()));
  } else if constexpr (is_double<S>) {
    const Interval::Precision scope(192);  // the middle rounds to the nearest double unless the value is extremely near a tie
    return cosine<Interval>(q).midpoint();
  } else if constexpr (std::is_same_v<S, Algebraic>) {
    return Algebraic::cosine(q);
  } else {
    throw Error(ErrorKind::not_exact, "E_NOT_EXACT", "cos(" + q.to_string().substr(0, 60) + "*pi) is not a rational number",
                "compute in algebraic numbers, enclosures or floating point");
  }
}

template <class S>
double approximate(const S& value) {
  if constexpr (is_double<S>) {
    return value;
  } else if constexpr (is_enclosure<S>) {
    return shown(value).midpoint();
  } else {
    return value.to_double();
  }
}

template <class S>
std::string to_text(const S& value) {
  if constexpr (is_double<S>) {
    char text[32];  // the shortest form of a double has at most 24 characters
    return {text, std::to_chars(text, text + sizeof text, value).ptr};
  } else {
    return value.to_string();
  }
}

template <class S>
bool is_zero(const S& value) {
  return value == S(0);
}

template <class S>
bool is_nonzero(const S& value) {
  return value != S(0);
}

#define UDCP_NUMBER(S)                    \
  template S number(const Rational&);     \
  template S number(const Algebraic&);    \
  template S number_from_double(double);  \
  template S cosine(const Rational&);     \
  template double approximate(const S&);  \
  template std::string to_text(const S&); \
  template bool is_zero(const S&);        \
  template bool is_nonzero(const S&);
UDCP_FOR_EACH_NUMBER(UDCP_NUMBER)
#undef UDCP_NUMBER

}  // namespace udcp
