// Enclosures: closed intervals with multi-precision end points, always rounded outward (MPFI). There is no unverified mode.
// Comparisons answer "certainly true"; code that branches on them lives in proofs/ and handles "cannot tell".
#pragma once

#include <iosfwd>
#include <string>

#include "operators/numbers/rational.h"

namespace udcp {

class Interval {
 public:
  Interval();                                              // [0, 0]
  Interval(int value);                                     // NOLINT: integers convert (exactly, from 32 bits of precision on)
  Interval(double) = delete;                               // from_double says so aloud
  explicit Interval(const Rational& value);                // the tightest enclosure in working precision
  Interval(const Rational& lower, const Rational& upper);  // Error{input, "E_INTERVAL_ORDER"} if lower > upper
  static Interval from_double(double value);  // a point (from 53 bits on); Error{input, "E_NOT_FINITE"} unless finite
  static Interval pi();
  static Interval hull(const Interval&, const Interval&);
  Interval(const Interval&);
  Interval(Interval&&) noexcept;
  Interval& operator=(const Interval&);
  Interval& operator=(Interval&&) noexcept;
  ~Interval();

  /// Bits of the end points of every value made from now on in this thread (default 128; 2 to 1,000,000, else
  /// Error{input, "E_PRECISION"}). Copies keep the precision of their source.
  static void set_precision(int bits);
  static int precision();
  /// Another working precision until the end of the scope.
  class Precision {
   public:
    explicit Precision(int bits) : before_(precision()) { set_precision(bits); }
    ~Precision() { set_precision(before_); }
    Precision(const Precision&) = delete;
    Precision& operator=(const Precision&) = delete;

   private:
    int before_;
  };

  // Every operation throws Error{limit, "E_NOT_FINITE"} where an end point would become infinite; NaN cannot occur.
  Interval& operator+=(const Interval&);
  Interval& operator-=(const Interval&);
  Interval& operator*=(const Interval&);
  Interval& operator/=(const Interval&);  // Error{input, "E_DIV0"} if the divisor contains 0
  friend Interval operator+(Interval a, const Interval& b) { return a += b; }
  friend Interval operator-(Interval a, const Interval& b) { return a -= b; }
  friend Interval operator*(Interval a, const Interval& b) { return a *= b; }
  friend Interval operator/(Interval a, const Interval& b) { return a /= b; }
  Interval operator-() const;

  // Certainly true, for every pair of members. `!(a < b)` does not mean a >= b. Equality holds only between equal points.
  friend bool operator==(const Interval& a, const Interval& b) { return a.certainly_equal(b); }
  friend bool operator!=(const Interval& a, const Interval& b) { return a.certainly_less(b) || b.certainly_less(a); }
  friend bool operator<(const Interval& a, const Interval& b) { return a.certainly_less(b); }
  friend bool operator>(const Interval& a, const Interval& b) { return b.certainly_less(a); }
  friend bool operator<=(const Interval& a, const Interval& b) { return a.certainly_less_equal(b); }
  friend bool operator>=(const Interval& a, const Interval& b) { return b.certainly_less_equal(a); }

  [[nodiscard]] Rational lower() const;  // exact end points; Error{limit, "E_NUMBER_SIZE"} past 10 million bits
  [[nodiscard]] Rational upper() const;
  [[nodiscard]] bool contains(const Rational&) const;
  [[nodiscard]] bool contains(const Interval&) const;
  [[nodiscard]] bool contains_zero() const;
  [[nodiscard]] bool is_point() const;
  [[nodiscard]] double midpoint() const;                       // nearest double to the middle: evidence, not a bound
  [[nodiscard]] double width() const;                          // rounded up
  [[nodiscard]] std::string lower_decimal(int digits) const;   // rounded down
  [[nodiscard]] std::string upper_decimal(int digits) const;   // rounded up
  [[nodiscard]] std::string to_string(int digits = 17) const;  // "[lo, hi]"

  friend Interval cos(const Interval&);
  friend Interval sin(const Interval&);
  friend Interval tan(const Interval&);  // E_DIV0 where it is unbounded
  friend Interval exp(const Interval&);
  friend Interval log(const Interval&);   // Error{input, "E_LOG_DOMAIN"} unless certainly positive
  friend Interval sqrt(const Interval&);  // Error{input, "E_SQRT_NEGATIVE"} if certainly or possibly negative
  friend Interval abs(const Interval&);
  friend Interval min(const Interval&, const Interval&);
  friend Interval max(const Interval&, const Interval&);
  friend Interval pow(const Interval&, int exponent);

 private:
  [[nodiscard]] bool certainly_equal(const Interval&) const;
  [[nodiscard]] bool certainly_less(const Interval&) const;
  [[nodiscard]] bool certainly_less_equal(const Interval&) const;
  void make();                               // initialises storage_ in working precision
  void widen();                              // brings an operand that is overwritten to working precision
  Interval& checked(const char* operation);  // the finiteness of every result
  // One mpfi_t, constructed in place; after a move `alive_` is false and only assignment and destruction are left.
  alignas(8) unsigned char storage_[64];
  bool alive_ = true;
  friend struct Ends;
};

std::ostream& operator<<(std::ostream&, const Interval&);

}  // namespace udcp
