// Simple shapes in every number type that can hold them.
#include "operators/shapes.h"

#include <array>
#include <string>

namespace udcp {
namespace {

template <class S>
Surface<S> build(const std::vector<std::array<int, 3>>& points, const std::vector<std::vector<int>>& faces) {
  Surface<S> result;
  result.mesh = std::make_shared<const Mesh>(make_mesh(static_cast<int>(points.size()), faces));
  result.points.resize(static_cast<Eigen::Index>(points.size()), 3);
  for (Eigen::Index v = 0; v < result.points.rows(); ++v)
    for (Eigen::Index c = 0; c < 3; ++c)
      result.points(v, c) = S(points[static_cast<std::size_t>(v)][static_cast<std::size_t>(c)]);
  return result;
}

void require(bool good, const std::string& message) {
  if (!good) throw Error(ErrorKind::input, "E_SHAPE", message, "");
}

// cos and sin of 2 pi i/n.
template <class S>
S circle_cos(int i, int n) {
  return cosine<S>(Rational(2 * static_cast<long long>(i)) / Rational(n));
}
template <class S>
S circle_sin(int i, int n) {
  return cosine<S>(Rational(1) / Rational(2) - Rational(2 * static_cast<long long>(i)) / Rational(n));
}

// m points round by k profile points; vertex (i, j) is j*m + i, i along the latitude ring.
template <class S>
Surface<S> revolve(int m, const Points<S>& profile, bool closed) {
  const int k = static_cast<int>(profile.rows());
  require(m >= 3 && k >= (closed ? 3 : 2), "a tube needs at least 3 points round and 2 rings (3 if closed)");
  require(profile.cols() == 2, "a profile has two columns, radius and height");
  require(static_cast<long long>(m) * k <= 100'000'000, "a tube has at most 100000000 points");
  Surface<S> result;
  result.points.resize(static_cast<Eigen::Index>(m) * k, 3);
  for (int i = 0; i < m; ++i) {
    const S c = circle_cos<S>(i, m), s = circle_sin<S>(i, m);
    for (int j = 0; j < k; ++j) {
      const Eigen::Index row = static_cast<Eigen::Index>(j) * m + i;
      result.points(row, 0) = profile(j, 0) * c;
      result.points(row, 1) = profile(j, 0) * s;
      result.points(row, 2) = profile(j, 1);
    }
  }
  std::vector<std::vector<int>> faces;
  for (int j = 0; j < (closed ? k : k - 1); ++j) {
    const int lower = j * m, upper = (j + 1) % k * m;
    for (int i = 0; i < m; ++i) faces.push_back({lower + i, lower + (i + 1) % m, upper + (i + 1) % m, upper + i});
  }
  result.mesh = std::make_shared<const Mesh>(make_mesh(m * k, faces));
  result.tags.edge.assign(static_cast<std::size_t>(result.mesh->edges()), EdgeTag::longitude);
  for (int h = 0; h < result.mesh->half_edges(); ++h)
    if (h % 2 == 0) result.tags.edge[Mesh::i(result.mesh->edge[Mesh::i(h)])] = EdgeTag::latitude;
  return result;
}

}  // namespace

template <class S>
Polyline<S> polygon(int corners, const std::type_identity_t<S>& radius) {
  require(corners >= 3 && corners <= 100'000'000,
          "a polygon has at least 3 corners and at most 100000000, not " + std::to_string(corners));
  Polyline<S> result;
  result.points.resize(corners, 2);
  for (int i = 0; i < corners; ++i) {
    result.points(i, 0) = radius * circle_cos<S>(i, corners);
    result.points(i, 1) = radius * circle_sin<S>(i, corners);
  }
  return result;
}

template <class S>
Surface<S> cube() {
  return build<S>({{-1, -1, -1}, {1, -1, -1}, {-1, 1, -1}, {1, 1, -1}, {-1, -1, 1}, {1, -1, 1}, {-1, 1, 1}, {1, 1, 1}},
                  {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}});
}

template <class S>
Surface<S> tetrahedron() {
  return build<S>({{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}, {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}});
}

template <class S>
Surface<S> octahedron() {
  return build<S>({{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
                  {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}});
}

template <class S>
Surface<S> icosahedron() {
  const S golden = S(2) * cosine<S>(Rational(1) / Rational(5));
  Surface<S> result;
  result.points = Points<S>::Zero(12, 3);
  for (int axis = 0; axis < 3; ++axis) {
    for (int k = 0; k < 4; ++k) {
      result.points(4 * axis + k, (axis + 1) % 3) = k % 2 == 0 ? S(1) : S(-1);
      result.points(4 * axis + k, (axis + 2) % 3) = k < 2 ? golden : S(-golden);
    }
  }
  result.mesh = std::make_shared<const Mesh>(make_mesh(
      12, {{0, 1, 4}, {0, 4, 8}, {0, 8, 9}, {0, 9, 6}, {0, 6, 1},  {1, 6, 11}, {1, 11, 10}, {1, 10, 4},  {4, 10, 5}, {4, 5, 8},
           {8, 5, 2}, {8, 2, 9}, {9, 2, 7}, {9, 7, 6}, {6, 7, 11}, {3, 2, 5},  {3, 5, 10},  {3, 10, 11}, {3, 11, 7}, {3, 7, 2}}));
  return result;
}

template <class S>
Surface<S> grid(int nx, int ny) {
  require(nx >= 1 && ny >= 1 && static_cast<long long>(nx) * ny <= 100'000'000,
          "a grid has at least 1 by 1 faces and at most 100000000");
  Surface<S> result;
  result.points = Points<S>::Zero(static_cast<Eigen::Index>(nx + 1) * (ny + 1), 3);
  std::vector<std::vector<int>> faces;
  for (int y = 0; y <= ny; ++y) {
    for (int x = 0; x <= nx; ++x) {
      const int v = y * (nx + 1) + x;
      result.points(v, 0) = S(x);
      result.points(v, 1) = S(y);
      if (x < nx && y < ny) faces.push_back({v, v + 1, v + nx + 2, v + nx + 1});
    }
  }
  result.mesh = std::make_shared<const Mesh>(make_mesh((nx + 1) * (ny + 1), faces));
  return result;
}

template <class S>
Surface<S> tube(int m, const Points<S>& profile, bool closed) {
  return revolve(m, profile, closed);
}

template <class S>
Surface<S> torus(int m, int k, const std::type_identity_t<S>& R, const std::type_identity_t<S>& r) {
  require(k >= 3, "a torus needs at least 3 points in each direction");
  Points<S> profile(k, 2);
  for (int j = 0; j < k; ++j) {
    profile(j, 0) = R + r * circle_cos<S>(j, k);
    profile(j, 1) = r * circle_sin<S>(j, k);
  }
  return revolve(m, profile, true);
}

template <class S>
Surface<S> triangulate(const Surface<S>& surface) {
  const Mesh& mesh = *surface.mesh;
  std::vector<int> begin{0}, corners;
  for (int f = 0; f < mesh.faces(); ++f) {
    const auto c = mesh.corners(f);
    for (std::size_t k = 1; k + 1 < c.size(); ++k) {
      corners.insert(corners.end(), {c[0], c[k], c[k + 1]});
      begin.push_back(static_cast<int>(corners.size()));
    }
  }
  Surface<S> result = surface;
  result.mesh = std::make_shared<const Mesh>(make_mesh(mesh.vertices(), std::move(begin), std::move(corners)));
  result.tags.edge.clear();  // the diagonals have no direction, and edges are numbered anew
  return result;
}

#define UDCP_INSTANTIATE(S)                                                                            \
  template Polyline<S> polygon(int, const std::type_identity_t<S>&);                                   \
  template Surface<S> cube();                                                                          \
  template Surface<S> tetrahedron();                                                                   \
  template Surface<S> octahedron();                                                                    \
  template Surface<S> icosahedron();                                                                   \
  template Surface<S> grid(int, int);                                                                  \
  template Surface<S> tube(int, const Points<S>&, bool);                                               \
  template Surface<S> torus(int, int, const std::type_identity_t<S>&, const std::type_identity_t<S>&); \
  template Surface<S> triangulate(const Surface<S>&);
UDCP_FOR_EACH_COORDINATE(UDCP_INSTANTIATE)
#undef UDCP_INSTANTIATE

}  // namespace udcp
