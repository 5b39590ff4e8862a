// glTF and GLB: our reader on our writer, tinygltf as a second reader, node transforms, and files that lie about their contents.
#include <tiny_gltf.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "files/colour_map.h"
#include "helpers.h"

using namespace udcp;
using namespace udcp::test;
using Json = nlohmann::json;

namespace {

Surface<double> cube() { return load<double>(data / "meshes" / "cube.obj"); }

/// A tetrahedron, which no triangulation changes.
Surface<double> tetrahedron() {
  Points<double> points(4, 3);
  points << 1, 1, 1, 1, -1, -1, -1, 1, -1, -1, -1, 1;
  return make_surface(points, {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}});
}

/// What another program sees.
tinygltf::Model second_opinion(const std::string& bytes, bool binary) {
  tinygltf::TinyGLTF loader;
  tinygltf::Model model;
  std::string error, warning;
  const bool good =
      binary ? loader.LoadBinaryFromMemory(&model, &error, &warning, reinterpret_cast<const unsigned char*>(bytes.data()),
                                           static_cast<unsigned>(bytes.size()))
             : loader.LoadASCIIFromString(&model, &error, &warning, bytes.data(), static_cast<unsigned>(bytes.size()), "");
  CHECK(good);
  CHECK(error == "");
  CHECK(warning == "");
  return model;
}

std::vector<double> floats(const tinygltf::Model& model, int accessor) {
  const auto& a = model.accessors[static_cast<std::size_t>(accessor)];
  const auto& view = model.bufferViews[static_cast<std::size_t>(a.bufferView)];
  const auto count = a.count * static_cast<std::size_t>(tinygltf::GetNumComponentsInType(static_cast<unsigned>(a.type)));
  std::vector<float> values(count);
  std::memcpy(values.data(), model.buffers[0].data.data() + view.byteOffset + a.byteOffset, 4 * count);
  return {values.begin(), values.end()};
}

/// The tetrahedron as glTF text, for changes.
Json document() { return Json::parse(save_bytes(tetrahedron(), "gltf")); }

std::string answer(const Json& changed) {
  return refusal([&] { parse(changed.dump(), "gltf"); });
}

}  // namespace

TEST_SUITE("files") {
  TEST_CASE("triangles survive GLB and glTF") {
    for (const char* format : {"glb", "gltf"}) {
      const auto back = parse(save_bytes(tetrahedron(), format), format);
      CHECK(back.points == tetrahedron().points);
      CHECK(back.mesh->vertex == tetrahedron().mesh->vertex);
      const double third = static_cast<double>(static_cast<float>(1 / std::sqrt(3.0)));
      CHECK(back.attributes.at("nx") == std::vector<double>{third, third, -third, -third});
    }
    CHECK(parse<Rational>(save_bytes(tetrahedron(), "glb"), "glb").points(1, 2) == Rational(-1));
  }

  TEST_CASE("another reader finds the same points unit normals colours and extras") {
    auto surface = cube();
    surface.attributes["height"] = {0, 1, 2, 3, 4, 5, 6, 8};
    SaveOptions options;
    options.word = "(UCP)^4";
    options.parameters = {{"delta", "1/2"}};
    options.colour_attribute = "height";
    for (const bool binary : {true, false}) {
      const auto model = second_opinion(save_bytes(surface, binary ? "glb" : "gltf", options), binary);
      const auto& primitive = model.meshes[0].primitives[0];
      CHECK(floats(model, primitive.attributes.at("POSITION")) ==
            std::vector<double>(surface.points.data(), surface.points.data() + 24));
      const auto normals = floats(model, primitive.attributes.at("NORMAL"));
      for (std::size_t v = 0; v < 8; ++v)
        CHECK(std::hypot(normals[3 * v], normals[3 * v + 1], normals[3 * v + 2]) == doctest::Approx(1).epsilon(1e-6));
      const auto& position = model.accessors[static_cast<std::size_t>(primitive.attributes.at("POSITION"))];
      CHECK(position.minValues == std::vector<double>{-1, -1, -1});
      CHECK(position.maxValues == std::vector<double>{1, 1, 1});
      CHECK(model.accessors[static_cast<std::size_t>(primitive.indices)].count == 36);
      CHECK(model.meshes[0].extras.Get("word").Get<std::string>() == "(UCP)^4");
      CHECK(model.meshes[0].extras.Get("parameters").Get("delta").Get<std::string>() == "1/2");
      const auto& colours = model.accessors[static_cast<std::size_t>(primitive.attributes.at("COLOR_0"))];
      CHECK(colours.normalized);
      const auto* first =
          model.buffers[0].data.data() + model.bufferViews[static_cast<std::size_t>(colours.bufferView)].byteOffset;
      const Colour low = linear(colour_map(0)), high = linear(colour_map(1));
      for (std::size_t c = 0; c < 3; ++c) {
        CHECK(first[c] == std::lround(255 * low[c]));
        CHECK(first[28 + c] == std::lround(255 * high[c]));
      }
    }
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
    const auto model = second_opinion(read_file(file), true);
    std::filesystem::remove(file);
    const auto& primitive = model.meshes[0].primitives[0];
    const auto base = floats(model, primitive.attributes.at("POSITION"));
    REQUIRE(primitive.targets.size() == 3);
    for (std::size_t k = 1; k < 4; ++k) {
      const auto moved = floats(model, primitive.targets[k - 1].at("POSITION"));
      for (std::size_t c = 0; c < 12; ++c) CHECK(base[c] + moved[c] == frames[k].points.data()[c]);
    }
    const auto& sampler = model.animations[0].samplers[0];
    CHECK(floats(model, sampler.input)[3] == doctest::Approx(0.3));
    CHECK(floats(model, sampler.output) == std::vector<double>{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1});
    frames[2] = cube();
    CHECK(refusal([&] { save_animation(frames, file); }) ==
          "E_ANIMATION: frame 2 has other faces than frame 0; morph targets need the same connectivity");
    CHECK(refusal([&] { save_animation({}, file); }) == "E_ANIMATION: an animation needs at least one frame");
    CHECK(refusal([&] { save_animation({cube()}, file, {}, 0); }) ==
          "E_ANIMATION: the number of frames per second must be positive");
    CHECK_FALSE(std::filesystem::exists(file));
  }

  TEST_CASE("node transforms are applied from the root down") {
    Json changed = document();
    changed["nodes"] = Json::parse(
        R"([{"translation": [10, 0, 0], "children": [1]}, {"rotation": [0, 0, 0.7071067811865476, 0.7071067811865476], "scale": [1, 2, 1], "children": [2]},
        {"mesh": 0, "matrix": [1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,3,1]}])");
    const auto moved = parse(changed.dump(), "gltf");
    const auto plain = tetrahedron();
    for (Eigen::Index v = 0; v < 4; ++v) {  // up by 3, stretched along y, a quarter turn, then along x
      CHECK(moved.points(v, 0) == doctest::Approx(10 - 2 * plain.points(v, 1)));
      CHECK(moved.points(v, 1) == doctest::Approx(plain.points(v, 0)));
      CHECK(moved.points(v, 2) == doctest::Approx(plain.points(v, 2) + 3));
    }
    changed["nodes"] = Json::parse(R"([{"mesh": 0, "scale": [-1, 1, 1]}])");
    const auto mirrored = parse(changed.dump(), "gltf");
    CHECK(mirrored.points(1, 0) == -plain.points(1, 0));
    CHECK(mirrored.mesh->corners(0)[1] == plain.mesh->corners(0)[2]);  // a mirror turns the faces round
    CHECK(mirrored.attributes.at("nx")[0] == doctest::Approx(-1 / std::sqrt(3.0)));
    changed["nodes"] = Json::parse(R"([{"mesh": 0}, {"mesh": 0, "translation": [9, 0, 0]}])");
    changed["scenes"] = Json::parse(R"([{"nodes": [0, 1]}, {"nodes": [1]}])");
    CHECK(parse(changed.dump(), "gltf").mesh->vertices() == 8);
    changed["scene"] = 1;
    CHECK(parse(changed.dump(), "gltf").points.col(0).minCoeff() == 8);
  }

  TEST_CASE("glTF files that lie are refused") {
    const auto with = [](auto change) {
      Json changed = document();
      change(changed);
      return answer(changed);
    };
    CHECK(answer(document()) == "accepted");
    CHECK(with([](Json& d) { d["asset"]["version"] = "1.0"; }) ==
          "E_FILE_FORMAT: t.gltf: version '1.0' of glTF is not supported; 2.0 is");
    CHECK(with([](Json& d) { d.erase("asset"); }) == "E_FILE_SYNTAX: t.gltf: asset.version is missing");
    CHECK(with([](Json& d) { d["extensionsRequired"] = {"KHR_draco_mesh_compression"}; }) ==
          "E_FILE_FORMAT: t.gltf: the file requires the extension 'KHR_draco_mesh_compression', which is not supported");
    CHECK(with([](Json& d) {
            d["meshes"][0]["primitives"][0]["mode"] = 1;
          }).starts_with("E_FILE_FORMAT: t.gltf: meshes[0].primitives[0] has mode 1"));
    CHECK(with([](Json& d) { d["meshes"][0]["primitives"][0]["attributes"]["POSITION"] = 77; }) ==
          "E_FILE_INDEX: t.gltf: meshes[0].primitives[0].POSITION names entry 77 of accessors, but there are 3");
    CHECK(with([](Json& d) { d["meshes"][0]["primitives"][0]["attributes"]["POSITION"] = -1; }) ==
          "E_FILE_NUMBER: t.gltf: meshes[0].primitives[0].POSITION is not a non-negative integer of reasonable size");
    CHECK(with([](Json& d) { d["accessors"][0]["count"] = 5; }) ==
          "E_FILE_COUNT: t.gltf: accessors[0] promises 5 elements of 12 bytes, but reaches past its view of 48 bytes");
    CHECK(with([](Json& d) {
            d["accessors"][0]["count"] = std::uint64_t{1} << 62;
          }).starts_with("E_FILE_NUMBER: t.gltf: accessors[0].count"));
    CHECK(
        with([](Json& d) { d["accessors"][0]["byteOffset"] = 1000; }).starts_with("E_FILE_COUNT: t.gltf: accessors[0] promises"));
    CHECK(with([](Json& d) { d["accessors"][0]["sparse"] = Json::object(); }) ==
          "E_FILE_FORMAT: t.gltf: accessors[0] is sparse, which is not supported");
    CHECK(with([](Json& d) {
            d["accessors"][0]["componentType"] = 5123;
          }).starts_with("E_FILE_FORMAT: t.gltf: meshes[0].primitives[0].POSITION"));
    CHECK(with([](Json& d) { d["accessors"][2]["componentType"] = 5126; }).starts_with("E_FILE_COUNT: t.gltf: accessors[2]"));
    CHECK(with([](Json& d) { d["accessors"][0].erase("bufferView"); }) ==
          "E_FILE_SYNTAX: t.gltf: accessors[0] has no bufferView");
    CHECK(with([](Json& d) {
            d["bufferViews"][0]["byteLength"] = 5000;
          }).starts_with("E_FILE_COUNT: t.gltf: bufferViews[0] reaches past its buffer"));
    CHECK(with([](Json& d) {
            d["bufferViews"][0]["byteStride"] = 4;
          }).starts_with("E_FILE_FORMAT: t.gltf: bufferViews[0] has a byteStride of 4"));
    CHECK(with([](Json& d) {
            d["buffers"][0]["byteLength"] = 5000;
          }).starts_with("E_FILE_COUNT: t.gltf: buffers[0] promises 5000 bytes"));
    CHECK(with([](Json& d) { d["buffers"][0]["uri"] = "data:;base64,!!"; }) ==
          "E_FILE_SYNTAX: t.gltf: buffers[0].uri is no base64 data");
    CHECK(with([](Json& d) { d["buffers"][0].erase("uri"); }).starts_with("E_FILE_FORMAT: t.gltf: buffers[0] has no uri"));
    CHECK(with([](Json& d) {
            d["buffers"][0]["uri"] = "a.bin";
          }).starts_with("E_FILE_OPEN: t.gltf: buffers[0] lies in another file 'a.bin'"));
    CHECK(with([](Json& d) { d["nodes"][0]["children"] = {0}; }) ==
          "E_FILE_SYNTAX: t.gltf: nodes[0] is reached twice; nodes form trees");
    CHECK(with([](Json& d) { d["nodes"][0]["mesh"] = 3; }) ==
          "E_FILE_INDEX: t.gltf: a node names entry 3 of meshes, but there are 1");
    CHECK(with([](Json& d) { d["nodes"][0]["matrix"] = {1, 2}; }) == "E_FILE_SYNTAX: t.gltf: nodes[0].matrix needs 16 numbers");
    CHECK(with([](Json& d) { d["scenes"][0]["nodes"] = Json::array(); }) ==
          "E_FILE_EMPTY: t.gltf: the file holds no triangle in its scene");
    CHECK(refusal([] {
            parse("{", "gltf");
          }).starts_with("E_FILE_SYNTAX: t.gltf: the JSON is malformed: parse error at line 1, column 2"));
    CHECK(refusal([] {
            parse(std::string(200000, '['), "gltf");
          }).starts_with("E_FILE_FORMAT: t.gltf: the file starts with '[[[['"));
    CHECK(refusal([] { parse("{\"a\":" + std::string(200000, '[') + std::string(200000, ']') + "}", "gltf"); }) ==
          "E_FILE_SYNTAX: t.gltf: asset.version is missing");
  }

  TEST_CASE("a mesh in many nodes may not outgrow the file") {
    const int n = 1000;
    Points<double> points(n + 1, 3);
    std::vector<std::vector<int>> faces;
    for (int k = 0; k < n; ++k) {
      points.row(k + 1) << std::cos(k * 6.283185307179586 / n), std::sin(k * 6.283185307179586 / n), 0;
      faces.push_back({0, 1 + k, 1 + (k + 1) % n});
    }
    points.row(0).setZero();
    Json many = Json::parse(save_bytes(make_surface(points, faces), "gltf"));
    const auto repeat = [&](int times) {
      many["nodes"] = Json::array();
      many["scenes"][0]["nodes"] = Json::array();
      for (int k = 0; k < times; ++k) {
        many["nodes"].push_back({{"mesh", 0}, {"translation", {3 * k, 0, 0}}});
        many["scenes"][0]["nodes"].push_back(k);
      }
      return answer(many);
    };
    CHECK(repeat(20) == "accepted");
    CHECK(repeat(6000) ==
          "E_FILE_TOO_LARGE: t.gltf: the nodes repeat their meshes so often that the sum is out of proportion to the file");
  }

  TEST_CASE("a cut GLB is refused at every length") {
    const std::string good = save_bytes(tetrahedron(), "glb");
    for (std::size_t size = 0; size < good.size(); ++size) {
      CAPTURE(size);
      CHECK(refusal([&] { parse(good.substr(0, size), "glb"); }).starts_with("E_FILE_"));
    }
  }

  TEST_CASE("buffers in other files are read beside the file and nowhere else") {
    namespace fs = std::filesystem;
    const fs::path root = fs::temp_directory_path() / ("udcp-gltf-" + std::to_string(::getpid()));
    fs::create_directories(root / "in");
    const auto model = second_opinion(save_bytes(tetrahedron(), "gltf"), false);
    const std::string bytes(model.buffers[0].data.begin(), model.buffers[0].data.end());
    write_file(root / "in" / "my points.bin", bytes);
    write_file(root / "secret.bin", bytes);
    fs::create_symlink(root / "secret.bin", root / "in" / "link.bin");
    const auto load_with = [&](const std::string& uri) {
      Json changed = document();
      changed["buffers"][0]["uri"] = uri;
      write_file(root / "in" / "a.gltf", changed.dump());
      return refusal([&] { load<double>(root / "in" / "a.gltf"); });
    };
    CHECK(load_with("my%20points.bin") == "accepted");
    CHECK(load_with("../in/my points.bin") == "accepted");
    for (const std::string& uri : {std::string("../secret.bin"), std::string("%2e%2e/secret.bin"), std::string("link.bin")}) {
      CHECK(load_with(uri).find("outside the folder of the file") != std::string::npos);
    }
    for (const std::string& uri : {(root / "in" / "my points.bin").string(), std::string("file:///etc/passwd"),
                                   std::string("nothing.bin"), std::string("")}) {
      CHECK(load_with(uri).starts_with("E_FILE_OPEN"));
    }
    fs::remove_all(root);
  }
}
