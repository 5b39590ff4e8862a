// Exact rational numbers, always in lowest terms. Values that fit two 64-bit integers are kept in place (subdivision weights
// nearly always do); larger ones own a Boost mpq_rational. Boost stays in rational.cpp, as its expressions and Eigen's do not
// mix.
#pragma once

#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace udcp {

class Rational {
 public:
  Rational() noexcept : numerator_(0), denominator_(1) {}
  Rational(int value) noexcept : numerator_(value), denominator_(1) {}  // NOLINT: integers convert, as they do for double
  Rational(long value);                                                 // NOLINT
  Rational(long long value);                                            // NOLINT
  Rational(double) = delete;  // no exact value ever comes from a double; from_double says so aloud
  Rational(const Rational& other) : numerator_(other.numerator_), denominator_(other.denominator_) {
    if (is_big()) clone();
  }
  Rational(Rational&& other) noexcept : numerator_(other.numerator_), denominator_(std::exchange(other.denominator_, 1)) {
    other.numerator_ = 0;
  }
  Rational& operator=(const Rational& other) { return *this = Rational(other); }
  Rational& operator=(Rational&& other) noexcept {
    std::swap(numerator_, other.numerator_);
    std::swap(denominator_, other.denominator_);
    return *this;
  }
  ~Rational() {
    if (is_big()) release();
  }

  /// "12", "-3/4", "0.8", "1.5e-3", also "+1", "5." and ".5" as files have them (ASCII, no blanks). Throws Error{input} for
  /// anything else (E_NUMBER), a zero denominator (E_DIV0), an exponent beyond 10000 in modulus or more than 100000 characters
  /// (E_NUMBER_SIZE).
  static Rational parse(std::string_view text);
  /// The dyadic rational that a finite double is. Throws Error{not_exact, "E_NOT_FINITE"} for infinities and NaN.
  static Rational from_double(double value);

  Rational& operator+=(const Rational&);
  Rational& operator-=(const Rational&);
  Rational& operator*=(const Rational&);
  Rational& operator/=(const Rational&);  // throws Error{input, "E_DIV0"} for zero
  friend Rational operator+(Rational a, const Rational& b) { return std::move(a += b); }
  friend Rational operator-(Rational a, const Rational& b) { return std::move(a -= b); }
  friend Rational operator*(Rational a, const Rational& b) { return std::move(a *= b); }
  friend Rational operator/(Rational a, const Rational& b) { return std::move(a /= b); }
  Rational operator-() const;
  Rational operator+() const { return *this; }

  [[nodiscard]] int compare(const Rational&) const;  // -1, 0, 1
  friend bool operator==(const Rational& a, const Rational& b) { return a.equals(b); }
  friend bool operator!=(const Rational& a, const Rational& b) { return !a.equals(b); }
  friend bool operator<(const Rational& a, const Rational& b) { return a.compare(b) < 0; }
  friend bool operator>(const Rational& a, const Rational& b) { return a.compare(b) > 0; }
  friend bool operator<=(const Rational& a, const Rational& b) { return a.compare(b) <= 0; }
  friend bool operator>=(const Rational& a, const Rational& b) { return a.compare(b) >= 0; }

  [[nodiscard]] int sign() const;
  [[nodiscard]] bool is_zero() const { return denominator_ == 1 && numerator_ == 0; }
  [[nodiscard]] bool is_integer() const;
  [[nodiscard]] Rational numerator() const;
  [[nodiscard]] Rational denominator() const;  // positive
  [[nodiscard]] Rational floor() const;
  [[nodiscard]] bool fits_int() const;           // an integer that fits int
  [[nodiscard]] int to_int() const;              // requires fits_int()
  [[nodiscard]] std::uint64_t low_bits() const;  // an integer modulo 2^64; requires is_integer()
  [[nodiscard]] double to_double() const;        // nearest double, ties to even; infinite beyond the largest double
  [[nodiscard]] std::string to_string() const;   // "p/q", "p" for integers
  [[nodiscard]] std::size_t bits() const;        // size of numerator plus denominator

  // The door to GMP, for interval.cpp only: the value into an initialised mpq_ptr, and the value of a canonical mpq_srcptr.
  void copy_to_mpq(void* target) const;
  static Rational from_mpq(const void* source);

 private:
  struct Big;                                                               // owns an mpq_t
  struct View;                                                              // either form as an mpq_srcptr
  static Rational adopt(std::int64_t numerator, std::int64_t denominator);  // in lowest terms, denominator positive
  [[nodiscard]] bool is_big() const { return denominator_ == 0; }
  [[nodiscard]] bool equals(const Rational& other) const {
    if (is_big() && other.is_big()) return compare(other) == 0;
    return numerator_ == other.numerator_ && denominator_ == other.denominator_;
  }
  [[nodiscard]] Big* big() const;
  void hold(Big* value);  // takes a canonical value over, in place if it fits
  void clone();
  void release() noexcept;
  bool add_small(const Rational& other, int sign);  // false if it does not fit; then nothing has changed
  bool multiply_small(std::int64_t numerator, std::int64_t denominator);
  template <class Operation>
  void combine(const Rational& other, Operation operation);

  // In place: numerator_/denominator_, coprime, |numerator_| < 2^63, denominator_ > 0. Otherwise denominator_ is 0 and numerator_
  // is the address of a Big; a value that fits is never big, so that equality is equality of members.
  std::int64_t numerator_;
  std::int64_t denominator_;
};

Rational abs(const Rational&);
Rational pow(const Rational& base,
             int exponent);  // E_DIV0 for 0 to a negative power; Error{limit, "E_POWER_SIZE"} past 10 million bits
/// Square root where it is rational; Error{not_exact, "E_NOT_EXACT"} otherwise, Error{input, "E_SQRT_NEGATIVE"} for negative
/// values.
Rational sqrt(const Rational&);
/// The non-negative n-th root of a non-negative value if it is rational; n >= 1.
std::optional<Rational> exact_root(const Rational& value, int n);
std::ostream& operator<<(std::ostream&, const Rational&);

}  // namespace udcp
