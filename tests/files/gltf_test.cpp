// Reading glTF and GLB: our reader on our writer and on a file of others, node transforms, and files that lie about their
// contents.
#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>

#include "gltf_opinion.h"

using namespace udcp;
using namespace udcp::test;

namespace {

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

  TEST_CASE("the triangle of the Khronos tutorial is read") {
    const std::string text = R"({"scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}], "asset": {"version": "2.0"},
      "meshes": [{"primitives": [{"attributes": {"POSITION": 1}, "indices": 0}]}],
      "buffers": [{"byteLength": 44, "uri":
        "data:application/octet-stream;base64,AAABAAIAAAAAAAAAAAAAAAAAAAAAAIA/AAAAAAAAAAAAAAAAAACAPwAAAAA="}],
      "bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": 6, "target": 34963},
                      {"buffer": 0, "byteOffset": 8, "byteLength": 36, "target": 34962}],
      "accessors": [{"bufferView": 0, "byteOffset": 0, "componentType": 5123, "count": 3, "type": "SCALAR", "max": [2], "min": [0]},
                    {"bufferView": 1, "byteOffset": 0, "componentType": 5126, "count": 3, "type": "VEC3",
                     "max": [1, 1, 0], "min": [0, 0, 0]}]})";
    const auto triangle = parse(text, "gltf");
    Points<double> points(3, 3);
    points << 0, 0, 0, 1, 0, 0, 0, 1, 0;
    check_same(triangle, make_surface(points, {{0, 1, 2}}));
    CHECK(triangle.attributes.empty());
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

  TEST_CASE("what is not read cannot disturb") {
    Json changed = document();
    changed["meshes"][0]["primitives"][0]["extensions"]["KHR_draco_mesh_compression"]["bufferView"] = 99;
    changed["bufferViews"].push_back({{"buffer", 7}, {"byteOffset", std::uint64_t{1} << 50}, {"byteLength", "long"}});
    changed["accessors"].push_back({{"type", "MAT9"}, {"sparse", 1}});
    changed["buffers"].push_back({{"byteLength", 8}, {"uri", "/etc/passwd"}});
    changed["images"] = Json::parse(R"([{"bufferView": 3, "mimeType": "image/png"}, {"uri": "../secret.png"}, 5])");
    changed["materials"] = "none";
    changed["extensions"]["KHR_lights_punctual"]["lights"] = {1, 2};
    changed["nodes"][0]["extras"] = "deep";
    std::string text = changed.dump();
    text.replace(text.find("\"deep\""), 6, std::string(200000, '[') + std::string(200000, ']'));
    CHECK(parse_error(text, "gltf") == "accepted");
    changed["meshes"][0]["primitives"][0]["attributes"]["NORMAL"] = 3;
    CHECK(answer(changed) == "E_FILE_FORMAT: t.gltf: accessors[3] is sparse, which is not supported");
  }

  TEST_CASE("buffers may have another media type and more bytes than they promise") {
    Json changed = document();
    const auto uri = changed["buffers"][0]["uri"].get<std::string>();
    const std::string digits = uri.substr(uri.find(',') + 1);
    const auto length = changed["buffers"][0]["byteLength"].get<std::size_t>();
    for (const std::string start : {"data:;base64,", "data:model/vnd.udcp;x=1;base64,"}) {
      for (const std::string more : {"", "A", "AA", "AAA=", "AAAA", "===="}) {
        CAPTURE(more);
        changed["buffers"][0] = {{"byteLength", length}, {"uri", start + digits + more}};
        CHECK(answer(changed) == "accepted");
      }
    }
    for (std::size_t less = 1; less < 9; ++less) {
      changed["buffers"][0]["byteLength"] = length - less;
      CHECK(answer(changed) ==
            "E_FILE_COUNT: t.gltf: bufferViews[2] reaches past its buffer of " + std::to_string(length - less) + " bytes");
    }
    std::string glb = save_bytes(tetrahedron(), "glb");
    for (const std::size_t at : {std::size_t{8}, std::size_t{20} + word_at(glb, 12)}) {  // the file and its last chunk
      const std::uint32_t longer = word_at(glb, at) + 3;
      std::memcpy(glb.data() + at, &longer, 4);
    }
    CHECK(parse_error(glb + "xyz", "glb") == "accepted");
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
    CHECK(with([](Json& d) { d["nodes"][0]["mesh"] = std::uint64_t{1} << 32; }) ==
          "E_FILE_NUMBER: t.gltf: nodes[0].mesh is not a non-negative integer of reasonable size");
    CHECK(with([](Json& d) { d["meshes"][0]["primitives"][0]["mode"] = (std::uint64_t{1} << 32) + 4; }) ==
          "E_FILE_NUMBER: t.gltf: meshes[0].primitives[0].mode is not a non-negative integer of reasonable size");
    CHECK(with([](Json& d) { d["nodes"][0]["children"] = "none"; }) == "E_FILE_SYNTAX: t.gltf: nodes[0].children is not a list");
    CHECK(with([](Json& d) { d["bufferViews"][0]["byteStride"] = 14; }) ==
          "E_FILE_FORMAT: t.gltf: bufferViews[0] has a byteStride of 14; only 4, 8, ..., 252 are legal");
    CHECK(with([](Json& d) { d["buffers"][0]["byteLength"] = 0; }) == "E_FILE_COUNT: t.gltf: buffers[0] has no bytes");
    CHECK(with([](Json& d) { d["accessors"][1]["bufferView"] = 9; }) ==
          "E_FILE_INDEX: t.gltf: accessors[1].bufferView names entry 9 of bufferViews, but there are 3");
    CHECK(with([](Json& d) { d["scene"] = 1; }) == "E_FILE_INDEX: t.gltf: scene names entry 1 of scenes, but there are 1");
    CHECK(with([](Json& d) {
            d["scenes"] = Json::array();
            d["nodes"] = Json::array({5});
          }) == "E_FILE_SYNTAX: t.gltf: nodes[0] is not an object");
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
    std::string empty = R"({"asset": {"version": "2.0"}, "nodes": [{})";
    for (int k = 0; k < 1'000'000; ++k) empty += ",{}";
    CHECK(parse_error(empty + "]}", "gltf") == "E_FILE_TOO_LARGE: t.gltf: the lists of the file have more than 1000000 entries");
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
    const std::string bytes = second_opinion(save_bytes(tetrahedron(), "gltf"), false).bytes;
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
