// Expansion of words. Every item remembers the place in the running text that it came from, so that an error about item 7 can
// point at it.
#include "interpreter/words.h"

#include <algorithm>

#include "grammar/print.h"
#include "interpreter/bindings.h"
#include "interpreter/formula.h"

namespace udcp {

namespace {

using grammar::Span;
using grammar::WordExpr;
using grammar::WordItem;

struct Spot {
  Item item;
  Span span;
};

/// A part of a word under construction.
struct Piece {
  std::vector<Spot> head, tail;
  Directional<KernelPtr> alpha0;
  Rings rings = Rings::off;
  bool triangles = false;  // some part is a word on triangles
  bool polygons = false;   // some part is not
};

[[noreturn]] void fail(Span span, ErrorKind kind, const char* code, const std::string& message, const std::string& help = {}) {
  throw Located(Error(kind, code, message, help), span);
}

void check_length(std::size_t items, Span span) {
  if (items > static_cast<std::size_t>(max_word_items))
    fail(span, ErrorKind::limit, "E_WORD_TOO_LONG",
         "this word expands to more than " + std::to_string(max_word_items) + " items");
}

bool uses_alpha(const KernelPtr& kernel) { return kernel && uses(*kernel).alpha; }
bool uses_alpha(const Directional<KernelPtr>& d) {
  return uses_alpha(d.plain) || uses_alpha(d.latitude) || uses_alpha(d.longitude);
}
bool uses_alpha(const Item& i) {
  return uses_alpha(i.f) || uses_alpha(i.omega) || uses_alpha(i.omega_face) || uses_alpha(i.delta);
}

bool same_slot(const Directional<KernelPtr>& a, const Directional<KernelPtr>& b, int otherwise) {
  return same_kernel(a.plain, b.plain, otherwise) && same_kernel(a.latitude, b.latitude, otherwise) &&
         same_kernel(a.longitude, b.longitude, otherwise);
}

class Builder {
 public:
  explicit Builder(CallContext& context) : context_(context) {}

  Piece build(const WordExpr& word) {
    Piece result;
    for (const WordItem& item : word.items) append(result, build_item(item), item.span);
    if (!word.where.empty()) bind(result, read_bindings(word.where, context_));
    if (word.on_triangles) {
      result.triangles = true;
      result.polygons = false;
    }
    return result;
  }

 private:
  Piece build_item(const WordItem& item) {
    Piece piece = std::visit([&](const auto& what) { return make(what, item); }, item.what);
    if (item.power) {
      const int n = whole_number(evaluate(*item.power, context_), "the number of repeats", 0, std::numeric_limits<int>::max());
      repeat(piece, n, item.span);
    }
    if (!item.star) return piece;
    if (!piece.tail.empty()) fail(item.span, ErrorKind::word, "E_STAR", "this word already repeats for ever", "leave one * away");
    piece.tail = std::move(piece.head);
    piece.head.clear();
    return piece;
  }

  Piece make(const WordItem::Atom& atom, const WordItem& item) {
    Spot spot{{}, item.span};
    spot.item.atom = static_cast<Atom>(atom.letter);
    if (item.sections) {
      if (spot.item.atom != Atom::up)
        fail(item.span, ErrorKind::word, "E_BINDING", "only U takes a number of sections, as in U[3]");
      spot.item.sections = whole_number(evaluate(*item.sections, context_), "the number of sections", 2, 1000);
    }
    own_bindings(spot.item, item);
    Piece piece;
    piece.head.push_back(std::move(spot));
    piece.polygons = true;
    return piece;
  }

  void own_bindings(Item& to, const WordItem& item) {
    const Bindings own = read_bindings(item.bindings, context_);
    const bool pushes = to.atom == Atom::push_back, smooths = to.atom == Atom::average || to.atom == Atom::convolve;
    for (const auto& [name, span] : own.written) {
      const bool fits = (pushes && (name == "omega" || name == "delta")) || (smooths && name == "f") ||
                        (to.atom == Atom::convolve && name == "ngon");
      if (!fits)
        fail(span, ErrorKind::word, "E_BINDING", std::string(1, static_cast<char>(to.atom)) + " takes no '" + name + "'",
             "U[3] takes a number of sections, D takes f, C takes f and ngon, P takes omega and delta");
    }
    std::set<std::string> used;
    fill(to, own, used);
    to.f_everywhere = is_bound(own.f);
    to.ngon = own.ngon;
  }

  Piece make(const WordItem::Group& group, const WordItem& item) {
    Piece piece = build(*group.word);
    if (!item.bindings.empty()) bind(piece, read_bindings(item.bindings, context_));
    return piece;
  }

  Piece make(const WordItem::Named& named, const WordItem& item) {
    const Value value = named_value(named, item.span);
    const auto* word = value.as<WordValue>();
    if (!word) {
      Error error = wrong_type("'" + named.name + "'", "a word", value);
      if (value.as<FunctionValue>()) error.help = "write " + signature(*value.as<FunctionValue>());
      throw Located(error, item.span);
    }
    Piece piece;
    const Word& w = word->rounds ? finite_ = finite(*word) : word->word;
    for (const Item& i : w.head) piece.head.push_back({i, item.span});
    for (const Item& i : w.tail) piece.tail.push_back({i, item.span});
    piece.alpha0 = w.alpha0;
    piece.rings = w.rings;
    piece.triangles = w.triangles;
    piece.polygons = !w.triangles;
    if (!item.bindings.empty()) bind(piece, read_bindings(item.bindings, context_));
    return piece;
  }

  Value named_value(const WordItem::Named& named, Span span) {
    if (!named.has_arguments) {
      if (const Value* found = context_.scope->find(named.name)) return *found;
      throw Located(unknown_name(named.name, *context_.scope, false), span);
    }
    return evaluate(grammar::Expr{grammar::Call{named.name, named.arguments}, span}, context_);
  }

  void repeat(Piece& piece, int n, Span span) {
    const std::vector<Spot> once = piece.tail.empty() ? std::exchange(piece.head, {}) : std::exchange(piece.tail, {});
    check_length(piece.head.size() + static_cast<std::size_t>(n) * once.size(), span);
    for (int i = 0; i < n; ++i) piece.head.insert(piece.head.end(), once.begin(), once.end());
  }

  void append(Piece& to, Piece piece, Span span) {
    if (!to.tail.empty())
      fail(span, ErrorKind::word, "E_STAR", "nothing can follow a part that repeats for ever",
           "give the part before it a number of rounds, as in (UCP)^4");
    check_length(to.head.size() + piece.head.size() + piece.tail.size(), span);
    to.head.insert(to.head.end(), piece.head.begin(), piece.head.end());
    to.tail = std::move(piece.tail);
    if (is_bound(to.alpha0) && is_bound(piece.alpha0) && !same_slot(to.alpha0, piece.alpha0, 0))
      fail(span, ErrorKind::word, "E_BINDING", "this part has another alpha0 than the part before it; a word has one alpha0");
    if (!is_bound(to.alpha0)) to.alpha0 = piece.alpha0;
    if (to.rings != Rings::off && piece.rings != Rings::off && to.rings != piece.rings)
      fail(span, ErrorKind::word, "E_BINDING", "this part has another value of rings than the part before it; a word has one");
    if (to.rings == Rings::off) to.rings = piece.rings;
    to.triangles = to.triangles || piece.triangles;
    to.polygons = to.polygons || piece.polygons;
  }

  void bind(Piece& piece, const Bindings& where) {
    std::set<std::string> used;
    bool smooths = false, pushes = false, alpha = false;
    for (std::vector<Spot>* part : {&piece.head, &piece.tail}) {
      for (Spot& spot : *part) {
        fill(spot.item, where, used);
        smooths = smooths || spot.item.atom == Atom::average || spot.item.atom == Atom::convolve;
        pushes = pushes || spot.item.atom == Atom::push_back;
        alpha = alpha || uses_alpha(spot.item);
      }
    }
    if (fill(piece.alpha0, where.alpha0) && (alpha || where.rings != Rings::off || piece.rings != Rings::off))
      used.insert("alpha0");
    if (where.has_rings && piece.rings == Rings::off) piece.rings = where.rings;
    for (const auto& [name, span] : where.written) {
      if (name == "ngon") fail(span, ErrorKind::word, "E_BINDING", "ngon belongs to one C", "write C[ngon = classic]");
      if (name == "rings" || used.contains(name)) continue;
      if (name == "alpha0")
        warn(context_, span,
             is_bound(piece.alpha0) && alpha ? "alpha0 has no effect: the word inside has its own"
                                             : "alpha0 has no effect: no formula uses alpha");
      else if (name == "f" ? smooths : pushes)
        warn(context_, span, name + " has no effect: every " + (name == "f" ? "C and D" : "P") + " of the word has its own");
      else
        warn(context_, span,
             name + (name == "f" ? " has no effect: the word has no C or D" : " has no effect: the word has no P"));
    }
  }

  CallContext& context_;
  Word finite_;
};

void finish_items(const std::vector<Spot>& from, std::vector<Item>& to) {
  for (const Spot& spot : from) {
    to.push_back(spot.item);
    spread(to.back().f);
    spread(to.back().omega);
  }
}

/// Letters as they stand, for the hint about the direction of reading.
std::string letters(const Piece& piece) {
  std::string text;
  for (const auto* part : {&piece.head, &piece.tail})
    for (const Spot& spot : *part) text += static_cast<char>(spot.item.atom);
  return text;
}

[[noreturn]] void explain(const Error& error, const Piece& piece, Span whole) {
  Error better = error;
  const std::string text = letters(piece);
  if (error.code == "E_P_NO_U" && text.find('U') != std::string::npos && text.size() < 30) {
    std::string product, word(text.rbegin(), text.rend());
    for (const char c : text) product += (product.empty() ? "" : " . ") + std::string(1, c);
    better.help = "words are read from left to right, U first; did you mean the operator product " + product +
                  ", which is the word " + word + "?";
  }
  const std::size_t heads = piece.head.size(), all = heads + piece.tail.size();
  if (error.item < 0 || all == 0) throw Located(better, whole);
  const std::size_t i = static_cast<std::size_t>(error.item);
  const std::size_t at = i < all || piece.tail.empty() ? i % all : heads + (i - heads) % piece.tail.size();
  throw Located(better, at < heads ? piece.head[at].span : piece.tail[at - heads].span);
}

bool same_item(const Item& a, const Item& b) {
  return a.atom == b.atom && a.sections == b.sections && a.f_everywhere == b.f_everywhere && a.ngon == b.ngon &&
         same_slot(a.f, b.f, 1) && same_slot(a.omega, b.omega, 1) && same_kernel(a.delta, b.delta, 1) &&
         (a.omega_face == b.omega_face || (a.omega_face && b.omega_face && same_kernel(a.omega_face, b.omega_face, 1)));
}

bool same_items(const std::vector<Item>& a, const std::vector<Item>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), same_item);
}

}  // namespace

WordValue make_word(const WordExpr& expr, Span span, CallContext& context) {
  const Piece piece = Builder(context).build(expr);
  if (piece.triangles && piece.polygons)
    fail(span, ErrorKind::word, "E_TRIANGLES_MIX", "a part of this word is on triangles and another part is not",
         "write 'on triangles' after the whole word");
  WordValue value;
  finish_items(piece.head, value.word.head);
  finish_items(piece.tail, value.word.tail);
  value.word.alpha0 = piece.alpha0;
  spread(value.word.alpha0);
  value.word.rings = piece.rings;
  value.word.triangles = piece.triangles;
  try {
    validate(value.word);
  } catch (const Error& error) {
    explain(error, piece, span);
  }
  value.source = grammar::to_string(expr);
  value.defaults = defaults_of(value.word);
  return value;
}

WordValue power(const WordValue& base, int n) {
  WordValue result = base;
  const std::string& s = base.source;
  const bool simple =
      s.find_first_of(" |") == std::string::npos && s.find('*') == std::string::npos && s.find('^') == std::string::npos;
  const bool one_letter_or_name = s.size() == 1 || s.find_first_of("UDCP") == std::string::npos;
  result.source = (simple && one_letter_or_name ? s : "(" + s + ")") + "^" + std::to_string(n);
  const std::size_t length = base.word.head.size() + base.word.tail.size() * static_cast<std::size_t>(base.rounds.value_or(1));
  if (length * static_cast<std::size_t>(n) > static_cast<std::size_t>(max_word_items))
    throw Error(ErrorKind::limit, "E_WORD_TOO_LONG",
                "this word expands to more than " + std::to_string(max_word_items) + " items");
  if (base.word.is_scheme() && !base.rounds) {
    result.rounds = n;
    return result;
  }
  const std::vector<Item> once = finite(base).head;
  result.word = finite(base);
  result.rounds.reset();
  result.word.head.clear();
  for (int i = 0; i < n; ++i) result.word.head.insert(result.word.head.end(), once.begin(), once.end());
  return result;
}

Word finite(const WordValue& value) {
  Word word = value.word;
  if (!value.rounds) return word;
  const std::vector<Item> once = std::exchange(word.tail, {});
  for (int i = 0; i < *value.rounds; ++i) word.head.insert(word.head.end(), once.begin(), once.end());
  return word;
}

bool same_word(const WordValue& a, const WordValue& b) {
  const Word x = finite(a), y = finite(b);
  return same_items(x.head, y.head) && same_items(x.tail, y.tail) && same_slot(x.alpha0, y.alpha0, 0) && x.rings == y.rings &&
         x.triangles == y.triangles;
}

std::vector<std::string> defaults_of(const Word& word) {
  bool f = false, omega = false, delta = false, alpha = word.rings != Rings::off;
  for (const auto* part : {&word.head, &word.tail}) {
    for (const Item& item : *part) {
      f = f || ((item.atom == Atom::average || item.atom == Atom::convolve) && !item.f.plain);
      omega = omega || (item.atom == Atom::push_back && !item.omega.plain);
      delta = delta || (item.atom == Atom::push_back && !item.delta);
      alpha = alpha || uses_alpha(item);
    }
  }
  std::vector<std::string> result;
  if (f) result.emplace_back("f = 1");
  if (omega) result.emplace_back("omega = 1");
  if (delta) result.emplace_back("delta = 1");
  if (alpha && !word.alpha0.plain) result.emplace_back("alpha0 = 0");
  return result;
}

}  // namespace udcp
