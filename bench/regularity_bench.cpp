// Exact regularity tests on patches in space: T2 on ten thousand of them, against the same number of T4 and of exact refinements.
#include <benchmark/benchmark.h>

#include <random>

#include "proofs/regularity/adaptive.h"

namespace {

using namespace udcp;

/// Nets of a height field with noise, integers of four digits, so that most pass T2 and some do not.
std::vector<BicubicNet> nets(int count) {
  std::mt19937 random(1);
  std::uniform_int_distribution<int> jitter(-250, 250);
  std::vector<BicubicNet> result(static_cast<std::size_t>(count));
  for (BicubicNet& net : result)
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j) net.at(i, j) = {1000 * j + jitter(random), 1000 * i + jitter(random), 4 * jitter(random)};
  return result;
}

void test_patches(benchmark::State& state, RegularityTest test) {
  const std::vector<BicubicNet> patches = nets(10'000);
  int passed = 0;
  for (auto _ : state) {
    passed = 0;
    for (const BicubicNet& net : patches) passed += find_witness(net, test, false) ? 1 : 0;
    benchmark::DoNotOptimize(passed);
  }
  state.counters["passed"] = passed;
  state.SetItemsProcessed(state.iterations() * 10'000);
}
void t2_in_space(benchmark::State& state) { test_patches(state, RegularityTest::t2); }
void t3_in_space(benchmark::State& state) { test_patches(state, RegularityTest::t3); }
void t4_in_space(benchmark::State& state) { test_patches(state, RegularityTest::t4); }

void exact_refinement(benchmark::State& state) {
  const std::vector<BicubicNet> patches = nets(10'000);
  for (auto _ : state)
    for (const BicubicNet& net : patches) benchmark::DoNotOptimize(children(net));
  state.SetItemsProcessed(state.iterations() * 10'000);
}

BENCHMARK(t2_in_space)->Unit(benchmark::kMillisecond);
BENCHMARK(t3_in_space)->Unit(benchmark::kMillisecond);
BENCHMARK(t4_in_space)->Unit(benchmark::kMillisecond);
BENCHMARK(exact_refinement)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
