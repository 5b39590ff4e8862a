// The system of offsets and its solvers: reference values, spectra, contraction, and the theorem that it is positive definite.
#include "operators/methods/offset/offset_system.h"

#include <Eigen/Eigenvalues>
#include <map>
#include <set>

#include "operators/methods/offset/dense_solve.h"
#include "tests/operators/offset_golden.h"
#include "tests/oracle/refusal.h"

namespace udcp {
namespace {

using namespace oracle;

constexpr std::array iterative{OffsetSolver::edge, OffsetSolver::star, OffsetSolver::gauss_seidel, OffsetSolver::richardson,
                               OffsetSolver::conjugate_gradients};

Points<double> wanted(const LoopLimit<double>& limit, const Points<double>& points, double distance) {
  return distance * limit_normals(limit, points);
}

SolveOptions with(OffsetSolver solver, double tolerance = 1e-13) {
  SolveOptions options;
  options.solver = solver;
  options.tolerance = tolerance;
  return options;
}

std::string key_of(OffsetSolver solver) {
  switch (solver) {
    case OffsetSolver::edge:
      return "edge";
    case OffsetSolver::star:
      return "star";
    case OffsetSolver::gauss_seidel:
      return "gs";
    case OffsetSolver::richardson:
      return "richardson";
    default:
      return "cg";
  }
}

/// C of d <- C d + ..., dense.
Eigen::MatrixXd iteration_matrix(const OffsetSystem& system, bool star) {
  const EdgeIteration rules = edge_iteration(system, star);
  Eigen::MatrixXd c = Eigen::MatrixXd::Zero(system.size(), system.size());
  for (std::size_t i = 0; i < static_cast<std::size_t>(system.size()); ++i)
    for (int k = rules.begin_old[i]; k < rules.begin_old[i + 1]; ++k)
      c(static_cast<Eigen::Index>(i), rules.old_index[static_cast<std::size_t>(k)]) +=
          rules.old_value[static_cast<std::size_t>(k)];
  return c;
}

double spectral_radius(const Eigen::MatrixXd& a) {
  return Eigen::EigenSolver<Eigen::MatrixXd>(a, false).eigenvalues().cwiseAbs().maxCoeff();
}

Eigen::MatrixXd stiffness(const OffsetSystem& system) {
  Eigen::MatrixXd k = Eigen::MatrixXd::Zero(system.size(), system.size());
  for (int i = 0; i < system.size(); ++i) {
    k(i, i) = system.weight[static_cast<std::size_t>(i)];
    for (const int j : system.around(i)) k(i, j) += 1;
  }
  return k;
}

TEST_SUITE("operators") {
  TEST_CASE("control vectors of offsets agree with the reference values") {
    for (const auto& test : offset_golden()["cases"]) {
      CAPTURE(test["mesh"].get<std::string>());
      CAPTURE(test["refine"].get<int>());
      const double distance = decimal(test["dis"]);
      const Surface<double> mesh = case_mesh(test);
      const LoopLimit<double> limit = loop_limit(mesh);
      const OffsetSolution solution = solve_offset(limit, wanted(limit, mesh.points, distance));
      CHECK(solution.residual <= 1e-14);
      const Points<double> expected = decimal_rows(test["d"]);
      CHECK(largest_difference(rows_at(solution.d, reference_vertices(test), expected.rows()), expected) <=
            1e-12 * std::abs(distance));
      CHECK(std::abs(solution.d.squaredNorm() - decimal(test["d_sum_of_squares"])) <= 1e-11 * solution.d.squaredNorm());
      CHECK(std::abs(std::sqrt(solution.d.rowwise().squaredNorm().maxCoeff()) - decimal(test["d_max_norm"])) <= 1e-12);
    }
  }

  TEST_CASE("all solvers find the same control vectors") {
    for (const auto& test : offset_golden()["cases"]) {
      const Surface<double> mesh = case_mesh(test);
      if (mesh.mesh->vertices() > 300 || test["refine"] == 0) continue;
      CAPTURE(test["mesh"].get<std::string>());
      const LoopLimit<double> limit = loop_limit(mesh);
      const Points<double> right = wanted(limit, mesh.points, decimal(test["dis"]));
      const Points<double> direct = solve_offset(limit, right, with(OffsetSolver::direct)).d;
      for (const OffsetSolver solver : iterative) {
        CAPTURE(name_of(solver));
        const OffsetSolution solution = solve_offset(limit, right, with(solver));
        CHECK(solution.residual <= 1.01e-13);
        CHECK(largest_difference(solution.d, direct) <= 1e-10 * std::abs(decimal(test["dis"])));
      }
    }
  }

  TEST_CASE("solvers need as many iterations as the reference") {
    for (const auto& test : offset_golden()["cases"]) {
      if (!test.contains("iterations")) continue;
      CAPTURE(test["mesh"].get<std::string>());
      CAPTURE(test["refine"].get<int>());
      const Surface<double> mesh = case_mesh(test);
      const LoopLimit<double> limit = loop_limit(mesh);
      const Points<double> right = wanted(limit, mesh.points, decimal(test["dis"]));
      for (const OffsetSolver solver : iterative) {
        const auto& expected = test["iterations"][key_of(solver)];
        CAPTURE(key_of(solver));
        if (!expected.is_array()) {
          CHECK(expected == "NotContractive");
          CHECK(refusal([&] { solve_offset(limit, right, with(solver)); }).substr(0, 18) == "E_NOT_CONTRACTIVE:");
          continue;
        }
        for (std::size_t k = 0; k < expected.size(); ++k) {
          const double tolerance = test["iterations"]["tolerances"][k].get<double>();
          const int count = solve_offset(limit, right, with(solver, tolerance)).iterations;
          CHECK(std::abs(count - expected[k].get<int>()) <= 1);
        }
      }
    }
  }

  TEST_CASE("spectra agree with the reference values and with the theorem") {
    for (const auto& test : offset_golden()["cases"]) {
      if (!test.contains("spectra")) continue;
      const Surface<double> mesh = case_mesh(test);
      if (mesh.mesh->vertices() > 70) continue;  // larger ones take seconds
      CAPTURE(test["mesh"].get<std::string>());
      CAPTURE(test["refine"].get<int>());
      const auto& spectra = test["spectra"];
      const OffsetSystem system = offset_system(loop_limit(mesh));
      const Eigen::MatrixXd k = stiffness(system);
      Eigen::VectorXd weight(system.size()), scale(system.size());
      for (int i = 0; i < system.size(); ++i) {
        weight[i] = system.weight[static_cast<std::size_t>(i)];
        scale[i] = weight[i] + system.valence[static_cast<std::size_t>(i)];
      }
      const Eigen::VectorXd root = scale.cwiseSqrt().cwiseInverse();
      const Eigen::VectorXd values =
          Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(root.asDiagonal() * k * root.asDiagonal()).eigenvalues();
      CHECK(std::abs(values.minCoeff() - spectra["lambda_min"].get<double>()) <= 1e-6);
      CHECK(std::abs(values.maxCoeff() - spectra["lambda_max"].get<double>()) <= 1e-6);
      CHECK(std::abs(least_eigenvalue_bound(system) - spectra["lambda_min_bound"].get<double>()) <= 1e-6);
      CHECK(values.minCoeff() >= least_eigenvalue_bound(system) - 1e-12);
      CHECK(values.maxCoeff() <= 1 + 1e-12);
      const Eigen::MatrixXd off = k - Eigen::MatrixXd(k.diagonal().asDiagonal());
      CHECK(std::abs(spectral_radius(k.diagonal().cwiseInverse().asDiagonal() * off) - spectra["rho_jacobi"].get<double>()) <=
            1e-6);
      const Eigen::MatrixXd lower = k.triangularView<Eigen::Lower>();
      CHECK(std::abs(spectral_radius(lower.triangularView<Eigen::Lower>().solve(lower - k)) -
                     spectra["rho_gauss_seidel"].get<double>()) <= 1e-4);  // a defective eigenvalue on cube36: cube root of 1e-15
      for (const bool star : {false, true}) {
        const Eigen::MatrixXd c = iteration_matrix(system, star);
        const auto& radius = spectra[star ? "rho_star" : "rho_edge"];
        if (radius.is_number()) CHECK(std::abs(spectral_radius(c) - radius.get<double>()) <= 1e-6);
        CHECK(std::abs(c.cwiseAbs().rowwise().sum().maxCoeff() -
                       spectra[star ? "Lambda_star_max" : "Lambda_edge_max"].get<double>()) <= 1e-6);
      }
    }
  }

  TEST_CASE("rows of the edge iteration agree with the reference values") {
    for (const auto& test : offset_golden()["edge_rows"]) {
      const Surface<double> mesh = case_mesh(test);
      const OffsetSystem system = offset_system(loop_limit(mesh));
      const int i = test["vertex"].get<int>();
      CAPTURE(test["mesh"].get<std::string>());
      CAPTURE(i);
      for (const bool star : {false, true}) {
        const auto& expected = test[star ? "star" : "paper"];
        const EdgeIteration rules = edge_iteration(system, star);
        const auto row = static_cast<std::size_t>(i);
        CHECK(std::abs(rules.lambda[row] - expected["Lambda"].get<double>()) <= 1e-14);
        CHECK(rules.begin_old[row + 1] - rules.begin_old[row] == static_cast<int>(expected["C"].size()));
        for (int k = rules.begin_old[row]; k < rules.begin_old[row + 1]; ++k) {
          const auto at = static_cast<std::size_t>(k);
          CHECK(std::abs(rules.old_value[at] - expected["C"][std::to_string(rules.old_index[at])].get<double>()) <= 1e-14);
        }
        CHECK(rules.begin_right[row + 1] - rules.begin_right[row] == static_cast<int>(expected["G"].size()));
        for (int k = rules.begin_right[row]; k < rules.begin_right[row + 1]; ++k) {
          const auto at = static_cast<std::size_t>(k);
          CHECK(std::abs(rules.right_value[at] - expected["G"][std::to_string(rules.right_index[at])].get<double>()) <= 1e-14);
        }
      }
    }
  }

  TEST_CASE("contraction bounds of pairs and stars agree with the reference values") {
    for (const auto& row : offset_golden()["Lambda_pair_table"])
      CHECK(std::abs(pair_contraction(row[0].get<int>(), row[1].get<int>()) - row[2].get<double>()) <= 1e-14);
    for (const auto& row : offset_golden()["masks"]) {
      const int n = row["N"].get<int>();
      CHECK(std::abs(star_contraction(n) - decimal(row["Lambda_star"])) <= 1e-14);
      CHECK(std::abs(pair_contraction(n, 6) - decimal(row["Lambda_pair_printed"])) <= 1e-14);
    }
    CHECK(star_contraction(3) == doctest::Approx(9.0 / 13).epsilon(1e-15));
    CHECK(star_contraction(4) == doctest::Approx(93.0 / 161).epsilon(1e-15));
    for (int n = 5; n <= 50; ++n)
      CHECK(pair_contraction(n, 6) == doctest::Approx((6 * n - 5) / (6 * loop_weight<double>(n) - 1)).epsilon(1e-14));
  }

  TEST_CASE("the error of the edge iteration shrinks by its contraction bound at least") {
    for (const char* name : {"spot188.obj", "octa.obj", "eight.obj", "strip9.obj"}) {
      const Surface<double> mesh = offset_mesh(name, 1);
      const LoopLimit<double> limit = loop_limit(mesh);
      const Points<double> right = wanted(limit, mesh.points, 1);
      const Points<double> exact = solve_offset(limit, right).d;
      for (const OffsetSolver solver : {OffsetSolver::edge, OffsetSolver::star}) {
        double before = 0;
        for (double tolerance = 0.3; tolerance > 1e-6; tolerance /= 1.3) {
          const OffsetSolution now = solve_offset(limit, right, with(solver, tolerance));
          const double error = largest_difference(now.d, exact);
          const double start = before;
          before = error;
          CHECK(now.contraction < 1);
          CHECK(error <= std::pow(now.contraction, now.iterations) * largest_difference(right, exact) + 1e-12);
          if (start > 0) CHECK(error <= start + 1e-12);
        }
      }
    }
  }

  TEST_CASE("control vectors of platonic nets are the known multiples of their vertices") {
    const double golden_ratio = (361 + 12 * std::sqrt(5.0)) / (156 + 53 * std::sqrt(5.0));
    for (const auto& [name, scale] :
         std::map<std::string, double>{{"tetra.obj", 5}, {"octa.obj", 55.0 / 24}, {"icosa.obj", golden_ratio}}) {
      const Surface<double> mesh = offset_mesh(name);
      const LoopLimit<double> limit = loop_limit(mesh);
      const Points<double> d = solve_offset(limit, wanted(limit, mesh.points, 0.25)).d;
      const Points<double> expected = 0.25 * scale * mesh.points.rowwise().normalized();
      CHECK(largest_difference(d, expected) <= 1e-14);
    }
  }

  TEST_CASE("the interpolation holds to 45 digits in enclosures of 200 bits") {
    const Interval::Precision precision(200);
    for (const char* name : {"octa.obj", "icosa.obj", "bipyramid7.obj"}) {
      const Surface<Interval> mesh = convert<Interval>(offset_mesh(name));
      const LoopLimit<Interval> limit(mesh.mesh, mesh.tags);
      const Points<Interval> right = limit_normals(limit, mesh.points);
      const Points<Interval> d = dense_solve(limit_matrix(limit), right);
      const Points<Interval> reached = limit.points(d);
      double widest = 0;
      for (Eigen::Index k = 0; k < right.size(); ++k) {
        const Interval difference = reached.data()[k] - right.data()[k];
        CHECK(difference.contains_zero());
        widest = std::max(widest, difference.width());
      }
      CHECK(widest < 1e-45);
      const Points<double> rounded = solve_offset(loop_limit(offset_mesh(name)),
                                                  [&] {
                                                    Points<double> r(right.rows(), 3);
                                                    for (Eigen::Index k = 0; k < r.size(); ++k)
                                                      r.data()[k] = right.data()[k].midpoint();
                                                    return r;
                                                  }())
                                         .d;
      for (Eigen::Index k = 0; k < d.size(); ++k) CHECK(std::abs(d.data()[k].midpoint() - rounded.data()[k]) <= 1e-14);
    }
  }

  TEST_CASE("the system is exact in rational numbers where the valences allow it") {
    const Surface<double> octa = offset_mesh("octa.obj");
    const LoopLimit<Rational> limit(octa.mesh, {});
    const Points<Rational> matrix = limit_matrix(limit),
                           inverse = dense_solve(matrix, Points<Rational>(Points<Rational>::Identity(6, 6)));
    CHECK(matrix * inverse == Points<Rational>::Identity(6, 6));
    for (int i = 0; i < 6; ++i) CHECK(matrix.row(i).sum() == Rational(1));
    CHECK(matrix(0, 0) == Rational(24) / Rational(55));
  }

  TEST_CASE("active vertices alone are corrected and the others stay") {
    for (const char* name : {"icosa.obj", "cap.obj", "cap_corners.obj", "strip9.obj"}) {
      CAPTURE(name);
      const Surface<double> mesh = offset_mesh(name, 1);
      const LoopLimit<double> limit = loop_limit(mesh);
      const Points<double> right = wanted(limit, mesh.points, 1);
      std::vector<char> active(static_cast<std::size_t>(mesh.mesh->vertices()));
      for (std::size_t v = 0; v < active.size(); ++v) active[v] = v % 3 != 0;
      const Points<double> d = solve_offset(limit, right, {}, &active).d, reached = limit.points(d);
      for (std::size_t v = 0; v < active.size(); ++v) {
        const auto row = static_cast<Eigen::Index>(v);
        if (active[v]) CHECK(largest_difference(reached.row(row), right.row(row)) <= 1e-13);
        if (!active[v]) CHECK(d.row(row).isZero());
      }
    }
  }

  TEST_CASE("every factor of the right side passes through and zero gives zero") {
    const Surface<double> mesh = offset_mesh("cap.obj", 1);
    const LoopLimit<double> limit = loop_limit(mesh);
    const Points<double> right = wanted(limit, mesh.points, 1), one = solve_offset(limit, right).d;
    CHECK(largest_difference(solve_offset(limit, -0.375 * right).d, -0.375 * one) <= 1e-15);
    for (const OffsetSolver solver : iterative) CHECK(solve_offset(limit, 0 * right, with(solver)).d.isZero());
  }

  TEST_CASE("iterations that cannot reach their tolerance say so") {
    const Surface<double> spot = offset_mesh("spot188.obj"), eight = offset_mesh("eight.obj");
    const auto solve = [](const Surface<double>& mesh, const SolveOptions& options) {
      const LoopLimit<double> limit = loop_limit(mesh);
      return solve_offset(limit, wanted(limit, mesh.points, 1), options);
    };
    const auto begins = [](const std::string& text, const std::string& begin) { return text.substr(0, begin.size()) == begin; };
    CHECK(
        begins(refusal([&] { solve(spot, with(OffsetSolver::jacobi)); }), "E_NO_CONVERGENCE: the solver jacobi diverged after "));
    CHECK(solve(eight, with(OffsetSolver::jacobi, 1e-10)).residual <= 1e-10);  // genus 2: radius 0.9845
    SolveOptions few = with(OffsetSolver::gauss_seidel);
    few.max_iterations = 3;
    CHECK(begins(refusal([&] { solve(spot, few); }),
                 "E_NO_CONVERGENCE: the solver gauss-seidel stopped after 3 iterations with a residual of "));
    std::atomic<bool> stop = true;
    few.stop = &stop;
    CHECK(refusal([&] { solve(spot, few); }) == "E_INTERRUPTED: interrupted");
  }
}

}  // namespace
}  // namespace udcp
