// Does an offset of a Loop surface meet or fold over itself? Tests on a refined mesh (approximate), the prediction from the
// curvatures of S, and hits as pairs of faces. The certificate of their absence is in embedded_surface.h.
#pragma once

#include <string_view>
#include <utility>
#include <vector>

#include "operators/run.h"

namespace udcp {

enum class OffsetVerdict { clean, inverted, folded, self_intersecting };
std::string_view name_of(OffsetVerdict verdict);

/// At the vertices and faces of the `rounds` times refined mesh. Approximate: triangles between limit points stand for patches.
struct SelfIntersection {
  OffsetVerdict verdict = OffsetVerdict::clean;  // self_intersecting if hits, else folded if folds, else inverted
  Surface<double> surface;                       // limit points of F on the refined mesh
  std::vector<std::pair<int, int>> hits;         // faces of it without a common vertex whose limit triangles meet, by number
  std::vector<int> folds;                        // vertices with an incident limit triangle turned against F's normal
  std::vector<int> inverted;  // vertices where the map from S to F, in tangents, has determinant <= 0 or trace <= 0
  int rounds = 0;
};
/// `surface` and `d`: S and the control vectors of F - S. At most `most_hits` pairs are kept (Error{limit, "E_MAX_HITS"} beyond).
SelfIntersection find_self_intersections(const Surface<double>& surface, const Points<double>& d, int rounds = 1,
                                         const RunControl& control = {}, int most_hits = 1'000'000);
/// Pairs of the faces of the mesh before refinement, each once and ordered.
std::vector<std::pair<int, int>> coarse_hits(const SelfIntersection& found);
/// Per vertex of the refined mesh: 1 where a face is hit, 0.5 where folded or inverted, else 0; for colours.
std::vector<double> marks(const SelfIntersection& found);

/// Curvatures of S sampled over its faces. The exact offset by a distance has no local fold there iff 1 + distance k > 0 for both
/// principal curvatures. Around vertices of valence 3 and 7 or more curvature is unbounded in general: an eighth of the faces
/// there is left out, and `excluded` counts such vertices; so are places without a normal. Approximate.
struct CurvatureRange {
  double least = 0, greatest = 0;
  int least_face = 0, greatest_face = 0;
  Eigen::RowVector3d least_place = Eigen::RowVector3d::Zero(), greatest_place = Eigen::RowVector3d::Zero();
  int excluded = 0;
  /// Distances between these do not fold (infinite where no curvature limits them).
  [[nodiscard]] double lowest_distance() const { return greatest > 0 ? -1 / greatest : -HUGE_VAL; }
  [[nodiscard]] double highest_distance() const { return least < 0 ? -1 / least : HUGE_VAL; }
};
CurvatureRange curvature_range(const Surface<double>& surface, const RunControl& control = {});

}  // namespace udcp
