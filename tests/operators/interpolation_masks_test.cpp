// The masks of interpolation against closed forms, as eigenvectors of the running word, and against limits found another way.
#include <doctest/doctest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include "operators/limit.h"
#include "operators/methods/interpolation/interpolate_points.h"
#include "operators/methods/interpolation/ring_tangents.h"
#include "operators/schemes.h"
#include "tests/oracle/inputs.h"

using namespace udcp;
using namespace udcp::oracle;

namespace {

// The new fan of vertex 0 from the old one: rows are v, e_0 .., f_0 ..
template <class S>
Points<S> fan_matrix(const Mesh& mesh) {
  const Surface<S> units{std::make_shared<const Mesh>(mesh), Points<S>::Identity(mesh.vertices(), mesh.vertices()), {}, {}};
  const Surface<S> fine = run(schemes::catmull_clark(), units, 1);
  Fan before, after;
  collect_fan(mesh, 0, before);
  collect_fan(*fine.mesh, 0, after);
  const auto row = [](const Fan& fan, int k) { return k == 0 ? 0 : fan_point(fan, static_cast<std::size_t>(k - 1)); };
  Points<S> matrix(mesh.vertices(), mesh.vertices());
  for (int i = 0; i < mesh.vertices(); ++i)
    for (int j = 0; j < mesh.vertices(); ++j) matrix(i, j) = fine.points(row(after, i), row(before, j));
  return matrix;
}

// The weights of a tangent with that of v in front, which makes their sum 0.
Eigen::RowVectorXd with_vertex(const std::vector<double>& weights) {
  Eigen::RowVectorXd row(static_cast<Eigen::Index>(weights.size()) + 1);
  row[0] = 0;
  for (std::size_t k = 0; k < weights.size(); ++k) row[static_cast<Eigen::Index>(k) + 1] = weights[k];
  row[0] = -row.sum();
  return row;
}

Fan fan_of(const Mesh& mesh) {
  Fan fan;
  collect_fan(mesh, 0, fan);
  return fan;
}

}  // namespace

TEST_SUITE("operators") {
  TEST_CASE("fans list neighbours counter-clockwise and the points across between them") {
    const Fan inside = fan_of(fan_mesh(5, true)), boundary = fan_of(fan_mesh(3, false));
    CHECK(inside.inside);
    CHECK(inside.e == std::vector<int>{1, 3, 5, 7, 9});
    CHECK(inside.f == std::vector<int>{2, 4, 6, 8, 10});
    CHECK_FALSE(boundary.inside);
    CHECK(boundary.e == std::vector<int>{1, 3, 5, 7});
    CHECK(boundary.f == std::vector<int>{2, 4, 6});
    Fan fan;
    const Mesh grid_mesh = *grid<Rational>(2, 2).mesh;
    collect_fan(grid_mesh, 4, fan);  // the middle of 3 by 3 vertices
    std::rotate(fan.e.begin(), std::find(fan.e.begin(), fan.e.end(), 5), fan.e.end());
    std::rotate(fan.f.begin(), std::find(fan.f.begin(), fan.f.end(), 8), fan.f.end());
    CHECK(fan.e == std::vector<int>{5, 7, 3, 1});
    CHECK(fan.f == std::vector<int>{8, 6, 0, 2});
  }

  TEST_CASE("limit masks of valence 3 to 50 are the closed forms") {
    LimitMasks masks;
    const double pi = std::acos(-1.0);
    for (int n = 3; n <= 50; ++n) {
      CAPTURE(n);
      const Rational total(n * (n + 5));
      CHECK(masks.inside(n).vertex == Rational(n * n) / total);
      CHECK(masks.inside(n).edge == Rational(4) / total);
      CHECK(masks.inside(n).face == Rational(1) / total);
      // a few roundings of numbers below 8
      const double c = std::cos(2 * pi / n), a = 1 + c + std::cos(pi / n) * std::sqrt(2 * (9 + c));
      CHECK(std::abs(masks.tangents(n).edge - a) < 2e-14);
      CHECK(std::abs(masks.tangents(n).eigenvalue - (4 + a) / 16) < 2e-15);
      CHECK(std::abs(masks.tangents(n).face - 2 * std::cos(pi / n)) < 1e-15);
    }
    CHECK(masks.boundary().vertex == Rational(2) / Rational(3));
    CHECK(masks.boundary().edge == Rational(1) / Rational(6));
  }

  TEST_CASE("limit masks are left eigenvectors of the running word for valence 3 to 50") {
    LimitMasks masks;
    RingMasks rings;
    for (int n = 3; n <= 50; ++n) {
      CAPTURE(n);
      const Mesh mesh = fan_mesh(n, true);
      if (n <= 12) {
        const Points<Rational> exact = fan_matrix<Rational>(mesh);
        Points<Rational> row(1, 2 * n + 1);
        for (int k = 0; k <= 2 * n; ++k)
          row(0, k) = k == 0 ? masks.inside(n).vertex : k <= n ? masks.inside(n).edge : masks.inside(n).face;
        CHECK(Points<Rational>(row * exact) == row);
      }
      const Eigen::MatrixXd matrix = fan_matrix<double>(mesh);
      const RingWeights& weights = *rings.weights(fan_of(mesh));
      for (const auto* tangent : {&weights.first, &weights.second}) {
        const Eigen::RowVectorXd row = with_vertex(*tangent);
        CHECK(std::abs(row[0]) < 1e-13);
        CHECK((row * matrix - masks.tangents(n).eigenvalue * row).cwiseAbs().maxCoeff() < 1e-14);
      }
    }
  }

  TEST_CASE("sums of the tangent weights have the identities of every valence") {
    RingMasks rings;
    for (int n = 3; n <= 50; ++n) {
      CAPTURE(n);
      const RingWeights& w = *rings.weights(fan_of(fan_mesh(n, true)));
      double on_e = 0, on_f = 0, mixed = 0, first = 0, second = 0, tied_mixed = 0, tied_first = 0, tied_second = 0;
      for (std::size_t k = 0; k < Mesh::i(n); ++k) {
        const std::size_t f = k + Mesh::i(n);
        on_e += w.first[k];
        on_f += w.second[f];
        mixed += w.first[k] * w.second[k] + w.first[f] * w.second[f];
        first += w.first[k] * w.first[k] + w.first[f] * w.first[f];
        second += w.second[k] * w.second[k] + w.second[f] * w.second[f];
        const double a = w.first[k] + w.first[f], b = w.second[k] + w.second[f];
        tied_mixed += a * b;
        tied_first += a * a;
        tied_second += b * b;
      }
      const double bound = 1e-12 * first;
      CHECK(std::abs(on_e) + std::abs(on_f) + std::abs(mixed) + std::abs(tied_mixed) < bound);
      CHECK(std::abs(first - second) + std::abs(first - w.squares) < bound);
      CHECK(std::abs(tied_first - tied_second) + std::abs(tied_first - w.tied_squares) < bound);
      LimitMasks masks;
      const double a = masks.tangents(n).edge, c = std::cos(2 * std::acos(-1.0) / n);
      CHECK(std::abs(first - n / 2.0 * (a * a + 2 * (1 + c))) < bound);
      CHECK(std::abs(tied_first - n / 2.0 * ((a + 1) * (a + 1) + 2 * (a + 1) * c + 1)) < bound);
    }
  }

  TEST_CASE("tangents on the boundary are left eigenvectors of the running word") {
    LimitMasks masks;
    RingMasks rings;
    for (const int k : {2, 3}) {
      CAPTURE(k);
      const Mesh mesh = fan_mesh(k, false);
      const Eigen::MatrixXd matrix = fan_matrix<double>(mesh);
      const RingWeights& weights = *rings.weights(fan_of(mesh));
      const Eigen::RowVectorXd along = with_vertex(weights.first), across = with_vertex(weights.second);
      CHECK((along * matrix - along / 2).cwiseAbs().maxCoeff() < 1e-15);
      CHECK(std::abs(across[0] - masks.across(k).vertex) < 1e-13);
      CHECK((across * matrix - masks.across(k).inside.eigenvalue * across).cwiseAbs().maxCoeff() < 1e-13);
      CHECK(weights.movable.front() == 0);
      CHECK(weights.movable[Mesh::i(k)] == 0);
    }
    for (const int k : {1, 4, 5, 9}) CHECK(rings.weights(fan_of(fan_mesh(k, false))) == nullptr);
  }

  TEST_CASE("with four faces or more on a boundary a second mode is no weaker than the tangent along") {
    LimitMasks masks;
    for (int k = 2; k <= 12; ++k) {
      CAPTURE(k);
      const Eigen::MatrixXd matrix = fan_matrix<double>(fan_mesh(k, false));
      const Eigen::VectorXcd values = matrix.eigenvalues();
      const auto strong = ((values.array() - 1.0).abs() > 1e-9 && values.real().array() > 0.5 - 1e-5).count();  // and not the 1
      if (k <= 3)
        CHECK(strong == 2);
      else
        CHECK(strong > 2);
    }
    CHECK(masks.tangents(4).eigenvalue == doctest::Approx(0.5));
  }

  TEST_CASE("limit points and normals agree with the limit code on every kind of mesh") {
    Dice dice(71);
    for (const NamedMesh& named : {NamedMesh{"star 5", *ring_mesh(5, 2).mesh},
                                   {"L", l_shape()},
                                   {"prism", prism(7)},
                                   {"mixed", polygon_meshes().back().mesh},
                                   {"fan", fan_mesh(3, false)}}) {
      CAPTURE(named.name);
      Surface<double> fine = run(schemes::catmull_clark(), random_surface<double>(dice, named.mesh), 1);
      const Limit expected = limit(schemes::catmull_clark(), fine);
      CHECK((limit_points(fine, fine.mesh->vertices()) - expected.points).cwiseAbs().maxCoeff() < 1e-12 * 30);
      RingMasks rings;
      Fan fan;
      for (int v = 0; v < fine.mesh->vertices(); ++v) {
        collect_fan(*fine.mesh, v, fan);
        const RingWeights* weights = rings.weights(fan);
        if (weights == nullptr) continue;
        const Eigen::RowVector3d normal = normal_of(tangents_at(fine.points, v, fan, *weights));
        CHECK(angle_between(normal, expected.normals.row(v)) < 1e-7);
      }
    }
  }
}
