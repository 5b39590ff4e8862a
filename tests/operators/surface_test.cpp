// validate and convert: what fits, what does not, and that exactness is never invented.
#include "operators/surface.h"

#include <doctest/doctest.h>

#include <memory>

#include "operators/polyline.h"

using namespace udcp;

namespace {

Surface<Rational> triangle() {
  Surface<Rational> surface;
  surface.mesh = std::make_shared<const Mesh>(make_mesh(3, std::vector<std::vector<int>>{{0, 1, 2}}));
  surface.points.resize(3, 2);
  surface.points << Rational(0), Rational(0), Rational::parse("1/3"), Rational(0), Rational(0), Rational::parse("0.1");
  surface.tags.corner = {1, 0, 0};
  surface.attributes["w"] = {Rational(1), Rational(2), Rational::parse("-7/5")};
  return surface;
}

template <class F>
std::string refusal(F f) {
  try {
    f();
  } catch (const Error& error) {
    return error.code + ": " + error.what();
  }
  return "accepted";
}

}  // namespace

TEST_SUITE("operators") {
  TEST_CASE("a rational surface survives the way through algebraic numbers exactly") {
    const auto surface = triangle();
    const auto back = convert<Rational>(convert<Algebraic>(surface));
    CHECK(back.points == surface.points);
    CHECK(back.attributes == surface.attributes);
    CHECK(back.tags.corner == surface.tags.corner);
    CHECK(back.mesh == surface.mesh);
  }

  TEST_CASE("converting to double rounds to nearest and to Interval encloses") {
    const auto surface = triangle();
    const auto rounded = convert<double>(surface);
    CHECK(rounded.points(1, 0) == 1.0 / 3.0);
    CHECK(rounded.points(2, 1) == 0.1);
    CHECK(rounded.attributes.at("w")[2] == -1.4);
    const auto enclosed = convert<Interval>(surface);
    CHECK(enclosed.points(1, 0).contains(Rational::parse("1/3")));
    CHECK(enclosed.points(2, 1).contains(Rational::parse("1/10")));
    const auto dyadic = convert<Interval>(rounded);
    CHECK(dyadic.points(2, 1).contains(Rational::from_double(0.1)));
    CHECK_FALSE(dyadic.points(2, 1).contains(Rational::parse("1/10")));
    CHECK(convert<double>(dyadic).points == rounded.points);
    CHECK(convert<double>(rounded).points == rounded.points);
  }

  TEST_CASE("nothing becomes exact that was not") {
    const auto rounded = convert<double>(triangle());
    const auto enclosed = convert<Interval>(triangle());
    for (const auto& answer : {refusal([&] { convert<Rational>(rounded); }), refusal([&] { convert<Algebraic>(rounded); })}) {
      CHECK(answer == "E_NOT_EXACT: a floating-point number has no exact value here");
    }
    CHECK(refusal([&] { convert<Rational>(enclosed); }) == "E_NOT_EXACT: an enclosure has no exact value here");
    const Polyline<double> curve{rounded.points, true, {}, {}};
    CHECK(refusal([&] { convert<Rational>(curve); }).starts_with("E_NOT_EXACT"));
  }

  TEST_CASE("surfaces whose columns do not fit the mesh are refused") {
    const auto good = triangle();
    CHECK(refusal([&] { validate(good); }) == "accepted");
    CHECK(refusal([] { validate(Surface<double>{}); }) == "E_NO_FACES: the surface has no face");
    auto bad = good;
    bad.points.resize(2, 3);
    CHECK(refusal([&] { validate(bad); }) == "E_POINTS: a surface needs one point per vertex: 2 values given, 3 needed");
    bad = good;
    bad.points.resize(3, 0);
    CHECK(refusal([&] { validate(bad); }) == "E_DIMENSION: the points of a surface need at least one coordinate");
    bad = good;
    bad.tags.edge.resize(2);
    CHECK(refusal([&] { validate(bad); }) == "E_TAGS: edge tags need one value per edge: 2 values given, 3 needed");
    bad = good;
    bad.tags.corner.resize(4);
    CHECK(refusal([&] { validate(bad); }) == "E_TAGS: corner tags need one value per vertex: 4 values given, 3 needed");
    bad = good;
    bad.attributes["w"].pop_back();
    CHECK(refusal([&] { validate(bad); }) ==
          "E_ATTRIBUTE_SIZE: attribute 'w' needs one value per vertex: 2 values given, 3 needed");
  }

  TEST_CASE("curves need points and one to three coordinates") {
    Polyline<double> curve{Points<double>::Zero(3, 2), true, {}, {}};
    CHECK(refusal([&] { validate(curve); }) == "accepted");
    curve.points.resize(2, 2);
    CHECK(refusal([&] { validate(curve); }) == "E_POINTS: a closed curve needs at least 3 points, not 2");
    curve.closed = false;
    CHECK(refusal([&] { validate(curve); }) == "accepted");
    curve.points.resize(1, 2);
    CHECK(refusal([&] { validate(curve); }) == "E_POINTS: an open curve needs at least 2 points, not 1");
    curve.points.resize(5, 4);
    CHECK(refusal([&] { validate(curve); }) == "E_DIMENSION: the points of a curve have one to three coordinates, not 4");
    curve.points.resize(5, 0);
    CHECK(refusal([&] { validate(curve); }) == "E_DIMENSION: the points of a curve have one to three coordinates, not 0");
    curve.points.resize(5, 1);
    curve.corner = {1};
    CHECK(refusal([&] { validate(curve); }) == "E_TAGS: corner tags need one value per point: 1 values given, 5 needed");
  }
}
