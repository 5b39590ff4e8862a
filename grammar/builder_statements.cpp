// Values around an operation (ranges, where, pipes) and statements. Rows and brackets stand in builder.cpp.
#include <algorithm>
#include <set>
#include <utility>

#include "grammar/builder.h"
#include "grammar/comments.h"
#include "grammar/parse.h"

namespace udcp::grammar {
namespace {

[[noreturn]] void syntax_error(const std::string& message, Span span, const std::string& label, const std::string& help) {
  throw SyntaxError("E_SYNTAX", message, span, help, label);
}

/// In a domain [a, b] is an interval; a list of any other length is a set of values.
void list_to_interval(Draft& draft) {
  const List* list = std::get_if<List>(&draft.expr.node);
  if (list && list->items.size() == 2) draft.expr.node = Interval{list->items[0], list->items[1], false, false};
}

}  // namespace

ExprPtr Builder::value() { return node(take()); }
std::string Builder::taken_text() { return std::get<Text>(take_raw().expr.node).raw; }
std::string Builder::taken_name() { return std::get<Name>(take_raw().expr.node).name; }

// ---- values

void Builder::range_last() {
  Draft last = take(), first = take();
  const Span span{first.expr.span.begin, last.expr.span.end};
  const std::size_t depth = std::max(first.depth, last.depth) + 1;
  push({Range{node(std::move(first)), node(std::move(last)), nullptr}, span}, depth);
}

void Builder::range_step() {
  Draft step = take();
  Draft& range = values_.back();
  range.depth = std::max(range.depth, step.depth + 1);
  range.expr.span.end = step.expr.span.end;
  std::get<Range>(range.expr.node).step = node(std::move(step));
}

void Builder::on_triangles(Span span) {
  Draft draft = take();
  const std::size_t begin = draft.expr.span.begin, depth = draft.depth + 1;
  WordExpr word = completed_word(std::move(draft), text_);
  word.on_triangles = true;
  push({std::move(word), {begin, span.end}}, depth);
}

void Builder::where_begin(Span span) { opens_.push_back({{span.begin, span.begin + 5}, {}, values_.size(), false, {}}); }

void Builder::where_end() {
  Open open = std::move(opens_.back());
  opens_.pop_back();
  if (text_[open.span.begin] == '{') opens_.pop_back();
  Draft draft = take();
  const Span span{draft.expr.span.begin, end_};
  std::size_t depth = draft.depth + 1;
  WordExpr word = completed_word(std::move(draft), text_);
  word.where = bindings(open.entries, depth);
  push({std::move(word), span}, depth);
}

void Builder::verb(Span span) {
  verbs_.push_back({std::string(text_.substr(span.begin, span.end - span.begin)), span, values_.size()});
  end_ = span.end;
}

void Builder::verb_step() {
  const Verb verb = std::move(verbs_.back());
  verbs_.pop_back();
  std::size_t depth = 1;
  Step step{verb.name, {}};
  if (call_) {
    step.arguments = arguments(call_->entries, depth);
    call_.reset();
  } else if (values_.size() > verb.first_value) {
    const Span span = values_.back().expr.span;
    step.arguments.push_back({"", value(), span});
  }
  if (step.arguments.empty() && verb.name != "print") {
    syntax_error(verb.name + " needs the name of a file", verb.span, "a text is expected after it",
                 "write " + verb.name + (verb.name == "save" ? " \"cube.obj\"" : " \"circle.svg\""));
  }
  push({std::move(step), {verb.span.begin, end_}}, depth);
}

void Builder::pipe() {
  Draft step = take(), input = take();
  const Span span{input.expr.span.begin, step.expr.span.end};
  const std::size_t depth = std::max(step.depth, input.depth) + 1;
  push({Pipe{node(std::move(input)), node(std::move(step))}, span}, depth);
}

// ---- statements

void Builder::block_begin(Span span) {
  opens_.push_back({span, {}, values_.size(), false, {}});
  bodies_.emplace_back();
}

void Builder::block_end(Span span) {
  opens_.pop_back();
  body_ = std::move(bodies_.back());
  bodies_.pop_back();
  end_ = span.end;
}

void Builder::sweep() {
  ExprPtr range = value();
  node_ = Sweep{taken_name(), std::move(range), std::move(body_), {}};
}

void Builder::animate() {
  ExprPtr frames = value();
  ExprPtr range = value();
  node_ = Animate{taken_name(), std::move(range), std::move(frames), std::move(body_), {}};
}

void Builder::printed() { printed_.push_back(value()); }
void Builder::print() { node_ = Print{std::exchange(printed_, {})}; }
void Builder::assertion() { node_ = Assert{value()}; }

Draft Builder::take_set() {
  Draft set = take_raw();
  list_to_interval(set);
  if (!std::holds_alternative<Interval>(set.expr.node) || set.bracketed) seal(set, text_);
  return set;
}

void Builder::domain() {
  Draft set = take_set();
  const Span name = values_.back().expr.span;
  const Span span{name.begin, set.expr.span.end};
  ExprPtr values = node(std::move(set));
  domains_.push_back({taken_name(), std::move(values), span});
}

void Builder::certificate() { certificate_ = taken_text(); }

void Builder::claim(bool prove) {
  node_ = Claim{prove, value(), std::exchange(domains_, {}), std::exchange(certificate_, std::nullopt)};
}

void Builder::verify() { node_ = Verify{taken_text()}; }
void Builder::use() { node_ = Use{taken_text()}; }

void Builder::setting() {
  ExprPtr setting = value();
  node_ = Set{taken_name(), std::move(setting)};
}

void Builder::define() {
  Define define;
  define.value = value();
  const Draft left = take_raw();
  const Call* call = std::get_if<Call>(&left.expr.node);
  const Name* name = std::get_if<Name>(&left.expr.node);
  if (left.bracketed || !left.direction.empty() || (!call && !name)) {
    const bool word = std::holds_alternative<WordExpr>(left.expr.node);
    syntax_error("the left side of = must be a name, or a name with parameters in brackets", left.expr.span,
                 word ? "a word, not a name" : "not a name", "write name = value or name(p, q) = value; == compares two values");
  }
  define.name = name ? name->name : call->name;
  define.is_function = call != nullptr;
  std::set<std::string> seen;
  for (const Argument& argument : call ? call->arguments : std::vector<Argument>{}) {
    const Name* parameter = std::get_if<Name>(&argument.value->node);
    if (!parameter || !argument.name.empty()) {
      syntax_error("a parameter of a function is a name", argument.span, "not a name", "write name(p, q) = value");
    }
    if (!seen.insert(parameter->name).second) {
      syntax_error("the parameter " + parameter->name + " stands twice", argument.span, "a second time",
                   "give every parameter its own name");
    }
    define.parameters.push_back(parameter->name);
  }
  node_ = std::move(define);
  defined_ = true;
}

void Builder::evaluate() {
  if (!std::exchange(defined_, false)) node_ = Evaluate{value()};
}

void Builder::statement(Span whole) {
  Statement statement;
  statement.node = std::exchange(node_, Evaluate{});
  statement.span = {whole.begin, end_};
  bodies_.back().push_back(std::move(statement));
}

Program Builder::program() {
  Program program;
  program.statements = std::move(bodies_.back());
  place_comments(program, text_, comments_);
  return program;
}

ExprPtr Builder::expression() { return value(); }

}  // namespace udcp::grammar
