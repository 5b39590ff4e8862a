// region(claim, x in a .. b, ...): where in a box of parameters a claim on curves holds, as data and as a picture; the curve
// where it starts to fail, for one parameter, as enclosures.
#include <algorithm>

#include "interpreter/analysis.h"
#include "interpreter/arguments.h"
#include "interpreter/claims.h"
#include "interpreter/pictures.h"

namespace udcp {
namespace {

Error bad_claim() {
  return {ErrorKind::word, "E_NO_REGION", "region speaks of the claims converges(w), c1(w) and c(w, k) on curves",
          "write region(c1(four_point(w)), w in 0 .. 1/4) |> plot \"region.svg\""};
}

struct SmoothnessClaim {
  Word word;
  int k = 0;
};

SmoothnessClaim read_claim(const grammar::Expr& e, const ParameterBox& box, CallContext& context) {
  const auto* call = std::get_if<grammar::Call>(&e.node);
  if (!call || call->arguments.empty()) throw Located(bad_claim(), e.span);
  SmoothnessClaim claim;
  if (call->name == "c1") {
    claim.k = 1;
  } else if (call->name == "c" && call->arguments.size() == 2) {
    claim.k = whole_number(evaluate(*call->arguments[1].value, context), "k", 0, 20);
  } else if (call->name != "converges") {
    throw Located(bad_claim(), e.span);
  }
  const Value value = evaluate(*call->arguments[0].value, context);
  const auto* word = value.as<WordValue>();
  if (!word || !word->word.is_scheme() || word->rounds || word->word.triangles) throw Located(bad_claim(), e.span);
  ClaimDomain domain;
  domain.box = box;
  claim.word = static_limit(with_parameters(word->word, domain));
  return claim;
}

Json cell_to_json(const RegionCell& cell, const ParameterBox& box) {
  Json json = {{"verdict", to_string(cell.verdict)}};
  for (std::size_t v = 0; v < box.size(); ++v) json[box[v].name] = {cell.lower[v].to_string(), cell.upper[v].to_string()};
  return json;
}

/// For one parameter: intervals of one verdict, neighbours joined.
std::string intervals_text(const std::vector<RegionCell>& cells, const std::string& name) {
  std::string text;
  for (std::size_t k = 0; k < cells.size();) {
    std::size_t end = k;
    while (end + 1 < cells.size() && cells[end + 1].verdict == cells[k].verdict) ++end;
    text += "\n  " + to_string(cells[k].verdict) + " for " + name + " in [" + cells[k].lower[0].to_string() + ", " +
            cells[end].upper[0].to_string() + "]  (" + std::to_string(cells[k].lower[0].to_double()) + " .. " +
            std::to_string(cells[end].upper[0].to_double()) + ")";
    k = end + 1;
  }
  return text;
}

}  // namespace

Value show_region(CallContext& context, const grammar::Call& call) {
  ParameterBox box;
  const grammar::Expr* claim_expression = nullptr;
  for (const grammar::Argument& argument : call.arguments) {
    if (argument.name.empty() && !claim_expression) {
      claim_expression = argument.value.get();
    } else if (argument.in) {
      box.push_back(range_of(argument.name, *argument.value, context));
    } else {
      throw bad_claim();
    }
  }
  if (!claim_expression || box.empty() || box.size() > 2) throw bad_claim();
  for (const ParameterRange& range : box) {
    if (!range.lower || !range.upper || *range.lower == *range.upper)
      throw Error(ErrorKind::word, "E_DOMAIN", "a region needs a finite range of '" + range.name + "'", "write 0 .. 1/4");
  }
  auto scope = std::make_shared<Environment>();
  scope->frame = true;
  scope->outer = context.scope;
  for (const ParameterRange& range : box) scope->names.emplace(range.name, Value{NumberValue{Parametric::variable(range.name)}});
  const auto outside = std::exchange(context.scope, scope);
  SmoothnessClaim claim;
  try {
    claim = read_claim(*claim_expression, box, context);
  } catch (...) {
    context.scope = outside;
    throw;
  }
  context.scope = outside;

  SearchLimits limits = search_limits(context);
  const int depth = box.size() == 1 ? 10 : 10;
  const std::vector<RegionCell> cells = region_of_smoothness(claim.word, claim.k, box, depth, limits);
  std::array<int, 3> count{};
  ReportValue report;
  report.json = Json{{"kind", "region"}, {"cells", Json::array()}};
  for (const RegionCell& cell : cells) {
    ++count.at(static_cast<std::size_t>(cell.verdict));
    report.json["cells"].push_back(cell_to_json(cell, box));
  }
  report.text = std::to_string(count[0]) + " cells proved, " + std::to_string(count[1]) +
                " refuted (where the shifts of the limit function are stable), " + std::to_string(count[2]) + " undecided";
  if (box.size() == 1) report.text += intervals_text(cells, box[0].name);
  report.picture = [cells, box] { return picture_of_region(cells, box, "region"); };
  return Value{std::move(report)};
}

}  // namespace udcp
