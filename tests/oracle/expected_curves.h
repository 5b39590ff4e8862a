// The expected values of the proofs about curves, and the words that they are about.
#pragma once

#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/oracle/words.h"

namespace udcp::oracle {

inline const nlohmann::ordered_json& expected_curves() {
  static const auto json = [] {
    std::ifstream file(std::string(UDCP_TEST_DATA) + "/curve-proofs.json");
    return nlohmann::ordered_json::parse(file);
  }();
  return json;
}

/// "U[3]CP" with "f", "omega", "delta" as in {"program", "params"}.
inline Word expected_word(const nlohmann::ordered_json& record) {
  const auto kernel = [&](const char* name) {
    const auto& params = record["params"];
    return params.contains(name) ? constant(Rational::parse(params[name].get<std::string>())) : KernelPtr();
  };
  std::string letters;
  for (const char c : record["program"].get<std::string>())
    if (c != '[' && c != ']') letters += c;
  return scheme(letters, kernel("f"), kernel("omega"), kernel("delta"));
}

}  // namespace udcp::oracle
