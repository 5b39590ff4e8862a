// Every malformed or awkward file against its required outcome, and cut or changed files of all formats, which may be refused but
// must not crash.
#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>

#include "helpers.h"

using namespace udcp;
using namespace udcp::test;

namespace {

struct Outcome {
  std::optional<Surface<double>> surface;
  std::optional<Error> error;
  Warnings warnings;
};

Outcome try_load(const std::filesystem::path& file) {
  Outcome outcome;
  try {
    outcome.surface = load<double>(file, &outcome.warnings);
  } catch (const Error& error) {
    outcome.error = error;
  }
  return outcome;
}

/// The plain cube that the variants are made from.
Surface<double> plain_cube() {
  Points<double> points(8, 3);
  for (int v = 0; v < 8; ++v) points.row(v) << (v & 1) * 2 - 1, (v & 2) - 1, (v & 4) / 2 - 1;
  return make_surface(points, {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}});
}

bool names_line(const std::string& message, const std::string& name) {
  const auto at = message.find(name + ":");
  return at != std::string::npos && message[at + name.size() + 1] >= '1' && message[at + name.size() + 1] <= '9';
}

/// What must stand in the message, for the files whose fault lies at a known place.
const std::map<std::string, std::string> places{{"index_out_of_range.obj", ":9: face 1 names vertex 9, but there are 8 vertices"},
                                                {"nonmanifold_edge.obj", "edge 1-2 has 3 faces"},
                                                {"nonmanifold_vertex.obj", "meet in vertex 1"},
                                                {"two_cubes_one_vertex.obj", "meet in vertex 8"},
                                                {"repeated_vertex.obj", "repeats vertex 3"},
                                                {"repeated_vertex_far.obj", "repeats vertex 1"},
                                                {"duplicate_face.obj", "has the same vertices as face 1"},
                                                {"duplicate_face_reversed.obj", "has the same vertices as face 1"},
                                                {"duplicate_face_rotated.obj", "has the same vertices as face 1"},
                                                {"moebius_strip.obj", "not orientable"},
                                                {"isolated_vertex.obj", "(9)"},
                                                {"nan_coordinate.obj", ":8: "},
                                                {"comma_coordinate.obj", "is not a number"},
                                                {"zero_index.obj", "vertex 0 does not exist"},
                                                {"bad_count.ply", "99999999999"},
                                                {"index_past_vertices.glb", "names point 77"},
                                                {"missing_accessor.glb", "entry 99 of accessors"},
                                                {"short_binary.stl", "promises 1000 triangles, but holds only 1"},
                                                {"utf16.obj", "UTF-16"},
                                                {"zero_area_face.obj", "a face has no area (1)"},
                                                {"bowtie_quad.obj", "a quad crosses itself (1)"},
                                                {"unknown_keyword.obj", ":15: unknown keyword 'vertex'"},
                                                {"pillow_two_quads.obj", "valence 2"},
                                                {"old_mac_cr.obj", "bare CR"},
                                                {"no_magic.off", "OFF is missing"}};

}  // namespace

TEST_SUITE("files") {
  TEST_CASE("every malformed or awkward file has its required outcome") {
    const auto cube = plain_cube();
    std::ifstream table(data / "broken" / "expected.json");
    int count = 0;
    for (const auto& row : nlohmann::json::parse(table)) {
      ++count;
      const auto name = row["file"].get<std::string>(), verdict = row["verdict"].get<std::string>();
      CAPTURE(name);
      const Outcome outcome = try_load(data / "broken" / name);
      std::string said = outcome.error ? outcome.error->what() : "";
      for (const auto& warning : outcome.warnings) said += warning;
      CAPTURE(said);
      const bool is_text = !name.ends_with(".glb") && !name.ends_with(".stl");
      if (const auto place = places.find(name); place != places.end()) CHECK(said.find(place->second) != std::string::npos);
      if (verdict == "error") {
        REQUIRE(outcome.error);
        CHECK(outcome.error->kind == ErrorKind::file);
        CHECK(said.find(name) != std::string::npos);
        const bool whole_file = outcome.error->code == "E_FILE_EMPTY";  // nothing is in any line
        CHECK((!is_text || whole_file || names_line(said, name)));
      } else if (verdict == "topology-error") {
        REQUIRE(outcome.error);
        CHECK(outcome.error->kind == ErrorKind::input);
        CHECK(said.find(name) != std::string::npos);
        CHECK(said.find_first_of("0123456789") != std::string::npos);
      } else if (verdict == "warn") {
        CHECK((outcome.error || !outcome.warnings.empty()));
        CHECK(said.find(name) != std::string::npos);
      } else {
        CHECK(verdict == "ok");
        CHECK_FALSE(outcome.error);
      }
      if (outcome.surface && outcome.surface->mesh->vertices() == 8 && outcome.surface->mesh->faces() == 6 &&
          name.ends_with(".obj") && name != "denormal_coordinate.obj" && name != "zero_area_face.obj") {
        check_same(*outcome.surface, cube);
      }
    }
    CHECK(count == 72);
  }

  TEST_CASE("the variants of the cube are the cube") {
    const auto cube = plain_cube();
    for (const std::string name :
         {"negative_index_ok", "crlf", "old_mac_cr", "no_final_newline", "bom", "tabs_and_blanks", "backslash_continuation",
          "slashes", "colours_and_w", "faces_first", "other_keywords", "unknown_keyword", "isolated_vertex", "quads_for_loop"}) {
      CAPTURE(name);
      check_same(load<double>(data / "broken" / (name + ".obj")), cube);
    }
    const auto small = load<double>(data / "broken" / "denormal_coordinate.obj");
    CHECK(small.points(7, 2) == 1e-310);
    CHECK(load<double>(data / "broken" / "long_line.obj").mesh->size(0) == 3000);
    CHECK(load<double>(data / "broken" / "two_components.obj").mesh->faces() == 12);
  }

  TEST_CASE("what is refused as double is refused as rational, except what only overflows") {
    std::ifstream table(data / "broken" / "expected.json");
    for (const auto& row : nlohmann::json::parse(table)) {
      const auto name = row["file"].get<std::string>();
      CAPTURE(name);
      const std::string rounded = refusal([&] { load<double>(data / "broken" / name); });
      const std::string exact = refusal([&] { load<Rational>(data / "broken" / name); });
      if (name != "overflow_coordinate.obj") CHECK(exact == rounded);
    }
    CHECK(load<Rational>(data / "broken" / "overflow_coordinate.obj").points.maxCoeff() > Rational::from_double(1e308));
  }

  TEST_CASE("cut and changed files are read or refused and nothing else") {
    std::mt19937 random(7);
    Surface<double> surface = load<double>(data / "meshes" / "cube.obj");
    surface.tags.corner.assign(8, 1);
    surface.attributes["w"] = {0, 1, 2, 3, 4, 5, 6, 7};
    int refused = 0, read = 0;
    for (const char* format : {"obj", "off", "ply", "ply-ascii", "stl", "glb", "gltf"}) {
      const std::string good = save_bytes(surface, format);
      for (int trial = 0; trial < 300; ++trial) {
        CAPTURE(format);
        CAPTURE(trial);
        std::string bytes = good;
        if (trial % 3 == 0) bytes.resize(random() % good.size());
        for (int change = 0; change < trial % 5 && !bytes.empty(); ++change)
          bytes[random() % bytes.size()] = static_cast<char>(random());
        Warnings warnings;
        const std::string answer = refusal([&] { load_bytes<double>(bytes, format, "t", &warnings); });
        (answer == "accepted" ? read : refused)++;
        CHECK(answer.find("E_INTERNAL") == std::string::npos);
      }
    }
    CHECK(refused > 700);
    CHECK(read > 100);
  }
}
