// glTF 2.0 and GLB output: triangles with positions, normals and colours as floats; several shapes in one scene, or frames as
// morph targets with an animation of their weights. What is written passes the Khronos validator without errors and warnings.
#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "files/colour_map.h"
#include "files/raw_mesh.h"
#include "files/text_writer.h"

namespace udcp {
namespace {

using Json = nlohmann::ordered_json;

enum Target { no_target = 0, vertex_data = 34962, index_data = 34963 };

constexpr int type_ubyte = 5121, type_ushort = 5123, type_uint = 5125, type_float = 5126;

/// Points and vectors as floats, three a row.
using Floats = std::vector<float>;

void put(std::string& bytes, std::uint32_t value, std::size_t size = 4) {
  for (std::size_t k = 0; k < size; ++k) bytes.push_back(static_cast<char>(value >> (8 * k) & 0xff));
}

/// The growing document and its one buffer.
class Document {
 public:
  Document() {
    root_["asset"] = {{"version", "2.0"}, {"generator", "udcp"}};
    root_["scene"] = 0;
    root_["scenes"] = Json::array({{{"nodes", Json::array()}}});
    root_["nodes"] = Json::array();
    root_["materials"] =
        Json::array({{{"pbrMetallicRoughness", {{"metallicFactor", 0.0}, {"roughnessFactor", 0.7}}}, {"doubleSided", true}}});
    root_["meshes"] = Json::array();
  }

  Json& operator[](const char* key) { return root_[key]; }

  int add_floats(const Floats& values, int columns, Target target, bool bounds) {
    const std::size_t start = bytes_.size();
    for (const float value : values) put(bytes_, std::bit_cast<std::uint32_t>(value));
    const int index = add_accessor(start, type_float, values.size() / static_cast<std::size_t>(columns), columns, target);
    if (bounds) add_bounds(accessors_.back(), values, static_cast<std::size_t>(columns));
    return index;
  }
  int add_colours(const std::vector<Colour>& colours) {
    const std::size_t start = bytes_.size();
    for (const Colour& colour : colours) {
      for (const double channel : colour) bytes_.push_back(static_cast<char>(std::lround(255 * channel)));
      bytes_.push_back('\xff');
    }
    const int index = add_accessor(start, type_ubyte, colours.size(), 4, vertex_data);
    accessors_.back()["normalized"] = true;
    return index;
  }
  int add_indices(const std::vector<std::array<int, 3>>& triangles, int vertices) {
    const std::size_t start = bytes_.size();
    const bool small = vertices <= 65535;  // 65535 itself is not a legal index
    for (const auto& triangle : triangles) {
      for (const int v : triangle) put(bytes_, static_cast<std::uint32_t>(v), small ? 2 : 4);
    }
    return add_accessor(start, small ? type_ushort : type_uint, 3 * triangles.size(), 1, index_data);
  }

  std::string finish(bool binary) {
    root_["accessors"] = accessors_;
    root_["bufferViews"] = views_;
    Json buffer{{"byteLength", bytes_.size()}};
    if (!binary) buffer["uri"] = "data:application/octet-stream;base64," + base64();
    root_["buffers"] = Json::array({buffer});
    std::string text = root_.dump(binary ? -1 : 1, ' ', false, Json::error_handler_t::replace);
    if (!binary) return text + "\n";
    text.resize((text.size() + 3) / 4 * 4, ' ');
    const std::size_t total = 12 + 8 + text.size() + 8 + bytes_.size();
    if (total > std::numeric_limits<std::uint32_t>::max()) {
      throw Error(ErrorKind::limit, "E_TOO_LARGE", "a GLB file cannot hold more than 4 GiB", "refine less, or save as PLY");
    }
    std::string out = "glTF";
    out.reserve(total);
    put(out, 2);
    put(out, static_cast<std::uint32_t>(total));
    put(out, static_cast<std::uint32_t>(text.size()));
    out += "JSON" + text;
    put(out, static_cast<std::uint32_t>(bytes_.size()));
    return (out += std::string("BIN\0", 4)) += bytes_;
  }

 private:
  int add_accessor(std::size_t start, int component, std::size_t count, int columns, Target target) {
    Json view{{"buffer", 0}, {"byteOffset", start}, {"byteLength", bytes_.size() - start}};
    if (target != no_target) view["target"] = static_cast<int>(target);
    bytes_.resize((bytes_.size() + 3) / 4 * 4, '\0');
    const char* types[] = {"", "SCALAR", "VEC2", "VEC3", "VEC4"};
    accessors_.push_back(
        {{"bufferView", views_.size()}, {"componentType", component}, {"count", count}, {"type", types[columns]}});
    views_.push_back(view);
    return static_cast<int>(accessors_.size()) - 1;
  }
  static void add_bounds(Json& accessor, const Floats& values, std::size_t columns) {
    Json low = Json::array(), high = Json::array();
    for (std::size_t c = 0; c < columns; ++c) {
      float least = values[c], most = values[c];
      for (std::size_t k = c; k < values.size(); k += columns) {
        least = std::min(least, values[k]);
        most = std::max(most, values[k]);
      }
      low.push_back(double{least});
      high.push_back(double{most});
    }
    accessor["min"] = low;
    accessor["max"] = high;
  }
  [[nodiscard]] std::string base64() const {
    constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string out;
    for (std::size_t k = 0; k < bytes_.size(); k += 3) {
      std::uint32_t bits = 0;
      const std::size_t have = std::min<std::size_t>(3, bytes_.size() - k);
      for (std::size_t b = 0; b < 3; ++b) bits = bits << 8 | (b < have ? static_cast<unsigned char>(bytes_[k + b]) : 0U);
      for (std::size_t d = 0; d < 4; ++d) out += d <= have ? digits[bits >> (18 - 6 * d) & 63] : '=';
    }
    return out;
  }

  Json root_, accessors_ = Json::array(), views_ = Json::array();
  std::string bytes_;
};

Floats positions_of(const Surface<double>& surface) {
  Floats result;
  result.reserve(3 * static_cast<std::size_t>(surface.points.rows()));
  for (Eigen::Index v = 0; v < surface.points.rows(); ++v) {
    for (Eigen::Index c = 0; c < 3; ++c) result.push_back(static_cast<float>(coordinate(surface.points, v, c)));
  }
  return result;
}

/// Unit normals: those given, elsewhere area-weighted ones, elsewhere up.
Floats normals_of(const Surface<double>& surface, const SaveOptions& options) {
  if (options.normals && (options.normals->rows() != surface.points.rows() || options.normals->cols() != 3)) {
    throw Error(ErrorKind::input, "E_POINTS",
                "the normals do not fit the surface: one row of three numbers per vertex is needed");
  }
  const Points<double> weighted = area_normals(surface);
  Floats result;
  result.reserve(3 * static_cast<std::size_t>(weighted.rows()));
  for (Eigen::Index v = 0; v < weighted.rows(); ++v) {
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();
    if (options.normals) normal = options.normals->row(v).transpose().stableNormalized();
    if (!(normal.norm() > 0.5)) normal = weighted.row(v).transpose().stableNormalized();
    if (!(normal.norm() > 0.5)) normal = Eigen::Vector3d::UnitZ();
    for (Eigen::Index c = 0; c < 3; ++c) result.push_back(static_cast<float>(normal(c)));
  }
  return result;
}

std::vector<Colour> colours_of(const Surface<double>& surface, const std::string& name) {
  const auto found = surface.attributes.find(name);
  if (found == surface.attributes.end()) {
    throw Error(ErrorKind::input, "E_ATTRIBUTE", "the surface has no attribute '" + name + "' to show as colour");
  }
  const auto [low, high] = std::ranges::minmax(found->second);
  if (!std::ranges::all_of(found->second, [](double value) { return std::isfinite(value); })) {
    throw Error(ErrorKind::input, "E_NOT_FINITE", "attribute '" + name + "' has a value that is not finite; nothing was written");
  }
  std::vector<Colour> result;
  const double range = high / 2 - low / 2;  // halves: the difference of two large numbers may overflow
  for (const double value : found->second) result.push_back(linear(colour_map(range > 0 ? (value / 2 - low / 2) / range : 0.5)));
  return result;
}

Json extras_of(const SaveOptions& options) {
  Json extras = Json::object();
  if (!options.word.empty()) extras["word"] = options.word;
  if (!options.parameters.empty()) extras["parameters"] = options.parameters;
  return extras;
}

/// Mesh and node of one shape; returns the primitive for whoever adds targets.
void add_shape(Document& document, const SceneShape& shape) {
  const Surface<double>& surface = *shape.surface;
  check_for_floats(surface);
  Json attributes;
  attributes["POSITION"] = document.add_floats(positions_of(surface), 3, vertex_data, true);
  attributes["NORMAL"] = document.add_floats(normals_of(surface, shape.options), 3, vertex_data, false);
  if (!shape.options.colour_attribute.empty()) {
    attributes["COLOR_0"] = document.add_colours(colours_of(surface, shape.options.colour_attribute));
  }
  const int indices = document.add_indices(triangles(surface), surface.mesh->vertices());
  Json mesh{{"primitives", Json::array({{{"attributes", attributes}, {"indices", indices}, {"material", 0}}})}};
  Json node{{"mesh", document["meshes"].size()}};
  if (!shape.name.empty()) mesh["name"] = node["name"] = shape.name;
  if (const Json extras = extras_of(shape.options); !extras.empty()) mesh["extras"] = extras;
  if (shape.place != std::array<double, 3>{0, 0, 0}) node["translation"] = shape.place;
  document["scenes"][0]["nodes"].push_back(document["nodes"].size());
  document["nodes"].push_back(node);
  document["meshes"].push_back(mesh);
}

Floats difference(const Floats& a, const Floats& b) {
  Floats result(a.size());
  std::ranges::transform(a, b, result.begin(), std::minus<>());
  return result;
}

void check_frames(const std::vector<Surface<double>>& frames, double frames_per_second) {
  if (frames.empty()) throw Error(ErrorKind::input, "E_ANIMATION", "an animation needs at least one frame");
  if (!(frames_per_second > 0) || !std::isfinite(frames_per_second)) {
    throw Error(ErrorKind::input, "E_ANIMATION", "the number of frames per second must be positive");
  }
  for (std::size_t k = 0; k < frames.size(); ++k) {
    check_for_floats(frames[k]);
    const Mesh &first = *frames[0].mesh, &mesh = *frames[k].mesh;
    if (first.face_begin == mesh.face_begin && first.vertex == mesh.vertex) continue;
    throw Error(ErrorKind::input, "E_ANIMATION",
                "frame " + std::to_string(k) + " has other faces than frame 0; morph targets need the same connectivity",
                "keep the cage and the number of rounds the same in all frames");
  }
}

/// Frame k > 0 is morph target k - 1; at its time its weight is 1 and all others are 0.
void add_animation(Document& document, std::size_t frames, double frames_per_second) {
  Floats times, weights;
  for (std::size_t k = 0; k < frames; ++k) {
    times.push_back(static_cast<float>(static_cast<double>(k) / frames_per_second));
    for (std::size_t target = 1; target < frames; ++target) weights.push_back(target == k ? 1.0F : 0.0F);
  }
  const int input = document.add_floats(times, 1, no_target, true), output = document.add_floats(weights, 1, no_target, false);
  document["animations"] =
      Json::array({{{"channels", Json::array({{{"sampler", 0}, {"target", {{"node", 0}, {"path", "weights"}}}}})},
                    {"samplers", Json::array({{{"input", input}, {"interpolation", "LINEAR"}, {"output", output}}})}}});
}

}  // namespace

std::string write_gltf(const std::vector<SceneShape>& shapes, bool binary) {
  if (shapes.empty()) throw Error(ErrorKind::input, "E_NO_FACES", "there is no shape to save");
  Document document;
  for (const SceneShape& shape : shapes) add_shape(document, shape);
  return document.finish(binary);
}

std::string write_gltf_animation(const std::vector<Surface<double>>& frames, bool binary, const SaveOptions& options,
                                 double frames_per_second) {
  check_frames(frames, frames_per_second);
  Document document;
  add_shape(document, {&frames[0], {}, {0, 0, 0}, options});
  if (frames.size() == 1) return document.finish(binary);
  const Floats points = positions_of(frames[0]), normals = normals_of(frames[0], options);
  SaveOptions plain = options;
  plain.normals = nullptr;  // they belong to frame 0
  Json targets = Json::array();
  for (std::size_t k = 1; k < frames.size(); ++k) {
    const int moved = document.add_floats(difference(positions_of(frames[k]), points), 3, vertex_data, true);
    const int turned = document.add_floats(difference(normals_of(frames[k], plain), normals), 3, vertex_data, false);
    targets.push_back({{"POSITION", moved}, {"NORMAL", turned}});
  }
  document["meshes"][0]["primitives"][0]["targets"] = targets;
  document["meshes"][0]["weights"] = std::vector<double>(frames.size() - 1, 0.0);
  add_animation(document, frames.size(), frames_per_second);
  return document.finish(binary);
}

}  // namespace udcp
