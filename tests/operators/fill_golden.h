// The expected values of adjustable Catmull-Clark and of fills.
#pragma once

#include <fstream>
#include <nlohmann/json.hpp>

namespace udcp::oracle {

using Json = nlohmann::json;

inline const Json& golden() {
  static const Json data = Json::parse(std::ifstream(UDCP_TEST_DATA "/g2-filling.json"));
  return data;
}

}  // namespace udcp::oracle
