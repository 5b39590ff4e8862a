// A polynomial patch by its Bezier points, and what a modeller asks of it: points, derivatives, normals, curvature. Knows no
// mesh.
#pragma once

#include <array>
#include <vector>

#include "operators/number.h"

namespace udcp {

/// A point of a surface with its derivatives by the two parameters.
struct PatchJet {
  Eigen::Vector3d point, u, v, uu, uv, vv;
};

/// P(u, v) = sum of p_jk b_j(u) b_k(v) over Bernstein polynomials, 0 <= u, v <= 1; p_jk is row (degree_v + 1) j + k.
struct BezierPatch {
  int degree_u = 0, degree_v = 0;
  Points<double> points;  // three columns

  [[nodiscard]] PatchJet at(double u, double v) const;
};

/// Curvature at a point, with the normal u x v: H is half the trace of the shape operator with that normal.
struct SurfaceCurvature {
  bool is_regular = false;  // the rest is 0 where the derivatives are (nearly) parallel
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  double gaussian = 0, mean = 0;
  /// L a a^T + M (a b^T + b a^T) + N b b^T, with a, b dual to the derivatives: the same for every parametrisation with that
  /// normal.
  Eigen::Matrix3d tensor = Eigen::Matrix3d::Zero();
  /// The coefficients L, M, N of the second fundamental form.
  std::array<double, 3> second_form{};
};
SurfaceCurvature curvature(const PatchJet& jet);

/// The extrema over a grid of samples x samples points of each patch, its sides included; samples >= 2. Points that are not
/// regular are counted and left out.
struct CurvatureExtrema {
  double gaussian_low = 0, gaussian_high = 0, mean_low = 0, mean_high = 0;
  long long points = 0, irregular = 0;
  void include(const SurfaceCurvature& here);
  void include(const BezierPatch& patch, int samples);
};

}  // namespace udcp
