// Time of the G2 fill: of a mask by valence, of the cached masks on a mesh with 10,008 extraordinary vertices (valence 3 and 5),
// and of the whole surface.
#include <benchmark/benchmark.h>

#include "operators/methods/filling/fill_g2.h"
#include "tests/oracle/nets.h"

namespace {

using namespace udcp;

/// 834 polyhedra, refined once: 2 vertices of valence 5 and 10 of valence 3 in each.
Surface<double> many_holes() {
  const Surface<double> one = oracle::trapezohedron(5);
  oracle::Faces faces;
  constexpr int copies = 834;
  Surface<double> all;
  all.points.resize(12 * copies, 3);
  for (int k = 0; k < copies; ++k) {
    for (int v = 0; v < 12; ++v) all.points.row(12 * k + v) = one.points.row(v) + Eigen::RowVector3d(3.0 * k, 0, 0);
    for (std::vector<int> face : oracle::faces_of(*one.mesh)) {
      for (int& v : face) v += 12 * k;
      faces.push_back(face);
    }
  }
  all.mesh = std::make_shared<const Mesh>(make_mesh(12 * copies, faces));
  return run(schemes::catmull_clark(), all, 1);
}

void make_mask(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(make_fill_mask(static_cast<int>(state.range(0))).freedom);
}

void apply_masks(benchmark::State& state) {
  const Surface<double> surface = many_holes();
  const Mesh& mesh = *surface.mesh;
  FillMasks masks;
  for (const int n : {3, 5}) masks.of(n);
  for (auto _ : state) {
    int filled = 0;
    double sum = 0;
    for (int v = 0; v < mesh.vertices(); ++v) {
      if (mesh.valence(v) == 4) continue;
      const std::vector<int> ring = ring_vertices(mesh, mesh.outgoing[Mesh::i(v)], 2);
      Points<double> points(static_cast<Eigen::Index>(ring.size()), 3);
      for (std::size_t k = 0; k < ring.size(); ++k) points.row(static_cast<Eigen::Index>(k)) = surface.points.row(ring[k]);
      sum += apply(masks.of(mesh.valence(v)), points)(0, 0);
      ++filled;
    }
    benchmark::DoNotOptimize(sum);
    if (filled != 10008) state.SkipWithError("not 10,008 vertices");
  }
}

void fill_surface(benchmark::State& state) {
  const Surface<double> surface = many_holes();
  FillMasks masks;
  FillOptions options;
  options.masks = &masks;
  for (auto _ : state)
    if (fill_g2(surface, options).filled.size() != 10008) state.SkipWithError("not 10,008 vertices");
}

BENCHMARK(make_mask)->DenseRange(3, 12)->Arg(32)->Unit(benchmark::kMillisecond);
BENCHMARK(apply_masks)->Unit(benchmark::kMillisecond);
BENCHMARK(fill_surface)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
