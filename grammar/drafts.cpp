// How drafts combine. Word or value is decided by the operands: atoms and groups of atoms are words, names and calls may be both.
#include "grammar/drafts.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "grammar/parse.h"

namespace udcp::grammar {
namespace {

[[noreturn]] void star_error(const std::string& message, Span span, const std::string& label, const std::string& help) {
  throw SyntaxError("E_STAR", message, span, help, label);
}

[[noreturn]] void star_not_last(Span star) {
  star_error("* may stand only on the last item of a word", star, "what follows would never be reached",
             "write the repeated group last, as in UC (UCP)*; (UCP)^3 repeats three times");
}

[[noreturn]] void star_inside(Span span) {
  star_error("a word that is repeated for ever cannot be an item of another word", span, "* inside brackets",
             "leave out the brackets and write the repeated group last, as in UC (UCP)*");
}

Span star_of(const WordItem& item) { return {item.span.end - 1, item.span.end}; }

bool has_star(const WordExpr& word) {
  return std::any_of(word.items.begin(), word.items.end(), [](const WordItem& item) { return item.star; });
}

const WordExpr* word_of(const Draft& draft) { return std::get_if<WordExpr>(&draft.expr.node); }

[[noreturn]] void not_a_word(const Draft& draft, std::string_view text) {
  const std::string what = quote(text, draft.expr.span);
  std::string help = "a word is made of U, D, C, P, groups ( ) and names of words; between values write an operator such as *";
  if (std::holds_alternative<Text>(draft.expr.node))
    help = "put the text into brackets behind the name of a function: load(\"cage.obj\")";
  if (std::holds_alternative<Method>(draft.expr.node)) help = "put brackets around the word before the point: (UCP).name()";
  if (what == "N") help = "N is the valence in expressions; the atoms are U, D, C and P";
  throw SyntaxError("E_SYNTAX", what + " is no part of a word", draft.expr.span, help,
                    "neither an atom nor a group nor the name of a word");
}

WordItem group(WordExpr word, Span span) {
  WordItem item;
  item.what = GroupItem{std::make_shared<const WordExpr>(std::move(word))};
  item.span = span;
  return item;
}

/// A bracketed operand as one item.
WordItem group_item(const Draft& draft, std::string_view text) {
  std::optional<WordExpr> word = as_word(draft.expr);
  if (!word) not_a_word(draft, text);
  if (has_star(*word)) star_inside(draft.expr.span);
  return group(std::move(*word), draft.expr.span);
}

Draft word_draft(WordExpr word, Span span, std::size_t depth) {
  Draft result;
  result.expr = {std::move(word), span};
  result.depth = depth;
  return result;
}

[[noreturn]] void mixed_product(Span span) {
  throw SyntaxError("E_SYNTAX", "in a product such as P . C . U every factor is one item", span,
                    "put brackets around a factor of several items: P . (CC) . U", "more than one item");
}

/// UC and U C: items side by side.
Draft juxtapose(Draft left, Draft right, std::string_view text) {
  if (left.product) mixed_product(right.expr.span);
  const Span span{left.expr.span.begin, right.expr.span.end};
  const std::size_t depth = std::max(left.depth + (left.bracketed ? 1 : 0), right.depth + 1);
  WordExpr word = items_of(std::move(left), text);
  if (word.items.back().star) star_not_last(star_of(word.items.back()));
  WordExpr tail = items_of(std::move(right), text);
  std::move(tail.items.begin(), tail.items.end(), std::back_inserter(word.items));
  return word_draft(std::move(word), span, depth);
}

/// P . C: kept in written order until the product is complete.
Draft product(Draft left, Draft right, std::string_view text) {
  const Span span{left.expr.span.begin, right.expr.span.end};
  const std::size_t depth = std::max(left.depth + (left.bracketed ? 1 : 0), right.depth + 1);
  const Span left_span = left.expr.span;
  const bool continued = left.product;
  WordExpr word = items_of(std::move(left), text);
  if (!continued && word.items.size() > 1) mixed_product(left_span);
  WordExpr factor = items_of(std::move(right), text);
  word.items.push_back(std::move(factor.items.front()));
  word.written_right_to_left = true;
  Draft result = word_draft(std::move(word), span, depth);
  result.product = true;
  return result;
}

Draft binary(const Operator& op, Draft left, Draft right, std::string_view text) {
  seal(left, text);
  seal(right, text);
  if (op.sign == "*" && (word_of(left) || word_of(right))) star_not_last(op.span);
  Draft result;
  const Span span{left.expr.span.begin, right.expr.span.end};
  result.depth = std::max(left.depth, right.depth) + 1;
  result.expr = {Binary{op.sign, node(std::move(left)), node(std::move(right))}, span};
  return result;
}

/// C^2, (UD)^3: a power of an item. Powers of names, of calls and of schemes stay an operation on values.
Draft power(const Operator& op, Draft left, Draft right, std::string_view text) {
  if (word_of(right)) {
    throw SyntaxError("E_SYNTAX", "the exponent of a word is a number, not a word", right.expr.span,
                      "leave a blank and write the next item after a number: U^2 C", "a word");
  }
  const WordExpr* word = word_of(left);
  if (!word || has_star(*word)) return binary(op, std::move(left), std::move(right), text);
  seal(right, text);
  const Span span{left.expr.span.begin, right.expr.span.end};
  const std::size_t depth = std::max(left.depth, right.depth) + 1;
  WordExpr result = items_of(std::move(left), text);
  result.items.back().power = node(std::move(right));
  result.items.back().span = span;
  return word_draft(std::move(result), span, depth);
}

void check_stars(const WordExpr& word, Span span, std::string_view text) {
  for (std::size_t i = 0; i < word.items.size(); ++i) {
    const WordItem& item = word.items[i];
    if (!item.star) continue;
    if (i + 1 < word.items.size()) star_not_last(star_of(item));
    const bool atom = std::holds_alternative<AtomItem>(item.what);
    if (!atom && !item.power) continue;
    const Span before{span.begin, item.span.end - 1};
    const std::string fix = "(" + quote(text, before) + ")*";
    star_error(atom ? "* repeats a group, not the single atom before it" : "* repeats a group, not an item that has a power",
               star_of(item), "did you mean " + fix + "?", "write " + fix);
  }
}

}  // namespace

std::optional<WordExpr> as_word(const Expr& expr) {
  if (const WordExpr* word = std::get_if<WordExpr>(&expr.node)) return *word;
  WordExpr result;
  WordItem item;
  item.span = expr.span;
  if (const Name* name = std::get_if<Name>(&expr.node)) {
    if (name->name == "N") return std::nullopt;
    item.what = NamedItem{name->name, false, {}};
  } else if (const Call* call = std::get_if<Call>(&expr.node)) {
    item.what = NamedItem{call->name, true, call->arguments};
  } else {
    const Binary* binary = std::get_if<Binary>(&expr.node);
    if (!binary || binary->op != "^") return std::nullopt;
    std::optional<WordExpr> base = as_word(*binary->left);
    if (!base || has_star(*base)) return std::nullopt;
    // Two carets in a row mean (w^2)^3: the inner power was in brackets.
    item = base->items.size() == 1 && !base->items[0].power ? std::move(base->items[0])
                                                            : group(std::move(*base), binary->left->span);
    item.power = binary->right;
    item.span = expr.span;
  }
  result.items.push_back(std::move(item));
  return result;
}

WordExpr items_of(Draft&& draft, std::string_view text) {
  if (!draft.direction.empty()) seal(draft, text);
  if (draft.bracketed) {
    WordExpr result;
    result.items.push_back(group_item(draft, text));
    return result;
  }
  if (WordExpr* word = std::get_if<WordExpr>(&draft.expr.node)) return std::move(*word);
  std::optional<WordExpr> word = as_word(draft.expr);
  if (!word) not_a_word(draft, text);
  return std::move(*word);
}

WordExpr completed_word(Draft&& draft, std::string_view text) {
  const WordExpr* word = word_of(draft);
  if (word && (!draft.bracketed || (!word->on_triangles && word->where.empty())))
    return std::get<WordExpr>(std::move(draft.expr.node));
  if (word) return items_of(std::move(draft), text);
  std::optional<WordExpr> named = as_word(draft.expr);
  if (!named) not_a_word(draft, text);
  return std::move(*named);
}

void seal(Draft& draft, std::string_view text) {
  if (!draft.direction.empty()) {
    throw SyntaxError("E_SYNTAX", "@" + draft.direction + " belongs to a binding after where", draft.expr.span,
                      "write it as in (UCP)* where f@lat(alpha) = cos(alpha/2)", "not the left side of a binding");
  }
  if (std::holds_alternative<Interval>(draft.expr.node)) {
    throw SyntaxError("E_SYNTAX", "an interval can stand only in the domain of a claim", draft.expr.span,
                      "write [a, b] for a list, or f(a, b) without a blank for a call", "an interval after for x in, or a call");
  }
  WordExpr* word = std::get_if<WordExpr>(&draft.expr.node);
  if (!word || draft.bracketed) return;
  if (draft.product) std::reverse(word->items.begin(), word->items.end());
  draft.product = false;
  check_stars(*word, draft.expr.span, text);
}

ExprPtr node(Draft&& draft) {
  if (draft.depth > max_tree_depth) {
    throw SyntaxError("E_DEPTH", "this expression chains or nests more than " + std::to_string(max_tree_depth) + " operations",
                      draft.expr.span, "split it into several definitions", "too long");
  }
  return std::make_shared<const Expr>(std::move(draft.expr));
}

Draft apply(const Operator& op, Draft left, Draft right, std::string_view text) {
  if (op.kind == Operator::Kind::neighbour) return juxtapose(std::move(left), std::move(right), text);
  if (op.kind == Operator::Kind::dot) return product(std::move(left), std::move(right), text);
  if (op.sign == "^" && op.kind == Operator::Kind::infix) return power(op, std::move(left), std::move(right), text);
  if (op.kind == Operator::Kind::infix) return binary(op, std::move(left), std::move(right), text);
  seal(right, text);
  Draft result;
  const Span span{op.span.begin, right.expr.span.end};
  result.depth = right.depth + 1;
  result.expr = {Unary{op.sign, node(std::move(right))}, span};
  return result;
}

Draft repeat(Draft operand, Span star, std::string_view text) {
  const Span span{operand.expr.span.begin, star.end};
  const std::size_t depth = operand.depth + 1;
  WordExpr word = items_of(std::move(operand), text);
  WordItem& item = word.items.back();
  if (item.star) star_error("this word is repeated for ever already", star, "a second *", "write one * only, as in (UCP)*");
  item.star = true;
  item.span = span;
  return word_draft(std::move(word), span, depth);
}

std::string quote(std::string_view text, Span span) {
  constexpr std::size_t longest = 60;
  const std::string_view whole = text.substr(span.begin, span.end - span.begin);
  const std::string_view line = whole.substr(0, whole.find('\n'));
  std::size_t size = 0;
  while (size < line.size() && size < longest) size += character_length(line, size);
  return std::string(line.substr(0, size)) + (size < whole.size() ? "…" : "");
}

}  // namespace udcp::grammar
