// Curves in OBJ files.
#include "helpers.h"

using namespace udcp;
using namespace udcp::test;

TEST_SUITE("files") {
  TEST_CASE("open and closed curves come back as they were") {
    Polyline<double> curve;
    curve.points = Points<double>::Random(7, 3);
    for (const bool closed : {true, false}) {
      curve.closed = closed;
      curve.corner = {0, 0, 1, 0, 0, 1, 0};
      const auto back = load_curve_bytes<double>(save_bytes(curve, "obj"), "t.obj");
      CHECK(back.points == curve.points);
      CHECK(back.closed == closed);
      CHECK(back.corner == curve.corner);
    }
  }

  TEST_CASE("the order of the line is the order of the curve") {
    const auto curve = load_curve_bytes<Rational>("v 0 0 0\nv 0.1 0 0\nv 1 1 0\nv 7 7 7\nl 3 1 -3/5\n", "t.obj");
    CHECK_FALSE(curve.closed);
    REQUIRE(curve.size() == 3);
    CHECK(curve.points(0, 0) == Rational(1));
    CHECK(curve.points(2, 0) == Rational::parse("1/10"));
  }

  TEST_CASE("files that hold no single curve are refused") {
    const auto answer = [](const std::string& text) { return refusal([&] { load_curve_bytes<double>(text, "t.obj"); }); };
    const std::string points = "v 0 0 0\nv 1 0 0\nv 1 1 0\n";
    CHECK(answer("") == "E_FILE_EMPTY: t.obj: the file is empty");
    CHECK(answer(points) == "E_FILE_EMPTY: t.obj: the file holds no 'l' line, so no curve");
    CHECK(answer(points + "l 1 2\nl 2 3\n") == "E_FILE_SYNTAX: t.obj:5: a second 'l' line; a curve is one line");
    CHECK(answer(points + "l 1 2 1\n") == "E_FILE_SYNTAX: t.obj:4: a closed curve needs at least three points");
    CHECK(answer(points + "l 1 2\ng corner\np 3\n") == "E_FILE_TAG: t.obj:6: vertex 3 in group corner is not on the curve");
    CHECK(refusal([] { load_curve<double>("a.ply"); }) == "E_FILE_FORMAT: a.ply: unknown format 'ply'");
    Polyline<double> curve;
    curve.points = Points<double>::Zero(3, 2);
    curve.points(1, 1) = INFINITY;
    CHECK(refusal([&] { save_bytes(curve, "obj"); }) ==
          "E_NOT_FINITE: the curve has a point that is not finite; nothing was written");
    CHECK(refusal([&] { save_bytes(curve, "glb"); }) == "E_FORMAT: cannot save a curve: unknown format 'glb'");
    CHECK(refusal([&] { save_bytes(Polyline<double>{}, "obj"); }).starts_with("E_DIMENSION"));
  }
}
