// The map, convex hulls on it, and dots.
#include "interpreter/sphere_map.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace udcp {
namespace {

/// The convex hull of points of the plane, counter-clockwise (Andrew's scan).
std::vector<std::array<double, 2>> convex_hull(std::vector<std::array<double, 2>> points) {
  std::sort(points.begin(), points.end());
  std::vector<std::array<double, 2>> hull;
  for (int pass = 0; pass < 2; ++pass) {
    const std::size_t start = hull.size();
    for (const auto& p : points) {
      while (hull.size() >= start + 2) {
        const auto &a = hull[hull.size() - 2], &b = hull.back();
        if ((b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]) > 0) break;
        hull.pop_back();
      }
      hull.push_back(p);
    }
    hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

void draw_hull(Scene& scene, const SphereMap& map, const std::vector<Direction>& directions, const FamilyStyle& style) {
  std::vector<std::array<double, 2>> plane;
  for (const Direction& d : directions) plane.push_back(map.to_plane(d));
  const auto hull = convex_hull(std::move(plane));
  if (hull.size() < 3) return;
  std::vector<Pixel> outline;
  for (std::size_t k = 0; k < hull.size(); ++k) {
    const auto &a = hull[k], &b = hull[(k + 1) % hull.size()];
    const int steps = static_cast<int>(std::clamp(8 * std::hypot(b[0] - a[0], b[1] - a[1]), 1.0, 12.0));
    for (int s = 0; s < steps; ++s) {
      const double t = static_cast<double>(s) / steps;
      outline.push_back(map.place(map.of_plane(a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]))));
    }
  }
  scene.polygon(outline, style.colour, style.dashed ? 0.1 : 0.18);
  SvgLayer& rim = scene.line(outline, style.colour, 0.8);
  rim.closed = true;
  if (style.dashed) rim.dash = "4 3";
}

/// Beside the dots, on the outer side.
void draw_name(Scene& scene, const SphereMap& map, const std::vector<Direction>& directions, const FamilyStyle& style) {
  Pixel mean;
  for (const Direction& d : directions) {
    mean.x += map.place(d).x / static_cast<double>(directions.size());
    mean.y += map.place(d).y / static_cast<double>(directions.size());
  }
  const double x = mean.x - map.middle().x, y = mean.y - map.middle().y, length = std::hypot(x, y);
  if (!(length > 1)) return;
  double reach = 0;  // of the dots, along the way out
  for (const Direction& d : directions) {
    const Pixel p = map.place(d);
    reach = std::max(reach, ((p.x - mean.x) * x + (p.y - mean.y) * y) / length);
  }
  scene.text({mean.x + (reach + 14) * x / length, mean.y + (reach + 14) * y / length + 4}, style.name, style.colour, "middle",
             13);
}

}  // namespace

SphereMap::SphereMap(const Direction& centre, Pixel place, double radius)
    : towards_(centre),
      right_(unit(cross(std::abs(centre[2]) > 0.9 ? Direction{0, 1, 0} : Direction{0, 0, 1}, centre))),
      up_(cross(towards_, right_)),
      place_(place),
      radius_(radius) {}

bool SphereMap::is_near(const Direction& d) const { return dot(d, towards_) > 0; }

Pixel SphereMap::place(const Direction& d) const {
  const double stretch = radius_ / std::sqrt(1 + std::abs(dot(d, towards_)));  // sqrt(2) sin(angle/2) / sin(angle)
  return {place_.x + stretch * dot(d, right_), place_.y - stretch * dot(d, up_)};
}

std::array<double, 2> SphereMap::to_plane(const Direction& d) const {
  return {dot(d, right_) / dot(d, towards_), dot(d, up_) / dot(d, towards_)};
}

Direction SphereMap::of_plane(double x, double y) const {
  Direction d{};
  for (std::size_t c = 0; c < 3; ++c) d[c] = x * right_[c] + y * up_[c] + towards_[c];
  return unit(d);
}

void draw_family(Scene& scene, const SphereMap& map, const std::vector<Direction>& directions, const FamilyStyle& style) {
  if (directions.empty()) return;
  if (std::all_of(directions.begin(), directions.end(), [&](const Direction& d) { return map.is_near(d); })) {
    draw_hull(scene, map, directions, style);
    draw_name(scene, map, directions, style);
  }
  for (const bool near : {false, true}) {
    std::set<std::pair<long, long>> bins;
    std::vector<Pixel> places;
    for (const Direction& d : directions) {
      if (map.is_near(d) != near) continue;
      const Pixel p = map.place(d);
      if (bins.insert({std::lround(p.x / 1.5), std::lround(p.y / 1.5)}).second) places.push_back(p);
    }
    if (!places.empty()) scene.dots(places, style.colour, 1.8).opacity = !near ? 0.25 : style.dashed ? 0.6 : 1;
  }
}

}  // namespace udcp
