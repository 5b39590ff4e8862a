// Words on triangles: Loop against the textbook, the ten-point butterfly stencil, and the convolution with a kernel.
#include <doctest/doctest.h>

#include "operators/run.h"
#include "tests/oracle/inputs.h"
#include "tests/oracle/loop.h"
#include "tests/oracle/schemes.h"
#include "tests/oracle/words.h"

using namespace udcp;
using namespace udcp::oracle;

TEST_SUITE("operators") {
  TEST_CASE("UCP on triangles with omega 0 and the delta of Loop is Loop") {
    Dice dice(51);
    for (const NamedMesh& named : triangle_meshes()) {
      CAPTURE(named.name);
      auto surface = random_surface<Algebraic>(dice, named.mesh);
      surface.tags = random_corners(dice, named.mesh, 3);
      const auto expected = loop_step(faces_of(named.mesh), surface.points, surface.tags.corner);
      const auto fine = run(loop(), surface, 1);
      CHECK(faces_of(*fine.mesh) == expected.faces);
      CHECK(fine.points == expected.points);
    }
  }

  TEST_CASE("two rounds of Loop with rational cosines") {
    Dice dice(52);
    const auto surface = random_surface<Rational>(dice, *octahedron<Rational>().mesh);
    auto expected = loop_step(faces_of(*surface.mesh), surface.points);
    expected = loop_step(expected.faces, expected.points);
    const auto fine = run(loop(), surface, 2);
    CHECK(fine.points == expected.points);
    CHECK(faces_of(*fine.mesh) == expected.faces);
  }

  TEST_CASE("UCP on triangles with all ones is the ten-point butterfly scheme") {
    // a regular piece: vertices of three rings, the edge from the centre to spoke 0
    const Mesh mesh = *ring_mesh(6, 3, true).mesh;
    const Surface<Rational> surface{std::make_shared<const Mesh>(mesh), Points<Rational>::Zero(mesh.vertices(), 1), {}, {}};
    const Points<Rational> matrix = subdivision_matrix<Rational>(on_triangles(scheme("UCP")), surface);
    for (int v = 0; v < mesh.vertices(); ++v) {
      Points<Rational> unit = Points<Rational>::Zero(1, mesh.vertices());
      unit(0, v) = Rational(1);
      if (!mesh.on_boundary(v)) CHECK(matrix.row(v) == unit.row(0));
    }
    const int e = [&] {
      for (int k = 0;; ++k) {
        const int h = mesh.edge_half[Mesh::i(k)];
        if (mesh.vertex[Mesh::i(h)] + mesh.tip(h) == 1) return k;  // between vertices 0 and 1
      }
    }();
    const int h = mesh.edge_half[Mesh::i(e)], twin = mesh.twin[Mesh::i(h)];
    Points<Rational> expected = Points<Rational>::Zero(1, mesh.vertices());
    for (const int end : {0, 1}) {
      for (int k = 0; k < mesh.half_edges(); ++k)
        if (mesh.vertex[Mesh::i(k)] == end) expected(0, mesh.tip(k)) = ratio(-1, 32);
    }
    for (const int side : {h, twin}) expected(0, mesh.tip(mesh.next(side))) = ratio(1, 16);
    expected(0, 0) = expected(0, 1) = ratio(17, 32);
    CHECK(expected.sum() == Rational(1));
    CHECK(matrix.row(mesh.vertices() + e) == expected.row(0));
  }

  TEST_CASE("C on triangles with a kernel weighs old vertices in the first C only") {
    Dice dice(53);
    for (int n = 3; n <= 7; ++n) {
      CAPTURE(n);
      const Rational f = dice.positive();
      const auto surface = random_surface<Rational>(dice, *ring_mesh(n, 2, true).mesh);
      const auto up_only = run(on_triangles(operation("U")), surface, 1);
      const auto first = run(on_triangles(operation("UC", constant(f))), surface, 1);
      const auto second = run(on_triangles(operation("UCC", constant(f))), surface, 1);
      const auto plain = run(on_triangles(operation("C")), first, 1);
      CHECK(second.points == plain.points);
      const Mesh& fine = *up_only.mesh;
      for (int v = 0; v < fine.vertices(); ++v) {
        if (fine.on_boundary(v)) continue;
        const auto weight = [&](int u) { return u < surface.mesh->vertices() ? f : Rational(1); };
        const Rational share = ratio(6, fine.valence(v));
        Rational total = Rational(2) * weight(v);
        Points<Rational> sum = total * up_only.points.row(v);
        for (int h = 0; h < fine.half_edges(); ++h) {
          if (fine.vertex[Mesh::i(h)] != v) continue;
          total += share * weight(fine.tip(h));
          sum.row(0) += share * weight(fine.tip(h)) * up_only.points.row(fine.tip(h));
        }
        const Points<Rational> expected = sum / total;
        CHECK(first.points.row(v) == expected.row(0));
      }
    }
  }

  TEST_CASE("inner points of U[3] on triangles get omega squared times barycentric weights") {
    Dice dice(54);
    const Rational omega = dice.fraction(), delta = dice.fraction();
    const auto surface = random_surface<Rational>(dice, make_mesh(3, Faces{{0, 1, 2}}));
    const auto smooth = run(on_triangles(operation("U3C")), surface, 1);
    const auto fine = run(on_triangles(operation("U3CP", nullptr, constant(omega), constant(delta))), surface, 1);
    Points<Rational> moved = surface.points;
    for (int v = 0; v < 3; ++v) moved.row(v) = delta * (surface.points.row(v) - smooth.points.row(v));
    const auto centre = static_cast<Eigen::Index>(9);  // 3 old points, 2 on each edge, 1 inside
    REQUIRE(fine.points.rows() == 10);
    const Points<Rational> inner =
        smooth.points.row(centre) + omega * omega * (moved.row(0) + moved.row(1) + moved.row(2)) / Rational(3);
    CHECK(fine.points.row(centre) == inner.row(0));
    for (int e = 0; e < 3; ++e)
      for (int s = 1; s < 3; ++s) {
        const Eigen::Index i = 3 + 2 * e + s - 1;
        const Points<Rational> point =
            smooth.points.row(i) + omega * (Rational(3 - s) * moved.row(e) + Rational(s) * moved.row((e + 1) % 3)) / Rational(3);
        CHECK(fine.points.row(i) == point.row(0));
      }
  }
}
