// Certificates: what a proof leaves behind so that another program can check it without repeating the search. JSON, versioned,
// self-contained; exact numbers are strings. This file knows the envelope and the numbers, not what is proved.
#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>

#include "operators/number.h"
#include "operators/numbers/parametric.h"
#include "operators/numbers/parametric_polynomial.h"

namespace udcp {

using Json = nlohmann::ordered_json;

/// A certificate says something that is not so, or not in the form it should be. `what` says what and where.
struct Rejected : std::runtime_error {
  using std::runtime_error::runtime_error;
};
/// Throws Rejected{message} unless the condition holds: the one way in which checkers refuse.
void require(bool condition, const std::string& message);

/// {"format": "udcp-certificate", "version": 1, "kind", "statement", "data", "digest"}. The statement is a sentence that the
/// checker of this kind derives from the data again; the digest is FNV-1a (64 bit, hexadecimal) over the compact text of all
/// entries before it.
Json seal(const std::string& kind, const std::string& statement, Json data);
/// Checks the envelope, in this order of entries, without extra ones, and the digest. Throws Rejected.
void check_envelope(const Json& certificate);
/// JSON without a name that stands twice in an object; nothing for other texts.
std::optional<Json> parse_certificate(const std::string& text);
std::string digest(const std::string& text);

// Numbers. Rationals are "p/q" strings in lowest terms; algebraic ones either that or {"order": N, "coefficients": [..]} in
// powers of 2 cos(2 pi/N), lowest first; functions of parameters either that or {"names": [..], "numerator": [["3", 1, 0], ..],
// "denominator": [..]}, a term being its coefficient and its exponents. The readers throw Rejected for anything else, also for
// "2/4" or "+1": one number, one text.
Json to_json(const Rational& value);
Json to_json(const Algebraic& value);
Json to_json(const Parametric& value);
Json to_json(const std::vector<Rational>& values);
Rational rational_from(const Json& value, const std::string& where);
Algebraic algebraic_from(const Json& value, const std::string& where);
Parametric parametric_from(const Json& value, const std::string& where);
std::vector<Rational> rationals_from(const Json& value, const std::string& where);
/// An integer within [least, most].
int integer_from(const Json& value, int least, int most, const std::string& where);
/// The entry of an object; Rejected if it is not there.
const Json& entry(const Json& object, const std::string& name);
/// Rejected unless the object has exactly these entries, in any order.
void require_entries(const Json& object, std::initializer_list<const char*> names, const std::string& where);

}  // namespace udcp
