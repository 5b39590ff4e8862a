// Functions and powers of quantities: values that are exact in every number type first, then those that the type itself has.
#include "operators/quantity_kinds.h"

namespace udcp {
namespace {

// A function without exact values: computed in double and Interval, refused by the exact types.
template <class S, class F>
Quantity<S> computed(const char* name, const Quantity<S>& x, F function) {
  if constexpr (is_exact<S>) {
    no_exact_value(std::string(name) + "(" + x.to_string() + ")");
  } else {
    return Quantity<S>::of(function(x.value()));
  }
}

// Not certainly zero or negative. A formula in free parameters may be anything.
template <class S>
bool may_be_positive(const S& x) {
  return !(x <= S(0));
}
bool may_be_positive(const Parametric&) { return true; }

}  // namespace

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
  if (is_number(x) ? !may_be_positive(x.value()) : x.exact().sign() <= 0) {
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

// ---- powers

namespace {

double integer_power(double base, int exponent) { return std::pow(base, exponent); }
Rational integer_power(const Rational& base, int exponent) { return pow(base, exponent); }
Algebraic integer_power(const Algebraic& base, int exponent) { return pow(base, exponent); }
Interval integer_power(const Interval& base, int exponent) { return pow(base, exponent); }
Parametric integer_power(const Parametric& base, int exponent) { return pow(base, exponent); }
Jet integer_power(const Jet& base, int exponent) { return pow(base, exponent); }

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
  if (may_be_positive(value)) return 1;
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

#define UDCP_QUANTITY(S)                         \
  template Quantity<S> cos(const Quantity<S>&);  \
  template Quantity<S> sin(const Quantity<S>&);  \
  template Quantity<S> tan(const Quantity<S>&);  \
  template Quantity<S> sqrt(const Quantity<S>&); \
  template Quantity<S> exp(const Quantity<S>&);  \
  template Quantity<S> log(const Quantity<S>&);  \
  template Quantity<S> abs(const Quantity<S>&);  \
  template Quantity<S> pow(const Quantity<S>&, const Quantity<S>&);
UDCP_FOR_EACH_NUMBER(UDCP_QUANTITY)
#undef UDCP_QUANTITY

}  // namespace udcp
