// The evaluation of programs' expressions, node by node. Calls and pipe steps are in calls.cpp.
#include "interpreter/expressions.h"

#include <algorithm>
#include <set>

#include "grammar/parse.h"
#include "interpreter/arithmetic.h"
#include "interpreter/builtins.h"
#include "interpreter/compare.h"
#include "interpreter/formula.h"
#include "interpreter/report.h"
#include "interpreter/words.h"
#include "operators/interrupt.h"

namespace udcp {

namespace {

using grammar::Expr;

Value number_value(NumberValue value) { return Value{std::move(value)}; }
Value exact(const Rational& value) { return number_value({Quantity<Algebraic>(value)}); }

std::vector<std::string> builtin_names() {
  std::vector<std::string> names;
  for (const Builtin& b : builtins()) names.emplace_back(b.name);
  return names;
}

/// Arithmetic on numbers, and on lists number by number; a number goes with every item.
Value arithmetic(const std::string& op, const Value& a, const Value& b) {
  const auto *x = a.as<NumberValue>(), *y = b.as<NumberValue>();
  if (x && y) return number_value(apply_operator(op, *x, *y));
  const auto *left = a.as<ListValue>(), *right = b.as<ListValue>();
  const bool scaled = (left && y && (op == "*" || op == "/")) || (x && right && op == "*");
  if ((left && right && (op == "+" || op == "-")) || scaled) {
    if (left && right && left->items.size() != right->items.size())
      throw Error(ErrorKind::word, "E_TYPE",
                  "these lists have " + std::to_string(left->items.size()) + " and " + std::to_string(right->items.size()) +
                      " items; '" + op + "' needs the same number");
    ListValue result;
    for (std::size_t i = 0; i < (left ? left : right)->items.size(); ++i)
      result.items.push_back(arithmetic(op, left ? left->items[i] : a, right ? right->items[i] : b));
    return Value{std::move(result)};
  }
  const auto *s = a.as<TextValue>(), *t = b.as<TextValue>();
  if (op == "+" && s && t) return Value{TextValue{s->value + t->value}};
  throw Error(ErrorKind::word, "E_TYPE",
              "'" + op + "' does not go between " + with_article(type_name(a)) + " and " + with_article(type_name(b)));
}

Value raise(const Value& base, const Value& exponent) {
  const auto* word = base.as<WordValue>();
  if (!word) return arithmetic("^", base, exponent);
  return Value{power(*word, whole_number(exponent, "the number of rounds", 0, std::numeric_limits<int>::max()))};
}

Value compare_with(const std::string& op, const Value& a, const Value& b) {
  if (op == "==" || op == "!=") return Value{Boolean{compare_values(a, b).equal == (op == "==")}};
  const auto *x = a.as<NumberValue>(), *y = b.as<NumberValue>();
  if (!x || !y)
    throw Error(ErrorKind::word, "E_TYPE",
                "'" + op + "' compares numbers, not " + with_article(type_name(a)) + " and " + with_article(type_name(b)));
  return Value{Boolean{holds(op, compare(*x, *y))}};
}

class Evaluator {
 public:
  Evaluator(const Expr& expr, CallContext& context) : expr_(expr), context_(context) {}

  Value operator()(const grammar::Number& n) { return exact(Rational::parse(n.text)); }
  Value operator()(const grammar::Text& t) { return Value{TextValue{interpolate(t.raw, context_)}}; }

  Value operator()(const grammar::Name& n) {
    if (const Value* found = context_.scope->find(n.name)) return *found;
    if (context_.function && context_.function->name == n.name) return Value{*context_.function};
    if (n.name == "_" && context_.last) return *context_.last;
    if (n.name == "pi") return number_value({Quantity<Algebraic>::pi()});
    if (n.name == "yes" || n.name == "true") return Value{Boolean{true}};
    if (n.name == "no" || n.name == "false") return Value{Boolean{false}};
    if (const Builtin* builtin = find_builtin(n.name))
      throw Error(ErrorKind::word, "E_TYPE", "'" + n.name + "' is a function and needs its arguments",
                  "write " + std::string(builtin->signature));
    if (is_number_function(n.name))
      throw Error(ErrorKind::word, "E_TYPE", "'" + n.name + "' is a function and needs its arguments", "write " + n.name + "(x)");
    if (n.name == "oo")
      throw Error(ErrorKind::word, "E_TYPE", "oo stands only in the domain of a claim, as in: for f in (0, oo)");
    throw unknown_name(n.name, *context_.scope, false, builtin_names());
  }

  Value operator()(const grammar::Attribute& a) {
    throw Error(ErrorKind::word, "E_NAME", "v." + a.name + " has a value only inside the formulas of a word");
  }

  Value operator()(const grammar::Unary& u) {
    const Value operand = evaluate(*u.operand, context_);
    if (u.op == "not") return Value{Boolean{!truth(operand)}};
    if (const auto* number = operand.as<NumberValue>()) return number_value(negate(*number));
    return arithmetic("*", exact(-1), operand);
  }

  Value operator()(const grammar::Binary& b) {
    if (b.op == "and") return Value{Boolean{truth(evaluate(*b.left, context_)) && truth(evaluate(*b.right, context_))}};
    if (b.op == "or") return Value{Boolean{truth(evaluate(*b.left, context_)) || truth(evaluate(*b.right, context_))}};
    const Value left = evaluate(*b.left, context_);
    const Value right = evaluate(*b.right, context_);
    if (is_comparison(b.op)) return compare_with(b.op, left, right);
    return b.op == "^" ? raise(left, right) : arithmetic(b.op, left, right);
  }

  Value operator()(const grammar::Conditional& c) {
    return evaluate(truth(evaluate(*c.condition, context_)) ? *c.then : *c.otherwise, context_);
  }

  Value operator()(const grammar::List& l) {
    ListValue list;
    for (const auto& item : l.items) list.items.push_back(evaluate(*item, context_));
    return Value{std::move(list)};
  }

  Value operator()(const grammar::Range& r) {
    const auto bound = [&](const grammar::ExprPtr& e, const char* what) {
      const Value value = evaluate(*e, context_);
      const auto* number = value.as<NumberValue>();
      if (!number) throw Located(wrong_type(what, "a number", value), e->span);
      return *number;
    };
    const NumberValue first = bound(r.first, "the start of a range"), last = bound(r.last, "the end of a range");
    const NumberValue step = r.step ? bound(r.step, "the step of a range") : NumberValue{Quantity<Algebraic>(1)};
    const int sign = compare(step, {Quantity<Algebraic>(0)});
    if (sign == 0) throw Error(ErrorKind::word, "E_RANGE", "the step of a range cannot be 0");
    ListValue list;
    for (NumberValue x = first; sign > 0 ? compare(x, last) <= 0 : compare(x, last) >= 0; x = apply_operator("+", x, step)) {
      if (list.items.size() >= 1'000'000) throw Error(ErrorKind::limit, "E_RANGE", "this range has more than 1000000 values");
      list.items.push_back(number_value(x));
    }
    return Value{std::move(list)};
  }

  Value operator()(const grammar::Interval&) {
    throw Error(ErrorKind::word, "E_TYPE", "an interval stands only in the domain of a claim, as in: for f in (0, 2]");
  }

  Value operator()(const grammar::Call& c);
  Value operator()(const grammar::Method& m);

  Value operator()(const grammar::Index& x) {
    const Value object = evaluate(*x.object, context_);
    const Value index = evaluate(*x.index, context_);
    const std::vector<Value>* items = nullptr;
    if (const auto* list = object.as<ListValue>()) items = &list->items;
    if (const auto* report = object.as<ReportValue>()) items = &report->parts;
    if (!items) throw wrong_type("what stands before [ ]", "a list", object);
    const int i = whole_number(index, "an index", std::numeric_limits<int>::min(), std::numeric_limits<int>::max());
    check_index(i, items->size());
    return (*items)[static_cast<std::size_t>(i)];
  }

  Value operator()(const grammar::WordExpr& w) { return Value{make_word(w, expr_.span, context_)}; }
  Value operator()(const grammar::Pipe& p) {
    Value input = evaluate(*p.input, context_);
    return apply_step(std::move(input), *p.step, context_);
  }
  Value operator()(const grammar::Step& s) {
    throw Error(ErrorKind::word, "E_TYPE", "'" + s.verb + "' needs something to work on",
                "write: shape |> " + s.verb + " \"file\"");
  }

 private:
  static bool truth(const Value& value) {
    if (const auto* boolean = value.as<Boolean>()) return boolean->value;
    throw wrong_type("a condition", "yes or no, such as n == 4", value);
  }

  [[nodiscard]] bool is_own_function(const std::string& name) const {
    const Value* found = context_.scope->find(name);
    return found && found->as<FunctionValue>();
  }
  std::vector<Value> positional(const std::vector<grammar::Argument>& arguments);
  std::vector<std::pair<std::string, Value>> named(const std::vector<grammar::Argument>& arguments, const std::string& function);

  const Expr& expr_;
  CallContext& context_;
};

/// Restores the flag that says "inside a file name".
class PathText {
 public:
  PathText(CallContext& context, const std::string& function) : context_(context), before_(context.path_text) {
    if (function == "save" || function == "plot" || function == "load" || function == "load_curve") context_.path_text = true;
  }
  ~PathText() { context_.path_text = before_; }
  PathText(const PathText&) = delete;
  PathText& operator=(const PathText&) = delete;

 private:
  CallContext& context_;
  bool before_;
};

std::vector<Value> Evaluator::positional(const std::vector<grammar::Argument>& arguments) {
  std::vector<Value> values;
  bool seen_named = false;
  for (const auto& a : arguments) {
    seen_named = seen_named || !a.name.empty();
    if (!a.name.empty()) continue;
    if (seen_named)
      throw Located(Error(ErrorKind::word, "E_ARGUMENTS", "an argument without a name cannot follow one with a name"), a.span);
    values.push_back(evaluate_argument(a, context_, nullptr));
  }
  return values;
}

std::vector<std::pair<std::string, Value>> Evaluator::named(const std::vector<grammar::Argument>& arguments,
                                                            const std::string& function) {
  const Builtin* callee = is_own_function(function) ? nullptr : find_builtin(function);
  std::vector<std::pair<std::string, Value>> values;
  for (const auto& a : arguments) {
    if (a.name.empty()) continue;
    const auto same = [&](const auto& given) { return given.first == a.name; };
    if (std::any_of(values.begin(), values.end(), same))
      throw Located(Error(ErrorKind::word, "E_ARGUMENTS", "the argument '" + a.name + "' is given twice"), a.span);
    values.emplace_back(a.name, evaluate_argument(a, context_, callee));
  }
  return values;
}

Value Evaluator::operator()(const grammar::Call& c) {
  const Builtin* builtin = find_builtin(c.name);
  if (builtin && builtin->special && !is_own_function(c.name)) return builtin->special(context_, c);
  const PathText in_path(context_, c.name);
  std::vector<Value> values = positional(c.arguments);
  return call(c.name, std::move(values), named(c.arguments, c.name), context_);
}

Value Evaluator::operator()(const grammar::Method& m) {
  std::vector<Value> values;
  values.push_back(evaluate(*m.object, context_));
  const PathText in_path(context_, m.name);
  for (Value& v : positional(m.arguments)) values.push_back(std::move(v));
  return call(m.name, std::move(values), named(m.arguments, m.name), context_);
}

/// A number as it goes into a text: "1/4"; into a file name: "0.25", or "1_3" where the decimals do not end.
std::string text_of_number(const Value& value, bool in_path) {
  const auto* number = value.as<NumberValue>();
  const auto* q = number ? std::get_if<Quantity<Algebraic>>(&number->value) : nullptr;
  if (!q || q->kind() != Quantity<Algebraic>::Kind::rational) {
    const std::string text = to_text(value), mark = "≈ ";
    return text.starts_with(mark) ? text.substr(mark.size()) : text;
  }
  const Rational& r = q->exact();
  if (!in_path || r.is_integer()) return r.to_string();
  Rational scaled = abs(r);
  for (int digits = 1; digits <= 12; ++digits) {
    scaled *= Rational(10);
    if (!scaled.is_integer()) continue;
    std::string text = scaled.to_string();
    const std::size_t wanted = static_cast<std::size_t>(digits) + 1;
    if (text.size() < wanted) text.insert(0, wanted - text.size(), '0');
    text.insert(text.size() - static_cast<std::size_t>(digits), ".");
    return (r.sign() < 0 ? "-" : "") + text;
  }
  std::string text = r.to_string();
  std::replace(text.begin(), text.end(), '/', '_');
  return text;
}

std::string text_of_expression(const std::string& inside, CallContext& context) {
  Value value;
  try {
    value = evaluate(*grammar::parse_expression(inside), context);
  } catch (const grammar::SyntaxError& error) {
    throw Error(ErrorKind::word, "E_TEXT", "'{" + inside + "}' inside a text is no expression: " + error.what(),
                "write {{ for a brace");
  } catch (const Located& error) {
    throw Error(error.kind, error.code, std::string("inside '{") + inside + "}': " + error.what(), error.help);
  }
  if (const auto* text = value.as<TextValue>()) return text->value;
  return text_of_number(value, context.path_text);
}

}  // namespace

Value evaluate(const Expr& expr, CallContext& context) {
  const Nesting level(context.depth);
  try {
    if (context.depth > max_nesting) throw too_deep();
    if (++context.steps > max_steps)
      throw Error(ErrorKind::limit, "E_STEPS", "this statement took more than " + std::to_string(max_steps) + " steps",
                  "a recursive function may not come to an end");
    throw_if_stopped(context.stop.get());
    return std::visit(Evaluator(expr, context), expr.node);
  } catch (const Located&) {
    throw;
  } catch (const Error& error) {
    throw Located(error, expr.span);
  }
}

std::string interpolate(const std::string& text, CallContext& context) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c != '{' && c != '}') {
      result += c;
    } else if (i + 1 < text.size() && text[i + 1] == c) {
      result += c;
      ++i;
    } else if (c == '}') {
      throw Error(ErrorKind::word, "E_TEXT", "a text has '}' without '{'", "write }} for a brace");
    } else {
      const std::size_t end = text.find('}', i);
      if (end == std::string::npos) throw Error(ErrorKind::word, "E_TEXT", "a text has '{' without '}'", "write {{ for a brace");
      result += text_of_expression(text.substr(i + 1, end - i - 1), context);
      i = end;
    }
  }
  return result;
}

int whole_number(const Value& value, const std::string& what, int least, int most) {
  const auto* number = value.as<NumberValue>();
  if (!number) throw wrong_type(what, "a whole number", value);
  const auto* q = std::get_if<Quantity<Algebraic>>(&number->value);
  if (q && q->kind() == Quantity<Algebraic>::Kind::rational && q->exact().fits_int()) {
    const int n = q->exact().to_int();
    if (n >= least && n <= most) return n;
  }
  std::string range =
      least > std::numeric_limits<int>::min() ? " from " + std::to_string(least) + " to " + std::to_string(most) : "";
  throw Error(ErrorKind::word, "E_TYPE", what + " must be a whole number" + range + ", but it is " + to_text(value));
}

std::string place_prefix(const CallContext& context, grammar::Span span) {
  if (!context.source) return {};
  const grammar::Place place = grammar::place_of(context.source->text, span.begin);
  return context.source->name + ":" + std::to_string(place.line) + ":" + std::to_string(place.column) + ": ";
}

void warn(const CallContext& context, grammar::Span span, const std::string& message) {
  if (!context.output.warning || (context.source && context.source->internal)) return;
  context.output.warning(place_prefix(context, span) + message);
}

Value evaluate_argument(const grammar::Argument& a, CallContext& context, const Builtin* callee) {
  static const std::set<std::string> choices = {"mode",   "test",  "except", "corners", "step1", "step2",
                                                "method", "order", "solver", "measure", "rule"};
  const auto* name = std::get_if<grammar::Name>(&a.value->node);
  const bool is_choice = callee != nullptr && choices.contains(a.name);
  if (name && is_symbol(name->name) && (is_choice || !context.scope->find(name->name))) return Value{TextValue{name->name}};
  return evaluate(*a.value, context);
}

bool is_symbol(const std::string& name) {
  static const std::set<std::string> symbols = {
      "lat",          "lon",        "both",     "off",     "x",        "y",       "z",         "one_face", "all",       "none",
      "corner",       "sharp",      "interior", "bspline", "boundary", "nothing", "tagged",    "T1",       "T2",        "T3",
      "T4",           "global",     "local",    "plain",   "auto",     "free",    "tied",      "rotate",   "two_level", "literal",
      "kkt",          "jacobi",     "gauss",    "average", "gaussian", "mean",    "automatic", "direct",   "edge",      "star",
      "gauss_seidel", "richardson", "cg",       "eps",     "E",        "En",      "Et",        "paper",    "pair"};
  return symbols.contains(name);
}

}  // namespace udcp
