// Rational arithmetic: 64-bit integers while everything fits, Boost's GMP rational from there on; correctly rounded conversion.
#include "operators/numbers/rational.h"

#include <gmp.h>

#include <algorithm>
#include <boost/multiprecision/gmp.hpp>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <numeric>
#include <ostream>

#include "operators/error.h"

namespace udcp {
namespace {

constexpr std::int64_t kLargest = std::numeric_limits<std::int64_t>::max();
constexpr std::size_t kLargestPower = 10'000'000;  // bits

std::int64_t gcd(std::int64_t a, std::int64_t b) { return std::gcd(a, b); }

[[noreturn]] void division_by_zero() {
  throw Error(ErrorKind::input, "E_DIV0", "division by zero", "check the denominator, or guard it with if ... then ... else");
}

struct Integer {
  Integer() { mpz_init(value); }
  ~Integer() { mpz_clear(value); }
  Integer(const Integer&) = delete;
  Integer& operator=(const Integer&) = delete;
  mpz_t value;
};

// mpz_set_si takes a long; int64_t is one on every platform that we build for, and the assertion says so.
static_assert(sizeof(long) == sizeof(std::int64_t));

bool fits(mpz_srcptr value) { return mpz_fits_slong_p(value) != 0 && mpz_get_si(value) != std::numeric_limits<long>::min(); }

}  // namespace

struct Rational::Big {
  Big() = default;
  Big(const Big&) = delete;
  Big& operator=(const Big&) = delete;
  boost::multiprecision::mpq_rational number;
  mpq_ptr value = number.backend().data();
};

struct Rational::View {
  explicit View(const Rational& source) {
    if (source.is_big()) {
      value = source.big()->value;
    } else {
      mpz_set_si(mpq_numref(own.value), source.numerator_);
      mpz_set_si(mpq_denref(own.value), source.denominator_);
      value = own.value;
    }
  }
  Big own;
  mpq_srcptr value = nullptr;
};

Rational Rational::adopt(std::int64_t numerator, std::int64_t denominator) {
  Rational result;
  result.numerator_ = numerator;
  result.denominator_ = denominator;
  return result;
}

Rational::Big* Rational::big() const { return reinterpret_cast<Big*>(numerator_); }

void Rational::hold(Big* value) {
  if (fits(mpq_numref(value->value)) && fits(mpq_denref(value->value))) {
    numerator_ = mpz_get_si(mpq_numref(value->value));
    denominator_ = mpz_get_si(mpq_denref(value->value));
    delete value;
  } else {
    numerator_ = reinterpret_cast<std::int64_t>(value);
    denominator_ = 0;
  }
}

void Rational::clone() {
  Big* copy = new Big;
  mpq_set(copy->value, big()->value);
  numerator_ = reinterpret_cast<std::int64_t>(copy);
}

void Rational::release() noexcept { delete big(); }

Rational::Rational(long value) : numerator_(value), denominator_(1) {
  if (value < -kLargest) {
    Big* wide = new Big;
    mpz_set_si(mpq_numref(wide->value), value);
    hold(wide);
  }
}

Rational::Rational(long long value) : Rational(static_cast<long>(value)) {}

void Rational::copy_to_mpq(void* target) const { mpq_set(static_cast<mpq_ptr>(target), View(*this).value); }

Rational Rational::from_mpq(const void* source) {
  Big* copy = new Big;
  mpq_set(copy->value, static_cast<mpq_srcptr>(source));
  Rational result;
  result.hold(copy);
  return result;
}

// ---- arithmetic

bool Rational::add_small(const Rational& other, int sign) {
  if (is_big() || other.is_big()) return false;
  const std::int64_t other_numerator = sign < 0 ? -other.numerator_ : other.numerator_;
  const std::int64_t common = denominator_ == other.denominator_ ? denominator_ : gcd(denominator_, other.denominator_);
  const std::int64_t left = other.denominator_ / common;
  const std::int64_t right = denominator_ / common;
  std::int64_t a = 0;
  std::int64_t b = 0;
  std::int64_t sum = 0;
  if (__builtin_mul_overflow(numerator_, left, &a) || __builtin_mul_overflow(other_numerator, right, &b) ||
      __builtin_add_overflow(a, b, &sum) || sum < -kLargest) {
    return false;
  }
  // Only divisors of `common` can be shared by the sum and the common denominator (Knuth, vol. 2, section 4.5.1).
  const std::int64_t shared = common == 1 ? 1 : gcd(sum, common);
  std::int64_t denominator = 0;
  if (__builtin_mul_overflow(right, other.denominator_ / shared, &denominator)) return false;
  numerator_ = sum / shared;
  denominator_ = sum == 0 ? 1 : denominator;
  return true;
}

bool Rational::multiply_small(std::int64_t numerator, std::int64_t denominator) {
  if (is_big() || denominator == 0) return false;
  const std::int64_t first = denominator == 1 ? 1 : gcd(numerator_, denominator);
  const std::int64_t second = denominator_ == 1 ? 1 : gcd(numerator, denominator_);
  std::int64_t top = 0;
  std::int64_t bottom = 0;
  if (__builtin_mul_overflow(numerator_ / first, numerator / second, &top) || top < -kLargest ||
      __builtin_mul_overflow(denominator_ / second, denominator / first, &bottom)) {
    return false;
  }
  numerator_ = top;
  denominator_ = top == 0 ? 1 : bottom;
  return true;
}

template <class Operation>
void Rational::combine(const Rational& other, Operation operation) {
  Big* result = new Big;
  {
    const View a(*this);
    const View b(other);
    operation(result->value, a.value, b.value);
  }
  if (is_big()) release();
  hold(result);
}

Rational& Rational::operator+=(const Rational& other) {
  if (!add_small(other, 1)) combine(other, mpq_add);
  return *this;
}

Rational& Rational::operator-=(const Rational& other) {
  if (!add_small(other, -1)) combine(other, mpq_sub);
  return *this;
}

Rational& Rational::operator*=(const Rational& other) {
  if (other.is_big() || !multiply_small(other.numerator_, other.denominator_)) combine(other, mpq_mul);
  return *this;
}

Rational& Rational::operator/=(const Rational& other) {
  if (other.is_zero()) division_by_zero();
  const bool negative = other.numerator_ < 0;
  if (other.is_big() ||
      !multiply_small(negative ? -other.denominator_ : other.denominator_, negative ? -other.numerator_ : other.numerator_)) {
    combine(other, mpq_div);
  }
  return *this;
}

Rational Rational::operator-() const {
  Rational result(*this);
  if (result.is_big()) {
    mpq_neg(result.big()->value, result.big()->value);
  } else {
    result.numerator_ = -result.numerator_;
  }
  return result;
}

int Rational::compare(const Rational& other) const {
  if (!is_big() && !other.is_big()) {
    std::int64_t a = 0;
    std::int64_t b = 0;
    if (!__builtin_mul_overflow(numerator_, other.denominator_, &a) &&
        !__builtin_mul_overflow(other.numerator_, denominator_, &b)) {
      return a < b ? -1 : (a > b ? 1 : 0);
    }
  }
  const int order = mpq_cmp(View(*this).value, View(other).value);
  return order < 0 ? -1 : (order > 0 ? 1 : 0);
}

// ---- parts

int Rational::sign() const {
  if (is_big()) return mpq_sgn(big()->value);
  return numerator_ < 0 ? -1 : (numerator_ > 0 ? 1 : 0);
}

bool Rational::is_integer() const { return is_big() ? mpz_cmp_ui(mpq_denref(big()->value), 1) == 0 : denominator_ == 1; }

Rational Rational::numerator() const {
  if (!is_big()) return adopt(numerator_, 1);
  Big* result = new Big;
  mpz_set(mpq_numref(result->value), mpq_numref(big()->value));
  Rational integer;
  integer.hold(result);
  return integer;
}

Rational Rational::denominator() const {
  if (!is_big()) return adopt(denominator_, 1);
  Big* result = new Big;
  mpz_set(mpq_numref(result->value), mpq_denref(big()->value));
  Rational integer;
  integer.hold(result);
  return integer;
}

Rational Rational::floor() const {
  if (!is_big()) {
    const std::int64_t quotient = numerator_ / denominator_;
    return adopt(numerator_ % denominator_ < 0 ? quotient - 1 : quotient, 1);
  }
  Big* result = new Big;
  mpz_fdiv_q(mpq_numref(result->value), mpq_numref(big()->value), mpq_denref(big()->value));
  Rational integer;
  integer.hold(result);
  return integer;
}

bool Rational::fits_int() const {
  return denominator_ == 1 && numerator_ >= std::numeric_limits<int>::min() && numerator_ <= std::numeric_limits<int>::max();
}

int Rational::to_int() const { return static_cast<int>(numerator_); }

std::uint64_t Rational::low_bits() const {
  if (!is_big()) return static_cast<std::uint64_t>(numerator_);
  Integer remainder;
  mpz_fdiv_r_2exp(remainder.value, mpq_numref(big()->value), 64);
  return mpz_get_ui(remainder.value);
}

std::size_t Rational::bits() const {
  const View view(*this);
  return mpz_sizeinbase(mpq_numref(view.value), 2) + mpz_sizeinbase(mpq_denref(view.value), 2);
}

// ---- conversion

double Rational::to_double() const {
  constexpr std::int64_t exact = std::int64_t{1} << 53;
  if (!is_big() && numerator_ >= -exact && numerator_ <= exact && denominator_ <= exact) {
    return static_cast<double>(numerator_) / static_cast<double>(denominator_);  // one rounding
  }
  const View view(*this);
  const auto length = [](mpz_srcptr integer) { return static_cast<long>(mpz_sizeinbase(integer, 2)); };
  const long size = length(mpq_numref(view.value)) - length(mpq_denref(view.value));  // 2^(size-1) < |value| < 2^(size+1)
  const double direction = sign() < 0 ? -1.0 : 1.0;
  if (size > 1030) return direction * std::numeric_limits<double>::infinity();
  if (size < -1080) return direction * 0.0;
  Integer scaled;
  Integer divisor;
  Integer quotient;
  Integer remainder;
  // |value| = quotient * 2^unit + rest with a quotient of 53 bits (fewer where doubles are subnormal).
  for (long unit = std::max(size - 53, -1074L);; ++unit) {
    mpz_abs(scaled.value, mpq_numref(view.value));
    mpz_set(divisor.value, mpq_denref(view.value));
    if (unit < 0) mpz_mul_2exp(scaled.value, scaled.value, static_cast<mp_bitcnt_t>(-unit));
    if (unit > 0) mpz_mul_2exp(divisor.value, divisor.value, static_cast<mp_bitcnt_t>(unit));
    mpz_fdiv_qr(quotient.value, remainder.value, scaled.value, divisor.value);
    if (mpz_sizeinbase(quotient.value, 2) > 53) continue;
    mpz_mul_2exp(remainder.value, remainder.value, 1);
    const int half = mpz_cmp(remainder.value, divisor.value);
    if (half > 0 || (half == 0 && mpz_odd_p(quotient.value))) mpz_add_ui(quotient.value, quotient.value, 1);
    return direction * std::ldexp(mpz_get_d(quotient.value), static_cast<int>(unit));
  }
}

Rational Rational::from_double(double value) {
  if (!std::isfinite(value)) {
    throw Error(ErrorKind::not_exact, "E_NOT_FINITE", "an infinite or undefined floating-point number has no exact value");
  }
  Big* result = new Big;
  mpq_set_d(result->value, value);
  Rational rational;
  rational.hold(result);
  return rational;
}

std::string Rational::to_string() const {
  if (!is_big()) {
    return denominator_ == 1 ? std::to_string(numerator_) : std::to_string(numerator_) + "/" + std::to_string(denominator_);
  }
  std::string text(mpz_sizeinbase(mpq_numref(big()->value), 10) + mpz_sizeinbase(mpq_denref(big()->value), 10) + 3, '\0');
  mpq_get_str(text.data(), 10, big()->value);
  text.resize(text.find('\0'));
  return text;
}

// ---- functions

Rational abs(const Rational& value) { return value.sign() < 0 ? -value : value; }

Rational pow(const Rational& base, int exponent) {
  if (exponent == 0) return Rational(1);
  if (base.is_zero() && exponent < 0) division_by_zero();
  if (base.is_zero() || base == Rational(1)) return base;
  const auto count = static_cast<unsigned long>(std::labs(exponent));
  if (base == Rational(-1)) return count % 2 == 0 ? Rational(1) : base;
  if (base.bits() > kLargestPower / count) {
    throw Error(ErrorKind::limit, "E_POWER_SIZE", "the power " + std::to_string(exponent) + " of a fraction has too many digits",
                "use a smaller exponent");
  }
  const Rational forward = exponent < 0 ? Rational(1) / base : base;
  mpq_t power;
  mpq_init(power);
  forward.copy_to_mpq(power);
  mpz_pow_ui(mpq_numref(power), mpq_numref(power), count);  // powers of coprime integers are coprime
  mpz_pow_ui(mpq_denref(power), mpq_denref(power), count);
  Rational result = Rational::from_mpq(power);
  mpq_clear(power);
  return result;
}

std::optional<Rational> exact_root(const Rational& value, int n) {
  mpq_t root;
  mpq_init(root);
  value.copy_to_mpq(root);
  const auto degree = static_cast<unsigned long>(n);
  const bool exact =
      mpz_root(mpq_numref(root), mpq_numref(root), degree) != 0 && mpz_root(mpq_denref(root), mpq_denref(root), degree) != 0;
  std::optional<Rational> result;
  if (exact) result = Rational::from_mpq(root);
  mpq_clear(root);
  return result;
}

Rational sqrt(const Rational& value) {
  if (value.sign() < 0) {
    throw Error(ErrorKind::input, "E_SQRT_NEGATIVE", "the square root of " + value.to_string().substr(0, 60) + " is not real");
  }
  if (std::optional<Rational> root = exact_root(value, 2)) return *root;
  throw Error(ErrorKind::not_exact, "E_NOT_EXACT", "the square root of " + value.to_string().substr(0, 60) + " is irrational",
              "compute in algebraic numbers, enclosures or floating point");
}

std::ostream& operator<<(std::ostream& out, const Rational& value) { return out << value.to_string(); }

}  // namespace udcp
