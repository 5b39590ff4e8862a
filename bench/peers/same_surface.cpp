// Whether two programs made the same surface, whatever order they number it in: same_surface A B with files written by --save.
// Prints the largest distance of a point of one to the nearest point of the other, both ways, over the size of the box around
// them; the same for the centres of the faces. Where a point has none within a hundred-thousandth of the box, it says so.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>

#include "bench/peers/harness.h"

namespace {

using namespace peers;
using Point = std::array<double, 3>;
constexpr double reach = 1e-5;  // the largest distance that is looked at, over the size of the box
constexpr double cell = 1e-4;   // the side of a cell of the grid that finds neighbours

struct Set {
  std::vector<Point> points, centres;
};

Set read(const char* path) {
  std::ifstream file(path, std::ios::binary);
  std::int64_t header[3] = {};
  const auto get = [&](void* to, std::size_t bytes) {
    if (!file.read(static_cast<char*>(to), static_cast<std::streamsize>(bytes))) refuse(std::string("cannot read ") + path);
  };
  get(header, sizeof header);
  Set set;
  set.points.resize(static_cast<std::size_t>(header[0]));
  get(set.points.data(), set.points.size() * sizeof(Point));
  std::vector<std::uint32_t> corners(static_cast<std::size_t>(header[1]));
  get(corners.data(), corners.size() * sizeof(std::uint32_t));
  const auto per_face = static_cast<std::size_t>(header[2]);
  for (std::size_t at = 0; at + per_face <= corners.size(); at += per_face) {
    Point centre{};
    for (std::size_t k = 0; k < per_face; ++k)
      for (std::size_t c = 0; c < 3; ++c) centre[c] += set.points.at(corners[at + k])[c] / static_cast<double>(per_face);
    set.centres.push_back(centre);
  }
  return set;
}

/// Points sorted by the cells of a grid, in units of the box.
class Grid {
 public:
  Grid(const std::vector<Point>& points, double unit) : unit_(unit) {
    entries_.reserve(points.size());
    for (const Point& p : points) entries_.push_back({key(p, {}), p});
    std::sort(entries_.begin(), entries_.end(), [](const Entry& a, const Entry& b) { return a.key < b.key; });
  }
  /// Distance to the nearest point within reach, or infinity; both in units of the box.
  [[nodiscard]] double nearest(const Point& p) const {
    double best = HUGE_VAL;
    std::array<std::int64_t, 8> keys{};
    for (unsigned corner = 0; corner < 8; ++corner) {
      Point shift;
      for (unsigned c = 0; c < 3; ++c) shift[c] = (corner >> c & 1U) != 0 ? reach : -reach;
      keys[corner] = key(p, shift);
    }
    std::sort(keys.begin(), keys.end());
    for (auto end = std::unique(keys.begin(), keys.end()), k = keys.begin(); k != end; ++k)
      for (auto e =
               std::lower_bound(entries_.begin(), entries_.end(), *k, [](const Entry&a, std::int64_t b) { return a.key < b; });
           e != entries_.end() && e->key == *k; ++e)
        best = std::min(best, std::hypot(e->p[0] - p[0], e->p[1] - p[1], e->p[2] - p[2]) / unit_);
    return best <= reach ? best : HUGE_VAL;
  }

 private:
  struct Entry {
    std::int64_t key;
    Point p;
  };
  [[nodiscard]] std::int64_t key(const Point& p, const Point& shift) const {
    std::int64_t k = 0;  // 21 bits a coordinate; what wraps only shares a cell
    for (std::size_t c = 0; c < 3; ++c)
      k = (k << 21) | (static_cast<std::int64_t>(std::floor((p[c] / unit_ + shift[c]) / cell)) & 0x1fffff);
    return k;
  }
  std::vector<Entry> entries_;
  double unit_;
};

double distance(const std::vector<Point>& from, const std::vector<Point>& to, double unit) {
  const Grid grid(to, unit);
  double worst = 0;
  for (const Point& p : from) worst = std::max(worst, grid.nearest(p));
  return worst;
}

double box_size(const std::vector<Point>& points) {
  double size = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    const auto [low, high] =
        std::minmax_element(points.begin(), points.end(), [c](const Point& a, const Point& b) { return a[c] < b[c]; });
    size = std::max(size, (*high)[c] - (*low)[c]);
  }
  return size;
}

void compare(const Set& a, const Set& b) {
  if (a.points.size() != b.points.size() || a.centres.size() != b.centres.size() || a.points.empty())
    refuse("different numbers of vertices or faces");
  const double unit = box_size(a.points);
  const double points = std::max(distance(a.points, b.points, unit), distance(b.points, a.points, unit));
  const double centres = std::max(distance(a.centres, b.centres, unit), distance(b.centres, a.centres, unit));
  if (points > reach || centres > reach) refuse("a point or a face of one is nowhere near the other");
  std::printf("{\"points\": %.3g, \"faces\": %.3g}\n", points, centres);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    if (argc != 3) refuse("usage: same_surface A B");
    compare(read(argv[1]), read(argv[2]));
  } catch (const std::exception& error) {
    std::printf("{\"error\": \"%s\"}\n", error.what());
    return 1;
  }
}
