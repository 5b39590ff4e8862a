// Atoms on meshes: boundaries are curve words, corners, U[d] and P on quads, errors of geometry.
#include <doctest/doctest.h>

#include "operators/atoms.h"
#include "operators/run.h"
#include "tests/oracle/inputs.h"
#include "tests/oracle/refusal.h"
#include "tests/oracle/words.h"

using namespace udcp;
using namespace udcp::oracle;

namespace {

// Vertices along the boundary from `start` on.
std::vector<int> boundary_from(const Mesh& mesh, int start) {
  std::vector<int> result;
  int v = start;
  do {
    result.push_back(v);
    v = mesh.tip(mesh.outgoing[Mesh::i(v)]);
  } while (v != start);
  return result;
}

Polyline<Rational> boundary_curve(const Surface<Rational>& surface, const std::vector<int>& vertices) {
  Polyline<Rational> curve{Points<Rational>(static_cast<Eigen::Index>(vertices.size()), surface.points.cols()), true, {}, {}};
  for (std::size_t k = 0; k < vertices.size(); ++k) {
    curve.points.row(static_cast<Eigen::Index>(k)) = surface.points.row(vertices[k]);
    curve.corner.push_back(surface.tags.is_corner(vertices[k]) ? 1 : 0);
  }
  return curve;
}

// f per vertex, for the vertices below `old`.
template <class S>
KernelWeights<S> random_weights(Dice& dice, const Mesh& mesh, int old) {
  KernelWeights<S> weights;
  weights.origin = {old, mesh.vertices() - old};
  weights.f = Directional<Parameter<S>>::all({{}, nullptr});
  for (int v = 0; v < mesh.vertices(); ++v) weights.f.plain.values.push_back(number<S>(dice.positive()));
  return weights;
}

int first_boundary_vertex(const Mesh& mesh) {
  int v = 0;
  while (!mesh.on_boundary(v)) ++v;
  return v;
}

}  // namespace

TEST_SUITE("operators") {
  TEST_CASE("boundaries of meshes are exactly curves under the same word") {
    Dice dice(121);
    for (const char* atoms : {"UDD", "UDDDD", "UCP", "U3CP", "UD", "UDDD"}) {
      for (int trial = 0; trial < 6; ++trial) {
        CAPTURE(atoms);
        CAPTURE(trial);
        Surface<Rational> surface = random_surface<Rational>(dice, random_mesh(dice, atoms[1] == '3'));
        surface.tags = random_corners(dice, *surface.mesh, 4);
        const Word word = scheme(atoms, constant(dice.positive()), constant(dice.fraction()), constant(dice.fraction()));
        const Surface<Rational> fine = run(word, surface, 1);
        const int v = first_boundary_vertex(*surface.mesh);
        const auto expected = run(word, boundary_curve(surface, boundary_from(*surface.mesh, v)), 1);
        // find where the curve starts among the points of the fine boundary
        int start = -1;
        for (int u = 0; u < fine.mesh->vertices() && start < 0; ++u)
          if (fine.mesh->on_boundary(u) && fine.points.row(u) == expected.points.row(0)) start = u;
        REQUIRE(start >= 0);
        const auto found = boundary_curve(fine, boundary_from(*fine.mesh, start));
        CHECK(found.points == expected.points);
        CHECK(found.corner == expected.corner);
      }
    }
  }

  TEST_CASE("boundaries of triangle meshes are curves too") {
    Dice dice(122);
    for (const NamedMesh& named : triangle_meshes()) {
      if (std::count(named.mesh.twin.begin(), named.mesh.twin.end(), -1) == 0) continue;
      for (const char* atoms : {"UCP", "UCCP", "U3C"}) {
        CAPTURE(named.name);
        CAPTURE(atoms);
        Surface<Rational> surface = random_surface<Rational>(dice, named.mesh);
        surface.tags = random_corners(dice, named.mesh, 4);
        Word word = scheme(atoms, constant(dice.positive()), constant(dice.fraction()), constant(dice.fraction()));
        const int v = first_boundary_vertex(named.mesh);
        const auto expected = run(word, boundary_curve(surface, boundary_from(named.mesh, v)), 1);
        const auto fine = run(on_triangles(word), surface, 1);
        CHECK(boundary_curve(fine, boundary_from(*fine.mesh, v)).points == expected.points);
      }
    }
  }

  TEST_CASE_TEMPLATE("C is D then D to the last bit", S, double, Rational) {
    Dice dice(122);
    for (int trial = 0; trial < 40; ++trial) {
      CAPTURE(trial);
      const Mesh mesh = trial % 4 == 0 ? dodecahedron() : random_mesh(dice);
      Surface<S> surface = random_surface<S>(dice, mesh, 1 + trial % 5);
      if (trial % 3 != 0) surface.tags = random_corners(dice, mesh, 3);
      const KernelWeights<S> weights = random_weights<S>(dice, mesh, mesh.vertices() / 2);
      for (const KernelWeights<S>* w : {static_cast<const KernelWeights<S>*>(nullptr), &weights})
        CHECK(convolve(surface, w) == to_primal(surface, to_dual(surface, w)));
    }
  }

  TEST_CASE("C on triangles with a weight per vertex that is 1 everywhere is C without weights") {
    Dice dice(123);
    for (const NamedMesh& shape : triangle_meshes()) {
      CAPTURE(shape.name);
      const auto surface = random_surface<Rational>(dice, shape.mesh);
      KernelWeights<Rational> ones = random_weights<Rational>(dice, shape.mesh, shape.mesh.vertices());
      for (Rational& f : ones.f.plain.values) f = Rational(1);
      CHECK(convolve_triangles(surface, &ones) == convolve_triangles<Rational>(surface, nullptr));
    }
  }

  TEST_CASE("three columns come out as each of them alone to the last bit") {
    Dice dice(124);
    const auto check = [&](const Word& word, const Mesh& mesh) {
      const auto surface = random_surface<double>(dice, mesh);
      const Points<double> together = run(word, surface, 2).points;
      for (int c = 0; c < 3; ++c) {
        Surface<double> alone = surface;
        alone.points = surface.points.col(c);
        CHECK(run(word, alone, 2).points == together.col(c));
      }
    };
    const KernelPtr third = constant(ratio(1, 3));
    for (const char* atoms : {"UCP", "UCCP", "UDDD", "U3CP"}) {
      CAPTURE(atoms);
      check(scheme(atoms, third, third, third), *grid<Rational>(3, 2).mesh);
      if (atoms[1] != '3') check(scheme(atoms, third, third, third), prism(5));
    }
    for (const auto& [name, mesh] : triangle_meshes()) check(on_triangles(scheme("UCCP", third, third, third)), mesh);
  }

  TEST_CASE("a corner inside stays under words of even D and moves nothing else") {
    Dice dice(123);
    Surface<Rational> plain = random_surface<Rational>(dice, *cube<Rational>().mesh), tagged = plain;
    tagged.tags.corner.assign(8, 0);
    tagged.tags.corner[3] = 1;
    const auto a = run(scheme("UC"), plain, 1).points, b = run(scheme("UC"), tagged, 1).points;
    CHECK(b.row(3) == tagged.points.row(3));
    for (Eigen::Index v = 0; v < a.rows(); ++v)
      if (v != 3) CHECK(a.row(v) == b.row(v));
    CHECK(run(scheme("UCP"), tagged, 2).points.row(3) == tagged.points.row(3));
  }

  TEST_CASE("U[3] is bilinear and P spreads by the same weights") {
    Dice dice(124);
    const Rational omega = dice.fraction(), delta = dice.fraction();
    const auto surface = random_surface<Rational>(dice, make_mesh(4, Faces{{0, 1, 2, 3}}));
    const auto bilinear = [](const Points<Rational>& p, int x, int y) {
      const Rational u = ratio(x, 3), v = ratio(y, 3), one(1);
      return Points<Rational>((one - u) * (one - v) * p.row(0) + u * (one - v) * p.row(1) + u * v * p.row(2) +
                              (one - u) * v * p.row(3));
    };
    const auto up = run(operation("U3"), surface, 1).points, smooth = run(operation("U3C"), surface, 1).points;
    const auto fine = run(operation("U3CP", nullptr, constant(omega), constant(delta)), surface, 1).points;
    const Points<Rational> difference = delta * (surface.points - smooth.topRows(4));
    const auto check = [&](int i, int x, int y, const Rational& weight) {
      CHECK(up.row(i) == bilinear(surface.points, x, y).row(0));
      const Points<Rational> moved = smooth.row(i) + weight * bilinear(difference, x, y);
      CHECK(fine.row(i) == moved.row(0));
    };
    const std::pair<int, int> along[] = {{1, 0}, {2, 0}, {3, 1}, {3, 2}, {2, 3}, {1, 3}, {0, 2}, {0, 1}};
    for (int k = 0; k < 8; ++k) check(4 + k, along[k].first, along[k].second, omega);
    for (int y = 1; y < 3; ++y)
      for (int x = 1; x < 3; ++x) check(12 + 2 * (y - 1) + x - 1, x, y, omega * omega);
  }

  TEST_CASE("N is the valence inside and regular on boundaries and at new points") {
    Dice dice(125);
    const KernelPtr by_valence =
        formula([](const auto& c) { return std::decay_t<decltype(c.alpha)>(c.valence); }, {true, false, false});
    const auto surface = random_surface<Rational>(dice, *ring_mesh(5, 1).mesh);
    const auto smooth = run(operation("UC"), surface, 1).points;
    const auto fine = run(operation("UCP", nullptr, by_valence, by_valence), surface, 1).points;
    const Mesh& mesh = *surface.mesh;
    const auto difference = [&](int v) {
      return Points<Rational>(Rational(mesh.on_boundary(v) ? 4 : mesh.valence(v)) * (surface.points.row(v) - smooth.row(v)));
    };
    CHECK(fine.row(0) == (smooth.row(0) + difference(0).row(0)).eval());
    for (int e = 0; e < mesh.edges(); ++e) {
      const int h = mesh.edge_half[Mesh::i(e)], i = mesh.vertices() + e;
      const Points<Rational> expected =
          smooth.row(i) + Rational(4) / Rational(2) * (difference(mesh.vertex[Mesh::i(h)]) + difference(mesh.tip(h)));
      CHECK(fine.row(i) == expected.row(0));
    }
    // f = N: V of valence 5 weighs 25, the edge points 4 each, the centre of the old face 1
    const auto up = run(operation("U"), surface, 1), dual = run(operation("UD", by_valence), surface, 1);
    for (int f = 0; f < up.mesh->faces(); ++f) {
      const auto c = up.mesh->corners(f);
      if (c[0] != 0) continue;
      const Points<Rational> expected =
          (Rational(25) * up.points.row(0) + Rational(4) * (up.points.row(c[1]) + up.points.row(c[3])) + up.points.row(c[2])) /
          Rational(34);
      CHECK(dual.points.row(f) == expected.row(0));
    }
  }

  TEST_CASE("interior vertices and edges of a plane grid stay where linear precision wants them") {
    for (const char* atoms : {"UCP", "UCCP", "UDDDDP"}) {
      CAPTURE(atoms);
      const auto surface = grid<Rational>(6, 6);
      const auto fine = run(scheme(atoms, nullptr, value(7, 3), value(-2, 5)), surface, 1).points;
      for (const int v : {24, 23, 25, 17, 31}) CHECK(fine.row(v) == surface.points.row(v));  // the middle and its neighbours
    }
  }

  TEST_CASE("errors of geometry name the face or vertex") {
    Surface<Rational> pillow{
        std::make_shared<const Mesh>(make_mesh(3, Faces{{0, 1, 2}, {2, 1, 0}})), Points<Rational>::Ones(3, 3), {}, {}};
    CHECK(refusal([&] { run(scheme("UD"), pillow, 1); }) ==
          "E_VALENCE2: vertex 0 lies inside and has valence 2, so its face in the dual mesh would have two corners");
    CHECK(refusal([&] { run(scheme("UDD"), pillow, 2); }) == "accepted");
    auto tagged = cube<Rational>();
    tagged.tags.corner.assign(8, 0);
    tagged.tags.corner[2] = 1;
    CHECK(refusal([&] { run(scheme("UD"), tagged, 1); }) ==
          "E_CORNER: vertex 2 is a corner inside the mesh; a dual mesh has corners on its boundary only");
    CHECK(refusal([] { run(scheme("UC", value(-1)), cube<Rational>(), 1); }) ==
          "E_WEIGHT: the weights of D at face 0 sum to 0, so they have no average");
    CHECK(refusal([] { run(scheme("UC", value(-1)), cube<double>(), 1); }).starts_with("E_WEIGHT"));
    CHECK(refusal([] { run(on_triangles(scheme("UC", value(-3))), octahedron<Rational>(), 1); }) ==
          "E_WEIGHT: the weights of C at vertex 0 sum to 0, so they have no average");
    Word classic = scheme("UC", value(-1));
    classic.tail[1].ngon = Ngon::classic;
    CHECK(refusal([&] { run(classic, tetrahedron<Rational>(), 1); }).starts_with("E_WEIGHT"));
    CHECK(refusal([] { run(scheme("U3C"), tetrahedron<Rational>(), 1); }) ==
          "E_USPLIT: U[3] splits quads only, and the mesh has other faces");
    CHECK(refusal([] { run(scheme("UD"), cube<Rational>(), 1); }) == "accepted");
    // faces of a dual are found out when they are split
    CHECK(refusal([] { run(operation("UDU3"), cube<Rational>(), 1); }) ==
          "E_USPLIT: face 0 has 3 corners; U[3] splits quads only");
    CHECK(refusal([] { run(on_triangles(scheme("UC")), cube<Rational>(), 1); }) ==
          "E_NOT_TRIANGLES: a word `on triangles` needs a mesh of triangles");
  }
}
