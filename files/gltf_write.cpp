// glTF 2.0 and GLB output by tinygltf: triangles with positions, normals and colours as floats; several shapes in one scene, or
// frames as morph targets with an animation of their weights. What is written passes the Khronos validator without errors and
// warnings.
#include <tiny_gltf.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>
#include <sstream>

#include "files/colour_map.h"
#include "files/gltf_container.h"
#include "files/raw_mesh.h"

namespace udcp {
namespace {

enum Target { no_target = 0, vertex_data = TINYGLTF_TARGET_ARRAY_BUFFER, index_data = TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER };

using Json = nlohmann::json;
using Floats = std::vector<float>;

/// The text in UTF-8, with a replacement character for every byte that is not; tinygltf throws at such bytes.
std::string readable(const std::string& text) {
  return Json::parse(Json(text).dump(-1, ' ', false, Json::error_handler_t::replace)).get<std::string>();
}

/// A part of the buffer: how many bytes, and who writes them when their turn comes.
struct Part {
  std::size_t size;
  std::function<void(Writer&)> write;
};

/// The growing model, and the parts of its one buffer. tinygltf makes the JSON; the buffer never exists as a whole.
class Document {
 public:
  Document() {
    model_.asset.generator = "udcp";
    model_.defaultScene = 0;
    model_.scenes.resize(1);
    tinygltf::Material material;
    material.pbrMetallicRoughness.metallicFactor = 0;
    material.pbrMetallicRoughness.roughnessFactor = 0.7;
    material.doubleSided = true;
    model_.materials.push_back(material);
  }

  tinygltf::Model& model() { return model_; }

  template <class R>
  int add_points(const MeshView<R>& mesh) {
    const int index = add(12 * mesh.vertices(), TINYGLTF_COMPONENT_TYPE_FLOAT, mesh.vertices(), TINYGLTF_TYPE_VEC3, vertex_data,
                          [mesh](Writer& out) { write_floats(out, mesh); });
    add_bounds<3>(mesh.points);
    return index;
  }
  template <class R>
  int add_normals(const MeshView<R>& mesh) {
    return add(12 * mesh.vertices(), TINYGLTF_COMPONENT_TYPE_FLOAT, mesh.vertices(), TINYGLTF_TYPE_VEC3, vertex_data,
               [mesh](Writer& out) { write_unit_normals(out, mesh); });
  }
  int add_floats(Floats values, int type, Target target, bool bounds) {
    const std::size_t columns = type == TINYGLTF_TYPE_VEC3 ? 3 : 1, size = 4 * values.size(), count = values.size() / columns;
    const auto kept = std::make_shared<const Floats>(std::move(values));
    const int index = add(size, TINYGLTF_COMPONENT_TYPE_FLOAT, count, type, target,
                          [kept](Writer& out) { out.write(std::span<const float>(*kept)); });
    if (bounds && columns == 3) add_bounds<3>(std::span<const float>(*kept));
    if (bounds && columns == 1) add_bounds<1>(std::span<const float>(*kept));
    return index;
  }
  int add_colours(std::vector<Colour> colours) {
    const std::size_t count = colours.size();
    const auto write = [kept = std::move(colours)](Writer& out) {
      for (const Colour& colour : kept) {
        for (const double channel : colour) out << static_cast<char>(std::lround(255 * channel));
        out << '\xff';
      }
    };
    const int index = add(4 * count, TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE, count, TINYGLTF_TYPE_VEC4, vertex_data, write);
    model_.accessors.back().normalized = true;
    return index;
  }
  template <class R>
  int add_indices(const MeshView<R>& mesh) {
    const std::size_t count = 3 * mesh.triangles();
    if (mesh.vertices() <= 65535) {  // 65535 itself is not a legal index
      return add(2 * count, TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT, count, TINYGLTF_TYPE_SCALAR, index_data,
                 [mesh](Writer& out) { write_indices<std::uint16_t>(out, mesh); });
    }
    return add(4 * count, TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT, count, TINYGLTF_TYPE_SCALAR, index_data,
               [mesh](Writer& out) { write_indices<std::uint32_t>(out, mesh); });
  }

  void write(Writer& out, bool binary);

 private:
  int add(std::size_t size, int component, std::size_t count, int type, Target target, std::function<void(Writer&)> write) {
    tinygltf::BufferView view;
    view.buffer = 0;
    view.byteOffset = size_;
    view.byteLength = size;
    view.target = target;
    tinygltf::Accessor accessor;
    accessor.bufferView = static_cast<int>(model_.bufferViews.size());
    accessor.componentType = component;
    accessor.count = count;
    accessor.type = type;
    model_.bufferViews.push_back(std::move(view));
    model_.accessors.push_back(std::move(accessor));
    parts_.push_back({size, std::move(write)});
    size_ += (size + 3) / 4 * 4;
    return static_cast<int>(model_.accessors.size()) - 1;
  }
  /// As the floats that are written: rounding keeps the order.
  template <std::size_t columns, class R>
  void add_bounds(std::span<const R> values) {
    std::array<R, columns> least, most;
    std::copy_n(values.begin(), columns, least.begin());
    most = least;
    for (std::size_t k = 0; k + columns <= values.size(); k += columns) {
      for (std::size_t c = 0; c < columns; ++c) {
        least[c] = std::min(least[c], values[k + c]);
        most[c] = std::max(most[c], values[k + c]);
      }
    }
    tinygltf::Accessor& accessor = model_.accessors.back();
    for (std::size_t c = 0; c < columns; ++c) {
      accessor.minValues.push_back(double{static_cast<float>(least[c])});
      accessor.maxValues.push_back(double{static_cast<float>(most[c])});
    }
  }
  template <class Index, class R>
  static void write_indices(Writer& out, const MeshView<R>& mesh) {
    constexpr std::size_t size = 3 * sizeof(Index), block = 4096 * size;
    char* to = out.room(block);
    const char* stop = to + block;
    for_each_triangle(mesh, [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
      if (to == stop) {
        out.filled(to);
        to = out.room(block);
        stop = to + block;
      }
      for (const std::uint32_t v : {a, b, c}) to = put_bytes(to, static_cast<Index>(v));
    });
    out.filled(to);
  }
  [[nodiscard]] std::string json(const std::string& uri, int indent) const;
  void write_buffer(Writer& out) const;

  tinygltf::Model model_;
  std::vector<Part> parts_;
  std::size_t size_ = 0;  // of the buffer so far
};

void expect_size(std::size_t size) {
  if (size <= std::numeric_limits<std::uint32_t>::max()) return;
  throw Error(ErrorKind::limit, "E_TOO_LARGE", "a glTF file cannot hold more than 4 GiB", "refine less, or save as PLY");
}

/// The model as text, with the buffer that tinygltf does not know of.
std::string Document::json(const std::string& uri, int indent) const {
  std::ostringstream out;
  if (!tinygltf::TinyGLTF().WriteGltfSceneToStream(&model_, out, false, false))
    throw Error(ErrorKind::internal, "E_INTERNAL", "tinygltf cannot write the scene");
  Json all = Json::parse(out.view());
  Json buffer{{"byteLength", size_}};
  if (!uri.empty()) buffer["uri"] = uri;
  all["buffers"] = Json::array({buffer});
  return all.dump(indent);
}

void Document::write_buffer(Writer& out) const {
  for (const Part& part : parts_) {
    part.write(out);
    for (std::size_t k = part.size; k % 4 != 0; ++k) out << '\0';
  }
}

void Document::write(Writer& out, bool binary) {
  expect_size(size_);
  if (binary) {
    std::string text = json({}, -1);
    text.resize((text.size() + 3) / 4 * 4, ' ');
    expect_size(28 + text.size() + size_);
    out << glb_head(text, size_);
    write_buffer(out);
    return;
  }
  Writer bytes(size_);
  write_buffer(bytes);
  const std::string mark = "base64,", text = json("data:application/octet-stream;" + mark, 2);
  const std::size_t place = text.find(mark + "\"") + mark.size();  // no text of a user stands before it
  out << std::string_view(text).substr(0, place);
  write_base64(out, bytes.take());
  out << std::string_view(text).substr(place) << '\n';
}

std::vector<Colour> colours_of(const Surface<double>* surface, const SaveOptions& options) {
  const std::string& name = options.colour_attribute;
  const std::map<std::string, std::vector<double>> none;
  const auto& attributes = surface ? surface->attributes : none;
  const auto found = attributes.find(name);
  if (found == attributes.end()) {
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

/// The largest size is known before anything is written or even checked.
template <class R>
void expect_room(const MeshView<R>& mesh) {
  expect_size(24 * mesh.vertices() + 3 * mesh.triangles() * (mesh.vertices() <= 65535 ? 2 : 4));
}

/// Mesh and node of one shape, which must live as long as the document.
template <class R>
void add_shape(Document& document, const MeshView<R>& shape, const std::string& name, const std::array<double, 3>& place,
               const SaveOptions& options) {
  expect_room(shape);
  check_for_floats(shape);
  tinygltf::Primitive primitive;
  primitive.mode = TINYGLTF_MODE_TRIANGLES;
  primitive.material = 0;
  primitive.attributes["POSITION"] = document.add_points(shape);
  primitive.attributes["NORMAL"] = document.add_normals(shape);
  if (!options.colour_attribute.empty()) {
    primitive.attributes["COLOR_0"] = document.add_colours(colours_of(shape.surface, options));
  }
  primitive.indices = document.add_indices(shape);
  tinygltf::Model& model = document.model();
  tinygltf::Mesh mesh;
  tinygltf::Node node;
  mesh.name = node.name = readable(name);
  mesh.extras = extras_of(options);
  mesh.primitives.push_back(std::move(primitive));
  node.mesh = static_cast<int>(model.meshes.size());
  if (place != std::array<double, 3>{0, 0, 0}) node.translation.assign(place.begin(), place.end());
  model.scenes[0].nodes.push_back(static_cast<int>(model.nodes.size()));
  model.nodes.push_back(std::move(node));
  model.meshes.push_back(std::move(mesh));
}

/// What a writer makes, as floats.
template <class F>
Floats floats_from(std::size_t count, F write) {
  Writer out(4 * count);
  write(out);
  const std::string bytes = out.take();
  Floats result(count);
  std::memcpy(result.data(), bytes.data(), 4 * count);
  return result;
}
Floats positions_of(const MeshView<double>& mesh) {
  return floats_from(mesh.points.size(), [&](Writer& out) { write_floats(out, mesh); });
}
Floats normals_of(const MeshView<double>& mesh) {
  return floats_from(mesh.points.size(), [&](Writer& out) { write_unit_normals(out, mesh); });
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
    Points<double> padded;
    check_for_floats(view_of(frames[k], {}, padded));
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

void write_gltf(Writer& out, const std::vector<SceneShape>& shapes, bool binary) {
  if (shapes.empty()) throw Error(ErrorKind::input, "E_NO_FACES", "there is no shape to save");
  Document document;
  std::vector<Points<double>> padded(shapes.size());
  for (std::size_t k = 0; k < shapes.size(); ++k) {
    const SceneShape& shape = shapes[k];
    add_shape(document, view_of(*shape.surface, shape.options, padded[k]), shape.name, shape.place, shape.options);
  }
  document.write(out, binary);
}

template <class R>
void write_gltf(Writer& out, const MeshView<R>& mesh, const SaveOptions& options, bool binary) {
  Document document;
  add_shape(document, mesh, {}, {0, 0, 0}, options);
  document.write(out, binary);
}

void write_gltf_animation(Writer& out, const std::vector<Surface<double>>& frames, bool binary, const SaveOptions& options,
                          double frames_per_second) {
  check_frames(frames, frames_per_second);
  Document document;
  Points<double> padded, padded_frame;
  const MeshView<double> first = view_of(frames[0], options, padded);
  add_shape(document, first, {}, {0, 0, 0}, options);
  if (frames.size() == 1) return document.write(out, binary);
  const Floats points = positions_of(first), normals = normals_of(first);
  SaveOptions plain = options;
  plain.normals = nullptr;  // they belong to frame 0
  tinygltf::Mesh& mesh = document.model().meshes[0];
  for (std::size_t k = 1; k < frames.size(); ++k) {
    const MeshView<double> frame = view_of(frames[k], plain, padded_frame);
    const Floats moved = difference(positions_of(frame), points), turned = difference(normals_of(frame), normals);
    mesh.primitives[0].targets.push_back({{"POSITION", document.add_floats(moved, TINYGLTF_TYPE_VEC3, vertex_data, true)},
                                          {"NORMAL", document.add_floats(turned, TINYGLTF_TYPE_VEC3, vertex_data, false)}});
  }
  mesh.weights.assign(frames.size() - 1, 0.0);
  add_animation(document, frames.size(), frames_per_second);
  document.write(out, binary);
}

template void write_gltf(Writer&, const MeshView<float>&, const SaveOptions&, bool);
template void write_gltf(Writer&, const MeshView<double>&, const SaveOptions&, bool);

}  // namespace udcp
