// Brackets are written where the precedences of ast.h ask for them and nowhere else.
#include "grammar/print_expression.h"

#include <algorithm>
#include <type_traits>

#include "grammar/print.h"

namespace udcp::grammar {
namespace {

// Levels below and above those of the operators: what needs brackets inside what.
constexpr int pipe_level = -2, value_level = -1, operation_level = 0, tight = 10;

struct Printer {
  std::string& out;
  Layout layout;

  // ---- levels
  static int level_of(const WordExpr& word) {
    if (word.on_triangles || !word.where.empty()) return value_level;
    return word.items.size() > 1 ? precedence::items : precedence::power;
  }
  static int level_of(const Expr& expr) {
    if (const Binary* binary = std::get_if<Binary>(&expr.node)) return precedence_of(binary->op);
    if (const Unary* unary = std::get_if<Unary>(&expr.node)) return unary->op == "-" ? precedence::sign : precedence::negation;
    if (const WordExpr* word = std::get_if<WordExpr>(&expr.node)) return level_of(*word);
    if (std::holds_alternative<Pipe>(expr.node)) return pipe_level;
    if (std::holds_alternative<Step>(expr.node) || std::holds_alternative<Range>(expr.node)) return value_level;
    return std::holds_alternative<Conditional>(expr.node) ? operation_level : tight;
  }

  void put(const Expr& expr, int least) {
    if (level_of(expr) < least) return in_brackets(expr);
    std::visit([this](const auto& node) { print(node); }, expr.node);
  }
  void put(const ExprPtr& expr, int least) { put(*expr, least); }

  void in_brackets(const Expr& expr) {
    out += '(';
    nested([&] { put(expr, pipe_level); });
    out += ')';
  }

  /// Inside brackets lines are not broken and bindings stand in braces.
  template <class Body>
  void nested(Body body) {
    const Layout outside = layout;
    layout.braces = true;
    layout.broken = false;
    body();
    layout = outside;
  }

  template <class List, class Item>
  void list(const List& items, Item item) {
    for (std::size_t i = 0; i < items.size(); ++i) {
      if (i > 0) out += ", ";
      item(items[i]);
    }
  }

  // ---- nodes
  void print(const Number& node) { out += node.text; }
  void print(const Text& node) { out += quoted(node.raw); }
  void print(const Name& node) { out += node.name; }
  void print(const Attribute& node) { out += "v." + node.name; }

  void print(const Unary& node) {
    const bool minus = node.op == "-";
    out += minus ? "-" : "not ";
    put(node.operand, minus ? precedence::sign : precedence::negation);
  }

  void print(const Binary& node) {
    const int level = precedence_of(node.op);
    if (level == precedence::power) return print_power(node.left, node.right);
    put(node.left, level == precedence::comparison ? level + 1 : level);
    out += level == precedence::product ? node.op : " " + node.op + " ";
    put(node.right, level + 1);
  }
  void print_power(const ExprPtr& base, const ExprPtr& exponent) {
    put(base, tight);
    put_exponent(exponent);
  }
  void put_exponent(const ExprPtr& exponent) {
    out += '^';
    const Expr* inner = exponent.get();
    for (const Unary* sign = std::get_if<Unary>(&inner->node); sign && sign->op == "-"; sign = std::get_if<Unary>(&inner->node)) {
      out += '-';
      inner = sign->operand.get();
    }
    put(*inner, precedence::power);
  }

  void print(const Conditional& node) {
    out += "if ";
    put(node.condition, operation_level);
    out += " then ";
    put(node.then, operation_level);
    out += " else ";
    put(node.otherwise, operation_level);
  }

  void print(const List& node) {
    out += '[';
    nested([&] { list(node.items, [this](const ExprPtr& item) { put(item, pipe_level); }); });
    out += ']';
  }

  void print(const Range& node) {
    put(node.first, operation_level);
    out += " .. ";
    put(node.last, operation_level);
    if (!node.step) return;
    out += " step ";
    put(node.step, operation_level);
  }

  void print(const Interval& node) {
    out += node.lower_open ? '(' : '[';
    nested([&] {
      put(node.lower, pipe_level);
      out += ", ";
      put(node.upper, pipe_level);
    });
    out += node.upper_open ? ')' : ']';
  }

  void arguments(const std::vector<Argument>& given) {
    out += '(';
    nested([&] {
      list(given, [this](const Argument& argument) {
        if (!argument.name.empty()) out += argument.name + (argument.in ? " in " : " = ");
        put(argument.value, pipe_level);
      });
    });
    out += ')';
  }
  void print(const Call& node) {
    out += node.name;
    arguments(node.arguments);
  }
  void print(const Method& node) {
    const bool number = std::holds_alternative<Number>(node.object->node);
    number ? in_brackets(*node.object) : put(node.object, tight);
    out += "." + node.name;
    arguments(node.arguments);
  }
  void print(const Index& node) {
    put(node.object, tight);
    out += '[';
    nested([&] { put(node.index, pipe_level); });
    out += ']';
  }

  void print(const Pipe& node) {
    put(node.input, pipe_level);
    line_break(2);
    out += "|> ";
    put(node.step, value_level);
  }
  void print(const Step& node) {
    out += node.verb;
    if (node.arguments.empty()) return;
    const Argument& first = node.arguments.front();
    if (node.arguments.size() > 1 || !first.name.empty() || !std::holds_alternative<Text>(first.value->node)) {
      return arguments(node.arguments);
    }
    out += ' ';
    put(first.value, tight);
  }

  // ---- words
  void print(const WordExpr& word) {
    const std::size_t size = word.items.size();
    for (std::size_t i = 0; i < size; ++i) {
      const WordItem& item = word.items[word.written_right_to_left ? size - 1 - i : i];
      if (i > 0 && word.written_right_to_left) {
        out += " . ";
      } else if (i > 0 && !attached(word.items[i - 1], item, i + 1 == size)) {
        out += ' ';
      }
      print(item);
    }
    if (word.on_triangles) out += " on triangles";
    if (!word.where.empty()) print_where(word.where);
  }

  static bool plain_atom(const WordItem& item) {
    return std::holds_alternative<AtomItem>(item.what) && !item.power && !item.sections && item.bindings.empty();
  }
  /// UCP, and UCP[delta = 1/2] at the end of a word; blanks set off all other items.
  static bool attached(const WordItem& before, const WordItem& item, bool last) {
    const bool with_arguments = std::holds_alternative<AtomItem>(item.what) && !item.power && last;
    return plain_atom(before) && (plain_atom(item) || with_arguments);
  }

  void print(const WordItem& item) {
    std::visit([this](const auto& what) { print(what); }, item.what);
    if (item.sections || !item.bindings.empty()) {
      out += '[';
      nested([&] {
        if (item.sections) put(item.sections, pipe_level);
        list(item.bindings, [this](const Binding& binding) { print(binding); });
      });
      out += ']';
    }
    if (item.star) out += '*';
    if (item.power) put_exponent(item.power);
  }
  void print(const AtomItem& item) { out += item.letter; }
  void print(const GroupItem& item) {
    out += '(';
    nested([&] { print(*item.word); });
    out += ')';
  }
  void print(const NamedItem& item) {
    out += item.name;
    if (item.has_arguments) arguments(item.arguments);
  }

  void print(const Binding& binding) {
    out += binding.name;
    if (!binding.direction.empty()) out += "@" + binding.direction;
    if (!binding.parameter.empty()) out += "(" + binding.parameter + ")";
    out += " = ";
    put(binding.value, operation_level);
  }

  void print_where(const std::vector<Binding>& bindings) {
    line_break(2);
    out += layout.braces ? "where {" : "where ";
    for (std::size_t i = 0; i < bindings.size(); ++i) {
      std::string text;
      Printer{text, layout}.nested_binding(bindings[i]);
      if (i > 0) out += ',';
      if (i > 0 && layout.broken && column() + text.size() + 2 > widest_line) {
        line_break(8);
      } else if (i > 0) {
        out += ' ';
      }
      out += text;
    }
    if (layout.braces) out += '}';
  }
  void nested_binding(const Binding& binding) {
    nested([&] { print(binding); });
  }

  [[nodiscard]] std::size_t column() const {
    const std::size_t newline = out.rfind('\n');
    return newline == std::string::npos ? out.size() : out.size() - newline - 1;
  }
  /// A new line in a broken layout, else a blank.
  void line_break(std::size_t further) {
    out += layout.broken ? '\n' : ' ';
    if (layout.broken) out.append(layout.indent + further, ' ');
  }
};

}  // namespace

void print(std::string& out, const Expr& expr, Position position, const Layout& layout) {
  const int level = position == Position::expression ? pipe_level : position == Position::value ? value_level : operation_level;
  Printer{out, layout}.put(expr, level);
}

void print(std::string& out, const WordExpr& word, const Layout& layout) { Printer{out, layout}.print(word); }

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      result += std::string("\\") + c;
    } else if (c == '\n') {
      result += "\\n";
    } else if (c == '\t') {
      result += "\\t";
    } else {
      result += c;
    }
  }
  return result + "\"";
}

std::string to_string(const Expr& expr) {
  std::string out;
  print(out, expr, Position::expression, Layout{});
  return out;
}

std::string to_string(const WordExpr& word) {
  std::string out;
  print(out, word, Layout{});
  return out;
}

}  // namespace udcp::grammar
