// Plans against the general path: compiling and executing (cold), executing again (warm), threads, limits with normals, small
// meshes. Counters: points made per second, and bytes of the result per second. The triad is the floor of the machine for as many
// bytes.
#include <benchmark/benchmark.h>

#include <string>

#include "operators/plan/refine.h"
#include "operators/schemes.h"
#include "operators/shapes.h"

namespace {

using namespace udcp;

Word word_of(const std::string& atoms, bool triangles = false) {
  Word word;
  for (const char letter : atoms) {
    Item item;
    item.atom = static_cast<Atom>(letter);
    word.tail.push_back(item);
  }
  word.triangles = triangles;
  return word;
}

/// 20 k^2 triangles with 12 vertices of valence 5.
Surface<double> triangle_sphere(int k) {
  Word split = word_of("U", true);
  split.tail[0].sections = k;
  return run(split, icosahedron<double>(), 1);
}

/// 60 k^2 quads, three to a triangle, so that each has a vertex of valence 3.
Surface<double> quad_sphere(int k) { return run(word_of("U"), triangle_sphere(k), 1); }

struct Task {
  Word word;
  Surface<double> surface;
  int rounds;
};

// 10,140 quads or 9,680 triangles, five rounds: 10 million faces.
Task catmull_clark() { return {schemes::catmull_clark(), quad_sphere(13), 5}; }
Task loop() { return {schemes::loop(), triangle_sphere(22), 5}; }
Task push_back() { return {word_of("UCCP"), quad_sphere(13), 5}; }
Task regular() { return {schemes::catmull_clark(), torus<double>(100, 100, 3, 1), 5}; }
Task quarter() { return {schemes::catmull_clark(), torus<double>(50, 50, 3, 1), 5}; }
Task small_cube() { return {schemes::catmull_clark(), cube<double>(), 5}; }
Task small_model() { return {schemes::catmull_clark(), quad_sphere(5), 2}; }

template <class R>
void count(benchmark::State& state, const FlatMesh<R>& mesh, bool with_corners) {
  const auto n = static_cast<double>(state.iterations());
  const double bytes = static_cast<double>((mesh.points.size() + mesh.normals.size()) * sizeof(R)) +
                       (with_corners ? 4.0 * static_cast<double>(mesh.corners.size()) : 0);
  state.counters["points"] = benchmark::Counter(n * static_cast<double>(mesh.vertices()), benchmark::Counter::kIsRate);
  state.counters["bytes"] = benchmark::Counter(n * bytes, benchmark::Counter::kIsRate);
}

template <class R>
void cold(benchmark::State& state, Task (*make)()) {
  const Task task = make();
  FlatMesh<R> last;
  for (auto _ : state) {
    last = {};
    last = std::get<0>(refine<R>(task.word, task.surface, task.rounds).mesh);
  }
  count(state, last, true);
}

template <class R>
void warm(benchmark::State& state, Task (*make)()) {
  const Task task = make();
  PlanControl control;
  control.threads = static_cast<int>(state.range(0));
  control.always = true;
  const Compiled<R> compiled = compile<R>(task.word, task.surface, task.rounds, control);
  FlatMesh<R> mesh;
  execute(*compiled.plan, task.surface.points, mesh, control);
  for (auto _ : state) execute(*compiled.plan, task.surface.points, mesh, control);
  count(state, mesh, false);
}

void limits(benchmark::State& state) {
  const Task task = catmull_clark();
  PlanControl control;
  control.limit_points = control.normals = true;
  FlatMesh<float> last;
  for (auto _ : state) {
    last = {};
    last = std::get<0>(refine<float>(task.word, task.surface, task.rounds, control).mesh);
  }
  count(state, last, true);
}

void general(benchmark::State& state, Task (*make)(), int fewer_rounds) {
  const Task task = make();
  std::int64_t points = 0;
  for (auto _ : state) points += run(task.word, task.surface, task.rounds - fewer_rounds).mesh->vertices();
  state.counters["points"] = benchmark::Counter(static_cast<double>(points), benchmark::Counter::kIsRate);
}

// a = b + s c over arrays whose sum is the size of the warm result of `quarter`.
void triad(benchmark::State& state) {
  const auto n = static_cast<std::size_t>(state.range(0)) / 3;
  Buffer<float> a(n), b(n), c(n);
  std::fill(a.begin(), a.end(), 0.0F);
  std::fill(b.begin(), b.end(), 1.0F);
  std::fill(c.begin(), c.end(), 2.0F);
  for (auto _ : state) {
    for (std::size_t k = 0; k < n; ++k) a[k] = b[k] + 0.5F * c[k];
    benchmark::ClobberMemory();
  }
  state.counters["bytes"] =
      benchmark::Counter(static_cast<double>(state.iterations()) * static_cast<double>(12 * n), benchmark::Counter::kIsRate);
}

// What the system takes to hand out pages for the cold result.
void fresh_pages(benchmark::State& state) {
  const auto bytes = static_cast<std::size_t>(state.range(0));
  for (auto _ : state) {
    Buffer<char> pages(bytes);
    for (std::size_t k = 0; k < bytes; k += 64) pages[k] = 1;
    benchmark::DoNotOptimize(pages.data());
  }
  state.counters["bytes"] =
      benchmark::Counter(static_cast<double>(state.iterations()) * static_cast<double>(bytes), benchmark::Counter::kIsRate);
}

}  // namespace

int main(int argc, char** argv) {
  const auto measure = [](const char* name, auto function, auto... arguments) {
    return benchmark::RegisterBenchmark(name, function, arguments...)->Unit(benchmark::kMillisecond);
  };
  measure("cold/catmull_clark/float", cold<float>, catmull_clark);
  measure("cold/catmull_clark/double", cold<double>, catmull_clark);
  measure("cold/loop/float", cold<float>, loop);
  measure("cold/push_back/float", cold<float>, push_back);
  measure("cold/regular/float", cold<float>, regular);
  measure("cold/cube/float", cold<float>, small_cube);
  measure("cold/model/float", cold<float>, small_model);
  for (const int threads : {1, 2}) {
    measure("warm/quarter/float", warm<float>, quarter)->Arg(threads)->UseRealTime();
    measure("warm/catmull_clark/float", warm<float>, catmull_clark)->Arg(threads)->UseRealTime();
    measure("warm/push_back/float", warm<float>, push_back)->Arg(threads)->UseRealTime();
  }
  measure("warm/quarter/double", warm<double>, quarter)->Arg(1)->UseRealTime();
  measure("limits/catmull_clark/float", limits);
  measure("general/catmull_clark, two rounds fewer", general, catmull_clark, 2);
  measure("general/cube", general, small_cube, 0);
  measure("general/model", general, small_model, 0);
  measure("floor/triad", triad)->Arg(3 * 2'560'000);
  measure("floor/fresh pages", fresh_pages)->Arg(290'734'000);
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
