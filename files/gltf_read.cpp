// glTF 2.0 and GLB input: triangle lists of the default scene with their node transforms, merged into one mesh. Images,
// materials, skins and animations are not read.
#include <Eigen/Geometry>
#include <cmath>

#include "files/gltf_document.h"
#include "files/raw_mesh.h"

namespace udcp {
namespace {

using Json = GltfDocument::Json;
using Matrix = Eigen::Matrix4d;

/// Triangles before welding.
struct Triangles {
  std::vector<double> points, normals;  // three per point
  std::vector<int> corners;
  bool all_have_normals = true;
};

class GltfReader {
 public:
  explicit GltfReader(const Input& input) : document_(input) {}

  Triangles read() {
    std::vector<char> visited(document_.size("nodes"), 0);
    if (visited.empty()) {
      for (std::size_t m = 0; m < document_.size("meshes"); ++m) add_mesh(m, Matrix::Identity());
    } else {
      for (const std::size_t root : roots()) add_tree(root, visited);
    }
    if (result_.corners.empty()) document_.fail("E_FILE_EMPTY", "the file holds no triangle in its scene");
    return std::move(result_);
  }

 private:
  [[nodiscard]] std::vector<std::size_t> roots() const;
  void add_tree(std::size_t root, std::vector<char>& visited);
  [[nodiscard]] Matrix transform(const Json& node, const std::string& name) const;
  void add_mesh(std::size_t index, const Matrix& transform);
  void add_primitive(const Json& primitive, const std::string& name, const Matrix& transform);
  void add_points(const GltfView& positions, const GltfView* normals, const std::string& name, const Matrix& transform);
  void add_corners(const Json& primitive, const std::string& name, std::size_t points, int first, bool mirrored);

  GltfDocument document_;
  Triangles result_;
};

/// The nodes of the default scene; without scenes, those that are nobody's child.
std::vector<std::size_t> GltfReader::roots() const {
  std::vector<std::size_t> result;
  if (document_.size("scenes") > 0) {
    const std::size_t chosen = document_.integer(document_.root(), "scene", "the file", 0);
    const Json& scene = document_.element("scenes", chosen, "scene");
    if (const auto nodes = scene.find("nodes"); nodes != scene.end()) {
      if (!nodes->is_array()) document_.fail("E_FILE_SYNTAX", "the nodes of the scene are not a list");
      for (const Json& node : *nodes) result.push_back(document_.integer(node, "a node of the scene"));
    }
    return result;
  }
  std::vector<char> is_child(document_.size("nodes"), 0);
  for (const Json& node : document_.root()["nodes"]) {
    if (!node.is_object() || !node.contains("children") || !node["children"].is_array()) continue;
    for (const Json& child : node["children"]) {
      if (const std::size_t c = document_.integer(child, "a child"); c < is_child.size()) is_child[c] = 1;
    }
  }
  for (std::size_t n = 0; n < is_child.size(); ++n) {
    if (is_child[n] == 0) result.push_back(n);
  }
  return result;
}

void GltfReader::add_tree(std::size_t root, std::vector<char>& visited) {
  std::vector<std::pair<std::size_t, Matrix>> open{{root, Matrix::Identity()}};
  while (!open.empty()) {
    const auto [index, outer] = open.back();
    open.pop_back();
    const std::string name = "nodes[" + std::to_string(index) + "]";
    const Json& node = document_.element("nodes", index, "a node list");
    if (visited[index]++ != 0) document_.fail("E_FILE_SYNTAX", name + " is reached twice; nodes form trees");
    const Matrix inner = outer * transform(node, name);
    if (node.contains("mesh")) add_mesh(document_.integer(node, "mesh", name), inner);
    const auto children = node.find("children");
    if (children == node.end()) continue;
    if (!children->is_array()) document_.fail("E_FILE_SYNTAX", name + ".children is not a list");
    for (auto child = children->rbegin(); child != children->rend(); ++child)
      open.emplace_back(document_.integer(*child, name + ".children"), inner);
  }
}

Matrix GltfReader::transform(const Json& node, const std::string& name) const {
  Matrix result = Matrix::Identity();
  if (node.contains("matrix")) {
    const auto m = document_.numbers(node, "matrix", 16, name);
    for (Eigen::Index k = 0; k < 16; ++k) result(k % 4, k / 4) = m[static_cast<std::size_t>(k)];
    if (result(3, 0) != 0 || result(3, 1) != 0 || result(3, 2) != 0 || result(3, 3) != 1)
      document_.fail("E_FILE_NUMBER", name + ".matrix is not affine");
    return result;
  }
  if (node.contains("rotation")) {
    const auto q = document_.numbers(node, "rotation", 4, name);
    const double x = q[0], y = q[1], z = q[2], w = q[3];
    result.topLeftCorner<3, 3>() << 1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w),  //
        2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w),                              //
        2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y);
  }
  if (node.contains("scale")) {
    const auto s = document_.numbers(node, "scale", 3, name);
    for (Eigen::Index c = 0; c < 3; ++c) result.col(c) *= s[static_cast<std::size_t>(c)];
  }
  if (node.contains("translation")) {
    const auto t = document_.numbers(node, "translation", 3, name);
    for (Eigen::Index c = 0; c < 3; ++c) result(c, 3) = t[static_cast<std::size_t>(c)];
  }
  return result;
}

void GltfReader::add_mesh(std::size_t index, const Matrix& transform) {
  const Json& mesh = document_.element("meshes", index, "a node");
  const std::string name = "meshes[" + std::to_string(index) + "]";
  if (!mesh.contains("primitives") || !mesh["primitives"].is_array())
    document_.fail("E_FILE_SYNTAX", name + " has no list of primitives");
  std::size_t k = 0;
  for (const Json& primitive : mesh["primitives"])
    add_primitive(primitive, name + ".primitives[" + std::to_string(k++) + "]", transform);
}

void GltfReader::add_primitive(const Json& primitive, const std::string& name, const Matrix& transform) {
  if (!primitive.is_object()) document_.fail("E_FILE_SYNTAX", name + " is not an object");
  if (const std::size_t mode = document_.integer(primitive, "mode", name, 4); mode != 4) {
    document_.fail("E_FILE_FORMAT", name + " has mode " + std::to_string(mode) + "; only lists of triangles (4) are read",
                   "export triangles");
  }
  const auto attributes = primitive.find("attributes");
  if (attributes == primitive.end() || !attributes->is_object()) document_.fail("E_FILE_SYNTAX", name + " has no attributes");
  const GltfView positions = document_.view(document_.integer(*attributes, "POSITION", name), name + ".POSITION");
  if (positions.components != 3 || positions.component_type != 5126)
    document_.fail("E_FILE_FORMAT", name + ".POSITION is not a list of three floats each");
  GltfView normals;
  const bool has_normals = attributes->contains("NORMAL");
  if (has_normals) {
    normals = document_.view(document_.integer(*attributes, "NORMAL", name), name + ".NORMAL");
    if (normals.components != 3 || normals.component_type != 5126 || normals.count != positions.count)
      document_.fail("E_FILE_FORMAT", name + ".NORMAL does not fit POSITION");
  }
  const int first = static_cast<int>(result_.points.size() / 3);
  // A mesh may stand in many nodes; the sum has to stay in proportion to the file.
  if (result_.points.size() / 3 + positions.count > 1'000'000 + 16 * document_.bytes()) {
    document_.fail("E_FILE_TOO_LARGE", "the nodes repeat their meshes so often that the sum is out of proportion to the file");
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
      document_.fail("E_FILE_NUMBER", name + ": point " + std::to_string(k) + " has a coordinate that is not a finite number");
    result_.points.insert(result_.points.end(), p.data(), p.data() + 3);
    if (!normals) continue;
    Eigen::Vector3d n(normals->real(k, 0), normals->real(k, 1), normals->real(k, 2));
    if (!plain) n = (cofactors * n).eval();
    if (!plain && n.norm() > 0) n /= n.norm();
    if (!n.allFinite()) document_.fail("E_FILE_NUMBER", name + ": normal " + std::to_string(k) + " is not finite");
    result_.normals.insert(result_.normals.end(), n.data(), n.data() + 3);
  }
  result_.all_have_normals = result_.all_have_normals && normals != nullptr;
}

void GltfReader::add_corners(const Json& primitive, const std::string& name, std::size_t points, int first, bool mirrored) {
  GltfView indices;
  const bool indexed = primitive.contains("indices");
  if (indexed) {
    indices = document_.view(document_.integer(primitive, "indices", name), name + ".indices");
    const bool fits = indices.components == 1 &&
                      (indices.component_type == 5121 || indices.component_type == 5123 || indices.component_type == 5125);
    if (!fits) document_.fail("E_FILE_FORMAT", name + ".indices are not unsigned integers");
  }
  const std::size_t count = indexed ? indices.count : points;
  if (count % 3 != 0)
    document_.fail("E_FILE_COUNT", name + " has " + std::to_string(count) + " corners, which is no multiple of 3");
  if (result_.corners.size() + count > 3'000'000 + 16 * document_.bytes()) {
    document_.fail("E_FILE_TOO_LARGE", "the nodes repeat their meshes so often that the sum is out of proportion to the file");
  }
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t at = mirrored && k % 3 != 0 ? k + (k % 3 == 1 ? 1 : -std::size_t{1}) : k;
    const std::size_t v = indexed ? indices.index(at) : at;
    if (v >= points)
      document_.fail("E_FILE_INDEX", name + ": corner " + std::to_string(at) + " names point " + std::to_string(v) +
                                         ", but there are " + std::to_string(points));
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
UDCP_FOR_EACH_NUMBER(UDCP_READ_GLTF)
#undef UDCP_READ_GLTF

}  // namespace udcp
