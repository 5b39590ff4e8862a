// U, D, C[ngon = classic], P and the ring pass on polygon meshes; U and P also on triangles, where only the split differs.
// push-back, eqs. (4) to (9).
#include <array>
#include <string>

#include "operators/atoms.h"
#include "operators/columns.h"

namespace udcp {
namespace {

std::size_t at(int k) { return Mesh::i(k); }

// 1/n for the valences and face sizes that occur, computed once each: divisions are what exact numbers pay for.
template <class S>
class Reciprocals {
 public:
  const S& operator()(int n) {
    while (static_cast<int>(values_.size()) <= n) values_.push_back(S(1) / S(static_cast<int>(values_.size())));
    return values_[at(n)];
  }

 private:
  std::vector<S> values_{S(0)};
};

// Rows of the dual: faces, then boundary edges in edge order, then corners in vertex order.
template <class Edge>
int walk_boundary_edges(const Mesh& mesh, Edge edge) {
  int row = mesh.faces();
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

// Weight of the vertex that half-edge h leaves, in the mean over its face: f of both its edges for an old vertex, of the edge
// that is no child of an old edge for an E point, 1 for an F point.
template <class S>
S corner_weight(const Surface<S>& shape, const KernelWeights<S>& weights, int h) {
  const Mesh& mesh = *shape.mesh;
  const int v = mesh.vertex[at(h)], before = mesh.prev(h);
  if (weights.origin.is_in_face(v)) return S(1);
  const auto f = [&](int half) -> const S& { return weights.f.at(shape.tags.of_edge(mesh.edge[at(half)]))[v]; };
  if (weights.origin.is_old(v)) return f(before) * f(h);
  S weight(1);
  if (weights.origin.is_in_face(mesh.tip(h))) weight *= f(h);
  if (weights.origin.is_in_face(mesh.vertex[at(before)])) weight *= f(before);
  return weight;
}

template <class S>
void average_faces(const Surface<S>& shape, const KernelWeights<S>* weights, Points<S>& dual) {
  const Mesh& mesh = *shape.mesh;
  Reciprocals<S> reciprocal;
  std::vector<S> weight;
  for (int f = 0; f < mesh.faces(); ++f) {
    const int begin = mesh.face_begin[at(f)], n = mesh.size(f);
    if (weights == nullptr) {
      for (int k = 0; k < n; ++k) add(dual, f, reciprocal(n), shape.points, mesh.vertex[at(begin + k)]);
      continue;
    }
    weight.clear();
    S sum(0);
    for (int k = 0; k < n; ++k) sum += weight.emplace_back(corner_weight(shape, *weights, begin + k));
    if (!is_nonzero(sum)) no_average("face " + std::to_string(f), sum);
    const S scale = S(1) / sum;
    for (int k = 0; k < n; ++k) add(dual, f, S(weight[at(k)] * scale), shape.points, mesh.vertex[at(begin + k)]);
  }
}

// The curve rule on a boundary edge.
template <class S>
void average_boundary_edge(const Surface<S>& shape, const KernelWeights<S>* weights, int h, int row, Points<S>& dual) {
  const Mesh& mesh = *shape.mesh;
  const EdgeTag tag = shape.tags.of_edge(mesh.edge[at(h)]);
  const int a = mesh.vertex[at(h)], b = mesh.tip(h);
  const auto weight = [&](int v) { return weights != nullptr && weights->origin.is_old(v) ? weights->f.at(tag)[v] : S(1); };
  const S wa = weight(a), wb = weight(b), sum = wa + wb;
  if (!is_nonzero(sum)) no_average("the boundary edge " + std::to_string(a) + "-" + std::to_string(b), sum);
  add(dual, row, S(wa / sum), shape.points, a);
  add(dual, row, S(wb / sum), shape.points, b);
}

template <class S>
void split_edges(const Mesh& mesh, const Points<S>& rows, int d, Points<S>& fine) {
  for (int s = 1; s < d; ++s) {
    const S near = S(d - s) / S(d), far = S(s) / S(d);
    for (int e = 0; e < mesh.edges(); ++e) {
      const int h = mesh.edge_half[at(e)], i = mesh.vertices() + (d - 1) * e + s - 1;
      add(fine, i, near, rows, mesh.vertex[at(h)]);
      add(fine, i, far, rows, mesh.tip(h));
    }
  }
}

template <class S>
void split_polygons(const Mesh& mesh, const Points<S>& rows, int first, Points<S>& fine) {
  Reciprocals<S> reciprocal;
  for (int f = 0; f < mesh.faces(); ++f)
    for (const int v : mesh.corners(f)) add(fine, first + f, reciprocal(mesh.size(f)), rows, v);
}

template <class S>
void split_quads(const Mesh& mesh, const Points<S>& rows, int d, int first, Points<S>& fine) {
  for (int y = 1; y < d; ++y) {
    for (int x = 1; x < d; ++x, ++first) {
      const S u = S(x) / S(d), v = S(y) / S(d), u1 = S(1) - u, v1 = S(1) - v;
      const std::array<S, 4> weight{u1 * v1, u * v1, u * v, u1 * v};
      for (int f = 0; f < mesh.faces(); ++f)
        for (std::size_t k = 0; k < 4; ++k)
          add(fine, first + (d - 1) * (d - 1) * f, weight[k], rows, mesh.vertex[at(mesh.face_begin[at(f)]) + k]);
    }
  }
}

template <class S>
void split_triangles(const Mesh& mesh, const Points<S>& rows, int d, int first, Points<S>& fine) {
  for (int y = 1; y < d; ++y) {
    for (int x = 1; x + y < d; ++x, ++first) {
      const std::array<S, 3> weight{S(d - x - y) / S(d), S(x) / S(d), S(y) / S(d)};
      for (int f = 0; f < mesh.faces(); ++f)
        for (std::size_t k = 0; k < 3; ++k)
          add(fine, first + (d - 1) * (d - 2) / 2 * f, weight[k], rows, mesh.vertex[at(mesh.face_begin[at(f)]) + k]);
    }
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
  Points<S> fine = Points<S>::Zero(first + inner_points(mesh, split), rows.cols());
  fine.topRows(mesh.vertices()) = rows;
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
  if (weights != nullptr && weights->is_one()) weights = nullptr;
  Points<S> dual = Points<S>::Zero(dual_rows(*shape.mesh, shape.tags), shape.points.cols());
  average_faces(shape, weights, dual);
  const int row = walk_boundary_edges(*shape.mesh, [&](int h, int r) { average_boundary_edge(shape, weights, h, r, dual); });
  walk_corners(*shape.mesh, shape.tags, row, [&](int v, int r) { add(dual, r, S(1), shape.points, v); });
  return dual;
}

template <class S>
Points<S> to_primal(const Surface<S>& shape, const Points<S>& dual) {
  const Mesh& mesh = *shape.mesh;
  Points<S> points = Points<S>::Zero(mesh.vertices(), dual.cols());
  Reciprocals<S> reciprocal;
  for (int h = 0; h < mesh.half_edges(); ++h) {
    const int v = mesh.vertex[at(h)];
    if (!mesh.on_boundary(v) && !shape.tags.is_corner(v)) add(points, v, reciprocal(mesh.valence(v)), dual, mesh.face[at(h)]);
  }
  const int row = walk_boundary_edges(mesh, [&](int h, int r) {
    for (const int v : {mesh.vertex[at(h)], mesh.tip(h)})
      if (!shape.tags.is_corner(v)) add(points, v, reciprocal(2), dual, r);
  });
  walk_corners(mesh, shape.tags, row, [&](int v, int r) { add(points, v, S(1), dual, r); });
  return points;
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
  Points<S> points = to_primal(shape, to_dual(shape, &weights));
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
    add(points, i, S(S(1) / sum), shape.points, first_face_point + left);
    add(points, i, S(S(1) / sum), shape.points, first_face_point + right);
    add(points, i, S(S(2) * f / sum), shape.points, i);
  }
  return points;
}

namespace {

// Delta at the old vertices: delta (old - new), 0 at corners.
template <class S>
Points<S> push_back_differences(const Points<S>& current, const Surface<S>& before, const Parameter<S>& delta) {
  Points<S> difference = Points<S>::Zero(before.mesh->vertices(), current.cols());
  for (int v = 0; v < before.mesh->vertices(); ++v) {
    if (before.tags.is_corner(v)) continue;
    add(difference, v, delta[v], before.points, v);
    add(difference, v, S(-delta[v]), current, v);
  }
  return difference;
}

}  // namespace

template <class S>
Points<S> push_back(Points<S> current, const Surface<S>& before, Split split, const PushBack<S>& parameters) {
  const Mesh& mesh = *before.mesh;
  const Points<S> difference = push_back_differences(current, before, parameters.delta);
  for (int v = 0; v < mesh.vertices(); ++v) add(current, v, S(1), difference, v);
  if (parameters.spreads_nothing()) return current;
  const Points<S> spread = split_points(mesh, difference, split);
  const int points = static_cast<int>(current.rows()), d = split.sections;
  const int first_edge_point = mesh.vertices(), first_inner = first_edge_point + (d - 1) * mesh.edges();
  for (int i = first_edge_point; i < first_inner; ++i)
    add(current, i, parameters.omega.at(before.tags.of_edge((i - first_edge_point) / (d - 1)))[i], spread, i);
  const int per_face = mesh.faces() == 0 ? 0 : inner_points(mesh, split) / mesh.faces();
  for (int i = first_inner; i < points; ++i) {
    const bool alternate = is_alternately_tagged(mesh, before.tags, (i - first_inner) / per_face);
    const S weight = parameters.has_omega_face ? parameters.omega_face[i]
                     : alternate               ? S(parameters.omega.latitude[i] * parameters.omega.longitude[i])
                                               : S(parameters.omega.plain[i] * parameters.omega.plain[i]);
    add(current, i, weight, spread, i);
  }
  return current;
}

#define UDCP_INSTANTIATE(S)                                                                     \
  template Points<S> split_points(const Mesh&, const Points<S>&, Split);                        \
  template Surface<S> up(const Surface<S>&, Split);                                             \
  template Points<S> to_dual(const Surface<S>&, const KernelWeights<S>*);                       \
  template Points<S> to_primal(const Surface<S>&, const Points<S>&);                            \
  template Surface<S> realise_dual(const Surface<S>&, const Points<S>&);                        \
  template Points<S> convolve_classic(const Surface<S>&, const KernelWeights<S>&, const Mesh&); \
  template Points<S> push_back(Points<S>, const Surface<S>&, Split, const PushBack<S>&);
UDCP_FOR_EACH_NUMBER(UDCP_INSTANTIATE)
#undef UDCP_INSTANTIATE

}  // namespace udcp
