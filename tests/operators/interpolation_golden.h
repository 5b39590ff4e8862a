// The file of expected interpolation values: meshes, normals, numbers. Independent computation, not our output.
#pragma once

#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "operators/methods/interpolation/interpolation.h"

namespace udcp::oracle {

inline const nlohmann::json& interpolation_values() {
  static const nlohmann::json values = [] {
    std::ifstream in(UDCP_TEST_DATA "/interpolation.json");
    return nlohmann::json::parse(in);
  }();
  return values;
}

inline Points<double> rows_of(const nlohmann::json& list) {
  Points<double> rows(static_cast<Eigen::Index>(list.size()), 3);
  for (std::size_t i = 0; i < list.size(); ++i)
    for (std::size_t c = 0; c < 3; ++c)
      rows(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(c)) = list[i][c].get<double>();
  return rows;
}

struct GoldenMesh {
  Surface<double> cage;
  Points<double> normals;
};

inline GoldenMesh golden_mesh(const std::string& name) {
  const nlohmann::json& mesh = interpolation_values()["meshes"][name];
  GoldenMesh result;
  result.cage.points = rows_of(mesh["V"]);
  result.cage.mesh =
      std::make_shared<const Mesh>(make_mesh(static_cast<int>(mesh["V"].size()), mesh["F"].get<std::vector<std::vector<int>>>()));
  result.normals = rows_of(mesh["N"]);
  return result;
}

inline const std::vector<std::string>& golden_names() {
  static const std::vector<std::string> names{"cube",         "cube_tilted",  "hex",  "torus",
                                              "torus_tilted", "torus_coarse", "cone", "sphere"};
  return names;
}

inline Rational fraction_of(const nlohmann::json& text) { return Rational::parse(text.get<std::string>()); }

}  // namespace udcp::oracle
