// Discs, boundary curves and separating planes.
#include "proofs/embedding_facts.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "operators/interrupt.h"
#include "operators/methods/offset/bernstein_triangle.h"
#include "operators/methods/offset/box_tree.h"
#include "operators/methods/offset/loop_limit.h"
#include "proofs/offset_statements.h"

namespace udcp {
namespace {

std::size_t at(int k) { return static_cast<std::size_t>(k); }

using Vector = std::array<Interval, 3>;

Vector row_of(const Points<Interval>& rows, Eigen::Index k) { return {rows(k, 0), rows(k, 1), rows(k, 2)}; }

/// axis . (a x b): the oriented area of the projections along the axis.
Interval area(const std::array<int, 3>& axis, const Vector& a, const Vector& b) {
  return Interval(axis[0]) * (a[1] * b[2] - a[2] * b[1]) + Interval(axis[1]) * (a[2] * b[0] - a[0] * b[2]) +
         Interval(axis[2]) * (a[0] * b[1] - a[1] * b[0]);
}

Interval dot(const std::array<int, 3>& axis, const Vector& a) {
  return Interval(axis[0]) * a[0] + Interval(axis[1]) * a[1] + Interval(axis[2]) * a[2];
}

int sign(const Interval& x) { return x > Interval(0) ? 1 : x < Interval(0) ? -1 : 0; }

/// Whether axis . (q x q') > 0 on the whole curve with Bezier points q (degree 4), by the Bernstein coefficients of degree 7.
bool turns_forward(const Points<Interval>& q, const std::array<int, 3>& axis) {
  static constexpr std::array of_four{1, 4, 6, 4, 1}, of_three{1, 3, 3, 1, 0};
  for (int k = 0; k <= 7; ++k) {
    Interval sum(0);
    for (int i = std::max(0, k - 3); i <= std::min(4, k); ++i) {
      const Vector a = row_of(q, i), next = row_of(q, k - i + 1), here = row_of(q, k - i);
      sum += Interval(of_four[at(i)] * of_three[at(k - i)]) *
             area(axis, a, {next[0] - here[0], next[1] - here[1], next[2] - here[2]});
    }
    if (!(sum > Interval(0))) return false;
  }
  return true;
}

/// Whether the projected points lie in an open half-plane through the origin: then the curve turns by less than half a turn.
bool in_half_plane(const Points<Interval>& q, const std::array<int, 3>& axis) {
  // Every point strictly forward of the first and less than half a turn from it, or the same for the last.
  bool after_first = true, before_last = true;
  for (Eigen::Index k = 1; k + 1 <= q.rows(); ++k) {
    after_first &= area(axis, row_of(q, 0), row_of(q, k)) > Interval(0);
    before_last &= area(axis, row_of(q, k - 1), row_of(q, q.rows() - 1)) > Interval(0);
  }
  return after_first || before_last;
}

/// Pieces that each turn forward by less than half a turn make one turn in all: seen from a direction u that piece `first`
/// passes, the corners from its end round to its start lie forward of u, then backward, and never forward again.
bool turns_once(const std::vector<Points<Interval>>& pieces, std::size_t first, Eigen::Index through,
                const std::array<int, 3>& axis) {
  const Vector u = row_of(pieces[first], through);
  if (!(area(axis, row_of(pieces[first], 0), u) > Interval(0))) return false;
  int before = 1;
  for (std::size_t k = 1; k <= pieces.size(); ++k) {
    const int now = sign(area(axis, u, row_of(pieces[(first + k) % pieces.size()], 0)));
    if (now == 0 || now > before || (k == 1 && now < 0)) return false;
    before = now;
  }
  return before < 0;
}

}  // namespace

const std::array<int, 3>& plane_direction(int k) {
  static constexpr std::array<std::array<int, 3>, plane_directions> directions{{{1, 0, 0},
                                                                                {0, 1, 0},
                                                                                {0, 0, 1},
                                                                                {1, 1, 0},
                                                                                {1, -1, 0},
                                                                                {1, 0, 1},
                                                                                {1, 0, -1},
                                                                                {0, 1, 1},
                                                                                {0, 1, -1},
                                                                                {1, 1, 1},
                                                                                {1, 1, -1},
                                                                                {1, -1, 1},
                                                                                {1, -1, -1}}};
  return directions[at(k)];
}

EmbeddingFacts::EmbeddingFacts(const LoopMesh& surface, int rounds, const std::atomic<bool>* stop)
    : patches_(enclosed_patches(surface, rounds, stop)), steps_(enclosed_steps(*surface.mesh)) {
  const Mesh& mesh = *patches_.mesh;
  for (int v = 0; v < mesh.vertices(); ++v) rings_.push_back(vertex_ring(mesh, v));
  std::map<int, CornerAnalysis<Interval>> corners;
  for (const int n : valences_of(mesh)) {
    weight_.emplace(n, loop_weight<Interval>(n));
    if (n != 6) corners.emplace(n, CornerAnalysis<Interval>(n));
  }
  for (int v = 0; v < mesh.vertices(); ++v) {
    if (mesh.valence(v) == 6) continue;
    std::set<int> near{v};
    for (int ring = 0; ring < 3; ++ring) {
      const std::set<int> before = near;
      for (const int u : before) near.insert(rings_[at(u)].begin(), rings_[at(u)].end());
    }
    for (const int u : near)
      require(u == v || mesh.valence(u) == 6, "irregular vertices are fewer than four edges apart: more rounds are needed");
  }
  for (int f = 0; f < mesh.faces(); ++f) {
    throw_if_stopped(stop);
    const Points<Interval>& net = patches_.net[at(f)];
    pieces_.push_back(piece_of(net));
    const bool regular = patches_.patch[at(f)].valence == 6;
    cone_.push_back(regular ? std::nullopt : corners.at(patches_.patch[at(f)].valence).cone(net));
    bezier_.push_back(regular ? bezier_points(net) : Points<Interval>());
    normal_.push_back(regular ? cross_product(derivative(bezier_.back(), 4, 0), 3, derivative(bezier_.back(), 4, 1), 3)
                              : Points<Interval>());
  }
}

int EmbeddingFacts::irregular_neighbour(int v) const {
  if (mesh().valence(v) != 6) return v;
  for (const int u : rings_[at(v)])
    if (mesh().valence(u) != 6) return u;
  return -1;
}

std::vector<int> EmbeddingFacts::disc(int v) const {
  std::set<int> faces;
  for (const int centre : {v, irregular_neighbour(v)}) {
    if (centre < 0) continue;
    const int first = mesh().outgoing[at(centre)];
    int h = first;
    do {
      faces.insert(mesh().face[at(h)]);
      h = mesh().around(h);
    } while (h != first);
  }
  return {faces.begin(), faces.end()};
}

Vector EmbeddingFacts::limit_of(int v) const {
  const Interval& w = weight_.at(mesh().valence(v));
  Vector sum;
  for (int c = 0; c < 3; ++c) {
    sum[at(c)] = w * patches_.points(v, c);
    for (const int u : rings_[at(v)]) sum[at(c)] += patches_.points(u, c);
    sum[at(c)] /= w + Interval(mesh().valence(v));
  }
  return sum;
}

bool EmbeddingFacts::has_normals_along(int face, const std::array<int, 3>& axis) const {
  if (patches_.patch[at(face)].valence == 6) {
    for (Eigen::Index k = 0; k < normal_[at(face)].rows(); ++k)
      if (!(dot(axis, row_of(normal_[at(face)], k)) > Interval(0))) return false;
    return true;
  }
  // The angle between the axes plus that of the cone is below a right angle: a . b > |a| sin alpha.
  const std::optional<NormalCone<Interval>>& cone = cone_[at(face)];
  if (!cone) return false;
  const Interval along = dot(axis, cone->axis);
  const int square = axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2];
  return along > Interval(0) && along * along > Interval(square) * (Interval(1) - cone->cosine * cone->cosine);
}

/// Half-edges of the faces whose other side is no face of the set, in order along the curve; none unless the set is a disc.
std::optional<std::vector<int>> EmbeddingFacts::boundary(const std::vector<int>& faces) const {
  const auto is_in = [&](int f) { return std::ranges::binary_search(faces, f); };
  std::map<int, int> leaving;  // by vertex
  std::set<int> vertices;
  int edges = 0;
  for (const int f : faces) {
    for (int h = 3 * f; h < 3 * f + 3; ++h) {
      const int twin = mesh().twin[at(h)], v = mesh().vertex[at(h)];
      vertices.insert(v);
      const bool outer = !is_in(mesh().face[at(twin)]);
      if (outer || h < twin) ++edges;
      if (outer && !leaving.emplace(v, h).second) return std::nullopt;
    }
  }
  if (static_cast<int>(vertices.size()) - edges + static_cast<int>(faces.size()) != 1 || leaving.empty()) return std::nullopt;
  std::vector<int> curve;
  for (int h = leaving.begin()->second; curve.empty() || h != curve.front();) {
    curve.push_back(h);
    const auto next = leaving.find(mesh().tip(h));
    if (next == leaving.end() || curve.size() > leaving.size()) return std::nullopt;
    h = next->second;
  }
  if (curve.size() != leaving.size()) return std::nullopt;
  return curve;
}

/// Bezier points of the limit of an edge, along its half-edge, from a regular patch beside it.
std::optional<Points<Interval>> EmbeddingFacts::edge_curve(int half_edge) const {
  const int twin = mesh().twin[at(half_edge)];
  const bool mine = patches_.patch[at(mesh().face[at(half_edge)])].valence == 6;
  const int h = mine ? half_edge : twin, face = mesh().face[at(h)];
  if (patches_.patch[at(face)].valence != 6) return std::nullopt;
  const int side = (h - patches_.patch[at(face)].half_edge + 3) % 3;
  Points<Interval> curve(5, 3);
  for (int t = 0; t <= 4; ++t) {
    const int i = side == 0 ? t : side == 1 ? 4 - t : 0, j = side == 0 ? 0 : side == 1 ? t : 4 - t;
    curve.row(mine ? t : 4 - t) = bezier_[at(face)].row(bernstein_index(4, i, j));
  }
  return curve;
}

bool EmbeddingFacts::goes_round(const std::vector<int>& boundary, const Vector& centre, const std::array<int, 3>& axis) const {
  std::vector<Points<Interval>> pieces;
  for (const int h : boundary) {
    std::optional<Points<Interval>> curve = edge_curve(h);
    if (!curve) return false;
    for (Eigen::Index k = 0; k < 5; ++k)
      for (Eigen::Index c = 0; c < 3; ++c) (*curve)(k, c) -= centre[static_cast<std::size_t>(c)];
    if (!turns_forward(*curve, axis) || !in_half_plane(*curve, axis)) return false;
    pieces.push_back(std::move(*curve));
  }
  for (std::size_t first = 0; first < pieces.size(); ++first)
    for (const Eigen::Index through : {1, 2, 3})  // a corner may lie just opposite to one of them
      if (turns_once(pieces, first, through, axis)) return true;
  return false;
}

bool EmbeddingFacts::is_graph(int v, const std::array<int, 3>& axis) const {
  const std::vector<int> faces = disc(v);
  const std::optional<std::vector<int>> curve = boundary(faces);
  if (!curve) return false;
  for (const int f : faces)
    if (!has_normals_along(f, axis)) return false;
  Vector centre = limit_of(v);
  const int other = irregular_neighbour(v);
  if (other >= 0 && other != v) {
    const Vector second = limit_of(other);
    for (std::size_t c = 0; c < 3; ++c) centre[c] = (centre[c] + second[c]) / Interval(2);
  }
  return goes_round(*curve, centre, axis);
}

std::array<int, 3> EmbeddingFacts::likely_axis(int v) const {
  std::array<double, 3> sum{0, 0, 0};
  for (const int f : disc(v)) {
    const auto c = mesh().corners(f);
    const auto difference = [&](int k, int column) {
      return patches_.points(c[at(k)], column).midpoint() - patches_.points(c[0], column).midpoint();
    };
    for (int k = 0; k < 3; ++k) {
      const int a = (k + 1) % 3, b = (k + 2) % 3;
      sum[at(k)] += difference(1, a) * difference(2, b) - difference(1, b) * difference(2, a);
    }
  }
  const double most = std::max({std::abs(sum[0]), std::abs(sum[1]), std::abs(sum[2]), 1e-300});
  std::array<int, 3> axis{};
  for (std::size_t k = 0; k < 3; ++k) axis[k] = static_cast<int>(std::lround(100 * sum[k] / most));
  return axis;
}

std::vector<std::pair<int, int>> EmbeddingFacts::close_pairs() const {
  std::vector<SpaceBox> boxes;
  for (const PatchPiece& patch : pieces_) {
    SpaceBox box;
    for (Eigen::Index c = 0; c < 3; ++c) {  // doubles next to the end points, outward
      const auto& [least, most] = patch.range[static_cast<std::size_t>(c)];
      box.low[c] = std::nextafter(least.lower().to_double(), -HUGE_VAL);
      box.high[c] = std::nextafter(most.upper().to_double(), HUGE_VAL);
    }
    boxes.push_back(box);
  }
  std::vector<std::pair<int, int>> pairs;
  BoxTree(std::move(boxes)).pairs([&](int f, int g) {
    for (const int v : mesh().corners(f))
      for (const int u : mesh().corners(g))
        if (u == v) return true;
    pairs.emplace_back(f, g);
    return true;
  });
  std::ranges::sort(pairs);
  return pairs;
}

PatchPiece EmbeddingFacts::piece_of(Points<Interval> net) {
  PatchPiece piece{std::move(net), {}, nullptr};
  const Points<Interval> hull = piece.net.rows() == 12 ? bezier_points(piece.net) : piece.net;
  for (int k = 0; k < plane_directions; ++k) {
    const std::array<int, 3>& direction = plane_direction(k);
    auto& [least, most] = piece.range[at(k)];
    for (Eigen::Index i = 0; i < hull.rows(); ++i) {
      Interval value(0);
      for (int c = 0; c < 3; ++c)
        if (direction[at(c)] != 0) value += direction[at(c)] > 0 ? hull(i, c) : -hull(i, c);
      least = i == 0 ? value : min(least, value);
      most = i == 0 ? value : max(most, value);
    }
  }
  return piece;
}

std::array<PatchPiece, 4>& EmbeddingFacts::parts(PatchPiece& whole) const {
  if (whole.parts) return *whole.parts;
  const PatchStep<Interval>& step = steps_.at(static_cast<int>(whole.net.rows()) - 6);
  const auto part = [&](const Points<Interval>& rows) { return piece_of(weighted_rows(rows, whole.net)); };
  whole.parts = std::make_unique<std::array<PatchPiece, 4>>(
      std::array<PatchPiece, 4>{part(step.inner), part(step.regular[0]), part(step.regular[1]), part(step.regular[2])});
  return *whole.parts;
}

bool EmbeddingFacts::are_separated(const PatchPiece& a, const PatchPiece& b, int direction) {
  const auto& [a_low, a_high] = a.range[at(direction)];
  const auto& [b_low, b_high] = b.range[at(direction)];
  return a_high < b_low || b_high < a_low;
}

}  // namespace udcp
