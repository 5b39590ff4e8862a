// Patches and evaluation of Loop surfaces against reference values, refinement and exact identities.
#include "operators/methods/offset/loop_patch.h"

#include "operators/methods/offset/loop_evaluation.h"
#include "tests/operators/offset_golden.h"
#include "tests/oracle/refusal.h"

namespace udcp {
namespace {

using namespace oracle;

TEST_SUITE("operators") {
  TEST_CASE("the Bezier points of the box spline come out of the word as published") {
    const auto& table = offset_golden()["bezier_times_24"];
    const Points<Rational>& matrix = box_spline_bezier();
    for (std::size_t r = 0; r < 15; ++r) {
      const int i = table["rows_ijk"][r][0].get<int>(), j = table["rows_ijk"][r][1].get<int>();
      for (std::size_t c = 0; c < 12; ++c)
        CHECK(matrix(bernstein_index(4, i, j), static_cast<Eigen::Index>(c)) ==
              Rational(table["matrix"][r][c].get<int>()) / Rational(24));
    }
  }

  TEST_CASE("one step of a regular patch is the restriction of its Bezier form") {
    const PatchStep<Rational> step = patch_step<Rational>(6);
    Points<Rational> net(12, 1);
    for (int i = 0; i < 12; ++i) net(i, 0) = Rational(i * i % 7 - 3);
    const Rational half = Rational(1) / Rational(2), a = Rational(1) / Rational(5), b = Rational(2) / Rational(7);
    // The children at c, r_0, r_1 and in the middle, at the point (a, b) of each.
    const auto at = [&](const Points<Rational>& rows) { return evaluate_regular<Rational>(rows * net, a, b)(0, 0); };
    const auto parent = [&](const Rational& v, const Rational& w) { return evaluate_regular(net, v, w)(0, 0); };
    CHECK(at(step.inner) == parent(half * a, half * b));
    CHECK(at(step.regular[0]) == parent(half + half * a, half * b));
    CHECK(at(step.regular[1]) == parent(half * a, half + half * b));
    CHECK(at(step.regular[2]) == parent(half * (Rational(1) - a), half * (Rational(1) - b)));
  }

  TEST_CASE("patches of all valences agree with the reference values") {
    for (const auto& test : offset_golden()["patch_eval"]) {
      const int n = test["N"].get<int>();
      const Points<double> net = decimal_rows(test["control_points"]);
      const PatchStep<double> step = patch_step<double>(n);
      for (const auto& point : test["points"]) {
        CAPTURE(n);
        CAPTURE(point["v"].get<std::string>());
        const Points<double> values = evaluate_patch(net, step, decimal(point["v"]), decimal(point["w"]));
        REQUIRE(values.rows() == 6);
        const double bound = 5e-15 / (decimal(point["v"]) + decimal(point["w"]));  // 2^depth times the rounding of positions
        for (Eigen::Index c = 0; c < 3; ++c) {
          const auto column = static_cast<std::size_t>(c);
          CHECK(std::abs(values(0, c) - decimal(point["position"][column])) <= 1e-14);
          CHECK(std::abs(values(1, c) - decimal(point["dv"][column])) <= bound);
          CHECK(std::abs(values(2, c) - decimal(point["dw"][column])) <= bound);
        }
        if (!point.contains("position_exact")) continue;
        Points<Rational> exact_net(net.rows(), 3);
        for (Eigen::Index k = 0; k < net.size(); ++k) exact_net.data()[k] = Rational::from_double(net.data()[k]);
        const Points<Rational> exact =
            evaluate_patch<Rational>(exact_net, patch_step<Rational>(n), Rational::parse(point["v"].get<std::string>()),
                                     Rational::parse(point["w"].get<std::string>()));
        for (Eigen::Index c = 0; c < 3; ++c)
          CHECK(exact(0, c) == Rational::parse(point["position_exact"][static_cast<std::size_t>(c)].get<std::string>()));
      }
    }
  }

  TEST_CASE("evaluation at dyadic points equals refinement and limit") {
    for (const char* name :
         {"icosa.obj", "tetra.obj", "eight.obj", "cap.obj", "cap_corners.obj", "openfan5.obj", "triangle.obj"}) {
      CAPTURE(name);
      const Surface<double> mesh = offset_mesh(name), fine = run(schemes::loop(), mesh, 3);
      const Points<double> points = loop_limit(fine).points(fine.points), normals = limit_normals(loop_limit(fine), fine.points);
      const LoopEvaluation evaluation(mesh.mesh, mesh.tags);
      // Corner k of child g of face f by three digits of g in base 4: (a, ab, ca), (b, bc, ab), (c, ca, bc), (ab, bc, ca).
      for (int f = 0; f < mesh.mesh->faces(); ++f) {
        for (int g = 0; g < 64; g += 7) {
          std::array<std::array<double, 2>, 3> corner{{{0, 0}, {1, 0}, {0, 1}}};  // (v, w)
          for (const int digit : {g / 16, g / 4 % 4, g % 4}) {
            const auto [a, b, c] = corner;
            const auto mid = [](const auto& x, const auto& y) {
              return std::array<double, 2>{(x[0] + y[0]) / 2, (x[1] + y[1]) / 2};
            };
            const auto ab = mid(a, b), bc = mid(b, c), ca = mid(c, a);
            if (digit == 0) corner = {a, ab, ca};
            if (digit == 1) corner = {b, bc, ab};
            if (digit == 2) corner = {c, ca, bc};
            if (digit == 3) corner = {ab, bc, ca};
          }
          for (int k = 0; k < 3; ++k) {
            const int v = fine.mesh->corners(64 * f + g)[static_cast<std::size_t>(k)];
            const auto& place = corner[static_cast<std::size_t>(k)];
            const LoopPoint point = evaluation.at(mesh.points, f, place[0], place[1]);
            CHECK(largest_difference(point.values.row(0), points.row(v)) <= 1e-14);
            if (!point.has_derivatives) continue;
            CHECK(largest_difference(curvature(point.values).normal, normals.row(v)) <= 1e-12);
          }
        }
      }
    }
  }

  TEST_CASE("a valence above the matrices kept is evaluated by refinement") {
    std::vector<std::vector<int>> faces;
    const int n = 40;
    Surface<double> bipyramid{nullptr, Points<double>(n + 2, 3), {}, {}};
    bipyramid.points.row(0) << 0, 0, 1;
    bipyramid.points.row(n + 1) << 0, 0, -1;
    for (int k = 0; k < n; ++k) {
      bipyramid.points.row(1 + k) << std::cos(2 * 3.14159 * k / n), std::sin(2 * 3.14159 * k / n), 0.1;
      faces.push_back({0, 1 + k, 1 + (k + 1) % n});
      faces.push_back({n + 1, 1 + (k + 1) % n, 1 + k});
    }
    bipyramid.mesh = std::make_shared<const Mesh>(make_mesh(n + 2, faces));
    const Surface<double> fine = run(schemes::loop(), bipyramid, 2);
    const Points<double> points = loop_limit(fine).points(fine.points);
    const LoopEvaluation evaluation(bipyramid.mesh, {});
    CHECK(largest_difference(evaluation.at(bipyramid.points, 0, 0, 0).values.row(0), points.row(0)) <= 1e-14);
    const int first_edge = bipyramid.mesh->vertices();  // its point lies halfway along the first edge of face 0
    CHECK(largest_difference(evaluation.at(bipyramid.points, 0, 0.5, 0).values.row(0), points.row(first_edge)) <= 1e-14);
  }

  TEST_CASE("curvatures agree with the reference values") {
    for (const auto& test : offset_golden()["curvature"]) {
      CAPTURE(test["mesh"].get<std::string>());
      CAPTURE(test["v"].get<double>());
      const Surface<double> mesh = case_mesh(test);
      const LoopPoint point = LoopEvaluation(mesh.mesh, mesh.tags)
                                  .at(mesh.points, test["face"].get<int>(), test["v"].get<double>(), test["w"].get<double>());
      REQUIRE(point.has_derivatives);
      const Curvature k = curvature(point.values);
      CHECK(std::abs(k.least - test["k1"].get<double>()) <= 1e-8);
      CHECK(std::abs(k.greatest - test["k2"].get<double>()) <= 1e-8);
      for (Eigen::Index c = 0; c < 3; ++c) {
        CHECK(std::abs(k.normal[c] - test["normal"][static_cast<std::size_t>(c)].get<double>()) <= 1e-12);
        CHECK(std::abs(k.position[c] - test["position"][static_cast<std::size_t>(c)].get<double>()) <= 1e-13);
      }
    }
  }

  TEST_CASE("derivatives agree with differences of positions") {
    for (const char* name : {"spot188.obj", "cap_corners.obj"}) {
      const Surface<double> mesh = offset_mesh(name);
      const LoopEvaluation evaluation(mesh.mesh, mesh.tags);
      const double h = 1e-4;
      for (int f = 0; f < mesh.mesh->faces(); f += 5) {
        CAPTURE(f);
        const double v = 0.31, w = 0.27;
        const auto at = [&](double x, double y) { return evaluation.at(mesh.points, f, x, y).values; };
        const Points<double> values = at(v, w);
        REQUIRE(values.rows() == 6);
        CHECK(largest_difference((at(v + h, w).row(0) - at(v - h, w).row(0)) / (2 * h), values.row(1)) <= 1e-6);
        CHECK(largest_difference((at(v, w + h).row(0) - at(v, w - h).row(0)) / (2 * h), values.row(2)) <= 1e-6);
        CHECK(largest_difference((at(v + h, w).row(1) - at(v - h, w).row(1)) / (2 * h), values.row(3)) <= 1e-4);
        CHECK(largest_difference((at(v, w + h).row(1) - at(v, w - h).row(1)) / (2 * h), values.row(4)) <= 1e-4);
        CHECK(largest_difference((at(v, w + h).row(2) - at(v, w - h).row(2)) / (2 * h), values.row(5)) <= 1e-4);
      }
    }
  }

  TEST_CASE("parameters and faces out of range are refused") {
    const Surface<double> mesh = offset_mesh("octa.obj");
    const LoopEvaluation evaluation(mesh.mesh, mesh.tags);
    CHECK(refusal([&] { (void)evaluation.at(mesh.points, 8, 0, 0); }) == "E_INDEX: there is no face 8");
    CHECK(refusal([&] { (void)evaluation.at(mesh.points, 0, 0.75, 0.5); }) ==
          "E_PARAMETER_RANGE: the point (0.75, 0.5) is not in the triangle v >= 0, w >= 0, v + w <= 1");
    CHECK(refusal([] { patch_step<double>(65); }) ==
          "E_TOO_LARGE: matrices of patches are made for valences from 3 to 64, not 65");
    CHECK(refusal([] { curvature(Points<double>::Zero(6, 3)); }) == "E_ZERO_NORMAL: the surface has no normal at this point");
  }
}

}  // namespace
}  // namespace udcp
