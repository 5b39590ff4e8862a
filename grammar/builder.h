// Builds the syntax tree while the grammar runs: one method per action, finished operands on a stack, precedences by the table in
// ast.h. Computes nothing and knows no PEGTL; drafts.h says what operands become. Every method may throw SyntaxError.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "grammar/ast.h"
#include "grammar/drafts.h"

namespace udcp::grammar {

/// An entry of a call, of item arguments or of where: `value`, or `name = value`.
struct Entry {
  Draft left;
  std::optional<Draft> right;
  bool in = false;  // name in set
};

class Builder {
 public:
  explicit Builder(std::string_view text) : text_(text) { bodies_.emplace_back(); }

  // For the rules that ask, and for whoever raises an error.
  [[nodiscard]] bool inside_brackets() const { return brackets_ > 0; }
  [[nodiscard]] bool star_may_stand(const char* place) const;
  /// The innermost bracket that is still open; nullptr if there is none.
  [[nodiscard]] const Span* open_bracket() const;
  [[nodiscard]] std::string_view text() const { return text_; }

  // Tokens that become operands, and comments.
  void comment(Span span);
  void number(Span span);
  void string(Span span);
  void name(Span span);
  void greek_name(Span span);
  void atom(Span span);
  void direction(Span span);

  // Brackets and what stands in them.
  void open(Span span);
  void close(Span span);
  void entry_sign();
  void entry_in();
  void entry();
  void call_done();
  void bracket();
  void called();
  void item_arguments();
  void member();
  void conditional(Span whole);

  // Rows of operands and operators.
  void operation_begin();
  void prefix(Span span);
  void infix(Span span);
  void dot(Span span);
  void neighbour();
  void star(Span span);
  void operation_end();

  // Values and pipes.
  void range_last();
  void range_step();
  void on_triangles(Span span);
  void where_begin(Span span);
  void where_end();
  void verb(Span span);
  void verb_step();
  void pipe();

  // Statements.
  void block_begin(Span span);
  void block_end(Span span);
  void sweep();
  void animate();
  void printed();
  void print();
  void assertion();
  void domain();
  void certificate();
  void claim(bool prove);
  void verify();
  void use();
  void setting();
  void define();
  void evaluate();
  void statement(Span whole);

  /// What was built; the builder is empty afterwards.
  Program program();
  ExprPtr expression();

 private:
  /// An open bracket, list of bindings or block: where its values begin, and its entries.
  struct Open {
    Span span;
    Span closed;
    std::size_t first_value = 0;
    bool sign_seen = false;
    std::vector<Entry> entries;
    bool in_seen = false;
  };
  struct Verb {
    std::string name;
    Span span;
    std::size_t first_value = 0;
  };

  void push(Expr expr, std::size_t depth = 1);
  void count();
  Draft take();      // the top value, sealed
  Draft take_raw();  // as it is
  Draft take_set();  // [a, b] is an interval, not a list
  void reduce();     // applies the top operator
  void reduce_to(int precedence, bool also_equal);
  std::vector<Argument> arguments(std::vector<Entry>& entries, std::size_t& depth);
  std::vector<Binding> bindings(std::vector<Entry>& entries, std::size_t& depth);
  Binding binding(Entry& entry, std::size_t& depth);
  void add_arguments(WordItem& item, std::vector<Entry>& entries, Span brackets, std::size_t& depth);
  ExprPtr value();  // the top value, sealed and on the heap
  std::string taken_text();
  std::string taken_name();

  std::string_view text_;
  std::size_t end_ = 0;    // of the last token
  std::size_t parts_ = 0;  // operands and comments so far
  int brackets_ = 0;
  std::vector<Draft> values_;
  std::vector<Operator> operators_;
  std::vector<Open> opens_;
  std::optional<Open> call_;  // a closed call, until its owner takes it
  std::vector<Verb> verbs_;
  std::vector<ExprPtr> printed_;
  std::vector<Domain> domains_;
  std::optional<std::string> certificate_;
  bool defined_ = false;  // the statement at hand was a definition
  std::vector<std::vector<Statement>> bodies_;
  std::vector<Statement> body_;  // of the block closed last
  decltype(Statement::node) node_;
  std::vector<Span> comments_;
};

}  // namespace udcp::grammar
