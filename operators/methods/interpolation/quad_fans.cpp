// Walks round a vertex by half-edges.
#include "operators/methods/interpolation/quad_fans.h"

namespace udcp {

void collect_fan(const Mesh& mesh, int v, Fan& fan) {
  fan.e.clear();
  fan.f.clear();
  fan.inside = !mesh.on_boundary(v);
  const int first = mesh.outgoing[Mesh::i(v)];
  for (int h = first; h >= 0;) {
    const int across = mesh.next(mesh.next(h));
    fan.e.push_back(mesh.tip(h));
    fan.f.push_back(mesh.vertex[Mesh::i(across)]);
    const int after = mesh.around(h);
    if (after < 0) fan.e.push_back(mesh.tip(across));
    if (after == first) return;
    h = after;
  }
}

Mesh fan_mesh(int faces, bool inside) {
  std::vector<int> begin{0}, corners;
  for (int j = 0; j < faces; ++j) {
    corners.insert(corners.end(), {0, 1 + 2 * j, 2 + 2 * j, inside && j + 1 == faces ? 1 : 3 + 2 * j});
    begin.push_back(static_cast<int>(corners.size()));
  }
  return make_mesh(2 * faces + (inside ? 1 : 2), std::move(begin), std::move(corners));
}

}  // namespace udcp
