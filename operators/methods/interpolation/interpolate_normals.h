// Step 2 of interpolation: the rings of given vertices are moved so that the limit surface has given normals there and the limit
// points stay. "Catmull-Clark Subdivision Interpolation Based on Vertex Normal Vector Constraint", section 3; any valence >= 3.
#pragma once

#include <string>
#include <vector>

#include "operators/surface.h"

namespace udcp {

/// free: the least sum of squares over the ring. tied: the paper's (5), the same for e_k and f_k. Both project the tangents onto
/// the plane across the normal, so they cannot turn them by 90 degrees or more. rotate: turns them, keeping |C2 x C3|.
/// automatic: free while the cosine of the angle is above 1/10, else rotate.
enum class NormalStep { automatic, free, tied, rotate };

/// What was done at a vertex. none: no normal was prescribed. fixed: at a boundary vertex with one face, or a corner, the
/// boundary curve alone decides the tangent plane. no_plane: at a boundary vertex with four faces or more Catmull-Clark's
/// boundary rule leaves none.
enum class Correction : char { none, free, tied, rotate, fixed, no_plane };
std::string to_string(Correction correction);

struct VertexReport {
  Correction correction = Correction::none;
  double angle_before = 0;          // between the limit normal before and the one aimed at; NaN if there is none
  double displacement = 0;          // the largest of a control point of the ring
  double squared_displacement = 0;  // summed over the ring
  double off_boundary = 0;          // angle between the prescribed normal and the nearest one that the boundary tangent allows
  double length_ratio = 1;          // |C2 x C3| after against before; 0: no tangent plane is left
  [[nodiscard]] bool turns_over() const { return angle_before > 1.5707963267948966; }  // the surface folds, or stays turned over
};

struct NormalOptions {
  NormalStep step = NormalStep::automatic;
  std::vector<char> skipped;  // per vertex, 1: its normal is not prescribed; empty: all are
};

/// Error{input} unless there is a row of three numbers for each of `count` vertices (E_NORMALS), each finite and not 0 where it
/// is prescribed (E_NORMAL, naming the vertex).
void check_normals(const Points<double>& normals, int count, const std::vector<char>& skipped);

/// Sums of the area vectors of the faces around each vertex, as rows; quads give (p2 - p0) x (p3 - p1)/2.
template <class S>
Points<S> area_normals(const Surface<S>& surface);

struct TurnedNormals {
  Points<double> points;              // of all of `fine`
  std::vector<VertexReport> reports;  // per row of normals
};
/// Corrects the rings of the vertices 0 .. (rows of normals) - 1 of `fine`. They must not share points (which is so two steps
/// after the mesh whose vertices they were), and their faces must be quads. On the boundary only points inside move, so the
/// boundary curve stays and the normal is the prescribed one without its part along the boundary tangent. Throws what
/// check_normals throws, Error{input, "E_DIMENSION"} unless points have three columns, and Error{input, "E_TANGENTS"} naming the
/// vertex whose tangents are parallel (rotate and automatic), or whose normal has the direction of the boundary.
TurnedNormals turn_normals(const Surface<double>& fine, const Points<double>& normals, const NormalOptions& options = {});

/// How far `fine` is from points and normals at its first vertices; normals as turn_normals aims at them, those it cannot change
/// left out.
struct InterpolationErrors {
  double position = 0;  // largest distance
  double normal = 0;    // largest angle
  int reversed = 0;     // normals on the wrong side
};
InterpolationErrors interpolation_errors(const Surface<double>& fine, const Points<double>& points, const Points<double>& normals,
                                         const std::vector<char>& skipped_points = {},
                                         const std::vector<char>& skipped_normals = {});

}  // namespace udcp
