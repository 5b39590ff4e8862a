// OFF and its variants.
#include "helpers.h"

using namespace udcp;
using namespace udcp::test;

TEST_SUITE("files") {
  TEST_CASE("OFF keeps polygons and every bit of the coordinates") {
    check_same(parse(save_bytes(roof(), "off"), "off"), roof());
    const auto a = load<double>(data / "meshes" / "icosahedron.off"), b = load<double>(data / "meshes" / "icosahedron.obj");
    CHECK(a.mesh->vertices() - a.mesh->edges() + a.mesh->faces() == 2);
    CHECK((a.points - b.points).cwiseAbs().maxCoeff() < 1e-10);
  }

  TEST_CASE("NOFF gives normals and COFF colours are passed over") {
    const auto surface = parse(
        "CNOFF # c\n3 1 0\n0 0 0 0 0 1 255 0 0 1\n1 0 0 0 1 0 255 0 0 1\n0 1 0 1 0 0 255 0 0 1\n3 0 1 2 0.5 0.5 0.5\n", "off");
    CHECK(surface.attributes.at("nx") == std::vector<double>{0, 0, 1});
    CHECK(surface.attributes.at("nz") == std::vector<double>{1, 0, 0});
    Warnings warnings;
    parse("OFF 3 1 0\n0 0 0 7\n1 0 0\n0 1 0\n3 0 1 2\n", "off", &warnings);
    CHECK(warnings == Warnings{"t.off:2: numbers after the coordinates of a vertex; ignored"});
  }

  TEST_CASE("errors of OFF name the line and what was expected") {
    const std::string three = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n";
    const std::pair<std::string, std::string> rows[] = {
        {"", "E_FILE_EMPTY: t.off: the file is empty"},
        {"PLY\n", "E_FILE_FORMAT: t.off:1: the file starts with 'PLY'; OFF is expected"},
        {"STOFF\n", "E_FILE_FORMAT: t.off:1: the variant 'STOFF' is not supported"},
        {"OFF BINARY\n", "E_FILE_FORMAT: t.off:1: binary OFF is not supported"},
        {"OFF\n3\n", "E_FILE_SYNTAX: t.off:3: the number of faces is missing"},
        {"OFF\n-3 1 0\n", "E_FILE_COUNT: t.off:2: the number of vertices is -3; counts are not negative"},
        {"OFF\n3 1 0 7\n", "E_FILE_SYNTAX: t.off:2: the line of counts goes on with '7'"},
        {"OFF\n999999999999 1 0\n0 0 0\n",
         "E_FILE_COUNT: t.off:2: the header promises 999999999999 vertices, but the rest of the file has room for at most 2"},
        {"OFF\n3 1 0\n0 0 0\n1 0 0\n", "E_FILE_COUNT: t.off:5: the file ends after 2 of 3 vertices"},
        {three, "E_FILE_COUNT: t.off:6: the file ends after 0 of 1 faces"},
        {three + "2 0 1\n", "E_FILE_SYNTAX: t.off:6: face 0 has 2 corners; faces need at least three"},
        {three + "4 0 1 2\n", "E_FILE_SYNTAX: t.off:6: face 0 promises 4 corners, but only 3 follow"},
        {three + "3 0 1 3\n", "E_FILE_INDEX: t.off:6: face 0 names vertex 3, but there are 3 vertices (0 to 2)"},
        {three + "3 0 1 2\n3 0 1 2\n", "E_FILE_COUNT: t.off:7: the file goes on with '3' after 1 faces"},
        {three + "3 0 1 1\n", "E_FACE_REPEATS: t.off:6: face 0 repeats vertex 1; faces need distinct vertices"},
    };
    for (const auto& row : rows) {
      const std::string &text = row.first, &answer = row.second;
      CAPTURE(text);
      CHECK(parse_error(text, "off") == answer);
    }
  }
}
