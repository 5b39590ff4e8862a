// Classes, nets, groups and the global frame of a quad mesh.
#include "proofs/regularity/quad_mesh.h"

#include <numeric>

namespace udcp {
namespace {

std::size_t at(int k) { return static_cast<std::size_t>(k); }

int faces_at(const Mesh& mesh, int v) { return mesh.on_boundary(v) ? mesh.valence(v) - 1 : mesh.valence(v); }

VertexClass class_in(const Mesh& mesh, const Tags& tags, int v) {
  const int faces = faces_at(mesh, v);
  if (!mesh.on_boundary(v) && tags.is_corner(v))
    throw Error(ErrorKind::input, "E_CORNER", "vertex " + std::to_string(v) + " is tagged as a corner but lies inside the mesh",
                "only boundary vertices can be corners here");
  if (!mesh.on_boundary(v)) return faces == 4 ? VertexClass::interior : VertexClass::extraordinary;
  if (tags.is_corner(v)) return faces == 1 ? VertexClass::corner : VertexClass::tagged;
  return faces == 1 ? VertexClass::smooth1 : faces == 2 ? VertexClass::boundary : VertexClass::bextraordinary;
}

void require_quads(const Mesh& mesh) {
  for (int f = 0; f < mesh.faces(); ++f)
    if (mesh.size(f) != 4)
      throw Error(ErrorKind::input, "E_NOT_QUADS",
                  "face " + std::to_string(f) + " has " + std::to_string(mesh.size(f)) + " corners; this needs quads",
                  "one step of catmull_clark makes quads of all faces");
}

std::vector<Vector3> scaled(const Points<Rational>& points, const Rational& scale) {
  std::vector<Vector3> result(static_cast<std::size_t>(points.rows()));
  for (Eigen::Index v = 0; v < points.rows(); ++v)
    for (Eigen::Index c = 0; c < points.cols(); ++c)
      result[static_cast<std::size_t>(v)][static_cast<std::size_t>(c)] = scale * points(v, c);
  return result;
}

/// Entries of a net seen from the side of half-edge number `side`, so that one walk serves all four sides.
struct Turned {
  int side;
  /// Row 0 is outside the side, row 1 on it, columns along it.
  [[nodiscard]] std::pair<int, int> place(int row, int column) const {
    switch (side) {
      case 0:
        return {row, column};
      case 1:
        return {column, 3 - row};
      case 2:
        return {3 - row, 3 - column};
      default:
        return {3 - column, row};
    }
  }
};

/// The representative of the class of k, with path halving.
int find(std::vector<int>& parent, int k) {
  while (parent[at(k)] != k) k = parent[at(k)] = parent[at(parent[at(k)])];
  return k;
}

}  // namespace

std::string to_string(VertexClass c) {
  static constexpr std::array names = {"interior", "extraordinary", "boundary", "corner", "smooth1", "bextraordinary", "tagged"};
  return names[static_cast<std::size_t>(c)];
}

Rational common_denominator(const Points<Rational>& points) {
  Rational scale(1);
  for (Eigen::Index k = 0; k < points.size(); ++k) {
    const Rational& x = points.data()[k];
    if (!(scale * x).is_integer()) scale = least_common_multiple(scale, x.denominator());
    if (scale.bits() > 10'000 || x.bits() > 20'000)
      throw Error(ErrorKind::limit, "E_TOO_LARGE", "the coordinates have no common denominator of less than 10,000 bits",
                  "round them to fewer digits");
  }
  return scale;
}

QuadMesh::QuadMesh(const Surface<Rational>& surface) : surface_(surface) {
  validate(surface);
  require_quads(mesh());
  if (surface.points.cols() > 3) throw Error(ErrorKind::input, "E_DIMENSION", "the mesh must have two or three coordinates");
  scale_ = common_denominator(surface.points);
  points_ = scaled(surface.points, scale_);
  for (const Vector3& p : points_) planar_ = planar_ && p[2].is_zero();
  for (int v = 0; v < mesh().vertices(); ++v) classes_.push_back(class_in(mesh(), surface.tags, v));
}

FaceKind QuadMesh::kind_of(int face, RegularityMode mode) const {
  bool regular = true, extraordinary = false;
  for (const int v : mesh().corners(face)) {
    const VertexClass c = class_of(v);
    extraordinary = extraordinary || c == VertexClass::extraordinary;
    const bool on_regular_boundary = c == VertexClass::boundary || c == VertexClass::corner;
    regular = regular && (c == VertexClass::interior || (mode == RegularityMode::bspline && on_regular_boundary));
  }
  if (regular) return FaceKind::patch;
  return mode == RegularityMode::bspline || extraordinary ? FaceKind::excluded : FaceKind::outside;
}

BicubicNet QuadMesh::net(int face) const {
  const Mesh& m = mesh();
  BicubicNet net;
  const auto set = [&](const Turned& view, int row, int column, const Vector3& value) {
    const auto [i, j] = view.place(row, column);
    net.at(i, j) = value;
  };
  for (int side = 0; side < 4; ++side) {
    const int h = m.face_begin[at(face)] + side, across = m.twin[at(h)];
    const Turned view{side};
    set(view, 1, 1, point(m.vertex[at(h)]));
    net.flagged[at(side)] = across < 0;
    if (across < 0) continue;
    const int away = m.next(across);  // leaves the first corner of this side
    set(view, 0, 1, point(m.tip(away)));
    set(view, 0, 2, point(m.vertex[at(m.prev(across))]));
    const int diagonal = m.twin[at(away)];
    if (diagonal >= 0) set(view, 0, 0, point(m.tip(m.next(m.next(diagonal)))));
  }
  reflect(net);
  return net;
}

std::vector<int> QuadMesh::groups(RegularityMode mode) const {
  const Mesh& m = mesh();
  std::vector<int> parent(static_cast<std::size_t>(m.faces())), seen(static_cast<std::size_t>(m.vertices()), -1);
  std::iota(parent.begin(), parent.end(), 0);
  for (int f = 0; f < m.faces(); ++f) {
    if (kind_of(f, mode) != FaceKind::patch) continue;
    for (const int v : m.corners(f)) {
      if (seen[at(v)] < 0) seen[at(v)] = f;
      parent[at(find(parent, f))] = find(parent, seen[at(v)]);
    }
  }
  std::vector<int> result;
  for (int f = 0; f < m.faces(); ++f) result.push_back(kind_of(f, mode) == FaceKind::patch ? find(parent, f) : -1);
  return result;
}

Surface<Rational> with_one_face_corners(Surface<Rational> surface) {
  const Mesh& mesh = *surface.mesh;
  if (surface.tags.corner.empty()) surface.tags.corner.assign(static_cast<std::size_t>(mesh.vertices()), 0);
  for (int v = 0; v < mesh.vertices(); ++v)
    if (mesh.on_boundary(v) && faces_at(mesh, v) == 1) surface.tags.corner[at(v)] = 1;
  return surface;
}

std::optional<std::vector<int>> global_frame(const Mesh& mesh) {
  std::vector<int> turn(static_cast<std::size_t>(mesh.faces()), -1);
  std::vector<int> stack;
  for (int start = 0; start < mesh.faces(); ++start) {
    if (turn[at(start)] >= 0) continue;
    turn[at(start)] = 0;
    stack.push_back(start);
    while (!stack.empty()) {
      const int f = stack.back();
      stack.pop_back();
      for (int side = 0; side < 4; ++side) {
        const int across = mesh.twin[at(mesh.face_begin[at(f)] + side)];
        if (across < 0) continue;
        const int g = mesh.face[at(across)], other = across - mesh.face_begin[at(g)];
        const int wanted = (other - side + turn[at(f)] + 6) % 4;  // the shared edge runs the other way round
        if (turn[at(g)] < 0) {
          turn[at(g)] = wanted;
          stack.push_back(g);
        } else if (turn[at(g)] != wanted) {
          return std::nullopt;
        }
      }
    }
  }
  return turn;
}

}  // namespace udcp
