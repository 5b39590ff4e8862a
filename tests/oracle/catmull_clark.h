// Catmull-Clark as the textbooks have it, on lists of faces: face points, edge points, vertex points, cubic spline boundaries,
// corners. Shares nothing with operators/ but the number types.
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "operators/number.h"

namespace udcp::oracle {

/// Edges of a list of faces by first appearance, and what lies around them.
struct EdgeTable {
  struct Edge {
    int a, b;
    std::vector<int> faces;
  };
  std::vector<Edge> edges;
  std::map<std::pair<int, int>, int> index;

  explicit EdgeTable(const std::vector<std::vector<int>>& faces) {
    for (std::size_t f = 0; f < faces.size(); ++f) {
      for (std::size_t k = 0; k < faces[f].size(); ++k) {
        const int a = faces[f][k], b = faces[f][(k + 1) % faces[f].size()];
        const auto [found, is_new] = index.try_emplace(std::minmax(a, b), static_cast<int>(edges.size()));
        if (is_new) edges.push_back({a, b, {}});
        edges[static_cast<std::size_t>(found->second)].faces.push_back(static_cast<int>(f));
      }
    }
  }
  [[nodiscard]] int of(int a, int b) const { return index.at(std::minmax(a, b)); }
};

template <class S>
struct Refined {
  std::vector<std::vector<int>> faces;
  Points<S> points;
};

/// Midpoints of edges (boundary only, or all) as one row.
template <class S>
Eigen::Matrix<S, 1, Eigen::Dynamic> middle(const Points<S>& points, int a, int b) {
  return (points.row(a) + points.row(b)) / S(2);
}

/// The cubic spline rule on the boundary: (a + 6 v + b)/8; corners stay. Writes the rows of all boundary vertices.
template <class S>
void boundary_vertices(const EdgeTable& table, const Points<S>& points, const std::vector<char>& corner, Points<S>& result) {
  std::map<int, std::vector<int>> ends;
  for (const auto& e : table.edges) {
    if (e.faces.size() != 1) continue;
    ends[e.a].push_back(e.b);
    ends[e.b].push_back(e.a);
  }
  for (const auto& [v, other] : ends) {
    if (!corner.empty() && corner[static_cast<std::size_t>(v)] != 0) {
      result.row(v) = points.row(v);
    } else {
      result.row(v) = (points.row(other[0]) + S(6) * points.row(v) + points.row(other[1])) / S(8);
    }
  }
}

template <class S>
Refined<S> catmull_clark_step(const std::vector<std::vector<int>>& faces, const Points<S>& points,
                              const std::vector<char>& corner = {}) {
  const EdgeTable table(faces);
  const int v0 = static_cast<int>(points.rows()), e0 = static_cast<int>(table.edges.size()), f0 = static_cast<int>(faces.size());
  Refined<S> result{{}, Points<S>::Zero(v0 + e0 + f0, points.cols())};
  Points<S>& fine = result.points;
  std::vector<int> valence(static_cast<std::size_t>(v0), 0);
  for (int f = 0; f < f0; ++f) {
    const auto& face = faces[static_cast<std::size_t>(f)];
    for (const int v : face) fine.row(v0 + e0 + f) += points.row(v) / S(static_cast<int>(face.size()));
    for (const int v : face) ++valence[static_cast<std::size_t>(v)];
  }
  for (int e = 0; e < e0; ++e) {
    const auto& edge = table.edges[static_cast<std::size_t>(e)];
    fine.row(v0 + e) = middle(points, edge.a, edge.b);
    if (edge.faces.size() == 2)
      fine.row(v0 + e) = (fine.row(v0 + e) + middle(fine, v0 + e0 + edge.faces[0], v0 + e0 + edge.faces[1])) / S(2);
  }
  // (Q + 2 R + (n - 3) V)/n, with Q the mean of the face points and R that of the edge midpoints
  for (int v = 0; v < v0; ++v)
    fine.row(v) = S(valence[static_cast<std::size_t>(v)] - 3) * points.row(v) / S(valence[static_cast<std::size_t>(v)]);
  for (int f = 0; f < f0; ++f)
    for (const int v : faces[static_cast<std::size_t>(f)]) {
      const S n(valence[static_cast<std::size_t>(v)]);
      fine.row(v) += fine.row(v0 + e0 + f) / (n * n);
    }
  for (const auto& edge : table.edges)
    for (const int v : {edge.a, edge.b}) {
      const S n(valence[static_cast<std::size_t>(v)]);
      fine.row(v) += S(2) * middle(points, edge.a, edge.b) / (n * n);
    }
  boundary_vertices(table, points, corner, fine);
  for (int f = 0; f < f0; ++f) {
    const auto& face = faces[static_cast<std::size_t>(f)];
    for (std::size_t k = 0; k < face.size(); ++k) {
      const int before = face[(k + face.size() - 1) % face.size()], after = face[(k + 1) % face.size()];
      result.faces.push_back({face[k], v0 + table.of(face[k], after), v0 + e0 + f, v0 + table.of(before, face[k])});
    }
  }
  return result;
}

}  // namespace udcp::oracle
