// prove, check and verify: domains become parameters in the scope of the claim, the claim's own function decides, and the outcome
// becomes a report with a certificate.
#include "interpreter/claims.h"

#include <algorithm>
#include <cctype>
#include <set>

#include "files/geometry_file.h"
#include "grammar/print.h"
#include "interpreter/formula.h"
#include "interpreter/report.h"

namespace udcp {
namespace {

using grammar::Expr;

Error bad_domain(const std::string& message, const std::string& help) { return {ErrorKind::word, "E_DOMAIN", message, help}; }

/// The exact end of a domain; nothing for oo and -oo.
std::optional<Rational> end_of(const grammar::ExprPtr& e, CallContext& context, bool lower) {
  const auto is_infinity = [](const Expr& x) {
    const auto* name = std::get_if<grammar::Name>(&x.node);
    return name && name->name == "oo";
  };
  const auto* minus = std::get_if<grammar::Unary>(&e->node);
  if (minus && minus->op == "-" && is_infinity(*minus->operand) && lower) return std::nullopt;
  if (is_infinity(*e) && !lower) return std::nullopt;
  const Value value = evaluate(*e, context);
  if (const auto* number = value.as<NumberValue>()) {
    try {
      return number_as<Rational>(*number);
    } catch (const Error& error) {
      if (error.kind != ErrorKind::not_exact) throw;
    }
  }
  throw Located(bad_domain("the end of a domain must be a rational number, or oo", "such as (0, oo), [1/1000, 19/100]"), e->span);
}

}  // namespace

ParameterRange range_of(const std::string& name, const Expr& set, CallContext& context) {
  ParameterRange range;
  range.name = name;
  if (const auto* interval = std::get_if<grammar::Interval>(&set.node)) {
    range = {name, end_of(interval->lower, context, true), end_of(interval->upper, context, false), interval->lower_open,
             interval->upper_open};
  } else if (const auto* closed = std::get_if<grammar::Range>(&set.node); closed && !closed->step) {
    range = {name, end_of(closed->first, context, true), end_of(closed->last, context, false), false, false};
  } else {
    throw Located(bad_domain("'" + name + "' needs an interval", "such as (0, 1], [0, oo) or 0 .. 1/4"), set.span);
  }
  if ((!range.lower && !range.lower_open) || (!range.upper && !range.upper_open))
    throw Located(bad_domain("oo belongs to no interval; its side is open", "write (0, oo)"), set.span);
  if (range.lower && range.upper &&
      (*range.lower > *range.upper || (*range.lower == *range.upper && (range.lower_open || range.upper_open))))
    throw Located(bad_domain("the domain of '" + name + "' is empty", "the lower end stands first"), set.span);
  return range;
}

namespace {

/// What `for` says, taken apart: continuous ranges, and names with a list of values each.
struct Domains {
  ParameterBox box;
  std::vector<std::pair<std::string, std::vector<Value>>> lists;
  std::vector<int> valences;
};

Domains read_domains(const std::vector<grammar::Domain>& domains, CallContext& context) {
  Domains result;
  std::set<std::string> seen;
  for (const grammar::Domain& d : domains) {
    static const std::set<std::string> reserved = {"alpha", "alpha0", "h", "pi", "oo", "v", "X"};
    if (reserved.contains(d.name))
      throw Located(bad_domain("'" + d.name + "' has a meaning of its own and cannot run over a domain", "use another name"),
                    d.span);
    if (!seen.insert(d.name).second) throw Located(bad_domain("'" + d.name + "' has two domains", "give it one"), d.span);
    if (std::holds_alternative<grammar::Interval>(d.set->node)) {
      if (d.name == "N")
        throw Located(bad_domain("N is a whole number", "write N in 3 .. 20, or N in [5] for one valence"), d.span);
      result.box.push_back(range_of(d.name, *d.set, context));
      continue;
    }
    const Value set = evaluate(*d.set, context);
    std::vector<Value> values = set.as<ListValue>() ? set.as<ListValue>()->items : std::vector<Value>{set};
    if (values.empty() || values.size() > 1000)
      throw Located(bad_domain("the domain of '" + d.name + "' must have 1 to 1000 values", "such as 3 .. 20"), d.span);
    if (d.name != "N") {
      result.lists.emplace_back(d.name, std::move(values));
      continue;
    }
    for (const Value& v : values) result.valences.push_back(whole_number(v, "the valence N", 3, 1000));
  }
  return result;
}

/// Calls f with a scope for every combination of the listed values.
template <class F>
void for_values(const Domains& domains, std::size_t k, const std::shared_ptr<const Environment>& scope, F f) {
  if (k == domains.lists.size()) return f(scope);
  for (const Value& value : domains.lists[k].second) {
    auto inner = std::make_shared<Environment>();
    inner->frame = true;
    inner->outer = scope;
    inner->names.emplace(domains.lists[k].first, value);
    for_values(domains, k + 1, inner, f);
  }
}

/// The values of this pass of those names that words may leave open.
std::map<std::string, Rational> open_parameters(const Domains& domains, const Environment& scope) {
  std::map<std::string, Rational> values;
  for (const auto& [name, list] : domains.lists) {
    if (name != "f" && name != "omega" && name != "delta") continue;
    const auto* number = scope.find(name)->as<NumberValue>();
    if (!number) throw bad_domain("the values of '" + name + "' must be numbers", "such as 0 .. 3");
    try {
      values[name] = number_as<Rational>(*number);
    } catch (const Error& error) {
      if (error.kind != ErrorKind::not_exact) throw;
      throw bad_domain("the values of '" + name + "' must be rational", "write them into the word");
    }
  }
  return values;
}

/// The name stands in the text as a word of its own.
bool mentions(const std::string& text, const std::string& name) {
  const auto is_part = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; };
  for (std::size_t at = text.find(name); at != std::string::npos; at = text.find(name, at + 1)) {
    const bool begins = at == 0 || !is_part(text[at - 1]),
               ends = at + name.size() == text.size() || !is_part(text[at + name.size()]);
    if (begins && ends) return true;
  }
  return false;
}

std::string domain_text(const std::vector<grammar::Domain>& domains) {
  std::string text;
  for (const grammar::Domain& d : domains) text += (text.empty() ? "" : ", ") + d.name + " in " + grammar::to_string(*d.set);
  return text;
}

/// The scope, domain and search of a claim, taken back at the end of the block.
class Inside {
 public:
  Inside(CallContext& context, std::shared_ptr<const Environment> scope, const ClaimDomain& domain)
      : context_(context), scope_(context.scope), domain_(context.domain) {
    context.scope = std::move(scope);
    context.domain = &domain;
  }
  ~Inside() {
    context_.scope = std::move(scope_);
    context_.domain = domain_;
  }
  Inside(const Inside&) = delete;
  Inside& operator=(const Inside&) = delete;

 private:
  CallContext& context_;
  std::shared_ptr<const Environment> scope_;
  const ClaimDomain* domain_;
};

Result result_of(const Expr& claim, CallContext& context) {
  const Value value = evaluate(claim, context);
  const auto* report = value.as<ReportValue>();
  if (!report || !report->claim)
    throw Located(Error(ErrorKind::word, "E_NOT_A_CLAIM",
                        "this claims nothing that could be proved, it is " + with_article(type_name(value)),
                        "claims are converges(w), c1(w), c(w, k), equal(w, w), keeps_circles(w), regular(mesh), "
                        "interpolates(mesh); assert compares values"),
                  claim.span);
  return *report->claim;
}

void save_certificate(const grammar::Claim& c, const Result& result, CallContext& context) {
  if (!c.certificate) return;
  if (!result.certificate) {
    if (context.output.warning) context.output.warning("there is no certificate, so '" + *c.certificate + "' was not written");
    return;
  }
  write_file(context.folder / interpolate(*c.certificate, context), result.certificate->dump(1) + "\n");
}

/// Lists of more than 20 entries end in dots: for people.
Json shortened(const Json& json) {
  if (!json.is_structured()) return json;
  Json result = json.is_array() ? Json::array() : Json::object();
  for (const auto& [key, value] : json.items()) {
    if (json.is_object()) {
      result[key] = shortened(value);
    } else if (result.size() == 20) {
      result.push_back("and " + std::to_string(json.size() - 20) + " more");
      break;
    } else {
      result.push_back(shortened(value));
    }
  }
  return result;
}

std::string headline(const Result& result) {
  const std::string verdict = result.evidence
                                  ? std::string("evidence ") + (result.verdict == Verdict::refuted ? "against" : "for")
                                  : to_string(result.verdict);
  return (result.evidence && result.verdict == Verdict::undecided ? "no evidence" : verdict) + ": " + result.claim;
}

}  // namespace

SearchLimits search_limits(const CallContext& context) {
  SearchLimits limits;
  limits.stop = context.stop.get();
  return limits;
}

Value claim_value(Result result, const std::string& domain) {
  ReportValue report;
  report.text =
      headline(result) + (domain.empty() ? "" : "\n  for " + domain) + (result.reason.empty() ? "" : "\n  " + result.reason);
  if (!result.witness.is_null()) report.text += "\n  witness: " + shortened(result.witness).dump();
  report.json = Json{{"kind", "claim"},
                     {"claim", result.claim},
                     {"domain", domain},
                     {"verdict", to_string(result.verdict)},
                     {"reason", result.reason},
                     {"witness", result.witness},
                     {"certificate", result.certificate ? *result.certificate : Json(nullptr)},
                     {"details", result.details}};
  if (result.evidence) {  // numbers in floating point prove nothing
    report.json["verdict"] = "undecided";
    report.json["evidence"] = result.verdict == Verdict::proved ? "for" : result.verdict == Verdict::refuted ? "against" : "none";
    report.json.erase("certificate");
  }
  report.claim = std::make_shared<const Result>(std::move(result));
  return Value{std::move(report)};
}

Value decide_claim(const grammar::Claim& c, CallContext& context) {
  const Domains domains = read_domains(c.domains, context);
  std::size_t passes = 1;
  for (const auto& [name, values] : domains.lists) {
    passes *= values.size();
    if (passes > 1000) throw bad_domain("the domain has more than 1000 combinations of values", "prove parts of it");
  }
  ClaimDomain domain{domains.box, domains.valences, !c.prove};
  auto scope = std::make_shared<Environment>();
  scope->frame = true;
  scope->outer = context.scope;
  for (const ParameterRange& range : domains.box)
    scope->names.emplace(range.name, Value{NumberValue{Parametric::variable(range.name)}});
  std::vector<Result> results;
  for_values(domains, 0, scope, [&](const std::shared_ptr<const Environment>& inner) {
    domain.fixed = open_parameters(domains, *inner);
    const Inside inside(context, inner, domain);
    results.push_back(result_of(*c.claim, context));
  });
  for (const grammar::Domain& d : c.domains) {
    if (d.name != "N" && !domain.filled.contains(d.name) && !mentions(grammar::to_string(*c.claim), d.name))
      throw Located(
          bad_domain("nothing in the claim depends on '" + d.name + "'", "leave its domain away, or use it in the word"), d.span);
  }
  Result result = all_of(std::move(results));
  save_certificate(c, result, context);
  return claim_value(std::move(result), domain_text(c.domains));
}

Value verify_file(const std::string& path, CallContext& context) {
  const std::string text = read_file(context.folder / path);
  const std::optional<Json> certificate = parse_certificate(text);
  const Verification outcome = certificate ? verify(*certificate, context.stop.get())
                                           : Verification{false, "", "the file is not JSON, or has an entry twice"};
  ReportValue report;
  report.text = outcome.accepted ? "accepted: " + outcome.statement : "rejected: " + outcome.reason;
  report.json = Json{{"kind", "verification"},
                     {"file", path},
                     {"accepted", outcome.accepted},
                     {"statement", outcome.statement},
                     {"reason", outcome.reason}};
  Result result;
  result.verdict = outcome.accepted ? Verdict::proved : Verdict::refuted;
  result.claim = outcome.statement;
  result.reason = outcome.reason;
  report.claim = std::make_shared<const Result>(std::move(result));
  return Value{std::move(report)};
}

}  // namespace udcp
