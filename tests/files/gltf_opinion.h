// A second reader of what is written as glTF, by the JSON library alone, and a shape to write. Shared by the tests of both
// directions.
#pragma once

#include <nlohmann/json.hpp>

#include "helpers.h"

namespace udcp::test {

using Json = nlohmann::json;

/// What another program sees: the JSON and the bytes of its one buffer.
struct Opinion {
  Json json;
  std::string bytes;
};

inline std::uint32_t word_at(const std::string& bytes, std::size_t at) {
  std::uint32_t value = 0;
  std::memcpy(&value, bytes.data() + at, 4);
  return value;
}

inline std::string from_base64(const std::string& text) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bits, bytes;
  for (const char c : text.substr(0, text.find('='))) {
    for (int bit = 5; bit >= 0; --bit) bits += (digits.find(c) >> bit & 1) != 0 ? '1' : '0';
  }
  for (std::size_t k = 0; k + 8 <= bits.size(); k += 8) bytes += static_cast<char>(std::stoi(bits.substr(k, 8), nullptr, 2));
  return bytes;
}

inline Opinion second_opinion(const std::string& file, bool binary) {
  Opinion result;
  if (binary) {
    REQUIRE(file.size() > 28);
    const std::size_t json = word_at(file, 12), bytes = word_at(file, 20 + json);
    CHECK(file.substr(0, 4) == "glTF");
    CHECK(word_at(file, 4) == 2);
    CHECK(word_at(file, 8) == file.size());
    CHECK(json % 4 == 0);
    CHECK(bytes % 4 == 0);
    CHECK(file.substr(16, 4) == "JSON");
    CHECK(file.substr(24 + json, 4) == std::string("BIN\0", 4));
    REQUIRE(28 + json + bytes == file.size());
    result = {Json::parse(file.substr(20, json)), file.substr(28 + json)};
  } else {
    const std::string start = "data:application/octet-stream;base64,";
    result.json = Json::parse(file);
    const auto uri = result.json["buffers"][0]["uri"].get<std::string>();
    REQUIRE(uri.starts_with(start));
    result.bytes = from_base64(uri.substr(start.size()));
  }
  CHECK(result.json["asset"]["version"] == "2.0");
  CHECK(result.json["buffers"].size() == 1);
  CHECK(result.json["buffers"][0]["byteLength"] == result.bytes.size());
  return result;
}

/// Where the elements of an accessor start in the buffer.
inline std::size_t start_of(const Opinion& opinion, const Json& accessor) {
  const Json& view = opinion.json["bufferViews"][accessor["bufferView"].get<std::size_t>()];
  return view.value("byteOffset", std::size_t{0}) + accessor.value("byteOffset", std::size_t{0});
}

inline std::vector<double> floats(const Opinion& opinion, const Json& index) {
  const Json& accessor = opinion.json["accessors"][index.get<std::size_t>()];
  CHECK(accessor["componentType"] == 5126);
  std::vector<float> values(accessor["count"].get<std::size_t>() * (accessor["type"] == "VEC3" ? 3 : 1));
  REQUIRE(start_of(opinion, accessor) + 4 * values.size() <= opinion.bytes.size());
  std::memcpy(values.data(), opinion.bytes.data() + start_of(opinion, accessor), 4 * values.size());
  return {values.begin(), values.end()};
}

/// A tetrahedron, which no triangulation changes.
inline Surface<double> tetrahedron() {
  Points<double> points(4, 3);
  points << 1, 1, 1, 1, -1, -1, -1, 1, -1, -1, -1, 1;
  return make_surface(points, {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}});
}

}  // namespace udcp::test
