// Follows a pipe from its input: a step that is a word changes the counts; any other step needs the shape itself.
#include "interpreter/counts.h"

#include "interpreter/formula.h"
#include "interpreter/words.h"

namespace udcp {

namespace {

struct CurveCounts {
  std::int64_t points = 0;
  bool closed = true;
  int corners = 0;
};
/// Counts, or a value that is not a shape yet to be counted.
using Tally = std::variant<Counts, CurveCounts>;

Tally tally(const Value& shape) {
  if (const auto* mesh = shape.as<MeshValue>())
    return std::visit([](const auto& s) { return Tally(counts(*s.mesh, s.tags)); }, mesh->shape);
  if (const auto* curve = shape.as<CurveValue>()) {
    return std::visit(
        [](const auto& c) {
          CurveCounts result{c.size(), c.closed, 0};
          for (int i = 0; i < c.size(); ++i) result.corners += c.is_corner(i) ? 1 : 0;
          return Tally(result);
        },
        curve->shape);
  }
  throw wrong_type("what counts looks at", "a curve or a mesh", shape);
}

Tally after(const WordValue& word, const Tally& before) {
  if (word.word.is_scheme() && !word.rounds)
    throw Error(ErrorKind::word, "E_ROUNDS", "this word repeats for ever, so it needs a number of rounds here",
                "write (" + word.source + ")^4 for four rounds");
  const int rounds = word.rounds.value_or(1);
  if (const auto* mesh = std::get_if<Counts>(&before)) return counts(word.word, *mesh, rounds);
  CurveCounts curve = std::get<CurveCounts>(before);
  validate_for_curve(word.word);
  curve.points = count_points(word.word, curve.points, curve.closed, curve.corners, rounds);
  return curve;
}

Value report(const Tally& tally) {
  ReportValue result;
  std::vector<std::pair<const char*, std::int64_t>> rows;
  if (const auto* mesh = std::get_if<Counts>(&tally))
    rows = {{"vertices", mesh->vertices}, {"edges", mesh->edges}, {"faces", mesh->faces}};
  else
    rows = {{"points", std::get<CurveCounts>(tally).points}};
  result.json = Json::object();
  for (const auto& [name, count] : rows) {
    result.text += (result.text.empty() ? "" : ", ") + std::to_string(count) + " " + name;
    result.json[name] = count;
    result.parts.push_back(Value{NumberValue{Quantity<Algebraic>(Rational(static_cast<long long>(count)))}});
  }
  return Value{std::move(result)};
}

/// The word that a step stands for, if it is one.
std::optional<WordValue> word_of_step(const grammar::Expr& step, CallContext& context) {
  if (std::holds_alternative<grammar::Step>(step.node)) return std::nullopt;
  if (const auto* c = std::get_if<grammar::Call>(&step.node)) {
    const Value* found = context.scope->find(c->name);
    const auto* function = found ? found->as<FunctionValue>() : nullptr;
    if (!function || function->parameters.size() != c->arguments.size()) return std::nullopt;
  }
  const auto* name = std::get_if<grammar::Name>(&step.node);
  if (name && !context.scope->find(name->name) && find_builtin(name->name)) return std::nullopt;
  const Value value = evaluate(step, context);
  if (const auto* word = value.as<WordValue>()) return *word;
  return std::nullopt;
}

Tally tally(const grammar::Expr& expr, CallContext& context) {
  if (const auto* pipe = std::get_if<grammar::Pipe>(&expr.node)) {
    if (const auto word = word_of_step(*pipe->step, context)) {
      const Tally before = tally(*pipe->input, context);
      try {
        return after(*word, before);
      } catch (const Error& error) {
        throw Located(error, pipe->step->span);
      }
    }
  }
  return tally(evaluate(expr, context));
}

}  // namespace

Value counts_of_value(CallContext&, const Arguments& a) { return report(tally(a.positional[0])); }

Value counts_of_expression(CallContext& context, const grammar::Call& call) {
  if (call.arguments.size() != 1 || !call.arguments[0].name.empty())
    throw Error(ErrorKind::word, "E_ARGUMENTS", "'counts' takes one shape", "write counts(shape |> word^n)");
  return report(tally(*call.arguments[0].value, context));
}

}  // namespace udcp
