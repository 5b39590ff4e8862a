// Rings around vertices: exact rings, the level at which they close, and data that must not close.
#include "proofs/regularity/ring_certificate.h"

#include <doctest/doctest.h>

#include <cmath>
#include <set>

#include "operators/shapes.h"
#include "proofs/certificate.h"
#include "proofs/regularity/ring_search.h"
#include "tests/proofs/regularity_meshes.h"

using namespace udcp;

namespace {

using Index = Eigen::Index;
using Status = AdaptiveResult::Status;

/// Two flat rings with noise in thousandths, off the plane too.
Points<Rational> noisy_rings(int n, int noise, std::mt19937& random) {
  std::uniform_int_distribution<int> jitter(-noise, noise);
  const Points<double> flat = ring_mesh(n, 2).points;
  Points<Rational> result(flat.rows(), 3);
  for (Index i = 0; i < flat.rows(); ++i)
    for (Index c = 0; c < 3; ++c) result(i, c) = Rational(static_cast<int>(std::lround(1000 * flat(i, c))) + jitter(random));
  return result;
}

std::vector<Label> labels_of(int n) {
  std::vector<Label> result(static_cast<std::size_t>(1 + 6 * n));
  for (int s = 0; s < n; ++s)
    for (int i = 1; i <= 2; ++i)
      for (int j = 0; j <= 2; ++j) result[static_cast<std::size_t>(ring_index(n, {s, 2 * i, 2 * j}))] = {s, 2 * i, 2 * j};
  return result;
}

/// The points in the order that a change of labels gives.
template <class Change>
Points<Rational> relabelled(const Points<Rational>& points, int n, Change change) {
  Points<Rational> result(points.rows(), points.cols());
  const std::vector<Label> labels = labels_of(n);
  for (std::size_t k = 0; k < labels.size(); ++k)
    result.row(static_cast<Index>(k)) = points.row(ring_index(n, change(labels[k])));
  return result;
}

int closing_level(const Points<Rational>& points) {
  VertexRings rings(points);
  for (int level = 0; level <= largest_ring_level; ++level)
    if (rings.closes_at(level)) return level;
  return -1;
}

RingResult decide(VertexRings rings, int depth = 4) {
  AdaptiveOptions options;
  options.depth = depth;
  options.planar = true;
  for (Index i = 0; i < rings.points(0).rows(); ++i) options.planar = options.planar && rings.points(0)(i, 2).is_zero();
  return decide_rings(rings, options);
}

/// All patches of a ring pass T2 with at most `depth` splits.
bool is_regular_ring(VertexRings& rings, int ring, int depth) {
  AdaptiveOptions options;
  options.depth = depth;
  const std::vector<BicubicNet> nets = rings.nets(ring);
  return decide_patches(nets, std::vector<int>(nets.size(), 0), options).status == Status::regular;
}

}  // namespace

TEST_SUITE_BEGIN("proofs");

TEST_CASE("rings are the patches around the vertex in the exactly refined mesh and cover its faces") {
  for (const std::string name : {"star3", "star5"}) {
    CAPTURE(name);
    const Surface<Rational> star = oracle::regularity_mesh(name);
    VertexRings rings = VertexRings::around(star, 0);
    for (int m = 1; m <= 3; ++m) {
      CAPTURE(m);
      const Surface<Rational> coarse = oracle::refined(star, m - 1), fine = oracle::refined(star, m);
      const QuadMesh quads(fine);
      const Rational fine_scale = quads.point(0)[0] / fine.points(0, 0);
      const std::vector<BicubicNet> nets = rings.nets(m);
      const Rational scale = nets[0].at(1, 0)[0] / fine.points(0, 0);  // the centre
      // Faces of the next level are numbered by the corners that they lie at.
      std::set<int> expected, found;
      for (int f = 0; f < coarse.mesh->faces(); ++f) {
        const auto corners = coarse.mesh->corners(f);
        if (std::find(corners.begin(), corners.end(), 0) == corners.end()) continue;
        for (int k = 0; k < 4; ++k)
          if (corners[static_cast<std::size_t>(k)] != 0) expected.insert(4 * f + k);
      }
      for (const BicubicNet& net : nets) {
        for (const int f : expected) {
          const BicubicNet other = quads.net(f);
          for (int turn = 0; turn < 4; ++turn) {
            bool same = true;
            for (int i = 0; i < 4; ++i)
              for (int j = 0; j < 4; ++j) {
                const std::array<std::array<int, 2>, 4> places{{{i, j}, {j, 3 - i}, {3 - i, 3 - j}, {3 - j, i}}};
                const auto& [row, column] = places[static_cast<std::size_t>(turn)];
                same = same && fine_scale * net.at(i, j) == scale * other.at(row, column);
              }
            if (same) found.insert(f);
          }
        }
      }
      CHECK(found == expected);
      CHECK(nets.size() == expected.size());
    }
  }
}

TEST_CASE("points of rings lie in the faces at the vertex however these begin") {
  const Surface<Rational> star = oracle::regularity_mesh("star5");
  const auto place = [](const Surface<Rational>& surface, const FacePoint& p) {
    const auto c = surface.mesh->corners(p.face);
    const Rational one(1);
    return Points<Rational>((one - p.u) * (one - p.v) * surface.points.row(c[0]) + p.u * (one - p.v) * surface.points.row(c[1]) +
                            p.u * p.v * surface.points.row(c[2]) + (one - p.u) * p.v * surface.points.row(c[3]));
  };
  const Rational u = Rational(1) / Rational(4), v = Rational(1) / Rational(2);
  for (int turn = 0; turn < 4; ++turn) {
    std::vector<std::vector<int>> faces;
    for (int f = 0; f < star.mesh->faces(); ++f) {
      const auto c = star.mesh->corners(f);
      faces.emplace_back();
      for (int k = 0; k < 4; ++k) faces.back().push_back(c[static_cast<std::size_t>((k + turn + f) % 4)]);
    }
    Surface<Rational> turned = star;
    turned.mesh = std::make_shared<const Mesh>(make_mesh(star.mesh->vertices(), faces));
    const VertexRings rings = VertexRings::around(turned, 0);
    for (int patch = 0; patch < 15; ++patch) {
      const int h = rings.spokes()[static_cast<std::size_t>(patch / 3)], e = turned.mesh->tip(h);
      const int f = turned.mesh->tip(turned.mesh->next(h)), g = turned.mesh->vertex[Mesh::i(turned.mesh->prev(h))];
      // sector coordinates of the point, by the corners that the spokes lead to
      const Rational x = (Rational(patch % 3 == 2 ? 0 : 1) + u) / Rational(4),
                     y = (Rational(patch % 3 == 0 ? 0 : 1) + v) / Rational(4);
      const Rational one(1);
      const Points<Rational> expected = (one - x) * (one - y) * star.points.row(0) + x * (one - y) * star.points.row(e) +
                                        x * y * star.points.row(f) + (one - x) * y * star.points.row(g);
      CHECK(place(turned, face_point(*turned.mesh, rings.spokes(), 2, patch, u, v)) == expected);
    }
  }
}

TEST_CASE("rings of the stars close at their levels and are regular") {
  for (const auto& entry : oracle::expected_regularity()["ring_certificates"].items()) {
    const std::string name = entry.key();
    const Json& expected = entry.value();
    CAPTURE(name);
    const RingResult result = decide(VertexRings::around(oracle::regularity_mesh(name), expected["vertex"].get<int>() - 1));
    CHECK(result.status == Status::regular);
    CHECK(result.level == expected["level"].get<int>());
    REQUIRE(result.rings.size() == expected["ring_depths"].size());
    for (std::size_t k = 0; k < result.rings.size(); ++k) CHECK(result.rings[k].depth == expected["ring_depths"][k].get<int>());
  }
}

TEST_CASE("rings of the cube close after two steps") {
  const Json& expected = oracle::expected_regularity()["cube_after_two_cc_steps"];
  const Surface<Rational> surface = oracle::refined(cube<Rational>(), 2);
  int vertices = 0;
  for (int v = 0; v < surface.mesh->vertices(); ++v) {
    if (surface.mesh->valence(v) == 4) continue;
    ++vertices;
    const RingResult result = decide(VertexRings::around(surface, v));
    CHECK(result.status == Status::regular);
    CHECK(result.level == expected["ring_level"][0].get<int>());
  }
  CHECK(vertices == 8);
}

TEST_CASE("where rings close depends neither on place nor on size nor on the first spoke nor on the side") {
  std::mt19937 random(3);
  for (const int n : {3, 5, 6}) {
    CAPTURE(n);
    const Points<Rational> points = noisy_rings(n, 60, random);
    const int level = closing_level(points);
    REQUIRE(level > 0);
    const Sectors sectors{n, false, false};
    CHECK(closing_level(relabelled(points, n, [&](const Label& l) { return sectors.rotated(l, 1); })) == level);
    CHECK(closing_level(relabelled(points, n, [&](const Label& l) { return sectors.mirrored(l); })) == level);
    CHECK(closing_level(Points<Rational>(Rational::parse("1e30") / Rational(7) * points)) == level);
    CHECK(closing_level(Points<Rational>(Rational::parse("1e-30") / Rational(7) * points)) == level);
    Points<Rational> moved = points;
    for (Index i = 0; i < moved.rows(); ++i) moved(i, 1) += Rational::parse("1e60");
    CHECK(closing_level(moved) == level);
    Points<Rational> turned = points;  // by the angle of the triangle 3, 4, 5
    for (Index i = 0; i < turned.rows(); ++i) {
      turned(i, 0) = (Rational(3) * points(i, 0) - Rational(4) * points(i, 2)) / Rational(5);
      turned(i, 2) = (Rational(4) * points(i, 0) + Rational(3) * points(i, 2)) / Rational(5);
    }
    CHECK(closing_level(turned) == level);
  }
}

TEST_CASE("rings beyond the closing level pass one by one") {
  std::mt19937 random(4);
  for (int n = 3; n <= 12; ++n) {
    CAPTURE(n);
    const Points<Rational> points = noisy_rings(n, 80, random);
    VertexRings rings(points);
    const int level = closing_level(points);
    REQUIRE(level >= 0);
    REQUIRE(level < largest_ring_level - 2);
    for (int ring = level + 1; ring <= level + 2; ++ring) CHECK(is_regular_ring(rings, ring, rings.constants().splits));
    for (int later = level; later <= level + 2; ++later) CHECK(rings.closes_at(later));
  }
}

TEST_CASE("a plane grid closes at once") {
  Points<Rational> grid(25, 2);
  const Sectors sectors{4, false, false};
  for (int x = -2; x <= 2; ++x) {
    for (int y = -2; y <= 2; ++y) {
      const Index k = ring_index(4, sectors.label(0, {2 * x, 2 * y}));
      grid(k, 0) = Rational(x);
      grid(k, 1) = Rational(y);
    }
  }
  CHECK(closing_level(grid) == 0);
  const RingResult result = decide(VertexRings(grid));
  CHECK(result.status == Status::regular);
  CHECK(result.rings.empty());
}

TEST_CASE("a vertex without a normal never closes") {
  std::mt19937 random(5);
  std::uniform_int_distribution<int> any(-50, 50);
  for (const int n : {3, 5, 8}) {
    CAPTURE(n);
    const Sectors sectors{n, false, false};
    Points<Rational> line = noisy_rings(n, 50, random), folded = line, point = line;
    for (Index i = 0; i < line.rows(); ++i) {
      line.row(i) = line(i, 0) * line.row(0);
      point.row(i) = line.row(0);
    }
    // Folded on a mirror plane: both halves coincide.
    for (const Label& l : labels_of(n)) {
      const Label image = l.is_centre() ? l : sectors.mirrored(l);
      folded.row(ring_index(n, image)) = folded.row(ring_index(n, l));
    }
    for (const Points<Rational>& points : {line, folded, point}) {
      CHECK(closing_level(points) == -1);
      const RingResult result = decide(VertexRings(points));
      CHECK(result.status == Status::undecided);
      CHECK(result.reason == "the tangent plane at the vertex may be degenerate");
    }
  }
}

TEST_CASE("a star folded on a line is not regular") {
  for (const std::string name : {"star3", "star5", "star6"}) {
    for (const int at : {1, 3, 5, 8}) {  // tenths to the left of the vertex
      CAPTURE(name);
      CAPTURE(at);
      Surface<Rational> star = oracle::regularity_mesh(name);
      const Rational line = star.points(0, 0) - Rational(at) / Rational(10);
      for (Index i = 0; i < star.points.rows(); ++i) star.points(i, 0) = abs(star.points(i, 0) - line);
      CHECK(decide(VertexRings::around(star, 0), 8).status == Status::sign);
    }
  }
}

TEST_CASE("random rings are proved only where the normal of all rings keeps to one side") {
  std::mt19937 random(6);
  int proved = 0, other = 0;
  for (int k = 0; k < 15; ++k) {
    const int n = 3 + k % 5;
    CAPTURE(k);
    Points<Rational> points = noisy_rings(n, 900, random);
    points.col(2).setZero();
    VertexRings rings(points);
    const RingResult result = decide(rings, 2);
    if (result.status != Status::regular) {
      ++other;
      continue;
    }
    ++proved;
    int first = 0;
    for (int ring = 1; ring <= result.level + 2; ++ring) {
      for (const BicubicNet& net : rings.nets(ring)) {
        for (const char* path : {"0", "3", "12", "21"}) {
          for (const int r : {0, 1}) {
            const CornerValues at = corner(descendant(net, path), r, 1 - r);
            const int sign = cross(at.du, at.dv)[2].sign();
            if (first == 0) first = sign;
            CHECK(sign == first);
          }
        }
      }
    }
  }
  CHECK(proved > 0);
  CHECK(other > 0);
}

TEST_CASE("rings refuse vertices that they do not cover") {
  const Surface<Rational> star = oracle::regularity_mesh("star5");
  const auto refused = [](const Surface<Rational>& surface, int v) {
    try {
      (void)VertexRings::around(surface, v);
    } catch (const Rejected& reason) {
      return std::string(reason.what());
    }
    return std::string();
  };
  CHECK(refused(star, 0).empty());
  CHECK(refused(star, -1) == "there is no vertex -1");
  CHECK(refused(star, star.mesh->vertices()) == "there is no vertex " + std::to_string(star.mesh->vertices()));
  int rim = 0;
  while (!star.mesh->on_boundary(rim)) ++rim;
  CHECK(refused(star, rim) == "the vertex lies on the boundary or is tagged");
  const std::string corner =
      "a face at the vertex has another corner that is not inside, untagged, of valence 4 and in quads only";
  CHECK(refused(cube<Rational>(), 0) == corner);
  CHECK(refused(oracle::refined(cube<Rational>(), 1), 0).empty());
  Surface<Rational> tagged = star;
  tagged.tags.corner.assign(static_cast<std::size_t>(star.mesh->vertices()), 0);
  tagged.tags.corner[1] = 1;
  CHECK(refused(tagged, 0) == corner);
  CHECK(refused(tetrahedron<Rational>(), 0) == "a face at the vertex is no quad");
  CHECK_THROWS_AS(VertexRings(Points<Rational>(Points<Rational>::Zero(30, 3))), Rejected);
  CHECK_THROWS_AS(VertexRings(Points<Rational>(Points<Rational>::Zero(13, 3))), Rejected);
  CHECK_THROWS_AS(VertexRings(Points<Rational>(Points<Rational>::Zero(187, 3))), Rejected);
  CHECK_THROWS_AS(VertexRings(Points<Rational>(Points<Rational>::Zero(31, 4))), Rejected);
  VertexRings rings = VertexRings::around(star, 0);
  CHECK_THROWS_AS(rings.nets(0), Rejected);
  CHECK_THROWS_AS(rings.nets(largest_ring_level + 1), Rejected);
  CHECK_THROWS_AS(rings.closes_at(-1), Rejected);
  CHECK_THROWS_AS(ring_constants(2), Error);
  CHECK_THROWS_AS(ring_constants(largest_ring_valence + 1), Error);
}

TEST_SUITE_END();
