// Arithmetic and functions on quantities: exact rules for rationals and multiples of pi first, the number type where they end.
#include "operators/quantity.h"

#include <cstdint>

namespace udcp {
namespace {

const char* const kUseAnotherType =
    "compute in enclosures or floating point, or use values with an exact form such as cos(2*pi/5)";

template <class S>
bool is_number(const Quantity<S>& x) {
  return x.kind() == Quantity<S>::Kind::number;
}
template <class S>
bool is_rational(const Quantity<S>& x) {
  return x.kind() == Quantity<S>::Kind::rational;
}
template <class S>
bool is_pi_multiple(const Quantity<S>& x) {
  return x.kind() == Quantity<S>::Kind::pi_multiple;
}
template <class S>
bool is_plain_zero(const Quantity<S>& x) {
  return is_rational(x) && x.exact().is_zero();
}

std::string shorten(const std::string& text) { return text.size() <= 80 ? text : text.substr(0, 77) + "..."; }

[[noreturn]] void no_exact_value(const std::string& what) {
  throw Error(ErrorKind::not_exact, "E_NOT_EXACT", shorten(what) + " has no exact value here", kUseAnotherType);
}

[[noreturn]] void division_by_zero(const std::string& what) {
  throw Error(ErrorKind::input, "E_DIV0", "division by zero in " + shorten(what),
              "check the denominator, or guard it with if ... then ... else");
}

// A function without exact values: computed in double and Interval, refused by the exact types.
template <class S, class F>
Quantity<S> computed(const char* name, const Quantity<S>& x, F function) {
  if constexpr (is_exact<S>) {
    no_exact_value(std::string(name) + "(" + x.to_string() + ")");
  } else {
    return Quantity<S>::of(function(x.value()));
  }
}

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
    return Interval(exact_) * Interval::pi();
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

// ---- functions

template <class S>
Quantity<S> cos(const Quantity<S>& x) {
  if (is_plain_zero(x)) return Quantity<S>(1);
  if (!is_pi_multiple(x)) {
    return computed("cos", x, [](const auto& value) {
      using std::cos;
      return cos(value);
    });
  }
  if (const std::optional<Rational> exact = rational_cosine(x.exact())) return Quantity<S>(*exact);
  return Quantity<S>::of(cosine<S>(x.exact()));
}

template <class S>
Quantity<S> sin(const Quantity<S>& x) {
  if (is_plain_zero(x)) return x;
  if (!is_pi_multiple(x)) {
    return computed("sin", x, [](const auto& value) {
      using std::sin;
      return sin(value);
    });
  }
  const Rational complement = Rational(1) / Rational(2) - x.exact();
  return complement.is_zero() ? Quantity<S>(1) : cos(Quantity<S>::pi(complement));
}

template <class S>
Quantity<S> tan(const Quantity<S>& x) {
  if (is_plain_zero(x)) return x;
  if (!is_pi_multiple(x)) {
    return computed("tan", x, [](const auto& value) {
      using std::tan;
      return tan(value);
    });
  }
  const Rational turn = x.exact() - x.exact().floor();  // tan has period pi
  if (turn == Rational(1) / Rational(2)) division_by_zero("tan(" + x.to_string() + ")");
  if (turn == Rational(1) / Rational(4)) return Quantity<S>(1);
  if (turn == Rational(3) / Rational(4)) return Quantity<S>(-1);
  return sin(x) / cos(x);
}

template <class S>
Quantity<S> sqrt(const Quantity<S>& x) {
  if ((!is_number(x) && x.exact().sign() < 0) || (std::is_same_v<S, double> && is_number(x) && x.value() < S(0))) {
    throw Error(ErrorKind::input, "E_SQRT_NEGATIVE", "the square root of " + shorten(x.to_string()) + " is not real");
  }
  if (is_rational(x)) {
    if (const std::optional<Rational> root = exact_root(x.exact(), 2)) return Quantity<S>(*root);
  }
  if (is_exact<S> && is_pi_multiple(x)) no_exact_value("sqrt(" + x.to_string() + ")");
  using std::sqrt;
  return Quantity<S>::of(sqrt(x.value()));
}

template <class S>
Quantity<S> exp(const Quantity<S>& x) {
  if (is_plain_zero(x)) return Quantity<S>(1);
  return computed("exp", x, [](const auto& value) {
    using std::exp;
    return exp(value);
  });
}

template <class S>
Quantity<S> log(const Quantity<S>& x) {
  bool positive = is_number(x) || x.exact().sign() > 0;
  if constexpr (!std::is_same_v<S, Interval>) {
    if (is_number(x)) positive = x.value() > S(0);
  }
  if (!positive) {
    throw Error(ErrorKind::input, "E_LOG_DOMAIN",
                "the logarithm needs a positive number, but here it is " + shorten(x.to_string()));
  }
  if (is_rational(x) && x.exact() == Rational(1)) return Quantity<S>();
  return computed("log", x, [](const auto& value) {
    using std::log;
    return log(value);
  });
}

template <class S>
Quantity<S> abs(const Quantity<S>& x) {
  if (!is_number(x)) return x.exact().sign() < 0 ? -x : x;
  using std::abs;
  return Quantity<S>::of(abs(x.value()));
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
  if constexpr (std::is_same_v<S, Interval>) {
    if (is_number(a) || is_number(b)) {
      const Interval left = a.value();
      const Interval right = b.value();
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

// ---- powers

namespace {

double integer_power(double base, int exponent) { return std::pow(base, exponent); }
Rational integer_power(const Rational& base, int exponent) { return pow(base, exponent); }
Algebraic integer_power(const Algebraic& base, int exponent) { return pow(base, exponent); }
Interval integer_power(const Interval& base, int exponent) { return pow(base, exponent); }

[[noreturn]] void power_too_large(const std::string& exponent) {
  throw Error(ErrorKind::limit, "E_POWER_SIZE", "the exponent " + shorten(exponent) + " is too large",
              "use an exponent of at most 9 digits");
}

template <class S>
Quantity<S> power_of_integer_exponent(const Quantity<S>& base, const Rational& exponent) {
  if (exponent.is_zero()) return Quantity<S>(1);
  if (exponent == Rational(1)) return base;
  if (is_rational(base) && (base.exact().is_zero() || abs(base.exact()) == Rational(1))) {
    if (base.exact().is_zero() && exponent.sign() < 0) division_by_zero("0^" + exponent.to_string());
    const bool odd = !(exponent / Rational(2)).is_integer();
    return odd ? base : abs(base);
  }
  if (!exponent.fits_int()) power_too_large(exponent.to_string());
  const int n = exponent.to_int();
  if (is_rational(base)) return Quantity<S>(pow(base.exact(), n));
  const S value = base.value();
  if (n < 0 && is_zero(value)) division_by_zero(base.to_string() + "^" + exponent.to_string());
  return Quantity<S>::of(integer_power(value, n));
}

// base^(p/q) where it is exact: a perfect q-th power, or in Algebraic a square root that it can name.
template <class S>
std::optional<Quantity<S>> power_of_fraction(const Quantity<S>& base, const Rational& exponent) {
  const Rational p = exponent.numerator();
  const Rational q = exponent.denominator();
  if (is_rational(base) && q.fits_int()) {
    if (const std::optional<Rational> root = exact_root(base.exact(), q.to_int())) {
      return power_of_integer_exponent(Quantity<S>(*root), p);
    }
  }
  if constexpr (std::is_same_v<S, Algebraic>) {
    if (q == Rational(2) && !is_pi_multiple(base)) return power_of_integer_exponent(sqrt(base), p);
  }
  return std::nullopt;
}

// -1, 0, 1 where it is certain; 1 for an enclosure that may be positive, so that log() judges it.
template <class S>
int sign_of_base(const Quantity<S>& base) {
  if (!is_number(base)) return base.exact().sign();
  const S value = base.value();
  if (value < S(0)) return -1;
  return is_zero(value) ? 0 : 1;
}

}  // namespace

template <class S>
Quantity<S> pow(const Quantity<S>& base, const Quantity<S>& exponent) {
  if (is_rational(exponent) && exponent.exact().is_integer()) return power_of_integer_exponent(base, exponent.exact());
  const int sign = sign_of_base(base);
  if (sign < 0) {
    throw Error(
        ErrorKind::input, "E_POWER_NEGATIVE",
        "the negative number " + shorten(base.to_string()) + " has no power with the exponent " + shorten(exponent.to_string()),
        "use an integer exponent, or abs() of the base");
  }
  if (is_rational(base) && base.exact() == Rational(1)) return base;
  if (sign == 0) {
    if (compare(exponent, Quantity<S>(0)) < 0) division_by_zero(base.to_string() + "^" + exponent.to_string());
    return Quantity<S>(0);
  }
  if (is_rational(exponent)) {
    if (std::optional<Quantity<S>> exact = power_of_fraction(base, exponent.exact())) return *exact;
  }
  if constexpr (is_exact<S>) {
    no_exact_value("(" + base.to_string() + ")^(" + exponent.to_string() + ")");
  } else if constexpr (std::is_same_v<S, double>) {
    return Quantity<S>::of(std::pow(base.value(), exponent.value()));
  } else {
    return Quantity<S>::of(exp(exponent.value() * log(base.value())));
  }
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
  } else if constexpr (std::is_same_v<S, Algebraic> || std::is_same_v<S, Rational>) {
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
  template Quantity<S> cos(const Quantity<S>&);                           \
  template Quantity<S> sin(const Quantity<S>&);                           \
  template Quantity<S> tan(const Quantity<S>&);                           \
  template Quantity<S> sqrt(const Quantity<S>&);                          \
  template Quantity<S> exp(const Quantity<S>&);                           \
  template Quantity<S> log(const Quantity<S>&);                           \
  template Quantity<S> abs(const Quantity<S>&);                           \
  template Quantity<S> min(const Quantity<S>&, const Quantity<S>&);       \
  template Quantity<S> max(const Quantity<S>&, const Quantity<S>&);       \
  template Quantity<S> pow(const Quantity<S>&, const Quantity<S>&);       \
  template int compare(const Quantity<S>&, const Quantity<S>&);           \
  template Quantity<S> noise(const Rational&, int, int);                  \
  template Quantity<double> convert(const Quantity<S>&);                  \
  template Quantity<Rational> convert(const Quantity<S>&);                \
  template Quantity<Algebraic> convert(const Quantity<S>&);               \
  template Quantity<Interval> convert(const Quantity<S>&);
UDCP_FOR_EACH_NUMBER(UDCP_QUANTITY)
#undef UDCP_QUANTITY

}  // namespace udcp
