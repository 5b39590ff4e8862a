// The cones of difference vectors of a quad mesh, before and after Catmull-Clark steps: what cones() reports and draws. Whether
// cones are separated is decided exactly (Theorem 3 of "On Regularity of Catmull-Clark Subdivision Surfaces", corrected form);
// degrees are floating point, for people. Knows no value of the language and no file format.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "interpreter/direction.h"
#include "operators/run.h"
#include "proofs/regularity/quad_mesh.h"

namespace udcp {

/// Of length 1; of any non-zero exact vector, however large.
Direction direction_of(const Vector3& vector);

/// Whether cone(U) and cone(V) are pointed, and cone(V) and its opposite meet cone(U) in 0 alone. The last two are left open
/// where a cone is not pointed: then nothing is separated anyway.
struct ConeTest {
  bool has_zero = false;  // a zero difference that may not be ignored
  bool pointed_u = false, pointed_v = false;
  std::optional<bool> apart, apart_from_opposite;
  std::optional<Vector3> n, m;  // n.u > 0 > n.v; m.u, m.v > 0
  [[nodiscard]] bool separated() const { return !has_zero && n && m; }
};
/// Exact. Zero vectors among the differences count as has_zero only if `zeros_matter`.
ConeTest test_cones(const Differences& differences, bool zeros_matter);

/// The directions of one family, u or v.
struct Sector {
  std::vector<Vector3> directions;  // each once, coprime integers, in order of their entries
  double from = 0;                  // planar: the direction after the largest gap, in degrees in (-180, 180]
  double width = 0;                 // planar: 360 minus the largest gap; in space twice the angle of the smallest round cone
  std::optional<std::array<Vector3, 2>> ends;  // planar and pointed: the extreme directions, counter-clockwise
};

/// One level of the study: a mesh, and the differences whose cones are shown.
struct ConeLevel {
  QuadMesh mesh;
  int patches = 0, excluded = 0;  // faces
  int parts = 1, passed = 0;      // components with T1, or patches with T2: what the verdict is about
  int shown = 0;                  // the component, or the patch
  ConeTest test;                  // of what is shown; of all parts of a face together, which may meet though each part passes
  Sector u, v;
  std::optional<double> gap, gap_to_opposite;  // between cone(U) and cone(V), cone(-V); negative: so much of an overlap
  std::vector<char> family;                    // per edge: 0 not among what is shown, 1 u, 2 v
  std::vector<char> marked;                    // per face: 1 for the patch that is shown
  [[nodiscard]] bool holds() const { return parts > 0 && passed == parts; }
};

struct ConeStudy {
  /// What the vectors are: all edges of a component in one frame (T1), the differences of the worst patch of each level where
  /// there is no such frame, or those of all parts of one face (T2).
  enum class Subject { mesh, worst_patch, face } subject = Subject::mesh;
  RegularityMode mode = RegularityMode::bspline;
  int face = -1;
  bool is_refined = true;         // false: mode interior has no rule to refine an open mesh, so only level 0 is there
  std::vector<ConeLevel> levels;  // 0 to steps
};

struct ConeOptions {
  RegularityMode mode = RegularityMode::bspline;
  int steps = 2;
  std::optional<int> face;
  RunControl control{};  // limits, stop
};
/// Throws what QuadMesh throws; Error{input, "E_INDEX"} for a face that there is not, "E_NO_PATCH" for one that is no patch or a
/// mesh that needs patches and has none; Error{limit, "E_MAX_FACES"} where the pictures would need more than 50,000 faces.
ConeStudy study_cones(const Surface<Rational>& surface, const ConeOptions& options);

/// The centre of the smallest round cone around directions that lie in an open half space, and the angle to its rim in degrees;
/// nothing if floating point finds no such half space.
struct RoundCone {
  Direction centre{};
  double angle = 0;
};
std::optional<RoundCone> smallest_round_cone(const std::vector<Direction>& directions);

/// "patch", "excluded" with the reason, or "outside", in words: "face 3 is no patch: vertex 7 is a boundary vertex of 3 faces".
std::string why_no_patch(const QuadMesh& mesh, int face, RegularityMode mode);
/// Error{input, "E_INDEX"} unless the mesh has the face.
void require_face(const Mesh& mesh, int face);

}  // namespace udcp
