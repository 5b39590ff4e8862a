// STL: welding, and the checks of both encodings.
#include "helpers.h"

using namespace udcp;
using namespace udcp::test;

TEST_SUITE("files") {
  TEST_CASE("a binary STL is welded to the mesh it came from") {
    const auto surface = load<double>(data / "meshes" / "icosahedron.stl");
    CHECK(surface.mesh->vertices() == 12);
    CHECK(surface.mesh->edges() == 30);
    const auto exact = load<Rational>(data / "meshes" / "icosahedron.stl");
    for (Eigen::Index k = 0; k < surface.points.size(); ++k)
      CHECK(exact.points.data()[k] == Rational::from_double(surface.points.data()[k]));
    const auto back = parse(save_bytes(surface, "stl"), "stl");
    check_same(back, surface);
  }

  TEST_CASE("quads are cut along the shorter diagonal and normals point outside") {
    Points<double> points(4, 3);
    points << 0, 0, 0, 3, 1, 0, 1, 1, 0, 0, 1, 0;  // the diagonal 1-3 is the longer one
    const std::string bytes = save_bytes(make_surface(points, {{0, 1, 2, 3}}), "stl");
    CHECK(bytes.size() == 84 + 2 * 50);
    const auto surface = parse(bytes, "stl");
    CHECK(surface.mesh->faces() == 2);
    const auto& mesh = *surface.mesh;
    int interior = -1;
    for (int e = 0; e < mesh.edges(); ++e) {
      if (!mesh.is_boundary_edge(e)) interior = mesh.edge_half[Mesh::i(e)];
    }
    REQUIRE(interior >= 0);
    const int a = mesh.vertex[Mesh::i(interior)], b = mesh.tip(interior);
    CHECK((surface.points.row(a) - surface.points.row(b)).norm() == doctest::Approx(std::sqrt(2.0)));
    float normal = 0;
    std::memcpy(&normal, bytes.data() + 84 + 8, 4);
    CHECK(normal == 1.0F);
  }

  TEST_CASE("an ascii STL is read with exact decimals") {
    const std::string text =
        "solid a name\n facet normal 0 0 1\n  outer loop\n   vertex 0 0 0\n   vertex 0.1 0 0\n   vertex 0 1 0\n  endloop\n "
        "endfacet\n"
        "facet normal 0 0 1\nouter loop\nvertex 0.10 -0 0\nvertex 1 1 0\nvertex 0 1e0 0\nendloop\nendfacet\nendsolid a name\n";
    const auto surface = parse<Rational>(text, "stl");
    CHECK(surface.mesh->vertices() == 4);
    CHECK(surface.points(1, 0) == Rational::parse("1/10"));
  }

  TEST_CASE("errors of STL name the place and what was expected") {
    const std::string start = "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n";
    const std::pair<std::string, std::string> rows[] = {
        {"", "E_FILE_EMPTY: t.stl: the file is empty"},
        {"abc", "E_FILE_FORMAT: t.stl: the file has 3 bytes; a binary STL has at least 84, and an ascii one starts with 'solid'"},
        {"solid\nendsolid\n", "E_FILE_EMPTY: t.stl: the file holds no triangle"},
        {start + "endloop\n", "E_FILE_SYNTAX: t.stl:6: 'endloop' stands where vertex is expected"},
        {start, "E_FILE_SYNTAX: t.stl:6: the file ends where vertex is expected"},
        {start + "vertex 0 x 0\n", "E_FILE_NUMBER: t.stl:6: a coordinate 'x' is not a number"},
        {start + "vertex 1 0 0\nendloop\nendfacet\nendsolid\n",
         "E_FACE_REPEATS: t.stl:2: face 0 repeats vertex 1; faces need distinct vertices"},
        {std::string(80, ' ') + std::string("\1\0\0\0", 4),
         "E_FILE_COUNT: t.stl: the file promises 1 triangles, but holds only 0"},
        {std::string(80, ' ') + std::string("\1\0\0\0", 4) + std::string(50, '\xff'),
         "E_FILE_NUMBER: t.stl: triangle 0 (byte 96) has a coordinate that is not a finite number"},
    };
    for (const auto& row : rows) {
      const std::string &text = row.first, &answer = row.second;
      CAPTURE(text);
      CHECK(parse_error(text, "stl") == answer);
    }
  }
}
