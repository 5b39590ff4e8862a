// A walk over both meshes at once.
#include "operators/plan/correspondence.h"

#include <algorithm>
#include <utility>

namespace udcp {
namespace {

class Walk {
 public:
  Walk(const Mesh& a, const Mesh& b) : a_(a), b_(b), half_(a.vertex.size(), -1), vertex_(Mesh::i(a.vertices()), -1) {
    used_.assign(b.vertex.size(), 0);
  }

  [[nodiscard]] bool has_reached(int half_a) const { return half_[Mesh::i(half_a)] >= 0; }

  /// All that can be reached from two half-edges that correspond; false where the meshes differ there.
  bool from(int half_a, int half_b) {
    std::vector<int> stack{half_a};
    half_[Mesh::i(half_a)] = half_b;
    while (!stack.empty()) {
      const int h = stack.back(), g = half_[Mesh::i(h)];
      stack.pop_back();
      if (used_[Mesh::i(g)]++ != 0) return false;
      int& v = vertex_[Mesh::i(a_.vertex[Mesh::i(h)])];
      if (v >= 0 && v != b_.vertex[Mesh::i(g)]) return false;
      v = b_.vertex[Mesh::i(g)];
      for (const auto& [next, other] : {std::pair{a_.next(h), b_.next(g)}, {a_.twin[Mesh::i(h)], b_.twin[Mesh::i(g)]}}) {
        if ((next < 0) != (other < 0)) return false;
        if (next < 0) continue;
        int& known = half_[Mesh::i(next)];
        if (known >= 0 && known != other) return false;
        if (known >= 0) continue;
        known = other;
        stack.push_back(next);
      }
    }
    return true;
  }

  /// Empty unless all vertices have been reached.
  std::vector<int> vertices() {
    return std::find(vertex_.begin(), vertex_.end(), -1) == vertex_.end() ? std::move(vertex_) : std::vector<int>{};
  }

 private:
  const Mesh &a_, &b_;
  std::vector<int> half_, vertex_;
  std::vector<char> used_;
};

bool have_equal_sizes(const Mesh& a, const Mesh& b) {
  return a.vertices() == b.vertices() && a.faces() == b.faces() && a.half_edges() == b.half_edges();
}

}  // namespace

template <class R>
Mesh half_edges_of(const FlatMesh<R>& flat) {
  std::vector<int> begin{0}, corners(flat.corners.begin(), flat.corners.end());
  for (std::int64_t f = 0; f < flat.faces(); ++f) begin.push_back(begin.back() + flat.corners_per_face);
  return make_mesh(static_cast<int>(flat.vertices()), std::move(begin), std::move(corners));
}
template Mesh half_edges_of(const FlatMesh<float>&);
template Mesh half_edges_of(const FlatMesh<double>&);

std::vector<int> correspondence(const Mesh& a, int half_a, const Mesh& b, int half_b) {
  if (!have_equal_sizes(a, b)) return {};
  Walk walk(a, b);
  return walk.from(half_a, half_b) ? walk.vertices() : std::vector<int>{};
}

std::vector<int> numbers_in_plan(const Mesh& made_by_run, const Mesh& made_by_plan, const Mesh& planned) {
  if (!have_equal_sizes(made_by_run, made_by_plan)) return {};
  const int block = made_by_run.half_edges() / planned.faces();
  Walk walk(made_by_run, made_by_plan);
  for (int f = 0; f < planned.faces(); ++f) {
    if (walk.has_reached(block * f)) continue;
    const int corner = planned.vertex[Mesh::i(planned.face_begin[Mesh::i(f)])];
    int half = block * f;
    while (half < block * (f + 1) && made_by_plan.vertex[Mesh::i(half)] != corner) ++half;
    if (half == block * (f + 1) || !walk.from(block * f, half)) return {};
  }
  return walk.vertices();
}

}  // namespace udcp
