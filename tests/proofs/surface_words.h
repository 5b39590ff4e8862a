// The words of the tests on extraordinary points: Catmull-Clark, Loop and the families of the expected values, by name.
#pragma once

#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "operators/number.h"
#include "tests/oracle/words.h"

namespace udcp::oracle {

/// delta = (N - 4)/N
inline Word catmull_clark() {
  return scheme("UCP", value(1), value(0),
                formula([](const auto& c) { return ratio(c.valence - 4, c.valence); }, {true, false, false}));
}

/// delta = 1 - 8/3 (5/8 - (3/8 + cos(2 pi/N)/4)^2)
inline Word loop() {
  const KernelPtr delta = formula(
      [](const auto& c) {
        using Q = std::decay_t<decltype(c.alpha)>;
        const Q third = Q(ratio(3, 8)) + cos(Q::pi(ratio(2, c.valence))) / Q(4);
        return Q(1) - Q(ratio(8, 3)) * (Q(ratio(5, 8)) - third * third);
      },
      {true, false, false});
  return on_triangles(scheme("UCP", value(1), value(0), delta));
}

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
