// What a word is: masks, stencils, symbols, support, matrices, limits and counts. All of it is computed by running the word.
#include <algorithm>

#include "interpreter/apply.h"
#include "interpreter/arguments.h"
#include "interpreter/counts.h"
#include "interpreter/formula.h"
#include "interpreter/report.h"
#include "interpreter/vertex_matrix.h"
#include "interpreter/words.h"
#include "operators/limit.h"
#include "operators/matrix.h"

namespace udcp {

namespace {

using AnyMask = std::variant<Mask<Algebraic>, Mask<Interval>>;

AnyMask mask_of(const Arguments& a) {
  const Word word = finite(need_word(a, 0));
  validate_for_curve(word);
  const int round = whole_or(a, 1, "round", 0, 0, 10'000);
  return exact_or_enclosed([&]<class S>(std::type_identity<S>) { return mask<S>(word, round); });
}

template <class S>
std::vector<Value> values_of(const std::vector<S>& numbers) {
  std::vector<Value> values;
  for (const S& n : numbers) values.push_back(number_of(n));
  return values;
}

std::string text_of(const std::vector<Value>& values) { return to_text(Value{ListValue{values}}); }

Json json_of(const std::vector<Value>& values) {
  Json json = Json::array();
  for (const Value& v : values) json.push_back(to_json(v)["value"]);
  return json;
}

Value show_mask(CallContext&, const Arguments& a) {
  return std::visit(
      [](const auto& m) {
        ReportValue report;
        report.parts = values_of(m.coefficients);
        const int last = m.first + static_cast<int>(m.coefficients.size()) - 1;
        report.text = text_of(report.parts) + "  offsets " + std::to_string(m.first) + " .. " + std::to_string(last) +
                      ", arity " + std::to_string(m.arity);
        report.json = Json{{"kind", "mask"},
                           {"arity", m.arity},
                           {"first", m.first},
                           {"shift", m.shift.to_string()},
                           {"coefficients", json_of(report.parts)}};
        return Value{std::move(report)};
      },
      mask_of(a));
}

Value show_stencils(CallContext&, const Arguments& a) {
  return std::visit(
      [](const auto& m) {
        ReportValue report;
        report.json = Json{{"kind", "stencils"}, {"rows", Json::array()}};
        for (const auto& s : stencils(m)) {
          const std::vector<Value> weights = values_of(s.weights);
          report.text += (report.text.empty() ? "" : "\n") + text_of(weights) + "  from point " + std::to_string(s.first);
          report.json["rows"].push_back(Json{{"first", s.first}, {"weights", json_of(weights)}});
          report.parts.push_back(Value{ListValue{weights}});
        }
        return Value{std::move(report)};
      },
      mask_of(a));
}

/// sum a_k z^k as text; the coefficients are the parts.
Value show_symbol(CallContext&, const Arguments& a) {
  return std::visit(
      [](const auto& m) {
        ReportValue report;
        report.parts = values_of(m.coefficients);
        for (std::size_t i = 0; i < report.parts.size(); ++i) {
          if (is_zero(m.coefficients[i])) continue;
          const int power = m.first + static_cast<int>(i);
          report.text += (report.text.empty() ? "(" : " + (") + udcp::to_text(m.coefficients[i]) + ")" +
                         (power == 0   ? ""
                          : power == 1 ? "*z"
                                       : "*z^" + std::to_string(power));
        }
        report.json = Json{{"kind", "symbol"}, {"first", m.first}, {"coefficients", json_of(report.parts)}};
        return Value{std::move(report)};
      },
      mask_of(a));
}

/// How far one point reaches in the limit: with arity d the width of the mask, divided by d - 1.
Value show_support(CallContext&, const Arguments& a) {
  return std::visit(
      [](const auto& m) {
        if (m.arity < 2) throw Error(ErrorKind::word, "E_MASK_NO_ROUND", "a word without U has no support", "");
        const Rational below = (Rational(m.first) + m.shift) / Rational(m.arity - 1);
        const Rational above = below + Rational(static_cast<int>(m.coefficients.size()) - 1) / Rational(m.arity - 1);
        ReportValue report;
        report.parts = {Value{NumberValue{Quantity<Algebraic>(below)}}, Value{NumberValue{Quantity<Algebraic>(above)}}};
        report.text = "[" + below.to_string() + ", " + above.to_string() + "]";
        report.json = Json{{"kind", "support"}, {"lower", below.to_string()}, {"upper", above.to_string()}};
        return Value{std::move(report)};
      },
      mask_of(a));
}

Value curve_matrix(const Word& word, int points, bool closed, int round) {
  validate_for_curve(word);
  MatrixValue matrix;
  std::visit([&](auto&& m) { matrix.entries = std::move(m); }, exact_or_enclosed([&]<class S>(std::type_identity<S>) {
               Polyline<S> curve;
               curve.points = Points<S>::Constant(points, 1, S(0));
               curve.closed = closed;
               return subdivision_matrix(word, curve, round);
             }));
  return Value{std::move(matrix)};
}

Value make_matrix(CallContext&, const Arguments& a) {
  const Word word = finite(need_word(a, 0));
  const int round = whole_or(a, 1, "round", 0, 0, 10'000);
  if (a.find("points")) {
    if (a.find("N") || a.find("rings"))
      throw Error(ErrorKind::word, "E_ARGUMENTS", "points is for curves, N and rings are for meshes; give one of them");
    const bool closed = flag_or(a, a.positional.size(), "closed", true);
    return curve_matrix(word, need_whole(a, a.positional.size(), "points", closed ? 3 : 2, 1000), closed, round);
  }
  if (!a.find("N"))
    throw Error(ErrorKind::word, "E_ARGUMENTS", "matrix needs a valence, N = 5, or a number of points, points = 8");
  const int valence = need_whole(a, a.positional.size(), "N", 3, 100);
  return Value{vertex_matrix(word, valence, whole_or(a, a.positional.size(), "rings", 0, 1, 6), round).matrix};
}

Value show_defaults(CallContext&, const Arguments& a) {
  ListValue list;
  for (const std::string& text : defaults_of(need_word(a, 0).word)) list.items.push_back(Value{TextValue{text}});
  return Value{std::move(list)};
}

Value show_atoms(CallContext&, const Arguments& a) {
  const WordValue& word = need_word(a, 0);
  return Value{TextValue{atoms(word.word, word.rounds.value_or(whole_or(a, 1, "rounds", 1, 0, 1000)))}};
}

/// limit(shape, word)
Value limit_points(CallContext& context, const Arguments& a) {
  const WordValue& word = need_word(a, 1);
  if (!word.word.is_scheme() || word.rounds)
    throw Error(ErrorKind::word, "E_NOT_A_SCHEME", "a limit needs a word that repeats for ever, but this one ends",
                "write limit(shape, (UCP)*)");
  const RunControl control = run_control(context, "limit of " + word.source);
  if (const auto* curve = a.positional[0].as<CurveValue>()) {
    validate_for_curve(word.word);
    Polyline<double> line = as_double(*curve);
    line.points = limit(word.word, line, control);
    return Value{CurveValue{std::move(line)}};
  }
  Surface<double> surface = as_double(need_mesh(a, 0, "shape"));
  Limit result = limit(word.word, surface, control);
  surface.points = std::move(result.points);
  return Value{MeshValue{std::move(surface), "limit(" + word.source + ")",
                         std::make_shared<const Points<double>>(std::move(result.normals))}};
}

}  // namespace

std::vector<Builtin> builtins_words() {
  return {
      {"mask", "mask(word, round = 0)", "The mask of one round on curves.", 1, 2, {"round"}, show_mask},
      {"stencils",
       "stencils(word, round = 0)",
       "The rows of the mask, one per kind of new point.",
       1,
       2,
       {"round"},
       show_stencils},
      {"symbol", "symbol(word, round = 0)", "The mask as a Laurent polynomial.", 1, 2, {"round"}, show_symbol},
      {"support", "support(word)", "How far one point reaches in the limit.", 1, 2, {"round"}, show_support},
      {"matrix",
       "matrix(word, N = valence, rings = fewest, round = 0) or matrix(word, points = n, closed = yes, round = 0)",
       "The subdivision matrix at a vertex of a mesh, or on a curve.",
       1,
       1,
       {"N", "rings", "points", "closed", "round"},
       make_matrix},
      {"defaults", "defaults(word)", "The parameters that a word leaves at their defaults.", 1, 1, {}, show_defaults},
      {"atoms", "atoms(word, rounds = 1)", "The atoms of a word, written out.", 1, 2, {"rounds"}, show_atoms},
      {"limit",
       "limit(shape, word)",
       "The limit points of a scheme at the points of a shape, with normals.",
       2,
       2,
       {},
       limit_points},
      {"counts",
       "counts(shape |> word^n)",
       "Vertices, edges and faces, without refining.",
       1,
       1,
       {},
       counts_of_value,
       counts_of_expression},
  };
}

}  // namespace udcp
