// The envelope of certificates and the text of their numbers.
#include "proofs/certificate.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <set>

namespace udcp {
namespace {

constexpr std::array<const char*, 6> envelope = {"format", "version", "kind", "statement", "data", "digest"};

bool is_deeper_than(const Json& json, int levels) {
  if (!json.is_structured()) return false;
  if (levels == 0) return true;
  return std::any_of(json.begin(), json.end(), [&](const Json& part) { return is_deeper_than(part, levels - 1); });
}

std::string digest_of(const Json& certificate) {
  Json open = certificate;
  open.erase("digest");
  return digest(open.dump(-1, ' ', true));
}

}  // namespace

void require(bool condition, const std::string& message) {
  if (!condition) throw Rejected(message);
}

std::string digest(const std::string& text) {
  std::uint64_t hash = 0xcbf29ce484222325U;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
  std::string result(16, '0');
  for (std::size_t k = 16; k-- > 0; hash >>= 4U) result[k] = "0123456789abcdef"[hash & 15U];
  return result;
}

Json seal(const std::string& kind, const std::string& statement, Json data) {
  Json result = {
      {"format", "udcp-certificate"}, {"version", 1}, {"kind", kind}, {"statement", statement}, {"data", std::move(data)}};
  result["digest"] = digest_of(result);
  return result;
}

void check_envelope(const Json& certificate) {
  require(certificate.is_object(), "a certificate is a JSON object");
  require(!is_deeper_than(certificate, 300), "the certificate is nested more than 300 levels deep");
  require(certificate.contains("format") && certificate["format"] == "udcp-certificate",
          "\"format\" is not \"udcp-certificate\"");
  require(certificate.contains("version") && certificate["version"].is_number_integer() && certificate["version"] == 1,
          "\"version\" is not 1, the only one that this program reads");
  require(certificate.size() == envelope.size(), "a certificate has the entries format, version, kind, statement, data, digest");
  std::size_t k = 0;
  for (const auto& [name, value] : certificate.items())
    require(name == envelope[k++], "a certificate has the entries format, version, kind, statement, data, digest, in this order");
  require(certificate["kind"].is_string() && certificate["statement"].is_string() && certificate["digest"].is_string(),
          "\"kind\", \"statement\" and \"digest\" are texts");
  require(certificate["digest"] == digest_of(certificate), "the digest does not fit: something in the certificate was changed");
}

Json to_json(const Rational& value) { return value.to_string(); }

Json to_json(const Algebraic& value) {
  if (value.is_rational()) return to_json(value.rational());
  return {{"order", value.field_order()}, {"coefficients", to_json(value.coefficients())}};
}

Json to_json(const std::vector<Rational>& values) {
  Json result = Json::array();
  for (const Rational& value : values) result.push_back(to_json(value));
  return result;
}

namespace {

Json terms_to_json(const ParametricPolynomial& p, const std::vector<std::string>& names) {
  Json result = Json::array();
  for (const ParametricPolynomial::Term& term : p.terms) {
    Json row = Json::array();  // {x} would be x itself for some compilers
    row.push_back(to_json(term.coefficient));
    for (const std::string& name : names) {
      const auto found = std::find(p.names.begin(), p.names.end(), name);
      row.push_back(found == p.names.end() ? 0 : term.exponents[static_cast<std::size_t>(found - p.names.begin())]);
    }
    result.push_back(std::move(row));
  }
  return result;
}

Parametric terms_from(const Json& rows, const std::vector<std::string>& names, const std::string& where) {
  require(rows.is_array() && !rows.empty() && rows.size() <= 500, where + " must be a list of 1 to 500 terms");
  Parametric sum(0);
  for (const Json& row : rows) {
    require(row.is_array() && row.size() == names.size() + 1, where + ": a term is a coefficient and an exponent per name");
    Parametric term(rational_from(row[0], where));
    for (std::size_t v = 0; v < names.size(); ++v)
      term *= pow(Parametric::variable(names[v]), integer_from(row[v + 1], 0, 60, where));
    sum += term;
  }
  return sum;
}

}  // namespace

Json to_json(const Parametric& value) {
  if (value.is_constant()) return to_json(value.constant());
  const std::vector<std::string> names = value.variables();
  return {{"names", names},
          {"numerator", terms_to_json(value.numerator(), names)},
          {"denominator", terms_to_json(value.denominator(), names)}};
}

Parametric parametric_from(const Json& value, const std::string& where) {
  if (!value.is_object()) return Parametric(rational_from(value, where));
  require_entries(value, {"names", "numerator", "denominator"}, where);
  require(value["names"].is_array() && !value["names"].empty() && value["names"].size() <= 6,
          where + ".names must be 1 to 6 names");
  std::vector<std::string> names;
  for (const Json& name : value["names"]) {
    require(name.is_string() && name.get<std::string>().size() <= 60, where + ".names must be texts");
    names.push_back(name.get<std::string>());
  }
  try {
    const Parametric denominator = terms_from(value["denominator"], names, where + ".denominator");
    require(!denominator.is_zero(), where + ".denominator is 0");
    Parametric result = terms_from(value["numerator"], names, where + ".numerator") / denominator;
    require(to_json(result) == value, where + " is not in lowest terms");
    return result;
  } catch (const Error& error) {
    throw Rejected(where + ": " + error.what());
  }
}

Rational rational_from(const Json& value, const std::string& where) {
  require(value.is_string(), where + " must be a fraction in quotes, as \"3/4\"");
  const auto& text = value.get_ref<const std::string&>();
  require(!text.empty() && text.size() <= 100'000 && text.find_first_not_of("-0123456789/") == std::string::npos,
          where + " must be a fraction p/q");
  try {
    Rational result = Rational::parse(text);
    require(result.to_string() == text, where + " must be in lowest terms");
    return result;
  } catch (const Error& error) {
    throw Rejected(where + ": " + error.what());
  }
}

Algebraic algebraic_from(const Json& value, const std::string& where) {
  if (!value.is_object()) return rational_from(value, where);
  require_entries(value, {"order", "coefficients"}, where);
  const int order = integer_from(entry(value, "order"), 5, 4000, where + ".order");
  const std::vector<Rational> coefficients = rationals_from(entry(value, "coefficients"), where + ".coefficients");
  require(coefficients.size() <= 192, where + " has too many coefficients");
  try {
    const Algebraic c = Algebraic(2) * Algebraic::cosine(Rational(2) / Rational(order));
    Algebraic result(0);
    for (std::size_t k = coefficients.size(); k-- > 0;) result = result * c + Algebraic(coefficients[k]);
    require(to_json(result) == value, where + " is not in reduced form");
    return result;
  } catch (const Error& error) {
    throw Rejected(where + ": " + error.what());
  }
}

std::vector<Rational> rationals_from(const Json& value, const std::string& where) {
  require(value.is_array(), where + " must be a list of fractions");
  std::vector<Rational> result;
  for (const Json& item : value) result.push_back(rational_from(item, where + "[" + std::to_string(result.size()) + "]"));
  return result;
}

int integer_from(const Json& value, int least, int most, const std::string& where) {
  require(value.is_number_integer(), where + " must be an integer");
  const auto number = value.get<std::int64_t>();
  require(!(value.is_number_unsigned() && value.get<std::uint64_t>() > static_cast<std::uint64_t>(most)) && number >= least &&
              number <= most,
          where + " must be an integer from " + std::to_string(least) + " to " + std::to_string(most));
  return static_cast<int>(number);
}

const Json& entry(const Json& object, const std::string& name) {
  require(object.is_object() && object.contains(name), "the entry \"" + name + "\" is missing");
  return object.at(name);
}

void require_entries(const Json& object, std::initializer_list<const char*> names, const std::string& where) {
  require(object.is_object(), where + " must be an object");
  for (const char* name : names) require(object.contains(name), where + " has no entry \"" + name + "\"");
  require(object.size() == names.size(), where + " has entries that do not belong there");
}

std::optional<Json> parse_certificate(const std::string& text) {
  std::vector<std::set<std::string>> names;  // of the objects that are open
  bool has_twice = false;
  const Json json = Json::parse(
      text,
      [&](int, Json::parse_event_t event, Json& value) {
        if (event == Json::parse_event_t::object_start) names.emplace_back();
        if (event == Json::parse_event_t::object_end) names.pop_back();
        if (event == Json::parse_event_t::key) has_twice = !names.back().insert(value.get<std::string>()).second || has_twice;
        return true;
      },
      false);
  if (json.is_discarded() || has_twice) return std::nullopt;
  return json;
}

}  // namespace udcp
