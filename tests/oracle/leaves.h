// The leaves of a JSON value and wrong values to put there, for tests that change certificates.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace udcp::oracle {

/// JSON pointers to all numbers, texts and truth values.
inline std::vector<std::string> leaves(const nlohmann::ordered_json& value, const std::string& at = "") {
  if (!value.is_structured()) return {at};
  std::vector<std::string> result;
  for (const auto& [key, inner] : value.items())
    for (std::string& leaf : leaves(inner, at + "/" + key)) result.push_back(std::move(leaf));
  return result;
}

/// Other values of the same sort, and one of another.
inline std::vector<nlohmann::ordered_json> other_values(const nlohmann::ordered_json& value) {
  if (value.is_number_integer()) return {value.get<int>() + 1, value.get<int>() - 1, "1"};
  if (value.is_boolean()) return {!value.get<bool>(), 0};
  if (!value.is_string()) return {0};
  const auto text = value.get<std::string>();
  if (text.empty() || text.find_first_not_of("-0123456789/") != std::string::npos) return {text + "x", 1};
  const auto slash = text.find('/');
  std::vector<nlohmann::ordered_json> result{text.front() == '-' ? text.substr(1) : "-" + text, text + "1", 1};
  result.push_back(slash == std::string::npos ? text + "/2" : text.substr(0, slash));
  return result;
}

}  // namespace udcp::oracle
