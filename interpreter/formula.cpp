// Formulas as kernels: what they mention, constants folded, and when two of them are the same. Also the errors about names.
#include "interpreter/formula.h"

#include <algorithm>
#include <optional>
#include <set>

#include "grammar/print.h"
#include "interpreter/arithmetic.h"
#include "interpreter/prefix_form.h"
#include "interpreter/report.h"

namespace udcp {

namespace {

using grammar::Expr;

/// Walks a formula: which variables it uses, which bindings it reads, and whether all names are known.
class Reader {
 public:
  Uses uses;
  std::string bindings;  // "w = 1/16; g(x) = x/2; ", in order of appearance

  void read(const Expr& e, const Environment& scope, const std::set<std::string>& bound, bool check) {
    std::visit([&](const auto& node) { see(node, e, scope, bound, check); }, e.node);
  }

 private:
  using Scope = const Environment&;
  using Bound = const std::set<std::string>&;

  void see(const grammar::Name& n, const Expr& e, Scope scope, Bound bound, bool check) {
    if (bound.contains(n.name)) return;
    const Environment::Found found = scope.lookup(n.name);
    if (!found.in_frame) {
      if (n.name == "alpha") uses.alpha = true;
      if (n.name == "N") uses.valence = true;
      if (n.name == "h") uses.round = true;
      if (n.name == "alpha" || n.name == "N" || n.name == "h" || n.name == "pi") return;
    }
    static const std::set<std::string> truth = {"yes", "no", "true", "false"};
    if (!found.value && truth.contains(n.name)) return;
    if (!found.value && check) throw Located(unknown_name(n.name, scope, true), e.span);
    if (found.value) note(n.name, *found.value);
  }
  void see(const grammar::Attribute& a, const Expr&, Scope, Bound, bool) {
    uses.vertex = true;
    bindings += "v." + a.name + "; ";
  }
  void see(const grammar::Unary& u, const Expr&, Scope scope, Bound bound, bool check) { read(*u.operand, scope, bound, check); }
  void see(const grammar::Binary& b, const Expr&, Scope scope, Bound bound, bool check) {
    read(*b.left, scope, bound, check);
    read(*b.right, scope, bound, check);
  }
  void see(const grammar::Conditional& c, const Expr&, Scope scope, Bound bound, bool check) {
    read(*c.condition, scope, bound, check);
    read(*c.then, scope, bound, check);
    read(*c.otherwise, scope, bound, check);
  }
  void see(const grammar::Index& x, const Expr&, Scope scope, Bound bound, bool check) {
    read(*x.object, scope, bound, check);
    read(*x.index, scope, bound, check);
  }
  void see(const grammar::List& l, const Expr&, Scope scope, Bound bound, bool check) {
    for (const auto& item : l.items) read(*item, scope, bound, check);
  }
  void see(const grammar::Call& call, const Expr& e, Scope scope, Bound bound, bool check) {
    for (const auto& argument : call.arguments) read(*argument.value, scope, bound, check);
    if (call.name == "noise") uses.vertex = uses.round = true;
    if (call.name == "noise" || is_number_function(call.name)) return;
    const Value* found = scope.find(call.name);
    if (!found && inside_.contains(call.name)) return;  // a function that calls itself
    if (!found && check) throw Located(unknown_name(call.name, scope, true), e.span);
    const auto* function = found ? found->as<FunctionValue>() : nullptr;
    if (!function || !inside_.insert(call.name).second) return;
    bindings += signature(*function) + " = " + grammar::to_string(*function->body) + "; ";
    read(*function->body, *function->scope, {function->parameters.begin(), function->parameters.end()}, false);
  }
  template <class Node>
  void see(const Node&, const Expr&, Scope, Bound, bool) {}  // evaluation says what is wrong with it

  void note(const std::string& name, const Value& value) {
    if (value.as<NumberValue>() || value.as<Boolean>() || value.as<ListValue>()) bindings += name + " = " + to_text(value) + "; ";
  }

  std::set<std::string> inside_;
};

class ExprKernel final : public Kernel {
 public:
  explicit ExprKernel(FormulaText formula) : formula_(std::move(formula)) {
    Reader reader;
    std::set<std::string> bound;
    if (!formula_.parameter.empty()) bound.insert(formula_.parameter);
    reader.read(*formula_.body, *formula_.scope, bound, true);
    uses_ = reader.uses;
    if (!formula_.parameter.empty()) (formula_.stands_for == "N" ? uses_.valence : uses_.alpha) = true;
    text_ = formula_.parameter + ": " + grammar::to_string(*formula_.body) + "; " + reader.bindings;
    if (uses_.vertex) text_ += "seed " + std::to_string(formula_.bounds.seed);
    if (!uses_.alpha && !uses_.valence && !uses_.round && !uses_.vertex) fold();
  }

  [[nodiscard]] Needs needs() const override { return {uses_.valence, uses_.vertex, uses_.alpha || uses_.round, uses_.round}; }
#define UDCP_KERNEL_AT(S) \
  [[nodiscard]] Quantity<S> at(const Context<S>& c) const override { return value(c); }
  UDCP_FOR_EACH_NUMBER(UDCP_KERNEL_AT)
#undef UDCP_KERNEL_AT

  [[nodiscard]] std::string closed_form() const override { return prefix_form(formula_); }

  [[nodiscard]] const Uses& uses() const { return uses_; }
  [[nodiscard]] const std::string& text() const { return text_; }
  [[nodiscard]] const std::optional<NumberValue>& constant() const { return constant_; }

 private:
  template <class S>
  Quantity<S> value(const Context<S>& context) const {
    if (constant_) return quantity<S>(*constant_);
    try {
      return evaluate_formula(formula_, context);
    } catch (const Located& error) {
      if (error.source || !formula_.source) throw;
      if (formula_.source->internal) throw Error(static_cast<const Error&>(error));
      throw Located(error, error.span, formula_.source);
    }
  }

  /// Exact constants are kept; others are computed again in the number type of each run, so that double rounds only once.
  void fold() {
    try {
      constant_ = NumberValue{evaluate_formula(formula_, Context<Algebraic>{})};
    } catch (const Error& error) {
      if (error.kind != ErrorKind::not_exact && error.code != "E_FIELD_DEGREE") throw;
      try {
        constant_ = as_number(evaluate_formula(formula_, Context<Parametric>{}));
      } catch (const Error&) {
        (void)evaluate_formula(formula_, Context<Interval>{});
      }
    }
  }

  /// A function of the parameters of a claim; what is none is computed again in the number type of each run.
  static std::optional<NumberValue> as_number(const Quantity<Parametric>& value) {
    const Parametric function = value.value();
    if (function.is_constant()) return std::nullopt;
    return NumberValue{function};
  }

  FormulaText formula_;
  Uses uses_;
  std::string text_;
  std::optional<NumberValue> constant_;
};

/// Edit distance with swaps of neighbours, up to `limit`.
int distance(const std::string& a, const std::string& b) {
  std::vector<std::vector<int>> d(a.size() + 1, std::vector<int>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) {
    for (std::size_t j = 0; j <= b.size(); ++j) {
      if (i == 0 || j == 0) {
        d[i][j] = static_cast<int>(i + j);
        continue;
      }
      d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
    }
  }
  return d[a.size()][b.size()];
}

}  // namespace

KernelPtr make_kernel(FormulaText formula) {
  const grammar::Span span = formula.body->span;
  try {
    return std::make_shared<ExprKernel>(std::move(formula));
  } catch (const Located&) {
    throw;
  } catch (const Error& error) {
    throw Located(error, span);
  }
}

Uses uses(const Kernel& kernel) {
  if (const auto* formula = dynamic_cast<const ExprKernel*>(&kernel)) return formula->uses();
  return {true, true, true, true};
}

bool same_kernel(const KernelPtr& a, const KernelPtr& b, int otherwise) {
  if (a == b) return true;
  const auto constant_of = [&](const KernelPtr& kernel) -> std::optional<NumberValue> {
    if (!kernel) return NumberValue{Quantity<Algebraic>(otherwise)};
    const auto* formula = dynamic_cast<const ExprKernel*>(kernel.get());
    return formula ? formula->constant() : std::nullopt;
  };
  const auto x = constant_of(a);
  const auto y = constant_of(b);
  if (x && y) return compare(*x, *y) == 0;
  const auto* f = dynamic_cast<const ExprKernel*>(a.get());
  const auto* g = dynamic_cast<const ExprKernel*>(b.get());
  return !x && !y && f && g && f->text() == g->text();
}

std::string did_you_mean(const std::string& name, const std::vector<std::string>& known) {
  if (name.size() > 40) return {};
  std::string best;
  int least = name.size() <= 2 ? 2 : name.size() <= 5 ? 3 : 4;  // fewer than half of the letters may be wrong
  for (const std::string& candidate : known) {
    if (candidate.size() > 60) continue;
    const int d = distance(name, candidate);
    if (d < least && d < static_cast<int>(std::max(name.size(), candidate.size()))) {
      least = d;
      best = candidate;
    }
  }
  return best.empty() ? std::string() : "did you mean '" + best + "'?";
}

std::vector<std::string> visible_names(const Environment& scope) {
  std::set<std::string> names;
  for (const Environment* s = &scope; s; s = s->outer.get()) {
    for (const auto& [name, value] : s->names) names.insert(name);
  }
  return {names.begin(), names.end()};
}

Error unknown_name(const std::string& name, const Environment& scope, bool in_formula, const std::vector<std::string>& more) {
  std::vector<std::string> known = visible_names(scope);
  known.insert(known.end(), more.begin(), more.end());
  known.insert(known.end(), number_functions().begin(), number_functions().end());
  for (const char* variable : {"alpha", "N", "h", "pi", "noise"}) known.emplace_back(variable);
  const bool variable = !in_formula && (name == "alpha" || name == "N" || name == "h");
  return Error(ErrorKind::word, "E_NAME", "unknown name '" + name + "'",
               variable ? "alpha, N and h have values only inside the bindings of a word" : did_you_mean(name, known));
}

std::string with_article(const std::string& noun) {
  if (noun == "nothing") return noun;
  const bool vowel = noun.find_first_of("aeiou") == 0;
  return (vowel ? "an " : "a ") + noun;
}

Error wrong_type(const std::string& what, const std::string& expected, const Value& given) {
  return Error(ErrorKind::word, "E_TYPE", what + " must be " + expected + ", but it is " + with_article(type_name(given)));
}

Error not_a_number(const std::string& what) {
  return Error(ErrorKind::word, "E_TYPE", "a number was expected here, but this is " + what);
}

std::string signature(const FunctionValue& function) {
  std::string text = function.name + "(";
  for (std::size_t i = 0; i < function.parameters.size(); ++i) text += (i ? ", " : "") + function.parameters[i];
  return text + ")";
}

Error wrong_count(const FunctionValue& function, std::size_t given) {
  const std::size_t expected = function.parameters.size();
  return Error(ErrorKind::word, "E_ARGUMENTS",
               "'" + function.name + "' takes " + std::to_string(expected) + (expected == 1 ? " argument" : " arguments") +
                   ", but " + std::to_string(given) + (given == 1 ? " was" : " were") + " given",
               "the definition is " + signature(function));
}

Error too_deep() {
  return Error(ErrorKind::limit, "E_CALL_DEPTH",
               "calls are nested too deeply; the limits are " + std::to_string(max_call_depth) + " calls and " +
                   std::to_string(max_nesting) + " expressions inside each other",
               "give a recursive function a case that ends, such as: if n == 0 then 1 else n*f(n - 1)");
}

void check_index(int i, std::size_t size) {
  if (i >= 0 && static_cast<std::size_t>(i) < size) return;
  throw Error(ErrorKind::word, "E_INDEX",
              "this index is outside the list of " + std::to_string(size) + (size == 1 ? " item" : " items"),
              "items count from 0");
}

void rethrow_from(const FunctionValue& function, const Located& error) {
  if (error.source || !function.source) throw Located(error);
  if (function.source->internal) throw Error(error.kind, error.code, "in " + function.name + ": " + error.what(), error.help);
  throw Located(error, error.span, function.source);
}

}  // namespace udcp
