// Fills as programs write them: surfaces, what is saved and drawn of them, claims, and what is refused.
#include "interpreter/filling.h"

#include <doctest/doctest.h>

#include <fstream>
#include <sstream>

#include "files/geometry_file.h"
#include "interpreter/colour_bar.h"
#include "interpreter/reflection_lines.h"
#include "operators/shapes.h"
#include "tests/interpreter/room.h"

namespace {

using namespace udcp;
using oracle::Room;

std::string printed(Room& room, const std::string& program) { return to_text(room.run(program)); }

}  // namespace

TEST_SUITE_BEGIN("interpreter");

TEST_CASE("a fill says how many patches it has and joins without gaps") {
  Room room;
  CHECK(printed(room, "fill_g2(cube())") ==
        "surface of 24 patches: 0 bicubic, 24 of bidegree 7 around 8 vertices (8 of valence 3); 1 step");
  CHECK(printed(room, "fill_g2(cube(), steps = 2)") ==
        "surface of 96 patches: 72 bicubic, 24 of bidegree 7 around 8 vertices (8 of valence 3); 2 steps");
  CHECK(printed(room, "fill_g2(cube(), steps = auto)") == printed(room, "fill_g2(cube())"));
  CHECK(printed(room, "fill_g2(torus(5, 5, 3, 1))") ==
        "surface of 25 patches: 25 bicubic, 0 of bidegree 7 around 0 vertices; 0 steps");
  CHECK(printed(room, "type(fill_g2(cube()))") == "surface");
  const Json joins = to_json(room.run("joins(fill_g2(cube(), c = 1/4))"))["value"];
  CHECK(joins["edges"] == 48);
  CHECK(joins["gap"].get<double>() <= 1e-13);
  CHECK(joins["normal"].get<double>() <= 1e-11);
  CHECK(joins["curvature"].get<double>() <= 1e-9);
}

TEST_CASE("the parameter of a fill can be a number or a list or an attribute or a function") {
  Room room;
  CHECK(printed(room, "fill_g2(cube(), c = [1/4, 1/4, 1/4, 1/4, 1/4, 1/4, 1/4, 1/4]) |> curvature") ==
        printed(room, "fill_g2(cube(), c = 1/4) |> curvature"));
  CHECK(printed(room, "fill_g2(cube() |> attribute(\"tight\", 1/4), c = \"tight\") |> curvature") ==
        printed(room, "fill_g2(cube(), c = 1/4) |> curvature"));
  CHECK(printed(room, "g(x) = 3/8 + x/8\nfill_g2(cube(), c = g) |> curvature") !=
        printed(room, "fill_g2(cube(), c = 3/8) |> curvature"));
  CHECK(printed(room, "hybrid(cube(), 1/4, steps = 2) |> points") == printed(room, "cube() |> adjustable(1/4)^2 |> points"));
}

TEST_CASE("patches are saved with their degrees and points") {
  Room room;
  room.run("fill_g2(cube(), steps = 2) |> save \"patches.json\"");
  const Json json = Json::parse(room.text("patches.json"));
  CHECK(json["kind"] == "patches");
  REQUIRE(json["patches"].size() == 96);
  int large = 0;
  const PatchSurface surface = fill_g2(cube<double>(), [] {
    FillOptions options;
    options.steps = 2;
    return options;
  }());
  for (const Json& patch : json["patches"]) {
    const BezierPatch& expected = surface.patches[patch["face"].get<std::size_t>()];
    const bool filled = !patch["around"].is_null();
    large += filled;
    CHECK(patch["degree"] == (filled ? Json::array({7, 7}) : Json::array({3, 3})));
    REQUIRE(patch["points"].size() == (filled ? 64U : 16U));
    for (std::size_t k = 0; k < patch["points"].size(); ++k)
      for (std::size_t c = 0; c < 3; ++c)
        CHECK(patch["points"][k][c].get<double>() == expected.points(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(c)));
  }
  CHECK(large == 24);
}

TEST_CASE("tessellations have normals and curvature and files of them a legend") {
  Room room;
  room.run("fill_g2(cube()) |> tessellate(3) |> save \"cube.glb\"\nfill_g2(cube()) |> save \"eight.obj\"");
  const std::string glb = room.text("cube.glb");
  CHECK(glb.find("legend: gaussian from ") != std::string::npos);
  CHECK(glb.find("COLOR_0") != std::string::npos);
  CHECK(load<double>(room.file("eight.obj")).mesh->faces() == 24 * 64);
  room.run("fill_g2(cube()) |> tessellate(3, colour = mean) |> save \"mean.glb\"");
  CHECK(room.text("mean.glb").find("legend: mean from ") != std::string::npos);
  room.run("fill_g2(cube()) |> tessellate(3, colour = none) |> save \"plain.glb\"");
  CHECK(room.text("plain.glb").find("legend") == std::string::npos);
}

TEST_CASE("the bar of a legend runs from the least to the greatest value beside the shape") {
  Surface<double> surface = cube<double>();
  surface.attributes["k"] = {-2, 0, 0, 0, 0, 0, 0, 3};
  const Surface<double> bar = colour_bar(surface, "k");
  CHECK(bar.attributes.at("k").front() == -2);
  CHECK(bar.attributes.at("k").back() == 3);
  CHECK(bar.points.col(0).minCoeff() > 1);
  CHECK(bar.points.col(2).minCoeff() == -1);
  CHECK(bar.points.col(2).maxCoeff() == 1);
  CHECK_THROWS_AS(colour_bar(surface, "l"), Error);
}

TEST_CASE("the comparison of the fill with Catmull-Clark has the values of the reference") {
  Room room;
  const Json rows = to_json(room.run("compare_fill(cube(), vertex = 0)"))["value"]["rows"];
  REQUIRE(rows.size() == 8);
  // The corner of the cube after two steps: the reference table, rounded to its digits.
  const auto near = [](const Json& value, double expected) { return std::abs(value.get<double>() - expected) <= 1e-5; };
  CHECK(near(rows[0]["K"][0], 0.97244));
  CHECK(near(rows[0]["K"][1], 1.92258));
  CHECK(near(rows[6]["K"][0], 2.22170));
  CHECK(near(rows[6]["K"][1], 2.70693));
  CHECK(rows[7]["name"] == "fill");
  CHECK(near(rows[7]["K"][0], 1.26251));
  CHECK(near(rows[7]["K"][1], 2.51213));
  room.run("compare_fill(cube(), vertex = 0, levels = 2) |> plot \"side_by_side.svg\"");
  const std::string picture = room.text("side_by_side.svg");
  CHECK(picture.find(">Catmull-Clark</text>") != std::string::npos);
  CHECK(picture.find(">fill</text>") != std::string::npos);
  CHECK(to_json(room.run("curvature(cube() |> catmull_clark^2, vertex = 0, levels = 6)"))["value"]["rows"][6]["K"] ==
        rows[6]["K"]);
}

TEST_CASE("reflection lines of a plane under one light have one band") {
  // A flat patch mirrors one direction, so all of it lies in one band; a curved one crosses several.
  BezierPatch flat{1, 1, Points<double>(4, 3)}, curved{2, 1, Points<double>(6, 3)};
  flat.points << 0, 0, 0, 0, 1, 0, 1, 0, 0, 1, 1, 0;
  curved.points << 0, 0, 0, 0, 1, 0, 0.5, 0, 1, 0.5, 1, 1, 1, 0, 0, 1, 1, 0;
  const auto dark = [](const BezierPatch& patch) {
    ReflectionOptions options;
    options.eye = {0.1, 0.05, 1};
    const std::string text = picture_of_reflection_lines({{"", {{patch, 4}}}}, options);
    int count = 0;
    for (auto found = text.find("#24466e\" stroke="); found != std::string::npos;
         found = text.find("#24466e\" stroke=", found + 1))
      ++count;
    return count;
  };
  CHECK((dark(flat) == 0 || dark(flat) == 32));  // two triangles per cell, or none
  CHECK(dark(curved) > 40);
  ReflectionOptions nowhere;
  nowhere.eye.setZero();
  CHECK_THROWS_AS(picture_of_reflection_lines({}, nowhere), Error);
}

TEST_CASE("claims about fills are proved and their printed variants refuted") {
  Room room;
  CHECK(room.verdict("prove g2(6) -> \"g2.json\"") == "proved");
  (void)room.run("verify \"g2.json\"");
  CHECK(room.outcome() == Outcome::done);
  CHECK(room.verdict("prove g2(n) for n in 3 .. 4") == "proved");
  CHECK(room.verdict("prove g2() for N in 3 .. 4") == "proved");
  CHECK(room.verdict("prove g2(5, word = interpolating_quads)") == "undecided");
  CHECK(room.verdict("prove g2(5, printed = \"net\")") == "refuted");
  CHECK(room.verdict("prove g2(4, printed = \"psi_y_uu\")") == "undecided");
  CHECK(room.error("prove g2(5, printed = \"x\")") == "E_TYPE");
  CHECK(room.error("prove g2(11)") == "E_FILL_VALENCE");
  CHECK(room.error("g2()") == "E_ARGUMENTS");
}

TEST_CASE("what fills cannot take is refused") {
  Room room;
  CHECK(room.error("fill_g2(cube(), steps = 0)") == "E_FILL_ISOLATED");
  CHECK(room.error("fill_g2(cube(), steps = 21)") == "E_TYPE");
  CHECK(room.error("fill_g2(cube(), c = 3/2)") == "E_ADJUSTABLE_C");
  CHECK(room.error("fill_g2(cube(), c = \"c\")") == "E_ATTRIBUTE");
  CHECK(room.error("fill_g2(cube(), c = [1/2, 1/2])") == "E_ATTRIBUTE_SIZE");
  CHECK(room.error("fill_g2(polygon(5))") == "E_TYPE");
  CHECK(room.error("tessellate(cube())") == "E_TYPE");
  CHECK(room.error("tessellate(fill_g2(cube()), 0)") == "E_TYPE");
  CHECK(room.error("tessellate(fill_g2(cube()), colour = \"red\")") == "E_TYPE");
  CHECK(room.error("set max_faces = 1000\ntessellate(fill_g2(cube()), 50)") == "E_MAX_FACES");
  CHECK(room.error("curvature(cube(), vertex = 8)") == "E_INDEX");
  CHECK(room.error("curvature(cube(), vertex = 0)") == "E_FILL_ISOLATED");
  CHECK(room.error("compare_fill(grid(4, 4), vertex = 0)") == "E_INDEX");
  CHECK(room.error("hybrid(cube(), -1)") == "E_ADJUSTABLE_C");
}

TEST_SUITE_END();
