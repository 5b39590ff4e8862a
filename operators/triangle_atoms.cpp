// C on triangle meshes, an atom of its own there; boundary vertices follow the curve rule. The kernel on triangles is this
// project's choice, as the paper says only that it is "slightly modified".
#include <optional>
#include <string>
#include <vector>

#include "operators/atoms.h"
#include "operators/rows.h"

namespace udcp {
namespace {

std::size_t at(int k) { return Mesh::i(k); }

template <class S>
class TriangleConvolution {
 public:
  TriangleConvolution(const Surface<S>& shape, const KernelWeights<S>* weights)
      : shape_(shape), mesh_(*shape.mesh), weights_(weights != nullptr && weights->is_one() ? nullptr : weights) {}

  Points<S> run() {
    result_ = zero_rows<S>(shape_.points.rows(), shape_.points.cols());
    for (int v = 0; v < mesh_.vertices(); ++v) {
      if (shape_.tags.is_corner(v)) {
        add_row(result_, v, S(1), shape_.points, v);
      } else if (mesh_.on_boundary(v)) {
        boundary_vertex(v);
      } else if (weights_ != nullptr) {
        inner_vertex(v);
      } else {
        add_row(result_, v, mean(mesh_.valence(v)).own, shape_.points, v);
      }
    }
    if (weights_ == nullptr) add_neighbours();
    return std::move(result_);
  }

 private:
  [[nodiscard]] S weight(int v) const { return weights_ != nullptr && weights_->origin.is_old(v) ? weights_->f.plain[v] : S(1); }

  void check(int v, const S& sum) const {
    if (is_nonzero(sum)) return;
    throw Error(ErrorKind::input, "E_WEIGHT",
                "the weights of C at vertex " + std::to_string(v) + " sum to " + to_text(sum) + ", so they have no average",
                "choose another kernel f");
  }

  // The weights of inner_vertex for w = 1, once per valence.
  struct Mean {
    S own, each;
  };
  const Mean& mean(int n) {
    if (at(n) >= means_.size()) means_.resize(at(n) + 1);
    std::optional<Mean>& known = means_[at(n)];
    if (!known) {
      const S own(2), share = S(6) / S(n);
      S sum = own;
      for (int k = 0; k < n; ++k) sum += share;
      known = Mean{own / sum, share / sum};
    }
    return *known;
  }

  // Where w = 1 the neighbours are added face by face, in the order of memory.
  void add_neighbours() {
    for (int h = 0; h < mesh_.half_edges(); ++h) {
      const int v = mesh_.vertex[at(h)];
      if (!shape_.tags.is_corner(v) && !mesh_.on_boundary(v))
        add_row(result_, v, mean(mesh_.valence(v)).each, shape_.points, mesh_.tip(h));
    }
  }

  // (2 w_v P_v + (6/n) sum w_u P_u) / (2 w_v + (6/n) sum w_u)
  void inner_vertex(int v) {
    const S own = S(2) * weight(v), share = S(6) / S(mesh_.valence(v));
    S sum = own;
    const int first = mesh_.outgoing[at(v)];
    for (int h = first;;) {
      sum += share * weight(mesh_.tip(h));
      h = mesh_.around(h);
      if (h == first) break;
    }
    check(v, sum);
    add_row(result_, v, S(own / sum), shape_.points, v);
    for (int h = first;;) {
      const int u = mesh_.tip(h);
      add_row(result_, v, S(share * weight(u) / sum), shape_.points, u);
      h = mesh_.around(h);
      if (h == first) break;
    }
  }

  // Two D along the boundary: the mean of the weighted means of v with its two neighbours.
  void boundary_vertex(int v) {
    const int ahead = mesh_.tip(mesh_.outgoing[at(v)]), behind = mesh_.vertex[at(mesh_.boundary_arrival(v))];
    const S own = weight(v);
    for (const int u : {behind, ahead}) {
      const S sum = own + weight(u);
      check(v, sum);
      const S scale = S(1) / (S(2) * sum);
      add_row(result_, v, S(own * scale), shape_.points, v);
      add_row(result_, v, S(weight(u) * scale), shape_.points, u);
    }
  }

  const Surface<S>& shape_;
  const Mesh& mesh_;
  const KernelWeights<S>* weights_;
  Points<S> result_;
  std::vector<std::optional<Mean>> means_;  // by valence
};

}  // namespace

template <class S>
Points<S> convolve_triangles(const Surface<S>& shape, const KernelWeights<S>* weights) {
  return TriangleConvolution<S>(shape, weights).run();
}

#define UDCP_INSTANTIATE(S) template Points<S> convolve_triangles(const Surface<S>&, const KernelWeights<S>*);
UDCP_FOR_EACH_NUMBER(UDCP_INSTANTIATE)
#undef UDCP_INSTANTIATE

}  // namespace udcp
