// What interpolation refuses, with the texts; stopping and progress.
#include <doctest/doctest.h>

#include <limits>

#include "operators/methods/interpolation/interpolation.h"
#include "operators/methods/interpolation/mesh_system.h"
#include "operators/shapes.h"
#include "tests/oracle/inputs.h"
#include "tests/oracle/refusal.h"

using namespace udcp;
using namespace udcp::oracle;

namespace {

std::string refused(const Surface<double>& cage, const Points<double>& normals, const InterpolateOptions& options = {}) {
  return refusal([&] { (void)interpolate(cage, normals, options); });
}

InterpolateOptions with_lambda(int p, int q) {
  InterpolateOptions options;
  options.lambda = Rational(p) / Rational(q);
  return options;
}

}  // namespace

TEST_SUITE("operators") {
  TEST_CASE("lambda outside of the theorem is refused with the theorem") {
    const auto cage = cube<double>();
    const std::string reason =
        " is outside (7/20, 1]: the eigenvalues of the map from control points to limit points are at least n(20 lambda - "
        "7)/(13(n + 5)), attained on two-colourable meshes, so at 7/20 it stops being invertible";
    CHECK(refused(cage, cage.points, with_lambda(7, 20)) == "E_LAMBDA: lambda = 7/20" + reason);
    CHECK(refused(cage, cage.points, with_lambda(11, 10)) == "E_LAMBDA: lambda = 11/10" + reason);
    CHECK(refused(cage, cage.points, with_lambda(-1, 2)) == "E_LAMBDA: lambda = -1/2" + reason);
    CHECK(refused(cage, cage.points, with_lambda(1, 1)) == "accepted");
    CHECK(refused(cage, cage.points, with_lambda(351, 1000)) == "accepted");
    InterpolateOptions local = with_lambda(1, 4);
    local.step1 = PointStep::local;
    const Interpolation result = interpolate(cage, cage.points, local);
    REQUIRE(result.notes.size() == 1);
    CHECK(result.notes[0] == "lambda shapes the result of step1 = global only");
  }

  TEST_CASE("bad normals are refused by name") {
    const auto cage = cube<double>();
    Points<double> normals = cage.points;
    CHECK(refused(cage, normals.topRows(7)) == "E_NORMALS: there are 7 normals of 3 numbers for 8 vertices");
    CHECK(refused(cage, normals.leftCols(2)) == "E_NORMALS: there are 8 normals of 2 numbers for 8 vertices");
    normals.row(5).setZero();
    CHECK(refused(cage, normals) == "E_NORMAL: the normal at vertex 5 is zero");
    normals(3, 1) = std::numeric_limits<double>::infinity();
    CHECK(refused(cage, normals) == "E_NORMAL: the normal at vertex 3 is not finite");
    InterpolateOptions options;
    options.skipped_normals = {0, 0, 0, 1, 0, 1, 0, 0};
    CHECK(refused(cage, normals, options) == "accepted");
    options.skipped_normals.pop_back();
    CHECK(refused(cage, normals, options) == "E_ARGUMENTS: a list of 7 flags for 8 vertices");
  }

  TEST_CASE("bad cages are refused by name") {
    Surface<double> cage = cube<double>();
    cage.points(6, 2) = std::numeric_limits<double>::quiet_NaN();
    CHECK(refused(cage, cube<double>().points) == "E_NOT_FINITE: vertex 6 has a coordinate that is not finite");
    Surface<double> pillow{
        std::make_shared<const Mesh>(make_mesh(4, Faces{{0, 1, 2, 3}, {3, 2, 1, 0}})), grid<double>(1, 1).points, {}, {}};
    CHECK(refused(pillow, pillow.points) ==
          "E_VALENCE2: vertex 0 has two edges and lies inside; interpolation needs three or more there");
    Surface<double> flat = grid<double>(2, 2);
    flat.points.conservativeResize(9, 2);
    CHECK(refused(flat, {}) == "E_DIMENSION: interpolation of normals needs points of three coordinates");
    InterpolateOptions literal;
    literal.method = InterpolationMethod::literal;
    const Surface<double> open = grid<double>(2, 2);
    const Points<double> up = Eigen::RowVector3d(0, 0, 1).replicate(9, 1);
    CHECK(refused(open, up, literal) ==
          "E_NOT_CLOSED: vertex 0 lies on the boundary; this method is for closed meshes without corners");
    literal.step2 = NormalStep::rotate;
    CHECK(refused(cube<double>(), cube<double>().points, literal) ==
          "E_ARGUMENTS: the sweeps of the paper project tangents; they have no rotation");
    InterpolateOptions kkt;
    kkt.method = InterpolationMethod::kkt;
    kkt.step1 = PointStep::plain;
    CHECK(refused(cube<double>(), cube<double>().points, kkt) ==
          "E_ARGUMENTS: the shortest correction works on the first refinement, and plain needs two");
    kkt.step1 = PointStep::global;
    const auto large = torus<double>(80, 70, 3, 1);
    CHECK(refused(large, large.points, kkt) ==
          "E_TOO_LARGE: all conditions at once would take too long for 5600 vertices; the limit is 5000");
  }

  TEST_CASE("tangents without a plane are refused by name unless they are projected") {
    Surface<double> line = cube<double>();
    line.points.rightCols(2).setZero();
    const Points<double> up = Eigen::RowVector3d(0, 0, 1).replicate(8, 1);
    const std::string message = "E_TANGENTS: the surface has no tangent plane at vertex 0: its limit tangents are parallel";
    CHECK(refused(line, up) == message);
    InterpolateOptions options;
    options.step2 = NormalStep::rotate;
    CHECK(refused(line, up, options) == message);
    options.step2 = NormalStep::free;
    const Interpolation result = interpolate(line, up, options);
    REQUIRE(result.notes.size() == 1);
    CHECK(result.notes[0] == "8 vertices: no tangent plane is left there; step2 = rotate keeps one");
    const Points<double> along = Eigen::RowVector3d(1, 0, 0).replicate(9, 1);
    CHECK(refused(grid<double>(2, 2), along) ==
          "E_TANGENTS: the normal at vertex 1 has the direction of the boundary curve there");
  }

  TEST_CASE("exact systems of many vertices are refused before they are solved") {
    Surface<Rational> cage = grid<Rational>(40, 40);
    CHECK(refusal([&] { (void)interpolate_points(cage); }) ==
          "E_TOO_LARGE: an exact solution for 1521 vertices would take too long; the limit is 400");
    PointOptions local;
    local.step = PointStep::local;
    CHECK(limit_points(interpolate_points(cage, local), cage.mesh->vertices()) == cage.points);
    MeshSystem<Rational> system;
    system.diagonal = {Rational(1), Rational(1)};
    system.edges = {{0, 1}};
    CHECK(refusal([&] { (void)solve(system, Points<Rational>(Points<Rational>::Zero(2, 1))); }) ==
          "E_SINGULAR: a pivot of the linear system cannot be told from 0");
    CHECK(refusal([&] { (void)progress_points(cube<Rational>(), local, -1); }) ==
          "E_ARGUMENTS: the iteration exists for global and local, and for 0 or more iterations");
  }

  TEST_CASE("interpolation stops when told to and reports rising progress") {
    std::atomic<bool> stop{true};
    const auto cage = torus<double>(12, 8, 3, 1);
    for (const InterpolationMethod method :
         {InterpolationMethod::two_level, InterpolationMethod::literal, InterpolationMethod::kkt}) {
      InterpolateOptions options;
      options.method = method;
      options.control.stop = &stop;
      CHECK(refused(cage, cage.points, options) == "E_INTERRUPTED: interrupted");
    }
    InterpolateOptions options;
    double last = 0;
    bool rising = true;
    options.control.progress = [&](double fraction) {
      rising = rising && fraction >= last && fraction <= 1;
      last = fraction;
    };
    const Interpolation result = interpolate(cage, cage.points, options);
    CHECK(rising);
    CHECK(last == 1);
    options.control.max_faces = 16 * 96 - 1;
    CHECK(refused(cage, cage.points, options) == "E_MAX_FACES: the result would have 1536 faces; the limit is 1535");
  }
}
