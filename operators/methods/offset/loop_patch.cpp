// Patches on patch meshes: a fan around c, completed around r_0 and r_1, goes through the word on unit vectors.
#include "operators/methods/offset/loop_patch.h"

#include <algorithm>
#include <map>
#include <string>

#include "operators/methods/offset/dense_solve.h"
#include "operators/methods/offset/loop_limit.h"
#include "operators/run.h"
#include "operators/schemes.h"

namespace udcp {
namespace {

std::size_t at(int k) { return static_cast<std::size_t>(k); }

bool is_regular(const Mesh& mesh, const Tags& tags, int v) {
  return mesh.on_boundary(v) ? !tags.is_corner(v) && mesh.valence(v) == 4 : mesh.valence(v) == 6;
}

/// The ring of the vertex that `start` leaves, from the tip of `start`; with two points beyond the boundary for K = 4.
std::vector<PatchPoint> ring_from(const Mesh& mesh, int start) {
  const int v = mesh.vertex[at(start)];
  std::vector<PatchPoint> ring;
  for (const int u : vertex_ring(mesh, v)) ring.push_back({u, -1, -1});
  if (mesh.on_boundary(v)) {
    const int first = ring[0].a, second = ring[1].a, third = ring[2].a, last = ring[3].a;
    ring.push_back({v, last, third});
    ring.push_back({v, first, second});
  }
  const int wanted = mesh.tip(start);
  const auto found = std::find_if(ring.begin(), ring.end(), [&](const PatchPoint& p) { return p.b < 0 && p.a == wanted; });
  std::rotate(ring.begin(), found, ring.end());
  return ring;
}

std::vector<PatchPoint> points_from(const Mesh& mesh, int half_edge) {
  const int to_second = mesh.next(half_edge), to_centre = mesh.prev(half_edge);
  std::vector<PatchPoint> points{{mesh.vertex[at(half_edge)], -1, -1}};
  const std::vector<PatchPoint> ring = ring_from(mesh, half_edge);
  points.insert(points.end(), ring.begin(), ring.end());
  const std::vector<PatchPoint> first = ring_from(mesh, to_second);   // r_1, c, r_{N-1}, a_0, a_1, a_2
  const std::vector<PatchPoint> second = ring_from(mesh, to_centre);  // c, r_0, a_2, a_3, a_4, r_2
  points.insert(points.end(), first.begin() + 3, first.end());
  points.insert(points.end(), second.begin() + 3, second.begin() + 5);
  return points;
}

/// The mesh of a patch: vertices in the order of its control points, face 0 the patch.
Mesh patch_mesh(int n) {
  const auto ring = [n](int j) { return 1 + j % n; };
  const auto outer = [n](int j) { return 1 + n + j; };
  std::vector<std::vector<int>> faces;
  for (int j = 0; j < n; ++j) faces.push_back({0, ring(j), ring(j + 1)});
  faces.push_back({ring(0), ring(n - 1), outer(0)});
  for (int j = 0; j < 2; ++j) faces.push_back({ring(0), outer(j), outer(j + 1)});
  faces.push_back({ring(0), outer(2), ring(1)});
  for (int j = 2; j < 4; ++j) faces.push_back({ring(1), outer(j), outer(j + 1)});
  faces.push_back({ring(1), outer(4), ring(2)});
  return make_mesh(n + 6, faces);
}

template <class S>
Points<S> rows_of(const Points<S>& all, const std::vector<PatchPoint>& points) {
  Points<S> rows(static_cast<Eigen::Index>(points.size()), all.cols());
  for (std::size_t k = 0; k < points.size(); ++k) rows.row(static_cast<Eigen::Index>(k)) = all.row(points[k].a);
  return rows;
}

/// Barycentric places, times 4, of the vertices of face 0 after two steps: vertex by place.
using Place = std::array<int, 3>;  // weights of c, r_0, r_1
void collect_places(const Mesh& mesh, int face, int levels, const std::array<Place, 3>& corners, std::map<Place, int>& places) {
  if (levels == 0) {
    for (int j = 0; j < 3; ++j) places[corners[at(j)]] = mesh.corners(face)[at(j)];
    return;
  }
  const auto middle = [](const Place& a, const Place& b) {
    return Place{(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2};
  };
  const auto& [a, b, c] = corners;
  const Place ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
  const std::array<std::array<Place, 3>, 4> children{{{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}}};
  for (int k = 0; k < 4; ++k) collect_places(mesh, 4 * face + k, levels - 1, children[at(k)], places);
}

Rational power(const Rational& x, int n) { return pow(x, n); }

/// b_ijk interpolate the limit points at the 15 places (i, j, k)/4, which the word gives after two rounds.
Points<Rational> make_box_spline_bezier() {
  Surface<Rational> patch{std::make_shared<const Mesh>(patch_mesh(6)), Points<Rational>::Identity(12, 12), {}, {}};
  const Surface<Rational> fine = run(schemes::loop(), std::move(patch), 2);
  std::map<Place, int> places;
  collect_places(*fine.mesh, 0, 2, {{{4, 0, 0}, {0, 4, 0}, {0, 0, 4}}}, places);
  const Rational w = loop_weight<Rational>(6), quarter = Rational(1) / Rational(4);
  Points<Rational> basis(15, 15), limits(15, 12);
  for (const auto& [place, v] : places) {
    const int row = bernstein_index(4, place[1], place[2]);
    limits.row(row) = w * fine.points.row(v);
    for (const int u : vertex_ring(*fine.mesh, v)) limits.row(row) += fine.points.row(u);
    limits.row(row) /= w + Rational(6);
    for (int i = 0; i <= 4; ++i) {
      for (int j = 0; i + j <= 4; ++j) {
        static constexpr std::array factorial{1, 1, 2, 6, 24};
        const int k = 4 - i - j;
        basis(row, bernstein_index(4, i, j)) = Rational(24 / (factorial[at(i)] * factorial[at(j)] * factorial[at(k)])) *
                                               power(Rational(place[1]) * quarter, i) * power(Rational(place[2]) * quarter, j) *
                                               power(Rational(place[0]) * quarter, k);
      }
    }
  }
  return dense_solve(basis, limits);
}

template <class S>
const Points<S>& bezier_matrix() {
  static const Points<S> matrix = [] {
    const Points<Rational>& exact = box_spline_bezier();
    Points<S> result(exact.rows(), exact.cols());
    for (Eigen::Index k = 0; k < exact.size(); ++k) result.data()[k] = number<S>(exact.data()[k]);
    return result;
  }();
  return matrix;
}

/// de Casteljau: from degree n to n - 1.
template <class S>
Points<S> lower(const Points<S>& b, int n, const S& u, const S& v, const S& w) {
  Points<S> result(bernstein_size(n - 1), b.cols());
  for (int i = 0; i < n; ++i)
    for (int j = 0; i + j < n; ++j)
      result.row(bernstein_index(n - 1, i, j)) =
          v * b.row(bernstein_index(n, i + 1, j)) + w * b.row(bernstein_index(n, i, j + 1)) + u * b.row(bernstein_index(n, i, j));
  return result;
}

/// Position only, by the limit mask of c.
template <class S>
Points<S> limit_of_centre(const Points<S>& net) {
  const int n = static_cast<int>(net.rows()) - 6;
  const S w = loop_weight<S>(n);
  Points<S> result = w * net.row(0);
  for (int j = 1; j <= n; ++j) result += net.row(j);
  result /= w + S(n);
  return result;
}

}  // namespace

int bernstein_size(int degree) { return (degree + 1) * (degree + 2) / 2; }
int bernstein_index(int degree, int i, int j) { return i * (degree + 1) - i * (i - 1) / 2 + j; }

std::optional<LoopPatch> loop_patch(const Mesh& mesh, const Tags& tags, int face) {
  const int first = mesh.face_begin[at(face)];
  int centre = first, irregular = 0;
  for (int h = first; h < first + 3; ++h) {
    if (is_regular(mesh, tags, mesh.vertex[at(h)])) continue;
    centre = h;
    ++irregular;
  }
  const int c = mesh.vertex[at(centre)];
  if (irregular > 1 || (irregular == 1 && mesh.on_boundary(c))) return std::nullopt;
  return LoopPatch{irregular == 0 ? 6 : mesh.valence(c), centre, points_from(mesh, centre)};
}

template <class S>
Points<S> patch_net(const LoopPatch& patch, const Points<S>& field) {
  Points<S> net = rows_of(field, patch.points);
  for (std::size_t k = 0; k < patch.points.size(); ++k) {
    const PatchPoint& p = patch.points[k];
    if (p.b < 0) continue;
    const auto row = static_cast<Eigen::Index>(k);
    net.row(row) += field.row(p.b);
    net.row(row) -= field.row(p.minus);
  }
  return net;
}

const Points<Rational>& box_spline_bezier() {
  static const Points<Rational> matrix = make_box_spline_bezier();
  return matrix;
}

template <class S>
Points<S> bezier_points(const Points<S>& net) {
  const Points<S>& matrix = bezier_matrix<S>();
  Points<S> result = Points<S>::Zero(15, net.cols());
  for (int i = 0; i < 15; ++i)
    for (int j = 0; j < 12; ++j)
      if (!is_zero(matrix(i, j))) add(result, i, matrix(i, j), net, j);
  return result;
}

template <class S>
PatchStep<S> patch_step(int valence) {
  if (valence < 3 || valence > largest_patch_valence)
    throw Error(ErrorKind::limit, "E_TOO_LARGE",
                "matrices of patches are made for valences from 3 to " + std::to_string(largest_patch_valence) + ", not " +
                    std::to_string(valence),
                "");
  const int size = valence + 6;
  Surface<S> patch{std::make_shared<const Mesh>(patch_mesh(valence)), Points<S>::Identity(size, size), {}, {}};
  const Surface<S> fine = run(schemes::loop(), std::move(patch), 1);
  // Face 0 = (c, r_0, r_1) became (c, e_0, e_1), (r_0, e_01, e_0), (r_1, e_1, e_01), (e_0, e_01, e_1).
  const auto rows = [&](int half_edge) { return rows_of(fine.points, points_from(*fine.mesh, half_edge)); };
  return {rows(0), {rows(3 + 2), rows(6 + 1), rows(9 + 1)}};
}

template <class S>
Points<S> evaluate_regular(const Points<S>& net, const std::type_identity_t<S>& v, const std::type_identity_t<S>& w) {
  const S u = S(1) - v - w;
  Points<S> b = bezier_points(net);
  b = lower(b, 4, u, v, w);
  b = lower(b, 3, u, v, w);
  Points<S> result(6, net.cols());
  const auto row = [&](int n, int i, int j) { return b.row(bernstein_index(n, i, j)); };
  result.row(3) = S(12) * (row(2, 2, 0) - S(2) * row(2, 1, 0) + row(2, 0, 0));
  result.row(4) = S(12) * (row(2, 1, 1) - row(2, 1, 0) - row(2, 0, 1) + row(2, 0, 0));
  result.row(5) = S(12) * (row(2, 0, 2) - S(2) * row(2, 0, 1) + row(2, 0, 0));
  b = lower(b, 2, u, v, w);
  result.row(1) = S(4) * (row(1, 1, 0) - row(1, 0, 0));
  result.row(2) = S(4) * (row(1, 0, 1) - row(1, 0, 0));
  b = lower(b, 1, u, v, w);
  result.row(0) = b.row(0);
  return result;
}

template <class S>
void change_parameters(Points<S>& values, const std::array<std::array<std::type_identity_t<S>, 2>, 2>& jacobian) {
  const auto& [first, second] = jacobian;
  const S a = first[0], b = first[1], c = second[0], d = second[1];
  const Points<S> old = values;
  values.row(1) = a * old.row(1) + c * old.row(2);
  values.row(2) = b * old.row(1) + d * old.row(2);
  values.row(3) = a * a * old.row(3) + S(2) * a * c * old.row(4) + c * c * old.row(5);
  values.row(4) = a * b * old.row(3) + (a * d + b * c) * old.row(4) + c * d * old.row(5);
  values.row(5) = b * b * old.row(3) + S(2) * b * d * old.row(4) + d * d * old.row(5);
}

template <class S>
Points<S> evaluate_patch(const Points<S>& net, const PatchStep<S>& step, std::type_identity_t<S> v, std::type_identity_t<S> w) {
  constexpr int deepest = 60;
  if (net.rows() == 12) return evaluate_regular(net, v, w);
  Points<S> current = net;
  S factor(1);
  const auto product = [&](const Points<S>& rows) {
    Points<S> result = Points<S>::Zero(rows.rows(), current.cols());
    for (int i = 0; i < rows.rows(); ++i)
      for (int j = 0; j < rows.cols(); ++j)
        if (!is_zero(rows(i, j))) add(result, i, rows(i, j), current, j);
    return result;
  };
  for (int depth = 0; depth < deepest && !(is_zero(v) && is_zero(w)); ++depth) {
    v += v;
    w += w;
    factor += factor;
    if (v + w <= S(1)) {
      current = product(step.inner);
      continue;
    }
    const int child = v >= S(1) ? 0 : w >= S(1) ? 1 : 2;
    if (child == 2) factor = -factor;
    const S from_v = child == 0 ? S(v - S(1)) : child == 2 ? S(S(1) - v) : v;
    const S from_w = child == 1 ? S(w - S(1)) : child == 2 ? S(S(1) - w) : w;
    Points<S> values = evaluate_regular(product(step.regular[at(child)]), from_v, from_w);
    change_parameters(values, {{{factor, S(0)}, {S(0), factor}}});
    return values;
  }
  return limit_of_centre(current);
}

#define UDCP_INSTANTIATE(S)                                                       \
  template Points<S> patch_net(const LoopPatch&, const Points<S>&);               \
  template Points<S> bezier_points(const Points<S>&);                             \
  template PatchStep<S> patch_step(int);                                          \
  template Points<S> evaluate_regular(const Points<S>&, const S&, const S&);      \
  template Points<S> evaluate_patch(const Points<S>&, const PatchStep<S>&, S, S); \
  template void change_parameters(Points<S>&, const std::array<std::array<S, 2>, 2>&);
UDCP_INSTANTIATE(double)
UDCP_INSTANTIATE(Rational)
UDCP_INSTANTIATE(Interval)
#undef UDCP_INSTANTIATE

}  // namespace udcp
