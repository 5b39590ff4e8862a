// Connected groups of level edges; a group is a loop if each of its vertices has exactly two of them.
#include "interpreter/edge_loops.h"

#include <cmath>
#include <numeric>

namespace udcp {

namespace {

struct Groups {
  std::vector<int> parent;
  explicit Groups(int n) : parent(static_cast<std::size_t>(n)) { std::iota(parent.begin(), parent.end(), 0); }
  int find(int v) {
    while (parent[Mesh::i(v)] != v) v = parent[Mesh::i(v)] = parent[Mesh::i(parent[Mesh::i(v)])];
    return v;
  }
  void join(int a, int b) { parent[Mesh::i(find(a))] = find(b); }
};

}  // namespace

std::vector<int> planar_edge_loops(const Surface<double>& surface, int axis) {
  const Mesh& mesh = *surface.mesh;
  if (axis >= surface.points.cols())
    throw Error(ErrorKind::input, "E_DIMENSION", "the points have no coordinate along this axis");
  const double size = (surface.points.colwise().maxCoeff() - surface.points.colwise().minCoeff()).maxCoeff();
  const auto ends = [&](int e) {
    const int h = mesh.edge_half[Mesh::i(e)];
    return std::pair(mesh.vertex[Mesh::i(h)], mesh.tip(h));
  };
  std::vector<char> level(Mesh::i(mesh.edges()), 0);
  std::vector<int> degree(Mesh::i(mesh.vertices()), 0);
  Groups groups(mesh.vertices());
  for (int e = 0; e < mesh.edges(); ++e) {
    const auto [a, b] = ends(e);
    if (std::abs(surface.points(a, axis) - surface.points(b, axis)) > 1e-9 * size) continue;
    level[Mesh::i(e)] = 1;
    ++degree[Mesh::i(a)];
    ++degree[Mesh::i(b)];
    groups.join(a, b);
  }
  std::vector<char> broken(Mesh::i(mesh.vertices()), 0);  // by group
  for (int v = 0; v < mesh.vertices(); ++v) {
    if (degree[Mesh::i(v)] != 2) broken[Mesh::i(groups.find(v))] = 1;
  }
  std::vector<int> edges;
  for (int e = 0; e < mesh.edges(); ++e) {
    if (level[Mesh::i(e)] && !broken[Mesh::i(groups.find(ends(e).first))]) edges.push_back(e);
  }
  return edges;
}

}  // namespace udcp
