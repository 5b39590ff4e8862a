// Values as text for people and as JSON lines for programs. Knows every kind of value; leaves numbers and shapes to
// report_parts.h.
#include "interpreter/report.h"

#include <algorithm>

#include "grammar/parse.h"
#include "grammar/print.h"
#include "interpreter/report_parts.h"

namespace udcp {
namespace {

/// A double, or a list of nothing else: one ≈ before the bracket then speaks for all of them.
bool is_measured(const Value& value) {
  if (const auto* number = value.as<NumberValue>()) return std::holds_alternative<double>(number->value);
  const auto* list = value.as<ListValue>();
  return list != nullptr && !list->items.empty() && std::all_of(list->items.begin(), list->items.end(), is_measured);
}

std::string plain_text(const Value& measured) {
  if (const auto* number = measured.as<NumberValue>()) return double_text(std::get<double>(number->value));
  std::string text;
  for (const Value& item : measured.as<ListValue>()->items) text += (text.empty() ? "" : ", ") + plain_text(item);
  return "[" + text + "]";
}

std::string list_text(const ListValue& list) {
  std::string text;
  bool long_items = false;
  for (const Value& item : list.items) {
    const auto* quoted = item.as<TextValue>();
    const std::string part = quoted != nullptr ? "\"" + quoted->value + "\"" : to_text(item);
    long_items = long_items || part.find('\n') != std::string::npos;
    text += (text.empty() ? "" : long_items ? ",\n" : ", ") + part;
  }
  return "[" + text + "]";
}

std::string function_text(const FunctionValue& function) {
  std::string parameters;
  for (const std::string& parameter : function.parameters) parameters += (parameters.empty() ? "" : ", ") + parameter;
  return function.name + "(" + parameters + ")" + (function.body ? " = " + grammar::to_string(*function.body) : "");
}

Json payload(const Value& value);

struct Texts {
  std::string operator()(const Nothing&) const { return {}; }
  std::string operator()(const NumberValue& number) const { return number_text(number); }
  std::string operator()(const Boolean& boolean) const { return boolean.value ? "true" : "false"; }
  std::string operator()(const TextValue& text) const { return text.value; }
  std::string operator()(const ListValue& list) const { return list_text(list); }
  std::string operator()(const WordValue& word) const { return word.source; }
  std::string operator()(const CurveValue& curve) const { return curve_text(curve); }
  std::string operator()(const MeshValue& mesh) const { return mesh_text(mesh); }
  std::string operator()(const MatrixValue& matrix) const { return matrix_text(matrix); }
  std::string operator()(const FunctionValue& function) const { return function_text(function); }
  std::string operator()(const ReportValue& report) const { return report.text; }
};

struct Payloads {
  Json operator()(const Nothing&) const { return nullptr; }
  Json operator()(const NumberValue& number) const {
    return std::visit([](const auto& value) { return number_json(value); }, number.value);
  }
  Json operator()(const Boolean& boolean) const { return boolean.value; }
  Json operator()(const TextValue& text) const { return text.value; }
  Json operator()(const ListValue& list) const {
    Json items = Json::array();
    for (const Value& item : list.items) items.push_back(payload(item));
    return items;
  }
  Json operator()(const WordValue& word) const { return word.source; }
  Json operator()(const CurveValue& curve) const { return curve_json(curve); }
  Json operator()(const MeshValue& mesh) const { return mesh_json(mesh); }
  Json operator()(const MatrixValue& matrix) const { return matrix_json(matrix); }
  Json operator()(const FunctionValue& function) const { return function_text(function); }
  Json operator()(const ReportValue& report) const { return report.json; }
};

Json payload(const Value& value) { return std::visit(Payloads{}, value.data); }

}  // namespace

std::vector<std::string> word_bindings(const WordValue& word) {
  std::vector<std::string> lines;
  try {
    const auto expression = grammar::parse_expression(word.source);
    const auto* written = std::get_if<grammar::WordExpr>(&expression->node);
    if (written == nullptr) return lines;
    for (const grammar::Binding& binding : written->where) {
      const std::string direction = binding.direction.empty() ? "" : "@" + binding.direction;
      const std::string parameter = binding.parameter.empty() ? "" : "(" + binding.parameter + ")";
      lines.push_back(binding.name + direction + parameter + " = " + grammar::to_string(*binding.value));
    }
  } catch (const grammar::SyntaxError&) {
    // The text of a word that was made by a function call need not be a word by itself; then there is nothing to list.
  }
  return lines;
}

std::string to_text(const Value& value) {
  return is_measured(value) ? "≈ " + plain_text(value) : std::visit(Texts{}, value.data);
}

namespace {

/// A report names its own kind; of a mask the coefficients are the value, and arity, offset and shift stand beside it.
Json report_json(const Json& report) {
  const auto kind = report.find("kind");
  if (!report.is_object() || kind == report.end()) return Json{{"kind", "report"}, {"value", report}};
  const bool has_coefficients = report.contains("coefficients");
  Json json{{"kind", *kind}, {"value", has_coefficients ? report["coefficients"] : Json::object()}};
  for (const auto& [key, part] : report.items()) {
    if (key == "kind" || key == "coefficients") continue;
    (has_coefficients ? json : json["value"])[key] = part;
  }
  return json;
}

}  // namespace

Json to_json(const Value& value) {
  if (const auto* report = value.as<ReportValue>()) return report_json(report->json);
  Json json{{"kind", type_name(value)}, {"value", payload(value)}};
  if (const auto* word = value.as<WordValue>()) {
    json["bindings"] = word_bindings(*word);
    json["defaults"] = word->defaults;
    json["scheme"] = word->word.is_scheme();
  }
  return json;
}

}  // namespace udcp
