// Pictures of the cones of difference vectors, like figures 5 to 7 of "On Regularity of Catmull-Clark Subdivision Surfaces", as
// SVG text. Floating point draws; what the pictures say in words was decided exactly before.
#pragma once

#include <string>

#include "interpreter/sectors.h"

namespace udcp {

/// The first and the last level, one below the other: the mesh at the left, u edges in one colour and v edges in another, and
/// beside it the directions of their differences. In the plane: unit vectors from one point in sectors, -v dashed. In space: dots
/// on the sphere, once seen from the middle of u and v and once from the middle of u and -v, in Lambert's azimuthal map, which
/// keeps areas and so the density of directions. A separated pair lies in the near half of its map as a whole, which is what
/// the theorem asks; an orthographic view would crowd the dots at the rim, where this is seen.
std::string picture_of_cones(const ConeStudy& study);

/// "T1 holds: both cones are pointed, v and -v apart from u" and the like, exact. Of a face in parts the verdict is about each
/// part, and the cones are those of all parts together: "T2 holds on all 16 parts; together: the cones of u and v meet".
std::string verdict_of(const ConeLevel& level, ConeStudy::Subject subject);
/// "59.6°"
std::string degrees_text(double degrees);
/// "gap u to v 72.0°", "u and -v overlap by 4.3°"
std::string gap_text(const std::string& name, double gap);

}  // namespace udcp
