// What the programs of the comparison share: the command line, the cage, the clock and the line of JSON that a program prints.
// Knows no library that is measured; each of them lives in a file of its own beside this one.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace peers {

/// One measurement: one process runs one of these.
struct Job {
  std::string mesh;                      // an OBJ file
  std::string scheme = "catmull_clark";  // catmull_clark, loop, or a word that only we run: uccp
  std::string way = "cold";              // what each program offers is said at its top
  std::string real = "float";            // float or double
  std::string save;                      // write the result of the last run to this file
  int rounds = 1, threads = 1;
  std::int64_t bytes = 0;  // for the floors, which have no mesh
  double seconds = 0.3;    // short runs are repeated until they have taken so long together
};

/// The control mesh as face lists: what every library is given.
struct Cage {
  std::vector<double> points;  // three per vertex
  std::vector<int> sizes;      // corners of each face
  std::vector<int> corners;    // of all faces, one after the other
  [[nodiscard]] int vertices() const { return static_cast<int>(points.size() / 3); }
  [[nodiscard]] int faces() const { return static_cast<int>(sizes.size()); }
  template <class R>
  [[nodiscard]] std::vector<R> points_as() const {
    return {points.begin(), points.end()};
  }
};

/// A result, in the same terms for all: written by --save, and compared by same_surface.
struct Result {
  std::vector<double> points;  // three per vertex
  std::vector<std::uint32_t> corners;
  int corners_per_face = 4;
};

/// Sizes of a result. `output_bytes` is what the result needs as flat arrays: three numbers a vertex, four bytes a corner.
struct Sizes {
  std::int64_t vertices = 0, faces = 0, output_bytes = 0;
};
Sizes sizes_of(std::int64_t vertices, std::int64_t faces, const Job& job, bool with_corners);

/// What is measured: `run`, and nothing before or after it. Freeing a result is not timed.
struct Program {
  std::function<void()> drop = [] {};  // frees the result of the run before
  std::function<void()> run;
  std::function<Sizes()> sizes;
  std::function<Result()> result;  // of the last run
};

/// Runs and repeats the program, prints {"seconds": median, "wall": .., "first": .., "runs": .., "peak_bytes": .., ...}. Seconds
/// are CPU seconds of the process, user and system, over all its threads. Peak memory is that of the whole process.
void measure(const Job& job, const Program& program);

/// Reads the command line and the mesh, calls `make` and measures what it returns; prints {"error": ...} and returns 1 where
/// something throws. Every program's main is this.
int run_main(int argc, char** argv, Program (*make)(const Job&, const Cage&));

[[noreturn]] void refuse(const std::string& why);

double cpu_seconds();
double wall_seconds();

}  // namespace peers
