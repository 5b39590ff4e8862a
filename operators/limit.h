// Limit points, tangents and normals at the vertices of a mesh, from the atoms alone: neighbourhoods are pushed through run() on
// unit vectors until they repeat, and the dominant left eigenvectors of the repeating matrix are applied to the points.
#pragma once

#include <array>

#include "operators/neighbourhood.h"
#include "operators/run.h"

namespace udcp {

struct Limit {
  Points<double> points;  // a row per vertex of the input
  Points<double>
      tangents;  // six columns: two independent directions of the tangent plane, counter-clockwise; 0 where there is none
  Points<double> normals;  // unit; 0 0 0 where there is no tangent plane
};

/// Limit of a scheme at the vertices of `surface`, as the input of its head and round 0; or, with control.first_item > 0, as the
/// result of so many items of the word (the points of word^n are its input with word.items(n) items applied). Primal words only
/// (E_LIMIT_DUAL); noise and per-vertex parameters are refused (E_LIMIT_VARIES). Throws E_NO_LIMIT if the rows do not settle.
Limit limit(const Word& word, const Surface<double>& surface, const RunControl& control = {});
/// Rows that take the points of a neighbourhood of a vertex to its limit point and two tangents as above; zero rows where there
/// is no tangent plane.
struct LimitStencil {
  Eigen::RowVectorXd point;
  std::array<Eigen::RowVectorXd, 2> tangent;
};
/// The rings that such a neighbourhood needs. Throws what limit() throws about the word.
int limit_rings(const Word& word);
/// `around` has limit_rings(word) rings; control.first_item as in limit().
LimitStencil limit_stencil(const Word& word, const Neighbourhood& around, const RunControl& control = {});
/// Limit points of a curve at its points.
Points<double> limit(const Word& word, const Polyline<double>& curve, const RunControl& control = {});

}  // namespace udcp
