// Offsets of Loop surfaces: errors, bounds, tolerance runs and fits against reference values, and the properties that they have.
#include "operators/methods/offset/offset.h"

#include <Eigen/Geometry>

#include "operators/methods/offset/offset_fit.h"
#include "operators/methods/offset/patch_bounds.h"
#include "tests/operators/offset_golden.h"
#include "tests/oracle/refusal.h"

namespace udcp {
namespace {

using namespace oracle;

OffsetResult offset_by(const Surface<double>& mesh, double distance, int rounds = 2) {
  OffsetOptions options;
  options.distance = distance;
  options.sample_rounds = rounds;
  return offset(mesh, options);
}

void check_close(double found, const OffsetJson& expected, double relative = 1e-8) {
  CHECK(std::abs(found - expected.get<double>()) <= relative * std::abs(expected.get<double>()) + 1e-13);
}

TEST_SUITE("operators") {
  TEST_CASE("sampled errors agree with the reference values") {
    for (const auto& test : offset_golden()["cases"]) {
      CAPTURE(test["mesh"].get<std::string>());
      CAPTURE(test["refine"].get<int>());
      const auto& expected = test["errors"];
      const OffsetErrors errors = offset_by(case_mesh(test), decimal(test["dis"]), expected["k"].get<int>()).errors;
      check_close(errors.eps, expected["eps"]);
      check_close(errors.full, expected["E"]);
      check_close(errors.normal, expected["En"]);
      check_close(errors.slip, expected["Et"]);
      check_close(errors.rms, expected["rmsE"]);
      check_close(errors.least_eps, expected["eps_min"]);
      check_close(errors.greatest_eps, expected["eps_max"]);
    }
  }

  TEST_CASE("upper bounds agree with the reference values and lie above the samples") {
    for (const auto& test : offset_golden()["cases"]) {
      if (!test.contains("bounds")) continue;
      CAPTURE(test["mesh"].get<std::string>());
      const double distance = decimal(test["dis"]);
      const OffsetResult result = offset_by(case_mesh(test), distance, 3);
      for (const OffsetBound kind : {OffsetBound::aabb, OffsetBound::hull, OffsetBound::bernstein}) {
        const auto& expected = test["bounds"][std::string(name_of(kind))];
        for (std::size_t m = 0; m < expected.size(); ++m) {
          CAPTURE(name_of(kind));
          CAPTURE(m);
          const BoundedError bound = bound_offset_error(result.base, result.d, distance, kind, static_cast<int>(m));
          check_close(bound.bound, expected[m]);
          CHECK(bound.bound >= result.errors.eps);
        }
      }
    }
  }

  TEST_CASE("certified errors enclose the samples closely") {
    for (const auto& test : offset_golden()["cases"]) {
      if (!test.contains("certified") || (test["vertices"] > 20 && test["vertices"] != 72)) continue;  // others take seconds
      CAPTURE(test["mesh"].get<std::string>());
      CAPTURE(test["refine"].get<int>());
      const double distance = decimal(test["dis"]);
      const OffsetResult result = offset_by(case_mesh(test), distance, 3);
      const CertifiedErrors certified = certified_offset_errors(result.base, result.d, distance);
      for (const auto& [key, found, sampled] :
           {std::tuple{"eps", certified.eps, result.errors.eps}, std::tuple{"E", certified.full, result.errors.full}}) {
        const std::string name = key;
        CAPTURE(name);
        CHECK(found.upper >= sampled);
        CHECK(found.upper <= 1.2 * found.lower);
        CHECK(found.upper >= test["certified"][name]["lower"].get<double>());
        CHECK(found.lower <= test["certified"][name]["upper"].get<double>());
      }
    }
  }

  TEST_CASE("Jacobian bounds of characteristic rings agree with the reference values") {
    for (const auto& row : offset_golden()["characteristic"]) {
      const int n = row["N"].get<int>();
      CAPTURE(n);
      const CornerAnalysis<double> corner(n);
      // Both are lower bounds of the same minimum; for valence 3 to 5 the reference took smaller pieces.
      CHECK(corner.jacobian() <= row["jacobian_lower_bound"].get<double>() + 1e-12);
      CHECK(corner.jacobian() >= (n <= 5 ? 0.93 : 1 - 1e-12) * row["jacobian_lower_bound"].get<double>());
      CHECK(corner.rings() >= 5);
      CHECK(corner.rings() <= 40);
      const CornerAnalysis<Interval> enclosed(n);
      CHECK(std::abs(enclosed.jacobian().midpoint() - corner.jacobian()) <= 1e-12);
    }
  }

  TEST_CASE("tolerance runs agree with the reference values") {
    for (const auto& test : offset_golden()["tolerance_runs"]) {
      CAPTURE(test["mesh"].get<std::string>());
      OffsetOptions options;
      options.distance = decimal(test["dis"]);
      options.tolerance = test["tol"].get<double>();
      options.max_level = test["max_level"].get<int>();
      options.sample_rounds = test["k"].get<int>();
      options.local = test["local"].get<bool>();
      options.pad = test["pad"].get<int>();
      CAPTURE(options.local);
      const OffsetResult result = offset(case_mesh(test), options);
      const auto& log = test["log_level_vertices_unknowns_eps"];
      REQUIRE(result.log.size() == log.size());
      for (std::size_t k = 0; k < log.size(); ++k) {
        CHECK(result.log[k].level == log[k][0].get<int>());
        CHECK(result.log[k].vertices == log[k][1].get<int>());
        CHECK(result.log[k].unknowns == log[k][2].get<int>());
        check_close(result.log[k].eps, log[k][3]);
      }
      CHECK(result.errors.eps <= *options.tolerance);
      const double bound = bound_offset_error(result.base, result.d, options.distance, OffsetBound::bernstein, 1).bound;
      CHECK(bound >= result.errors.eps);
    }
  }

  TEST_CASE("fits agree with the reference values") {
    for (const auto& test : offset_golden()["cases"]) {
      if (!test.contains("fit")) continue;
      CAPTURE(test["mesh"].get<std::string>());
      const Surface<double> mesh = case_mesh(test);
      const double distance = decimal(test["dis"]);
      double best = offset_by(mesh, distance, 3).errors.eps;
      for (const auto& fit : test["fit"]) {
        const double alpha = fit["alpha"].get<double>();
        CAPTURE(alpha);
        const Points<double> d = fit_offset(mesh, distance, alpha);
        const Points<double> head = decimal_rows(fit["d_head"]);
        CHECK(largest_difference(d.topRows(head.rows()), head) <= 1e-7 * std::abs(distance));
        check_close(d.squaredNorm(), fit["d_sum_of_squares"], 1e-7);
        const OffsetErrors errors = offset_errors(sample_offset(mesh, d, 3), distance);
        check_close(errors.eps, fit["eps"], 1e-7);
        check_close(errors.full, fit["E"], 1e-7);
        check_close(errors.normal, fit["En"], 1e-7);
        check_close(errors.slip, fit["Et"], 1e-7);
        if (alpha < 1) best = std::min(best, errors.eps);
      }
      OffsetOptions options;
      options.distance = distance;
      options.fit = true;
      options.sample_rounds = 3;
      CHECK(offset(mesh, options).errors.eps == doctest::Approx(best).epsilon(1e-9));
    }
  }

  TEST_CASE("offsets are linear in the distance and move with the surface") {
    for (const char* name : {"spot188.obj", "cap.obj"}) {
      CAPTURE(name);
      const Surface<double> mesh = offset_mesh(name);
      const OffsetResult one = offset_by(mesh, 0.02);
      CHECK(largest_difference(offset_by(mesh, -0.05).d, -2.5 * one.d) <= 1e-14);
      CHECK(offset_by(mesh, 0).surface.points == mesh.points);
      const double scale = 3;
      const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, -2) / 3).toRotationMatrix();
      Surface<double> moved = mesh;
      moved.points = (scale * mesh.points * turn.transpose()).rowwise() + Eigen::RowVector3d(1, -2, 0.5);
      CHECK(largest_difference(offset_by(moved, 0.06).d, scale * one.d * turn.transpose()) <= 1e-12);
      std::vector<std::vector<int>> reversed;
      for (int f = 0; f < mesh.mesh->faces(); ++f)
        reversed.push_back({mesh.mesh->corners(f)[0], mesh.mesh->corners(f)[2], mesh.mesh->corners(f)[1]});
      Surface<double> turned = mesh;
      turned.mesh = std::make_shared<const Mesh>(make_mesh(mesh.mesh->vertices(), reversed));
      CHECK(largest_difference(offset_by(turned, 0.02).d, -one.d) <= 1e-13);
    }
  }

  TEST_CASE("the offset of a plane is exact") {
    const OffsetResult result = offset_by(offset_mesh("plane.obj"), 0.5);
    const Points<double> height = Points<double>(result.base.points.rowwise() + 0.5 * result.d.row(0).normalized());
    CHECK(largest_difference(result.surface.points, height) <= 1e-14);
    CHECK(result.errors.full <= 1e-14);
  }

  TEST_CASE("near-spheres stay between the radii that they must") {
    for (const auto& test : offset_golden()["cases"]) {
      if (!test.contains("sphere")) continue;
      CAPTURE(test["mesh"].get<std::string>());
      const auto& sphere = test["sphere"];
      const double distance = decimal(test["dis"]);
      const OffsetResult result = offset_by(case_mesh(test), distance, sphere["k"].get<int>());
      const OffsetSamples samples = sample_offset(result.base, result.d, sphere["k"].get<int>());
      const Eigen::VectorXd s = samples.position.rowwise().norm(), f = (samples.position + samples.delta).rowwise().norm();
      check_close(s.minCoeff(), sphere["S_radius"][0]);
      check_close(s.maxCoeff(), sphere["S_radius"][1]);
      check_close(f.minCoeff(), sphere["F_radius"][0]);
      check_close(f.maxCoeff(), sphere["F_radius"][1]);
      const double e = result.errors.eps + 1e-12;
      CHECK(f.maxCoeff() <= s.maxCoeff() + distance + e);
    }
  }

  TEST_CASE("the error of the distance to the surface is as measured") {
    const auto foot = [](const char* name, int refine, double distance) {
      const OffsetResult result = offset_by(offset_mesh(name, refine), distance, 3);
      return foot_error(sample_offset(result.base, result.d, 3), distance);
    };
    CHECK(foot("icosa.obj", 1, 0.5) == doctest::Approx(4.6e-4).epsilon(0.02));
    CHECK(foot("horseshoe.obj", 0, 0.25) == doctest::Approx(2.6e-2).epsilon(0.02));
  }

  TEST_CASE("a shell of an open mesh is closed and has the volume of its thickness") {
    const Surface<double> plane = offset_mesh("plane.obj");
    const Surface<double> body = shell(offset_by(plane, 0.25).surface, offset_by(plane, -0.25).surface);
    double volume = 0, area = 0;
    for (int h = 0; h < body.mesh->half_edges(); ++h) CHECK(body.mesh->twin[static_cast<std::size_t>(h)] >= 0);
    const auto corner = [](const Surface<double>& s, int f, int k) {
      return Eigen::Vector3d(s.points.row(s.mesh->corners(f)[static_cast<std::size_t>(k)]).transpose());
    };
    for (int f = 0; f < body.mesh->faces(); ++f)
      volume += corner(body, f, 0).dot(corner(body, f, 1).cross(corner(body, f, 2))) / 6;
    for (int f = 0; f < plane.mesh->faces(); ++f)
      area += (corner(plane, f, 1) - corner(plane, f, 0)).cross(corner(plane, f, 2) - corner(plane, f, 0)).norm() / 2;
    CHECK(volume == doctest::Approx(0.5 * area).epsilon(1e-12));
    const Surface<double> ball =
        shell(offset_by(offset_mesh("icosa.obj"), 0.2).surface, offset_by(offset_mesh("icosa.obj"), -0.2).surface);
    CHECK(ball.mesh->vertices() == 24);
    CHECK(ball.mesh->faces() == 40);
  }

  TEST_CASE("what cannot be offset is refused by name") {
    const Surface<double> mesh = offset_mesh("cube36.obj");
    const auto with = [&](auto change) {
      OffsetOptions options;
      options.distance = 1;
      change(options);
      return refusal([&] { offset(mesh, options); });
    };
    CHECK(with([](OffsetOptions& o) { o.distance = std::nan(""); }) == "E_NOT_FINITE: the distance of the offset is not finite");
    CHECK(with([](OffsetOptions& o) { o.tolerance = 0; }) == "E_TOLERANCE: the tolerance must be a positive number, not 0");
    for (const char* text : {"1e+101", "-1e-101"})
      CHECK(with([&](OffsetOptions& o) { o.distance = std::stod(text); }) ==
            std::string("E_OPTION: distances of offsets are 0 or from 1e-100 to 1e100 in modulus, not ") + text);
    CHECK(with([](OffsetOptions& o) { o.max_level = 13; }) == "E_OPTION: max_level must be from 0 to 12, not 13");
    CHECK(with([](OffsetOptions& o) { o.sample_rounds = 7; }) == "E_OPTION: errors are sampled after 0 to 6 rounds, not 7");
    CHECK(with([](OffsetOptions& o) { o.pad = -1; }) == "E_OPTION: pad must be from 0 to 100, not -1");
    CHECK(with([](OffsetOptions& o) { o.control.max_faces = 100; }).substr(0, 12) == "E_MAX_FACES:");
    std::atomic<bool> stop = true;
    CHECK(with([&](OffsetOptions& o) { o.control.stop = &stop; }) == "E_INTERRUPTED: interrupted");
  }

  TEST_CASE("a tolerance out of reach gives the best result with the error") {
    OffsetOptions options;
    options.distance = 1;
    options.tolerance = 1e-4;
    options.max_level = 1;
    try {
      offset(offset_mesh("cube36.obj"), options);
      FAIL("accepted");
    } catch (const ToleranceError& error) {
      CHECK(error.code == "E_OFFSET_LEVELS");
      CHECK(std::string(error.what()).substr(0, 40) == "after 1 refinements the error is 0.03045");
      CHECK(error.best->log.back().level == 1);
      CHECK(error.best->surface.mesh->vertices() == 26);
    }
    // Twelve faces, sampled after two rounds: 192, and 768 after a refinement.
    options.max_level = 5;
    options.control.max_faces = 767;
    try {
      offset(offset_mesh("cube36.obj"), options);
      FAIL("accepted");
    } catch (const ToleranceError& error) {
      CHECK(error.best->log.size() == 1);
      CHECK(std::string(error.what()).find("; one more would be sampled on 768 faces, and the limit is 767") !=
            std::string::npos);
    }
  }
}

}  // namespace
}  // namespace udcp
