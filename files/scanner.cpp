// Numbers and names of the text readers. Decimals are read strictly: no hexadecimal, no "nan", no decimal comma, nothing left
// over.
#include "files/scanner.h"

#include <algorithm>

namespace udcp {
namespace {

// An exact number in a file may not blow up to thousands of digits for each byte; no double needs more than 324.
constexpr int largest_exponent = 1000;

/// The parts of a decimal, or nothing.
struct Decimal {
  bool valid = false, negative = false;
  std::string_view whole, fraction;
  long exponent = 0;  // clipped far outside what anything can hold
};

bool is_digit(char c) { return c >= '0' && c <= '9'; }

std::string_view take_digits(std::string_view& text) {
  const auto length = static_cast<std::size_t>(std::find_if_not(text.begin(), text.end(), is_digit) - text.begin());
  const std::string_view digits = text.substr(0, length);
  text.remove_prefix(length);
  return digits;
}

Decimal split_decimal(std::string_view text) {
  Decimal result;
  if (!text.empty() && (text[0] == '-' || text[0] == '+')) {
    result.negative = text[0] == '-';
    text.remove_prefix(1);
  }
  result.whole = take_digits(text);
  if (!text.empty() && text[0] == '.') {
    text.remove_prefix(1);
    result.fraction = take_digits(text);
  }
  if (result.whole.empty() && result.fraction.empty()) return {};
  if (!text.empty() && (text[0] == 'e' || text[0] == 'E')) {
    text.remove_prefix(1);
    const bool minus = !text.empty() && text[0] == '-';
    if (!text.empty() && (text[0] == '-' || text[0] == '+')) text.remove_prefix(1);
    const std::string_view digits = take_digits(text);
    if (digits.empty()) return {};
    constexpr long far = 1'000'000'000;
    for (const char c : digits) result.exponent = std::min(far, 10 * result.exponent + (c - '0'));
    if (minus) result.exponent = -result.exponent;
  }
  result.valid = text.empty();
  return result;
}

/// Whether the value lies below 1: what from_chars calls out of range is then a zero, otherwise it is an overflow.
bool is_small(const Decimal& decimal) {
  const auto nonzero = [](std::string_view digits) { return digits.find_first_not_of('0'); };
  const std::size_t whole = nonzero(decimal.whole), fraction = nonzero(decimal.fraction);
  if (whole != std::string_view::npos) return static_cast<long>(decimal.whole.size() - whole) + decimal.exponent <= 0;
  return fraction == std::string_view::npos || decimal.exponent - static_cast<long>(fraction) <= 0;
}

bool names_no_finite_number(std::string_view token) {
  if (!token.empty() && (token[0] == '-' || token[0] == '+')) token.remove_prefix(1);
  std::string lower;
  for (const char c : token.substr(0, 16)) lower += static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
  return lower == "nan" || lower.starts_with("nan(") || lower == "inf" || lower == "infinity" || lower.starts_with("1.#");
}

NumberError complain(std::string_view token) {
  return names_no_finite_number(token) ? NumberError::not_finite : NumberError::malformed;
}

}  // namespace

std::string in_quotes(std::string_view token) {
  std::string result = "'";
  for (const char c : token.substr(0, 40)) result += c >= ' ' && c <= '~' ? c : '?';
  return result + (token.size() > 40 ? "...'" : "'");
}

std::string_view text_of(const Input& input) {
  std::string_view text = input.bytes;
  if (text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff")) {
    input.fail(1, "E_FILE_FORMAT", "this is UTF-16 text; plain ASCII or UTF-8 is expected", "save the file as UTF-8");
  }
  if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
  if (const auto at = text.find('\0'); at != std::string_view::npos) {
    const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n');
    input.fail(line, "E_FILE_FORMAT", "NUL byte: this is no text file, or it is damaged");
  }
  return text;
}

NumberError to_number(std::string_view token, double& value) {
  std::string_view digits = token;
  if (digits.size() > 1 && digits[0] == '+' && digits[1] != '-') digits.remove_prefix(1);
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error == std::errc() && end == digits.data() + digits.size() && std::isfinite(value)) return NumberError::none;
  const Decimal decimal = split_decimal(token);
  if (!decimal.valid) return complain(token);
  if (!is_small(decimal)) return NumberError::too_large;
  value = decimal.negative ? -0.0 : 0.0;
  return NumberError::none;
}

template <class S>
NumberError to_number(std::string_view token, S& value) {
  const Decimal decimal = split_decimal(token);
  if (!decimal.valid) return complain(token);
  if (std::abs(decimal.exponent) > largest_exponent) return NumberError::too_large;
  std::string text(decimal.negative ? "-" : "");
  text += decimal.whole.empty() ? "0" : decimal.whole;
  if (!decimal.fraction.empty()) (text += '.') += decimal.fraction;
  if (decimal.exponent != 0) (text += 'e') += std::to_string(decimal.exponent);
  value = number<S>(Rational::parse(text));
  return NumberError::none;
}

void fail_number(const Input& input, std::int64_t line, NumberError error, std::string_view token, const char* what) {
  const std::string name = std::string(what) + " " + in_quotes(token);
  if (error == NumberError::not_finite) input.fail(line, "E_FILE_NUMBER", name + " is not a finite number");
  if (error == NumberError::too_large) input.fail(line, "E_FILE_NUMBER", name + " is too large or has too large an exponent");
  const bool comma = token.find(',') != std::string_view::npos;
  input.fail(line, "E_FILE_NUMBER", name + " is not a number", comma ? "write decimals with a point" : "");
}

std::int64_t Scanner::integer_of(std::string_view found, const char* what) const {
  std::int64_t value = 0;
  std::string_view digits = found;
  if (digits.size() > 1 && digits[0] == '+' && is_digit(digits[1])) digits.remove_prefix(1);
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error == std::errc::result_out_of_range)
    fail("E_FILE_NUMBER", std::string(what) + " " + in_quotes(found) + " is too large");
  if (error != std::errc() || end != digits.data() + digits.size()) {
    fail("E_FILE_NUMBER", std::string(what) + " " + in_quotes(found) + " is not an integer");
  }
  return value;
}

#define UDCP_TO_NUMBER(S) template NumberError to_number(std::string_view, S&);
UDCP_FOR_EACH_COORDINATE(UDCP_TO_NUMBER)
#undef UDCP_TO_NUMBER

}  // namespace udcp
