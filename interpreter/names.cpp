// Which names an expression mentions that nothing defines: for function bodies and claims, which are checked before anything
// runs.
#include <algorithm>
#include <set>

#include "interpreter/builtins.h"
#include "interpreter/expressions.h"
#include "interpreter/formula.h"

namespace udcp {

namespace {

using grammar::Expr;

class NameCheck {
 public:
  NameCheck(const CallContext& context, const std::vector<std::string>& extra)
      : context_(context), known_(extra.begin(), extra.end()) {}

  void check(const grammar::ExprPtr& e) const {
    if (e) std::visit([&](const auto& node) { see(node, *e); }, e->node);
  }

 private:
  void name(const std::string& n, grammar::Span span, bool is_call) const {
    static const std::set<std::string> variables = {"alpha", "N", "h", "pi", "oo", "_", "yes", "no", "true", "false"};
    if (known_.contains(n) || context_.scope->find(n) || (context_.function && context_.function->name == n)) return;
    if (is_call ? (find_builtin(n) || is_number_function(n) || n == "noise")
                : (variables.contains(n) || is_symbol(n) || find_builtin(n)))
      return;
    std::vector<std::string> more(known_.begin(), known_.end());
    for (const Builtin& b : builtins()) more.emplace_back(b.name);
    throw Located(unknown_name(n, *context_.scope, true, more), span);
  }
  void see(const grammar::Number&, const Expr&) const {}
  void see(const grammar::Text&, const Expr&) const {}
  void see(const grammar::Attribute&, const Expr&) const {}
  void see(const grammar::Name& n, const Expr& e) const { name(n.name, e.span, false); }
  void see(const grammar::Unary& u, const Expr&) const { check(u.operand); }
  void see(const grammar::Binary& b, const Expr&) const { all({b.left, b.right}); }
  void see(const grammar::Conditional& c, const Expr&) const { all({c.condition, c.then, c.otherwise}); }
  void see(const grammar::List& l, const Expr&) const { all(l.items); }
  void see(const grammar::Range& r, const Expr&) const { all({r.first, r.last, r.step}); }
  void see(const grammar::Interval& i, const Expr&) const { all({i.lower, i.upper}); }
  void see(const grammar::Index& x, const Expr&) const { all({x.object, x.index}); }
  void see(const grammar::Pipe& p, const Expr&) const { all({p.input, p.step}); }
  void see(const grammar::Step& s, const Expr&) const { arguments(s.arguments); }
  void see(const grammar::Call& c, const Expr& e) const {
    name(c.name, e.span, true);
    arguments(c.arguments);
  }
  void see(const grammar::Method& m, const Expr& e) const {
    check(m.object);
    name(m.name, e.span, true);
    arguments(m.arguments);
  }
  void see(const grammar::WordExpr& w, const Expr&) const { word(w); }

  void all(const std::vector<grammar::ExprPtr>& list) const {
    for (const auto& e : list) check(e);
  }
  void arguments(const std::vector<grammar::Argument>& list) const {
    for (const auto& a : list) check(a.value);
  }
  void bindings(const std::vector<grammar::Binding>& list) const {
    for (const auto& b : list) {
      if (b.name == "rings" || b.name == "ngon") continue;
      NameCheck inside = *this;
      if (!b.parameter.empty()) inside.known_.insert(b.parameter);
      inside.check(b.value);
    }
  }
  void word(const grammar::WordExpr& w) const {
    for (const grammar::WordItem& item : w.items) {
      check(item.sections);
      check(item.power);
      bindings(item.bindings);
      if (const auto* group = std::get_if<grammar::GroupItem>(&item.what)) word(*group->word);
      if (const auto* named = std::get_if<grammar::NamedItem>(&item.what)) {
        name(named->name, item.span, named->has_arguments);
        arguments(named->arguments);
      }
    }
    bindings(w.where);
  }

  const CallContext& context_;
  std::set<std::string> known_;
};

}  // namespace

void check_names(const Expr& expr, const CallContext& context, const std::vector<std::string>& extra) {
  NameCheck(context, extra).check(std::make_shared<const Expr>(expr));
}

}  // namespace udcp
