// The checker of "asymptotic": the jets once more, against the stored bounds, and the certificate of the static limit.
#include "proofs/asymptotic.h"
#include "proofs/checkers.h"
#include "proofs/closed_form.h"

namespace udcp {

std::string check_asymptotic(const Json& data, StopFlag) {
  require_entries(data, {"word", "smoothness", "range", "first", "second", "static"}, "data");
  const Word word = word_with_formulas_from(entry(data, "word"));
  require(!word.triangles && to_json(word, {4}) == data["word"], "the word is not in the form that this program writes");
  const int k = integer_from(entry(data, "smoothness"), 0, 50, "data.smoothness");
  const Rational range = rational_from(entry(data, "range"), "data.range");
  require(range.sign() > 0 && range <= Rational(1), "data.range must lie in (0, 1]");
  AsymptoticBounds bounds;
  try {
    bounds = asymptotic_bounds(word, range);
  } catch (const Error& error) {
    throw Rejected(std::string("the masks have no bounds near alpha = 0: ") + error.what());
  }
  require(bounds.first == rational_from(entry(data, "first"), "data.first"),
          "data.first is not the bound of the first derivatives");
  require(bounds.second == rational_from(entry(data, "second"), "data.second"),
          "data.second is not the bound of the second derivatives");
  require(k <= inherited_smoothness(bounds), "C^" + std::to_string(k) + " is not handed on from the static limit");

  const Json& part = entry(data, "static");
  require_entries(part, {"kind", "data"}, "data.static");
  require(part["kind"] == "curve-smoothness", "data.static must be a certificate of the kind curve-smoothness");
  (void)check_curve_smoothness(part["data"]);
  require(entry(part["data"], "smoothness") == data["smoothness"], "data.static speaks of another smoothness");
  require(entry(part["data"], "word") == to_json(static_limit(word), {4}), "data.static speaks of another word");

  const int a = bounds.arity;
  const std::string gamma = bounds.flat ? "1/" + std::to_string(a * a) : "1/" + std::to_string(a);
  return "the limits of " + describe(data["word"]) + " are C^" + std::to_string(k) +
         " for every alpha0 >= 0 for which all rounds exist; ||S_h - S|| <= c " + gamma + "^h with c = " +
         (bounds.flat ? (bounds.second / Rational(2)).to_string() + " alpha0^2" : bounds.first.to_string() + " alpha0") +
         " from the round on in which alpha is at most " + range.to_string();
}

}  // namespace udcp
