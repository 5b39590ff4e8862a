// A walk over both meshes at once.
#include "operators/plan/correspondence.h"

#include <algorithm>
#include <utility>

namespace udcp {

template <class R>
Mesh half_edges_of(const FlatMesh<R>& flat) {
  std::vector<int> begin{0}, corners(flat.corners.begin(), flat.corners.end());
  for (std::int64_t f = 0; f < flat.faces(); ++f) begin.push_back(begin.back() + flat.corners_per_face);
  return make_mesh(static_cast<int>(flat.vertices()), std::move(begin), std::move(corners));
}
template Mesh half_edges_of(const FlatMesh<float>&);
template Mesh half_edges_of(const FlatMesh<double>&);

int first_half(const Mesh& result, const Mesh& planned) {
  for (int h = 0; h < result.half_edges() / planned.faces(); ++h)
    if (result.vertex[Mesh::i(h)] == planned.vertex[0]) return h;
  return -1;
}

std::vector<int> correspondence(const Mesh& a, int half_a, const Mesh& b, int half_b) {
  if (a.vertices() != b.vertices() || a.faces() != b.faces() || a.half_edges() != b.half_edges()) return {};
  std::vector<int> half(a.vertex.size(), -1), vertex(Mesh::i(a.vertices()), -1), stack{half_a};
  std::vector<char> used(b.vertex.size(), 0);
  half[Mesh::i(half_a)] = half_b;
  while (!stack.empty()) {
    const int h = stack.back(), g = half[Mesh::i(h)];
    stack.pop_back();
    if (used[Mesh::i(g)]++ != 0) return {};
    int& v = vertex[Mesh::i(a.vertex[Mesh::i(h)])];
    if (v >= 0 && v != b.vertex[Mesh::i(g)]) return {};
    v = b.vertex[Mesh::i(g)];
    for (const auto& [from, to] : {std::pair{a.next(h), b.next(g)}, {a.twin[Mesh::i(h)], b.twin[Mesh::i(g)]}}) {
      if ((from < 0) != (to < 0)) return {};
      if (from < 0) continue;
      int& known = half[Mesh::i(from)];
      if (known >= 0 && known != to) return {};
      if (known >= 0) continue;
      known = to;
      stack.push_back(from);
    }
  }
  return std::find(vertex.begin(), vertex.end(), -1) == vertex.end() ? vertex : std::vector<int>{};
}

}  // namespace udcp
