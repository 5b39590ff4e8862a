// Formulas as prefix text, user functions written out. What the prefix form does not know makes the whole text empty.
#include "interpreter/prefix_form.h"

#include <map>

namespace udcp {
namespace {

/// Thrown inside this file only: there is no prefix form.
struct NoForm {};

using Locals = std::map<std::string, std::string>;

class Writer {
 public:
  std::string write(const grammar::Expr& e, const Environment& scope, const Locals& locals) {
    if (++steps_ > 10'000 || depth_ > 100) throw NoForm{};
    ++depth_;
    std::string text = std::visit([&](const auto& node) { return form(node, scope, locals); }, e.node);
    --depth_;
    if (text.size() > 10'000) throw NoForm{};
    return text;
  }

 private:
  std::string form(const grammar::Number& n, const Environment&, const Locals&) { return Rational::parse(n.text).to_string(); }

  std::string form(const grammar::Name& n, const Environment& scope, const Locals& locals) {
    const auto local = locals.find(n.name);
    if (local != locals.end()) return local->second;
    const Environment::Found found = scope.lookup(n.name);
    if (!found.in_frame && (n.name == "alpha" || n.name == "N" || n.name == "pi")) return n.name;
    const auto* number = found.value && n.name != "h" ? found.value->as<NumberValue>() : nullptr;
    const auto* exact = number ? std::get_if<Quantity<Algebraic>>(&number->value) : nullptr;
    if (!exact || exact->kind() == Quantity<Algebraic>::Kind::number) throw NoForm{};
    const std::string factor = exact->exact().to_string();
    return exact->kind() == Quantity<Algebraic>::Kind::rational ? factor : "(* " + factor + " pi)";
  }

  std::string form(const grammar::Unary& u, const Environment& scope, const Locals& locals) {
    if (u.op != "-") throw NoForm{};
    return "(neg " + write(*u.operand, scope, locals) + ")";
  }

  std::string form(const grammar::Binary& b, const Environment& scope, const Locals& locals) {
    if (b.op.size() != 1 || std::string("+-*/^").find(b.op) == std::string::npos) throw NoForm{};
    return "(" + b.op + " " + write(*b.left, scope, locals) + " " + write(*b.right, scope, locals) + ")";
  }

  std::string form(const grammar::Call& call, const Environment& scope, const Locals& locals) {
    std::vector<std::string> arguments;
    for (const grammar::Argument& argument : call.arguments) arguments.push_back(write(*argument.value, scope, locals));
    if (is_number_function(call.name)) return number_function(call.name, arguments);
    const Value* found = scope.find(call.name);
    const auto* function = found ? found->as<FunctionValue>() : nullptr;
    if (!function || function->parameters.size() != arguments.size()) throw NoForm{};
    Locals inner;
    for (std::size_t k = 0; k < arguments.size(); ++k) inner[function->parameters[k]] = arguments[k];
    return write(*function->body, *function->scope, inner);
  }

  static std::string number_function(const std::string& name, const std::vector<std::string>& arguments) {
    if (name != "min" && name != "max") return "(" + name + " " + arguments.at(0) + ")";
    std::string text = arguments.at(0);
    for (std::size_t k = 1; k < arguments.size(); ++k) text = "(" + name + " " + text + " " + arguments[k] + ")";
    return text;
  }

  template <class Node>
  std::string form(const Node&, const Environment&, const Locals&) {
    throw NoForm{};
  }

  int steps_ = 0, depth_ = 0;
};

}  // namespace

std::string prefix_form(const FormulaText& formula) {
  Locals locals;
  if (!formula.parameter.empty()) locals[formula.parameter] = formula.stands_for;
  if (formula.stands_for == "h" && !formula.parameter.empty()) return {};
  try {
    return Writer().write(*formula.body, *formula.scope, locals);
  } catch (const NoForm&) {
    return {};
  }
}

}  // namespace udcp
