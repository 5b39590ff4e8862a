// U, D, C[ngon = classic], P and the ring pass on polygon meshes; U and P also on triangles, where only the split differs.
// push-back, eqs. (4) to (9).
#include <array>
#include <string>

#include "operators/atoms.h"
#include "operators/columns.h"
#include "operators/rows.h"

namespace udcp {
namespace {

std::size_t at(int k) { return Mesh::i(k); }

// 1/n for the valences and face sizes that occur, computed once each: divisions are what exact numbers pay for.
template <class S>
class Reciprocals {
 public:
  const S& operator()(int n) {
    if (at(n) >= values_.size()) extend(n);
    return values_[at(n)];
  }

 private:
  void extend(int n) {
    while (at(n) >= values_.size()) values_.push_back(S(1) / S(static_cast<int>(values_.size())));
  }

  std::vector<S> values_{S(0)};
};

int boundary_edges(const Mesh& mesh) { return 2 * mesh.edges() - mesh.half_edges(); }

// Rows of the dual: faces, then boundary edges in edge order, then corners in vertex order.
template <class Edge>
int walk_boundary_edges(const Mesh& mesh, Edge edge) {
  int row = mesh.faces();
  if (boundary_edges(mesh) == 0) return row;
  for (int e = 0; e < mesh.edges(); ++e)
    if (mesh.is_boundary_edge(e)) edge(mesh.edge_half[at(e)], row++);
  return row;
}

template <class Corner>
void walk_corners(const Mesh& mesh, const Tags& tags, int row, Corner corner) {
  if (tags.corner.empty()) return;
  for (int v = 0; v < mesh.vertices(); ++v)
    if (tags.is_corner(v)) corner(v, row++);
}

template <class S>
[[noreturn]] void no_average(const std::string& where, const S& sum) {
  throw Error(ErrorKind::input, "E_WEIGHT",
              "the weights of D at " + where + " sum to " + to_text(sum) + ", so they have no average",
              "choose a kernel f with 1 + f nonzero");
}

// D from points to the dual, one row at a time.
template <class S>
class ToDual {
 public:
  ToDual(const Surface<S>& shape, const KernelWeights<S>* weights)
      : shape_(shape), mesh_(*shape.mesh), weights_(weights != nullptr && weights->is_one() ? nullptr : weights) {}

  void face(int f, Points<S>& dual, int row) {
    const std::span<const int> corners = mesh_.corners(f);
    if (weights_ == nullptr) {
      const S& share = reciprocal_(static_cast<int>(corners.size()));
      sum_rows(
          dual, row, [&](std::size_t) -> const S& { return share; }, shape_.points, corners);
      return;
    }
    weight_.clear();
    S sum(0);
    for (std::size_t k = 0; k < corners.size(); ++k) sum += weight_.emplace_back(corner_weight(f, k, corners));
    if (!is_nonzero(sum)) no_average("face " + std::to_string(f), sum);
    const S scale = S(1) / sum;
    sum_rows(
        dual, row, [&](std::size_t k) { return S(weight_[k] * scale); }, shape_.points, corners);
  }

  // The curve rule on the edge of h.
  void boundary_edge(int h, Points<S>& dual, int row) const {
    const EdgeTag tag = shape_.tags.of_edge(mesh_.edge[at(h)]);
    const std::array<int, 2> ends{mesh_.vertex[at(h)], mesh_.tip(h)};
    const auto weight = [&](int v) { return weights_ != nullptr && weights_->origin.is_old(v) ? weights_->f.at(tag)[v] : S(1); };
    const std::array<S, 2> w{weight(ends[0]), weight(ends[1])};
    const S sum = w[0] + w[1];
    if (!is_nonzero(sum)) no_average("the boundary edge " + std::to_string(ends[0]) + "-" + std::to_string(ends[1]), sum);
    sum_rows(
        dual, row, [&](std::size_t k) { return S(w[k] / sum); }, shape_.points, ends);
  }

  void corner(int v, Points<S>& dual, int row) const { dual.row(row) = shape_.points.row(v); }

 private:
  // Weight of corner k of a face in its mean: f of both its edges for an old vertex, of the edge that is no child of an old edge
  // for an E point, 1 for an F point.
  [[nodiscard]] S corner_weight(int face, std::size_t k, std::span<const int> corners) const {
    const Origin& origin = weights_->origin;
    const int v = corners[k];
    if (origin.is_in_face(v)) return S(1);
    const std::size_t before = (k == 0 ? corners.size() : k) - 1, after = k + 1 == corners.size() ? 0 : k + 1;
    const auto f = [&](std::size_t side) -> const S& {
      return weights_->f.at(shape_.tags.of_edge(mesh_.edge[at(mesh_.face_begin[at(face)]) + side]))[v];
    };
    if (origin.is_old(v)) return f(before) * f(k);
    S weight(1);
    if (origin.is_in_face(corners[after])) weight *= f(k);
    if (origin.is_in_face(corners[before])) weight *= f(before);
    return weight;
  }

  const Surface<S>& shape_;
  const Mesh& mesh_;
  const KernelWeights<S>* weights_;
  Reciprocals<S> reciprocal_;
  std::vector<S> weight_;  // of the corners of one face
};

// D from the dual back to points, which collect the rows around them. Vertices on the boundary follow the curve rule and corners
// stay, so they take nothing from faces.
template <class S>
class ToPrimal {
 public:
  ToPrimal(const Surface<S>& shape, Eigen::Index columns)
      : mesh_(*shape.mesh), tags_(shape.tags), points_(zero_rows<S>(mesh_.vertices(), columns)) {
    if (boundary_edges(mesh_) == 0 && tags_.corner.empty()) return;
    apart_.resize(at(mesh_.vertices()));
    for (int v = 0; v < mesh_.vertices(); ++v) apart_[at(v)] = mesh_.on_boundary(v) || tags_.is_corner(v);
  }

  void face(int f, const Points<S>& dual, int row) {
    const bool none_apart = apart_.empty();
    for (const int v : mesh_.corners(f))
      if (none_apart || apart_[at(v)] == 0) add_row(points_, v, reciprocal_(mesh_.valence(v)), dual, row);
  }

  void boundary_edge(int h, const Points<S>& dual, int row) {
    for (const int v : {mesh_.vertex[at(h)], mesh_.tip(h)})
      if (!tags_.is_corner(v)) add_row(points_, v, reciprocal_(2), dual, row);
  }

  void corner(int v, const Points<S>& dual, int row) { points_.row(v) = dual.row(row); }

  Points<S> points() { return std::move(points_); }

 private:
  const Mesh& mesh_;
  const Tags& tags_;
  Points<S> points_;
  std::vector<char> apart_;  // per vertex: on the boundary or a corner; empty: none
  Reciprocals<S> reciprocal_;
};

template <class S>
void split_edges(const Mesh& mesh, const Points<S>& rows, int d, Points<S>& fine) {
  for (int s = 1; s < d; ++s) {
    const std::array<S, 2> weight{S(d - s) / S(d), S(s) / S(d)};
    for (int e = 0; e < mesh.edges(); ++e) {
      const int h = mesh.edge_half[at(e)];
      const std::array<int, 2> ends{mesh.vertex[at(h)], mesh.tip(h)};
      sum_rows(
          fine, mesh.vertices() + (d - 1) * e + s - 1, [&](std::size_t k) -> const S& { return weight[k]; }, rows, ends);
    }
  }
}

template <class S>
void split_polygons(const Mesh& mesh, const Points<S>& rows, int first, Points<S>& fine) {
  Reciprocals<S> reciprocal;
  for (int f = 0; f < mesh.faces(); ++f) {
    const S& share = reciprocal(mesh.size(f));
    sum_rows(
        fine, first + f, [&](std::size_t) -> const S& { return share; }, rows, mesh.corners(f));
  }
}

// The points inside faces with these weights at the corners, every `stride`-th row from `first` on.
template <class S, std::size_t Corners>
void split_inside(const Mesh& mesh, const Points<S>& rows, const std::array<S, Corners>& weight, int first, int stride,
                  Points<S>& fine) {
  for (int f = 0; f < mesh.faces(); ++f)
    sum_rows(
        fine, first + stride * f, [&](std::size_t k) -> const S& { return weight[k]; }, rows, mesh.corners(f));
}

template <class S>
void split_quads(const Mesh& mesh, const Points<S>& rows, int d, int first, Points<S>& fine) {
  for (int y = 1; y < d; ++y) {
    for (int x = 1; x < d; ++x, ++first) {
      const S u = S(x) / S(d), v = S(y) / S(d), u1 = S(1) - u, v1 = S(1) - v;
      split_inside<S, 4>(mesh, rows, {u1 * v1, u * v1, u * v, u1 * v}, first, (d - 1) * (d - 1), fine);
    }
  }
}

template <class S>
void split_triangles(const Mesh& mesh, const Points<S>& rows, int d, int first, Points<S>& fine) {
  for (int y = 1; y < d; ++y) {
    for (int x = 1; x + y < d; ++x, ++first)
      split_inside<S, 3>(mesh, rows, {S(d - x - y) / S(d), S(x) / S(d), S(y) / S(d)}, first, (d - 1) * (d - 2) / 2, fine);
  }
}

int inner_points(const Mesh& mesh, Split split) {
  const int d = split.sections;
  if (split.triangles) return (d - 1) * (d - 2) / 2 * mesh.faces();
  return d == 2 ? mesh.faces() : (d - 1) * (d - 1) * mesh.faces();
}

}  // namespace

template <class S>
Points<S> split_points(const Mesh& mesh, const Points<S>& rows, Split split) {
  const int d = split.sections, first = mesh.vertices() + (d - 1) * mesh.edges();
  Points<S> fine = fresh_rows<S>(first + inner_points(mesh, split), rows.cols());
  std::copy(rows.data(), rows.data() + rows.size(), fine.data());
  split_edges(mesh, rows, d, fine);
  if (split.triangles) {
    split_triangles(mesh, rows, d, first, fine);
  } else if (d == 2) {
    split_polygons(mesh, rows, first, fine);
  } else {
    split_quads(mesh, rows, d, first, fine);
  }
  return fine;
}

template <class S>
Surface<S> up(const Surface<S>& shape, Split split) {
  Surface<S> fine;
  fine.mesh = std::make_shared<const Mesh>(split_mesh(*shape.mesh, split));
  fine.points = split_points(*shape.mesh, shape.points, split);
  fine.tags = split_tags(*shape.mesh, shape.tags, *fine.mesh, split);
  for (const auto& [name, column] : shape.attributes)
    fine.attributes[name] = as_column(split_points(*shape.mesh, as_rows(column), split));
  return fine;
}

template <class S>
Points<S> to_dual(const Surface<S>& shape, const KernelWeights<S>* weights) {
  Points<S> dual = fresh_rows<S>(dual_rows(*shape.mesh, shape.tags), shape.points.cols());
  ToDual<S> down(shape, weights);
  for (int f = 0; f < shape.mesh->faces(); ++f) down.face(f, dual, f);
  const int row = walk_boundary_edges(*shape.mesh, [&](int h, int r) { down.boundary_edge(h, dual, r); });
  walk_corners(*shape.mesh, shape.tags, row, [&](int v, int r) { down.corner(v, dual, r); });
  return dual;
}

template <class S>
Points<S> to_primal(const Surface<S>& shape, const Points<S>& dual) {
  ToPrimal<S> up(shape, dual.cols());
  for (int f = 0; f < shape.mesh->faces(); ++f) up.face(f, dual, f);
  const int row = walk_boundary_edges(*shape.mesh, [&](int h, int r) { up.boundary_edge(h, dual, r); });
  walk_corners(*shape.mesh, shape.tags, row, [&](int v, int r) { up.corner(v, dual, r); });
  return up.points();
}

template <class S>
Points<S> convolve(const Surface<S>& shape, const KernelWeights<S>* weights) {
  ToDual<S> down(shape, weights);
  ToPrimal<S> up(shape, shape.points.cols());
  Points<S> row(1, shape.points.cols());
  for (int f = 0; f < shape.mesh->faces(); ++f) {
    down.face(f, row, 0);
    up.face(f, row, 0);
  }
  walk_boundary_edges(*shape.mesh, [&](int h, int) {
    down.boundary_edge(h, row, 0);
    up.boundary_edge(h, row, 0);
  });
  walk_corners(*shape.mesh, shape.tags, 0, [&](int v, int) { up.corner(v, shape.points, v); });
  return up.points();
}

template <class S>
Surface<S> realise_dual(const Surface<S>& shape, const Points<S>& dual) {
  DualMesh connectivity = dual_mesh(*shape.mesh, shape.tags);
  Surface<S> result{std::make_shared<const Mesh>(std::move(connectivity.mesh)), dual, std::move(connectivity.tags), {}};
  for (const auto& [name, column] : shape.attributes) {
    const Surface<S> carrier{shape.mesh, as_rows(column), shape.tags, {}};
    result.attributes[name] = as_column(to_dual<S>(carrier, nullptr));
  }
  return result;
}

template <class S>
Points<S> convolve_classic(const Surface<S>& shape, const KernelWeights<S>& weights, const Mesh& before) {
  Points<S> points = convolve(shape, &weights);
  if (before.all_faces_have(4)) return points;
  const int first_face_point = before.vertices() + before.edges();
  for (int e = 0; e < before.edges(); ++e) {
    const int h = before.edge_half[at(e)], twin = before.twin[at(h)], i = before.vertices() + e;
    if (twin < 0) continue;
    const int left = before.face[at(h)], right = before.face[at(twin)];
    if (before.size(left) == 4 && before.size(right) == 4) continue;
    const EdgeTag across = opposite(shape.tags.of_edge(shape.mesh->edge[at(4 * h)]));
    const S& f = weights.f.at(across)[i];
    const S sum = S(2) + S(2) * f;
    if (!is_nonzero(sum)) no_average("edge " + std::to_string(e), sum);
    points.row(i).setZero();
    add_row(points, i, S(S(1) / sum), shape.points, first_face_point + left);
    add_row(points, i, S(S(1) / sum), shape.points, first_face_point + right);
    add_row(points, i, S(S(2) * f / sum), shape.points, i);
  }
  return points;
}

template <class S>
Points<S> push_back(Points<S> current, const Surface<S>& before, Split split, const PushBack<S>& parameters) {
  const Mesh& mesh = *before.mesh;
  const bool spreads = !parameters.spreads_nothing();
  // Delta at the old vertices: delta (old - new), 0 at corners.
  Points<S> difference = zero_rows<S>(spreads ? mesh.vertices() : 1, current.cols());
  for (int v = 0; v < mesh.vertices(); ++v) {
    if (before.tags.is_corner(v)) continue;
    const S& delta = parameters.delta[v];
    const int row = spreads ? v : 0;
    if (!spreads) difference.setZero();
    add_row(difference, row, delta, before.points, v);
    add_row(difference, row, S(-delta), current, v);
    add_row(current, v, S(1), difference, row);
  }
  if (!spreads) return current;
  const Points<S> spread = split_points(mesh, difference, split);
  const int edge_points = split.sections - 1;
  int i = mesh.vertices();
  for (int e = 0; e < mesh.edges(); ++e) {
    const Parameter<S>& along = parameters.omega.at(before.tags.of_edge(e));
    for (int s = 0; s < edge_points; ++s, ++i) add_row(current, i, along[i], spread, i);
  }
  const Directional<Parameter<S>>& omega = parameters.omega;
  const int inside = mesh.faces() == 0 ? 0 : inner_points(mesh, split) / mesh.faces();
  for (int f = 0; f < mesh.faces(); ++f) {
    const bool alternate = is_alternately_tagged(mesh, before.tags, f);
    const Parameter<S>&a = alternate ? omega.latitude : omega.plain, &b = alternate ? omega.longitude : omega.plain;
    for (int s = 0; s < inside; ++s, ++i)
      add_row(current, i, parameters.has_omega_face ? parameters.omega_face[i] : S(a[i] * b[i]), spread, i);
  }
  return current;
}

#define UDCP_INSTANTIATE(S)                                                                     \
  template Points<S> split_points(const Mesh&, const Points<S>&, Split);                        \
  template Surface<S> up(const Surface<S>&, Split);                                             \
  template Points<S> to_dual(const Surface<S>&, const KernelWeights<S>*);                       \
  template Points<S> to_primal(const Surface<S>&, const Points<S>&);                            \
  template Points<S> convolve(const Surface<S>&, const KernelWeights<S>*);                      \
  template Surface<S> realise_dual(const Surface<S>&, const Points<S>&);                        \
  template Points<S> convolve_classic(const Surface<S>&, const KernelWeights<S>&, const Mesh&); \
  template Points<S> push_back(Points<S>, const Surface<S>&, Split, const PushBack<S>&);
UDCP_FOR_EACH_NUMBER(UDCP_INSTANTIATE)
#undef UDCP_INSTANTIATE

}  // namespace udcp
