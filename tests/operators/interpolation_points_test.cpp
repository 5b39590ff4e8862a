// Step 1: the modified rule, exact interpolation, the theorem on 7/20, and the paper's iteration.
#include <doctest/doctest.h>

#include <Eigen/Eigenvalues>

#include "operators/methods/interpolation/mesh_system.h"
#include "operators/methods/interpolation/point_system.h"
#include "operators/methods/interpolation/quad_fans.h"
#include "operators/schemes.h"
#include "tests/operators/interpolation_golden.h"
#include "tests/oracle/inputs.h"

using namespace udcp;
using namespace udcp::oracle;

namespace {

Rational ratio(int p, int q) { return Rational(p) / Rational(q); }

std::vector<NamedMesh> all_meshes() {
  std::vector<NamedMesh> result = quad_meshes();
  for (NamedMesh& named : polygon_meshes()) result.push_back(std::move(named));
  result.push_back({"fan", fan_mesh(4, false)});
  return result;
}

PointOptions options_of(PointStep step, Rational lambda = ratio(7, 10)) {
  PointOptions options;
  options.step = step;
  options.lambda = std::move(lambda);
  return options;
}

// Points to limits of the modified step, as a matrix.
Eigen::MatrixXd limit_matrix(const Mesh& mesh, const Rational& lambda) {
  const Surface<double> units{
      std::make_shared<const Mesh>(mesh), Points<double>::Identity(mesh.vertices(), mesh.vertices()), {}, {}};
  return limit_points(modified_step(units, lambda), mesh.vertices());
}

double lower_bound(const Mesh& mesh, const Rational& lambda) {
  double result = 1;
  for (int v = 0; v < mesh.vertices(); ++v) {
    const int n = mesh.valence(v);
    const Rational inside = Rational(n) * (Rational(20) * lambda - Rational(7)) / Rational(13 * (n + 5));
    const Rational boundary = (Rational(32) * lambda - Rational(6)) / Rational(39);
    result = std::min(result, (mesh.on_boundary(v) ? boundary : inside).to_double());
  }
  return result;
}

// Real, as the matrix is similar to a symmetric one (block by block on open meshes).
std::pair<double, double> eigenvalue_range(const Eigen::MatrixXd& matrix) {
  const Eigen::VectorXcd values = Eigen::EigenSolver<Eigen::MatrixXd>(matrix, false).eigenvalues();
  CHECK(values.imag().cwiseAbs().maxCoeff() < 1e-6);  // Jordan blocks of block triangular matrices split by the root of rounding
  return {values.real().minCoeff(), values.real().maxCoeff()};
}

}  // namespace

TEST_SUITE("operators") {
  TEST_CASE("the modified vertex rule is equation (3) on closed quad meshes") {
    Dice dice(72);
    for (const NamedMesh& named : quad_meshes()) {
      if (named.name != "cube" && named.name != "torus") continue;
      const auto surface = random_surface<Rational>(dice, named.mesh);
      for (const Rational& lambda : {ratio(2, 5), ratio(7, 10), Rational(1), Rational(-3)}) {
        const Points<Rational> fine = modified_step(surface, lambda).points;
        Fan fan;
        for (int v = 0; v < named.mesh.vertices(); ++v) {
          collect_fan(named.mesh, v, fan);
          const Rational n(fan.faces()), rest = Rational(1) - lambda;
          Points<Rational> expected = surface.points.row(v) * lambda;
          for (const int e : fan.e) expected += surface.points.row(e) * Rational(rest * ratio(10, 13) / n);
          for (const int f : fan.f) expected += surface.points.row(f) * Rational(rest * ratio(3, 13) / n);
          CHECK(Points<Rational>(fine.row(v)) == expected);
        }
        const Points<Rational> plain = run(schemes::catmull_clark(), surface, 1).points;
        CHECK(fine.bottomRows(fine.rows() - named.mesh.vertices()) == plain.bottomRows(fine.rows() - named.mesh.vertices()));
      }
    }
  }

  TEST_CASE("all steps interpolate exactly on closed and open meshes of any polygons") {
    Dice dice(73);
    for (const NamedMesh& named : all_meshes()) {
      CAPTURE(named.name);
      for (const bool corners : {false, true}) {
        auto surface = random_surface<Rational>(dice, named.mesh);
        if (corners) surface.tags = random_corners(dice, named.mesh, 3);
        for (const PointStep step : {PointStep::global, PointStep::local, PointStep::plain}) {
          CAPTURE(static_cast<int>(step));
          const Surface<Rational> fine = interpolate_points(surface, options_of(step));
          CHECK(fine.mesh->faces() == (step == PointStep::plain ? 4 : 1) * named.mesh.half_edges());
          CHECK(limit_points(fine, named.mesh.vertices()) == surface.points);
          const Surface<Rational> finer = run(schemes::catmull_clark(), fine, 1);
          CHECK(limit_points(finer, named.mesh.vertices()) == surface.points);
        }
      }
    }
  }

  TEST_CASE("interpolation of points commutes with affine maps") {
    Dice dice(74);
    for (const NamedMesh& named : all_meshes()) {
      CAPTURE(named.name);
      const auto surface = random_surface<Rational>(dice, named.mesh);
      const Points<Rational> linear = random_points<Rational>(dice, 3, 3), shift = random_points<Rational>(dice, 1, 3);
      const auto map = [&](const Points<Rational>& points) {
        Points<Rational> result = points * linear;
        for (Eigen::Index i = 0; i < result.rows(); ++i) result.row(i) += shift.row(0);
        return result;
      };
      Surface<Rational> mapped = surface;
      mapped.points = map(surface.points);
      for (const PointStep step : {PointStep::global, PointStep::local, PointStep::plain})
        CHECK(interpolate_points(mapped, options_of(step)).points == map(interpolate_points(surface, options_of(step)).points));
    }
  }

  TEST_CASE("lambda has no influence on local and less with each of its iterations") {
    Dice dice(75);
    for (const Mesh& mesh : {*cube<Rational>().mesh, prism(5), *torus<double>(4, 3, 2, 1).mesh}) {
      const auto surface = random_surface<Rational>(dice, mesh);
      const PointOptions one = options_of(PointStep::local, ratio(2, 5)), other = options_of(PointStep::local, Rational(1));
      const Surface<Rational> limit = interpolate_points(surface, one);
      CHECK(limit.points == interpolate_points(surface, other).points);
      Points<Rational> before = progress_points(surface, one, 0).control.points - limit.points;
      for (int k = 1; k <= 4; ++k) {
        const Points<Rational> after = progress_points(surface, one, k).control.points - limit.points;
        for (int v = 0; v < mesh.vertices(); ++v)  // the paper's iteration contracts by 5/(n + 5) at each vertex
          CHECK(Points<Rational>(after.row(v)) == Points<Rational>(before.row(v) * ratio(5, mesh.valence(v) + 5)));
        before = after;
      }
      const Progress<double> many = progress_points(convert<double>(surface), one, 500, 1e-15);
      CHECK((many.control.points - convert<double>(limit).points).cwiseAbs().maxCoeff() < 1e-12);
    }
    const Progress<double> cube_run = progress_points(cube<double>(), options_of(PointStep::local), 20);
    CHECK(std::abs(cube_run.contraction - 0.625) < 1e-9);
  }

  TEST_CASE("the eigenvalues of the map to limits lie between the bound of the theorem and 1") {
    Dice dice(76);
    for (const NamedMesh& named : all_meshes()) {
      CAPTURE(named.name);
      for (const Rational& lambda : {ratio(36, 100), ratio(2, 5), ratio(7, 10), Rational(1)}) {
        const auto [least, most] = eigenvalue_range(limit_matrix(named.mesh, lambda));
        CHECK(least >= lower_bound(named.mesh, lambda) - 1e-7);
        CHECK(most <= 1 + 1e-9);
      }
    }
    for (const std::string& name : golden_names()) {
      CAPTURE(name);
      const Mesh mesh = *golden_mesh(name).cage.mesh;
      const nlohmann::json& expected = interpolation_values()["runs"][name]["limit_matrix_lambda_0.7"];
      CHECK(std::abs(lower_bound(mesh, ratio(7, 10)) - expected["lower_bound"].get<double>()) < 1e-12);
      CHECK(std::abs(eigenvalue_range(limit_matrix(mesh, ratio(7, 10))).first - expected["min_eigenvalue"].get<double>()) < 1e-9);
    }
  }

  TEST_CASE("at 7/20 and below two-colourable meshes have an eigenvalue that is not positive") {
    for (const Mesh& mesh : {*cube<double>().mesh, *torus<double>(4, 6, 2, 1).mesh, prism(6)}) {
      CHECK(eigenvalue_range(limit_matrix(mesh, ratio(7, 20))).first < 1e-12);
      CHECK(eigenvalue_range(limit_matrix(mesh, ratio(3, 10))).first < -1e-3);
      PointOptions options = options_of(PointStep::global, ratio(3, 10));
      Dice dice(77);
      const Progress<double> run = progress_points(random_surface<double>(dice, mesh), options, 400);
      CHECK(run.differences.back() > run.differences[100]);
      CHECK(run.contraction > 1.001);
    }
  }

  TEST_CASE("the iteration over the whole mesh contracts as the theorem says and meets the linear system") {
    for (const std::string name : {"cube", "hex", "torus_coarse", "cone"}) {
      CAPTURE(name);
      const Surface<double> cage = golden_mesh(name).cage;
      const PointOptions options = options_of(PointStep::global);
      const Progress<double> run = progress_points(cage, options, 400, 1e-15);
      CHECK(run.differences.size() < 400);
      CHECK((run.control.points - interpolate_points(cage, options).points).cwiseAbs().maxCoeff() < 1e-13 * 10);
      const Progress<double> some = progress_points(cage, options, 40);
      CHECK(some.contraction <= 1 - lower_bound(*cage.mesh, options.lambda) + 1e-6);
    }
  }

  TEST_CASE("exact and floating point solutions of global agree on every number type") {
    Dice dice(78);
    for (const NamedMesh& named : all_meshes()) {
      CAPTURE(named.name);
      const auto surface = random_surface<Rational>(dice, named.mesh);
      const Points<double> expected = convert<double>(interpolate_points(surface)).points;
      CHECK((interpolate_points(convert<double>(surface)).points - expected).cwiseAbs().maxCoeff() < 1e-12 * 100);
      CHECK(convert<double>(interpolate_points(convert<Algebraic>(surface))).points == expected);
      const Points<Interval> enclosed = interpolate_points(convert<Interval>(surface)).points;
      const Points<Rational> exact = interpolate_points(surface).points;
      bool inside = true;
      for (Eigen::Index k = 0; k < exact.size(); ++k)
        inside = inside && !(Interval(exact.data()[k]) < enclosed.data()[k]) && !(Interval(exact.data()[k]) > enclosed.data()[k]);
      CHECK(inside);
    }
  }

  TEST_CASE("vertices without a prescribed position keep W or follow the modified rule") {
    Dice dice(79);
    for (const NamedMesh& named :
         {NamedMesh{"cube", *cube<Rational>().mesh}, {"prism", prism(5)}, {"star", *ring_mesh(5, 2).mesh}}) {
      CAPTURE(named.name);
      const auto surface = random_surface<Rational>(dice, named.mesh);
      PointOptions options;
      options.skipped.assign(Mesh::i(named.mesh.vertices()), 0);
      options.skipped[0] = options.skipped[3] = 1;
      const Points<Rational> w = solve_for_limits(surface, options);
      for (const PointStep step : {PointStep::global, PointStep::local}) {
        options.step = step;
        const Surface<Rational> fine = interpolate_points(surface, options);
        const Points<Rational> limits = limit_points(fine, named.mesh.vertices());
        for (int v = 0; v < named.mesh.vertices(); ++v)
          CHECK((Points<Rational>(limits.row(v)) == Points<Rational>(surface.points.row(v))) == (v != 0 && v != 3));
        for (const int v : {0, 3}) {
          CHECK(Points<Rational>(w.row(v)) == Points<Rational>(surface.points.row(v)));
          if (step == PointStep::local)
            CHECK(Points<Rational>(fine.points.row(v)) == Points<Rational>(modified_step(surface, options.lambda).points.row(v)));
        }
      }
    }
  }

  TEST_CASE("conjugate gradients take over on large meshes") {
    // 22,800 vertices are more than the 20,000 up to which Cholesky serves
    const Surface<double> cage = torus<double>(152, 150, 3, 1);
    const Surface<double> fine = interpolate_points(cage);
    CHECK((limit_points(fine, cage.mesh->vertices()) - cage.points).cwiseAbs().maxCoeff() < 1e-13 * 4);
    PointOptions steep = options_of(PointStep::global, ratio(350001, 1000000));  // nearly singular: Cholesky again
    const Surface<double> other = interpolate_points(cage, steep);
    CHECK((limit_points(other, cage.mesh->vertices()) - cage.points).cwiseAbs().maxCoeff() < 1e-12 * 4);
  }

  TEST_CASE("boundary curves are interpolated by themselves") {
    Dice dice(80);
    const Mesh mesh = *ring_mesh(5, 2).mesh;
    auto surface = random_surface<Rational>(dice, mesh);
    const Surface<Rational> one = interpolate_points(surface);
    Surface<Rational> moved = surface;
    for (int v = 0; v < mesh.vertices(); ++v)
      if (!mesh.on_boundary(v)) moved.points.row(v) *= Rational(3);
    const Surface<Rational> other = interpolate_points(moved);
    for (int v = 0; v < one.mesh->vertices(); ++v)
      if (one.mesh->on_boundary(v)) CHECK(Points<Rational>(one.points.row(v)) == Points<Rational>(other.points.row(v)));
  }
}
