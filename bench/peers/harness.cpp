// The clock and the files of the comparison: see harness.h.
#include "bench/peers/harness.h"

#include <time.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace peers {
namespace {

Cage read_obj(const std::string& path) {
  std::ifstream file(path);
  if (!file) refuse("cannot read " + path);
  Cage cage;
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    std::string word;
    words >> word;
    if (word == "v") {
      double x = 0, y = 0, z = 0;
      if (!(words >> x >> y >> z)) refuse("three numbers after v: " + line);
      cage.points.insert(cage.points.end(), {x, y, z});
    } else if (word == "f") {
      int size = 0;
      for (; words >> word; ++size) cage.corners.push_back(std::stoi(word) - 1);  // stoi stops at the slash of 7/7/7
      cage.sizes.push_back(size);
    }
  }
  return cage;
}

void write(const Result& result, const std::string& path) {
  std::ofstream file(path, std::ios::binary);
  const std::int64_t header[3] = {static_cast<std::int64_t>(result.points.size() / 3),
                                  static_cast<std::int64_t>(result.corners.size()), result.corners_per_face};
  const auto put = [&](const void* from, std::size_t bytes) {
    file.write(static_cast<const char*>(from), static_cast<std::streamsize>(bytes));
  };
  put(header, sizeof header);
  put(result.points.data(), result.points.size() * sizeof(double));
  put(result.corners.data(), result.corners.size() * sizeof(std::uint32_t));
  if (!file.flush()) refuse("cannot write " + path);
}

Job parse(int argc, char** argv) {
  Job job;
  for (int k = 1; k < argc; ++k) {
    const std::string name = argv[k];
    if (name.rfind("--", 0) != 0) {
      job.mesh = name;
      continue;
    }
    if (++k == argc) refuse(name + " needs a value");
    const std::string value = argv[k];
    if (name == "--scheme")
      job.scheme = value;
    else if (name == "--way")
      job.way = value;
    else if (name == "--real")
      job.real = value;
    else if (name == "--save")
      job.save = value;
    else if (name == "--rounds")
      job.rounds = std::stoi(value);
    else if (name == "--threads")
      job.threads = std::stoi(value);
    else if (name == "--bytes")
      job.bytes = std::stoll(value);
    else if (name == "--seconds")
      job.seconds = std::stod(value);
    else
      refuse("unknown option " + name);
  }
  if (job.real != "float" && job.real != "double") refuse("--real is float or double");
  return job;
}

/// The largest resident set of the process so far. Not ru_maxrss, which begins with that of the script that started it.
std::int64_t peak_bytes() {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;)
    if (word == "VmHWM:") {
      std::int64_t kilobytes = 0;
      status >> kilobytes;
      return kilobytes * 1024;
    }
  return 0;
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

}  // namespace

void refuse(const std::string& why) { throw std::runtime_error(why); }

double cpu_seconds() {
  timespec time{};  // what getrusage adds up, in nanoseconds
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

double wall_seconds() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

Sizes sizes_of(std::int64_t vertices, std::int64_t faces, const Job& job, bool with_corners) {
  const std::int64_t number = job.real == "float" ? 4 : 8;
  const std::int64_t per_face = job.scheme == "loop" ? 3 : 4;
  return {vertices, faces, vertices * 3 * number + (with_corners ? faces * per_face * 4 : 0)};
}

void measure(const Job& job, const Program& program) {
  std::vector<double> cpu, wall;
  for (double total = 0; total < job.seconds || cpu.empty(); total += wall.back()) {
    program.drop();
    const double cpu_start = cpu_seconds(), wall_start = wall_seconds();
    program.run();
    cpu.push_back(cpu_seconds() - cpu_start);
    wall.push_back(wall_seconds() - wall_start);
  }
  const std::int64_t peak = peak_bytes();
  const double first = cpu.front(), first_wall = wall.front();
  if (cpu.size() > 1) cpu.erase(cpu.begin()), wall.erase(wall.begin());  // the first run also loads code
  const Sizes sizes = program.sizes();
  std::printf(
      "{\"seconds\": %.9g, \"wall\": %.9g, \"first\": %.9g, \"first_wall\": %.9g, \"runs\": %zu, \"peak_bytes\": %lld, "
      "\"vertices\": %lld, \"faces\": %lld, \"output_bytes\": %lld}\n",
      median(cpu), median(wall), first, first_wall, cpu.size(), static_cast<long long>(peak),
      static_cast<long long>(sizes.vertices), static_cast<long long>(sizes.faces), static_cast<long long>(sizes.output_bytes));
  if (!job.save.empty()) write(program.result(), job.save);
}

int run_main(int argc, char** argv, Program (*make)(const Job&, const Cage&)) {
  try {
    const Job job = parse(argc, argv);
    const Cage cage = job.mesh.empty() ? Cage{} : read_obj(job.mesh);
    measure(job, make(job, cage));
  } catch (const std::exception& error) {
    std::string text = error.what();
    std::replace_if(
        text.begin(), text.end(), [](char c) { return c == '"' || c == '\\' || c == '\n'; }, ' ');
    std::printf("{\"error\": \"%s\"}\n", text.c_str());
    return 1;
  }
  return 0;
}

}  // namespace peers
