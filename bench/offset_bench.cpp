// Offsets of large control meshes: time to build and to solve the system, by solver; counters: iterations and residual. The claim
// is that iterations do not depend on the size. Peak memory of the process is printed at the end.
#include <benchmark/benchmark.h>
#include <sys/resource.h>

#include <cmath>
#include <cstdio>

#include "operators/methods/offset/offset_system.h"
#include "operators/shapes.h"

namespace {

using namespace udcp;

/// A bumpy torus with about so many vertices, all of valence 6.
Surface<double> bumpy_torus(int vertices) {
  const int m = static_cast<int>(std::lround(std::sqrt(vertices)));
  Surface<double> mesh = triangulate(torus<double>(m, m, 2.0, 0.75));
  for (Eigen::Index v = 0; v < mesh.points.rows(); ++v)
    mesh.points(v, 2) += 0.05 * std::sin(7 * mesh.points(v, 0)) * std::cos(5 * mesh.points(v, 1));
  return mesh;
}

void build_system(benchmark::State& state) {
  const Surface<double> mesh = bumpy_torus(static_cast<int>(state.range(0)));
  for (auto _ : state) {
    const LoopLimit<double> limit(mesh.mesh, mesh.tags);
    const Points<double> normals = limit_normals(limit, mesh.points);
    benchmark::DoNotOptimize(offset_system(limit).size() + normals.rows());
  }
}

void solve_with(benchmark::State& state, OffsetSolver solver, double tolerance) {
  const Surface<double> mesh = bumpy_torus(static_cast<int>(state.range(0)));
  const LoopLimit<double> limit(mesh.mesh, mesh.tags);
  const Points<double> wanted = 0.05 * limit_normals(limit, mesh.points);
  SolveOptions options;
  options.solver = solver;
  options.tolerance = tolerance;
  for (auto _ : state) {
    const OffsetSolution solution = solve_offset(limit, wanted, options);
    state.counters["iterations"] = solution.iterations;
    state.counters["residual"] = solution.residual;
  }
}

void sizes(benchmark::internal::Benchmark* bench) {
  bench->Arg(10'000)->Arg(100'000)->Arg(1'000'000)->Unit(benchmark::kMillisecond)->Iterations(1);
}

BENCHMARK(build_system)->Apply(sizes);
BENCHMARK_CAPTURE(solve_with, direct, OffsetSolver::direct, 1e-10)
    ->Arg(10'000)
    ->Arg(100'000)
    ->Unit(benchmark::kMillisecond)
    ->Iterations(1);  // minutes beyond
BENCHMARK_CAPTURE(solve_with, edge, OffsetSolver::edge, 1e-10)->Apply(sizes);
BENCHMARK_CAPTURE(solve_with, star, OffsetSolver::star, 1e-10)->Apply(sizes);
BENCHMARK_CAPTURE(solve_with, gauss_seidel, OffsetSolver::gauss_seidel, 1e-10)->Apply(sizes);
BENCHMARK_CAPTURE(solve_with, richardson, OffsetSolver::richardson, 1e-10)->Apply(sizes);
BENCHMARK_CAPTURE(solve_with, conjugate_gradients, OffsetSolver::conjugate_gradients, 1e-10)->Apply(sizes);

}  // namespace

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  std::printf("peak memory: %ld MiB\n", usage.ru_maxrss >> 10);
}
