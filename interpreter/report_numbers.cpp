// Numbers as text and JSON. Exact first; digits after it only where an enclosure vouches for every one of them.
#include <charconv>
#include <cmath>
#include <optional>

#include "interpreter/report_parts.h"

namespace udcp {
namespace {

/// Working precision of Interval for one computation.
class PrecisionGuard {
 public:
  explicit PrecisionGuard(int bits) : before_(Interval::precision()) { Interval::set_precision(bits); }
  ~PrecisionGuard() { Interval::set_precision(before_); }
  PrecisionGuard(const PrecisionGuard&) = delete;
  PrecisionGuard& operator=(const PrecisionGuard&) = delete;

 private:
  int before_;
};

bool is_rational(const Quantity<Algebraic>& number) {
  using Kind = Quantity<Algebraic>::Kind;
  return number.kind() == Kind::rational || (number.kind() == Kind::number && number.value().is_rational());
}

Rational rational_of(const Quantity<Algebraic>& number) {
  return number.kind() == Quantity<Algebraic>::Kind::rational ? number.exact() : number.value().rational();
}

Interval enclosure_of(const Quantity<Algebraic>& number) {
  using Kind = Quantity<Algebraic>::Kind;
  if (number.kind() == Kind::rational) return Interval(number.exact());
  if (number.kind() == Kind::pi_multiple) return Interval::pi() * Interval(number.exact());
  return number.value().enclosure();
}

/// sign * 0.d1 d2 d3 ... * 10^(exponent + 1), cut off (not rounded) after the digits that are there.
struct Digits {
  bool negative = false;
  std::string digits;
  int exponent = 0;
  friend bool operator==(const Digits&, const Digits&) = default;
};

Digits digits_of(const Rational& number, int count) {
  const Rational size = abs(number);
  if (size.sign() == 0) return {false, std::string(static_cast<std::size_t>(count), '0'), 0};
  const auto length = [](const Rational& integer) { return static_cast<int>(integer.to_string().size()); };
  int exponent = length(size.numerator()) - length(size.denominator());
  if (size < pow(Rational(10), exponent)) --exponent;
  return {number.sign() < 0, (size * pow(Rational(10), count - 1 - exponent)).floor().to_string(), exponent};
}

std::string with_point(const Digits& number, const std::string& after) {
  const std::string& d = number.digits;
  const int count = static_cast<int>(d.size());
  std::string text = number.negative ? "-" : "";
  if (number.exponent < -5 || number.exponent >= count) {
    return text + d.substr(0, 1) + "." + d.substr(1) + after + "e" + std::to_string(number.exponent);
  }
  if (number.exponent < 0) return text + "0." + std::string(static_cast<std::size_t>(-number.exponent - 1), '0') + d + after;
  const auto whole = static_cast<std::size_t>(number.exponent) + 1;
  return text + d.substr(0, whole) + (whole < d.size() ? "." : "") + d.substr(whole) + after;
}

/// The digits that both ends of the enclosure agree on, once they are as many as asked for.
std::optional<Digits> agreed_digits(const Quantity<Algebraic>& number, int count, int bits) {
  const PrecisionGuard guard(bits);
  const Interval enclosure = enclosure_of(number);
  if (enclosure.contains_zero()) return {};
  const Digits lower = digits_of(enclosure.lower(), count);
  if (lower != digits_of(enclosure.upper(), count)) return {};
  return lower;
}

/// "2*pi/5", "-pi", "pi/3".
std::string pi_text(const Rational& times) {
  const Rational top = abs(times.numerator());
  std::string text = times.sign() < 0 ? "-" : "";
  if (top != Rational(1)) text += top.to_string() + "*";
  text += "pi";
  return times.is_integer() ? text : text + "/" + times.denominator().to_string();
}

/// Decimal digits that carry what the end points of an enclosure know.
int digits_for_precision() { return static_cast<int>(std::ceil(Interval::precision() * 0.30103)) + 1; }

Json enclosure_json(const Interval& number) {
  const int digits = digits_for_precision();
  return Json{{"lo", number.lower_decimal(digits)}, {"hi", number.upper_decimal(digits)}};
}

}  // namespace

std::string exact_text(const Quantity<Algebraic>& number) {
  if (is_rational(number)) return rational_of(number).to_string();
  return number.kind() == Quantity<Algebraic>::Kind::pi_multiple ? pi_text(number.exact()) : number.value().to_string();
}

std::string decimals(const Quantity<Algebraic>& number, int digits) {
  if (is_rational(number)) {
    const Rational value = rational_of(number);
    Digits cut = digits_of(value, digits);
    const Rational shown = Rational::parse(cut.digits) * pow(Rational(10), cut.exponent + 1 - digits);
    if (abs(value) != shown) return with_point(cut, "…");
    while (static_cast<int>(cut.digits.size()) > std::max(1, cut.exponent + 1) && cut.digits.back() == '0') cut.digits.pop_back();
    return with_point(cut, "");
  }
  // An irrational number is never on a decimal boundary, so some precision decides; the last bound is for the impossible.
  for (int bits = 128; bits <= 1 << 17; bits *= 2) {
    if (const auto agreed = agreed_digits(number, digits, bits)) return with_point(*agreed, "…");
  }
  return enclosure_of(number).to_string(digits);
}

std::string double_text(double value, int digits) {
  if (value == 0) return "0";  // also -0
  char buffer[64];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::general, digits).ptr;
  return {buffer, end};
}

std::string number_text(const NumberValue& number) {
  constexpr int digits = 12;
  constexpr std::size_t longest_readable_fraction = 64;  // bits of numerator and denominator
  if (const auto* measured = std::get_if<double>(&number.value)) return "≈ " + double_text(*measured);
  if (const auto* function = std::get_if<Parametric>(&number.value)) return function->to_string();
  if (const auto* enclosure = std::get_if<Interval>(&number.value)) return enclosure->to_string(digits);
  const auto& exact = std::get<Quantity<Algebraic>>(number.value);
  const std::string text = exact_text(exact);
  if (is_rational(exact) && (rational_of(exact).is_integer() || rational_of(exact).bits() <= longest_readable_fraction))
    return text;
  return text + "  (= " + decimals(exact, digits) + ")";
}

Json number_json(const Quantity<Algebraic>& number) {
  if (is_rational(number)) return rational_of(number).to_string();
  Json json{{"exact", exact_text(number)}};
  json.update(enclosure_json(enclosure_of(number)));
  return json;
}

Json number_json(const Algebraic& number) { return number_json(Quantity<Algebraic>::of(number)); }

Json number_json(const Interval& number) { return enclosure_json(number); }

Json number_json(const Parametric& number) { return number.to_string(); }

Json number_json(double number) {
  if (std::isfinite(number)) return number;
  return std::isnan(number) ? "nan" : number > 0 ? "inf" : "-inf";
}

}  // namespace udcp
