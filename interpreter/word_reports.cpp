// Words as wholes: which standard schemes they are, their normal form, and a report of all that is proved about them on curves,
// as text and as LaTeX.
#include <algorithm>

#include "interpreter/analysis.h"
#include "interpreter/arguments.h"
#include "interpreter/claims.h"
#include "interpreter/report.h"
#include "proofs/circle.h"
#include "proofs/curve_smoothness.h"
#include "proofs/equality.h"

namespace udcp {
namespace {

const WordValue& scheme_argument(const Arguments& a) {
  const WordValue& value = need_word(a, 0);
  if (!value.word.is_scheme() || value.rounds)
    throw Error(ErrorKind::word, "E_NOT_A_SCHEME", "this speaks of a word that repeats for ever, but the word ends",
                "write (UCP)*");
  return value;
}

bool has_alpha(const Word& word) { return word.alpha0.plain || word.alpha0.latitude || word.alpha0.longitude; }

bool same_on_curves(const Word& a, const Word& b) {
  if (a.triangles || b.triangles || arity(a) != arity(b)) return false;
  try {
    return equality::difference_on_curves(a, b, {1, 1}).empty();
  } catch (const Error& error) {
    if (error.kind == ErrorKind::interrupted) throw;
    return false;
  }
}

/// The value of the parameter w at which a family has the mask; nothing if there is none. The masks have to be linear in w.
std::optional<Rational> matching_parameter(const Mask<Parametric>& family, const Mask<Rational>& wanted) {
  if (family.arity != wanted.arity) return std::nullopt;
  const int first = std::min(family.first, wanted.first);
  const int last = std::max(family.first + static_cast<int>(family.coefficients.size()),
                            wanted.first + static_cast<int>(wanted.coefficients.size()));
  const auto at = [](const auto& m, int k, const auto& zero) {
    const int i = k - m.first;
    return i >= 0 && i < static_cast<int>(m.coefficients.size()) ? m.coefficients[static_cast<std::size_t>(i)] : zero;
  };
  std::optional<Rational> w;
  for (int k = first; k < last; ++k) {
    const Parametric f = at(family, k, Parametric(0));
    if (w || f.is_constant()) continue;
    const Rational f0 = f.at(std::map<std::string, Rational>{{"w", Rational(0)}});
    const Rational slope = f.at(std::map<std::string, Rational>{{"w", Rational(1)}}) - f0;
    if (slope.is_zero()) return std::nullopt;
    w = (at(wanted, k, Rational(0)) - f0) / slope;
  }
  if (!w) return std::nullopt;
  for (int k = first; k < last; ++k) {
    if (at(family, k, Parametric(0)).at(std::map<std::string, Rational>{{"w", *w}}) != at(wanted, k, Rational(0)))
      return std::nullopt;
  }
  return w;
}

/// Members of a family name(w) that have the mask: w solved for, or tried from 1 to 8 where it is a number of atoms.
std::optional<std::string> member_of_family(const std::string& name, const Word& word, CallContext& context) {
  const auto scheme = [&](const NumberValue& parameter) -> std::optional<Word> {
    try {
      const Value value = call(name, {Value{parameter}}, {}, context);
      const auto* made = value.as<WordValue>();
      if (!made || !made->word.is_scheme() || made->word.triangles || made->word.rings != Rings::off) return std::nullopt;
      if (has_alpha(made->word)) return std::nullopt;
      return static_limit(made->word);
    } catch (const Error& error) {
      if (error.kind == ErrorKind::interrupted) throw;
      return std::nullopt;
    }
  };
  if (const std::optional<Word> family = scheme(NumberValue{Parametric::variable("w")})) {
    try {
      const auto w = matching_parameter(mask<Parametric>(*family), mask<Rational>(word));
      if (w) return name + "(" + w->to_string() + ")";
    } catch (const Error& error) {
      if (error.kind == ErrorKind::interrupted) throw;
    }
    return std::nullopt;
  }
  for (int m = 1; m <= 8; ++m) {
    const std::optional<Word> member = scheme(NumberValue{Quantity<Algebraic>(m)});
    if (member && same_on_curves(*member, word)) return name + "(" + std::to_string(m) + ")";
  }
  return std::nullopt;
}

std::vector<std::string> names_of(const Word& word, CallContext& context) {
  std::vector<std::string> found;
  for (const std::string& name : visible_names(*context.scope)) {
    const Value* value = context.scope->find(name);
    if (const auto* known = value->as<WordValue>()) {
      const bool plain = known->word.is_scheme() && !known->rounds && known->word.rings == Rings::off && !has_alpha(known->word);
      if (!plain) continue;
      try {
        if (same_on_curves(static_limit(known->word), word)) found.push_back(name);
      } catch (const Error& error) {
        if (error.kind == ErrorKind::interrupted) throw;
      }
    } else if (const auto* function = value->as<FunctionValue>(); function && function->parameters.size() == 1) {
      if (const auto member = member_of_family(name, word, context)) found.push_back(*member);
    }
  }
  return found;
}

std::string joined(const std::vector<std::string>& parts, const std::string& separator) {
  std::string text;
  for (const std::string& part : parts) text += (text.empty() ? "" : separator) + part;
  return text;
}

/// One line of a report: what, and the value.
struct Line {
  std::string what, value;
};

template <class S>
std::string stencil_text(const Stencil<S>& stencil) {
  std::vector<std::string> weights;
  for (const S& w : stencil.weights) weights.push_back(to_text(w));
  return "[" + joined(weights, ", ") + "] from point " + std::to_string(stencil.first);
}

std::vector<Line> lines_of(const WordValue& value, CallContext& context) {
  const Word word = static_limit(value.word);
  std::vector<Line> lines{{"word", value.source}};
  if (!is_static(value.word) && value.word.alpha0.plain)
    lines.push_back(
        {"note", "the word has functions of alpha; what follows is about its static limit, and prove c(word, k) about the word"});
  const std::vector<std::string> names = names_of(word, context);
  if (!names.empty()) lines.push_back({"the same on curves", joined(names, ", ")});
  std::visit(
      [&]<class S>(const Mask<S>& m) {
        std::vector<std::string> coefficients;
        for (const S& c : m.coefficients) coefficients.push_back(to_text(c));
        lines.push_back({"mask", "[" + joined(coefficients, ", ") + "] from offset " + std::to_string(m.first)});
        lines.push_back({"arity", std::to_string(m.arity)});
        const Support s = support(m);
        lines.push_back({"support", "[" + s.lower.to_string() + ", " + s.upper.to_string() + "]"});
        lines.push_back({"sum rules", std::to_string(sum_rules(m))});
        lines.push_back({"polynomials reproduced up to degree", std::to_string(reproduction_degree(m))});
      },
      exact_mask(word));
  const Regularity regularity = holder(word, search_limits(context));
  if (regularity.result.verdict == Verdict::proved) {
    lines.push_back({"smoothness (proved)", "C^" + std::to_string(regularity.smoothness)});
    lines.push_back({"Hoelder exponent (proved)", !regularity.exact.empty() ? regularity.exact
                                                  : regularity.at_most ? "in [" + regularity.at_least.lower_decimal(10) + ", " +
                                                                             regularity.at_most->upper_decimal(10) + "]"
                                                                       : "at least " + regularity.at_least.lower_decimal(10)});
  } else {
    lines.push_back({"smoothness", to_string(regularity.result.verdict) + ": " + regularity.result.reason});
  }
  const LimitStencils limits = limit_stencils(word, search_limits(context));
  if (limits.position) lines.push_back({"limit stencil", stencil_text(*limits.position)});
  if (limits.tangent) lines.push_back({"tangent stencil", stencil_text(*limits.tangent)});
  if (!is_static(value.word)) {
    const Result circles = prove_circle(value.word);
    lines.push_back({"regular polygons become circles", to_string(circles.verdict)});
  }
  return lines;
}

std::string latex_escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (std::string("#$%&_{}").find(c) != std::string::npos) {
      result += std::string("\\") + c;
    } else if (c == '^' || c == '~') {
      result += std::string("\\") + c + "{}";
    } else if (c == '\\') {
      result += "\\textbackslash{}";
    } else if (c == '*') {
      result += "$*$";
    } else if (c == '<' || c == '>' || c == '|') {
      result += std::string("$") + c + "$";
    } else {
      result += c;
    }
  }
  return result;
}

std::string latex_of(const std::vector<Line>& lines) {
  std::string text = "\\documentclass{article}\n\\usepackage[T1]{fontenc}\n\\begin{document}\n\\section*{" +
                     latex_escaped(lines.front().value) + "}\n\\begin{description}\n";
  for (const Line& line : lines) text += "\\item[" + latex_escaped(line.what) + "] " + latex_escaped(line.value) + "\n";
  return text + "\\end{description}\n\\end{document}\n";
}

}  // namespace

Value show_identity(CallContext& context, const Arguments& a) {
  const WordValue& value = scheme_argument(a);
  validate_for_curve(value.word);
  ReportValue report;
  const std::vector<std::string> names = names_of(static_limit(value.word), context);
  for (const std::string& name : names) report.parts.push_back(Value{TextValue{name}});
  const bool functions = !is_static(value.word) && value.word.alpha0.plain;
  report.text = names.empty()
                    ? "none of the known schemes on curves"
                    : std::string(functions ? "on curves its static limit is " : "on curves this is ") + joined(names, " = ");
  report.json = Json{{"kind", "identity"}, {"names", names}};
  return Value{std::move(report)};
}

Value show_normal_form(CallContext&, const Arguments& a) {
  const WordValue& value = scheme_argument(a);
  const Word word = static_limit(value.word);
  const Json json = to_json(word, {word.triangles ? 6 : 4});
  std::string atoms;
  for (const Json& item : json["items"]) {
    const auto atom = item["atom"].get<std::string>();
    std::string next = atom;
    if (atom == "U" && item["sections"] != 2) next += "[" + std::to_string(item["sections"].get<int>()) + "]";
    if (atom == "C" && !word.triangles && item["f"] == "1" && item["ngon"] == "dual") next = "D D";
    if ((atom == "C" || atom == "D") && item["f"] != "1") next += "[f = " + item["f"].dump() + "]";
    if (atom == "P") {
      const bool idle = std::all_of(item["delta"].begin(), item["delta"].end(), [](const Json& d) { return d == "0"; });
      if (idle) continue;
      next += "[omega = " + item["omega"].dump() + ", delta = " + item["delta"].begin()->dump() + "]";
    }
    atoms += (atoms.empty() ? "" : " ") + next;
  }
  atoms.erase(std::remove(atoms.begin(), atoms.end(), '"'), atoms.end());
  return Value{TextValue{"(" + atoms + ")*" + (word.triangles ? " on triangles" : "")}};
}

Value show_report(CallContext& context, const Arguments& a) {
  const WordValue& value = scheme_argument(a);
  validate_for_curve(value.word);
  const std::vector<Line> lines = lines_of(value, context);
  ReportValue report;
  report.json = Json{{"kind", "word report"}};
  for (const Line& line : lines) {
    report.text += (report.text.empty() ? "" : "\n") + line.what + ": " + line.value;
    report.json[line.what] = line.value;
  }
  report.latex = [lines] { return latex_of(lines); };
  return Value{std::move(report)};
}

}  // namespace udcp
