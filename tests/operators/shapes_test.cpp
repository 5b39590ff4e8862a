// The simple shapes: regular, oriented outward, tagged in turn.
#include "operators/shapes.h"

#include <doctest/doctest.h>

#include <cmath>

#include "operators/topology.h"
#include "tests/oracle/refusal.h"
#include "tests/oracle/words.h"

using namespace udcp;
using namespace udcp::oracle;

namespace {

// Six times the volume, from fans of triangles.
template <class S>
S volume(const Surface<S>& surface) {
  S sum(0);
  const auto& p = surface.points;
  for (int f = 0; f < surface.mesh->faces(); ++f) {
    const auto c = surface.mesh->corners(f);
    for (std::size_t k = 1; k + 1 < c.size(); ++k) {
      const int i = c[0], j = c[k], l = c[k + 1];
      sum += p(i, 0) * (p(j, 1) * p(l, 2) - p(j, 2) * p(l, 1)) + p(i, 1) * (p(j, 2) * p(l, 0) - p(j, 0) * p(l, 2)) +
             p(i, 2) * (p(j, 0) * p(l, 1) - p(j, 1) * p(l, 0));
    }
  }
  return sum;
}

int euler(const Mesh& mesh) { return mesh.vertices() - mesh.edges() + mesh.faces(); }

bool is_closed(const Mesh& mesh) { return std::count(mesh.twin.begin(), mesh.twin.end(), -1) == 0; }

template <class S>
S squared_edge(const Surface<S>& surface, int e) {
  const int h = surface.mesh->edge_half[Mesh::i(e)], a = surface.mesh->vertex[Mesh::i(h)], b = surface.mesh->tip(h);
  S sum(0);
  for (Eigen::Index c = 0; c < 3; ++c)
    sum += (surface.points(a, c) - surface.points(b, c)) * (surface.points(a, c) - surface.points(b, c));
  return sum;
}

template <class S>
bool has_equal_edges(const Surface<S>& surface) {
  bool equal = true;
  for (int e = 1; e < surface.mesh->edges(); ++e) equal &= squared_edge(surface, e) == squared_edge(surface, 0);
  return equal;
}

}  // namespace

TEST_SUITE("operators") {
  TEST_CASE_TEMPLATE("the regular solids have equal edges and the volume of the textbooks", S, double, Rational, Algebraic) {
    const auto box = cube<S>(), four = tetrahedron<S>(), eight = octahedron<S>();
    CHECK(has_equal_edges(box));
    CHECK(has_equal_edges(four));
    CHECK(has_equal_edges(eight));
    CHECK(volume(box) == S(48));
    CHECK(volume(four) == S(16));  // edge 2 sqrt(2): 8/3
    CHECK(volume(eight) == S(8));
    for (const auto& solid : {box, four, eight}) {
      CHECK(is_closed(*solid.mesh));
      CHECK(euler(*solid.mesh) == 2);
    }
  }

  TEST_CASE("the icosahedron is exactly regular") {
    const auto solid = icosahedron<Algebraic>();
    CHECK(has_equal_edges(solid));
    CHECK(squared_edge(solid, 0) == Algebraic(4));
    const Algebraic golden = Algebraic(2) * cosine<Algebraic>(ratio(1, 5));
    CHECK(golden * golden == golden + Algebraic(1));
    CHECK(volume(solid) == Algebraic(40) * golden * golden);  // the volume 5 (3 + sqrt 5)/12 a^3 with a = 2, six times
    CHECK(is_closed(*solid.mesh));
    CHECK(euler(*solid.mesh) == 2);
    for (int v = 0; v < 12; ++v) CHECK(solid.mesh->valence(v) == 5);
  }

  TEST_CASE("polygons are regular and start on the first axis") {
    for (const int n : {3, 4, 5, 6, 12}) {
      CAPTURE(n);
      const auto curve = polygon<Algebraic>(n, Algebraic(2));
      CHECK(curve.closed);
      CHECK(curve.points(0, 0) == Algebraic(2));
      CHECK(curve.points(0, 1) == Algebraic(0));
      for (int i = 0; i < n; ++i) {
        const int j = (i + 1) % n;
        const auto dot = [&](int a, int b) -> Algebraic {
          return curve.points(a, 0) * curve.points(b, 0) + curve.points(a, 1) * curve.points(b, 1);
        };
        CHECK(dot(i, i) == Algebraic(4));
        CHECK(dot(i, j) == Algebraic(4) * cosine<Algebraic>(ratio(2, n)));
        CHECK((curve.points(i, 0) * curve.points(j, 1) - curve.points(i, 1) * curve.points(j, 0)).sign() > 0);
      }
    }
  }

  TEST_CASE("a grid is flat and unit and faces upward") {
    const auto shape = grid<Rational>(3, 2);
    CHECK(shape.mesh->vertices() == 12);
    CHECK(euler(*shape.mesh) == 1);
    CHECK(has_equal_edges(shape));
    for (int f = 0; f < shape.mesh->faces(); ++f) {
      const auto c = shape.mesh->corners(f);
      const auto at = [&](std::size_t k, Eigen::Index x) { return shape.points(c[k], x); };
      CHECK((at(1, 0) - at(0, 0)) * (at(2, 1) - at(0, 1)) - (at(1, 1) - at(0, 1)) * (at(2, 0) - at(0, 0)) == Rational(1));
    }
    CHECK(shape.points(5, 0) == Rational(1));
    CHECK(shape.points(5, 1) == Rational(1));
  }

  TEST_CASE("tubes and tori are tagged in turn and outward") {
    const auto ring = torus<Algebraic>(6, 4, 3, 1);
    CHECK(is_closed(*ring.mesh));
    CHECK(euler(*ring.mesh) == 0);
    CHECK(volume(ring).sign() > 0);
    for (int f = 0; f < ring.mesh->faces(); ++f) CHECK(is_alternately_tagged(*ring.mesh, ring.tags, f));
    for (Eigen::Index v = 0; v < ring.points.rows(); ++v) {
      const Algebraic axis = ring.points(v, 0) * ring.points(v, 0) + ring.points(v, 1) * ring.points(v, 1);
      const Algebraic sum = axis + ring.points(v, 2) * ring.points(v, 2) + Algebraic(8);
      CHECK(sum * sum == Algebraic(36) * axis);
    }
    Points<Algebraic> profile(2, 2);
    profile << Algebraic(2), Algebraic(0), Algebraic(1), Algebraic(5);
    const auto open = tube<Algebraic>(5, profile);
    CHECK(euler(*open.mesh) == 0);
    for (int e = 0; e < open.mesh->edges(); ++e) {
      const int h = open.mesh->edge_half[Mesh::i(e)], a = open.mesh->vertex[Mesh::i(h)], b = open.mesh->tip(h);
      CHECK((open.points(a, 2) == open.points(b, 2)) == (open.tags.of_edge(e) == EdgeTag::latitude));
    }
  }

  TEST_CASE("triangulating cuts faces into fans and keeps what belongs to vertices") {
    auto box = cube<Rational>();
    box.tags.corner.assign(8, 0);
    box.tags.corner[3] = 1;
    box.tags.edge.assign(12, EdgeTag::latitude);
    box.attributes["w"] = std::vector<Rational>(8, Rational(2));
    const auto cut = triangulate(box);
    CHECK(cut.mesh->faces() == 12);
    CHECK(cut.mesh->all_faces_have(3));
    CHECK(volume(cut) == volume(box));
    CHECK(cut.tags.corner == box.tags.corner);
    CHECK(cut.tags.edge.empty());
    CHECK(cut.attributes == box.attributes);
    CHECK(cut.points == box.points);
  }

  TEST_CASE("shapes that cannot be say so") {
    CHECK(refusal([] { polygon<double>(2); }) == "E_SHAPE: a polygon has at least 3 corners and at most 100000000, not 2");
    CHECK(refusal([] { grid<double>(0, 4); }) == "E_SHAPE: a grid has at least 1 by 1 faces and at most 100000000");
    CHECK(refusal([] { torus<double>(4, 2, 3, 1); }) == "E_SHAPE: a torus needs at least 3 points in each direction");
    CHECK(refusal([] { torus<double>(2, 4, 3, 1); }) ==
          "E_SHAPE: a tube needs at least 3 points round and 2 rings (3 if closed)");
    CHECK(refusal([] { tube<double>(4, Points<double>::Ones(3, 3)); }) ==
          "E_SHAPE: a profile has two columns, radius and height");
    CHECK(refusal([] { polygon<Rational>(5); }).starts_with("E_NOT_EXACT"));
    CHECK(refusal([] { polygon<Rational>(4); }) == "accepted");
  }
}
