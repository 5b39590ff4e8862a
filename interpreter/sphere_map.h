// Directions in space as dots on a disc. Knows colours and places, no meshes.
#pragma once

#include <vector>

#include "interpreter/direction.h"
#include "interpreter/picture_scene.h"

namespace udcp {

/// Lambert's azimuthal map around a centre, a unit vector: the near half of the sphere fills the disc, and the far half is folded
/// over it. It keeps areas.
class SphereMap {
 public:
  SphereMap(const Direction& centre, Pixel place, double radius);
  [[nodiscard]] bool is_near(const Direction& d) const;
  [[nodiscard]] Pixel place(const Direction& d) const;
  [[nodiscard]] Pixel middle() const { return place_; }
  /// Central projection to the tangent plane, for directions of the near half, and back.
  [[nodiscard]] std::array<double, 2> to_plane(const Direction& d) const;
  [[nodiscard]] Direction of_plane(double x, double y) const;

 private:
  Direction towards_, right_, up_;
  Pixel place_;
  double radius_;
};

struct FamilyStyle {
  const char* name;
  const char* colour;
  bool dashed;
};
/// Dots, pale on the far half. If all are near, also the name and the area of the cone, which great circles bound.
void draw_family(Scene& scene, const SphereMap& map, const std::vector<Direction>& directions, const FamilyStyle& style);

}  // namespace udcp
