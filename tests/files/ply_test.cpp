// PLY in three encodings.
#include <algorithm>

#include "helpers.h"

using namespace udcp;
using namespace udcp::test;

namespace {

const std::string head = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
const std::string points = "0 0 0\n1 0 0\n0 1 0\n";
const std::string faces = "element face 1\nproperty list uchar int vertex_indices\nend_header\n";

/// The bytes of the numbers of a file, most significant first.
template <class Unsigned>
void put_big(std::string& bytes, Unsigned value) {
  for (std::size_t k = sizeof value; k-- > 0;) bytes.push_back(static_cast<char>(value >> (8 * k) & 0xff));
}

}  // namespace

TEST_SUITE("files") {
  TEST_CASE("PLY keeps polygons attributes and every bit in binary and ascii") {
    auto surface = roof();
    surface.attributes["delta"] = {0.1, 1e-300, -2, 3, 4, 1.0 / 3};
    surface.attributes["my name"] = {1, 2, 3, 4, 5, 6};
    for (const char* format : {"ply", "ply-ascii"}) {
      const auto back = parse(save_bytes(surface, format), "ply");
      check_same(back, surface);
      CHECK(back.attributes.at("delta") == surface.attributes.at("delta"));
      CHECK(back.attributes.at("my_name") == surface.attributes.at("my name"));
    }
  }

  TEST_CASE("a face of more than 255 corners gets a longer count") {
    const auto surface = load<double>(data / "broken" / "long_line.obj");
    for (const char* format : {"ply", "ply-ascii"}) check_same(parse(save_bytes(surface, format), "ply"), surface);
  }

  TEST_CASE("big endian files of all scalar types are read") {
    std::string text =
        "ply\r\nformat binary_big_endian 1.0\r\nelement vertex 3\r\nproperty short x\r\nproperty char y\r\nproperty float z\r\n"
        "property ushort a\r\nproperty uchar b\r\nproperty int c\r\nproperty uint d\r\nproperty double e\r\nproperty list short "
        "uchar skipped\r\n"
        "element face 1\r\nproperty uchar flag\r\nproperty list uint ushort vertex_index\r\nelement other 2\r\nproperty list "
        "uchar double q\r\nend_header\r\n";
    const std::size_t header = text.size();
    const int xs[] = {-300, 20, 0}, ys[] = {0, -1, 1};
    for (std::size_t v = 0; v < 3; ++v) {
      put_big(text, static_cast<std::uint16_t>(xs[v]));
      put_big(text, static_cast<std::uint8_t>(ys[v]));
      put_big(text, std::bit_cast<std::uint32_t>(1.5F));
      put_big(text, std::uint16_t{65535});
      put_big(text, std::uint8_t{255});
      put_big(text, static_cast<std::uint32_t>(-7));
      put_big(text, std::uint32_t{4294967295U});
      put_big(text, std::bit_cast<std::uint64_t>(0.1));
      put_big(text, static_cast<std::uint16_t>(v));
      text.append(v, '\x7f');
    }
    put_big(text, std::uint8_t{9});
    put_big(text, std::uint32_t{3});
    for (const int v : {2, 0, 1}) put_big(text, static_cast<std::uint16_t>(v));
    text += '\0';
    text += '\1';
    put_big(text, std::bit_cast<std::uint64_t>(2.0));
    Warnings warnings;
    const auto surface = parse(text, "ply", &warnings);
    CHECK(warnings.empty());
    CHECK(surface.mesh->vertex == std::vector<int>{2, 0, 1});
    CHECK(surface.points(0, 0) == -300);
    CHECK(surface.points(1, 1) == -1);
    CHECK(surface.points(2, 2) == 1.5);
    CHECK(surface.attributes.at("a")[0] == 65535);
    CHECK(surface.attributes.at("b")[1] == 255);
    CHECK(surface.attributes.at("c")[2] == -7);
    CHECK(surface.attributes.at("d")[2] == 4294967295.0);
    CHECK(surface.attributes.at("e")[2] == 0.1);
    CHECK(parse<Rational>(text, "ply").attributes.at("e")[2] == Rational::from_double(0.1));
    CHECK(surface.attributes.count("skipped") == 0);
    parse(text + "xx", "ply", &warnings);
    CHECK(warnings == Warnings{"t.ply: 2 bytes follow the last element; ignored"});
    for (std::size_t cut = 1; cut <= text.size() - header; ++cut)
      CHECK(parse_error(text.substr(0, text.size() - cut), "ply").starts_with("E_FILE_COUNT: t.ply: "));
  }

  TEST_CASE("PLY files of other programs are read") {
    const auto torus = load<double>(data / "meshes" / "torus_quad_12x8.bin.ply");
    CHECK(torus.mesh->vertices() - torus.mesh->edges() + torus.mesh->faces() == 0);
    CHECK(std::ranges::all_of(torus.mesh->valences, [](int n) { return n == 4; }));
    const auto prism = load<double>(data / "meshes" / "prism_n7.ply");
    CHECK(prism.mesh->faces() == 9);
    CHECK(load<Rational>(data / "meshes" / "prism_n7.ply").points(1, 0) == Rational::parse("0.623489801859"));
  }

  TEST_CASE("errors of PLY name the line and what was expected") {
    const std::pair<std::string, std::string> rows[] = {
        {"", "E_FILE_EMPTY: t.ply: the file is empty"},
        {"plx\n", "E_FILE_FORMAT: t.ply:1: the file does not start with 'ply'"},
        {"ply\nformat ascii 1.0\n", "E_FILE_SYNTAX: t.ply:3: the header has no end_header line"},
        {"ply\nend_header\n", "E_FILE_SYNTAX: t.ply:2: the header has no format line"},
        {"ply\nformat text 1.0\n", "E_FILE_FORMAT: t.ply:2: unknown format 'text'"},
        {"ply\nformat ascii 2.0\n", "E_FILE_FORMAT: t.ply:2: unknown version '2.0'; 1.0 is expected"},
        {"ply\nproperty int x\n", "E_FILE_SYNTAX: t.ply:2: a property before the first element"},
        {"ply\nelement vertex\n", "E_FILE_SYNTAX: t.ply:2: an element line needs a name and a count"},
        {"ply\nelement vertex -1\n", "E_FILE_COUNT: t.ply:2: the count of element 'vertex' is -1; counts are not negative"},
        {"ply\nelement a 1\nelement a 1\n", "E_FILE_SYNTAX: t.ply:3: element 'a' stands twice in the header"},
        {"ply\nelement a 1\nproperty half x\n", "E_FILE_SYNTAX: t.ply:3: unknown type 'half'"},
        {"ply\nelement a 1\nproperty list float int x\n", "E_FILE_SYNTAX: t.ply:3: the length of a list needs an integer type"},
        {"ply\nelement a 1\nproperty int x\nproperty int x\n",
         "E_FILE_SYNTAX: t.ply:4: property 'x' stands twice in its element"},
        {"ply\nelement a 1\nproperty int\n", "E_FILE_SYNTAX: t.ply:3: a property needs a name"},
        {"ply\nfoo\n", "E_FILE_SYNTAX: t.ply:2: unknown header line 'foo'"},
        {"ply\nformat ascii 1.0\nend_header\n", "E_FILE_EMPTY: t.ply: the header has no element vertex"},
        {head + "end_header\n" + points, "E_FILE_EMPTY: t.ply: the header has no element face"},
        {"ply\nformat ascii 1.0\nelement vertex 1\nproperty int x\nend_header\n1\n",
         "E_FILE_SYNTAX: t.ply: element vertex needs the scalar properties x, y and z"},
        {head + "element face 1\nproperty int a\nend_header\n" + points + "1\n",
         "E_FILE_SYNTAX: t.ply: element face needs one list property vertex_indices (or vertex_index)"},
        {head + faces + points + "3 0 1 3\n", "E_FILE_INDEX: t.ply:13: face 0 names vertex 3, but there are 3 vertices (0 to 2)"},
        {head + faces + points + "3 0 1 -1\n", "E_FILE_INDEX: t.ply:13: face 0: vertex -1 does not exist"},
        {head + faces + points + "2 0 1\n", "E_FILE_SYNTAX: t.ply:13: face 0: it has 2 corners; faces need at least three"},
        {head + faces + points + "3 0 1\n",
         "E_FILE_COUNT: t.ply:14: face 0: the file ends here; the header promises 1 of element face"},
        {head + faces + points + "3 0 1 2 9\n", "E_FILE_COUNT: t.ply:13: the file goes on with '9' after the last element"},
        {head + faces + points + "200 0 1\n",
         "E_FILE_COUNT: t.ply:13: face 0: list vertex_indices of length 200 does not fit the rest of the file"},
        {head + faces + "0 0 0 # 1 0 0\n", "E_FILE_NUMBER: t.ply:10: x '#' is not a number"},
    };
    for (const auto& row : rows) {
      const std::string &text = row.first, &answer = row.second;
      CAPTURE(text);
      CHECK(parse_error(text, "ply") == answer);
    }
  }
}
