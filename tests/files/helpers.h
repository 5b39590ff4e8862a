// What the tests of files share: errors as text, small surfaces, comparison.
#pragma once

#include <doctest/doctest.h>

#include <bit>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <limits>
#include <memory>
#include <string>

#include "files/geometry_file.h"

namespace udcp::test {

inline const std::filesystem::path data = UDCP_TEST_DATA;

/// "CODE: message" of the error that f throws, "accepted" if it throws none.
template <class F>
std::string refusal(F f) {
  try {
    f();
  } catch (const Error& error) {
    return error.code + ": " + error.what();
  }
  return "accepted";
}

template <class S = double>
Surface<S> parse(const std::string& text, const std::string& format = "obj", Warnings* warnings = nullptr) {
  return load_bytes<S>(text, format, "t." + format, warnings);
}

inline std::string parse_error(const std::string& text, const std::string& format = "obj") {
  return refusal([&] { parse(text, format); });
}

inline Surface<double> make_surface(const Points<double>& points, const std::vector<std::vector<int>>& faces) {
  return {std::make_shared<const Mesh>(make_mesh(static_cast<int>(points.rows()), faces)), points, {}, {}};
}

/// A pentagonal roof: one pentagon and five triangles, closed below, with awkward coordinates.
inline Surface<double> roof() {
  Points<double> points(6, 3);
  points << 0.1, -1.0 / 3, 2e-300, 1e300, 0.5, -0.0, 3.25, 7, 1e-5, 0.3, 1.1, 123456789.125, -5, 2, 0.7, 0.25, 0.1, -9;
  return make_surface(points, {{0, 1, 2, 3, 4}, {1, 0, 5}, {2, 1, 5}, {3, 2, 5}, {4, 3, 5}, {0, 4, 5}});
}

inline void check_same(const Surface<double>& a, const Surface<double>& b) {
  CHECK(a.points == b.points);
  CHECK(a.mesh->face_begin == b.mesh->face_begin);
  CHECK(a.mesh->vertex == b.mesh->vertex);
}

}  // namespace udcp::test
