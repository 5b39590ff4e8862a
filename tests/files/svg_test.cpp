// Pictures: geometry of the projection, order of drawing, text that cannot break the XML.
#include "files/svg.h"

#include <algorithm>

#include "helpers.h"

using namespace udcp;
using namespace udcp::test;

namespace {

/// Values of an attribute, in order of appearance.
std::vector<std::string> values(const std::string& text, const std::string& attribute) {
  std::vector<std::string> result;
  const std::string key = " " + attribute + "=\"";
  for (auto at = text.find(key); at != std::string::npos; at = text.find(key, at + 1)) {
    const auto from = at + key.size();
    result.push_back(text.substr(from, text.find('"', from) - from));
  }
  return result;
}

SvgLayer layer(const Points<double>& points) {
  SvgLayer result;
  result.points = points;
  return result;
}

}  // namespace

TEST_SUITE("files") {
  TEST_CASE("the picture keeps the aspect and y points up") {
    Points<double> points(3, 2);
    points << 0, 0, 4, 0, 4, 2;
    SvgOptions options;
    options.size = 440;
    options.margin = 20;
    const std::string text = svg({layer(points)}, options);
    CHECK(values(text, "points") == std::vector<std::string>{"20,220 420,220 420,20"});
    CHECK(values(text, "viewBox") == std::vector<std::string>{"0 0 440 240"});
    Points<double> flat(3, 3);
    flat << 0, 0, 5, 4, 0, 5, 4, 2, 5;
    CHECK(svg({layer(flat)}, options) == text);  // flat in z: seen from above
    Points<double> values_only(3, 1);
    values_only << 0, 2, 0;
    CHECK(values(svg({layer(values_only)}, options), "points") == std::vector<std::string>{"20,420 220,20 420,420"});
  }

  TEST_CASE("layers have markers legends and closed lines") {
    SvgLayer cage = layer(Points<double>::Random(5, 2));
    cage.closed = cage.markers = true;
    cage.label = "a < b & \"c\"";
    cage.dash = "4 3";
    const std::string text = svg({cage, layer(Points<double>::Random(3, 2))});
    CHECK(values(text, "r").size() == 5);
    CHECK(text.find("<polygon ") != std::string::npos);
    CHECK(text.find("<polyline ") != std::string::npos);
    CHECK(text.find(">a &lt; b &amp; &quot;c&quot;</text>") != std::string::npos);
    CHECK(values(text, "stroke-dasharray") == std::vector<std::string>{"4 3"});
    cage.width = 0;
    CHECK(svg({cage}).find("<polygon ") == std::string::npos);
    CHECK(svg({}).find("</svg>") != std::string::npos);
  }

  TEST_CASE("a curve is drawn as it is") {
    Polyline<double> square;
    square.points.resize(4, 2);
    square.points << 0, 0, 1, 0, 1, 1, 0, 1;
    SvgOptions options;
    options.size = 100;
    options.margin = 0;
    CHECK(values(svg_curve(square, options), "points") == std::vector<std::string>{"0,100 100,100 100,0 0,0"});
    CHECK(save_bytes(square, "svg") == svg_curve(square));
  }

  TEST_CASE("near faces are drawn last and those that face the light are brighter") {
    const auto cube = load<double>(data / "meshes" / "cube.obj");
    SvgMeshOptions options;
    options.view = {0, 0, 1};
    options.size = 200;
    options.margin = 0;
    options.fill = "#808080";
    const auto places = values(svg_mesh(cube, options), "points");
    REQUIRE(places.size() == 6);
    auto corners_of = [](const std::string& text) { return std::count(text.begin(), text.end(), ','); };
    CHECK(corners_of(places.back()) == 4);
    options.view = {0.2, 0.1, 1};
    const std::string text = svg_mesh(cube, options);
    const auto fills = values(text, "fill");
    REQUIRE(fills.size() == 6);
    CHECK(*std::ranges::max_element(fills) == fills.back());  // the face towards the eye; equal channels compare as numbers
    CHECK(fills.front() == fills.back());                     // its opposite, seen from behind, is shaded alike
    options.edges = false;
    CHECK(values(svg_mesh(cube, options), "stroke").size() == 6);
    auto coloured = cube;
    coloured.attributes["h"] = {0, 0, 0, 0, 1, 1, 1, 1};
    options.colour_attribute = "h";
    CHECK(values(svg_mesh(coloured, options), "fill") != fills);
    CHECK(refusal([&] { svg_mesh(cube, options); }) == "E_ATTRIBUTE: the surface has no attribute 'h' to show as colour");
  }

  TEST_CASE("what cannot be drawn is refused") {
    Points<double> points = Points<double>::Zero(3, 2);
    points(1, 1) = NAN;
    CHECK(refusal([&] { svg({layer(points)}); }) == "E_NOT_FINITE: a point of the picture is not finite; nothing was drawn");
    CHECK(refusal([&] { svg({layer(Points<double>::Zero(3, 4))}); }) ==
          "E_DIMENSION: a picture shows points with one to three coordinates");
    SvgOptions options;
    options.view = {0, 0, 0};
    CHECK(refusal([&] { svg({layer(Points<double>::Random(3, 3))}, options); }) ==
          "E_VIEW: the view direction must be a vector that is not zero");
    CHECK(svg({layer(Points<double>::Constant(3, 2, 7))}).find("nan") == std::string::npos);
    CHECK(svg({layer(Points<double>::Random(3, 2) * 1e300)}).find("inf") == std::string::npos);
  }
}
