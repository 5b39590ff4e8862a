// The reference values of offsets of Loop surfaces, and the meshes that they speak of.
#pragma once

#include <doctest/doctest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "operators/methods/offset/loop_limit.h"
#include "operators/run.h"
#include "operators/schemes.h"
#include "tests/oracle/obj_lines.h"

namespace udcp::oracle {

using OffsetJson = nlohmann::json;

inline const OffsetJson& offset_golden() {
  static const OffsetJson data = [] {
    std::ifstream in(std::string(UDCP_TEST_DATA) + "/loop-offset.json");
    REQUIRE(in);
    return OffsetJson::parse(in);
  }();
  return data;
}

/// A number of the reference data: a JSON number, or a text of 17 digits or p/q.
inline double decimal(const OffsetJson& value) {
  if (!value.is_string()) return value.get<double>();
  const auto text = value.get<std::string>();
  return text.find('/') == std::string::npos ? std::stod(text) : Rational::parse(text).to_double();
}

inline Points<double> decimal_rows(const OffsetJson& rows) {
  Points<double> result(static_cast<Eigen::Index>(rows.size()), static_cast<Eigen::Index>(rows[0].size()));
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (std::size_t j = 0; j < rows[i].size(); ++j)
      result(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = decimal(rows[i][j]);
  return result;
}

/// A mesh of tests/data/offset, its corners (the points of the group `corner`) tagged, refined by Loop.
inline Surface<double> offset_mesh(const std::string& name, int refine = 0) {
  const std::string file = std::string(UDCP_TEST_DATA) + "/offset/" + name;
  Surface<double> surface = as_surface(read_obj_lines(file));
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    if (line.rfind("p ", 0) != 0) continue;
    surface.tags.corner.resize(static_cast<std::size_t>(surface.mesh->vertices()), 0);
    std::istringstream words(line.substr(2));
    for (std::size_t v = 0; words >> v;) surface.tags.corner[v - 1] = 1;
  }
  return run(schemes::loop(), std::move(surface), refine);
}
inline Surface<double> case_mesh(const OffsetJson& test) {
  return offset_mesh(test["mesh"].get<std::string>(), test.value("refine", 0));
}

inline LoopLimit<double> loop_limit(const Surface<double>& surface) { return {surface.mesh, surface.tags}; }

/// The vertices that the rows d, normals and limit points of a case belong to.
inline std::vector<int> reference_vertices(const OffsetJson& test) {
  if (test["d_index"].is_array()) return test["d_index"].get<std::vector<int>>();
  std::vector<int> all;
  for (int v = 0; v < test["vertices"].get<int>(); ++v) all.push_back(v);
  return all;
}
inline Points<double> rows_at(const Points<double>& all, const std::vector<int>& which, Eigen::Index count) {
  Points<double> result(count, all.cols());
  for (Eigen::Index k = 0; k < count; ++k) result.row(k) = all.row(which[static_cast<std::size_t>(k)]);
  return result;
}

inline double largest_difference(const Points<double>& a, const Points<double>& b) {
  REQUIRE(a.rows() == b.rows());
  REQUIRE(a.cols() == b.cols());
  return a.size() == 0 ? 0 : (a - b).cwiseAbs().maxCoeff();
}

}  // namespace udcp::oracle
