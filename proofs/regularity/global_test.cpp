// T1: every edge of a component, once, in one frame.
#include "proofs/regularity/global_test.h"

#include <algorithm>

#include "proofs/regularity/adaptive.h"

namespace udcp {
namespace {

/// Components of faces that share edges, numbered by their first face.
std::vector<int> components(const Mesh& mesh, int& count) {
  std::vector<int> result(static_cast<std::size_t>(mesh.faces()), -1), stack;
  for (int start = 0; start < mesh.faces(); ++start) {
    if (result[static_cast<std::size_t>(start)] >= 0) continue;
    stack.push_back(start);
    result[static_cast<std::size_t>(start)] = count;
    while (!stack.empty()) {
      const int f = stack.back();
      stack.pop_back();
      for (int side = 0; side < mesh.size(f); ++side) {
        const int across = mesh.twin[static_cast<std::size_t>(mesh.face_begin[static_cast<std::size_t>(f)] + side)];
        if (across < 0) continue;
        int& other = result[static_cast<std::size_t>(mesh.face[static_cast<std::size_t>(across)])];
        if (other >= 0) continue;
        other = count;
        stack.push_back(mesh.face[static_cast<std::size_t>(across)]);
      }
    }
    ++count;
  }
  return result;
}

std::optional<RegularityWitness> separate(const Differences& d) {
  const auto has_zero = [](const std::vector<Vector3>& list) {
    return std::any_of(list.begin(), list.end(), [](const Vector3& w) { return is_zero(w); });
  };
  if (has_zero(d.u) || has_zero(d.v)) return std::nullopt;
  return separating_pair({d.u, d.v});
}

}  // namespace

std::string to_string(GlobalStatus status) {
  return status == GlobalStatus::pass ? "pass" : status == GlobalStatus::fail ? "fail" : "noframe";
}

std::optional<std::vector<Differences>> edge_differences(const QuadMesh& mesh) {
  const Mesh& m = mesh.mesh();
  const std::optional<std::vector<int>> frame = global_frame(m);
  if (!frame) return std::nullopt;
  int count = 0;
  const std::vector<int> component = components(m, count);
  std::vector<Differences> result(static_cast<std::size_t>(count));
  for (const int h : m.edge_half) {
    const auto face = static_cast<std::size_t>(m.face[static_cast<std::size_t>(h)]);
    const int turn = (h - m.face_begin[face] - (*frame)[face] + 4) % 4;  // 0: +u, 1: +v, 2: -u, 3: -v
    Vector3 d = mesh.point(m.tip(h)) - mesh.point(m.vertex[static_cast<std::size_t>(h)]);
    if (turn >= 2) d = -d;
    Differences& into = result[static_cast<std::size_t>(component[face])];
    (turn % 2 == 0 ? into.u : into.v).push_back(std::move(d));
  }
  return result;
}

GlobalResult test_globally(const QuadMesh& mesh) {
  const std::optional<std::vector<Differences>> all = edge_differences(mesh);
  if (!all) return {GlobalStatus::no_frame, {}};
  GlobalResult result{GlobalStatus::pass, {}};
  for (const Differences& d : *all) {
    std::optional<RegularityWitness> witness = separate(d);
    if (!witness) return {GlobalStatus::fail, {}};
    result.components.push_back(std::move(*witness));
  }
  return result;
}

bool is_rectangle(const QuadMesh& mesh) {
  int corners = 0, count = 0;
  for (int v = 0; v < mesh.mesh().vertices(); ++v) {
    const VertexClass c = mesh.class_of(v);
    if (c != VertexClass::interior && c != VertexClass::boundary && c != VertexClass::corner) return false;
    corners += c == VertexClass::corner ? 1 : 0;
  }
  components(mesh.mesh(), count);
  return count == 1 && corners == 4;
}

}  // namespace udcp
