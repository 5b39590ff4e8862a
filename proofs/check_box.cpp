// The checker of "curve-box": walks the tree of cells, which covers the box by construction, and checks every leaf.
#include "proofs/box_scheme.h"
#include "proofs/checkers.h"
#include "proofs/parameter_box.h"
#include "proofs/polytope.h"

namespace udcp {
namespace {

ParameterRange range_from(const Json& json) {
  require_entries(json, {"name", "lower", "upper", "lower_open", "upper_open"}, "a range of data.box");
  require(json["name"].is_string() && json["lower_open"].is_boolean() && json["upper_open"].is_boolean(),
          "a range of data.box has a name and two flags");
  ParameterRange range;
  range.name = json["name"].get<std::string>();
  try {
    (void)Parametric::variable(range.name);
  } catch (const Error& error) {
    throw Rejected(std::string("data.box: ") + error.what());
  }
  if (!json["lower"].is_null()) range.lower = rational_from(json["lower"], "data.box.lower");
  if (!json["upper"].is_null()) range.upper = rational_from(json["upper"], "data.box.upper");
  range.lower_open = json["lower_open"].get<bool>();
  range.upper_open = json["upper_open"].get<bool>();
  require(range.lower || range.upper, "the range of '" + range.name + "' has no end");
  require((range.lower || range.lower_open) && (range.upper || range.upper_open), "an infinite end is open");
  const bool empty = range.lower && range.upper &&
                     (*range.lower > *range.upper || (*range.lower == *range.upper && (range.lower_open || range.upper_open)));
  require(!empty, "the range of '" + range.name + "' is empty");
  return range;
}

Rational power_bound(const BoxScheme& scheme) {
  Rational bound(1);
  for (int k = 0; k < scheme.smoothness; ++k) bound /= Rational(scheme.arity);
  return bound;
}

void check_cell(const BoxScheme& scheme, const Json& node, std::vector<Side> cell, int depth) {
  require(depth <= 100, "the cells are nested more than 100 deep");
  if (node.is_object() && node.contains("split")) {
    require_entries(node, {"split", "at", "below", "above"}, "a cell");
    const auto v = static_cast<std::size_t>(integer_from(node["split"], 0, static_cast<int>(cell.size()) - 1, "a cell's split"));
    const Rational at = rational_from(node["at"], "a cell's at");
    require(cell[v].lower < at && at < cell[v].upper, "a cell is split outside of itself");
    const Side whole = cell[v];
    cell[v] = {whole.lower, at, whole.lower_open, false};
    check_cell(scheme, node["below"], cell, depth + 1);
    cell[v] = {at, whole.upper, false, whole.upper_open};
    check_cell(scheme, node["above"], cell, depth + 1);
  } else if (node.is_object() && node.contains("norm")) {
    require_entries(node, {"norm"}, "a cell");
    require(contracts_on(scheme, integer_from(node["norm"], 1, 2, "a cell's norm"), cell), "the norm of a cell is not below 1");
  } else {
    require_entries(node, {"polytope"}, "a cell");
    const Polytope polytope = polytope_from(node["polytope"]);
    require(polytope.bound < power_bound(scheme), "the bound of a polytope is not below A^-k");
    check_polytope(transitions_on(scheme, cell), polytope);
  }
}

std::string text_of(const ParameterRange& range) {
  return range.name + " in " + (range.lower_open ? "(" : "[") + (range.lower ? range.lower->to_string() : "-oo") + ", " +
         (range.upper ? range.upper->to_string() : "oo") + (range.upper_open ? ")" : "]");
}

}  // namespace

std::vector<Points<Rational>> transitions_on(const BoxScheme& scheme, const std::vector<Side>& cell) {
  require(is_multi_affine(scheme), "polytopes serve masks that are multi-affine in the parameters only");
  std::vector<Points<Rational>> matrices;
  for (const std::vector<Rational>& corner : corners_of(cell)) {
    ScaledTransitions t = transitions_at(scheme, corner);
    require(t.denominator.sign() >= 0, "the denominator is negative at a corner");
    for (Points<Rational>& matrix : t.matrices) {
      if (t.denominator.is_zero()) {
        require(matrix == Points<Rational>::Zero(matrix.rows(), matrix.cols()),
                "the weights are unbounded at a corner of a cell");
        continue;
      }
      for (Eigen::Index i = 0; i < matrix.size(); ++i) matrix.data()[i] /= t.denominator;
      matrices.push_back(std::move(matrix));
    }
  }
  return matrices;
}

std::string check_curve_box(const Json& data, StopFlag) {
  require_entries(data, {"word", "smoothness", "box", "cells"}, "data");
  const Word word = word_from(entry(data, "word"));
  require(to_json(word, {4}) == data["word"] && !word.triangles, "the word is not in the form that this program writes");
  const int k = integer_from(entry(data, "smoothness"), 0, 20, "data.smoothness");
  const Json& ranges = entry(data, "box");
  require(ranges.is_array() && !ranges.empty() && ranges.size() <= 6, "data.box must be 1 to 6 ranges");
  ParameterBox box;
  std::string domain;
  for (const Json& range : ranges) {
    box.push_back(range_from(range));
    for (std::size_t i = 0; i + 1 < box.size(); ++i) require(box[i].name != box.back().name, "a parameter has two ranges");
    domain += (domain.empty() ? "" : ", ") + text_of(box.back());
  }
  const BoxScheme scheme = difference_scheme_on_box(word, k, box);
  check_cell(scheme, entry(data, "cells"), scheme.box, 0);
  return describe(data["word"]) + (k == 0 ? " converges" : " is C^" + std::to_string(k)) + " for all " + domain;
}

}  // namespace udcp
