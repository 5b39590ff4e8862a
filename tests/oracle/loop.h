// Loop's scheme as published, on lists of triangles: edge stencil 3/8, 1/8; Loop's beta(n) at vertices; cubic spline boundaries.
#pragma once

#include <vector>

#include "tests/oracle/catmull_clark.h"

namespace udcp::oracle {

/// The weight of each neighbour: (5/8 - (3/8 + cos(2 pi/n)/4)^2)/n.
template <class S>
S loop_beta(int n) {
  const S third = S(3) / S(8) + cosine<S>(Rational(2) / Rational(n)) / S(4);
  return (S(5) / S(8) - third * third) / S(n);
}

template <class S>
Refined<S> loop_step(const std::vector<std::vector<int>>& faces, const Points<S>& points, const std::vector<char>& corner = {}) {
  const EdgeTable table(faces);
  const int v0 = static_cast<int>(points.rows()), e0 = static_cast<int>(table.edges.size());
  Refined<S> result{{}, Points<S>::Zero(v0 + e0, points.cols())};
  Points<S>& fine = result.points;
  std::vector<std::vector<int>> neighbours(static_cast<std::size_t>(v0));
  for (const auto& e : table.edges) {
    neighbours[static_cast<std::size_t>(e.a)].push_back(e.b);
    neighbours[static_cast<std::size_t>(e.b)].push_back(e.a);
  }
  for (int v = 0; v < v0; ++v) {
    const auto& around = neighbours[static_cast<std::size_t>(v)];
    const int n = static_cast<int>(around.size());
    const S beta = n < 3 ? S(0) : loop_beta<S>(n);  // fewer only on the boundary, which is written below
    fine.row(v) = (S(1) - S(n) * beta) * points.row(v);
    for (const int u : around) fine.row(v) += beta * points.row(u);
  }
  boundary_vertices(table, points, corner, fine);
  for (int e = 0; e < e0; ++e) {
    const auto& edge = table.edges[static_cast<std::size_t>(e)];
    fine.row(v0 + e) = middle(points, edge.a, edge.b);
    if (edge.faces.size() != 2) continue;
    fine.row(v0 + e) = S(3) * fine.row(v0 + e) / S(4);
    for (const int f : edge.faces)
      for (const int v : faces[static_cast<std::size_t>(f)])
        if (v != edge.a && v != edge.b) fine.row(v0 + e) += points.row(v) / S(8);
  }
  for (const auto& f : faces) {
    const int ab = v0 + table.of(f[0], f[1]), bc = v0 + table.of(f[1], f[2]), ca = v0 + table.of(f[2], f[0]);
    for (const auto& t : {std::vector<int>{f[0], ab, ca}, {f[1], bc, ab}, {f[2], ca, bc}, {ab, bc, ca}})
      result.faces.push_back(t);
  }
  return result;
}

}  // namespace udcp::oracle
