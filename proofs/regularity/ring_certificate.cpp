// The rings around one vertex: the walk that collects its points, their exact descendants, and the inequality in enclosures.
#include "proofs/regularity/ring_certificate.h"

#include "proofs/certificate.h"

namespace udcp {
namespace {

using Index = Eigen::Index;

Interval length_squared(const Points<Interval>& rows, Index i) {
  Interval sum(0);
  for (Index c = 0; c < rows.cols(); ++c) sum += pow(rows(i, c), 2);
  return sum;
}

Points<Interval> cross(const Points<Interval>& p) {
  Points<Interval> result(1, 3);
  for (Index c = 0; c < 3; ++c) {
    const Index d = (c + 1) % 3, e = (c + 2) % 3;
    result(0, c) = p(0, d) * p(1, e) - p(0, e) * p(1, d);
  }
  return result;
}

/// The largest singular value of two rows p: the root of the larger eigenvalue of p p^T.
Interval largest_singular_value(const Points<Interval>& p) {
  const Interval a = length_squared(p, 0), d = length_squared(p, 1), two(2);
  Interval b(0);
  for (Index c = 0; c < 3; ++c) b += p(0, c) * p(1, c);
  return sqrt((a + d) / two + sqrt(pow((a - d) / two, 2) + pow(b, 2)));
}

/// A least common multiple of denominators; the numbers of a ring have few different ones.
Rational common_denominator(const Points<Rational>& points) {
  Rational result(1);
  for (Index i = 0; i < points.rows(); ++i)
    for (Index c = 0; c < points.cols(); ++c) result *= (result * points(i, c)).denominator();
  return result;
}

/// Whether the rules of a vertex inside, of valence 4 in quads, hold at v.
bool is_ordinary(const Mesh& mesh, int v) {
  if (mesh.on_boundary(v) || mesh.valence(v) != 4) return false;
  const int first = mesh.outgoing[Mesh::i(v)];
  int h = first;
  do {
    if (mesh.size(mesh.face[Mesh::i(h)]) != 4) return false;
    h = mesh.around(h);
  } while (h != first);
  return true;
}

std::vector<int> spokes_of(const Mesh& mesh, const Tags& tags, int v) {
  require(v >= 0 && v < mesh.vertices(), "there is no vertex " + std::to_string(v));
  require(!mesh.on_boundary(v) && !tags.is_corner(v), "the vertex lies on the boundary or is tagged");
  const int n = mesh.valence(v);
  require(n >= 3 && n <= largest_ring_valence,
          "rings of patches have bounds around vertices of valence 3 to " + std::to_string(largest_ring_valence));
  std::vector<int> result;
  int h = mesh.outgoing[Mesh::i(v)];
  for (int s = 0; s < n; ++s) {
    result.push_back(h);
    require(mesh.size(mesh.face[Mesh::i(h)]) == 4, "a face at the vertex is no quad");
    for (const int w : {mesh.tip(h), mesh.tip(mesh.next(h))})
      require(is_ordinary(mesh, w) && !tags.is_corner(w),
              "a face at the vertex has another corner that is not inside, untagged, of valence 4 and in quads only");
    h = mesh.around(h);
  }
  return result;
}

/// The vertices of two rings in the order of ring_mesh. The face behind an edge is entered at the twin of the half-edge.
std::vector<int> two_rings_around(const Mesh& mesh, int v, const std::vector<int>& spokes) {
  const int n = static_cast<int>(spokes.size());
  std::vector<int> result(static_cast<std::size_t>(1 + 6 * n), v);
  for (int s = 0; s < n; ++s) {
    const auto set = [&](int i, int j, int h) { result[Mesh::i(ring_index(n, {s, 2 * i, 2 * j}))] = mesh.tip(h); };
    const auto twin = [&](int h) { return mesh.twin[Mesh::i(h)]; };
    const int out = spokes[Mesh::i(s)], side = mesh.next(out);  // side: from (1, 0) to (1, 1)
    set(1, 0, out);
    set(1, 1, side);
    const int right = mesh.next(twin(side)), above = mesh.next(twin(mesh.next(side)));  // to (2, 0) and to (1, 2)
    set(2, 0, right);
    set(2, 1, mesh.next(right));
    set(1, 2, above);
    set(2, 2, mesh.next(twin(mesh.next(mesh.next(right)))));
  }
  return result;
}

Points<Rational> in_space(const Points<Rational>& points) {
  Points<Rational> result = Points<Rational>::Zero(points.rows(), 3);
  result.leftCols(points.cols()) = points;
  return result;
}

Points<Interval> enclosed(const Points<Rational>& points) {
  Points<Interval> result(points.rows(), points.cols());
  for (Index i = 0; i < points.rows(); ++i)
    for (Index c = 0; c < points.cols(); ++c) result(i, c) = Interval(points(i, c));
  return result;
}

}  // namespace

VertexRings::VertexRings(const Points<Rational>& two_rings) {
  const Index n = (two_rings.rows() - 1) / 6;
  require(two_rings.rows() == 1 + 6 * n && n >= 3 && n <= largest_ring_valence,
          "no two rings around a vertex have that many points");
  require(two_rings.cols() >= 1 && two_rings.cols() <= 3, "the points around a vertex need one to three coordinates");
  constants_ = ring_constants(static_cast<int>(n));
  levels_.push_back(in_space(two_rings));
  middle_ = sparse_product<Rational>(constants_->mean, levels_[0]);
  const Interval::Precision precision(ring_precision);
  // L 1 = 0, so the limit point may be taken off first: then nothing depends on where the surface lies.
  tangents_ = constants_->left * enclosed(levels_[0].rowwise() - middle_.row(0));
}

VertexRings VertexRings::around(const Surface<Rational>& surface, int v) {
  const std::vector<int> spokes = spokes_of(*surface.mesh, surface.tags, v);
  const std::vector<int> vertices = two_rings_around(*surface.mesh, v, spokes);
  Points<Rational> points(static_cast<Index>(vertices.size()), surface.points.cols());
  for (std::size_t k = 0; k < vertices.size(); ++k) points.row(static_cast<Index>(k)) = surface.points.row(vertices[k]);
  VertexRings result(points);
  result.spokes_ = spokes;
  return result;
}

const Points<Rational>& VertexRings::points(int level) {
  require(level >= 0 && level <= largest_ring_level, "there are levels 0 to " + std::to_string(largest_ring_level) + " only");
  while (static_cast<int>(levels_.size()) <= level)
    levels_.push_back(sparse_product<Rational>(constants_->outer.topRows(levels_[0].rows()), levels_.back()));
  return levels_[static_cast<std::size_t>(level)];
}

std::vector<BicubicNet> VertexRings::nets(int ring) {
  require(ring >= 1, "the first ring is ring 1");
  (void)points(ring);
  const Points<Rational> outer = sparse_product<Rational>(constants_->outer, points(ring - 1));
  const Rational scale = common_denominator(outer);
  std::vector<Vector3> scaled;
  for (Index i = 0; i < outer.rows(); ++i) scaled.push_back({scale * outer(i, 0), scale * outer(i, 1), scale * outer(i, 2)});
  std::vector<BicubicNet> result;
  for (int patch = 0; patch < 3 * valence(); ++patch) {
    const std::array<int, 16> numbers = ring_net(valence(), patch);
    BicubicNet& net = result.emplace_back();
    for (std::size_t k = 0; k < 16; ++k) net.points[k] = scaled[static_cast<std::size_t>(numbers[k])];
  }
  return result;
}

bool VertexRings::has_normal() const {
  const Interval::Precision precision(ring_precision);
  return length_squared(cross(tangents_), 0) > Interval(0);
}

// Proof. L, w being left eigenvectors, Y = X - 1 w X - E L X satisfies w Y = 0, L Y = 0, so A^m X = 1 w X + lambda^m (E p + R),
// R = B^m Y. For r >= 0 a row d of differences over level m + r gives lambda^-(m+r) d A^(m+r) X = c p + e with c = d E and
// e = d Q B^r R, |e| <= D C max |row of R| = eta. So for u = c p + e and v = c' p + e', with |c p| <= sigma G,
// |u x v - det(c, c') N| <= 2 G sigma eta + eta^2, and N.(u x v) >= |N| (|N| kappa - 2 G sigma eta - eta^2) > 0 for all u and v:
// condition (D) of Theorem 3 as corrected. Level m + r makes ring m + r + 1, so this proves all rings from m + 1 on. The first
// condition implies |N| > 0; with it and the regular and injective characteristic map the surface is regular and C^1 at the
// vertex, too (Reif).
bool VertexRings::closes_at(int level) {
  const Interval::Precision precision(ring_precision);
  const RingConstants& c = *constants_;
  const Interval scale = pow(c.lambda, level);
  const Points<Interval> above = enclosed(points(level).rowwise() - middle_.row(0));
  const Points<Interval> rest = above / scale - c.right * tangents_;
  Interval largest(0);
  for (Index i = 0; i < rest.rows(); ++i) largest = max(largest, sqrt(length_squared(rest, i)));
  const Interval eta = Interval(c.difference) * c.tail * largest;
  const Interval normal = sqrt(length_squared(cross(tangents_), 0));
  return normal * c.kappa > Interval(2) * c.size * largest_singular_value(tangents_) * eta + pow(eta, 2);
}

FacePoint face_point(const Mesh& mesh, const std::vector<int>& spokes, int ring, int patch, const Rational& u,
                     const Rational& v) {
  const int h = spokes.at(static_cast<std::size_t>(patch / 3)), face = mesh.face[Mesh::i(h)];
  const Rational scale = pow(Rational(2), -ring), one(1);
  const Rational x = scale * (Rational(patch % 3 == 2 ? 0 : 1) + u), y = scale * (Rational(patch % 3 == 0 ? 0 : 1) + v);
  // x runs along h, which leaves corner 0, 1, 2 or 3 of the face; y along its predecessor, backwards.
  switch (h - mesh.face_begin[Mesh::i(face)]) {
    case 0:
      return {face, x, y};
    case 1:
      return {face, one - y, x};
    case 2:
      return {face, one - x, one - y};
    default:
      return {face, y, one - x};
  }
}

}  // namespace udcp
