// Quantities: construction, arithmetic, order, noise and conversion. Exact rules for rationals and multiples of pi come first,
// the number type where they end. The functions are in quantity_functions.cpp.
#include "operators/quantity.h"

#include <cstdint>

#include "operators/quantity_kinds.h"

namespace udcp {
namespace {

// The sign of a - b where neither is a rational combination of the other: enclosures of growing precision separate them, because
// pi is transcendental.
template <class Enclose>
int separate(Enclose difference) {
  for (int bits = 128; bits <= 1 << 19; bits *= 2) {
    const Interval::Precision scope(bits);
    const Interval value = difference();
    if (!value.contains_zero()) return value > Interval(0) ? 1 : -1;
  }
  throw Error(ErrorKind::limit, "E_PRECISION", "two numbers are too close to be compared");
}

Interval enclose_exact(const Quantity<Algebraic>& x) {
  if (is_number(x)) return x.value().enclosure();
  return is_rational(x) ? Interval(x.exact()) : Interval(x.exact()) * Interval::pi();
}

}  // namespace

// ---- the class

template <class S>
Quantity<S> Quantity<S>::pi(Rational times) {
  Quantity result(std::move(times));
  if (!result.exact_.is_zero()) result.kind_ = Kind::pi_multiple;
  return result;
}

template <class S>
Quantity<S> Quantity<S>::of(S value) {
  Quantity result;
  if constexpr (std::is_same_v<S, double>) {
    if (!std::isfinite(value)) {
      throw Error(ErrorKind::input, "E_NOT_FINITE", "a result is beyond the floating-point range or undefined",
                  "keep the operands smaller, or compute exactly or in enclosures");
    }
  } else if constexpr (std::is_same_v<S, Rational>) {
    return Quantity(std::move(value));
  } else if constexpr (std::is_same_v<S, Algebraic>) {
    if (value.is_rational()) return Quantity(value.rational());
  } else if constexpr (std::is_same_v<S, Parametric>) {
    if (value.is_constant()) return Quantity(value.constant());
  }
  result.kind_ = Kind::number;
  result.number_ = std::move(value);
  return result;
}

template <class S>
S Quantity<S>::value() const {
  if (kind_ == Kind::rational) return number<S>(exact_);
  if (kind_ == Kind::number) return number_;
  if constexpr (is_exact<S>) {
    no_exact_value("the number " + to_string());
  } else if constexpr (std::is_same_v<S, double>) {
    const Interval::Precision scope(192);  // so that the result is the nearest double
    return (Interval(exact_) * Interval::pi()).midpoint();
  } else {
    return S(Interval(exact_) * Interval::pi());
  }
}

template <class S>
std::string Quantity<S>::to_string() const {
  if (kind_ == Kind::number) return to_text(number_);
  if (kind_ == Kind::rational) return exact_.to_string();
  if (abs(exact_) == Rational(1)) return exact_.sign() < 0 ? "-pi" : "pi";
  return exact_.to_string() + "*pi";
}

template <class S>
Quantity<S> Quantity<S>::operator-() const {
  Quantity result(*this);
  result.exact_ = -result.exact_;
  if (kind_ == Kind::number) result.number_ = -number_;
  return result;
}

// ---- arithmetic

template <class S>
Quantity<S> operator+(const Quantity<S>& a, const Quantity<S>& b) {
  if (is_plain_zero(a)) return b;
  if (is_plain_zero(b)) return a;
  if (is_rational(a) && is_rational(b)) return Quantity<S>(a.exact() + b.exact());
  if (is_pi_multiple(a) && is_pi_multiple(b)) return Quantity<S>::pi(a.exact() + b.exact());
  return Quantity<S>::of(a.value() + b.value());
}

template <class S>
Quantity<S> operator-(const Quantity<S>& a, const Quantity<S>& b) {
  return a + -b;
}

template <class S>
Quantity<S> operator*(const Quantity<S>& a, const Quantity<S>& b) {
  if (is_plain_zero(a) || is_plain_zero(b)) return Quantity<S>();
  if (is_rational(a) && is_rational(b)) return Quantity<S>(a.exact() * b.exact());
  if (!is_number(a) && !is_number(b) && is_rational(a) != is_rational(b)) return Quantity<S>::pi(a.exact() * b.exact());
  return Quantity<S>::of(a.value() * b.value());
}

template <class S>
Quantity<S> operator/(const Quantity<S>& a, const Quantity<S>& b) {
  if (is_plain_zero(b) || (std::is_same_v<S, double> && is_number(b) && is_zero(b.value()))) {
    division_by_zero(a.to_string() + " / " + b.to_string());
  }
  if (!is_number(a) && !is_number(b)) {
    if (is_plain_zero(a)) return a;
    if (a.kind() == b.kind()) return Quantity<S>(a.exact() / b.exact());
    if (is_pi_multiple(a)) return Quantity<S>::pi(a.exact() / b.exact());
  }
  return Quantity<S>::of(a.value() / b.value());
}

// ---- order

template <class S>
int compare(const Quantity<S>& a, const Quantity<S>& b) {
  if (!is_number(a) && !is_number(b)) {
    if (a.kind() == b.kind()) return a.exact().compare(b.exact());
    const Rational ratio = is_pi_multiple(a) ? b.exact() / a.exact() : a.exact() / b.exact();
    const int order = separate([&] { return Interval::pi() - Interval(ratio); });  // of pi against the ratio
    return is_pi_multiple(a) ? order * a.exact().sign() : -order * b.exact().sign();
  }
  if constexpr (std::is_same_v<S, Algebraic>) {
    if (is_pi_multiple(a) || is_pi_multiple(b)) return separate([&] { return enclose_exact(a) - enclose_exact(b); });
  }
  const S left = a.value();
  const S right = b.value();
  if (left < right) return -1;
  if (right < left) return 1;
  if (left == right) return 0;
  throw Error(ErrorKind::not_exact, "E_UNDECIDED",
              "enclosures cannot decide whether " + to_text(left) + " is below " + to_text(right),
              "raise the precision, or write the formula without the comparison");
}

template <class S>
Quantity<S> min(const Quantity<S>& a, const Quantity<S>& b) {
  if constexpr (is_enclosure<S>) {
    if (is_number(a) || is_number(b)) {
      const S left = a.value();
      const S right = b.value();
      if (left <= right) return a;
      return right <= left ? b : Quantity<S>::of(min(left, right));
    }
  }
  return compare(a, b) <= 0 ? a : b;
}

template <class S>
Quantity<S> max(const Quantity<S>& a, const Quantity<S>& b) {
  return -min(-a, -b);
}

// ---- noise and conversion

template <class S>
Quantity<S> noise(const Rational& seed, int h, int i) {
  if (!seed.is_integer()) {
    throw Error(ErrorKind::input, "E_NOISE_SEED", "noise needs an integer seed, but here it is " + shorten(seed.to_string()),
                "write noise(7), for example");
  }
  const std::uint64_t position = (static_cast<std::uint64_t>(h) << 40) + static_cast<std::uint64_t>(i) + 1;
  std::uint64_t x = seed.low_bits() + UINT64_C(0x9E3779B97F4A7C15) * position;
  x ^= x >> 30;
  x *= UINT64_C(0xBF58476D1CE4E5B9);
  x ^= x >> 27;
  x *= UINT64_C(0x94D049BB133111EB);
  x ^= x >> 31;
  const auto numerator = static_cast<std::int64_t>(x >> 11) - (std::int64_t{1} << 52);
  if constexpr (is_exact<S>) {
    return Quantity<S>(Rational(static_cast<long>(numerator)) / Rational(1L << 52));
  } else {  // 53 bits: exact in a double
    return Quantity<S>::of(number_from_double<S>(std::ldexp(static_cast<double>(numerator), -52)));
  }
}

template <class T, class S>
Quantity<T> convert(const Quantity<S>& value) {
  if (is_rational(value)) return Quantity<T>(value.exact());
  if (is_pi_multiple(value)) return Quantity<T>::pi(value.exact());
  if constexpr (std::is_same_v<T, S>) {
    return value;
  } else if constexpr (is_exact<S>) {
    return Quantity<T>::of(number<T>(value.value()));
  } else {
    return Quantity<T>::of(number_from_double<T>(approximate(value.value())));
  }
}

#define UDCP_QUANTITY(S)                                                  \
  template class Quantity<S>;                                             \
  template Quantity<S> operator+(const Quantity<S>&, const Quantity<S>&); \
  template Quantity<S> operator-(const Quantity<S>&, const Quantity<S>&); \
  template Quantity<S> operator*(const Quantity<S>&, const Quantity<S>&); \
  template Quantity<S> operator/(const Quantity<S>&, const Quantity<S>&); \
  template Quantity<S> min(const Quantity<S>&, const Quantity<S>&);       \
  template Quantity<S> max(const Quantity<S>&, const Quantity<S>&);       \
  template int compare(const Quantity<S>&, const Quantity<S>&);           \
  template Quantity<S> noise(const Rational&, int, int);                  \
  template Quantity<S> convert(const Quantity<double>&);                  \
  template Quantity<S> convert(const Quantity<Rational>&);                \
  template Quantity<S> convert(const Quantity<Algebraic>&);               \
  template Quantity<S> convert(const Quantity<Interval>&);
UDCP_FOR_EACH_NUMBER(UDCP_QUANTITY)
#undef UDCP_QUANTITY

}  // namespace udcp
