// Enclosures on MPFI. Every operation rounds outward and refuses end points that are not finite.
#include "operators/numbers/interval.h"

#include <gmp.h>
#include <mpfi.h>
#include <mpfr.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <new>
#include <ostream>

#include "operators/error.h"

namespace udcp {

// The one door to the MPFI number inside.
struct Ends {
  static mpfi_ptr of(Interval& x) { return std::launder(reinterpret_cast<mpfi_ptr>(x.storage_)); }
  static mpfi_srcptr of(const Interval& x) { return std::launder(reinterpret_cast<mpfi_srcptr>(x.storage_)); }
  static mpfr_srcptr lower(const Interval& x) { return &of(x)->left; }
  static mpfr_srcptr upper(const Interval& x) { return &of(x)->right; }
  static mpfr_ptr lower(Interval& x) { return &of(x)->left; }
  static mpfr_ptr upper(Interval& x) { return &of(x)->right; }
};

namespace {

static_assert(sizeof(__mpfi_struct) <= 64 && alignof(__mpfi_struct) <= 8);

constexpr int kLargestPrecision = 1'000'000;
constexpr mpfr_exp_t kLargestExponent = 10'000'000;  // beyond it an exact end point would fill the memory
constexpr mpfr_exp_t kLargestAngle = 100'000;  // reducing an angle of 2^k modulo pi takes k bits: beyond it [-1, 1] is the answer

thread_local int working_precision = 128;

// A GMP rational with a life span.
struct Fraction {
  Fraction() { mpq_init(value); }
  explicit Fraction(const Rational& source) : Fraction() { source.copy_to_mpq(value); }
  ~Fraction() { mpq_clear(value); }
  Fraction(const Fraction&) = delete;
  Fraction& operator=(const Fraction&) = delete;
  mpq_t value;
};

// A floating-point scratch number.
struct Scratch {
  explicit Scratch(mpfr_prec_t bits) { mpfr_init2(value, bits); }
  ~Scratch() { mpfr_clear(value); }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  mpfr_t value;
};

Rational exact(mpfr_srcptr end) {
  if (mpfr_zero_p(end) != 0) return Rational(0);
  if (std::abs(mpfr_get_exp(end)) > kLargestExponent) {
    throw Error(ErrorKind::limit, "E_NUMBER_SIZE",
                "the end point of an enclosure is too large or too small to be written as a fraction");
  }
  Fraction fraction;
  mpfr_get_q(fraction.value, end);
  return Rational::from_mpq(fraction.value);
}

bool too_many_turns(mpfi_srcptr x) {
  const auto far = [](mpfr_srcptr end) { return mpfr_zero_p(end) == 0 && mpfr_get_exp(end) > kLargestAngle; };
  return far(&x->left) || far(&x->right);
}

// `digits` significant digits of an end point, rounded as told; plain notation near 1, otherwise with an exponent.
std::string decimal(mpfr_srcptr end, int digits, mpfr_rnd_t rounding) {
  if (mpfr_zero_p(end) != 0) return "0";
  digits = std::clamp(digits, 1, 400'000);
  mpfr_exp_t point = 0;  // the value is 0.DIGITS * 10^point
  char* raw = mpfr_get_str(nullptr, &point, 10, static_cast<std::size_t>(digits), end, rounding);
  std::string text(raw);
  mpfr_free_str(raw);
  const bool negative = text.front() == '-';
  if (negative) text.erase(0, 1);
  text.erase(text.find_last_not_of('0') + 1);
  const auto size = static_cast<mpfr_exp_t>(text.size());
  if (point > -5 && point <= 0) {
    text.insert(0, static_cast<std::size_t>(-point), '0');
    text = std::string("0.").append(text);
  } else if (point > 0 && point <= std::max(digits, 6)) {
    if (size <= point) {
      text.append(static_cast<std::size_t>(point - size), '0');
    } else {
      text.insert(static_cast<std::size_t>(point), 1, '.');
    }
  } else {
    if (size > 1) text.insert(1, 1, '.');
    text.append("e").append(std::to_string(point - 1));
  }
  if (negative) text.insert(0, 1, '-');
  return text;
}

}  // namespace

// ---- life

void Interval::make() { mpfi_init2(Ends::of(*this), working_precision); }

void Interval::widen() {
  if (mpfi_get_prec(Ends::of(*this)) != static_cast<mpfr_prec_t>(working_precision)) {
    mpfi_round_prec(Ends::of(*this), working_precision);
  }
}

Interval& Interval::checked(const char* operation) {
  if (mpfr_number_p(Ends::lower(*this)) == 0 || mpfr_number_p(Ends::upper(*this)) == 0) {
    mpfi_set_si(Ends::of(*this), 0);
    throw Error(ErrorKind::limit, "E_NOT_FINITE", std::string("the enclosure of a ") + operation + " is not bounded",
                "raise the precision or keep the operands away from infinity");
  }
  return *this;
}

Interval::Interval() {
  make();
  mpfi_set_si(Ends::of(*this), 0);
}

Interval::Interval(int value) {
  make();
  mpfi_set_si(Ends::of(*this), value);
}

Interval::Interval(const Rational& value) {
  make();
  if (value.fits_int()) {
    mpfi_set_si(Ends::of(*this), value.to_int());
  } else {
    mpfi_set_q(Ends::of(*this), Fraction(value).value);
  }
}

Interval::Interval(const Rational& lower, const Rational& upper) {
  if (lower > upper) {
    throw Error(ErrorKind::input, "E_INTERVAL_ORDER",
                "the interval [" + lower.to_string().substr(0, 40) + ", " + upper.to_string().substr(0, 40) + "] is empty",
                "write the smaller end first");
  }
  make();
  mpfi_interv_q(Ends::of(*this), Fraction(lower).value, Fraction(upper).value);
}

Interval Interval::from_double(double value) {
  if (!std::isfinite(value)) {
    throw Error(ErrorKind::input, "E_NOT_FINITE", "an infinite or undefined floating-point number has no enclosure");
  }
  Interval result;
  mpfi_set_d(Ends::of(result), value);
  return result;
}

Interval Interval::pi() {
  Interval result;
  mpfi_const_pi(Ends::of(result));
  return result;
}

Interval Interval::hull(const Interval& a, const Interval& b) {
  Interval result;
  mpfi_union(Ends::of(result), Ends::of(a), Ends::of(b));
  return result;
}

Interval::Interval(const Interval& other) {
  mpfi_init2(Ends::of(*this), mpfi_get_prec(Ends::of(other)));
  mpfi_set(Ends::of(*this), Ends::of(other));
}

// MPFI numbers may be moved bit by bit: their limbs lie outside.
Interval::Interval(Interval&& other) noexcept : alive_(other.alive_) {
  std::memcpy(storage_, other.storage_, sizeof storage_);
  other.alive_ = false;
}

Interval& Interval::operator=(const Interval& other) {
  if (this != &other) *this = Interval(other);
  return *this;
}

Interval& Interval::operator=(Interval&& other) noexcept {
  std::swap(storage_, other.storage_);
  std::swap(alive_, other.alive_);
  return *this;
}

Interval::~Interval() {
  if (alive_) mpfi_clear(Ends::of(*this));
}

void Interval::set_precision(int bits) {
  if (bits < 2 || bits > kLargestPrecision) {
    throw Error(ErrorKind::input, "E_PRECISION", "a precision of " + std::to_string(bits) + " bits is not possible",
                "choose a precision from 2 to 1000000 bits");
  }
  working_precision = bits;
}

int Interval::precision() { return working_precision; }

// ---- arithmetic

Interval& Interval::operator+=(const Interval& other) {
  widen();
  mpfi_add(Ends::of(*this), Ends::of(*this), Ends::of(other));
  return checked("sum");
}

Interval& Interval::operator-=(const Interval& other) {
  widen();
  mpfi_sub(Ends::of(*this), Ends::of(*this), Ends::of(other));
  return checked("difference");
}

Interval& Interval::operator*=(const Interval& other) {
  widen();
  mpfi_mul(Ends::of(*this), Ends::of(*this), Ends::of(other));
  return checked("product");
}

Interval& Interval::operator/=(const Interval& other) {
  if (other.contains_zero()) {
    throw Error(ErrorKind::input, "E_DIV0", "division by an enclosure that contains zero: " + other.to_string(),
                "raise the precision, or keep the denominator away from zero");
  }
  widen();
  mpfi_div(Ends::of(*this), Ends::of(*this), Ends::of(other));
  return checked("quotient");
}

Interval Interval::operator-() const {
  Interval result;
  mpfi_neg(Ends::of(result), Ends::of(*this));
  return result;
}

// ---- comparison and parts

bool Interval::certainly_equal(const Interval& other) const {
  return is_point() && other.is_point() && mpfr_equal_p(Ends::lower(*this), Ends::lower(other)) != 0;
}

bool Interval::certainly_less(const Interval& other) const { return mpfr_less_p(Ends::upper(*this), Ends::lower(other)) != 0; }

bool Interval::certainly_less_equal(const Interval& other) const {
  return mpfr_lessequal_p(Ends::upper(*this), Ends::lower(other)) != 0;
}

Rational Interval::lower() const { return exact(Ends::lower(*this)); }
Rational Interval::upper() const { return exact(Ends::upper(*this)); }

bool Interval::contains(const Rational& value) const {
  const Fraction fraction(value);
  return mpfr_cmp_q(Ends::lower(*this), fraction.value) <= 0 && mpfr_cmp_q(Ends::upper(*this), fraction.value) >= 0;
}

bool Interval::contains(const Interval& other) const {
  return mpfr_lessequal_p(Ends::lower(*this), Ends::lower(other)) != 0 &&
         mpfr_lessequal_p(Ends::upper(other), Ends::upper(*this)) != 0;
}

bool Interval::contains_zero() const { return mpfr_sgn(Ends::lower(*this)) <= 0 && mpfr_sgn(Ends::upper(*this)) >= 0; }

bool Interval::is_point() const { return mpfr_equal_p(Ends::lower(*this), Ends::upper(*this)) != 0; }

double Interval::midpoint() const {
  if (is_point()) return mpfr_get_d(Ends::lower(*this), MPFR_RNDN);
  Scratch middle(53);
  mpfr_add(middle.value, Ends::lower(*this), Ends::upper(*this), MPFR_RNDN);
  mpfr_div_2ui(middle.value, middle.value, 1, MPFR_RNDN);
  return mpfr_get_d(middle.value, MPFR_RNDN);
}

double Interval::width() const {
  Scratch difference(53);
  mpfr_sub(difference.value, Ends::upper(*this), Ends::lower(*this), MPFR_RNDU);
  return mpfr_get_d(difference.value, MPFR_RNDU);
}

std::string Interval::lower_decimal(int digits) const { return decimal(Ends::lower(*this), digits, MPFR_RNDD); }
std::string Interval::upper_decimal(int digits) const { return decimal(Ends::upper(*this), digits, MPFR_RNDU); }
std::string Interval::to_string(int digits) const {
  return std::string("[").append(lower_decimal(digits)).append(", ").append(upper_decimal(digits)).append("]");
}

std::ostream& operator<<(std::ostream& out, const Interval& value) { return out << value.to_string(); }

// ---- functions

Interval cos(const Interval& x) {
  if (too_many_turns(Ends::of(x))) return Interval(Rational(-1), Rational(1));
  Interval result;
  mpfi_cos(Ends::of(result), Ends::of(x));
  return result.checked("cosine");
}

Interval sin(const Interval& x) {
  if (too_many_turns(Ends::of(x))) return Interval(Rational(-1), Rational(1));
  Interval result;
  mpfi_sin(Ends::of(result), Ends::of(x));
  return result.checked("sine");
}

Interval tan(const Interval& x) {
  Interval result;
  const bool lost = too_many_turns(Ends::of(x));
  if (!lost) mpfi_tan(Ends::of(result), Ends::of(x));
  if (lost || mpfi_bounded_p(Ends::of(result)) == 0) {
    throw Error(ErrorKind::input, "E_DIV0", "the tangent of " + x.to_string() + " is unbounded",
                "keep the argument away from odd multiples of pi/2");
  }
  return result;
}

Interval exp(const Interval& x) {
  Interval result;
  mpfi_exp(Ends::of(result), Ends::of(x));
  return result.checked("exponential");
}

Interval log(const Interval& x) {
  if (mpfr_sgn(Ends::lower(x)) <= 0) {
    throw Error(ErrorKind::input, "E_LOG_DOMAIN", "the logarithm needs a positive number, but here it is " + x.to_string());
  }
  Interval result;
  mpfi_log(Ends::of(result), Ends::of(x));
  return result.checked("logarithm");
}

Interval sqrt(const Interval& x) {
  if (mpfr_sgn(Ends::lower(x)) < 0) {
    throw Error(ErrorKind::input, "E_SQRT_NEGATIVE",
                "the square root needs a number that is not negative, but here it is " + x.to_string());
  }
  Interval result;
  mpfi_sqrt(Ends::of(result), Ends::of(x));
  return result.checked("square root");
}

Interval abs(const Interval& x) {
  Interval result;
  mpfi_abs(Ends::of(result), Ends::of(x));
  return result;
}

Interval min(const Interval& a, const Interval& b) {
  Interval result;
  mpfr_min(Ends::lower(result), Ends::lower(a), Ends::lower(b), MPFR_RNDD);
  mpfr_min(Ends::upper(result), Ends::upper(a), Ends::upper(b), MPFR_RNDU);
  return result;
}

Interval max(const Interval& a, const Interval& b) {
  Interval result;
  mpfr_max(Ends::lower(result), Ends::lower(a), Ends::lower(b), MPFR_RNDD);
  mpfr_max(Ends::upper(result), Ends::upper(a), Ends::upper(b), MPFR_RNDU);
  return result;
}

// Monotone on each side of 0, so that the end points decide; tighter than repeated products.
Interval pow(const Interval& base, int exponent) {
  if (exponent == 0) return Interval(1);
  if (exponent < 0 && base.contains_zero()) {
    throw Error(ErrorKind::input, "E_DIV0", "a negative power of an enclosure that contains zero: " + base.to_string(),
                "raise the precision, or keep the base away from zero");
  }
  const Interval x = exponent % 2 == 0 ? abs(base) : base;
  const bool rising = exponent > 0;
  Interval result;
  mpfr_pow_si(Ends::lower(result), rising ? Ends::lower(x) : Ends::upper(x), exponent, MPFR_RNDD);
  mpfr_pow_si(Ends::upper(result), rising ? Ends::upper(x) : Ends::lower(x), exponent, MPFR_RNDU);
  return result.checked("power");
}

}  // namespace udcp
