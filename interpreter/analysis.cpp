// Hoelder exponents, eigenvalues, characteristic maps, pictures of words. What is certified says so; eigenvalues and pictures are
// floating point.
#include "interpreter/analysis.h"

#include <algorithm>
#include <cmath>

#include "files/svg.h"
#include "interpreter/arguments.h"
#include "interpreter/claims.h"
#include "interpreter/pictures.h"
#include "interpreter/report.h"
#include "proofs/characteristic_picture.h"
#include "proofs/curve_smoothness.h"
#include "proofs/eigenvalues.h"
#include "proofs/linear_algebra.h"
#include "proofs/surface_c1.h"
#include "proofs/surface_facts.h"

namespace udcp {
namespace {

Word static_scheme(const Arguments& a) {
  const WordValue& value = need_word(a, 0);
  if (!value.word.is_scheme() || value.rounds)
    throw Error(ErrorKind::word, "E_NOT_A_SCHEME", "this speaks of a word that repeats for ever, but the word ends",
                "write (UCP)*");
  return static_limit(value.word);
}

int valence_of(const Arguments& a) {
  if (!a.find("N")) throw Error(ErrorKind::word, "E_ARGUMENTS", "the valence is missing", "write N = 5");
  return need_whole(a, a.positional.size(), "N", 3, largest_proof_valence);
}

std::string decimal(double x) {
  char text[40];
  std::snprintf(text, sizeof text, "%.10g", x);
  return text;
}

std::string complex_text(const std::complex<double>& z) {
  if (std::abs(z.imag()) < 1e-12 * std::max(1.0, std::abs(z))) return decimal(z.real());
  return decimal(z.real()) + (z.imag() < 0 ? " - " : " + ") + decimal(std::abs(z.imag())) + "i";
}

/// Rejected hypotheses of the theory, as an error of the language.
template <class F>
auto with_reasons(F f) -> decltype(f()) {
  try {
    return f();
  } catch (const Rejected& rejected) {
    throw Error(ErrorKind::word, "E_NO_SPECTRUM", rejected.what(),
                "the theory covers words with one U per round and constant parameters");
  }
}

std::vector<std::vector<std::complex<double>>> eigenvalues_at(const Word& word, int valence) {
  return with_reasons([&] {
    const LocalFacts<Algebraic> facts = local_facts<Algebraic>(word, valence);
    return eigenvalues_by_frequency(facts.enclosed, facts.radius);
  });
}

/// The rational number with a small denominator that a floating-point number is near, by continued fractions.
Rational nearby_fraction(double x) {
  Rational p0(0), q0(1), p1(1), q1(0), rest = Rational::from_double(x);
  for (int k = 0; k < 12; ++k) {
    const Rational whole = rest.floor();
    const Rational p2 = whole * p1 + p0, q2 = whole * q1 + q0;
    if (q2 > Rational(1 << 20)) break;
    p0 = p1, q0 = q1, p1 = p2, q1 = q2;
    if (std::abs((p1 / q1).to_double() - x) < 1e-9 || rest == whole) break;
    rest = Rational(1) / (rest - whole);
  }
  return p1 / q1;
}

}  // namespace

Value show_holder(CallContext& context, const Arguments& a) {
  const Word& word = need_word(a, 0).word;
  if (!is_static(word) && word.alpha0.plain)
    return claim_value(undecided("the Hoelder exponent of a word with functions of alpha",
                                 "exponents are proved for constant parameters only; prove c(word, k) decides its smoothness"));
  const Regularity regularity = holder(static_scheme(a), search_limits(context));
  if (regularity.result.verdict != Verdict::proved) return claim_value(regularity.result);
  ReportValue report;
  const bool plain = !regularity.exact.empty() && regularity.exact.find_first_not_of("-0123456789/") == std::string::npos;
  if (plain) return Value{NumberValue{Quantity<Algebraic>(Rational::parse(regularity.exact))}};
  const Rational low = regularity.at_least.lower();
  const std::string bounds =
      regularity.at_most ? "[" + regularity.at_least.lower_decimal(12) + ", " + regularity.at_most->upper_decimal(12) + "]"
                         : "at least " + regularity.at_least.lower_decimal(12);
  report.text = regularity.exact.empty() ? bounds : regularity.exact + "  (" + bounds + ")";
  report.json = Json{{"kind", "holder"},
                     {"exact", regularity.exact.empty() ? Json(nullptr) : Json(regularity.exact)},
                     {"lo", regularity.at_least.lower_decimal(17)},
                     {"hi", regularity.at_most ? Json(regularity.at_most->upper_decimal(17)) : Json(nullptr)},
                     {"smoothness", regularity.smoothness}};
  report.claim = std::make_shared<const Result>(regularity.result);
  return Value{std::move(report)};
}

Value show_eigen(CallContext&, const Arguments& a) {
  const Word word = static_scheme(a);
  std::vector<EigenvalueColumn> columns;
  if (const auto* list = a.find("N") ? a.find("N")->as<ListValue>() : nullptr) {
    for (const Value& item : list->items) {
      const int n = whole_number(item, "the valence N", 3, largest_proof_valence);
      columns.push_back({n, eigenvalues_at(word, n)});
    }
  } else {
    const int n = valence_of(a);
    columns.push_back({n, eigenvalues_at(word, n)});
  }
  ReportValue report;
  report.json = Json{{"kind", "eigenvalues"}, {"evidence", "floating point"}, {"valences", Json::array()}};
  for (const EigenvalueColumn& column : columns) {
    if (columns.size() > 1) report.text += "N = " + std::to_string(column.valence) + "\n";
    Json frequencies = Json::array();
    for (std::size_t m = 0; m < column.by_frequency.size(); ++m) {
      std::string text;
      Json row = Json::array();
      for (const std::complex<double>& z : column.by_frequency[m]) {
        if (std::abs(z) < 1e-9) continue;
        text += (text.empty() ? "" : ", ") + complex_text(z);
        row.push_back({{"re", z.real()}, {"im", z.imag()}});
      }
      report.text += "frequency " + std::to_string(m) + ": " + text + "\n";
      frequencies.push_back(std::move(row));
    }
    report.json["valences"].push_back({{"N", column.valence}, {"frequencies", std::move(frequencies)}});
  }
  report.text += "(floating point; prove c1(word) for N in .. certifies their order)";
  report.picture = [columns] { return picture_of_eigenvalues(columns); };
  return Value{std::move(report)};
}

Value show_jordan(CallContext&, const Arguments& a) {
  const Word word = static_scheme(a);
  const int n = valence_of(a);
  return with_reasons([&] {
    const LocalFacts<Algebraic> facts = local_facts<Algebraic>(word, n);
    const auto numeric = eigenvalues_by_frequency(facts.enclosed, facts.radius);
    ReportValue report;
    report.json = Json{{"kind", "jordan"}, {"N", n}, {"frequencies", Json::array()}};
    for (std::size_t m = 0; m < numeric.size(); ++m) {
      std::vector<Rational> seen;
      std::string text;
      Json row = Json::array();
      for (const std::complex<double>& z : numeric[m]) {
        if (std::abs(z.imag()) > 1e-4 || std::abs(z) < 1e-6) continue;
        const Rational value = nearby_fraction(z.real());
        if (std::find(seen.begin(), seen.end(), value) != seen.end()) continue;
        seen.push_back(value);
        const std::vector<int> blocks = block_jordan(facts.patch, facts.radius, static_cast<int>(m), Algebraic(value));
        if (blocks.empty()) continue;  // the fraction is near an eigenvalue and none itself
        std::string sizes;
        for (const int size : blocks) sizes += (sizes.empty() ? "" : "+") + std::to_string(size);
        text += (text.empty() ? "" : ", ") + value.to_string() + " (" + sizes + ")";
        row.push_back({{"eigenvalue", value.to_string()}, {"blocks", blocks}});
      }
      report.text +=
          (m == 0 ? "" : "\n") + ("frequency " + std::to_string(m)) + ": " + (text.empty() ? "no rational eigenvalue" : text);
      report.json["frequencies"].push_back(std::move(row));
    }
    return Value{std::move(report)};
  });
}

Value show_spectrum(CallContext&, const Arguments& a) {
  const Word word = static_scheme(a);
  return with_reasons([&] {
    // A valence so large that no row of the smallest invariant neighbourhood reaches round the centre.
    const LocalFacts<Algebraic> facts = local_facts<Algebraic>(word, 9);
    const int radius = closed_radius(facts.patch);
    const auto polynomial = polynomial_in_cosine(facts.patch, radius);
    ReportValue report;
    report.json =
        Json{{"kind", "characteristic polynomial"}, {"variables", {"x", "c = cos(2 pi m/N)"}}, {"coefficients", Json::array()}};
    for (std::size_t i = polynomial.size(); i-- > 0;) {
      std::string coefficient;
      for (std::size_t j = 0; j < polynomial[i].size(); ++j) {
        if (polynomial[i][j].is_zero()) continue;
        coefficient += (coefficient.empty() ? "" : " + ") + polynomial[i][j].to_string() +
                       (j == 0   ? ""
                        : j == 1 ? "*c"
                                 : "*c^" + std::to_string(j));
      }
      if (coefficient.empty()) continue;
      report.text += (report.text.empty() ? "" : " + ") + ("(" + coefficient + ")") +
                     (i == 0   ? ""
                      : i == 1 ? "*x"
                               : "*x^" + std::to_string(i));
    }
    for (const auto& row : polynomial) {
      Json json = Json::array();
      for (const Algebraic& c : row) json.push_back(c.to_string());
      report.json["coefficients"].push_back(std::move(json));
    }
    return Value{std::move(report)};
  });
}

Value show_charmap(CallContext&, const Arguments& a) {
  const Word word = static_scheme(a);
  const int n = valence_of(a);
  const std::vector<CharacteristicCell> cells = characteristic_cells(word, n, 2, 3);
  ReportValue report;
  const auto negative = std::count_if(cells.begin(), cells.end(), [](const CharacteristicCell& c) { return !(c.jacobian > 0); });
  report.text = "characteristic map at valence " + std::to_string(n) + ": " + std::to_string(cells.size()) + " cells, " +
                std::to_string(negative) + " with a Jacobian that is not positive (floating point)";
  report.json = Json{{"kind", "characteristic map"}, {"N", n}, {"cells", cells.size()}, {"not_positive", negative}};
  report.picture = [cells] {
    std::vector<SvgLayer> layers;
    for (const CharacteristicCell& cell : cells) {
      SvgLayer layer;
      layer.points.resize(4, 2);
      for (int k = 0; k < 4; ++k)
        layer.points.row(k) << cell.corners[static_cast<std::size_t>(k)].real(), cell.corners[static_cast<std::size_t>(k)].imag();
      layer.closed = true;
      layer.fill = cell.jacobian > 0 ? (cell.sector % 2 == 0 ? "#dce9f5" : "#c4d9ed") : "#d98880";
      layer.stroke = "#25405c";
      layer.width = 0.5;
      layers.push_back(std::move(layer));
    }
    SvgOptions options;
    options.background = "#ffffff";
    return svg(layers, options);
  };
  return Value{std::move(report)};
}

Value show_basic_function(CallContext&, const Arguments& a) {
  const Word word = static_scheme(a);
  const int derivatives = whole_or(a, 1, "derivatives", 0, 0, 2);
  validate_for_curve(word);
  const Support wide = std::visit([](const auto& m) { return support(m); }, exact_mask(word));
  ReportValue report;
  report.text = "basic limit function, support [" + wide.lower.to_string() + ", " + wide.upper.to_string() + "]; plot draws it";
  report.json = Json{{"kind", "basic function"}, {"support", {wide.lower.to_string(), wide.upper.to_string()}}};
  report.picture = [word, derivatives] { return picture_of_basic_function(word, derivatives); };
  return Value{std::move(report)};
}

Value show_diagram(CallContext&, const Arguments& a) {
  const Word word = static_scheme(a);
  validate_for_curve(word);
  ReportValue report;
  report.text = "the mask as bars, a colour per stencil; plot draws it";
  report.json = Json{{"kind", "diagram"}};
  report.picture = [word] { return picture_of_mask(word); };
  return Value{std::move(report)};
}

}  // namespace udcp
