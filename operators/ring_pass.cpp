// The second pass of surfaces of revolution: rings of tagged edges become circles. operators specification: the rule reproduces
// 1, t, cos and sin, so a regular ring stays on its circle. push-back, section on surfaces of revolution.
#include <array>
#include <string>
#include <utility>

#include "operators/atoms.h"

namespace udcp {
namespace {

std::size_t at(int k) { return Mesh::i(k); }

// The four-point rule that is exact on circles, at the odd point i; p holds the four even points in order.
template <class S>
void four_point(Points<S>& points, int i, const std::array<int, 4>& p, const S& c) {
  const S denominator = S(8) * c * (S(1) + c);
  if (!is_nonzero(denominator))
    throw Error(ErrorKind::input, "E_DIV0", "the ring pass divides by c(1 + c) with c = cos(alpha/2) = " + to_text(c),
                "choose alpha0 = 2*pi/m for rings of m >= 3 points");
  const S w = S(1) / denominator, near = S(1) / S(2) + w;
  points.row(i).setZero();
  add(points, i, S(-w), points, p[0]);
  add(points, i, near, points, p[1]);
  add(points, i, near, points, p[2]);
  add(points, i, S(-w), points, p[3]);
}

// Per vertex the other ends of its edges tagged t, if there are exactly two; otherwise -1, -1.
std::vector<std::array<int, 2>> ring_neighbours(const Mesh& mesh, const Tags& tags, EdgeTag t) {
  std::vector<std::array<int, 2>> ends(at(mesh.vertices()), {-1, -1});
  std::vector<int> count(at(mesh.vertices()), 0);
  for (int e = 0; e < mesh.edges(); ++e) {
    if (tags.of_edge(e) != t) continue;
    const int h = mesh.edge_half[at(e)], a = mesh.vertex[at(h)], b = mesh.tip(h);
    for (const auto& [from, to] : {std::pair{a, b}, {b, a}})
      if (const int k = count[at(from)]++; k < 2) ends[at(from)][at(k)] = to;
  }
  for (std::size_t v = 0; v < ends.size(); ++v)
    if (count[v] != 2) ends[v] = {-1, -1};
  return ends;
}

int other_end(const std::array<int, 2>& ends, int end) { return ends[0] < 0 ? -1 : ends[0] == end ? ends[1] : ends[0]; }

// The cross edge one face further: from half-edge h (a cross edge seen from inside the face that is left) to the one opposite in
// the neighbouring face; -1 where that face is missing or not alternately tagged.
int next_cross_edge(const Mesh& mesh, const Tags& tags, int h) {
  const int twin = mesh.twin[at(h)];
  if (twin < 0 || !is_alternately_tagged(mesh, tags, mesh.face[at(twin)])) return -1;
  return mesh.edge[at(mesh.next(mesh.next(twin)))];
}

}  // namespace

template <class S>
Points<S> ring_pass(Points<S> current, const Surface<S>& before, EdgeTag direction, const Parameter<S>& cosine_of_half_alpha) {
  const Mesh& mesh = *before.mesh;
  const std::vector<std::array<int, 2>> ends = ring_neighbours(mesh, before.tags, direction);
  const int first_edge_point = mesh.vertices(), first_face_point = first_edge_point + mesh.edges();
  for (int e = 0; e < mesh.edges(); ++e) {
    if (before.tags.of_edge(e) != direction) continue;
    const int h = mesh.edge_half[at(e)], a = mesh.vertex[at(h)], b = mesh.tip(h), i = first_edge_point + e;
    const int past_a = other_end(ends[at(a)], b), past_b = other_end(ends[at(b)], a);
    if (past_a >= 0 && past_b >= 0) four_point(current, i, {past_a, a, b, past_b}, cosine_of_half_alpha[i]);
  }
  for (int f = 0; f < mesh.faces(); ++f) {
    if (!is_alternately_tagged(mesh, before.tags, f)) continue;
    const int h = mesh.face_begin[at(f)] + (before.tags.of_edge(mesh.edge[at(mesh.face_begin[at(f)])]) == direction ? 1 : 0);
    const int opposite_half = mesh.next(mesh.next(h)), i = first_face_point + f;
    const int past = next_cross_edge(mesh, before.tags, h), past_opposite = next_cross_edge(mesh, before.tags, opposite_half);
    if (past < 0 || past_opposite < 0) continue;
    four_point(current, i,
               {first_edge_point + past, first_edge_point + mesh.edge[at(h)], first_edge_point + mesh.edge[at(opposite_half)],
                first_edge_point + past_opposite},
               cosine_of_half_alpha[i]);
  }
  return current;
}

#define UDCP_INSTANTIATE(S) template Points<S> ring_pass(Points<S>, const Surface<S>&, EdgeTag, const Parameter<S>&);
UDCP_FOR_EACH_NUMBER(UDCP_INSTANTIATE)
#undef UDCP_INSTANTIATE

}  // namespace udcp
