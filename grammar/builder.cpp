// Operands, brackets and rows. Statements stand in builder_statements.cpp.
#include "grammar/builder.h"

#include <algorithm>
#include <set>
#include <utility>

#include "grammar/parse.h"

namespace udcp::grammar {
namespace {

constexpr std::size_t most_parts = 250'000;

[[noreturn]] void syntax_error(const std::string& message, Span span, const std::string& label, const std::string& help) {
  throw SyntaxError("E_SYNTAX", message, span, help, label);
}

std::string unescape(std::string_view inner) {
  std::string result;
  for (std::size_t i = 0; i < inner.size(); ++i) {
    if (inner[i] != '\\') {
      result += inner[i];
      continue;
    }
    const char c = inner[++i];
    result += c == 'n' ? '\n' : c == 't' ? '\t' : c;
  }
  return result;
}

Operator infix_operator(const std::string& sign, Span span) { return {Operator::Kind::infix, sign, precedence_of(sign), span}; }

/// "1", "0", "1.5": literals that cannot be a number of sections.
void check_sections(const Expr& expr) {
  const Number* number = std::get_if<Number>(&expr.node);
  const bool whole = number && std::all_of(number->text.begin(), number->text.end(), [](char c) { return c >= '0' && c <= '9'; });
  const bool bad = number ? !whole || number->text == "0" || number->text == "1" : std::holds_alternative<Unary>(expr.node);
  if (bad) {
    syntax_error("U cuts an edge into at least 2 sections", expr.span, "a whole number from 2 on",
                 "write U or U[2] to halve edges, U[3] to cut them into three");
  }
}

}  // namespace

bool Builder::star_may_stand(const char* place) const {
  if (values_.empty()) return false;
  // An exponent that stands before the star belongs to the item that the star repeats.
  std::size_t value = values_.size() - 1;
  for (std::size_t i = operators_.size(); i-- > 0;) {
    const bool power = operators_[i].sign == "^";
    const bool sign_of_power = operators_[i].kind == Operator::Kind::prefix && i > 0 && operators_[i - 1].sign == "^";
    if (!power && !sign_of_power) break;
    if (power) --value;
  }
  const Draft& draft = values_[value];
  if (std::holds_alternative<WordExpr>(draft.expr.node)) return true;
  return text_.data() + end_ == place && as_word(draft.expr).has_value();
}

const Span* Builder::open_bracket() const {
  for (std::size_t i = opens_.size(); i-- > 0;) {
    if (opens_[i].span.end - opens_[i].span.begin == 1) return &opens_[i].span;
  }
  return nullptr;
}

void Builder::count() {
  if (++parts_ <= most_parts) return;
  throw SyntaxError("E_LIMIT", "a program may have at most 250000 names, numbers, atoms and comments", {end_, end_},
                    "read large data from a file with load", "one too many");
}

void Builder::push(Expr expr, std::size_t depth) {
  count();
  end_ = expr.span.end;
  Draft draft;
  draft.expr = std::move(expr);
  draft.depth = depth;
  values_.push_back(std::move(draft));
}

void Builder::comment(Span span) {
  if (!comments_.empty() && comments_.back().begin >= span.begin) return;  // seen already when the gap was tried before
  count();
  comments_.push_back(span);
}

void Builder::number(Span span) { push({Number{std::string(text_.substr(span.begin, span.end - span.begin))}, span}); }
void Builder::string(Span span) { push({Text{unescape(text_.substr(span.begin + 1, span.end - span.begin - 2))}, span}); }
void Builder::name(Span span) { push({Name{std::string(text_.substr(span.begin, span.end - span.begin))}, span}); }

void Builder::greek_name(Span span) {
  const std::string_view letter = text_.substr(span.begin, 2);
  std::string name = letter == "ω" ? "omega" : letter == "δ" ? "delta" : letter == "π" ? "pi" : "alpha";
  if (span.end - span.begin > 2) name += '0';
  push({Name{name}, span});
}

void Builder::atom(Span span) {
  WordItem item;
  item.what = AtomItem{text_[span.begin]};
  item.span = span;
  WordExpr word;
  word.items.push_back(std::move(item));
  push({std::move(word), span});
}

void Builder::direction(Span span) {
  values_.back().direction = std::string(text_.substr(span.begin + 1, span.end - span.begin - 1));
  values_.back().expr.span.end = end_ = span.end;
}

Draft Builder::take_raw() {
  Draft draft = std::move(values_.back());
  values_.pop_back();
  return draft;
}

Draft Builder::take() {
  Draft draft = take_raw();
  seal(draft, text_);
  return draft;
}

// ---- brackets

void Builder::open(Span span) {
  ++brackets_;
  opens_.push_back({span, {}, values_.size(), false, {}});
}

void Builder::close(Span span) {
  --brackets_;
  opens_.back().closed = span;
  end_ = span.end;
}

void Builder::entry_sign() { opens_.back().sign_seen = true; }
void Builder::entry_in() { opens_.back().sign_seen = opens_.back().in_seen = true; }

void Builder::entry() {
  Open& open = opens_.back();
  Entry entry;
  entry.in = open.in_seen;
  if (open.in_seen)
    entry.right = take_set();
  else if (open.sign_seen)
    entry.right = take();
  entry.left = take_raw();
  if (!open.sign_seen) seal(entry.left, text_);
  open.sign_seen = open.in_seen = false;
  open.entries.push_back(std::move(entry));
}

void Builder::call_done() {
  call_ = std::move(opens_.back());
  opens_.pop_back();
}

void Builder::bracket() {
  const Open open = std::move(opens_.back());
  opens_.pop_back();
  const Span span{open.span.begin, open.closed.end};
  const bool round_begin = text_[open.span.begin] == '(', round_end = text_[open.closed.begin] == ')';
  const std::size_t size = values_.size() - open.first_value;
  std::vector<Draft> items(size);
  for (std::size_t i = size; i-- > 0;) items[i] = take();
  if (size == 1 && round_begin && round_end) {
    items[0].bracketed = true;
    items[0].expr.span = span;
    values_.push_back(std::move(items[0]));
    return;
  }
  std::size_t depth = 1;
  for (const Draft& item : items) depth = std::max(depth, item.depth + 1);
  if (!round_begin && !round_end) {
    List list;
    for (Draft& item : items) list.items.push_back(node(std::move(item)));
    return push({std::move(list), span}, depth);
  }
  if (size == 2)
    return push({Interval{node(std::move(items[0])), node(std::move(items[1])), round_begin, round_end}, span}, depth);
  if (round_begin != round_end) {
    syntax_error(std::string("this ") + text_[open.closed.begin] + " does not close the " + text_[open.span.begin] + " it meets",
                 open.closed, "the other kind of bracket", std::string("write ") + (round_begin ? ")" : "]"));
  }
  if (size == 0)
    syntax_error("these brackets are empty", span, "a value or a word is expected inside", "write a value between ( and )");
  syntax_error("a list stands in square brackets", span, "round brackets", "write [a, b, c]");
}

std::vector<Argument> Builder::arguments(std::vector<Entry>& entries, std::size_t& depth) {
  std::vector<Argument> result;
  std::set<std::string> seen;
  for (Entry& entry : entries) {
    Argument argument;
    argument.span = entry.left.expr.span;
    if (entry.right) {
      const Name* name = std::get_if<Name>(&entry.left.expr.node);
      if (!name || entry.left.bracketed || !entry.left.direction.empty()) {
        syntax_error(std::string("the left side of ") + (entry.in ? "in" : "=") + " must be the name of an argument",
                     entry.left.expr.span, "not a name", "write name = value; == compares two values");
      }
      argument.name = name->name;
      if (!seen.insert(argument.name).second) {
        syntax_error("the argument " + argument.name + " is given twice", entry.left.expr.span, "a second time",
                     "leave one of them out");
      }
      argument.span.end = entry.right->expr.span.end;
    }
    Draft& draft = entry.right ? *entry.right : entry.left;
    depth = std::max(depth, draft.depth + 1);
    argument.value = node(std::move(draft));
    argument.in = entry.in;
    result.push_back(std::move(argument));
  }
  return result;
}

Binding Builder::binding(Entry& entry, std::size_t& depth) {
  Binding binding;
  const Span left = entry.left.expr.span;
  if (entry.in) syntax_error("a binding has one value", left, "in", "write name = value");
  binding.direction = entry.left.direction;
  binding.span = {left.begin, entry.right->expr.span.end};
  const Call* call = std::get_if<Call>(&entry.left.expr.node);
  const Name* name = std::get_if<Name>(&entry.left.expr.node);
  if (call && call->arguments.size() == 1 && call->arguments[0].name.empty()) {
    const Name* parameter = std::get_if<Name>(&call->arguments[0].value->node);
    if (parameter) binding.parameter = parameter->name;
  }
  if (entry.left.bracketed || (!name && binding.parameter.empty())) {
    syntax_error("a binding is a name, or a name with one variable in brackets, and = and a value", left,
                 "not the left side of a binding", "write f = 1, f(alpha) = cos(alpha/2) or f@lat = 1");
  }
  binding.name = name ? name->name : call->name;
  depth = std::max(depth, entry.right->depth + 1);
  binding.value = node(std::move(*entry.right));
  return binding;
}

std::vector<Binding> Builder::bindings(std::vector<Entry>& entries, std::size_t& depth) {
  std::vector<Binding> result;
  std::set<std::string> seen;
  for (Entry& entry : entries) {
    result.push_back(binding(entry, depth));
    const std::string name = result.back().name + (result.back().direction.empty() ? "" : "@" + result.back().direction);
    if (!seen.insert(name).second)
      syntax_error(name + " is bound twice", result.back().span, "a second time", "leave one of them out");
  }
  return result;
}

void Builder::called() {
  Open open = std::move(*call_);
  call_.reset();
  Draft name = take_raw();
  std::size_t depth = 1;
  Call call{std::get<Name>(name.expr.node).name, arguments(open.entries, depth)};
  push({std::move(call), {name.expr.span.begin, open.closed.end}}, depth);
  values_.back().direction = name.direction;
}

void Builder::item_arguments() {
  Open open = std::move(opens_.back());
  opens_.pop_back();
  const Span brackets{open.span.begin, open.closed.end};
  Draft draft = take_raw();
  const Span span{draft.expr.span.begin, brackets.end};
  std::size_t depth = draft.depth + 1;
  const auto assigned =
      std::count_if(open.entries.begin(), open.entries.end(), [](const Entry& e) { return e.right.has_value(); });
  if (assigned == 0 && open.entries.size() == 1 && !std::holds_alternative<WordExpr>(draft.expr.node)) {
    seal(draft, text_);
    depth = std::max(depth, open.entries[0].left.depth + 1);
    return push({Index{node(std::move(draft)), node(std::move(open.entries[0].left))}, span}, depth);
  }
  if (assigned != static_cast<std::ptrdiff_t>(open.entries.size()) && assigned > 0) {
    syntax_error("arguments of an item are bindings, each with =", brackets,
                 "some have no =", "write C[f = 1/2] or P[delta = 1/2, omega = 1]");
  }
  WordExpr word = items_of(std::move(draft), text_);
  add_arguments(word.items.back(), open.entries, brackets, depth);
  word.items.back().span = span;
  push({std::move(word), span}, depth);
}

void Builder::add_arguments(WordItem& item, std::vector<Entry>& entries, Span brackets, std::size_t& depth) {
  const AtomItem* atom = std::get_if<AtomItem>(&item.what);
  const bool up = atom && atom->letter == 'U';
  if (item.star || item.sections || !item.bindings.empty()) {
    syntax_error("arguments stand once, right after the item they belong to", brackets, "too late",
                 "write one [ ] with all bindings, before * or ^");
  }
  if (entries.empty())
    syntax_error("these brackets are empty", brackets, "arguments are expected inside",
                 "write U[3] or C[f = 1/2], or no brackets");
  if (up != !entries[0].right.has_value() || (up && entries.size() > 1)) {
    up ? syntax_error("U takes one number, its sections", brackets, "not a number of sections",
                      "write U[3]; bindings belong to C, D and P")
       : syntax_error("only U takes a number of sections", brackets, "a binding with = is expected",
                      "write U[3], or a binding such as C[f = 1/2]");
  }
  if (!up) {
    item.bindings = bindings(entries, depth);
    return;
  }
  check_sections(entries[0].left.expr);
  depth = std::max(depth, entries[0].left.depth + 1);
  item.sections = node(std::move(entries[0].left));
}

void Builder::member() {
  std::optional<Open> open = std::move(call_);
  call_.reset();
  const Draft name = take_raw();
  Draft object = take_raw();
  const std::string& member = std::get<Name>(name.expr.node).name;
  const Span span{object.expr.span.begin, end_};
  const Name* base = std::get_if<Name>(&object.expr.node);
  if (!open) {
    if (!base || base->name != "v" || object.bracketed) {
      syntax_error("only the vertex v has attributes", name.expr.span, "an attribute is v." + member,
                   "write v." + member + ", a method call with brackets such as x." + member +
                       "(), or P . C . U with blanks for a product");
    }
    return push({Attribute{member}, span});
  }
  if (std::holds_alternative<WordExpr>(object.expr.node) && !object.bracketed) {
    syntax_error("a method of a word needs the whole word in brackets", object.expr.span, "only this would be meant",
                 "write (UCP)." + member + "()");
  }
  seal(object, text_);
  std::size_t depth = object.depth + 1;
  std::vector<Argument> given = arguments(open->entries, depth);
  push({Method{node(std::move(object)), member, std::move(given)}, span}, depth);
}

void Builder::conditional(Span whole) {
  Draft otherwise = take(), then = take(), condition = take();
  const Span span{whole.begin, otherwise.expr.span.end};
  const std::size_t depth = std::max({condition.depth, then.depth, otherwise.depth}) + 1;
  push({Conditional{node(std::move(condition)), node(std::move(then)), node(std::move(otherwise))}, span}, depth);
}

// ---- rows of operands and operators

void Builder::operation_begin() { operators_.emplace_back(); }

void Builder::prefix(Span span) {
  const bool minus = text_[span.begin] == '-';
  // The sign of an exponent binds like the power itself: C^-1 P is two items.
  const int sign = operators_.back().precedence == precedence::power ? precedence::power : precedence::sign;
  operators_.push_back({Operator::Kind::prefix, minus ? "-" : "not", minus ? sign : precedence::negation, span});
}

void Builder::reduce() {
  const Operator op = operators_.back();
  operators_.pop_back();
  Draft right = take_raw();
  Draft left = op.kind == Operator::Kind::prefix ? Draft{} : take_raw();
  values_.push_back(apply(op, std::move(left), std::move(right), text_));
}

void Builder::reduce_to(int precedence, bool also_equal) {
  while (operators_.back().precedence > precedence || (also_equal && operators_.back().precedence == precedence)) reduce();
}

void Builder::infix(Span span) {
  Operator op = infix_operator(std::string(text_.substr(span.begin, span.end - span.begin)), span);
  if (op.precedence == precedence::comparison) {
    reduce_to(op.precedence, false);
    if (operators_.back().precedence == op.precedence) {
      syntax_error("comparisons do not chain", span, "a second comparison", "write a < b and b < c");
    }
  }
  reduce_to(op.precedence, op.sign != "^");
  operators_.push_back(std::move(op));
}

void Builder::dot(Span span) {
  reduce_to(precedence::items, true);
  operators_.push_back({Operator::Kind::dot, ".", precedence::items, span});
}

void Builder::neighbour() {
  reduce_to(precedence::items, true);
  operators_.push_back({Operator::Kind::neighbour, "", precedence::items, {end_, end_}});
}

void Builder::star(Span span) {
  const auto in_exponent = [&] {
    const std::size_t size = operators_.size();
    return operators_[size - 1].sign == "^" ||
           (operators_[size - 1].kind == Operator::Kind::prefix && operators_[size - 2].sign == "^");
  };
  while (in_exponent()) reduce();
  values_.push_back(repeat(take_raw(), span, text_));
  end_ = span.end;
}

void Builder::operation_end() {
  while (operators_.back().kind != Operator::Kind::barrier) reduce();
  operators_.pop_back();
}

}  // namespace udcp::grammar
