// Pictures: geometry of the projection, order of drawing, text that cannot break the XML.
#include "files/svg.h"

#include <algorithm>

#include "files/colour_map.h"
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

  TEST_CASE("layers can be words and many lines in one path") {
    Points<double> points(4, 2);
    points << 0, 0, 1, 0, 0, 1, 1, 1;
    SvgLayer lines = layer(points);
    lines.segments = true;
    lines.opacity = 0.5;
    SvgLayer word = layer(points.topRows(1));
    word.text = "u < v";
    word.text_size = 20;
    word.anchor = "middle";
    SvgLayer dots = layer(points);
    dots.width = 0;
    dots.markers = true;
    dots.marker_size = 7;
    SvgOptions options;
    options.size = 100;
    options.margin = 0;
    const std::string text = svg({lines, word, dots}, options);
    CHECK(values(text, "d") == std::vector<std::string>{"M0,100L100,100M0,0L100,0"});
    CHECK(values(text, "opacity") == std::vector<std::string>{"0.5"});
    CHECK(text.find("<text x=\"0\" y=\"100\" font-family=\"sans-serif\" font-size=\"20\" text-anchor=\"middle\" "
                    "fill=\"#1f4e79\">u &lt; v</text>") != std::string::npos);
    CHECK(values(text, "r") == std::vector<std::string>(4, "7"));
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

  TEST_CASE("where zero matters what is not positive is red and drawn last") {
    // Two unit squares over each other in one plane, the first with one negative corner.
    Surface<double> surface;
    surface.mesh = std::make_shared<const Mesh>(make_mesh(8, {{0, 1, 2, 3}, {4, 5, 6, 7}}));
    surface.points.resize(8, 3);
    surface.points << 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0;
    surface.attributes["j"] = {-1, 4, 4, 4, 4, 4, 4, 4};
    SvgMeshOptions options;
    options.view = {0, 0, 1};
    options.colour_attribute = "j";
    const auto plain = values(svg_mesh(surface, options), "fill");
    options.zero_matters = true;
    const auto marked = values(svg_mesh(surface, options), "fill");
    REQUIRE(marked.size() == 2);
    CHECK(marked[0] == plain[1]);  // the greatest value is the end of the map either way
    const auto channel = [&](std::size_t c) { return std::stoi(marked[1].substr(1 + 2 * c, 2), nullptr, 16); };
    CHECK(channel(0) > 2 * (channel(1) + channel(2)));
    options.legend = true;
    const std::string text = svg_mesh(surface, options);
    CHECK(text.find(">max 4</text>") != std::string::npos);
    CHECK(text.find(">min -1</text>") != std::string::npos);
    CHECK(text.find(">0</text>") != std::string::npos);
    CHECK(text.find(">j</text>") != std::string::npos);
  }

  TEST_CASE("scales lead values to colours") {
    const std::vector<double> values{-2, 1, 4};
    const ColourScale plain = colour_scale(values, false), marked = colour_scale(values, true);
    CHECK(plain.at(-2) == colour_map(0));
    CHECK(plain.at(1) == colour_map(0.5));
    CHECK(plain.at(4) == colour_map(1));
    CHECK(marked.at(1) == colour_map(0.25));
    CHECK(marked.at(4) == colour_map(1));
    CHECK(marked.at(0) != marked.at(-2));
    CHECK(marked.at(-2)[0] > 3 * marked.at(-2)[1]);  // red
    CHECK(colour_scale(std::vector<double>{3, 3}, false).at(3) == colour_map(0.5));
    CHECK(colour_scale(std::vector<double>{0, 0}, true).at(0) == marked.at(0));
    CHECK(colour_scale(std::vector<double>{-1e308, 1e308}, false).at(0) == colour_map(0.5));
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
