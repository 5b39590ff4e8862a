// Interpolation against the file of expected values: masks, exact solutions, runs of every variant.
#include <doctest/doctest.h>

#include "operators/limit.h"
#include "operators/methods/interpolation/point_system.h"
#include "operators/methods/interpolation/ring_tangents.h"
#include "operators/schemes.h"
#include "operators/shapes.h"
#include "tests/operators/interpolation_golden.h"
#include "tests/oracle/obj_lines.h"

using namespace udcp;
using namespace udcp::oracle;
using Values = nlohmann::json;

namespace {

// 1e-9 relative or absolute, as the file asks for; tiny values only mean rounding.
bool near(double value, double expected) { return std::abs(value - expected) <= 1e-9 * std::max(1.0, std::abs(expected)); }

PointStep point_step(const std::string& name) {
  return name == "global" ? PointStep::global : name == "local" ? PointStep::local : PointStep::plain;
}
NormalStep normal_step(const std::string& name) {
  return name == "free" ? NormalStep::free : name == "tied" ? NormalStep::tied : NormalStep::rotate;
}

// Decimal fractions as exact numbers.
Rational decimal(double value) { return Rational(static_cast<int>(std::lround(value * 10))) / Rational(10); }

void check_run(const GoldenMesh& mesh, const Values& expected, double bound) {
  CAPTURE(expected.dump());
  InterpolateOptions options;
  options.step1 = point_step(expected["step1"]);
  options.lambda = decimal(expected["lambda"]);
  options.step2 = normal_step(expected["step2"]);
  const Interpolation result = interpolate(mesh.cage, mesh.normals, options);
  double angle = 0, displacement = 0, squares = 0;
  for (const VertexReport& report : result.vertices) {
    angle = std::max(angle, report.angle_before);
    displacement = std::max(displacement, report.displacement);
    squares += report.squared_displacement;
  }
  CHECK(near(angle, expected["angle_before"]));
  CHECK(near(displacement, expected["max_displacement"]));
  CHECK(near(squares, expected["sum_squared_displacement"]));
  CHECK(result.errors.position <= bound);
  CHECK(result.errors.normal <= bound);
  CHECK(result.errors.reversed == 0);
}

Rational at(const Points<Rational>& points, int row, int column) { return points(row, column); }

void check_rows(const Points<Rational>& points, const Values& rows) {
  for (int v = 0; v < static_cast<int>(rows.size()); ++v)
    for (int c = 0; c < 3; ++c)
      CHECK(at(points, v, c) == fraction_of(rows[static_cast<std::size_t>(v)][static_cast<std::size_t>(c)]));
}

void check_row(const Points<Rational>& points, int row, const Values& expected) {
  for (int c = 0; c < 3; ++c) CHECK(at(points, row, c) == fraction_of(expected[static_cast<std::size_t>(c)]));
}

// The new point of the edge (face) of the cube whose middle is (1, 0, 1) ((0, 0, 1)).
int edge_point(const Surface<Rational>& cage) {
  const Mesh& mesh = *cage.mesh;
  for (int e = 0; e < mesh.edges(); ++e) {
    const int a = mesh.vertex[Mesh::i(mesh.edge_half[Mesh::i(e)])], b = mesh.tip(mesh.edge_half[Mesh::i(e)]);
    if (std::min(a, b) == 5 && std::max(a, b) == 7) return mesh.vertices() + e;
  }
  return -1;
}
int face_point(const Surface<Rational>& cage) { return cage.mesh->vertices() + cage.mesh->edges() + 1; }

// Limits at all points of the first refinement: one more step makes them vertices of a quad mesh.
Points<Rational> all_limits(const Surface<Rational>& fine) {
  return limit_points(run(schemes::catmull_clark(), fine, 1), fine.mesh->vertices());
}

void check_variant(const Surface<Rational>& cage, const Values& expected, const PointOptions& options) {
  const Surface<Rational> fine = interpolate_points(cage, options);
  const Points<Rational> limits = all_limits(fine);
  check_row(limits, 7, expected["limit_vertex"]);
  check_row(limits, edge_point(cage), expected["limit_edge_point"]);
  check_row(limits, face_point(cage), expected["limit_face_point"]);
}

}  // namespace

TEST_SUITE("operators") {
  TEST_CASE("masks of interpolation have the expected numbers for valence 3 to 12") {
    LimitMasks masks;
    RingMasks rings;
    for (int n = 3; n <= 12; ++n) {
      CAPTURE(n);
      const Values& expected = interpolation_values()["masks"][std::to_string(n)];
      CHECK(near(masks.tangents(n).edge, std::stod(expected["A_n"].get<std::string>())));
      CHECK(near(masks.tangents(n).eigenvalue, std::stod(expected["lambda2"].get<std::string>())));
      Fan fan{true, std::vector<int>(Mesh::i(n)), std::vector<int>(Mesh::i(n))};
      CHECK(near(rings.weights(fan)->squares, std::stod(expected["sum_a2_free"].get<std::string>())));
      CHECK(near(rings.weights(fan)->tied_squares, std::stod(expected["sum_a2_tied"].get<std::string>())));
      CHECK(Rational(1) - masks.inside(n).vertex == fraction_of(expected["contraction_local"]));
      // beta_n is the weight of e_j times n(n + 5); on a checkerboard the row gives its smallest eigenvalue
      const LimitRow row = limit_row_inside(Rational(7) / Rational(10), n);
      const Rational e = row.edge + row.face / Rational(2), f = row.face / Rational(4), v = row.own + Rational(n) * f;
      CHECK(e * Rational(n * (n + 5)) == fraction_of(expected["beta_n_lambda_7_10"]));
      CHECK(v - Rational(n) * e + Rational(n) * f == fraction_of(expected["min_eigenvalue_checkerboard_lambda_7_10"]));
    }
  }

  TEST_CASE("on the cube all steps have the expected exact points") {
    const Surface<Rational> cage = cube<Rational>();
    for (const auto& [key, expected] : interpolation_values()["cube_exact"].items()) {
      const std::string text = key;
      CAPTURE(text);
      PointOptions options;
      options.lambda = Rational::parse(text);
      const Surface<Rational> start = modified_step(cage, options.lambda);
      check_row(start.points, 7, expected["v1_init"]);
      check_row(start.points, edge_point(cage), expected["e1"]);
      check_row(start.points, face_point(cage), expected["f1"]);
      check_row(limit_points(start, 8), 7, expected["limit_of_v1_init"]);
      options.step = PointStep::local;
      for (int k = 1; k <= 3; ++k)
        check_row(progress_points(cage, options, k).control.points, 7, expected["v1_after_" + std::to_string(k)]);
      check_variant(cage, expected["local"], options);
      check_row(interpolate_points(cage, options).points, 7, expected["local"]["v1_star"]);
      options.step = PointStep::global;
      check_variant(cage, expected["global"], options);
      check_row(solve_for_limits(cage, options), 7, expected["global"]["W"]);
    }
  }

  TEST_CASE("on the displaced cube both steps have the expected exact points") {
    const Values& expected = interpolation_values()["hex_exact"];
    Surface<Rational> cage = cube<Rational>();
    const GoldenMesh mesh = golden_mesh("hex");
    for (Eigen::Index k = 0; k < cage.points.size(); ++k)
      cage.points.data()[k] = Rational::from_double(mesh.cage.points.data()[k]);
    PointOptions options;
    options.lambda = fraction_of(expected["lambda"]);
    check_rows(limit_points(modified_step(cage, options.lambda), 8), expected["limit_of_v1_init"]);
    check_rows(solve_for_limits(cage, options), expected["W"]);
    options.step = PointStep::local;
    check_rows(interpolate_points(cage, options).points, expected["v1_star"]);
  }

  TEST_CASE("two levels interpolate every expected mesh in every variant with the expected displacements") {
    for (const std::string& name : golden_names()) {
      CAPTURE(name);
      const GoldenMesh mesh = golden_mesh(name);
      const Values& expected = interpolation_values()["runs"][name];
      for (const Values& one : expected["two_level"]) check_run(mesh, one, expected["bound"]);
    }
  }

  TEST_CASE("the literal sweeps have the expected errors") {
    for (const std::string& name : golden_names()) {
      CAPTURE(name);
      const GoldenMesh mesh = golden_mesh(name);
      const Values& literal = interpolation_values()["runs"][name]["literal"];
      for (const auto& [key, expected] : literal.items()) {
        const std::string order = key;
        CAPTURE(order);
        SweepOptions options;
        options.order = order == "gauss" ? SweepOrder::gauss : SweepOrder::jacobi;
        const Sweeps swept = sweep(mesh.cage, mesh.normals, options);
        REQUIRE(swept.errors.size() == expected.size());
        for (std::size_t k = 0; k < expected.size(); ++k) {
          CAPTURE(k);
          CHECK(near(swept.errors[k].position, expected[k][0]));
          CHECK(near(swept.errors[k].normal, expected[k][1]));
        }
      }
    }
  }

  TEST_CASE("the shortest correction has the expected rank and length") {
    for (const std::string& name : golden_names()) {
      const Values& run = interpolation_values()["runs"][name];
      if (!run.contains("kkt_level1_from_global_0.7")) continue;
      CAPTURE(name);
      const GoldenMesh mesh = golden_mesh(name);
      const LeastCorrection least = least_correction(mesh.cage, mesh.normals);
      CHECK(least.rank == run["kkt_level1_from_global_0.7"]["rank"].get<int>());
      CHECK(least.rows == run["kkt_level1_from_global_0.7"]["rows"].get<int>());
      const double expected = run["kkt_level1_from_global_0.7"]["sum_squared_displacement"];
      CHECK(std::abs(least.squared_displacement - expected) <= 1e-6 * std::max(1.0, expected));
    }
  }

  TEST_CASE("the ring around one vertex has the expected points") {
    for (const auto& [key, expected] : interpolation_values()["samples"].items()) {
      const std::string name = key;
      CAPTURE(name);
      const GoldenMesh mesh = golden_mesh(name);
      InterpolateOptions options;
      options.step2 = NormalStep::free;
      const Surface<double> fine = interpolate(mesh.cage, mesh.normals, options).control;
      const int v = expected["vertex"];
      Fan before, after;  // both begin at the same half-edge of the cage
      collect_fan(*mesh.cage.mesh, v, before);
      collect_fan(*fine.mesh, v, after);
      const auto close = [&](int i, const Values& point) {
        for (int c = 0; c < 3; ++c) CHECK(near(fine.points(i, c), point[static_cast<std::size_t>(c)]));
      };
      close(v, expected["v2"]);
      const auto& cage = *mesh.cage.mesh;
      for (int h = cage.outgoing[Mesh::i(v)], j = 0; j < before.faces(); ++j, h = cage.around(h)) {
        for (const Values& one : expected["edge_points"])
          if (one["towards_vertex"] == before.e[Mesh::i(j)]) close(after.e[Mesh::i(j)], one["p"]);
        for (const Values& one : expected["face_points"])
          if (one["in_face"] == cage.face[Mesh::i(h)]) close(after.f[Mesh::i(j)], one["p"]);
      }
    }
  }

  TEST_CASE("the limit surfaces are as rough as expected") {
    // largest angle in degrees between limit normals at the ends of an edge, one refinement on: plain, local, global 0.4, 0.7, 1
    const std::map<std::string, std::array<double, 5>> table{{"cube", {73, 40, 13, 18, 24}},
                                                             {"cube_tilted", {82, 48, 17, 24, 31}},
                                                             {"hex", {0, 53, 46, 26, 34}},
                                                             {"torus_coarse", {144, 84, 24, 28, 38}},
                                                             {"cone", {0, 64, 43, 54, 60}}};
    for (const auto& [key, row] : table) {
      const std::string name = key;
      const GoldenMesh mesh = golden_mesh(name);
      for (std::size_t k = 0; k < row.size(); ++k) {
        if (row[k] == 0) continue;
        CAPTURE(name);
        CAPTURE(k);
        InterpolateOptions options;
        options.step1 = k == 0 ? PointStep::plain : k == 1 ? PointStep::local : PointStep::global;
        if (k >= 2) options.lambda = Rational(k == 2 ? 4 : k == 3 ? 7 : 10) / Rational(10);
        options.step2 = NormalStep::free;
        const Surface<double> fine = run(schemes::catmull_clark(), interpolate(mesh.cage, mesh.normals, options).control, 1);
        const Points<double> normals = limit(schemes::catmull_clark(), fine).normals;
        double rough = 0;
        for (const int h : fine.mesh->edge_half)
          rough = std::max(rough, angle_between(normals.row(fine.mesh->vertex[Mesh::i(h)]), normals.row(fine.mesh->tip(h))));
        CHECK(std::abs(rough * 180 / std::acos(-1.0) - row[k]) <= 0.5);
      }
    }
  }

  TEST_CASE("two levels interpolate real control meshes with the normals of their faces") {
    for (const auto& [key, steps] :
         std::vector<std::pair<std::string, int>>{{"spot_control", 1}, {"blub_control", 0}, {"blub_control", 1}}) {
      const std::string file = key;
      CAPTURE(file);
      Surface<double> cage = as_surface(read_obj_lines(UDCP_TEST_DATA "/../../examples/" + file + ".obj"));
      cage = run(schemes::catmull_clark(), cage, steps);
      const Interpolation result = interpolate(cage, area_normals(cage));
      CHECK(result.errors.position <= 1e-12);
      CHECK(result.errors.normal <= 1e-12);
      CHECK(result.errors.reversed == 0);
      CHECK(result.signed_volume > 0);
      const Limit limits = limit(schemes::catmull_clark(), result.control);
      CHECK((limits.points.topRows(cage.points.rows()) - cage.points).cwiseAbs().maxCoeff() < 1e-12);
    }
  }

  TEST_CASE("the side of a normal decides what projection and rotation give") {
    const GoldenMesh mesh = golden_mesh("cube");
    for (const Values& expected : interpolation_values()["sign_cases"]) {
      CAPTURE(expected.dump());
      Points<double> normals = mesh.normals;
      const int v = expected["vertex"];
      for (int c = 0; c < 3; ++c) normals(v, c) = expected["normal"][static_cast<std::size_t>(c)];
      for (const std::string mode : {"free", "rotate"}) {
        CAPTURE(mode);
        InterpolateOptions options;
        options.step1 = PointStep::local;
        options.step2 = normal_step(mode);
        const Interpolation result = interpolate(mesh.cage, normals, options);
        CHECK(near(result.vertices[Mesh::i(v)].length_ratio, expected[mode]["length_ratio"]));
        if (expected[mode]["angle_to_normal"].is_null()) continue;
        const Limit limits = limit(schemes::catmull_clark(), result.control);
        CHECK(near(angle_between(limits.normals.row(v), normals.row(v)), expected[mode]["angle_to_normal"]));
        CHECK(result.errors.reversed == (expected["case"] == "opposite" && mode == "free"));
      }
    }
  }
}
