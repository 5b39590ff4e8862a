// Time and memory of interpolating a torus of m by 5m/8 quads with its normals, and of its linear system alone; every run is
// checked against the bound 1e-12.
#include <benchmark/benchmark.h>
#include <sys/resource.h>

#include <cmath>

#include "operators/methods/interpolation/interpolation.h"
#include "operators/methods/interpolation/point_system.h"
#include "operators/shapes.h"

namespace {

using namespace udcp;

struct Input {
  Surface<double> cage;
  Points<double> normals;
};

Input torus_of(int m) {
  Input input{torus<double>(m, m * 5 / 8, 3, 1), {}};
  input.cage.tags = {};
  input.normals.resize(input.cage.points.rows(), 3);
  for (Eigen::Index v = 0; v < input.normals.rows(); ++v) {
    const double x = input.cage.points(v, 0), y = input.cage.points(v, 1), radius = std::hypot(x, y);
    input.normals.row(v) << x - 3 * x / radius, y - 3 * y / radius, input.cage.points(v, 2);
  }
  return input;
}

double peak_megabytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

void whole(benchmark::State& state) {
  const Input input = torus_of(static_cast<int>(state.range(0)));
  for (auto _ : state) {
    const Interpolation result = interpolate(input.cage, input.normals);
    if (result.errors.position > 1e-12 || result.errors.normal > 1e-12) state.SkipWithError("not interpolated");
  }
  state.counters["vertices"] = input.cage.mesh->vertices();
  state.counters["peak MiB"] = peak_megabytes();
}
BENCHMARK(whole)->Arg(50)->Arg(100)->Arg(200)->Arg(400)->Arg(800)->Unit(benchmark::kMillisecond);

void system_alone(benchmark::State& state) {
  const Input input = torus_of(static_cast<int>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(solve_for_limits(input.cage, PointOptions()));
  state.counters["vertices"] = input.cage.mesh->vertices();
}
BENCHMARK(system_alone)->Arg(50)->Arg(100)->Arg(200)->Arg(400)->Arg(800)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
