// From the lists of a file to a checked Surface: unused vertices, connectivity, tags, and warnings about strange geometry.
#include "files/raw_mesh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <bit>
#include <limits>
#include <numeric>
#include <tuple>
#include <utility>

namespace udcp {
namespace {

std::size_t at(int k) { return static_cast<std::size_t>(k); }

/// Per vertex its new index, -1 for one that no face uses.
std::vector<int> number_used(int vertices, const std::vector<int>& corners) {
  std::vector<int> index(at(vertices), -1);
  for (const int v : corners) {
    if (v >= 0 && v < vertices) index[at(v)] = 0;
  }
  int next = 0;
  for (int& entry : index) {
    if (entry == 0) entry = next++;
  }
  return index;
}

constexpr std::string_view unused = " used by no face and dropped (";

void warn_unused(const Input& input, const std::vector<int>& index, int first_index) {
  const auto count = std::count(index.begin(), index.end(), -1);
  if (count == 0) return;
  std::string names;
  int named = 0;
  for (std::size_t v = 0; v < index.size() && named < 5; ++v) {
    if (index[v] < 0) names += (named++ > 0 ? ", " : "") + std::to_string(static_cast<int>(v) + first_index);
  }
  const bool one = count == 1;
  input.warn(0, std::to_string(count) + (one ? " vertex is" : " vertices are") + std::string(unused) + names +
                    (count > named ? ", ..." : "") + ")");
}

/// The error of make_mesh with the file and the lines of the faces that it names.
[[noreturn]] void locate(const MeshError& error, const Input& input, const std::vector<std::uint32_t>& lines, int first_index) {
  const auto line_of = [&](int f) { return f >= 0 && at(f) < lines.size() ? std::int64_t{lines[at(f)]} : 0; };
  std::string message = input.place(line_of(error.face)) + error.what();
  if (const auto other = line_of(error.other_face); other > 0) {
    message += " (face " + std::to_string(error.other_face + first_index) + " stands in line " + std::to_string(other) + ")";
  }
  throw Error(error.kind, error.code, message, error.help);
}

/// Takes the faces out of `raw`.
template <class S>
std::shared_ptr<const Mesh> connect(RawMesh<S>& raw, const std::vector<int>& index, int used, const Input& input) {
  try {
    if (used == raw.vertices())
      return std::make_shared<const Mesh>(make_mesh(used, std::move(raw.begin), std::move(raw.corners), raw.first_index));
    std::vector<int> corners = raw.corners;
    try {
      for (int& v : corners) v = index[at(v)];
      return std::make_shared<const Mesh>(make_mesh(used, raw.begin, std::move(corners), raw.first_index));
    } catch (const MeshError&) {
      make_mesh(raw.vertices(), raw.begin, raw.corners, raw.first_index);  // the same error again, with the numbers of the file
      throw;
    }
  } catch (const MeshError& error) {
    locate(error, input, raw.face_lines, raw.first_index);
  }
}

template <class S>
std::vector<S> keep_used(const std::vector<S>& values, const std::vector<int>& index, std::size_t columns) {
  std::vector<S> result;
  result.reserve(values.size());
  for (std::size_t v = 0; v < index.size(); ++v) {
    if (index[v] < 0) continue;
    for (std::size_t c = 0; c < columns; ++c) result.push_back(values[columns * v + c]);
  }
  return result;
}

const char* name_of(EdgeTag tag) { return tag == EdgeTag::latitude ? "lat" : "lon"; }

template <class S>
void set_edge_tags(Surface<S>& surface, const RawMesh<S>& raw, const std::vector<int>& index, const Input& input) {
  if (raw.edges.empty()) return;
  const Mesh& mesh = *surface.mesh;
  std::vector<std::tuple<int, int, int>> ends;
  for (int e = 0; e < mesh.edges(); ++e) {
    const int h = mesh.edge_half[at(e)], a = mesh.vertex[at(h)], b = mesh.tip(h);
    ends.emplace_back(std::min(a, b), std::max(a, b), e);
  }
  std::ranges::sort(ends);
  surface.tags.edge.assign(at(mesh.edges()), EdgeTag::none);
  for (const TaggedEdge& edge : raw.edges) {
    const auto [a, b] = std::minmax(index[at(edge.from)], index[at(edge.to)]);
    const auto found = std::ranges::lower_bound(ends, std::tuple{a, b, 0});
    const std::string name = std::to_string(edge.from + raw.first_index) + "-" + std::to_string(edge.to + raw.first_index);
    if (found == ends.end() || std::get<0>(*found) != a || std::get<1>(*found) != b) {
      input.fail(edge.line, "E_FILE_TAG",
                 "the line in group " + std::string(name_of(edge.tag)) + " marks " + name + ", which is no edge of the mesh",
                 "an 'l' line in a tag group runs along edges of faces");
    }
    EdgeTag& tag = surface.tags.edge[at(std::get<2>(*found))];
    if (tag != EdgeTag::none && tag != edge.tag) {
      input.fail(edge.line, "E_FILE_TAG", "edge " + name + " is marked both lat and lon", "remove it from one of the two groups");
    }
    tag = edge.tag;
  }
}

template <class S>
void set_corner_tags(Surface<S>& surface, const RawMesh<S>& raw, const std::vector<int>& index, const Input& input) {
  if (raw.tagged_corners.empty()) return;
  surface.tags.corner.assign(at(surface.mesh->vertices()), 0);
  for (const TaggedVertex& corner : raw.tagged_corners) {
    const int v = index[at(corner.vertex)];
    if (v < 0) {
      input.fail(
          corner.line, "E_FILE_TAG",
          "the point in group corner marks vertex " + std::to_string(corner.vertex + raw.first_index) + ", which no face uses");
    }
    surface.tags.corner[at(v)] = 1;
  }
}

using Vector = Eigen::Vector3d;

/// Counts of strange faces, with the first of each kind.
struct Strange {
  int count = 0, first = -1;
  void note(int element) {
    if (count++ == 0) first = element;
  }
};

void warn_strange(const Input& input, const Strange& strange, const char* one, const char* many, std::int64_t line,
                  int first_index) {
  if (strange.count == 0) return;
  const std::string name = std::to_string(strange.first + first_index);
  input.warn(line, strange.count == 1 ? std::string(one) + " (" + name + ")"
                                      : std::to_string(strange.count) + " " + many + " (the first is " + name + ")");
}

/// Two corners of a quad turn one way and two the other: it crosses itself.
bool is_crossed(const std::vector<Vector>& p) {
  if (p.size() != 4) return false;
  Vector turn[4];
  int largest = 0;
  for (int k = 0; k < 4; ++k) {
    turn[k] = (p[at((k + 1) % 4)] - p[at(k)]).cross(p[at((k + 3) % 4)] - p[at(k)]);
    if (turn[k].squaredNorm() > turn[largest].squaredNorm()) largest = k;
  }
  int negative = 0;
  for (const Vector& t : turn) negative += t.dot(turn[largest]) < 0 ? 1 : 0;
  return negative == 2;
}

bool has_no_area(const std::vector<Vector>& p) {
  Vector area = Vector::Zero();
  double longest = 0;
  for (std::size_t k = 0; k < p.size(); ++k) {
    const Vector side = p[(k + 1) % p.size()] - p[k];
    longest = std::max(longest, side.squaredNorm());
    area += (p[k] - p[0]).cross(side);
  }
  return !(area.norm() > 1e-12 * longest);
}

void warn_faces(const Input& input, const Mesh& mesh, const Points<double>& points, const std::vector<std::uint32_t>& lines,
                int first_index) {
  Strange flat, crossed;
  std::vector<Vector> corners;
  for (int f = 0; f < mesh.faces(); ++f) {
    corners.clear();
    for (const int v : mesh.corners(f)) corners.emplace_back(points(v, 0), points(v, 1), points(v, 2));
    if (is_crossed(corners)) {
      crossed.note(f);
    } else if (has_no_area(corners)) {
      flat.note(f);
    }
  }
  const auto line = [&](const Strange& strange) {
    return strange.first >= 0 && !lines.empty() ? std::int64_t{lines[at(strange.first)]} : 0;
  };
  warn_strange(input, flat, "a face has no area", "faces have no area", line(flat), first_index);
  warn_strange(input, crossed, "a quad crosses itself", "quads cross themselves", line(crossed), first_index);
}

/// Points as doubles; `room` holds them where they are none.
const Points<double>& rounded(const Points<double>& points, Points<double>&) { return points; }
template <class S>
const Points<double>& rounded(const Points<S>& points, Points<double>& room) {
  room.resize(points.rows(), points.cols());
  for (Eigen::Index k = 0; k < points.size(); ++k) room.data()[k] = approximate<S>(points.data()[k]);
  return room;
}

/// `index` gives the vertices of the file their numbers in the mesh.
void warn_vertices(const Input& input, const Mesh& mesh, const Points<double>& points, const std::vector<int>& index,
                   int first_index) {
  const auto in_file = [&](Strange strange) {
    if (strange.count > 0) strange.first = static_cast<int>(std::ranges::find(index, strange.first) - index.begin());
    return strange;
  };
  Strange thin;
  std::vector<std::tuple<double, double, double, int>> rim;
  for (int v = 0; v < mesh.vertices(); ++v) {
    if (mesh.on_boundary(v)) {
      rim.emplace_back(points(v, 0) + 0.0, points(v, 1) + 0.0, points(v, 2) + 0.0, v);
    } else if (mesh.valence(v) == 2) {
      thin.note(v);
    }
  }
  warn_strange(input, in_file(thin), "an interior vertex has valence 2", "interior vertices have valence 2", 0, first_index);
  std::ranges::sort(rim);
  Strange seam;
  for (std::size_t k = 1; k < rim.size(); ++k) {
    const auto& [x, y, z, v] = rim[k - 1];
    const auto& [x2, y2, z2, w] = rim[k];
    if (x == x2 && y == y2 && z == z2) seam.note(w);
  }
  warn_strange(input, in_file(seam), "a boundary vertex lies on another one; are seams meant to be welded?",
               "boundary vertices lie on others; are seams meant to be welded?", 0, first_index);
}

}  // namespace

bool says_unused(const std::string& warning) { return warning.find(unused) != std::string::npos; }

void expect_int_count(const Input& input, std::size_t count, const char* what) {
  if (count <= static_cast<std::size_t>(std::numeric_limits<int>::max())) return;
  input.fail(0, "E_FILE_TOO_LARGE", std::string("more than 2^31 - 1 ") + what);
}

std::vector<int> weld(const std::vector<double>& coordinates, std::vector<int>& kept) {
  const int points = static_cast<int>(coordinates.size() / 3);
  std::vector<int> order(at(points)), vertex(at(points));
  std::iota(order.begin(), order.end(), 0);
  const auto key = [&](int k) {
    const double* p = coordinates.data() + 3 * at(k);
    return std::tuple{p[0], p[1], p[2]};
  };
  std::ranges::sort(order, [&](int a, int b) { return std::tuple{key(a), a} < std::tuple{key(b), b}; });
  for (std::size_t k = 0; k < order.size(); ++k) {
    const bool same = k > 0 && key(order[k]) == key(order[k - 1]);
    vertex[at(order[k])] = same ? vertex[at(order[k - 1])] : order[k];  // the first point of the run; numbered below
  }
  kept.clear();
  for (int k = 0; k < points; ++k) {
    if (vertex[at(k)] != k) {
      vertex[at(k)] = vertex[at(vertex[at(k)])];
      continue;
    }
    vertex[at(k)] = static_cast<int>(kept.size());
    kept.push_back(k);
  }
  return vertex;
}

template <class S>
Surface<S> build(RawMesh<S> raw, const Input& input) {
  expect_int_count(input, raw.coordinates.size() / 3, "vertices");
  if (raw.coordinates.empty()) input.fail(0, "E_FILE_EMPTY", "the file holds no vertex", "a mesh needs vertices and faces");
  if (raw.faces() == 0) input.fail(0, "E_FILE_EMPTY", "the file holds vertices but no face", "a mesh needs at least one face");
  const std::vector<int> index = number_used(raw.vertices(), raw.corners);
  const int used = raw.vertices() - static_cast<int>(std::count(index.begin(), index.end(), -1));
  Surface<S> surface;
  surface.mesh = connect(raw, index, used, input);
  warn_unused(input, index, raw.first_index);
  if (used < raw.vertices()) {
    raw.coordinates = keep_used(raw.coordinates, index, 3);
    for (auto& [name, values] : raw.attributes) values = keep_used(values, index, 1);
  }
  surface.points.resize(used, 3);
  std::ranges::move(raw.coordinates, surface.points.data());
  raw.coordinates = {};
  surface.attributes = std::move(raw.attributes);
  set_edge_tags(surface, raw, index, input);
  set_corner_tags(surface, raw, index, input);
  if (input.warnings) {
    Points<double> room;
    const Points<double>& points = rounded(surface.points, room);
    warn_faces(input, *surface.mesh, points, raw.face_lines, raw.first_index);
    warn_vertices(input, *surface.mesh, points, index, raw.first_index);
  }
  return surface;
}

#define UDCP_BUILD(S) template Surface<S> build(RawMesh<S>, const Input&);
UDCP_FOR_EACH_COORDINATE(UDCP_BUILD)
#undef UDCP_BUILD

}  // namespace udcp
