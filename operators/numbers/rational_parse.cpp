// Text to Rational: one grammar for integers, fractions and decimals, exact, without locale, of bounded size.
#include <gmp.h>

#include <cstdlib>
#include <string>

#include "operators/error.h"
#include "operators/numbers/rational.h"

namespace udcp {
namespace {

constexpr std::size_t kLongestText = 100'000;  // characters
constexpr int kLargestExponent = 10'000;

std::string_view take_digits(std::string_view& text) {
  std::size_t count = 0;
  while (count < text.size() && text[count] >= '0' && text[count] <= '9') ++count;
  const std::string_view digits = text.substr(0, count);
  text.remove_prefix(count);
  return digits;
}

bool take(std::string_view& text, char letter) {
  if (text.empty() || text.front() != letter) return false;
  text.remove_prefix(1);
  return true;
}

[[noreturn]] void not_a_number(std::string_view text) {
  throw Error(ErrorKind::input, "E_NUMBER", "'" + std::string(text.substr(0, 40)) + "' is not a number",
              "write an integer, a fraction such as 3/4, or a decimal such as 1.5e-3");
}

[[noreturn]] void too_large(std::string_view text) {
  throw Error(ErrorKind::input, "E_NUMBER_SIZE", "the number '" + std::string(text.substr(0, 40)) + "' is too long to be meant",
              "use at most 100000 characters and exponents between -10000 and 10000");
}

// What follows 'e': at most 10000 in modulus.
int take_exponent(std::string_view& rest, std::string_view text) {
  const bool negative = take(rest, '-');
  if (!negative) take(rest, '+');
  std::string_view digits = take_digits(rest);
  if (digits.empty()) not_a_number(text);
  while (digits.size() > 1 && digits.front() == '0') digits.remove_prefix(1);
  if (digits.size() > 5) too_large(text);
  const int exponent = std::atoi(std::string(digits).c_str());
  if (exponent > kLargestExponent) too_large(text);
  return negative ? -exponent : exponent;
}

}  // namespace

Rational Rational::parse(std::string_view text) {
  if (text.size() > kLongestText) too_large(text);
  std::string_view rest = text;
  const bool negative = take(rest, '-');
  if (!negative) take(rest, '+');
  std::string digits(take_digits(rest));
  std::string below = "1";
  long exponent = 0;
  if (!digits.empty() && take(rest, '/')) {
    below = take_digits(rest);
    if (below.empty()) not_a_number(text);
  } else {
    if (take(rest, '.')) {
      const std::string_view decimals = take_digits(rest);
      digits += decimals;
      exponent -= static_cast<long>(decimals.size());
    }
    if (digits.empty()) not_a_number(text);
    if (take(rest, 'e') || take(rest, 'E')) exponent += take_exponent(rest, text);
  }
  if (!rest.empty()) not_a_number(text);
  if (below.find_first_not_of('0') == std::string::npos) {
    throw Error(ErrorKind::input, "E_DIV0", "the number '" + std::string(text.substr(0, 40)) + "' has a zero denominator",
                "write a denominator that is not zero");
  }
  mpq_t value;
  mpq_init(value);
  mpz_ptr top = mpq_numref(value);
  mpz_ptr bottom = mpq_denref(value);
  mpz_set_str(top, digits.c_str(), 10);
  mpz_set_str(bottom, below.c_str(), 10);
  mpz_t power;
  mpz_init(power);
  mpz_ui_pow_ui(power, 10, static_cast<unsigned long>(std::labs(exponent)));
  mpz_ptr scaled = exponent < 0 ? bottom : top;
  mpz_mul(scaled, scaled, power);
  if (negative) mpz_neg(top, top);
  mpq_canonicalize(value);
  Rational result = from_mpq(value);
  mpq_clear(value);
  mpz_clear(power);
  return result;
}

}  // namespace udcp
