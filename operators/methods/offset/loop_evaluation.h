// Loop surfaces, and any field of control vectors on their mesh, at every parameter: exact up to rounding, boundaries included.
#pragma once

#include <Eigen/Core>
#include <map>
#include <memory>

#include "operators/methods/offset/loop_patch.h"

namespace udcp {

struct LoopPoint {
  /// Rows: value, and where `has_derivatives` also the derivatives by v, w, vv, vw, ww; a column per column of the field.
  Points<double> values;
  bool has_derivatives = false;  // not at irregular vertices, nor at irregular points of the boundary
};

/// Evaluates the limit of fields at the point v, w of a face: v is the weight of its second corner, w of its third.
class LoopEvaluation {
 public:
  /// Throws what validate_loop_mesh throws.
  LoopEvaluation(std::shared_ptr<const Mesh> mesh, Tags tags);
  /// `field` has a row per vertex. v, w >= 0, v + w <= 1, else Error{input, "E_PARAMETER_RANGE"}; a face out of range is E_INDEX.
  /// A face with more than one irregular vertex, or an irregular one on the boundary, is refined with the faces around it until
  /// the point lies in a patch, at most 60 times.
  [[nodiscard]] LoopPoint at(const Points<double>& field, int face, double v, double w) const;

 private:
  std::shared_ptr<const Mesh> mesh_;
  Tags tags_;
  std::map<int, PatchStep<double>> steps_;  // by valence, up to a moderate one
};

/// Principal curvatures, eigenvalues of the derivative of the unit normal: a sphere of radius R seen from outside has 1/R.
struct Curvature {
  double least = 0, greatest = 0;
  Eigen::RowVector3d position = Eigen::RowVector3d::Zero(), normal = Eigen::RowVector3d::Zero();
};
/// From the six rows of a LoopPoint with three columns. Error{input, "E_ZERO_NORMAL"} where x_v and x_w are parallel.
Curvature curvature(const Points<double>& values);

}  // namespace udcp
