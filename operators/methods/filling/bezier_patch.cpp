// Bernstein sums, and differential geometry from two derivatives.
#include "operators/methods/filling/bezier_patch.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace udcp {
namespace {

constexpr int largest_degree = 15;

// Values and first two derivatives of the Bernstein polynomials of one degree at t.
struct Basis {
  std::array<std::array<double, largest_degree + 1>, 3> values{};

  Basis(int degree, double t) {
    std::array<double, largest_degree + 1> b{1};
    for (int d = 0; d <= degree; ++d) {
      const int order = degree - d;  // b holds degree d: its differences are derivatives of this order
      if (order <= 2) write(order, d, degree, b);
      for (int k = d + 1; k > 0; --k) b[at(k)] = (1 - t) * (k <= d ? b[at(k)] : 0) + t * b[at(k - 1)];
      b[0] *= 1 - t;
    }
  }

 private:
  static std::size_t at(int k) { return static_cast<std::size_t>(k); }
  void write(int order, int d, int degree, const std::array<double, largest_degree + 1>& b) {
    constexpr int signs[3][3] = {{1, 0, 0}, {-1, 1, 0}, {1, -2, 1}};
    const int factor = order == 0 ? 1 : order == 1 ? degree : degree * (degree - 1);
    for (int k = 0; k <= d; ++k)
      for (int s = 0; s <= order; ++s) values[at(order)][at(k + s)] += factor * signs[order][s] * b[at(k)];
  }
};

}  // namespace

PatchJet BezierPatch::at(double u, double v) const {
  if (degree_u < 0 || degree_u > largest_degree || degree_v < 0 || degree_v > largest_degree || points.cols() != 3 ||
      points.rows() != (degree_u + 1) * (degree_v + 1))
    throw Error(ErrorKind::internal, "E_INTERNAL", "the points of a patch do not fit its degrees");
  const Basis bu(degree_u, u), bv(degree_v, v);
  PatchJet jet;
  Eigen::Vector3d* const targets[3][3] = {{&jet.point, &jet.v, &jet.vv}, {&jet.u, &jet.uv, nullptr}, {&jet.uu, nullptr, nullptr}};
  for (auto& row : targets)
    for (Eigen::Vector3d* target : row)
      if (target != nullptr) target->setZero();
  const double* p = points.data();
  for (std::size_t j = 0; j <= static_cast<std::size_t>(degree_u); ++j) {
    std::array<Eigen::Vector3d, 3> row;  // derivatives by v of the curve of row j
    row.fill(Eigen::Vector3d::Zero());
    for (std::size_t k = 0; k <= static_cast<std::size_t>(degree_v); ++k, p += 3) {
      const Eigen::Vector3d q(p[0], p[1], p[2]);
      for (std::size_t b = 0; b < 3; ++b) row[b] += bv.values[b][k] * q;
    }
    for (std::size_t a = 0; a < 3; ++a)
      for (std::size_t b = 0; a + b < 3; ++b) *targets[a][b] += bu.values[a][j] * row[b];
  }
  return jet;
}

SurfaceCurvature curvature(const PatchJet& jet) {
  SurfaceCurvature result;
  const Eigen::Vector3d cross = jet.u.cross(jet.v);
  const double length = cross.norm();
  if (!(length > 1e-12 * jet.u.norm() * jet.v.norm())) return result;
  result.is_regular = true;
  result.normal = cross / length;
  const Eigen::Vector3d a = jet.v.cross(result.normal) / length, b = result.normal.cross(jet.u) / length;
  const double l = jet.uu.dot(result.normal), m = jet.uv.dot(result.normal), n = jet.vv.dot(result.normal);
  result.second_form = {l, m, n};
  result.tensor = l * a * a.transpose() + m * (a * b.transpose() + b * a.transpose()) + n * b * b.transpose();
  result.gaussian = (l * n - m * m) / (length * length);
  result.mean = result.tensor.trace() / 2;
  return result;
}

void CurvatureExtrema::include(const SurfaceCurvature& here) {
  if (!here.is_regular) {
    ++irregular;
    return;
  }
  gaussian_low = points == 0 ? here.gaussian : std::min(gaussian_low, here.gaussian);
  gaussian_high = points == 0 ? here.gaussian : std::max(gaussian_high, here.gaussian);
  mean_low = points == 0 ? here.mean : std::min(mean_low, here.mean);
  mean_high = points == 0 ? here.mean : std::max(mean_high, here.mean);
  ++points;
}

void CurvatureExtrema::include(const BezierPatch& patch, int samples) {
  for (int j = 0; j < samples; ++j)
    for (int k = 0; k < samples; ++k)
      include(curvature(patch.at(static_cast<double>(j) / (samples - 1), static_cast<double>(k) / (samples - 1))));
}

}  // namespace udcp
