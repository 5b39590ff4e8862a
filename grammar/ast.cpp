// Equality of trees up to spans, comments and blank lines.
#include "grammar/ast.h"

#include <algorithm>
#include <type_traits>

namespace udcp::grammar {
namespace {

/// One overload a node; members of a struct, so that they see each other.
struct Equality {
  static bool equal(const ExprPtr& a, const ExprPtr& b) { return a && b ? a == b || same(*a, *b) : !a && !b; }

  template <class T, class Equal>
  static bool equal_lists(const std::vector<T>& a, const std::vector<T>& b, Equal equal_items) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), equal_items);
  }
  static bool equal(const std::vector<ExprPtr>& a, const std::vector<ExprPtr>& b) {
    return equal_lists(a, b, [](const ExprPtr& x, const ExprPtr& y) { return equal(x, y); });
  }

  static bool equal(const Argument& a, const Argument& b) { return a.name == b.name && a.in == b.in && equal(a.value, b.value); }
  static bool equal(const std::vector<Argument>& a, const std::vector<Argument>& b) {
    return equal_lists(a, b, [](const Argument& x, const Argument& y) { return equal(x, y); });
  }
  static bool equal(const Binding& a, const Binding& b) {
    return a.name == b.name && a.direction == b.direction && a.parameter == b.parameter && equal(a.value, b.value);
  }
  static bool equal(const std::vector<Binding>& a, const std::vector<Binding>& b) {
    return equal_lists(a, b, [](const Binding& x, const Binding& y) { return equal(x, y); });
  }

  static bool equal(const AtomItem& a, const AtomItem& b) { return a.letter == b.letter; }
  static bool equal(const GroupItem& a, const GroupItem& b) { return equal(*a.word, *b.word); }
  static bool equal(const NamedItem& a, const NamedItem& b) {
    return a.name == b.name && a.has_arguments == b.has_arguments && equal(a.arguments, b.arguments);
  }

  /// Two variants: the same alternative with equal contents.
  template <class Variant>
  static bool equal_variants(const Variant& a, const Variant& b) {
    if (a.index() != b.index()) return false;
    return std::visit([&b](const auto& x) { return equal(x, std::get<std::decay_t<decltype(x)>>(b)); }, a);
  }

  static bool equal(const WordItem& a, const WordItem& b) {
    return equal_variants(a.what, b.what) && equal(a.sections, b.sections) && equal(a.bindings, b.bindings) && a.star == b.star &&
           equal(a.power, b.power);
  }
  static bool equal(const WordExpr& a, const WordExpr& b) {
    return a.written_right_to_left == b.written_right_to_left && a.on_triangles == b.on_triangles && equal(a.where, b.where) &&
           equal_lists(a.items, b.items, [](const WordItem& x, const WordItem& y) { return equal(x, y); });
  }

  static bool equal(const Number& a, const Number& b) { return a.text == b.text; }
  static bool equal(const Text& a, const Text& b) { return a.raw == b.raw; }
  static bool equal(const Name& a, const Name& b) { return a.name == b.name; }
  static bool equal(const Attribute& a, const Attribute& b) { return a.name == b.name; }
  static bool equal(const Unary& a, const Unary& b) { return a.op == b.op && equal(a.operand, b.operand); }
  static bool equal(const Binary& a, const Binary& b) { return a.op == b.op && equal(a.left, b.left) && equal(a.right, b.right); }
  static bool equal(const Conditional& a, const Conditional& b) {
    return equal(a.condition, b.condition) && equal(a.then, b.then) && equal(a.otherwise, b.otherwise);
  }
  static bool equal(const List& a, const List& b) { return equal(a.items, b.items); }
  static bool equal(const Range& a, const Range& b) {
    return equal(a.first, b.first) && equal(a.last, b.last) && equal(a.step, b.step);
  }
  static bool equal(const Interval& a, const Interval& b) {
    return equal(a.lower, b.lower) && equal(a.upper, b.upper) && a.lower_open == b.lower_open && a.upper_open == b.upper_open;
  }
  static bool equal(const Call& a, const Call& b) { return a.name == b.name && equal(a.arguments, b.arguments); }
  static bool equal(const Method& a, const Method& b) {
    return a.name == b.name && equal(a.object, b.object) && equal(a.arguments, b.arguments);
  }
  static bool equal(const Index& a, const Index& b) { return equal(a.object, b.object) && equal(a.index, b.index); }
  static bool equal(const Pipe& a, const Pipe& b) { return equal(a.input, b.input) && equal(a.step, b.step); }
  static bool equal(const Step& a, const Step& b) { return a.verb == b.verb && equal(a.arguments, b.arguments); }

  static bool equal(const Domain& a, const Domain& b) { return a.name == b.name && equal(a.set, b.set); }
  static bool equal(const Define& a, const Define& b) {
    return a.name == b.name && a.is_function == b.is_function && a.parameters == b.parameters && equal(a.value, b.value);
  }
  static bool equal(const Evaluate& a, const Evaluate& b) { return equal(a.value, b.value); }
  static bool equal(const Print& a, const Print& b) { return equal(a.values, b.values); }
  static bool equal(const Sweep& a, const Sweep& b) {
    return a.name == b.name && equal(a.range, b.range) && equal(a.body, b.body);
  }
  static bool equal(const Animate& a, const Animate& b) {
    return a.name == b.name && equal(a.range, b.range) && equal(a.frames, b.frames) && equal(a.body, b.body);
  }
  static bool equal(const Assert& a, const Assert& b) { return equal(a.condition, b.condition); }
  static bool equal(const Claim& a, const Claim& b) {
    return a.prove == b.prove && equal(a.claim, b.claim) && a.certificate == b.certificate &&
           equal_lists(a.domains, b.domains, [](const Domain& x, const Domain& y) { return equal(x, y); });
  }
  static bool equal(const Verify& a, const Verify& b) { return a.path == b.path; }
  static bool equal(const Use& a, const Use& b) { return a.path == b.path; }
  static bool equal(const Set& a, const Set& b) { return a.name == b.name && equal(a.value, b.value); }
  static bool equal(const std::vector<Statement>& a, const std::vector<Statement>& b) {
    return equal_lists(a, b, [](const Statement& x, const Statement& y) { return equal_variants(x.node, y.node); });
  }
};

}  // namespace

int precedence_of(const std::string& op) {
  if (op == "or") return precedence::disjunction;
  if (op == "and") return precedence::conjunction;
  if (op == "+" || op == "-") return precedence::sum;
  if (op == "*" || op == "/") return precedence::product;
  if (op == "^") return precedence::power;
  return precedence::comparison;
}

bool same(const Expr& a, const Expr& b) { return Equality::equal_variants(a.node, b.node); }
bool same(const Program& a, const Program& b) { return Equality::equal(a.statements, b.statements); }

}  // namespace udcp::grammar
