// Codes to kinds, and kinds to one mesh.
#include "operators/plan/face_kinds.h"

#include <algorithm>

#include "operators/interrupt.h"

namespace udcp {
namespace {

std::size_t at(int k) { return static_cast<std::size_t>(k); }

// The mixing function of splitmix64, shortened.
std::uint64_t hash_of(const std::vector<int>& code) {
  std::uint64_t hash = code.size();
  for (const int value : code) {
    hash = (hash ^ static_cast<std::uint64_t>(value)) * 0x9E3779B97F4A7C15ULL;
    hash ^= hash >> 29U;
  }
  return hash;
}

}  // namespace

template <int N>
int FaceKinds<N>::find(const std::vector<int>& code, std::vector<int>*& candidates) {
  if (!kinds_.empty() && kinds_[at(last_)].code == code) return last_;
  candidates = &by_hash_[hash_of(code)];
  for (const int k : *candidates)
    if (kinds_[at(k)].code == code) return k;
  return -1;
}

template <int N>
int FaceKinds<N>::add(const FaceRings& rings, const RingWalker<N>& walker, const Tags& tags, const Mesh& mesh) {
  std::vector<int>* candidates = nullptr;
  const int known = find(rings.code, candidates);
  if (known >= 0) {
    ++kinds_[at(known)].faces;
    return last_ = known;
  }
  FaceKind kind{rings.code, walker.twins(), {}, {}, static_cast<int>(rings.vertex.size()), 1};
  if (!tags.corner.empty())
    for (const int v : rings.vertex) kind.corner.push_back(tags.corner[at(v)]);
  if (!tags.edge.empty())
    for (const int half : rings.half)
      for (int k = 0; k < N; ++k) kind.edge.push_back(tags.of_edge(mesh.edge[at(half / N * N + (half + k) % N)]));
  candidates->push_back(size());
  kinds_.push_back(std::move(kind));
  return last_ = size() - 1;
}

template <int N>
int FaceKinds<N>::most_vertices() const {
  int most = 0;
  for (const FaceKind& kind : kinds_) most = std::max(most, kind.vertices);
  return most;
}

template <int N>
typename FaceKinds<N>::Sheet FaceKinds<N>::sheet() const {
  Sheet sheet{{}, {}, {0}, {0}};
  Mesh& mesh = sheet.mesh;
  for (const FaceKind& kind : kinds_) {
    const int vertex = sheet.first_vertex.back(), face = sheet.first_face.back();
    for (std::size_t h = 0; h < kind.twin.size(); ++h) {
      mesh.vertex.push_back(vertex + kind.code[h]);
      mesh.twin.push_back(kind.twin[h] < 0 ? -1 : N * face + kind.twin[h]);
      mesh.face.push_back(face + static_cast<int>(h) / N);
    }
    sheet.first_vertex.push_back(vertex + kind.vertices);
    sheet.first_face.push_back(face + static_cast<int>(kind.twin.size()) / N);
    sheet.tags.corner.insert(sheet.tags.corner.end(), kind.corner.begin(), kind.corner.end());
  }
  for (int f = 0; f <= sheet.first_face.back(); ++f) mesh.face_begin.push_back(N * f);
  complete_mesh(mesh, sheet.first_vertex.back());
  if (kinds_.empty() || kinds_[0].edge.empty()) return sheet;
  for (const int h : mesh.edge_half) {
    const auto after = std::upper_bound(sheet.first_face.begin(), sheet.first_face.end(), h / N);
    const auto kind = static_cast<std::size_t>(after - sheet.first_face.begin()) - 1;
    sheet.tags.edge.push_back(kinds_[kind].edge[at(h - N * sheet.first_face[kind])]);
  }
  return sheet;
}

template <int N>
FaceGroups<N> group_faces(const Mesh& mesh, const Tags& tags, int rings, int most_kinds, const std::atomic<bool>* stop) {
  FaceGroups<N> groups;
  const Starts<N> starts(mesh, tags, rings);
  RingWalker<N> walker(mesh, tags, rings);
  groups.kind.reserve(at(mesh.faces()));
  groups.start.reserve(at(mesh.faces()));
  groups.first_vertex.reserve(at(mesh.faces()) + 1);
  groups.first_vertex.push_back(0);
  for (int f = 0; f < mesh.faces() && groups.kinds.size() <= most_kinds; ++f) {
    if (f % 1024 == 0) throw_if_stopped(stop);
    const int start = starts.of_face(f);
    const FaceRings& around = walker.around(start);
    groups.kind.push_back(groups.kinds.add(around, walker, tags, mesh));
    groups.start.push_back(start);
    groups.vertex.insert(groups.vertex.end(), around.vertex.begin(), around.vertex.end());
    groups.first_vertex.push_back(groups.vertex.size());
  }
  return groups;
}

#define UDCP_INSTANTIATE(N)    \
  template class FaceKinds<N>; \
  template FaceGroups<N> group_faces(const Mesh&, const Tags&, int, int, const std::atomic<bool>*);
UDCP_INSTANTIATE(3)
UDCP_INSTANTIATE(4)
#undef UDCP_INSTANTIATE

}  // namespace udcp
