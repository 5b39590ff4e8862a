// Breadth-first from the corners of a face, counter-clockwise around each vertex from where it was found.
#include "operators/plan/face_rings.h"

namespace udcp {
namespace {

std::size_t at(int k) { return static_cast<std::size_t>(k); }

// Arithmetic on half-edges where every face has N corners.
template <int N>
int next(int h) {
  return static_cast<unsigned>(h) % N == N - 1 ? h - (N - 1) : h + 1;
}
template <int N>
int prev(int h) {
  return static_cast<unsigned>(h) % N == 0 ? h + (N - 1) : h - 1;
}

// The mixing function of murmur3.
std::uint32_t scramble(std::uint32_t value) {
  value = (value ^ (value >> 16U)) * 0x85EBCA6BU;
  value = (value ^ (value >> 13U)) * 0xC2B2AE35U;
  return value ^ (value >> 16U);
}

}  // namespace

template <int N>
RingWalker<N>::RingWalker(const Mesh& mesh, const Tags& tags, int rings)
    : mesh_(mesh), tags_(tags), rings_(rings), vertex_mark_(at(mesh.vertices())), face_mark_(at(mesh.faces())) {}

template <int N>
int RingWalker<N>::find(int v) {
  Mark& mark = vertex_mark_[at(v)];
  if (mark.walk == walk_) return mark.local;
  mark = {walk_, static_cast<int>(found_.vertex.size())};
  found_.vertex.push_back(v);
  return mark.local;
}

template <int N>
void RingWalker<N>::add_face(int half) {
  Mark& mark = face_mark_[static_cast<unsigned>(half) / N];
  if (mark.walk == walk_) return;
  mark = {walk_, static_cast<int>(found_.half.size())};
  found_.half.push_back(half);
  int h = half;
  for (int k = 0; k < N; ++k, h = next<N>(h)) {
    const int known = static_cast<int>(found_.vertex.size()), local = find(mesh_.vertex[at(h)]);
    if (local == known) first_half_.push_back(h);
    found_.code.push_back(local);
  }
}

template <int N>
void RingWalker<N>::expand(int k) {
  const int v = found_.vertex[at(k)];
  const int first = mesh_.on_boundary(v) ? mesh_.outgoing[at(v)] : first_half_[at(k)];
  for (int h = first; h >= 0;) {
    add_face(h);
    h = mesh_.twin[at(prev<N>(h))];
    if (h == first) break;
  }
}

template <int N>
void RingWalker<N>::write_tags(int inner) {
  if (!tags_.corner.empty())
    for (int k = 0; k < inner; ++k) found_.code.push_back(tags_.is_corner(found_.vertex[at(k)]) ? 1 : 0);
  if (tags_.edge.empty()) return;
  for (const int half : found_.half) {
    int h = half;
    for (int k = 0; k < N; ++k, h = next<N>(h)) found_.code.push_back(static_cast<int>(tags_.of_edge(mesh_.edge[at(h)])));
  }
}

template <int N>
const FaceRings& RingWalker<N>::around(int start) {
  ++walk_;
  found_.vertex.clear();
  found_.half.clear();
  found_.code.clear();
  first_half_.clear();
  add_face(start);
  int begin = 0;
  for (int ring = 0; ring < rings_; ++ring) {
    const int end = static_cast<int>(found_.vertex.size());
    for (int k = begin; k < end; ++k) expand(k);
    begin = end;
  }
  write_tags(begin);
  return found_;
}

template <int N>
std::vector<int> RingWalker<N>::twins() const {
  std::vector<int> result;
  for (const int half : found_.half) {
    int h = half;
    for (int k = 0; k < N; ++k, h = next<N>(h)) {
      const int twin = mesh_.twin[at(h)];
      if (twin < 0 || face_mark_[at(twin / N)].walk != walk_) {
        result.push_back(-1);
        continue;
      }
      const int face = face_mark_[at(twin / N)].local, first = found_.half[at(face)];
      result.push_back(N * face + (twin - first + N) % N);
    }
  }
  return result;
}

namespace {

// What one sees at a vertex with all of its faces.
std::vector<std::uint32_t> vertex_colours(const Mesh& mesh, const Tags& tags) {
  std::vector<std::uint32_t> colour(at(mesh.vertices()));
  for (int v = 0; v < mesh.vertices(); ++v)
    colour[at(v)] = scramble(4U * static_cast<std::uint32_t>(mesh.valence(v)) + (mesh.on_boundary(v) ? 2U : 0U) +
                             (tags.is_corner(v) ? 1U : 0U));
  return colour;
}

// The same, one ring further: sums over the faces around, so that the order around the vertex does not matter.
template <int N>
std::vector<std::uint32_t> widen(const Mesh& mesh, const std::vector<std::uint32_t>& colour) {
  std::vector<std::uint32_t> wide(colour.size());
  for (std::size_t v = 0; v < colour.size(); ++v) wide[v] = scramble(colour[v] + 1U);
  for (int h = 0; h < mesh.half_edges(); ++h) {
    const auto of = [&](int half) { return colour[at(mesh.vertex[at(half)])]; };
    const int ahead = next<N>(h), behind = prev<N>(h);
    std::uint32_t sum = (of(ahead) ^ 0x5BD1E995U) * 0x27D4EB2FU + (of(behind) ^ 0x165667B1U) * 0x9E3779B1U;
    if constexpr (N == 4) sum += (of(next<N>(ahead)) ^ 0x85EBCA77U) * 0xC2B2AE3DU;
    wide[at(mesh.vertex[at(h)])] += sum;
  }
  return wide;
}

}  // namespace

template <int N>
Starts<N>::Starts(const Mesh& mesh, const Tags& tags, int rings) : key_(at(mesh.half_edges())) {
  std::vector<std::uint32_t> colour = vertex_colours(mesh, tags);
  for (int ring = 1; ring < rings; ++ring) colour = widen<N>(mesh, colour);
  for (int h = 0; h < mesh.half_edges(); ++h) {
    const std::uint32_t edge =
        2U * static_cast<std::uint32_t>(tags.of_edge(mesh.edge[at(h)])) + (rings > 0 && mesh.twin[at(h)] < 0 ? 1U : 0U);
    key_[at(h)] = scramble((rings > 0 ? colour[at(mesh.vertex[at(h)])] : 0U) + 0x9E3779B9U * edge);
  }
}

template <int N>
int Starts<N>::of_face(int f) const {
  const std::uint32_t* key = key_.data() + at(N * f);
  const auto smaller = [&](int a, int b) {
    for (int k = 0; k < N; ++k) {
      const std::uint32_t left = key[(a + k) % N], right = key[(b + k) % N];
      if (left != right) return left < right;
    }
    return false;
  };
  int best = 0;
  for (int k = 1; k < N; ++k)
    if (smaller(k, best)) best = k;
  return N * f + best;
}

template class RingWalker<3>;
template class RingWalker<4>;
template class Starts<3>;
template class Starts<4>;

}  // namespace udcp
