// Writing and reading large meshes, as bytes of the file per second of CPU time, with floors in the same run: the same bytes by
// plain write(2), by memcpy, and read back by plain read(2). Arguments: quads of a torus. The folder for temporary files is used.
#include <benchmark/benchmark.h>
#include <fcntl.h>
#include <unistd.h>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <memory>

#include "files/raw_mesh.h"
#include "operators/plan/flat_mesh.h"
#include "operators/shapes.h"

namespace {

using namespace udcp;
namespace fs = std::filesystem;

/// A wavy torus of about so many quads, without tags.
Surface<double> wavy_torus(std::int64_t quads) {
  const int m = static_cast<int>(std::lround(std::sqrt(static_cast<double>(quads))));
  auto mesh = torus<double>(m, m, 2.0, 0.75);
  for (Eigen::Index v = 0; v < mesh.points.rows(); ++v)
    mesh.points(v, 2) += 0.05 * std::sin(7 * mesh.points(v, 0)) * std::cos(5 * mesh.points(v, 1));
  mesh.tags = {};
  return mesh;
}

FlatMesh<float> flat(const Surface<double>& surface, bool normals) {
  FlatMesh<float> mesh;
  mesh.points = Buffer<float>(static_cast<std::size_t>(surface.points.size()));
  mesh.corners = Buffer<std::uint32_t>(surface.mesh->vertex.size());
  std::transform(surface.points.data(), surface.points.data() + surface.points.size(), mesh.points.begin(),
                 [](double value) { return static_cast<float>(value); });
  std::ranges::copy(surface.mesh->vertex, mesh.corners.begin());
  if (!normals) return mesh;
  const Points<double> units = surface.points.rowwise().normalized();
  mesh.normals = Buffer<float>(mesh.points.size());
  std::transform(units.data(), units.data() + units.size(), mesh.normals.begin(),
                 [](double value) { return static_cast<float>(value); });
  return mesh;
}

/// A file that goes away.
struct Scratch {
  fs::path path;
  explicit Scratch(const std::string& extension)
      : path(fs::temp_directory_path() / ("udcp-bench-" + std::to_string(::getpid()) + "." + extension)) {}
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  ~Scratch() { fs::remove(path); }
};

void count_bytes(benchmark::State& state, std::uintmax_t bytes) {
  state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(bytes));
  state.counters["MB"] = static_cast<double>(bytes) / 1e6;
}

template <class Mesh>
void time_saves(benchmark::State& state, const Mesh& mesh, const std::string& extension) {
  const Scratch file(extension);
  for (auto _ : state) save(mesh, file.path);
  count_bytes(state, fs::file_size(file.path));
}

void save_surface(benchmark::State& state, const std::string& extension) {
  time_saves(state, wavy_torus(state.range(0)), extension);
}
void save_flat(benchmark::State& state, const std::string& extension) {
  time_saves(state, flat(wavy_torus(state.range(0)), false), extension);
}
void save_flat_with_normals(benchmark::State& state, const std::string& extension) {
  time_saves(state, flat(wavy_torus(state.range(0)), true), extension);
}

/// Bytes of a GLB of so many quads: three floats for points and normals, six indices a quad.
std::size_t glb_size(const benchmark::State& state) { return 48 * static_cast<std::size_t>(state.range(0)); }

void floor_write(benchmark::State& state) {
  const Scratch file("bin");
  const std::string bytes(glb_size(state), 'x');
  for (auto _ : state) {
    fs::remove(file.path);
    const int fd = ::open(file.path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    for (std::size_t done = 0; done < bytes.size();) {
      const ssize_t written = ::write(fd, bytes.data() + done, bytes.size() - done);
      if (written < 0) return state.SkipWithError("the file cannot be written");
      done += static_cast<std::size_t>(written);
    }
    if (::fsync(fd) != 0 || ::close(fd) != 0) return state.SkipWithError("the file cannot be written");
  }
  count_bytes(state, bytes.size());
}

void floor_memcpy(benchmark::State& state) {
  const std::string bytes(glb_size(state), 'x');
  std::string copy = bytes;
  for (auto _ : state) {
    std::memcpy(copy.data(), bytes.data(), bytes.size());
    benchmark::ClobberMemory();
  }
  count_bytes(state, bytes.size());
}

/// The OBJ of the torus, with corners "a" or "a/b/c".
std::string obj_text(std::int64_t quads, bool slashes) {
  const Surface<double> mesh = wavy_torus(quads);
  if (!slashes) return save_bytes(mesh, "obj");
  const Points<double> normals = mesh.points.rowwise().normalized();
  SaveOptions options;
  options.normals = &normals;
  const std::string text = save_bytes(mesh, "obj", options);
  std::string result;
  for (std::size_t at = 0; at < text.size(); ++at) {  // "a//c" becomes "a/a/c"
    result += text[at];
    if (text[at] != '/' || text[at + 1] != '/') continue;
    const std::size_t start = text.rfind(' ', at) + 1;
    result.append(text, start, at - start);
  }
  return result;
}

void parse_obj(benchmark::State& state, bool slashes) {
  const std::string text = obj_text(state.range(0), slashes);
  const Input input{text, "bench.obj", nullptr, {}};
  for (auto _ : state) benchmark::DoNotOptimize(read_obj<double>(input).corners.data());
  count_bytes(state, text.size());
}

void connect_obj(benchmark::State& state) {
  const std::string text = obj_text(state.range(0), false);
  const RawMesh<double> raw = read_obj<double>({text, "bench.obj", nullptr, {}});
  for (auto _ : state) benchmark::DoNotOptimize(make_mesh(raw.vertices(), raw.begin, raw.corners).edges());
  count_bytes(state, text.size());
}

void load_obj(benchmark::State& state, bool slashes, bool warned) {
  const Scratch file("obj");
  write_file(file.path, obj_text(state.range(0), slashes));
  for (auto _ : state) {
    Warnings warnings;
    benchmark::DoNotOptimize(load<double>(file.path, warned ? &warnings : nullptr).points.data());
  }
  count_bytes(state, fs::file_size(file.path));
}

void floor_read(benchmark::State& state) {
  const Scratch file("obj");
  write_file(file.path, obj_text(state.range(0), false));
  for (auto _ : state) benchmark::DoNotOptimize(read_bytes(file.path).size);
  count_bytes(state, fs::file_size(file.path));
}

void sizes(benchmark::internal::Benchmark* bench) { bench->Arg(1'000'000)->Arg(4'000'000)->Unit(benchmark::kMillisecond); }

BENCHMARK(floor_memcpy)->Apply(sizes);
BENCHMARK(floor_write)->Apply(sizes);
BENCHMARK_CAPTURE(save_flat, glb, "glb")->Apply(sizes);
BENCHMARK_CAPTURE(save_flat_with_normals, glb, "glb")->Apply(sizes);
BENCHMARK_CAPTURE(save_flat, ply, "ply")->Apply(sizes);
BENCHMARK_CAPTURE(save_flat, stl, "stl")->Apply(sizes);
BENCHMARK_CAPTURE(save_flat, obj, "obj")->Apply(sizes);
BENCHMARK_CAPTURE(save_surface, glb, "glb")->Apply(sizes);
BENCHMARK_CAPTURE(save_surface, ply, "ply")->Apply(sizes);
BENCHMARK_CAPTURE(save_surface, stl, "stl")->Apply(sizes);
BENCHMARK_CAPTURE(save_surface, obj, "obj")->Apply(sizes);
BENCHMARK(floor_read)->Apply(sizes);
BENCHMARK_CAPTURE(parse_obj, a, false)->Apply(sizes);
BENCHMARK_CAPTURE(parse_obj, a_b_c, true)->Apply(sizes);
BENCHMARK(connect_obj)->Apply(sizes);
BENCHMARK_CAPTURE(load_obj, a, false, false)->Apply(sizes);
BENCHMARK_CAPTURE(load_obj, a_b_c, true, false)->Apply(sizes);
BENCHMARK_CAPTURE(load_obj, with_warnings, false, true)->Apply(sizes);

}  // namespace

BENCHMARK_MAIN();
