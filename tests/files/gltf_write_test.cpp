// What stands in written glTF and GLB files: points, unit normals, colours, extras, scenes and animations, seen by a second
// reader.
#include <array>
#include <cmath>
#include <fstream>

#include "files/colour_map.h"
#include "gltf_opinion.h"

using namespace udcp;
using namespace udcp::test;

namespace {

Surface<double> cube() { return load<double>(data / "meshes" / "cube.obj"); }

}  // namespace

TEST_SUITE("files") {
  TEST_CASE("another reader finds the same points unit normals colours and extras") {
    auto surface = cube();
    surface.attributes["height"] = {0, 1, 2, 3, 4, 5, 6, 8};
    SaveOptions options;
    options.word = "(UCP)^4";
    options.parameters = {{"delta", "1/2"}};
    options.colour_attribute = "height";
    for (const bool binary : {true, false}) {
      const auto seen = second_opinion(save_bytes(surface, binary ? "glb" : "gltf", options), binary);
      const Json &mesh = seen.json["meshes"][0], &primitive = mesh["primitives"][0], &accessors = seen.json["accessors"];
      const Json& attributes = primitive["attributes"];
      CHECK(floats(seen, attributes["POSITION"]) == std::vector<double>(surface.points.data(), surface.points.data() + 24));
      const auto normals = floats(seen, attributes["NORMAL"]);
      for (std::size_t v = 0; v < 8; ++v)
        CHECK(std::hypot(normals[3 * v], normals[3 * v + 1], normals[3 * v + 2]) == doctest::Approx(1).epsilon(1e-6));
      const Json& position = accessors[attributes["POSITION"].get<std::size_t>()];
      CHECK(position["min"] == Json{-1, -1, -1});
      CHECK(position["max"] == Json{1, 1, 1});
      const Json& indices = accessors[primitive["indices"].get<std::size_t>()];
      CHECK(indices["count"] == 36);
      CHECK(indices["componentType"] == 5123);
      CHECK(mesh["extras"] == Json{{"word", "(UCP)^4"}, {"parameters", {{"delta", "1/2"}}}});
      CHECK(seen.json["materials"][primitive["material"].get<std::size_t>()]["doubleSided"] == true);
      const Json& colours = accessors[attributes["COLOR_0"].get<std::size_t>()];
      CHECK(colours["normalized"] == true);
      CHECK(colours["componentType"] == 5121);
      CHECK(colours["type"] == "VEC4");
      const auto colour = [&](std::size_t k) { return static_cast<unsigned char>(seen.bytes[start_of(seen, colours) + k]); };
      const Colour low = linear(colour_map(0)), high = linear(colour_map(1));
      for (std::size_t c = 0; c < 3; ++c) {
        CHECK(colour(c) == std::lround(255 * low[c]));
        CHECK(colour(28 + c) == std::lround(255 * high[c]));
      }
      CHECK(colour(3) == 255);
    }
  }

  TEST_CASE("the same surface gives the same bytes") {
    for (const char* format : {"glb", "gltf"}) CHECK(save_bytes(cube(), format) == save_bytes(cube(), format));
  }

  TEST_CASE("a word that is no UTF-8 is written with replacement characters") {
    SaveOptions options;
    options.word =
        "U\xff"
        "P";
    const auto seen = second_opinion(save_bytes(tetrahedron(), "glb", options), true);
    CHECK(seen.json["meshes"][0]["extras"]["word"] == "U\xef\xbf\xbdP");
  }

  TEST_CASE("normals that are given are used and zero ones are replaced") {
    Points<double> normals = Points<double>::Zero(4, 3);
    normals.row(0) << 0, 0, 2;
    SaveOptions options;
    options.normals = &normals;
    const auto back = parse(save_bytes(tetrahedron(), "glb", options), "glb");
    CHECK(back.attributes.at("nz")[0] == 1);
    CHECK(std::abs(back.attributes.at("nz")[1] + 1 / std::sqrt(3.0)) < 1e-7);
    normals.resize(3, 3);
    CHECK(
        refusal([&] { save_bytes(tetrahedron(), "glb", options); }).starts_with("E_POINTS: the normals do not fit the surface"));
    SaveOptions missing;
    missing.colour_attribute = "w";
    CHECK(refusal([&] { save_bytes(tetrahedron(), "glb", missing); }) ==
          "E_ATTRIBUTE: the surface has no attribute 'w' to show as colour");
  }

  TEST_CASE("many vertices need long indices") {
    const int n = 70000;
    Points<double> points(n + 1, 3);
    std::vector<std::vector<int>> faces;
    for (int k = 0; k < n; ++k) {
      points.row(k + 1) << std::cos(k * 6.283185307179586 / n), std::sin(k * 6.283185307179586 / n), 0;
      faces.push_back({0, 1 + k, 1 + (k + 1) % n});
    }
    points.row(0).setZero();
    const auto surface = make_surface(points, faces);
    const auto back = parse(save_bytes(surface, "glb"), "glb");
    CHECK(back.mesh->vertex == surface.mesh->vertex);
    CHECK((back.points - points).cwiseAbs().maxCoeff() < 1e-7);
  }

  TEST_CASE("a scene holds several shapes in their places") {
    const auto a = tetrahedron(), b = cube();
    const auto file = std::filesystem::temp_directory_path() / ("udcp-scene-" + std::to_string(::getpid()) + ".glb");
    save_scene({{&a, "small", {0, 0, 0}, {}}, {&b, "large", {5, 0, 0}, {}}}, file);
    const auto both = load<double>(file);
    std::filesystem::remove(file);
    CHECK(both.mesh->vertices() == 12);
    CHECK(both.mesh->faces() == 4 + 12);
    CHECK(both.points.bottomRows(8).col(0).minCoeff() == 4);
    CHECK(both.points.bottomRows(8).col(0).maxCoeff() == 6);
    CHECK(refusal([&] { save_scene({}, "x.glb"); }) == "E_NO_FACES: there is no shape to save");
    CHECK(refusal([&] { save_scene({}, "x.obj"); }) == "E_FORMAT: x.obj: unknown format 'obj'");
  }

  TEST_CASE("the targets of an animation add up to its frames") {
    std::vector<Surface<double>> frames(4, tetrahedron());
    for (std::size_t k = 0; k < 4; ++k) frames[k].points *= 1 + 0.5 * static_cast<double>(k);
    const auto file = std::filesystem::temp_directory_path() / ("udcp-animation-" + std::to_string(::getpid()) + ".glb");
    save_animation(frames, file, {}, 10);
    const auto seen = second_opinion(read_file(file), true);
    std::filesystem::remove(file);
    const Json &mesh = seen.json["meshes"][0], &primitive = mesh["primitives"][0];
    const auto base = floats(seen, primitive["attributes"]["POSITION"]);
    REQUIRE(primitive["targets"].size() == 3);
    CHECK(mesh["weights"] == Json{0, 0, 0});
    for (std::size_t k = 1; k < 4; ++k) {
      const auto moved = floats(seen, primitive["targets"][k - 1]["POSITION"]);
      for (std::size_t c = 0; c < 12; ++c) CHECK(base[c] + moved[c] == frames[k].points.data()[c]);
    }
    const Json &animation = seen.json["animations"][0], &sampler = animation["samplers"][0];
    CHECK(animation["channels"] == Json::parse(R"([{"sampler": 0, "target": {"node": 0, "path": "weights"}}])"));
    CHECK(floats(seen, sampler["input"])[3] == doctest::Approx(0.3));
    CHECK(floats(seen, sampler["output"]) == std::vector<double>{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1});
    frames[2] = cube();
    CHECK(refusal([&] { save_animation(frames, file); }) ==
          "E_ANIMATION: frame 2 has other faces than frame 0; morph targets need the same connectivity");
    CHECK(refusal([&] { save_animation({}, file); }) == "E_ANIMATION: an animation needs at least one frame");
    CHECK(refusal([&] { save_animation({cube()}, file, {}, 0); }) ==
          "E_ANIMATION: the number of frames per second must be positive");
    CHECK_FALSE(std::filesystem::exists(file));
  }
}
