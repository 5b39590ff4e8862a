// Time of one proof of C^1 at a vertex, by valence: the search with its check, and the check of a certificate alone.
#include <benchmark/benchmark.h>

#include "proofs/surface_c1.h"
#include "tests/proofs/surface_words.h"

namespace {

using udcp::Result;
using udcp::Word;

void prove(benchmark::State& state, const Word& word) {
  const int valence = static_cast<int>(state.range(0));
  for (auto _ : state) {
    const Result result = udcp::prove_surface_c1(word, valence);
    if (result.verdict != udcp::Verdict::proved) state.SkipWithError("not proved");
  }
}

void verify(benchmark::State& state, const Word& word) {
  const Result result = udcp::prove_surface_c1(word, static_cast<int>(state.range(0)));
  if (result.verdict != udcp::Verdict::proved) state.SkipWithError("not proved");
  for (auto _ : state) benchmark::DoNotOptimize(udcp::verify(*result.certificate).accepted);
  state.counters["bytes"] = result.certificate ? static_cast<double>(result.certificate->dump().size()) : 0;
}

void add(const std::string& name, const Word& word, std::initializer_list<int> valences) {
  auto* proofs = benchmark::RegisterBenchmark(("prove " + name).c_str(), [word](benchmark::State& s) { prove(s, word); });
  auto* checks = benchmark::RegisterBenchmark(("verify " + name).c_str(), [word](benchmark::State& s) { verify(s, word); });
  for (auto* each : {proofs, checks})
    for (const int n : valences) each->Arg(n)->Unit(benchmark::kMillisecond);
}

}  // namespace

int main(int argc, char** argv) {
  const auto every = {3, 4, 5, 6, 7, 8, 9, 10, 12, 14, 16, 18, 20, 25, 30, 35, 40, 45, 50};
  add("catmull_clark", udcp::oracle::catmull_clark(), every);
  add("loop", udcp::oracle::loop(), every);
  add("interpolating quads", udcp::oracle::scheme("UCP"), {3, 5, 8, 20, 50});
  add("interpolating triangles", udcp::oracle::on_triangles(udcp::oracle::scheme("UCP")), {4, 5, 8, 20, 50});
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
