// The words of the tests on extraordinary points, by the names of the expected values.
#pragma once

#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "operators/number.h"
#include "operators/schemes.h"
#include "tests/oracle/words.h"

namespace udcp::oracle {

using schemes::catmull_clark;
using schemes::loop;

/// By the names of the expected values.
inline std::map<std::string, Word> surface_words() {
  return {{"catmull-clark", catmull_clark()},
          {"zorin-schroeder-2", scheme("UC")},
          {"zorin-schroeder-4", scheme("UCC")},
          {"doo-sabin-average", scheme("UD")},
          {"zorin-schroeder-3", scheme("UDDD")},
          {"loop", loop()},
          {"interpolating-k1", scheme("UCP")},
          {"interpolating-k2", scheme("UCCP")},
          {"half", scheme("UCP", nullptr, nullptr, value(1, 2))},
          {"interpolating-triangles", on_triangles(scheme("UCP"))}};
}

inline const nlohmann::ordered_json& surface_values() {
  static const nlohmann::ordered_json values =
      nlohmann::ordered_json::parse(std::ifstream(UDCP_TEST_DATA "/surface-proofs.json"));
  return values;
}

}  // namespace udcp::oracle
