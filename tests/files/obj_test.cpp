// OBJ: what is read, what comes back after writing, and the text of errors and warnings.
#include <algorithm>
#include <random>

#include "helpers.h"

using namespace udcp;
using namespace udcp::test;

namespace {

const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

}  // namespace

TEST_SUITE("files") {
  TEST_CASE("OBJ keeps polygons and every bit of the coordinates") {
    const auto surface = roof();
    SaveOptions options;
    options.word = "(UCP)*\nwhere f = 1 \\";
    const std::string text = save_bytes(surface, "obj", options);
    CHECK(text.starts_with("# made by udcp: (UCP)* where f = 1 \\ \nv 0.1 -0.3333333333333333 2e-300\n"));
    check_same(parse(text), surface);
  }

  TEST_CASE("OBJ keeps tags as groups") {
    auto surface = roof();
    surface.tags.corner = {1, 0, 0, 1, 0, 0};
    surface.tags.edge.assign(static_cast<std::size_t>(surface.mesh->edges()), EdgeTag::none);
    for (std::size_t e = 0; e < surface.tags.edge.size(); ++e) {
      surface.tags.edge[e] = e % 3 == 0 ? EdgeTag::latitude : e % 3 == 1 ? EdgeTag::longitude : EdgeTag::none;
    }
    const std::string text = save_bytes(surface, "obj");
    const auto back = parse(text);
    check_same(back, surface);
    CHECK(back.tags.corner == surface.tags.corner);
    CHECK(back.tags.edge == surface.tags.edge);
    CHECK(save_bytes(back, "obj") == text);
  }

  TEST_CASE("lines and points in groups corner lat and lon mark elements") {
    const std::string quad = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";
    const auto surface = parse(quad + "o lat\nl 1 2\ng lon other\nl -3/1 -2 -1\ng corner\np 1 3\ng none\nl 1 3\np 2\n");
    CHECK(surface.tags.edge == std::vector<EdgeTag>{EdgeTag::latitude, EdgeTag::longitude, EdgeTag::longitude, EdgeTag::none});
    CHECK(surface.tags.corner == std::vector<char>{1, 0, 1, 0});
    CHECK(parse(quad + "l 1 3\np 1\n").tags.edge.empty());
    CHECK(parse_error(quad + "g lat\nl 1 3\n") ==
          "E_FILE_TAG: t.obj:7: the line in group lat marks 1-3, which is no edge of the mesh");
    CHECK(parse_error(quad + "g lat\nl 1 2\ng lon\nl 2 1\n") == "E_FILE_TAG: t.obj:9: edge 2-1 is marked both lat and lon");
    CHECK(parse_error("v 9 9 9\nv 0 0 0\nv 1 0 0\nv 1 1 0\nf 2 3 4\ng corner\np 1\n") ==
          "E_FILE_TAG: t.obj:7: the point in group corner marks vertex 1, which no face uses");
    CHECK(parse_error(quad + "g corner\np 5\n") ==
          "E_FILE_INDEX: t.obj:7: the point names vertex 5, but only 4 were given so far");
    CHECK(parse_error(quad + "g lat\nl 1 5\n") == "E_FILE_INDEX: t.obj:7: the line names vertex 5, but only 4 were given so far");
    CHECK(parse_error(quad + "l 1\n") == "E_FILE_SYNTAX: t.obj:6: a line needs at least two vertices");
    Warnings warnings;
    parse(quad + "g corner\nl 1 2\n", "obj", &warnings);
    CHECK(warnings == Warnings{"t.obj:7: an 'l' line in group corner marks nothing; 'p' points mark corners"});
  }

  TEST_CASE("normals become attributes where each vertex has one") {
    const std::string normals = "vn 0 0 1\nvn 0 0 1\nvn 1 0 0\n";
    const auto one = parse(triangle + normals + "f 1//1 2//2 3//1\n");
    CHECK(one.attributes.at("nx") == std::vector<double>{0, 0, 0});
    CHECK(one.attributes.at("nz") == std::vector<double>{1, 1, 1});
    CHECK(parse(triangle + normals + "f 1//1 2//2 3\n").attributes.empty());
    const std::string two = triangle + "v 1 1 0\n" + normals + "f 1//1 2//1 3//1\nf 3//";
    CHECK(parse(two + "2 2//1 4//1\n").attributes.size() == 3);
    CHECK(parse(two + "3 2//1 4//1\n").attributes.empty());
    auto surface = parse(triangle + "f 1 2 3\n");
    Points<double> given(3, 3);
    given << 0, 0, 1, 0, 1, 0, 1, 0, 0;
    SaveOptions options;
    options.normals = &given;
    const auto back = parse(save_bytes(surface, "obj", options));
    CHECK(back.attributes.at("nx") == std::vector<double>{0, 0, 1});
    CHECK(back.attributes.at("ny") == std::vector<double>{0, 1, 0});
    CHECK(back.attributes.at("nz") == std::vector<double>{1, 0, 0});
  }

  TEST_CASE("vertices that no face uses are dropped and named") {
    Warnings warnings;
    const auto surface = parse("v 9 9 9\n" + triangle + "v 8 8 8\nf 2 3 4\n", "obj", &warnings);
    CHECK(surface.points.rows() == 3);
    CHECK(surface.points(1, 0) == 1);
    CHECK(warnings == Warnings{"t.obj: 2 vertices are used by no face and dropped (1, 5)"});
    CHECK(parse_error("v 9 9 9\n" + triangle + "f 2 3 4\nf 2 3 4\n") ==
          "E_DUPLICATE_FACE: t.obj:6: face 2 has the same vertices as face 1; each face may be given once (face 1 stands in line "
          "5)");
  }

  TEST_CASE("decimals are exact as rationals and nearest as doubles") {
    const std::string text = "v .1 +5. 1e-3\nv 1E+2 -0 0.333\nv 0 1 0\nf 1 2 3\n";
    const auto exact = parse<Rational>(text);
    CHECK(exact.points(0, 0) == Rational::parse("1/10"));
    CHECK(exact.points(0, 1) == Rational(5));
    CHECK(exact.points(0, 2) == Rational::parse("1/1000"));
    CHECK(exact.points(1, 0) == Rational(100));
    CHECK(exact.points(1, 2) == Rational::parse("333/1000"));
    CHECK(parse<Interval>(text).points(0, 0).contains(Rational::parse("1/10")));
    CHECK(parse<Algebraic>(text).points(0, 0) == Algebraic(Rational::parse("1/10")));
    CHECK(parse<double>(text).points(0, 0) == 0.1);
  }

  TEST_CASE("errors of OBJ name the line and what was expected") {
    const std::pair<std::string, std::string> rows[] = {
        {"v 0 0\n", "E_FILE_SYNTAX: t.obj:1: the z coordinate is missing"},
        {"v 0 0 x\n", "E_FILE_NUMBER: t.obj:1: the z coordinate 'x' is not a number"},
        {"v 0 0 1,5\n", "E_FILE_NUMBER: t.obj:1: the z coordinate '1,5' is not a number"},
        {"v 0 0 0x10\n", "E_FILE_NUMBER: t.obj:1: the z coordinate '0x10' is not a number"},
        {"v 0 0 -inf\n", "E_FILE_NUMBER: t.obj:1: the z coordinate '-inf' is not a finite number"},
        {"v 0 0 1e999\n", "E_FILE_NUMBER: t.obj:1: the z coordinate '1e999' is too large or has too large an exponent"},
        {"v 0 0 0 1 1\n",
         "E_FILE_SYNTAX: t.obj:1: a vertex has 5 numbers; three coordinates, then at most a weight and a colour"},
        {"vn 0 0 1 2\n", "E_FILE_SYNTAX: t.obj:1: a normal has three components; '2' follows"},
        {"v 0 0 0\nf 1/ 1 1\n", "E_FILE_SYNTAX: t.obj:2: malformed corner '1/'"},
        {"v 0 0 0\nf 1//1/1 1 1\n", "E_FILE_SYNTAX: t.obj:2: malformed corner '1//1/1'"},
        {"v 0 0 0\nf 1 0 1\n", "E_FILE_INDEX: t.obj:2: vertex 0 does not exist"},
        {"v 0 0 0\nf 1 -2 1\n", "E_FILE_INDEX: t.obj:2: vertex -2 does not exist; 1 were given so far"},
        {"v 0 0 0\nf 1 99999999999999999999 1\n", "E_FILE_NUMBER: t.obj:2: vertex '99999999999999999999' is too large"},
        {"v 0 0 0\nf 1 4294967297 1\n", "E_FILE_INDEX: t.obj:2: vertex 4294967297 does not exist; 1 were given so far"},
        {"v 0 0 0\nf 1 1.5 1\n", "E_FILE_NUMBER: t.obj:2: vertex '1.5' is not an integer"},
        {"v 0 0 0\nf 1 2 \\\n3\n", "E_FILE_INDEX: t.obj:2: face 1 names vertex 2, but there are 1 vertices"},
        {"v 0 0 0\n\n# c\nf 1 1\n", "E_FILE_SYNTAX: t.obj:4: face 1 has 2 corners; faces need at least three"},
        {"v 0 0 0\nf 1//2 1//2 1//2\n", "E_FILE_INDEX: t.obj:2: face 1 names normal 2, but there are 0 normals"},
        {"v 0 0 0\nf 1/0 1 1\n", "E_FILE_INDEX: t.obj:2: texture vertex 0 does not exist"},
        {"v 0 0 0\nv 1 0 0\nf 1 2 1\n", "E_FACE_REPEATS: t.obj:3: face 1 repeats vertex 1; faces need distinct vertices"},
        {"v 0 0 0\n\x01 0\n", "E_FILE_SYNTAX: t.obj:2: the line starts with '?'; this is no OBJ text, or it is damaged"},
        {"", "E_FILE_EMPTY: t.obj: the file is empty"},
        {"# only\n", "E_FILE_EMPTY: t.obj: the file holds no vertex and no face"},
        {"v 0 0 0\n", "E_FILE_EMPTY: t.obj: the file holds vertices but no face"},
        {"f 1 2 3\n", "E_FILE_INDEX: t.obj:1: face 1 names vertex 1, but there are 0 vertices"},
    };
    for (const auto& row : rows) {
      const std::string &text = row.first, &answer = row.second;
      CAPTURE(text);
      CHECK(parse_error(text) == answer);
    }
  }

  TEST_CASE("OBJ warns once of what it passes over") {
    Warnings warnings;
    std::string text = triangle + "v 2 2 2 0.5\nv 3 3 3 0.5\ncurv 1 2\nsurf 3\nf 1 2 3\nf 3 2 4\nf 4 2 5\n";
    for (int k = 0; k < 12; ++k) text += "foo\n";
    parse(text, "obj", &warnings);
    REQUIRE(warnings.size() == 13);
    CHECK(warnings[0] == "t.obj:4: a vertex has a weight other than 1; weights are ignored");
    CHECK(warnings[1] == "t.obj:6: free-form geometry ('curv') is not read; ignored");
    CHECK(warnings[2] == "t.obj:11: unknown keyword 'foo'; ignored");
    CHECK(warnings[12] == "t.obj: 2 more lines with unknown keywords; ignored");
  }

  TEST_CASE("surfaces that no file can hold are refused before writing") {
    auto surface = roof();
    surface.points(3, 1) = std::numeric_limits<double>::quiet_NaN();
    for (const char* format : {"obj", "off", "ply", "stl", "glb"}) {
      CHECK(refusal([&] { save_bytes(surface, format); }) ==
            "E_NOT_FINITE: vertex 3 has a coordinate that is not finite; nothing was written");
    }
    CHECK(refusal([&] { save_bytes(roof(), "stl"); }).starts_with("E_FLOAT_RANGE: vertex 1 has a coordinate beyond 3.4e38"));
    CHECK(refusal([&] { save_bytes(roof(), "doc"); }) == "E_FORMAT: cannot save a surface: unknown format 'doc'");
    CHECK(refusal([&] { save(roof(), "roof"); }) == "E_FORMAT: roof: the file name has no extension, so the format is not known");
    CHECK(refusal([&] { parse("", "doc"); }) == "E_FILE_FORMAT: t.doc: unknown format 'doc'");
    auto wide = roof();
    wide.points = Points<double>::Zero(6, 4);
    CHECK(refusal([&] { save_bytes(wide, "obj"); }) == "E_DIMENSION: points with 4 coordinates; files hold three");
    auto flat = roof();
    flat.points = Points<double>::Random(6, 2);
    CHECK(parse(save_bytes(flat, "obj")).points.leftCols(2) == flat.points);
  }

  TEST_CASE("the quick way through plain lines finds what the careful way finds") {
    // The quick way knows spaces only: with a tab in their place, every line is read the careful way.
    const std::string tokens[] = {"1",    "2",    "3",     "4",     "-1",      "0",   "5",    "99",    "1/1",  "2/1/1",
                                  "3//1", "1//2", "2/9/2", "1/0",   "1//",     "x",   "1/",   "+2",    "007",  "12345678901",
                                  "1.5",  ".5",   "-2e-3", "1e400", "1e-400",  "nan", "inf",  "1.5.2", "0x10", "123456789",
                                  "",     "#",    "\\",    "1,5",   "3/2/1/1", "-0",  "+.25", "1e",    "2//1", "3//9"};
    const std::string head = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvn 0 0 1\nvn 1 0 0\n";
    std::mt19937 random(5);
    const auto pick = [&](std::size_t count) { return std::uniform_int_distribution<std::size_t>(0, count - 1)(random); };
    int accepted = 0;
    for (int trial = 0; trial < 6000; ++trial) {
      std::string text = head;
      for (std::size_t line = 0; line < 2; ++line) {
        text += pick(2) == 0 ? "f" : "v";
        const std::size_t plain = pick(3), length = pick(4) == 0 ? pick(11) : 3;
        for (std::size_t k = 0; k < length; ++k)
          text += std::string(1 + pick(8) / 7, ' ') + tokens[plain > 0 ? pick(4) : pick(std::size(tokens))];
        text += pick(6) == 0 ? " \r\n" : "\n";
      }
      if (pick(9) == 0) text.pop_back();
      text += trial % 2 == 0 ? "\nf 1 2 3\n" : "";
      std::string careful = text;
      std::ranges::replace(careful, ' ', '\t');
      CAPTURE(text);
      Warnings quick_warnings, careful_warnings;
      Surface<double> quick_mesh, careful_mesh;
      const std::string answer = refusal([&] { quick_mesh = parse(text, "obj", &quick_warnings); });
      CHECK(answer == refusal([&] { careful_mesh = parse(careful, "obj", &careful_warnings); }));
      CHECK(quick_warnings == careful_warnings);
      if (answer != "accepted") continue;
      ++accepted;
      check_same(quick_mesh, careful_mesh);
      CHECK(quick_mesh.attributes == careful_mesh.attributes);
    }
    CHECK(accepted > 100);
  }
}
