// Nets of regular faces, and how patches meet.
#include "operators/methods/filling/patch_surface.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "operators/methods/filling/fill_system.h"

namespace udcp {
namespace {

std::size_t at(int k) { return Mesh::i(k); }

// Places in the 4x4 net: the corners of the face, and the way out across each side (side k starts at corner k).
struct Place {
  int a = 0, b = 0;
  friend Place operator+(Place p, Place q) { return {p.a + q.a, p.b + q.b}; }
  friend Place operator-(Place p, Place q) { return {p.a - q.a, p.b - q.b}; }
  [[nodiscard]] int row() const { return 4 * a + b; }
};
constexpr std::array<Place, 4> corners{{{1, 1}, {2, 1}, {2, 2}, {1, 2}}}, outwards{{{0, -1}, {1, 0}, {0, 1}, {-1, 0}}};

bool is_regular_vertex(const Surface<double>& surface, int v) {
  const Mesh& mesh = *surface.mesh;
  if (!mesh.on_boundary(v)) return mesh.valence(v) == 4;
  return mesh.valence(v) == (surface.tags.is_corner(v) ? 2 : 3);
}

// Fills the entries of a net that are points of the mesh, then those beyond a boundary.
class NetReader {
 public:
  NetReader(const Surface<double>& surface, int first) : surface_(surface), mesh_(*surface.mesh), net(16, 3) {
    half_[0] = first;
    for (std::size_t k = 1; k < 4; ++k) half_[k] = mesh_.next(half_[k - 1]);
  }

  bool read() {
    for (std::size_t k = 0; k < 4; ++k) {
      if (!is_regular_vertex(surface_, mesh_.vertex[at(half_[k])])) return false;
      set(corners[k], mesh_.vertex[at(half_[k])]);
    }
    for (std::size_t k = 0; k < 4; ++k)
      if (!read_side(k)) return false;
    for (std::size_t k = 0; k < 4; ++k)
      if (!read_corner(k)) return false;
    return true;
  }

 private:
  [[nodiscard]] bool is_quad(int h) const { return mesh_.size(mesh_.face[at(h)]) == 4; }
  void set(Place to, int v) { net.row(to.row()) = surface_.points.row(v); }
  void reflect(Place to, Place middle, Place from) { net.row(to.row()) = 2 * net.row(middle.row()) - net.row(from.row()); }

  bool read_side(std::size_t k) {
    const Place here = corners[k], next = corners[(k + 1) % 4], out = outwards[k];
    const int twin = mesh_.twin[at(half_[k])];
    if (twin < 0) {
      reflect(here + out, here, here - out);
      reflect(next + out, next, next - out);
      return true;
    }
    if (!is_quad(twin)) return false;
    set(here + out, mesh_.tip(mesh_.next(twin)));
    set(next + out, mesh_.vertex[at(mesh_.prev(twin))]);
    return true;
  }

  bool read_corner(std::size_t k) {
    const std::size_t before = (k + 3) % 4;
    const Place out = outwards[k], across = outwards[before], corner = corners[k];
    const bool open = mesh_.twin[at(half_[k])] < 0, open_before = mesh_.twin[at(half_[before])] < 0;
    if (open) {
      reflect(corner + across + out, corner + across, corner + across - out);
    } else if (open_before) {
      reflect(corner + across + out, corner + out, corner + out - across);
    } else {
      const int opposite = mesh_.twin[at(mesh_.next(mesh_.twin[at(half_[k])]))];
      if (opposite < 0 || !is_quad(opposite)) return false;
      set(corner + across + out, mesh_.tip(mesh_.next(mesh_.next(opposite))));
    }
    return true;
  }

  const Surface<double>& surface_;
  const Mesh& mesh_;
  std::array<int, 4> half_{};

 public:
  Points<double> net;
};

}  // namespace

std::optional<Points<double>> regular_net(const Surface<double>& surface, int first) {
  if (surface.mesh->size(surface.mesh->face[at(first)]) != 4) return std::nullopt;
  NetReader reader(surface, first);
  if (!reader.read()) return std::nullopt;
  return reader.net;
}

PatchSurface regular_patches(Surface<double> cage, const std::vector<double>& c, TangentFactor tangents) {
  PatchSurface result;
  result.cage = std::move(cage);
  const Mesh& mesh = *result.cage.mesh;
  result.patches.resize(at(mesh.faces()));
  for (int f = 0; f < mesh.faces(); ++f) {
    const int first = mesh.face_begin[at(f)];
    result.first.push_back(first);
    const std::optional<Points<double>> net = regular_net(result.cage, first);
    if (!net) continue;
    std::array<double, 4> corner{0.5, 0.5, 0.5, 0.5};
    static constexpr std::array<int, 4> order{0, 3, 1, 2};  // (0,0), (0,1), (1,0), (1,1) among the corners of the face
    for (std::size_t k = 0; k < 4 && !c.empty(); ++k) corner[k] = c[at(mesh.vertex[at(first + order[k])])];
    result.patches[at(f)] = {3, 3, hybrid_patch<double>(*net, corner, tangents)};
  }
  return result;
}

std::array<double, 2> on_side(const PatchSurface& surface, int h, double t) {
  const Mesh& mesh = *surface.cage.mesh;
  switch ((h - surface.first[at(mesh.face[at(h)])] + 4) % 4) {
    case 0:
      return {t, 0};
    case 1:
      return {1, t};
    case 2:
      return {1 - t, 1};
    default:
      return {0, 1 - t};
  }
}

double size_of(const Surface<double>& surface) {
  if (surface.points.rows() == 0) return 0;
  return (surface.points.colwise().maxCoeff() - surface.points.colwise().minCoeff()).norm();
}

JoinDefects join_defects(const PatchSurface& surface, int samples) {
  const Mesh& mesh = *surface.cage.mesh;
  const double size = size_of(surface.cage);
  JoinDefects result;
  for (int e = 0; e < mesh.edges(); ++e) {
    const int h = mesh.edge_half[at(e)], twin = mesh.twin[at(h)];
    if (twin < 0 || !surface.has_patch(mesh.face[at(h)]) || !surface.has_patch(mesh.face[at(twin)])) continue;
    ++result.edges;
    for (int k = 0; k < samples; ++k) {
      const double t = static_cast<double>(k) / (samples - 1);
      const auto [u, v] = on_side(surface, h, t);
      const auto [x, y] = on_side(surface, twin, 1 - t);
      const PatchJet p = surface.patches[at(mesh.face[at(h)])].at(u, v), q = surface.patches[at(mesh.face[at(twin)])].at(x, y);
      result.gap = std::max(result.gap, (p.point - q.point).norm());
      const SurfaceCurvature a = curvature(p), b = curvature(q);
      if (!a.is_regular || !b.is_regular) {
        ++result.irregular;
        continue;
      }
      result.normal = std::max(result.normal, (a.normal - b.normal).norm());
      const double scale = std::max({a.tensor.norm(), b.tensor.norm(), 1 / size}), defect = (a.tensor - b.tensor).norm() / scale;
      if (defect > result.curvature || result.worst_edge < 0) result.worst_edge = e;
      result.curvature = std::max(result.curvature, defect);
    }
  }
  return result;
}

FaceRings face_rings(const Mesh& mesh, int v) {
  FaceRings rings;
  int h = mesh.outgoing[at(v)];
  do {
    rings.inner.push_back(mesh.face[at(h)]);
    h = mesh.around(h);
  } while (h >= 0 && h != mesh.outgoing[at(v)]);
  for (const int f : rings.inner) {
    for (const int corner : mesh.corners(f)) {
      int start = mesh.outgoing[at(corner)], g = start;
      do {
        const int face = mesh.face[at(g)];
        if (std::find(rings.inner.begin(), rings.inner.end(), face) == rings.inner.end() &&
            std::find(rings.outer.begin(), rings.outer.end(), face) == rings.outer.end())
          rings.outer.push_back(face);
        g = mesh.around(g);
      } while (g >= 0 && g != start);
    }
  }
  return rings;
}

std::vector<int> ring_vertices(const Mesh& mesh, int start, int rings) {
  const int n = mesh.valence(mesh.vertex[at(start)]);
  std::vector<int> result(at(ring_size(n, rings)));
  result[0] = mesh.vertex[at(start)];
  int spoke = start;
  for (int i = 0; i < n; ++i) {
    int along = spoke;  // from (j, 0) to (j + 1, 0)
    for (int j = 0; j < rings; ++j) {
      int h = along;  // from (j, k) to (j + 1, k), the cell above it on its left
      for (int k = 0; k < rings; ++k) {
        result[at(ring_number(n, i, j + 1, k))] = mesh.tip(h);
        result[at(ring_number(n, i, j + 1, k + 1))] = mesh.tip(mesh.next(h));
        result[at(ring_number(n, i, j, k + 1))] = mesh.tip(mesh.next(mesh.next(h)));
        if (k + 1 < rings) h = mesh.twin[at(mesh.next(mesh.next(h)))];
      }
      if (j + 1 < rings) along = mesh.next(mesh.twin[at(mesh.next(along))]);
    }
    spoke = mesh.around(spoke);
  }
  return result;
}

}  // namespace udcp
