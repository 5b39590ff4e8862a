// Breadth-first from the centre: faces counter-clockwise round each vertex, from the half-edge by which it was found.
#include "operators/neighbourhood.h"

#include <algorithm>

namespace udcp {
namespace {

std::size_t at(int k) { return Mesh::i(k); }

class Collector {
 public:
  Collector(const Mesh& mesh, const Tags& tags) : mesh_(mesh), tags_(tags) {}

  Neighbourhood collect(int start, int rings) {
    find(mesh_.vertex[at(start)], start);
    int begin = 0;
    for (int ring = 0; ring < rings; ++ring) {
      const int end = static_cast<int>(result_.vertex.size());
      for (int k = begin; k < end; ++k) expand(k);
      begin = end;
    }
    inner_ = begin;
    finish();
    return std::move(result_);
  }

 private:
  // A neighbourhood is small: a linear search beats a hash table.
  static int position(const std::vector<int>& list, int value) {
    const auto found = std::find(list.begin(), list.end(), value);
    return found == list.end() ? -1 : static_cast<int>(found - list.begin());
  }

  int find(int v, int half) {
    const int known = position(result_.vertex, v);
    if (known >= 0) return known;
    result_.vertex.push_back(v);
    first_half_.push_back(mesh_.on_boundary(v) ? mesh_.outgoing[at(v)] : half);
    return static_cast<int>(result_.vertex.size()) - 1;
  }

  void expand(int k) {
    const int first = first_half_[at(k)];
    for (int h = first; h >= 0;) {
      add_face(h);
      h = mesh_.around(h);
      if (h == first) break;
    }
  }

  void add_face(int first) {
    if (position(faces_, mesh_.face[at(first)]) >= 0) return;
    faces_.push_back(mesh_.face[at(first)]);
    const int f = static_cast<int>(result_.mesh.face_begin.size());
    result_.mesh.face_begin.push_back(static_cast<int>(half_.size()));
    int h = first;
    do {
      half_.push_back(h);
      result_.mesh.vertex.push_back(find(mesh_.vertex[at(h)], h));
      result_.mesh.face.push_back(f);
      h = mesh_.next(h);
    } while (h != first);
  }

  void finish() {
    Mesh& local = result_.mesh;
    local.face_begin.push_back(static_cast<int>(half_.size()));
    for (const int h : half_) local.twin.push_back(mesh_.twin[at(h)] < 0 ? -1 : position(half_, mesh_.twin[at(h)]));
    complete_mesh(local, static_cast<int>(result_.vertex.size()));
    auto& signature = result_.signature;
    for (int f = 0; f < local.faces(); ++f) {
      signature.push_back(-local.size(f));
      signature.insert(signature.end(), local.corners(f).begin(), local.corners(f).end());
    }
    if (!tags_.corner.empty()) result_.tags.corner.resize(result_.vertex.size());
    for (std::size_t k = 0; k < result_.vertex.size(); ++k) {
      const int v = result_.vertex[k];
      if (!tags_.corner.empty()) result_.tags.corner[k] = tags_.corner[at(v)];
      signature.push_back((static_cast<int>(k) < inner_ && mesh_.on_boundary(v) ? 1 : 0) + (tags_.is_corner(v) ? 2 : 0));
    }
    if (tags_.edge.empty()) return;
    for (const int h : local.edge_half) {
      result_.tags.edge.push_back(tags_.of_edge(mesh_.edge[at(half_[at(h)])]));
      signature.push_back(static_cast<int>(result_.tags.edge.back()));
    }
  }

  const Mesh& mesh_;
  const Tags& tags_;
  Neighbourhood result_;
  std::vector<int> faces_;              // of the original
  std::vector<int> first_half_, half_;  // per local vertex, per local half-edge: half-edges of the original
  int inner_ = 0;                       // vertices below this index have all their faces
};

}  // namespace

Neighbourhood neighbourhood(const Mesh& mesh, const Tags& tags, int start, int rings) {
  return Collector(mesh, tags).collect(start, rings);
}

}  // namespace udcp
