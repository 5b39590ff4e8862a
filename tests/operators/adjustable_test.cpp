// Adjustable Catmull-Clark: the word against its definition and reference values, its closed forms against the word, and hybrid
// patches.
#include "operators/methods/filling/adjustable.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "operators/atoms.h"
#include "operators/limit.h"
#include "operators/matrix.h"
#include "operators/schemes.h"
#include "tests/operators/fill_golden.h"
#include "tests/oracle/adjustable.h"
#include "tests/oracle/inputs.h"
#include "tests/oracle/refusal.h"

using namespace udcp;
using namespace udcp::oracle;

namespace {

Rational exact(const Json& text) { return Rational::parse(text.get<std::string>()); }
Points<Rational> rows(const Json& list) {
  Points<Rational> result(static_cast<Eigen::Index>(list.size()), static_cast<Eigen::Index>(list[0].size()));
  for (Eigen::Index i = 0; i < result.rows(); ++i)
    for (Eigen::Index j = 0; j < result.cols(); ++j)
      result(i, j) = exact(list[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)]);
  return result;
}

const std::vector<Rational>& some_parameters() {
  static const std::vector<Rational> list{Rational(0), Rational(1) / Rational(4), Rational(1) / Rational(2),
                                          Rational(2) / Rational(3), Rational(1)};
  return list;
}

std::vector<Rational> constant_column(const Mesh& mesh, const Rational& c) {
  return std::vector<Rational>(Mesh::i(mesh.vertices()), c);
}

void compare(const Surface<Rational>& fine, const Adjusted<Rational>& expected) {
  CHECK(faces_of(*fine.mesh) == expected.faces);
  CHECK(fine.points == expected.points);
}

/// The map of one step on one ring around a vertex, which the inner rules make alone.
Points<double> one_ring_step(double c, int n) {
  const Surface<double> ring = ring_mesh(n, 1);
  const Word word = schemes::adjustable(Rational::from_double(c));
  const Points<double> all = subdivision_matrix<double>(word, ring);
  const Mesh fine = *run(word, ring, 1).mesh;
  Points<double> result(2 * n + 1, 2 * n + 1);
  result.row(0) = all.row(0);
  int spoke = ring.mesh->outgoing[0], h = fine.outgoing[0];
  while (ring.mesh->tip(spoke) != 1) spoke = ring.mesh->around(spoke);
  while (fine.tip(h) != 2 * n + 1 + ring.mesh->edge[Mesh::i(spoke)]) h = fine.around(h);
  for (int i = 0; i < n; ++i, h = fine.around(h)) {
    result.row(1 + 2 * i) = all.row(fine.tip(h));
    result.row(2 + 2 * i) = all.row(fine.tip(fine.next(h)));
  }
  return result;
}

}  // namespace

TEST_SUITE("operators") {
  TEST_CASE("the adjustable word is its definition on every polygon mesh") {
    Dice dice(61);
    for (const auto& meshes : {quad_meshes(), polygon_meshes()}) {
      for (const NamedMesh& named : meshes) {
        for (const Rational& c : some_parameters()) {
          CAPTURE(named.name);
          CAPTURE(c);
          const auto surface = with_corners(random_surface<Rational>(dice, named.mesh));
          compare(run(schemes::adjustable(c), surface, 1),
                  adjustable_step<Rational>({faces_of(named.mesh), surface.points, constant_column(named.mesh, c)}));
        }
      }
    }
    for (int trial = 0; trial < 20; ++trial) {
      CAPTURE(trial);
      const Mesh mesh = random_mesh(dice);
      const auto surface = with_corners(random_surface<Rational>(dice, mesh));
      const Rational c = Rational(dice.between(0, 9)) / Rational(9);
      compare(run(schemes::adjustable(c), surface, 1),
              adjustable_step<Rational>({faces_of(mesh), surface.points, constant_column(mesh, c)}));
    }
  }

  TEST_CASE("hybrid steps are their definition with a parameter per vertex and hand the parameters on") {
    Dice dice(62);
    for (int trial = 0; trial < 30; ++trial) {
      CAPTURE(trial);
      const Mesh mesh = trial < 20 ? random_mesh(dice) : polygon_meshes()[static_cast<std::size_t>(trial % 7)].mesh;
      auto surface = with_corners(random_surface<Rational>(dice, mesh));
      std::vector<Rational> c;
      for (int v = 0; v < mesh.vertices(); ++v) c.push_back(Rational(dice.between(0, 8)) / Rational(8));
      surface.attributes["c"] = c;
      Adjusted<Rational> expected{faces_of(mesh), surface.points, c};
      for (int round = 0; round < 2; ++round) {
        surface = hybrid_step(surface);
        expected = adjustable_step(expected);
        compare(surface, expected);
        CHECK(surface.attributes.at("c") == expected.c);
      }
    }
  }

  TEST_CASE("hybrid steps with one parameter everywhere are the word with it") {
    Dice dice(63);
    for (const Rational& c : some_parameters()) {
      CAPTURE(c);
      auto surface = random_surface<Rational>(dice, dodecahedron());
      surface.attributes["c"] = constant_column(*surface.mesh, c);
      CHECK(hybrid_step(surface).points == run(schemes::adjustable(c), surface, 1).points);
    }
  }

  TEST_CASE("the word with c = 1/2 is Catmull-Clark and with c = 0 bilinear") {
    Dice dice(64);
    for (const NamedMesh& named : polygon_meshes()) {
      const auto surface = random_surface<Rational>(dice, named.mesh);
      CHECK(run(schemes::adjustable(Rational(1) / Rational(2)), surface, 2).points ==
            run(schemes::catmull_clark(), surface, 2).points);
      CHECK(run(schemes::adjustable(Rational(0)), surface, 1).points == up(surface).points);
    }
  }

  TEST_CASE("the reference values of adjustable Catmull-Clark are met exactly") {
    Surface<Rational> cube;
    std::vector<std::vector<int>> faces;
    for (const Json& face : golden()["cube_input"]["faces"]) faces.push_back(face.get<std::vector<int>>());
    cube.points = rows(golden()["cube_input"]["vertices"]);
    cube.mesh = std::make_shared<const Mesh>(make_mesh(8, faces));
    for (const Json& set : golden()["adjustable"]) {
      const Rational c = exact(set["c"]);
      CAPTURE(c);
      const Word word = schemes::adjustable(c);
      CHECK(segment_matrix<Rational>(c) == rows(set["C_matrix"]));
      const Polyline<Rational> polygon{rows(set["closed_polygon"]["input"]), true, {}, {}};
      CHECK(run(word, polygon, 2).points == rows(set["closed_polygon"]["after_2_steps"]));
      CHECK(run(word, cube, 1).points == rows(set["cube"]["step1_vertex_edge_face"]));
      CHECK(run(word, cube, 2).points.topRows(26) == rows(set["cube"]["step2_first_26"]));
      for (const auto& [text, expected] : set["valence"].items()) {
        const int n = std::stoi(text);
        CAPTURE(n);
        const AdjustableLimit<Rational> limit = adjustable_limit<Rational>(c, n);
        CHECK(limit.vertex == exact(expected["limit_v"]));
        CHECK(limit.edge == exact(expected["limit_edge_each"]));
        CHECK(limit.diagonal == exact(expected["limit_face_each"]));
        const double x = c.to_double();
        CHECK(adjustable_eigenvalue(x, n, 1) == doctest::Approx(expected["lambda1"].get<double>()).epsilon(1e-14));
        CHECK(adjustable_cup_eigenvalue(x, n) == doctest::Approx(expected["mu0"].get<double>()).epsilon(1e-14));
        const double diagonal = expected["tangent_kappa"].get<double>() * (1 + std::cos(2 * std::numbers::pi / n));
        CHECK(adjustable_tangents(x, n)[0].diagonal[0] == doctest::Approx(diagonal).epsilon(1e-14));
      }
    }
  }

  TEST_CASE("the reference values of hybrid patches and steps are met exactly") {
    const Json& hybrid = golden()["hybrid"];
    std::array<Rational, 4> corner;
    for (std::size_t k = 0; k < 4; ++k) corner[k] = exact(hybrid["corner_c_row_major"][k]);
    CHECK(hybrid_patch(rows(hybrid["patch_net_row_major"]), corner) == rows(hybrid["bezier_row_major"]));
    std::vector<std::vector<int>> faces;
    for (const Json& face : golden()["cube_input"]["faces"]) faces.push_back(face.get<std::vector<int>>());
    Surface<Rational> cube{std::make_shared<const Mesh>(make_mesh(8, faces)), rows(golden()["cube_input"]["vertices"]), {}, {}};
    for (const Json& c : hybrid["cube_vertex_c"]) cube.attributes["c"].push_back(exact(c));
    const Surface<Rational> fine = hybrid_step(cube);
    CHECK(fine.points == rows(hybrid["cube_step1"]));
    std::vector<Rational> expected;
    for (const Json& c : hybrid["cube_step1_c"]) expected.push_back(exact(c));
    CHECK(fine.attributes.at("c") == expected);
  }

  TEST_CASE("closed forms of limits and eigenvalues belong to the matrix that the word makes") {
    for (const double c : {0.25, 0.5, 0.8125, 1.0}) {
      for (int n = 3; n <= 9; ++n) {
        CAPTURE(c);
        CAPTURE(n);
        const Points<double> step = one_ring_step(c, n);
        Eigen::RowVectorXd limit(2 * n + 1);
        const AdjustableLimit<double> weights = adjustable_limit<double>(c, n);
        limit[0] = weights.vertex;
        for (int i = 0; i < n; ++i) limit[1 + 2 * i] = weights.edge, limit[2 + 2 * i] = weights.diagonal;
        CHECK(std::abs(limit.sum() - 1) <= 1e-14);
        CHECK((limit * step - limit).cwiseAbs().maxCoeff() <= 1e-14);
        const double lambda = adjustable_eigenvalue(c, n, 1);
        for (const AdjustableTangent& tangent : adjustable_tangents(c, n)) {
          Eigen::RowVectorXd row = Eigen::RowVectorXd::Zero(2 * n + 1);
          for (int i = 0; i < n; ++i) row[1 + 2 * i] = tangent.edge[Mesh::i(i)], row[2 + 2 * i] = tangent.diagonal[Mesh::i(i)];
          CHECK((row * step - lambda * row).cwiseAbs().maxCoeff() <= 1e-14 * row.cwiseAbs().sum());
        }
        // Frequency k: the 2x2 block of the matrix has the trace and determinant of the closed form.
        for (int k = 1; k <= n / 2; ++k) {
          Eigen::Matrix2cd block = Eigen::Matrix2cd::Zero();
          for (int a = 0; a < 2; ++a)
            for (int b = 0; b < 2; ++b)
              for (int s = 0; s < n; ++s)
                block(a, b) += step(1 + a, 1 + 2 * s + b) * std::polar(1.0, 2 * std::numbers::pi * k * s / n);
          const double larger = adjustable_eigenvalue(c, n, k), smaller = adjustable_eigenvalue(c, n, k, false);
          CHECK(std::abs(block(0, 0) + block(1, 1) - (larger + smaller)) <= 1e-14);
          CHECK(std::abs(block(0, 0) * block(1, 1) - block(0, 1) * block(1, 0) - larger * smaller) <= 1e-14);
          CHECK(larger >= smaller);
        }
        // Frequency 0: with the eigenvalue 1 removed, trace and determinant of the 3x3 block.
        Eigen::Matrix3d cup = Eigen::Matrix3d::Zero();
        for (int a = 0; a < 3; ++a) {
          cup(a, 0) = step(a, 0);
          for (int s = 0; s < n; ++s) cup(a, 1) += step(a, 1 + 2 * s), cup(a, 2) += step(a, 2 + 2 * s);
        }
        const double mu = adjustable_cup_eigenvalue(c, n), trace = cup(0, 0) + cup(1, 1) + cup(2, 2) - 1;
        // the characteristic polynomial of the block is (x - 1)(x^2 - trace x + product)
        const double minors = cup(0, 0) * cup(1, 1) - cup(0, 1) * cup(1, 0) + cup(0, 0) * cup(2, 2) - cup(0, 2) * cup(2, 0) +
                              cup(1, 1) * cup(2, 2) - cup(1, 2) * cup(2, 1);
        CHECK(std::abs(mu * mu - trace * mu + (minors - trace)) <= 1e-14);
        CHECK(mu >= trace / 2 - 1e-15);
      }
    }
  }

  TEST_CASE("tangents and limit points of the closed forms are those of the limit surface") {
    Dice dice(65);
    for (const double c : {0.25, 0.75}) {
      for (const int n : {3, 5, 8}) {
        CAPTURE(n);
        Surface<double> ring = ring_mesh(n, 2);
        for (Eigen::Index i = 0; i < ring.points.rows(); ++i) ring.points(i, 2) = dice.fraction().to_double() / 40;
        const Limit limits = limit(schemes::adjustable(Rational::from_double(c)), ring);
        const AdjustableLimit<double> weights = adjustable_limit<double>(c, n);
        Eigen::RowVector3d point = weights.vertex * ring.points.row(0);
        std::array<Eigen::RowVector3d, 2> direction{Eigen::RowVector3d::Zero(), Eigen::RowVector3d::Zero()};
        const auto tangents = adjustable_tangents(c, n);
        for (int i = 0; i < n; ++i) {
          point += weights.edge * ring.points.row(1 + 2 * i) + weights.diagonal * ring.points.row(2 + 2 * i);
          for (std::size_t k = 0; k < 2; ++k)
            direction[k] += tangents[k].edge[Mesh::i(i)] * ring.points.row(1 + 2 * i) +
                            tangents[k].diagonal[Mesh::i(i)] * ring.points.row(2 + 2 * i);
        }
        CHECK((point - limits.points.row(0)).norm() <= 1e-13);
        const Eigen::RowVector3d normal = limits.normals.row(0);
        for (const auto& d : direction) CHECK(std::abs(d.dot(normal)) <= 1e-12 * d.norm());
        const Eigen::Vector3d up(direction[0][1] * direction[1][2] - direction[0][2] * direction[1][1],
                                 direction[0][2] * direction[1][0] - direction[0][0] * direction[1][2],
                                 direction[0][0] * direction[1][1] - direction[0][1] * direction[1][0]);
        CHECK(normal.dot(up) > 0);
      }
    }
  }

  TEST_CASE("segments are C1 for every c and C2 for c = 1/2 only") {
    for (int k = 1; k <= 12; ++k) {
      const Rational c = Rational(k) / Rational(12);
      CAPTURE(c);
      for (const TangentFactor factor : {TangentFactor::paper, TangentFactor::limit}) {
        const Points<Rational> m = segment_matrix<Rational>(c, factor);
        // Values, derivatives and second derivatives at the end of p0..p3 and at the start of p1..p4, on p0..p4.
        Points<Rational> jump = Points<Rational>::Zero(3, 5);
        for (int j = 0; j < 4; ++j) {
          jump(0, j) += m(0, j) + m(1, j) + m(2, j) + m(3, j);
          jump(1, j) += m(1, j) + Rational(2) * m(2, j) + Rational(3) * m(3, j);
          jump(2, j) += Rational(2) * m(2, j) + Rational(6) * m(3, j);
          jump(0, j + 1) -= m(0, j);
          jump(1, j + 1) -= m(1, j);
          jump(2, j + 1) -= Rational(2) * m(2, j);
        }
        CHECK(jump.topRows(2) == Points<Rational>::Zero(2, 5));
        if (factor == TangentFactor::limit) continue;
        const Rational scale = (Rational(2) * c - Rational(1)) / (Rational(1) + c),
                       side = Rational(2) * (Rational(2) * c - Rational(3));
        Points<Rational> expected(1, 5);
        expected << scale * c, scale * side, Rational(0), -scale * side, -scale * c;
        CHECK(jump.row(2) == expected.row(0));
        CHECK((jump.row(2) == Points<Rational>::Zero(1, 5).row(0)) == (c == Rational(1) / Rational(2)));
      }
    }
    Points<Rational> spline(4, 4);  // the uniform cubic B-spline
    const int weights[4][4] = {{1, 4, 1, 0}, {-3, 0, 3, 0}, {3, -6, 3, 0}, {-1, 3, -3, 1}};
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j) spline(i, j) = Rational(weights[i][j]) / Rational(6);
    CHECK(segment_matrix<Rational>(Rational(1) / Rational(2)) == spline);
  }

  TEST_CASE("a patch with one parameter is the tensor product of segments") {
    Dice dice(66);
    for (const Rational& c : {Rational(1) / Rational(4), Rational(1) / Rational(2), Rational(1)}) {
      const auto net = random_points<Rational>(dice, 16, 1);
      // power to Bernstein of degree 3: coefficient k is the sum of C(k,i)/C(3,i) a_i
      Points<Rational> change = Points<Rational>::Zero(4, 4);
      const int choose[4][4] = {{1, 0, 0, 0}, {1, 1, 0, 0}, {1, 2, 1, 0}, {1, 3, 3, 1}};
      for (int k = 0; k < 4; ++k)
        for (int i = 0; i <= k; ++i) change(k, i) = Rational(choose[k][i]) / Rational(choose[3][i]);
      const Points<Rational> one = change * segment_matrix<Rational>(c);
      Points<Rational> grid(4, 4);
      for (int a = 0; a < 4; ++a)
        for (int b = 0; b < 4; ++b) grid(a, b) = net(4 * a + b, 0);
      const Points<Rational> expected = one * grid * one.transpose(), patch = hybrid_patch<Rational>(net, {c, c, c, c});
      for (int j = 0; j < 4; ++j)
        for (int k = 0; k < 4; ++k) CHECK(patch(4 * j + k, 0) == expected(j, k));
    }
  }

  TEST_CASE("hybrid patches with different parameters meet with C1 exactly") {
    Dice dice(67);
    for (int trial = 0; trial < 20; ++trial) {
      const auto grid = random_points<Rational>(dice, 20, 3);  // 5 x 4 points: two faces side by side in the first direction
      std::array<Rational, 6> c;
      for (Rational& x : c) x = Rational(dice.between(1, 7)) / Rational(7);
      for (const TangentFactor factor : {TangentFactor::paper, TangentFactor::limit}) {
        const Points<Rational> left = hybrid_patch<Rational>(grid.topRows(16), {c[0], c[1], c[2], c[3]}, factor);
        const Points<Rational> right = hybrid_patch<Rational>(grid.bottomRows(16), {c[2], c[3], c[4], c[5]}, factor);
        CHECK(left.bottomRows(4) == right.topRows(4));
        CHECK(Points<Rational>(left.bottomRows(4) - left.middleRows(8, 4)) ==
              Points<Rational>(right.middleRows(4, 4) - right.topRows(4)));
      }
    }
  }

  TEST_CASE("patches with their own parameter each would leave gaps") {
    Dice dice(68);
    const auto grid = random_points<Rational>(dice, 20, 1);
    const Rational a = Rational(1) / Rational(4), b = Rational(3) / Rational(4);
    const Points<Rational> left = hybrid_patch<Rational>(grid.topRows(16), {a, a, a, a});
    const Points<Rational> right = hybrid_patch<Rational>(grid.bottomRows(16), {b, b, b, b});
    CHECK(left.bottomRows(4) != right.topRows(4));
  }

  TEST_CASE("parameters outside 0 to 1 are refused with their vertex") {
    CHECK_THROWS_WITH_AS(schemes::adjustable(Rational(3) / Rational(2)), "c = 3/2 is not between 0 and 1", Error);
    CHECK_THROWS_WITH_AS(schemes::adjustable(Rational(-1)), "c = -1 is not between 0 and 1", Error);
    auto surface = cube<Rational>();
    CHECK_THROWS_WITH_AS(hybrid_step(surface), "the surface has no attribute 'c'", Error);
    surface.attributes["c"] = constant_column(*surface.mesh, Rational(1));
    surface.attributes["c"][5] = Rational(9) / Rational(8);
    CHECK_THROWS_WITH_AS(hybrid_step(surface), "c = 9/8 at vertex 5 is not between 0 and 1", Error);
  }
}
