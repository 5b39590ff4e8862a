// glTF 2.0 and GLB output by tinygltf: triangles with positions, normals and colours as floats; several shapes in one scene, or
// frames as morph targets with an animation of their weights. What is written passes the Khronos validator without errors and
// warnings.
#include <tiny_gltf.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>

#include "files/colour_map.h"
#include "files/raw_mesh.h"
#include "files/text_writer.h"

namespace udcp {
namespace {

enum Target { no_target = 0, vertex_data = TINYGLTF_TARGET_ARRAY_BUFFER, index_data = TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER };

/// Points and vectors as floats, three a row.
using Floats = std::vector<float>;

/// The text in UTF-8, with a replacement character for every byte that is not; tinygltf throws at such bytes.
std::string readable(const std::string& text) {
  using Json = nlohmann::json;
  return Json::parse(Json(text).dump(-1, ' ', false, Json::error_handler_t::replace)).get<std::string>();
}

/// The growing model and its one buffer.
class Document {
 public:
  Document() {
    model_.asset.generator = "udcp";
    model_.defaultScene = 0;
    model_.scenes.resize(1);
    model_.buffers.resize(1);
    tinygltf::Material material;
    material.pbrMetallicRoughness.metallicFactor = 0;
    material.pbrMetallicRoughness.roughnessFactor = 0.7;
    material.doubleSided = true;
    model_.materials.push_back(material);
  }

  tinygltf::Model& model() { return model_; }

  int add_floats(const Floats& values, int type, Target target, bool bounds) {
    const std::size_t start = bytes().size();
    for (const float value : values) put(std::bit_cast<std::uint32_t>(value), 4);
    const auto columns = static_cast<std::size_t>(tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(type)));
    const int index = add_accessor(start, TINYGLTF_COMPONENT_TYPE_FLOAT, values.size() / columns, type, target);
    if (bounds) add_bounds(model_.accessors.back(), values, columns);
    return index;
  }
  int add_colours(const std::vector<Colour>& colours) {
    const std::size_t start = bytes().size();
    for (const Colour& colour : colours) {
      for (const double channel : colour) put(static_cast<std::uint32_t>(std::lround(255 * channel)), 1);
      put(255, 1);
    }
    const int index = add_accessor(start, TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE, colours.size(), TINYGLTF_TYPE_VEC4, vertex_data);
    model_.accessors.back().normalized = true;
    return index;
  }
  int add_indices(const std::vector<std::array<int, 3>>& triangles, int vertices) {
    const std::size_t start = bytes().size();
    const bool small = vertices <= 65535;  // 65535 itself is not a legal index
    for (const auto& triangle : triangles) {
      for (const int v : triangle) put(static_cast<std::uint32_t>(v), small ? 2 : 4);
    }
    return add_accessor(start, small ? TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT : TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT,
                        3 * triangles.size(), TINYGLTF_TYPE_SCALAR, index_data);
  }

  std::string finish(bool binary) {
    expect_size(bytes().size());
    std::ostringstream out;
    const bool good = tinygltf::TinyGLTF().WriteGltfSceneToStream(&model_, out, !binary, binary);
    if (!good || !out) throw Error(ErrorKind::internal, "E_INTERNAL", "tinygltf cannot write the scene");
    if (binary) expect_size(out.view().size());
    return std::move(out).str();
  }

 private:
  std::vector<unsigned char>& bytes() { return model_.buffers[0].data; }
  void put(std::uint32_t value, std::size_t size) {
    for (std::size_t k = 0; k < size; ++k) bytes().push_back(static_cast<unsigned char>(value >> (8 * k) & 0xff));
  }
  /// tinygltf counts bytes in 32 bits and does not check.
  static void expect_size(std::size_t size) {
    if (size <= std::numeric_limits<std::uint32_t>::max()) return;
    throw Error(ErrorKind::limit, "E_TOO_LARGE", "a glTF file cannot hold more than 4 GiB", "refine less, or save as PLY");
  }
  int add_accessor(std::size_t start, int component, std::size_t count, int type, Target target) {
    tinygltf::BufferView view;
    view.buffer = 0;
    view.byteOffset = start;
    view.byteLength = bytes().size() - start;
    view.target = target;
    bytes().resize((bytes().size() + 3) / 4 * 4);
    tinygltf::Accessor accessor;
    accessor.bufferView = static_cast<int>(model_.bufferViews.size());
    accessor.componentType = component;
    accessor.count = count;
    accessor.type = type;
    model_.bufferViews.push_back(std::move(view));
    model_.accessors.push_back(std::move(accessor));
    return static_cast<int>(model_.accessors.size()) - 1;
  }
  static void add_bounds(tinygltf::Accessor& accessor, const Floats& values, std::size_t columns) {
    for (std::size_t c = 0; c < columns; ++c) {
      float least = values[c], most = values[c];
      for (std::size_t k = c; k < values.size(); k += columns) {
        least = std::min(least, values[k]);
        most = std::max(most, values[k]);
      }
      accessor.minValues.push_back(double{least});
      accessor.maxValues.push_back(double{most});
    }
  }

  tinygltf::Model model_;
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

std::vector<Colour> colours_of(const Surface<double>& surface, const SaveOptions& options) {
  const std::string& name = options.colour_attribute;
  const auto found = surface.attributes.find(name);
  if (found == surface.attributes.end()) {
    throw Error(ErrorKind::input, "E_ATTRIBUTE", "the surface has no attribute '" + name + "' to show as colour");
  }
  if (!std::ranges::all_of(found->second, [](double value) { return std::isfinite(value); })) {
    throw Error(ErrorKind::input, "E_NOT_FINITE", "attribute '" + name + "' has a value that is not finite; nothing was written");
  }
  const ColourScale scale = colour_scale(found->second, options.zero_matters);
  std::vector<Colour> result;
  for (const double value : found->second) result.push_back(linear(scale.at(value)));
  return result;
}

tinygltf::Value extras_of(const SaveOptions& options) {
  using tinygltf::Value;
  Value::Object extras, parameters;
  if (!options.word.empty()) extras.emplace("word", Value(readable(options.word)));
  for (const auto& [name, value] : options.parameters) parameters.emplace(readable(name), Value(readable(value)));
  if (!parameters.empty()) extras.emplace("parameters", Value(std::move(parameters)));
  return extras.empty() ? Value() : Value(std::move(extras));
}

/// Mesh and node of one shape.
void add_shape(Document& document, const SceneShape& shape) {
  const Surface<double>& surface = *shape.surface;
  check_for_floats(surface);
  tinygltf::Primitive primitive;
  primitive.mode = TINYGLTF_MODE_TRIANGLES;
  primitive.material = 0;
  primitive.attributes["POSITION"] = document.add_floats(positions_of(surface), TINYGLTF_TYPE_VEC3, vertex_data, true);
  primitive.attributes["NORMAL"] =
      document.add_floats(normals_of(surface, shape.options), TINYGLTF_TYPE_VEC3, vertex_data, false);
  if (!shape.options.colour_attribute.empty()) {
    primitive.attributes["COLOR_0"] = document.add_colours(colours_of(surface, shape.options));
  }
  primitive.indices = document.add_indices(triangles(surface), surface.mesh->vertices());
  tinygltf::Model& model = document.model();
  tinygltf::Mesh mesh;
  tinygltf::Node node;
  mesh.name = node.name = readable(shape.name);
  mesh.extras = extras_of(shape.options);
  mesh.primitives.push_back(std::move(primitive));
  node.mesh = static_cast<int>(model.meshes.size());
  if (shape.place != std::array<double, 3>{0, 0, 0}) node.translation.assign(shape.place.begin(), shape.place.end());
  model.scenes[0].nodes.push_back(static_cast<int>(model.nodes.size()));
  model.nodes.push_back(std::move(node));
  model.meshes.push_back(std::move(mesh));
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
  tinygltf::AnimationSampler sampler;
  sampler.input = document.add_floats(times, TINYGLTF_TYPE_SCALAR, no_target, true);
  sampler.output = document.add_floats(weights, TINYGLTF_TYPE_SCALAR, no_target, false);
  tinygltf::AnimationChannel channel;
  channel.sampler = 0;
  channel.target_node = 0;
  channel.target_path = "weights";
  tinygltf::Animation animation;
  animation.samplers.push_back(sampler);
  animation.channels.push_back(channel);
  document.model().animations.push_back(animation);
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
  tinygltf::Mesh& mesh = document.model().meshes[0];
  for (std::size_t k = 1; k < frames.size(); ++k) {
    const Floats moved = difference(positions_of(frames[k]), points), turned = difference(normals_of(frames[k], plain), normals);
    mesh.primitives[0].targets.push_back({{"POSITION", document.add_floats(moved, TINYGLTF_TYPE_VEC3, vertex_data, true)},
                                          {"NORMAL", document.add_floats(turned, TINYGLTF_TYPE_VEC3, vertex_data, false)}});
  }
  mesh.weights.assign(frames.size() - 1, 0.0);
  add_animation(document, frames.size(), frames_per_second);
  return document.finish(binary);
}

}  // namespace udcp
