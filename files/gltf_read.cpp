// glTF 2.0 and GLB input by tinygltf: triangle lists of the default scene with their node transforms, merged into one mesh. What
// tinygltf gets has been filtered; what it gives is checked here for indices and ranges before a byte is touched. Images,
// materials, skins and animations are not read.
#include <tiny_gltf.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <span>

#include "files/gltf_filter.h"
#include "files/raw_mesh.h"

namespace udcp {
namespace {

using Matrix = Eigen::Matrix4d;

/// `count` elements of `components` numbers each, `stride` bytes apart, all inside a buffer of the model.
struct GltfView {
  const unsigned char* data = nullptr;
  std::size_t count = 0, stride = 0;
  int component_type = 0, components = 0;

  [[nodiscard]] double real(std::size_t k, std::size_t c) const {
    float value = 0;
    std::memcpy(&value, data + k * stride + 4 * c, 4);
    return double{value};
  }
  [[nodiscard]] std::uint32_t index(std::size_t k) const {
    std::uint32_t value = 0;
    const std::size_t size = component_type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE    ? 1
                             : component_type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ? 2
                                                                                        : 4;
    for (std::size_t b = 0; b < size; ++b) value |= std::uint32_t{data[k * stride + b]} << (8 * b);
    return value;
  }
};

using Files = std::map<std::string, std::string>;

/// tinygltf sees no file system, only the buffers that the filter has found and read.
tinygltf::FsCallbacks callbacks(Files& files) {
  tinygltf::FsCallbacks result{};
  result.FileExists = [](const std::string& name, void* known) { return static_cast<const Files*>(known)->contains(name); };
  result.ExpandFilePath = [](const std::string& name, void*) { return name; };
  result.ReadWholeFile = [](std::vector<unsigned char>* bytes, std::string*, const std::string& name, void* known) {
    const std::string& found = static_cast<const Files*>(known)->at(name);
    bytes->assign(found.begin(), found.end());
    return true;
  };
  result.WriteWholeFile = [](std::string*, const std::string&, const std::vector<unsigned char>&, void*) { return false; };
  result.user_data = &files;
  return result;
}

tinygltf::Model load_model(const Input& input) {
  FilteredGltf filtered = filter_gltf(input);
  tinygltf::TinyGLTF loader;
  loader.SetFsCallbacks(callbacks(filtered.files));
  loader.RemoveImageLoader();
  tinygltf::Model model;
  std::string error, warning;
  const auto size = static_cast<unsigned>(filtered.bytes.size());  // the filter keeps it below 4 GiB
  const bool good = filtered.binary
                        ? loader.LoadBinaryFromMemory(&model, &error, &warning,
                                                      reinterpret_cast<const unsigned char*>(filtered.bytes.data()), size)
                        : loader.LoadASCIIFromString(&model, &error, &warning, filtered.bytes.data(), size, "");
  if (!good) input.fail(0, "E_FILE_SYNTAX", "tinygltf cannot read the file: " + in_quotes(error));
  return model;
}

/// Triangles before welding.
struct Triangles {
  std::vector<double> points, normals;  // three per point
  std::vector<int> corners;
  bool all_have_normals = true;
};

class GltfReader {
 public:
  explicit GltfReader(const Input& input) : input_(input), model_(load_model(input)) {}

  Triangles read() {
    if (model_.nodes.empty()) {
      for (std::size_t m = 0; m < model_.meshes.size(); ++m) add_mesh(static_cast<int>(m), Matrix::Identity());
    } else {
      std::vector<char> visited(model_.nodes.size(), 0);
      for (const int root : roots()) add_tree(root, visited);
    }
    if (result_.corners.empty()) fail("E_FILE_EMPTY", "the file holds no triangle in its scene");
    return std::move(result_);
  }

 private:
  [[nodiscard]] std::vector<int> roots() const;
  void add_tree(int root, std::vector<char>& visited);
  [[nodiscard]] Matrix transform(const tinygltf::Node& node, const std::string& name) const;
  void add_mesh(int index, const Matrix& transform);
  void add_primitive(const tinygltf::Primitive& primitive, const std::string& name, const Matrix& transform);
  void add_points(const GltfView& positions, const GltfView* normals, const std::string& name, const Matrix& transform);
  void add_corners(const tinygltf::Primitive& primitive, const std::string& name, std::size_t points, int first, bool mirrored);
  [[nodiscard]] GltfView view(int accessor, const std::string& what) const;
  [[nodiscard]] std::span<const unsigned char> bytes_of(const tinygltf::BufferView& view, const std::string& name) const;
  /// An entry of a list of the model; `where` names who asks for it.
  template <class T>
  const T& entry(const std::vector<T>& entries, const char* list, int index, const std::string& where) const {
    if (index < 0 || static_cast<std::size_t>(index) >= entries.size()) {
      fail("E_FILE_INDEX",
           where + " names entry " + std::to_string(index) + " of " + list + ", but there are " + std::to_string(entries.size()));
    }
    return entries[static_cast<std::size_t>(index)];
  }
  [[noreturn]] void fail(const char* code, const std::string& message, const std::string& help = {}) const {
    input_.fail(0, code, message, help);
  }

  const Input& input_;
  tinygltf::Model model_;
  Triangles result_;
};

/// The nodes of the default scene; without scenes, those that are nobody's child.
std::vector<int> GltfReader::roots() const {
  if (!model_.scenes.empty()) {
    return entry(model_.scenes, "scenes", std::max(model_.defaultScene, 0), "scene").nodes;
  }
  std::vector<char> is_child(model_.nodes.size(), 0);
  for (const tinygltf::Node& node : model_.nodes) {
    for (const int child : node.children) {
      if (const auto c = static_cast<std::size_t>(child); c < is_child.size()) is_child[c] = 1;
    }
  }
  std::vector<int> result;
  for (std::size_t n = 0; n < is_child.size(); ++n) {
    if (is_child[n] == 0) result.push_back(static_cast<int>(n));
  }
  return result;
}

void GltfReader::add_tree(int root, std::vector<char>& visited) {
  std::vector<std::pair<int, Matrix>> open{{root, Matrix::Identity()}};
  while (!open.empty()) {
    const auto [index, outer] = open.back();
    open.pop_back();
    const std::string name = "nodes[" + std::to_string(index) + "]";
    const tinygltf::Node& node = entry(model_.nodes, "nodes", index, "a node list");
    if (visited[static_cast<std::size_t>(index)]++ != 0) fail("E_FILE_SYNTAX", name + " is reached twice; nodes form trees");
    const Matrix inner = outer * transform(node, name);
    if (node.mesh != -1) add_mesh(node.mesh, inner);
    for (auto child = node.children.rbegin(); child != node.children.rend(); ++child) open.emplace_back(*child, inner);
  }
}

/// The lists of numbers are empty or of the right length: the filter takes no others.
Matrix GltfReader::transform(const tinygltf::Node& node, const std::string& name) const {
  Matrix result = Matrix::Identity();
  if (!node.matrix.empty()) {
    for (Eigen::Index k = 0; k < 16; ++k) result(k % 4, k / 4) = node.matrix.at(static_cast<std::size_t>(k));
    if (result(3, 0) != 0 || result(3, 1) != 0 || result(3, 2) != 0 || result(3, 3) != 1)
      fail("E_FILE_NUMBER", name + ".matrix is not affine");
    return result;
  }
  if (!node.rotation.empty()) {
    const double x = node.rotation.at(0), y = node.rotation.at(1), z = node.rotation.at(2), w = node.rotation.at(3);
    result.topLeftCorner<3, 3>() << 1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w),  //
        2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w),                              //
        2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y);
  }
  for (std::size_t c = 0; c < 3; ++c) {
    const auto column = static_cast<Eigen::Index>(c);
    if (!node.scale.empty()) result.col(column) *= node.scale.at(c);
    if (!node.translation.empty()) result(column, 3) = node.translation.at(c);
  }
  return result;
}

/// The elements of an accessor; the view lives as long as the model.
GltfView GltfReader::view(int index, const std::string& what) const {
  const tinygltf::Accessor& accessor = entry(model_.accessors, "accessors", index, what);
  const std::string name = "accessors[" + std::to_string(index) + "]";
  const tinygltf::BufferView& view = entry(model_.bufferViews, "bufferViews", accessor.bufferView, name);
  const std::string view_name = "bufferViews[" + std::to_string(accessor.bufferView) + "]";
  const auto bytes = bytes_of(view, view_name);
  GltfView result;
  result.component_type = accessor.componentType;
  result.components = tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(accessor.type));
  const int size = tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(accessor.componentType));
  if (size < 1 || result.components < 1) fail("E_FILE_FORMAT", name + " has no type that is understood here");
  const auto each = static_cast<std::size_t>(size) * static_cast<std::size_t>(result.components);
  result.count = accessor.count;
  result.stride = view.byteStride == 0 ? each : view.byteStride;
  if (result.stride < each)
    fail("E_FILE_FORMAT",
         view_name + " has a byteStride of " + std::to_string(result.stride) + ", which does not fit its elements");
  const std::size_t offset = accessor.byteOffset, length = bytes.size();
  const bool fits = result.count == 0 ||
                    (offset <= length && length - offset >= each && result.count - 1 <= (length - offset - each) / result.stride);
  if (!fits) {
    fail("E_FILE_COUNT", name + " promises " + std::to_string(result.count) + " elements of " + std::to_string(each) +
                             " bytes, but reaches past its view of " + std::to_string(length) + " bytes");
  }
  result.data = bytes.data() + std::min(offset, length);
  return result;
}

std::span<const unsigned char> GltfReader::bytes_of(const tinygltf::BufferView& view, const std::string& name) const {
  const std::vector<unsigned char>& bytes = entry(model_.buffers, "buffers", view.buffer, name).data;
  if (view.byteOffset > bytes.size() || view.byteLength > bytes.size() - view.byteOffset)
    fail("E_FILE_COUNT", name + " reaches past its buffer of " + std::to_string(bytes.size()) + " bytes");
  return {bytes.data() + view.byteOffset, view.byteLength};
}

void GltfReader::add_mesh(int index, const Matrix& transform) {
  const tinygltf::Mesh& mesh = entry(model_.meshes, "meshes", index, "a node");
  const std::string name = "meshes[" + std::to_string(index) + "]";
  std::size_t k = 0;
  for (const tinygltf::Primitive& primitive : mesh.primitives)
    add_primitive(primitive, name + ".primitives[" + std::to_string(k++) + "]", transform);
}

void GltfReader::add_primitive(const tinygltf::Primitive& primitive, const std::string& name, const Matrix& transform) {
  if (primitive.mode != TINYGLTF_MODE_TRIANGLES) {
    fail("E_FILE_FORMAT", name + " has mode " + std::to_string(primitive.mode) + "; only lists of triangles (4) are read",
         "export triangles");
  }
  const auto position = primitive.attributes.find("POSITION"), normal = primitive.attributes.find("NORMAL");
  if (position == primitive.attributes.end()) fail("E_FILE_SYNTAX", name + " has no POSITION");
  const GltfView positions = view(position->second, name + ".POSITION");
  if (positions.components != 3 || positions.component_type != TINYGLTF_COMPONENT_TYPE_FLOAT)
    fail("E_FILE_FORMAT", name + ".POSITION is not a list of three floats each");
  GltfView normals;
  const bool has_normals = normal != primitive.attributes.end();
  if (has_normals) {
    normals = view(normal->second, name + ".NORMAL");
    if (normals.components != 3 || normals.component_type != TINYGLTF_COMPONENT_TYPE_FLOAT || normals.count != positions.count)
      fail("E_FILE_FORMAT", name + ".NORMAL does not fit POSITION");
  }
  const int first = static_cast<int>(result_.points.size() / 3);
  // A mesh may stand in many nodes; the sum has to stay in proportion to the file.
  if (result_.points.size() / 3 + positions.count > 1'000'000 + 16 * input_.bytes.size()) {
    fail("E_FILE_TOO_LARGE", "the nodes repeat their meshes so often that the sum is out of proportion to the file");
  }
  const bool mirrored = transform.topLeftCorner<3, 3>()
                            .col(0)
                            .cross(transform.topLeftCorner<3, 3>().col(1))
                            .dot(transform.topLeftCorner<3, 3>().col(2)) < 0;
  add_points(positions, has_normals ? &normals : nullptr, name, transform);
  add_corners(primitive, name, positions.count, first, mirrored);
}

void GltfReader::add_points(const GltfView& positions, const GltfView* normals, const std::string& name,
                            const Matrix& transform) {
  const Eigen::Matrix3d linear = transform.topLeftCorner<3, 3>();
  Eigen::Matrix3d cofactors;  // turns normals, up to a positive factor
  cofactors << linear.col(1).cross(linear.col(2)), linear.col(2).cross(linear.col(0)), linear.col(0).cross(linear.col(1));
  if (cofactors.col(0).dot(linear.col(0)) < 0) cofactors = -cofactors;  // a mirror turns them round
  const bool plain = transform == Matrix::Identity();
  for (std::size_t k = 0; k < positions.count; ++k) {
    Eigen::Vector3d p(positions.real(k, 0), positions.real(k, 1), positions.real(k, 2));
    if (!plain) p = linear * p + transform.topRightCorner<3, 1>();
    if (!p.allFinite())
      fail("E_FILE_NUMBER", name + ": point " + std::to_string(k) + " has a coordinate that is not a finite number");
    result_.points.insert(result_.points.end(), p.data(), p.data() + 3);
    if (!normals) continue;
    Eigen::Vector3d n(normals->real(k, 0), normals->real(k, 1), normals->real(k, 2));
    if (!plain) n = (cofactors * n).eval();
    if (!plain && n.norm() > 0) n /= n.norm();
    if (!n.allFinite()) fail("E_FILE_NUMBER", name + ": normal " + std::to_string(k) + " is not finite");
    result_.normals.insert(result_.normals.end(), n.data(), n.data() + 3);
  }
  result_.all_have_normals = result_.all_have_normals && normals != nullptr;
}

void GltfReader::add_corners(const tinygltf::Primitive& primitive, const std::string& name, std::size_t points, int first,
                             bool mirrored) {
  GltfView indices;
  const bool indexed = primitive.indices != -1;
  if (indexed) {
    indices = view(primitive.indices, name + ".indices");
    const bool fits = indices.components == 1 && (indices.component_type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE ||
                                                  indices.component_type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ||
                                                  indices.component_type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT);
    if (!fits) fail("E_FILE_FORMAT", name + ".indices are not unsigned integers");
  }
  const std::size_t count = indexed ? indices.count : points;
  if (count % 3 != 0) fail("E_FILE_COUNT", name + " has " + std::to_string(count) + " corners, which is no multiple of 3");
  if (result_.corners.size() + count > 3'000'000 + 16 * input_.bytes.size()) {
    fail("E_FILE_TOO_LARGE", "the nodes repeat their meshes so often that the sum is out of proportion to the file");
  }
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t at = mirrored && k % 3 != 0 ? k + (k % 3 == 1 ? 1 : -std::size_t{1}) : k;
    const std::size_t v = indexed ? indices.index(at) : at;
    if (v >= points)
      fail("E_FILE_INDEX", name + ": corner " + std::to_string(at) + " names point " + std::to_string(v) + ", but there are " +
                               std::to_string(points));
    result_.corners.push_back(first + static_cast<int>(v));
  }
}

/// Triangles with two corners in one point have no area and would be no faces.
void drop_collapsed(std::vector<int>& corners, const Input& input) {
  std::size_t kept = 0;
  for (std::size_t k = 0; k + 2 < corners.size(); k += 3) {
    const int a = corners[k], b = corners[k + 1], c = corners[k + 2];
    if (a == b || b == c || c == a) continue;
    for (const int v : {a, b, c}) corners[kept++] = v;
  }
  if (kept < corners.size())
    input.warn(0, std::to_string((corners.size() - kept) / 3) + " triangles with two corners in the same point are dropped");
  corners.resize(kept);
}

}  // namespace

template <class S>
RawMesh<S> read_gltf(const Input& input) {
  const Triangles triangles = GltfReader(input).read();
  std::vector<int> kept;
  const std::vector<int> vertex = weld(triangles.points, kept);
  RawMesh<S> raw;
  for (const int k : kept) {
    for (std::size_t c = 0; c < 3; ++c)
      raw.coordinates.push_back(exact_from<S>(triangles.points[3 * static_cast<std::size_t>(k) + c]));
  }
  for (const int k : triangles.corners) raw.corners.push_back(vertex[static_cast<std::size_t>(k)]);
  drop_collapsed(raw.corners, input);
  for (std::size_t f = 1; 3 * f <= raw.corners.size(); ++f) raw.begin.push_back(static_cast<int>(3 * f));
  if (!triangles.all_have_normals) return raw;
  for (std::size_t k = 0; k < vertex.size(); ++k) {  // one normal per vertex, or none
    const auto first = static_cast<std::size_t>(kept[static_cast<std::size_t>(vertex[k])]);
    if (!std::equal(triangles.normals.begin() + static_cast<std::ptrdiff_t>(3 * k),
                    triangles.normals.begin() + static_cast<std::ptrdiff_t>(3 * k + 3),
                    triangles.normals.begin() + static_cast<std::ptrdiff_t>(3 * first))) {
      return raw;
    }
  }
  const char* names[] = {"nx", "ny", "nz"};
  for (std::size_t c = 0; c < 3; ++c) {
    for (const int k : kept)
      raw.attributes[names[c]].push_back(exact_from<S>(triangles.normals[3 * static_cast<std::size_t>(k) + c]));
  }
  return raw;
}

#define UDCP_READ_GLTF(S) template RawMesh<S> read_gltf<S>(const Input&);
UDCP_FOR_EACH_COORDINATE(UDCP_READ_GLTF)
#undef UDCP_READ_GLTF

}  // namespace udcp
