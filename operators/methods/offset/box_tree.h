// Boxes around things in space, in a tree: which pairs overlap, and what lies nearest.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <functional>
#include <vector>

namespace udcp {

struct SpaceBox {
  Eigen::Array3d low = Eigen::Array3d::Constant(HUGE_VAL), high = Eigen::Array3d::Constant(-HUGE_VAL);
  void include(const Eigen::Array3d& point) {
    low = low.min(point);
    high = high.max(point);
  }
  [[nodiscard]] bool overlaps(const SpaceBox& other) const { return (low <= other.high).all() && (other.low <= high).all(); }
  [[nodiscard]] double distance_to(const Eigen::Array3d& point) const {
    return (low - point).max(point - high).max(0.0).matrix().norm();
  }
};

class BoxTree {
 public:
  explicit BoxTree(std::vector<SpaceBox> boxes);
  /// Every pair i < j of boxes that overlap, in an order that depends on the boxes only. `visit` false: stop.
  void pairs(const std::function<bool(int, int)>& visit) const;
  /// The smallest distance(i), given that it is at least that of box i from the point.
  [[nodiscard]] int nearest(const Eigen::Vector3d& point, const std::function<double(int)>& distance) const;

 private:
  struct Node {
    SpaceBox box;
    int first = 0, count = 0;   // of order_; leaves
    int left = -1, right = -1;  // inner nodes
  };
  int build(int first, int count);
  bool cross(int a, int b, const std::function<bool(int, int)>& visit) const;
  std::vector<SpaceBox> boxes_;
  std::vector<int> order_;
  std::vector<Node> nodes_;
};

/// The point of a triangle nearest to `point`, as weights of its corners.
Eigen::Vector3d nearest_in_triangle(const Eigen::Vector3d& point, const std::array<Eigen::Vector3d, 3>& corners);
/// Whether two triangles have a common point; touching counts.
bool triangles_meet(const std::array<Eigen::Vector3d, 3>& a, const std::array<Eigen::Vector3d, 3>& b);

}  // namespace udcp
