// Adjustable and hybrid Catmull-Clark as their definition has it, on lists of faces: face, edge and vertex rules with a parameter
// per vertex, curve rules on the boundary, vertices with one face fixed. Shares nothing with operators/ but the number types.
#pragma once

#include "tests/oracle/catmull_clark.h"

namespace udcp::oracle {

template <class S>
struct Adjusted {
  std::vector<std::vector<int>> faces;
  Points<S> points;
  std::vector<S> c;
};

/// edge point: (1-c)(a + b)/2 + c (F1 + F2)/2; vertex: (4 c^2 Q + 8 c (1-c) R + (n - 4c(2-c)) v)/n; boundary: midpoint, and
/// (1 - c/2) v + c/4 (left + right).
template <class S>
Adjusted<S> adjustable_step(const Adjusted<S>& before) {
  const auto at = [](int k) { return static_cast<std::size_t>(k); };
  const EdgeTable table(before.faces);
  const Points<S>& p = before.points;
  const int v0 = static_cast<int>(p.rows()), e0 = static_cast<int>(table.edges.size()),
            f0 = static_cast<int>(before.faces.size());
  Adjusted<S> result{{}, Points<S>::Zero(v0 + e0 + f0, p.cols()), before.c};
  Points<S>& fine = result.points;
  for (const auto& edge : table.edges) result.c.push_back((before.c[at(edge.a)] + before.c[at(edge.b)]) / S(2));
  std::vector<int> faces_at(at(v0), 0), edges_at(at(v0), 0);
  std::vector<char> open(at(v0), 0);
  Points<S> sum_q = Points<S>::Zero(v0, p.cols()), sum_r = sum_q, sum_side = sum_q;
  for (int f = 0; f < f0; ++f) {
    const auto& face = before.faces[at(f)];
    S mean(0);
    for (const int v : face) {
      fine.row(v0 + e0 + f) += p.row(v) / S(static_cast<int>(face.size()));
      mean += before.c[at(v)] / S(static_cast<int>(face.size()));
    }
    result.c.push_back(mean);
    for (const int v : face) sum_q.row(v) += fine.row(v0 + e0 + f), ++faces_at[at(v)];
  }
  for (int e = 0; e < e0; ++e) {
    const auto& edge = table.edges[at(e)];
    const S& c = result.c[at(v0 + e)];
    fine.row(v0 + e) = middle(p, edge.a, edge.b);
    for (const auto& [v, other] : {std::pair{edge.a, edge.b}, std::pair{edge.b, edge.a}}) {
      sum_r.row(v) += middle(p, edge.a, edge.b), ++edges_at[at(v)];
      if (edge.faces.size() == 1) sum_side.row(v) += p.row(other), open[at(v)] = 1;
    }
    if (edge.faces.size() == 2)
      fine.row(v0 + e) = (S(1) - c) * fine.row(v0 + e) + c * middle(fine, v0 + e0 + edge.faces[0], v0 + e0 + edge.faces[1]);
  }
  for (int v = 0; v < v0; ++v) {
    const S &c = before.c[at(v)], n(edges_at[at(v)]);
    if (open[at(v)] == 0) {
      fine.row(v) =
          (S(4) * c * c / n * sum_q.row(v) + S(8) * c * (S(1) - c) / n * sum_r.row(v) + (n - S(4) * c * (S(2) - c)) * p.row(v)) /
          n;
    } else if (faces_at[at(v)] == 1) {
      fine.row(v) = p.row(v);
    } else {
      fine.row(v) = (S(1) - c / S(2)) * p.row(v) + c / S(4) * sum_side.row(v);
    }
  }
  for (int f = 0; f < f0; ++f) {
    const auto& face = before.faces[at(f)];
    for (std::size_t k = 0; k < face.size(); ++k) {
      const int before_k = face[(k + face.size() - 1) % face.size()], after = face[(k + 1) % face.size()];
      result.faces.push_back({face[k], v0 + table.of(face[k], after), v0 + e0 + f, v0 + table.of(before_k, face[k])});
    }
  }
  return result;
}

}  // namespace udcp::oracle
