// Jacobians of Catmull-Clark surfaces: values against the expected patches, folds and cusps, and what the pictures show.
#include <doctest/doctest.h>

#include <cmath>
#include <fstream>

#include "files/geometry_file.h"
#include "interpreter/jacobian.h"
#include "tests/interpreter/room.h"

namespace {

using namespace udcp;
using oracle::Room;

std::string path_of(const std::string& name) { return UDCP_TEST_DATA "/regularity/" + name + ".obj"; }
Rational number(const Json& text) { return Rational::parse(text.get<std::string>()); }

}  // namespace

TEST_SUITE_BEGIN("interpreter");

TEST_CASE("the Jacobian at regular vertices is the expected one at every level") {
  const Json patches_of_meshes = Json::parse(std::ifstream(UDCP_TEST_DATA "/regularity.json"))["patches"];
  for (const auto& entry : patches_of_meshes.items()) {
    const std::string name = entry.key();
    const Json& patches = entry.value();
    const Surface<double> surface = load<double>(path_of(name));
    for (const int steps : {0, 2}) {
      const auto values = jacobian_surface(surface, steps, {}).surface.attributes.at("jacobian");
      for (const Json& patch : patches) {
        for (const Json& corner : patch["corners"]) {
          static constexpr std::array<std::array<int, 2>, 2> place = {{{0, 1}, {3, 2}}};
          const int k = place[corner["v"].get<std::size_t>()][corner["u"].get<std::size_t>()];
          const int v = patch["corner_vertices"][static_cast<std::size_t>(k)].get<int>() - 1;
          double wanted = 0;
          if (corner["cross"].is_array()) {
            for (const Json& x : corner["cross"]) wanted += std::pow(number(x).to_double(), 2);
            wanted = std::sqrt(wanted);
          } else {
            wanted = number(corner["cross"]).to_double();
          }
          CAPTURE(name);
          CAPTURE(v);
          CHECK(values[static_cast<std::size_t>(v)] == doctest::Approx(wanted).epsilon(1e-10));
        }
      }
    }
  }
}

TEST_CASE("the Jacobian tells folds from clockwise faces") {
  const auto least = [](const Surface<double>& surface, int steps) {
    const auto values = jacobian_surface(surface, steps, {}).surface.attributes.at("jacobian");
    return *std::min_element(values.begin(), values.end());
  };
  CHECK(least(load<double>(path_of("grid_folded")), 2) < -0.1);
  CHECK(least(load<double>(path_of("butterfly_like")), 2) > 0.1);
  Surface<double> mirrored = load<double>(path_of("butterfly_like"));
  mirrored.points.col(0) *= -1;
  CHECK(least(mirrored, 2) == doctest::Approx(least(load<double>(path_of("butterfly_like")), 2)));
  CHECK(least(load<double>(path_of("cusp3d_dyadic")), 2) == 0);  // at u = 1/4, a vertex of level 2
  CHECK(least(load<double>(path_of("cusp3d_dyadic")), 1) > 0);
}

TEST_CASE("a Jacobian that floating point cannot hold is refused") {
  Surface<double> grid = load<double>(path_of("grid_regular"));
  const double unit = jacobian_surface(grid, 1, {}).surface.attributes.at("jacobian")[0];
  CHECK(unit > 0);
  const auto scaled = [&](double factor) {
    Surface<double> result = grid;
    result.points *= factor;
    return result;
  };
  CHECK(jacobian_surface(scaled(1e150), 1, {}).surface.attributes.at("jacobian")[0] == doctest::Approx(1e300 * unit));
  for (const double factor : {1e200, 1e-200}) {
    CAPTURE(factor);
    try {
      (void)jacobian_surface(scaled(factor), 1, {});
      FAIL("no error");
    } catch (const Error& error) {
      CHECK(error.code == "E_NOT_FINITE");
      CHECK(std::string(error.what()).find(factor > 1 ? "too large" : "too small") != std::string::npos);
    }
  }
  Surface<double> point = scaled(0);  // singular everywhere is a value
  CHECK(jacobian_surface(point, 1, {}).surface.attributes.at("jacobian")[0] == 0);
}

TEST_CASE("a Jacobian shows its colours unless told otherwise") {
  Room room;
  room.run("j = jacobian(grid(2, 2), steps = 1)\nj |> plot \"j.svg\"\nj |> save \"j.glb\"\nj |> save \"j.ply\"");
  const std::string svg = room.text("j.svg");
  CHECK(svg.find(">jacobian</text>") != std::string::npos);
  CHECK(svg.find(">max 1</text>") != std::string::npos);
  CHECK(room.text("j.glb").find("COLOR_0") != std::string::npos);
  room.run("grid(2, 2) |> save \"plain.glb\"");
  CHECK(room.text("plain.glb").find("COLOR_0") == std::string::npos);
  CHECK(load<double>(room.file("j.ply")).attributes.contains("jacobian"));
}

TEST_SUITE_END();
