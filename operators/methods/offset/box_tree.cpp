// Median splits along the longest side.
#include "operators/methods/offset/box_tree.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>

namespace udcp {
namespace {

std::size_t at(int k) { return static_cast<std::size_t>(k); }

constexpr int leaf_size = 4;

using Vector = Eigen::Vector3d;

/// Whether the segment p q meets the triangle; false where they are in one plane.
bool segment_meets(const Vector& p, const Vector& q, const std::array<Vector, 3>& t) {
  const Vector n = (t[1] - t[0]).cross(t[2] - t[0]);
  const double a = n.dot(p - t[0]), b = n.dot(q - t[0]);
  if ((a > 0 && b > 0) || (a < 0 && b < 0) || a == b) return false;
  const Vector x = p + a / (a - b) * (q - p);
  for (std::size_t k = 0; k < 3; ++k)
    if (n.dot((t[(k + 1) % 3] - t[k]).cross(x - t[k])) < 0) return false;
  return true;
}

}  // namespace

BoxTree::BoxTree(std::vector<SpaceBox> boxes) : boxes_(std::move(boxes)), order_(boxes_.size()) {
  std::iota(order_.begin(), order_.end(), 0);
  if (!boxes_.empty()) build(0, static_cast<int>(boxes_.size()));
}

int BoxTree::build(int first, int count) {
  const int index = static_cast<int>(nodes_.size());
  nodes_.emplace_back();
  SpaceBox box;
  for (int k = first; k < first + count; ++k) {
    box.include(boxes_[at(order_[at(k)])].low);
    box.include(boxes_[at(order_[at(k)])].high);
  }
  nodes_[at(index)].box = box;
  nodes_[at(index)].first = first;
  nodes_[at(index)].count = count;
  if (count <= leaf_size) return index;
  Eigen::Index axis = 0;
  (box.high - box.low).maxCoeff(&axis);
  const auto begin = order_.begin() + first;
  const auto key = [&](int i) { return boxes_[at(i)].low[axis] + boxes_[at(i)].high[axis]; };
  std::nth_element(begin, begin + count / 2, begin + count,
                   [&](int i, int j) { return key(i) != key(j) ? key(i) < key(j) : i < j; });
  const int left = build(first, count / 2), right = build(first + count / 2, count - count / 2);
  nodes_[at(index)].left = left;
  nodes_[at(index)].right = right;
  return index;
}

bool BoxTree::cross(int a, int b, const std::function<bool(int, int)>& visit) const {
  const Node &x = nodes_[at(a)], &y = nodes_[at(b)];
  if (a != b && !x.box.overlaps(y.box)) return true;
  if (x.left < 0 && y.left < 0) {
    for (int i = x.first; i < x.first + x.count; ++i) {
      for (int j = a == b ? i + 1 : y.first; j < y.first + y.count; ++j) {
        const int p = order_[at(i)], q = order_[at(j)];
        if (boxes_[at(p)].overlaps(boxes_[at(q)]) && !visit(std::min(p, q), std::max(p, q))) return false;
      }
    }
    return true;
  }
  if (a == b) return cross(x.left, x.left, visit) && cross(x.left, x.right, visit) && cross(x.right, x.right, visit);
  if (y.left < 0 || (x.left >= 0 && x.count >= y.count)) return cross(x.left, b, visit) && cross(x.right, b, visit);
  return cross(a, y.left, visit) && cross(a, y.right, visit);
}

void BoxTree::pairs(const std::function<bool(int, int)>& visit) const {
  if (!nodes_.empty()) cross(0, 0, visit);
}

int BoxTree::nearest(const Eigen::Vector3d& point, const std::function<double(int)>& distance) const {
  int best = -1;
  double least = HUGE_VAL;
  std::vector<int> stack{0};
  while (!stack.empty() && !nodes_.empty()) {
    const Node& node = nodes_[at(stack.back())];
    stack.pop_back();
    if (node.box.distance_to(point.array()) >= least) continue;
    if (node.left < 0) {
      for (int k = node.first; k < node.first + node.count; ++k) {
        const double d = distance(order_[at(k)]);
        if (d < least) least = d, best = order_[at(k)];
      }
      continue;
    }
    const bool left_first =
        nodes_[at(node.left)].box.distance_to(point.array()) <= nodes_[at(node.right)].box.distance_to(point.array());
    stack.push_back(left_first ? node.right : node.left);
    stack.push_back(left_first ? node.left : node.right);
  }
  return best;
}

Eigen::Vector3d nearest_in_triangle(const Eigen::Vector3d& point, const std::array<Eigen::Vector3d, 3>& t) {
  const Vector a = t[1] - t[0], b = t[2] - t[0], p = point - t[0];
  const double aa = a.dot(a), ab = a.dot(b), bb = b.dot(b), det = aa * bb - ab * ab;
  if (det > 0) {
    const double v = (bb * a.dot(p) - ab * b.dot(p)) / det, w = (aa * b.dot(p) - ab * a.dot(p)) / det;
    if (v >= 0 && w >= 0 && v + w <= 1) return {1 - v - w, v, w};
  }
  Vector best(1, 0, 0);
  double least = HUGE_VAL;
  for (int k = 0; k < 3; ++k) {
    const Vector &from = t[at(k)], side = t[at((k + 1) % 3)] - from;
    const double length = side.squaredNorm();
    const double s = length > 0 ? std::clamp((point - from).dot(side) / length, 0.0, 1.0) : 0.0;
    const double d = (from + s * side - point).squaredNorm();
    if (!(d < least)) continue;
    least = d;
    best = Vector::Zero();
    best[k] = 1 - s;
    best[(k + 1) % 3] = s;
  }
  return best;
}

bool triangles_meet(const std::array<Eigen::Vector3d, 3>& a, const std::array<Eigen::Vector3d, 3>& b) {
  for (std::size_t k = 0; k < 3; ++k)
    if (segment_meets(a[k], a[(k + 1) % 3], b) || segment_meets(b[k], b[(k + 1) % 3], a)) return true;
  return false;
}

}  // namespace udcp
