// Statements, comments and blank lines as text. Expressions stand in print_expression.cpp.
#include "grammar/print.h"

#include "grammar/print_expression.h"

namespace udcp::grammar {
namespace {

/// Whether the text of an expression begins with the word print: at the start of a statement that needs brackets.
bool begins_with_print(const Expr& expr) {
  const Expr* first = &expr;
  while (const Pipe* pipe = std::get_if<Pipe>(&first->node)) first = pipe->input.get();
  const Step* step = std::get_if<Step>(&first->node);
  return step && step->verb == "print";
}

struct ProgramPrinter {
  std::string out;

  void print(const Program& program) {
    statements(program.statements, 0);
    comments(program.comments_after, 0);
  }

  void statements(const std::vector<Statement>& list, std::size_t indent) {
    for (const Statement& statement : list) {
      if (statement.blank_before && &statement != &list.front()) out += '\n';
      comments(statement.comments_before, indent);
      out += std::string(indent, ' ') + text(statement, indent);
      if (!statement.comment_after.empty()) out += "  #" + statement.comment_after;
      out += '\n';
    }
  }

  void comments(const std::vector<std::string>& list, std::size_t indent) {
    for (const std::string& comment : list) {
      if (comment != "\n") out += std::string(indent, ' ') + "#" + comment;
      out += '\n';
    }
  }

  /// A statement without a block, or whose block holds one such statement without comments: it may stand on one line.
  static bool may_be_flat(const Statement& statement) {
    const auto single = [](const auto& loop) {
      if (loop.body.empty()) return loop.comments_after.empty();
      const Statement& first = loop.body.front();
      return loop.body.size() == 1 && loop.comments_after.empty() && first.comments_before.empty() &&
             first.comment_after.empty() && !std::holds_alternative<Sweep>(first.node) &&
             !std::holds_alternative<Animate>(first.node);
    };
    if (const Sweep* sweep = std::get_if<Sweep>(&statement.node)) return single(*sweep);
    if (const Animate* animate = std::get_if<Animate>(&statement.node)) return single(*animate);
    return true;
  }

  /// On one line if it fits, else broken.
  static std::string text(const Statement& statement, std::size_t indent) {
    if (may_be_flat(statement)) {
      std::string flat = layout(statement, {false, false, indent});
      if (indent + flat.size() <= widest_line) return flat;
    }
    return layout(statement, {false, true, indent});
  }

  static std::string layout(const Statement& statement, const Layout& layout) {
    return std::visit([&](const auto& node) { return text(node, layout); }, statement.node);
  }

  static std::string text(const Expr& expr, Position position, Layout layout, bool braces) {
    std::string result;
    layout.braces = braces;
    grammar::print(result, expr, position, layout);
    return result;
  }

  static std::string text(const Define& node, const Layout& layout) {
    std::string head = node.name;
    if (node.is_function) {
      head += '(';
      for (std::size_t i = 0; i < node.parameters.size(); ++i) head += (i > 0 ? ", " : "") + node.parameters[i];
      head += ')';
    }
    return head + " = " + text(*node.value, Position::expression, layout, false);
  }

  static std::string text(const Evaluate& node, const Layout& layout) {
    if (!begins_with_print(*node.value)) return text(*node.value, Position::expression, layout, false);
    std::string result = "(";
    return result.append(text(*node.value, Position::expression, {true, false, layout.indent}, true)).append(")");
  }

  static std::string text(const Print& node, const Layout& layout) {
    std::string result = "print ";
    for (std::size_t i = 0; i < node.values.size(); ++i) {
      result += (i > 0 ? ", " : "") + text(*node.values[i], Position::expression, layout, true);
    }
    return result;
  }

  static std::string text(const Sweep& node, const Layout& layout) {
    const std::string head = "sweep " + node.name + " in " + text(*node.range, Position::value, {}, true) + " ";
    return head + block(node.body, node.comments_after, layout);
  }

  static std::string text(const Animate& node, const Layout& layout) {
    const std::string head = "animate " + node.name + " in " + text(*node.range, Position::value, {}, true) + " frames " +
                             text(*node.frames, Position::operation, {}, true) + " ";
    return head + block(node.body, node.comments_after, layout);
  }

  static std::string block(const std::vector<Statement>& body, const std::vector<std::string>& after, const Layout& layout) {
    if (body.empty() && after.empty()) return "{ }";
    if (!layout.broken) return "{ " + ProgramPrinter::layout(body[0], layout) + " }";
    ProgramPrinter inner;
    inner.statements(body, layout.indent + 2);
    inner.comments(after, layout.indent + 2);
    return "{\n" + inner.out + std::string(layout.indent, ' ') + "}";
  }

  static std::string text(const Assert& node, const Layout& layout) {
    return "assert " + text(*node.condition, Position::expression, layout, false);
  }

  static std::string text(const Claim& node, const Layout& layout) {
    std::string result = (node.prove ? "prove " : "check ") + text(*node.claim, Position::expression, layout, true);
    for (std::size_t i = 0; i < node.domains.size(); ++i) {
      const Domain& domain = node.domains[i];
      result += (i > 0 ? ", " : " for ") + domain.name + " in " + text(*domain.set, Position::value, {}, true);
    }
    if (node.certificate) result += " -> " + quoted(*node.certificate);
    return result;
  }

  static std::string text(const Verify& node, const Layout&) { return "verify " + quoted(node.path); }
  static std::string text(const Use& node, const Layout&) { return "use " + quoted(node.path); }
  static std::string text(const Set& node, const Layout& layout) {
    return "set " + node.name + " = " + text(*node.value, Position::expression, layout, false);
  }
};

}  // namespace

std::string to_string(const Program& program) {
  ProgramPrinter printer;
  printer.print(program);
  return std::move(printer.out);
}

}  // namespace udcp::grammar
