// Statements one by one. A definition puts a new scope on top of the old one; loops put the old scope back.
#include "interpreter/statements.h"

#include <algorithm>
#include <new>
#include <set>
#include <utility>

#include "files/geometry_file.h"
#include "grammar/print.h"
#include "interpreter/arithmetic.h"
#include "interpreter/builtins.h"
#include "interpreter/claims.h"
#include "interpreter/compare.h"
#include "interpreter/formula.h"
#include "interpreter/kept_plan.h"
#include "interpreter/report.h"
#include "operators/interrupt.h"

namespace udcp {

namespace {

using grammar::Span;
using grammar::Statement;

ProgramError program_error(const Error& error, const SourcePtr& source, Span span) {
  ProgramError result(error.what());
  result.kind = error.kind;
  result.code = error.code;
  result.help = error.help;
  result.label = error.label;
  result.file = source->name;
  result.source = source->text;
  result.span = span;
  return result;
}

ProgramError program_error(const grammar::SyntaxError& error, const SourcePtr& source) {
  ProgramError result(error.what());
  result.kind = ErrorKind::word;
  result.syntax = true;
  result.incomplete = error.incomplete;
  result.code = error.code;
  result.help = error.help;
  result.label = error.label;
  result.file = source->name;
  result.source = source->text;
  result.span = error.span;
  return result;
}

void check_definable(const std::string& name, const CallContext& context, Span span) {
  static const std::set<std::string> reserved = {"pi", "oo", "yes", "no", "true", "false", "noise", "_", "v"};
  if (reserved.contains(name) || is_number_function(name))
    throw Error(ErrorKind::word, "E_RESERVED", "the name '" + name + "' belongs to the language and cannot be defined",
                "choose another name");
  if (name == "alpha" || name == "N" || name == "h")
    warn(context, span,
         "inside the formulas of words '" + name + "' is a variable of the language and will not mean this definition");
}

/// save, plot and print at the end of a line have done their work; the value is not printed once more.
bool ends_in_step(const grammar::Expr& e) {
  if (const auto* pipe = std::get_if<grammar::Pipe>(&e.node))
    return std::holds_alternative<grammar::Step>(pipe->step->node) || ends_in_step(*pipe->step);
  const auto* call = std::get_if<grammar::Call>(&e.node);
  return call && (call->name == "save" || call->name == "plot");
}

/// Inside a loop, words on the same mesh keep their plan; an inner loop has its own.
class KeepingPlans {
 public:
  explicit KeepingPlans(CallContext& context) : context_(context), before_(std::exchange(context.kept, &plan_)) {}
  ~KeepingPlans() { context_.kept = before_; }
  KeepingPlans(const KeepingPlans&) = delete;
  KeepingPlans& operator=(const KeepingPlans&) = delete;

 private:
  KeptPlan plan_;
  CallContext& context_;
  KeptPlan* before_;
};

}  // namespace

void Runner::run(const SourcePtr& source, const std::filesystem::path& folder,
                 const std::function<void(const Statement&)>& done) {
  const SourcePtr source_before = std::exchange(context_.source, source);
  const std::filesystem::path folder_before = std::exchange(context_.folder, folder);
  Span span{0, source->text.size()};
  try {
    const grammar::Program program = grammar::parse(source->text);
    for (const Statement& statement : program.statements) {
      span = statement.span;
      execute(statement);
      if (done) done(statement);
    }
  } catch (const grammar::SyntaxError& error) {
    throw program_error(error, source);
  } catch (const Located& error) {
    throw program_error(error, error.source ? error.source : source, error.span);
  } catch (const Error& error) {
    throw program_error(error, source, span);
  } catch (const std::bad_alloc&) {
    throw program_error(Error(ErrorKind::limit, "E_MEMORY", "there is not enough memory for this statement"), source, span);
  }
  context_.source = source_before;
  context_.folder = folder_before;
}

void Runner::execute(const Statement& statement) {
  result_ = Value{};
  context_.steps = 0;
  context_.last = has_last_ ? &last_ : nullptr;
  throw_if_stopped(context_.stop.get());
  std::visit([&](const auto& node) { on(node, statement.span); }, statement.node);
}

void Runner::define(const std::string& name, Value value) {
  auto scope = std::make_shared<Environment>();
  scope->names.emplace(name, std::move(value));
  scope->outer = context_.scope;
  context_.scope = std::move(scope);
}

void Runner::on(const grammar::Define& d, Span span) {
  check_definable(d.name, context_, span);
  if (!d.is_function) return define(d.name, evaluate(*d.value, context_));
  std::vector<std::string> known = d.parameters;
  known.push_back(d.name);
  for (std::size_t i = 0; i < d.parameters.size(); ++i) {
    const std::string& p = d.parameters[i];
    if (std::find(d.parameters.begin(), d.parameters.begin() + static_cast<std::ptrdiff_t>(i), p) !=
        d.parameters.begin() + static_cast<std::ptrdiff_t>(i))
      throw Error(ErrorKind::word, "E_ARGUMENTS", "the parameter '" + p + "' of '" + d.name + "' stands twice");
  }
  check_names(*d.value, context_, known);
  define(d.name, Value{FunctionValue{d.name, d.parameters, d.value, context_.scope, context_.source}});
}

void Runner::on(const grammar::Evaluate& e, Span) {
  Value value = evaluate(*e.value, context_);
  if (context_.output.value && !value.as<Nothing>() && !ends_in_step(*e.value)) context_.output.value(value);
  if (!value.as<Nothing>()) {
    last_ = value;
    has_last_ = true;
  }
  result_ = std::move(value);
}

void Runner::on(const grammar::Print& p, Span) {
  ReportValue line;
  line.json = Json::array();
  for (const auto& e : p.values) {
    Value value = evaluate(*e, context_);
    line.text += (line.parts.empty() ? "" : "  ") + to_text(value);
    line.json.push_back(to_json(value));
    line.parts.push_back(std::move(value));
  }
  if (!context_.output.value) return;
  if (line.parts.size() == 1) return context_.output.value(line.parts[0]);
  context_.output.value(Value{std::move(line)});
}

void Runner::execute_body(const std::vector<Statement>& body, const std::string& name, Value value) {
  const auto outside = context_.scope;
  define(name, std::move(value));
  for (const Statement& statement : body) execute(statement);
  context_.scope = outside;
}

void Runner::on(const grammar::Sweep& s, Span span) {
  check_definable(s.name, context_, span);
  const Value range = evaluate(*s.range, context_);
  const auto* list = range.as<ListValue>();
  if (!list) throw Located(wrong_type("what sweep runs through", "a range or a list", range), s.range->span);
  const KeepingPlans keeping(context_);
  for (const Value& value : list->items) execute_body(s.body, s.name, value);
}

void Runner::on(const grammar::Animate& a, Span span) {
  check_definable(a.name, context_, span);
  if (context_.animation) throw Error(ErrorKind::word, "E_ANIMATE", "animate cannot stand inside animate");
  const auto* range = std::get_if<grammar::Range>(&a.range->node);
  if (!range || range->step)
    throw Located(Error(ErrorKind::word, "E_ANIMATE", "animate runs through a range without step",
                        "write: animate d in 0 .. 1 frames 60 { … }"),
                  a.range->span);
  const int frames = whole_number(evaluate(*a.frames, context_), "the number of frames", 2, 10'000);
  const auto bound = [&](const grammar::ExprPtr& e) {
    const Value value = evaluate(*e, context_);
    if (const auto* number = value.as<NumberValue>()) return *number;
    throw Located(wrong_type("the end of a range", "a number", value), e->span);
  };
  const NumberValue first = bound(range->first), width = apply_operator("-", bound(range->last), first);
  AnimationFrames collected;
  const KeepingPlans keeping(context_);
  context_.animation = &collected;
  try {
    for (int i = 0; i < frames; ++i) {
      const NumberValue share{Quantity<Algebraic>(Rational(i) / Rational(frames - 1))};
      execute_body(a.body, a.name, Value{apply_operator("+", first, apply_operator("*", share, width))});
    }
  } catch (...) {
    context_.animation = nullptr;
    throw;
  }
  context_.animation = nullptr;
  save_frames(collected);
}

void Runner::refute(const grammar::Expr& condition, Span span, const std::string& details, const Json& witness) {
  outcome_ = Outcome::refuted;
  if (!context_.output.value) return;
  ReportValue report;
  const std::string claim = grammar::to_string(condition);
  report.text = place_prefix(context_, span) + "assertion is false: " + claim + details;
  report.json = Json{{"assert", claim}, {"verdict", "refuted"}, {"witness", witness}};
  context_.output.value(Value{std::move(report)});
}

void Runner::on(const grammar::Assert& a, Span span) {
  const auto* b = std::get_if<grammar::Binary>(&a.condition->node);
  if (!b || !is_comparison(b->op)) {
    const Value value = evaluate(*a.condition, context_);
    const auto* truth = value.as<Boolean>();
    if (!truth) throw Located(wrong_type("what assert checks", "a condition, such as a == b", value), a.condition->span);
    if (!truth->value) refute(*a.condition, span, "", nullptr);
    return;
  }
  const Value left = evaluate(*b->left, context_), right = evaluate(*b->right, context_);
  bool holds_true = false;
  std::string difference;
  try {
    if (b->op == "==" || b->op == "!=") {
      const Comparison c = compare_values(left, right);
      holds_true = c.equal == (b->op == "==");
      if (!c.equal) difference = c.difference;
    } else {
      const auto *x = left.as<NumberValue>(), *y = right.as<NumberValue>();
      if (!x || !y) throw Error(ErrorKind::word, "E_TYPE", "'" + b->op + "' compares numbers");
      holds_true = holds(b->op, compare(*x, *y));
    }
  } catch (const Located&) {
    throw;
  } catch (const Error& error) {
    throw Located(error, a.condition->span);
  }
  if (holds_true) return;
  std::string details = "\n  left:  " + to_text(left) + "\n  right: " + to_text(right);
  if (!difference.empty()) details += "\n  first difference: " + difference;
  refute(*a.condition, span, details, Json{{"left", to_json(left)}, {"right", to_json(right)}, {"difference", difference}});
}

void Runner::on(const grammar::Claim& c, Span) {
  std::vector<std::string> variables;
  for (const grammar::Domain& d : c.domains) variables.push_back(d.name);
  check_names(*c.claim, context_, variables);
  settle(decide_claim(c, context_));
}

void Runner::on(const grammar::Verify& v, Span) { settle(verify_file(v.path, context_)); }

/// Prints a decision; the worst one of the program decides its exit code.
void Runner::settle(Value decision) {
  const Verdict verdict = decision.as<ReportValue>()->claim->verdict;
  const bool evidence = decision.as<ReportValue>()->claim->evidence;
  if (verdict == Verdict::refuted) outcome_ = Outcome::refuted;
  if ((verdict == Verdict::undecided) && !evidence && outcome_ == Outcome::done) outcome_ = Outcome::undecided;
  if (context_.output.value) context_.output.value(decision);
  last_ = decision;
  has_last_ = true;
  result_ = std::move(decision);
}

void Runner::on(const grammar::Use& u, Span) {
  const std::filesystem::path path = std::filesystem::weakly_canonical(context_.folder / u.path);
  if (std::find(files_.begin(), files_.end(), path) != files_.end())
    throw Error(ErrorKind::file, "E_USE_CYCLE", "'" + u.path + "' is being used already: the files use each other in a circle");
  if (files_.size() >= 50) throw Error(ErrorKind::limit, "E_USE_CYCLE", "files use each other more than 50 levels deep");
  const auto source = std::make_shared<const SourceText>(SourceText{u.path, read_file(context_.folder / u.path)});
  files_.push_back(path);
  run(source, path.parent_path(), {});
  files_.pop_back();
}

}  // namespace udcp
