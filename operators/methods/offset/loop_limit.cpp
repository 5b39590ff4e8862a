// Weights per valence from the word on a fan, and their sums over one-rings.
#include "operators/methods/offset/loop_limit.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "operators/run.h"
#include "operators/schemes.h"

namespace udcp {
namespace {

std::size_t at(int k) { return static_cast<std::size_t>(k); }

std::string text(int k) { return std::to_string(k); }

/// Rows of one round on a fan around vertex 0: what vertex 0 and the points on its edges take from vertex 0 and from vertex 1.
template <class S>
struct FanRows {
  S centre_from_centre, centre_from_first;           // the new vertex 0
  std::vector<S> edge_from_centre, edge_from_first;  // the point on the edge to vertex 1 + k
};

template <class S>
FanRows<S> fan_rows(int neighbours, bool closed) {
  std::vector<int> begin{0}, corners;
  for (int k = 0; k < (closed ? neighbours : neighbours - 1); ++k) {
    corners.insert(corners.end(), {0, 1 + k, 1 + (k + 1) % neighbours});
    begin.push_back(static_cast<int>(corners.size()));
  }
  Surface<S> fan;
  fan.mesh = std::make_shared<const Mesh>(make_mesh(neighbours + 1, std::move(begin), std::move(corners)));
  fan.points = Points<S>::Zero(neighbours + 1, 2);
  fan.points(0, 0) = S(1);
  fan.points(1, 1) = S(1);
  const std::shared_ptr<const Mesh> mesh = fan.mesh;
  const Points<S> fine = run(schemes::loop(), std::move(fan), 1).points;
  FanRows<S> rows{fine(0, 0), fine(0, 1), std::vector<S>(at(neighbours)), std::vector<S>(at(neighbours))};
  for (int h = 0; h < mesh->half_edges(); ++h) {
    const int a = mesh->vertex[at(h)], b = mesh->tip(h);
    if (a != 0 && b != 0) continue;
    const Eigen::Index row = neighbours + 1 + mesh->edge[at(h)];
    rows.edge_from_centre[at(std::max(a, b) - 1)] = fine(row, 0);
    rows.edge_from_first[at(std::max(a, b) - 1)] = fine(row, 1);
  }
  return rows;
}

template <class S>
S interior_weight(int valence) {
  const FanRows<S> rows = fan_rows<S>(valence, true);
  return rows.edge_from_centre[0] / rows.centre_from_first;
}

template <class S>
BoundaryWeights<S> boundary_weights() {
  const FanRows<S> rows = fan_rows<S>(3, false);
  // x_p (1 - e(p)) = x_v v'(p) and x_v + 2 x_p = 1.
  const S ratio = rows.centre_from_first / (S(1) - rows.edge_from_first[0]);
  const S centre = S(1) / (S(1) + S(2) * ratio);
  return {centre, ratio * centre};
}

template <class S>
std::vector<S> boundary_tangent(int neighbours) {
  const FanRows<S> rows = fan_rows<S>(neighbours, false);
  if (neighbours == 2) {  // no inner neighbour: the eigenvalue that the boundary curve leaves, its trace less 1
    const S lambda = rows.centre_from_centre + rows.edge_from_first[0] - S(1);
    return {(lambda - rows.edge_from_first[0]) / rows.centre_from_first, S(1), S(1)};
  }
  const Rational theta = Rational(1) / Rational(neighbours - 1);
  const S lambda = S(3) / S(8) + cosine<S>(theta) / S(4);
  std::vector<S> left(at(neighbours + 1), S(0));
  S sum(0);  // over inner neighbours, of what their edge points take from vertex 0
  for (int i = 2; i < neighbours; ++i) {
    left[at(i)] = cosine<S>(Rational(1) / Rational(2) - Rational(i - 1) * theta);  // sin((i-1) theta)
    sum += left[at(i)] * rows.edge_from_centre[at(i - 1)];
  }
  // Columns of vertex 0 and of p_1, with l(p_1) = l(p_K):
  //   (lambda - v'(v)) l_v - 2 e_1(v) l_1 = sum,   -v'(p_1) l_v + (lambda - e_1(p_1)) l_1 = l(p_2) e_2(p_1)
  const S a = lambda - rows.centre_from_centre, b = -(S(2) * rows.edge_from_centre[0]);
  const S c = -rows.centre_from_first, d = lambda - rows.edge_from_first[0];
  const S second = left[2] * rows.edge_from_first[1];
  const S determinant = a * d - b * c;
  left[0] = (sum * d - b * second) / determinant;
  left[1] = (a * second - c * sum) / determinant;
  left[at(neighbours)] = left[1];
  return left;
}

/// Doubles are made from enclosures and so rounded once, whatever the valence.
template <class S>
struct Weights {
  static S interior(int valence) { return interior_weight<S>(valence); }
  static BoundaryWeights<S> boundary() { return boundary_weights<S>(); }
  static std::vector<S> tangent(int neighbours) { return boundary_tangent<S>(neighbours); }
};
template <>
struct Weights<double> {
  static double interior(int valence) { return interior_weight<Interval>(valence).midpoint(); }
  static BoundaryWeights<double> boundary() {
    const BoundaryWeights<Interval> weights = boundary_weights<Interval>();
    return {weights.centre.midpoint(), weights.end.midpoint()};
  }
  static std::vector<double> tangent(int neighbours) {
    std::vector<double> result;
    for (const Interval& weight : boundary_tangent<Interval>(neighbours)) result.push_back(weight.midpoint());
    return result;
  }
};

template <class S>
void add_three(Points<S>& to, int i, int column, const S& w, const Points<S>& from, int j) {
  for (int c = 0; c < 3; ++c) to(i, column + c) += w * from(j, c);
}

}  // namespace

std::vector<int> vertex_ring(const Mesh& mesh, int v) {
  std::vector<int> ring;
  const int first = mesh.outgoing[at(v)];
  if (mesh.on_boundary(v)) ring.push_back(mesh.tip(first));
  for (int h = first; h >= 0;) {
    ring.push_back(mesh.on_boundary(v) ? mesh.vertex[at(mesh.prev(h))] : mesh.tip(h));
    h = mesh.around(h);
    if (h == first) break;
  }
  return ring;
}

VertexRings::VertexRings(const Mesh& mesh) {
  begin_.reserve(at(mesh.vertices()) + 1);
  neighbour_.reserve(at(mesh.half_edges()));
  begin_.push_back(0);
  for (int v = 0; v < mesh.vertices(); ++v) {
    const bool boundary = mesh.on_boundary(v);
    const int first = mesh.outgoing[at(v)];
    if (boundary) neighbour_.push_back(mesh.tip(first));
    for (int h = first; h >= 0;) {
      neighbour_.push_back(boundary ? mesh.vertex[at(mesh.prev(h))] : mesh.tip(h));
      h = mesh.around(h);
      if (h == first) break;
    }
    begin_.push_back(static_cast<int>(neighbour_.size()));
  }
}

void validate_loop_mesh(const Mesh& mesh, const Tags& tags) {
  for (int f = 0; f < mesh.faces(); ++f) {
    if (mesh.size(f) == 3) continue;
    throw Error(ErrorKind::input, "E_NOT_TRIANGLES",
                "face " + text(f) + " has " + text(mesh.size(f)) + " corners; Loop surfaces need a mesh of triangles",
                "triangulate(mesh) cuts the faces");
  }
  for (int v = 0; v < mesh.vertices(); ++v) {
    if (mesh.on_boundary(v) || mesh.valence(v) >= 3) continue;
    throw Error(ErrorKind::input, "E_VALENCE2",
                "vertex " + text(v) + " lies inside and has valence " + text(mesh.valence(v)) + "; Loop surfaces need 3 or more",
                "remove the vertex, or split the faces around it");
  }
  for (int v = 0; v < mesh.vertices(); ++v) {
    if (!tags.is_corner(v) || mesh.on_boundary(v)) continue;
    throw Error(ErrorKind::input, "E_CORNER_INSIDE",
                "vertex " + text(v) + " is tagged as a corner but lies inside; only boundary vertices can be interpolated",
                "untag it");
  }
}

void validate_control_mesh(const Surface<double>& surface) {
  if (!surface.mesh || surface.mesh->faces() == 0)
    throw Error(ErrorKind::input, "E_NO_FACES", "the mesh has no face", "a mesh needs at least one face of three corners");
  validate(surface);
  if (surface.points.cols() != 3)
    throw Error(ErrorKind::input, "E_DIMENSION",
                "the points have " + text(static_cast<int>(surface.points.cols())) + " coordinates; surfaces here have three",
                "");
  for (Eigen::Index v = 0; v < surface.points.rows(); ++v) {
    if (surface.points.row(v).allFinite()) continue;
    throw Error(ErrorKind::input, "E_NOT_FINITE", "a coordinate of vertex " + std::to_string(v) + " is not finite", "");
  }
  validate_loop_mesh(*surface.mesh, surface.tags);
}

void validate_boundary_normals(const Mesh& mesh, const Tags& tags) {
  for (int v = 0; v < mesh.vertices(); ++v) {
    if (!mesh.on_boundary(v)) continue;
    const int most = tags.is_corner(v) ? 4 : 7;
    if (mesh.valence(v) <= most) continue;
    throw Error(ErrorKind::input, "E_BOUNDARY_VALENCE",
                (tags.is_corner(v) ? "corner " : "boundary vertex ") + text(v) + " has " + text(mesh.valence(v)) +
                    " neighbours; Loop surfaces have a normal there for up to " + text(most),
                "split faces so that fewer edges meet there");
  }
}

template <class S>
S loop_weight(int valence) {
  if (valence < 3)
    throw Error(ErrorKind::input, "E_VALENCE2", "interior vertices of Loop surfaces have valence 3 or more, not " + text(valence),
                "");
  return Weights<S>::interior(valence);
}

template <class S>
BoundaryWeights<S> loop_boundary_weights() {
  return Weights<S>::boundary();
}

template <class S>
std::vector<S> loop_boundary_tangent(int neighbours) {
  if (neighbours < 2)
    throw Error(ErrorKind::input, "E_BOUNDARY_VALENCE", "a boundary vertex has two or more neighbours, not " + text(neighbours),
                "");
  return Weights<S>::tangent(neighbours);
}

template <class S>
LoopLimit<S>::LoopLimit(std::shared_ptr<const Mesh> mesh, Tags tags)
    : mesh_(std::move(mesh)), tags_(std::move(tags)), rings_(*mesh_), boundary_(Weights<S>::boundary()) {
  validate_loop_mesh(*mesh_, tags_);
  for (int v = 0; v < mesh_->vertices(); ++v)
    if (is_interior(v) && !weights_.contains(mesh_->valence(v)))
      weights_.emplace(mesh_->valence(v), loop_weight<S>(mesh_->valence(v)));
}

template <class S>
Points<S> LoopLimit<S>::points(const Points<S>& field) const {
  Points<S> result = Points<S>::Zero(field.rows(), field.cols());
  for (int v = 0; v < mesh_->vertices(); ++v) {
    const std::span<const int> ring = rings_.of(v);
    if (is_interior(v)) {
      const S& w = weight(v);
      const S neighbour = S(1) / (w + S(static_cast<int>(ring.size())));
      add(result, v, S(w * neighbour), field, v);
      for (const int u : ring) add(result, v, neighbour, field, u);
    } else if (tags_.is_corner(v)) {
      add(result, v, S(1), field, v);
    } else {
      add(result, v, boundary_.centre, field, v);
      add(result, v, boundary_.end, field, ring.front());
      add(result, v, boundary_.end, field, ring.back());
    }
  }
  return result;
}

template <class S>
Points<S> LoopLimit<S>::tangents(const Points<S>& field) const {
  std::map<int, std::vector<S>> cosines, across;
  Points<S> result = Points<S>::Zero(field.rows(), 6);
  for (int v = 0; v < mesh_->vertices(); ++v) {
    const std::span<const int> ring = rings_.of(v);
    const int n = static_cast<int>(ring.size());
    if (is_interior(v)) {
      std::vector<S>& waves = cosines[n];
      for (int j = static_cast<int>(waves.size()) / 2; j < n; ++j) {
        waves.push_back(cosine<S>(Rational(2 * j) / Rational(n)));
        waves.push_back(cosine<S>(Rational(1) / Rational(2) - Rational(2 * j) / Rational(n)));
      }
      for (int j = 0; j < n; ++j) {
        add_three(result, v, 0, waves[at(2 * j)], field, ring[at(j)]);
        add_three(result, v, 3, waves[at(2 * j + 1)], field, ring[at(j)]);
      }
      continue;
    }
    add_three(result, v, 0, S(1), field, ring.front());
    add_three(result, v, 0, S(-1), field, tags_.is_corner(v) ? v : ring.back());
    if (tags_.is_corner(v)) {
      add_three(result, v, 3, S(1), field, ring.back());
      add_three(result, v, 3, S(-1), field, v);
      continue;
    }
    std::vector<S>& weights = across[n];
    if (weights.empty()) weights = loop_boundary_tangent<S>(n);
    add_three(result, v, 3, weights[0], field, v);
    for (int j = 0; j < n; ++j) add_three(result, v, 3, weights[at(j + 1)], field, ring[at(j)]);
  }
  return result;
}

template <class S>
Points<S> limit_matrix(const LoopLimit<S>& limit) {
  const Eigen::Index n = limit.mesh().vertices();
  if (n > 2000)
    throw Error(ErrorKind::limit, "E_TOO_LARGE", "the matrix would have " + std::to_string(n) + " rows; the limit is 2000", "");
  return limit.points(Points<S>::Identity(n, n));
}

template <class S>
Points<S> normals_of(const Points<S>& tangents) {
  using std::sqrt;
  const S tiny = number<S>(Rational(1) / pow(Rational(10), 26));
  Points<S> result(tangents.rows(), 3);
  for (Eigen::Index v = 0; v < tangents.rows(); ++v) {
    const auto t = tangents.row(v);
    S square(0), first(0), second(0);
    for (Eigen::Index c = 0; c < 3; ++c) {
      const Eigen::Index d = (c + 1) % 3, e = (c + 2) % 3;
      result(v, c) = t[d] * t[3 + e] - t[e] * t[3 + d];
      square += result(v, c) * result(v, c);
      first += t[c] * t[c];
      second += t[3 + c] * t[3 + c];
    }
    if (!(square > tiny * first * second))
      throw Error(ErrorKind::input, "E_ZERO_NORMAL", "the surface has no normal at vertex " + std::to_string(v),
                  "its tangents there are parallel or vanish: move the vertices around it");
    const S length = sqrt(square);
    for (Eigen::Index c = 0; c < 3; ++c) result(v, c) /= length;
  }
  return result;
}

template <class S>
Points<S> limit_normals(const LoopLimit<S>& limit, const Points<S>& points) {
  validate_boundary_normals(limit.mesh(), limit.tags());
  return normals_of(limit.tangents(points));
}

#define UDCP_INSTANTIATE(S)                               \
  template S loop_weight(int);                            \
  template BoundaryWeights<S> loop_boundary_weights<S>(); \
  template std::vector<S> loop_boundary_tangent(int);     \
  template class LoopLimit<S>;                            \
  template Points<S> limit_matrix(const LoopLimit<S>&);
UDCP_FOR_EACH_COORDINATE(UDCP_INSTANTIATE)
#undef UDCP_INSTANTIATE
#define UDCP_INSTANTIATE(S)                        \
  template Points<S> normals_of(const Points<S>&); \
  template Points<S> limit_normals(const LoopLimit<S>&, const Points<S>&);
UDCP_INSTANTIATE(double)
UDCP_INSTANTIATE(Interval)
#undef UDCP_INSTANTIATE

}  // namespace udcp
