// The evaluation of expressions in a number type. Stateless between calls: what bounds it travels along in Bounds.
#include "interpreter/evaluate.h"

#include <map>

#include "interpreter/arithmetic.h"
#include "interpreter/formula.h"
#include "operators/interrupt.h"

namespace udcp {

namespace {

using grammar::Expr;

/// One evaluation. The frame changes at every call of a user function; context, bounds and counters stay.
template <class S>
class Evaluation {
 public:
  Evaluation(const Context<S>& context, const Bounds& bounds) : context_(context), bounds_(bounds) {}

  struct Frame {
    const Environment* scope = nullptr;
    const std::map<std::string, Quantity<S>>* locals = nullptr;
    const FunctionValue* function = nullptr;
    int depth = 0;
  };

  Quantity<S> number(const Expr& e, const Frame& frame) {
    return located(e, [&] { return std::visit([&](const auto& node) { return value(node, frame); }, e.node); });
  }

  bool condition(const Expr& e, const Frame& frame) {
    return located(e, [&] { return decide(e, frame); });
  }

 private:
  template <class F>
  auto located(const Expr& e, F f) -> decltype(f()) {
    if (++steps_ > max_steps)
      throw Located(Error(ErrorKind::limit, "E_STEPS", "this formula took more than " + std::to_string(max_steps) + " steps",
                          "a recursive function may not come to an end"),
                    e.span);
    const Nesting level(nesting_);
    if (nesting_ > max_nesting) throw Located(too_deep(), e.span);
    if ((steps_ & 255) == 0) throw_if_stopped(bounds_.stop.get());
    try {
      return f();
    } catch (const Located&) {
      throw;
    } catch (const Error& error) {
      throw Located(error, e.span);
    }
  }

  Quantity<S> value(const grammar::Number& n, const Frame&) { return Quantity<S>(Rational::parse(n.text)); }

  Quantity<S> value(const grammar::Name& n, const Frame& frame) {
    if (frame.locals) {
      const auto local = frame.locals->find(n.name);
      if (local != frame.locals->end()) return local->second;
    }
    const Environment::Found found = frame.scope->lookup(n.name);
    if (!found.in_frame) {
      if (n.name == "alpha") return context_.alpha;
      if (n.name == "N") return Quantity<S>(context_.valence);
      if (n.name == "h") return Quantity<S>(context_.round);
      if (n.name == "pi") return Quantity<S>::pi();
    }
    if (!found.value) throw unknown_name(n.name, *frame.scope, true);
    if (const auto* a_number = found.value->as<NumberValue>()) return quantity<S>(*a_number);
    throw wrong_type("'" + n.name + "'", "a number", *found.value);
  }

  Quantity<S> value(const grammar::Attribute& a, const Frame&) { return context_.attribute(a.name); }

  Quantity<S> value(const grammar::Unary& u, const Frame& frame) {
    if (u.op == "-") return -number(*u.operand, frame);
    throw not_a_number("a condition");
  }

  Quantity<S> value(const grammar::Binary& b, const Frame& frame) {
    if (is_comparison(b.op) || b.op == "and" || b.op == "or") throw not_a_number("a condition");
    const Quantity<S> left = number(*b.left, frame);
    return binary(b.op, left, number(*b.right, frame));
  }

  Quantity<S> value(const grammar::Conditional& c, const Frame& frame) {
    return number(condition(*c.condition, frame) ? *c.then : *c.otherwise, frame);
  }

  Quantity<S> value(const grammar::Index& x, const Frame& frame) {
    const Quantity<S> at = number(*x.index, frame);
    const bool whole = at.kind() == Quantity<S>::Kind::rational && at.exact().fits_int();
    const int i = whole ? at.exact().to_int() : -1;
    if (const auto* list = std::get_if<grammar::List>(&x.object->node)) {
      check_index(i, list->items.size());
      return number(*list->items[static_cast<std::size_t>(i)], frame);
    }
    const auto* name = std::get_if<grammar::Name>(&x.object->node);
    const Value* found = name ? frame.scope->find(name->name) : nullptr;
    if (name && !found) throw unknown_name(name->name, *frame.scope, true);
    const auto* list = found ? found->as<ListValue>() : nullptr;
    if (!list) throw Error(ErrorKind::word, "E_TYPE", "only a list can be indexed inside a formula");
    check_index(i, list->items.size());
    const Value& item = list->items[static_cast<std::size_t>(i)];
    if (const auto* a_number = item.template as<NumberValue>()) return quantity<S>(*a_number);
    throw wrong_type("item " + std::to_string(i), "a number", item);
  }

  Quantity<S> value(const grammar::Call& call, const Frame& frame) {
    if (call.name == "noise") return noise_value(call, frame);
    std::vector<Quantity<S>> arguments;
    for (const grammar::Argument& a : call.arguments) {
      if (!a.name.empty())
        throw Error(ErrorKind::word, "E_ARGUMENTS",
                    "'" + call.name + "' takes no argument named '" + a.name + "' inside a formula");
      arguments.push_back(number(*a.value, frame));
    }
    if (is_number_function(call.name)) return number_function(call.name, arguments);
    return call_user(call.name, arguments, frame);
  }

  Quantity<S> noise_value(const grammar::Call& call, const Frame& frame) {
    if (call.arguments.size() != 1) throw Error(ErrorKind::word, "E_ARGUMENTS", "noise(seed) takes one integer");
    const Quantity<S> seed = number(*call.arguments[0].value, frame);
    if (seed.kind() != Quantity<S>::Kind::rational || !seed.exact().is_integer())
      throw Error(ErrorKind::word, "E_TYPE", "the seed of noise must be an integer");
    if (context_.vertex < 0) throw Error(ErrorKind::word, "E_NAME", "noise has a value only inside the formulas of a word");
    return noise<S>(seed.exact() + Rational(static_cast<long long>(bounds_.seed)), context_.round, context_.vertex);
  }

  Quantity<S> call_user(const std::string& name, const std::vector<Quantity<S>>& arguments, const Frame& frame) {
    const FunctionValue* function = find_function(name, frame);
    if (function->parameters.size() != arguments.size()) throw wrong_count(*function, arguments.size());
    if (frame.depth >= max_call_depth) throw too_deep();
    std::map<std::string, Quantity<S>> locals;
    for (std::size_t i = 0; i < arguments.size(); ++i) locals.emplace(function->parameters[i], arguments[i]);
    try {
      return number(*function->body, Frame{function->scope.get(), &locals, function, frame.depth + 1});
    } catch (const Located& error) {
      rethrow_from(*function, error);
    }
  }

  const FunctionValue* find_function(const std::string& name, const Frame& frame) const {
    if (frame.function && frame.function->name == name) return frame.function;
    const Value* found = frame.scope->find(name);
    if (!found) throw unknown_name(name, *frame.scope, true);
    const auto* function = found->as<FunctionValue>();
    if (!function) throw wrong_type("'" + name + "'", "a function", *found);
    return function;
  }

  template <class Node>
  Quantity<S> value(const Node&, const Frame&) {
    throw not_a_number(kind_of_node(Node{}));
  }

  bool decide(const Expr& e, const Frame& frame) {
    if (const auto* b = std::get_if<grammar::Binary>(&e.node)) {
      if (b->op == "and") return condition(*b->left, frame) && condition(*b->right, frame);
      if (b->op == "or") return condition(*b->left, frame) || condition(*b->right, frame);
      if (is_comparison(b->op)) {
        const Quantity<S> left = number(*b->left, frame);
        return holds(b->op, compare(left, number(*b->right, frame)));
      }
    }
    if (const auto* u = std::get_if<grammar::Unary>(&e.node)) {
      if (u->op == "not") return !condition(*u->operand, frame);
    }
    if (const auto* c = std::get_if<grammar::Conditional>(&e.node))
      return condition(condition(*c->condition, frame) ? *c->then : *c->otherwise, frame);
    if (const auto* n = std::get_if<grammar::Name>(&e.node)) {
      const Value* found = frame.scope->find(n->name);
      if (const auto* truth = found ? found->as<Boolean>() : nullptr) return truth->value;
      if (!found && (n->name == "yes" || n->name == "true")) return true;
      if (!found && (n->name == "no" || n->name == "false")) return false;
    }
    throw Error(ErrorKind::word, "E_TYPE", "a condition was expected here, such as N == 4 or alpha < 1");
  }

  const Context<S>& context_;
  const Bounds& bounds_;
  std::int64_t steps_ = 0;
  int nesting_ = 0;
};

}  // namespace

template <class S>
Quantity<S> evaluate(const Expr& expr, const Context<S>& context, const Environment& scope, const Bounds& bounds) {
  return Evaluation<S>(context, bounds).number(expr, {&scope, nullptr, nullptr, 0});
}

template <class S>
Quantity<S> evaluate_formula(const FormulaText& formula, const Context<S>& context) {
  std::map<std::string, Quantity<S>> locals;
  if (!formula.parameter.empty()) {
    Quantity<S> stood_for = context.alpha;
    if (formula.stands_for == "N") stood_for = Quantity<S>(context.valence);
    if (formula.stands_for == "h") stood_for = Quantity<S>(context.round);
    locals.emplace(formula.parameter, stood_for);
  }
  return Evaluation<S>(context, formula.bounds).number(*formula.body, {formula.scope.get(), &locals, nullptr, 0});
}

#define X(S)                                                                                                                  \
  template Quantity<S> evaluate(const Expr& expr, const Context<S>& context, const Environment& scope, const Bounds& bounds); \
  template Quantity<S> evaluate_formula(const FormulaText& formula, const Context<S>& context);
UDCP_FOR_EACH_NUMBER(X)
#undef X

}  // namespace udcp
