// Conditions under which a closed Loop surface does not meet itself: discs around vertices are graphs over planes (normals in an
// open half-space, boundary curves that project to closed curves round a point), and any two patches without a common disc have
// convex hulls with a plane between them. Enclosures; directions come from outside.
#pragma once

#include <array>
#include <atomic>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "operators/methods/offset/patch_bounds.h"
#include "proofs/loop_facts.h"

namespace udcp {

/// Thirteen directions with entries -1, 0, 1, no two opposite: number 0 to 2 are the axes.
inline constexpr int plane_directions = 13;
const std::array<int, 3>& plane_direction(int k);

/// A patch or a part of one: its control net, and the ranges along all directions of points whose convex hull holds it (Bezier
/// points if it is regular, control points otherwise). Its parts are made when first asked for.
struct PatchPiece {
  Points<Interval> net;
  std::array<std::pair<Interval, Interval>, plane_directions> range;
  std::unique_ptr<std::array<PatchPiece, 4>> parts;
};

class EmbeddingFacts {
 public:
  /// The patches after `rounds` rounds. Throws Rejected unless irregular vertices are at least four edges apart, for then one
  /// disc holds any two faces with a common vertex. Error{interrupted} when told to stop.
  EmbeddingFacts(const LoopMesh& surface, int rounds, const std::atomic<bool>* stop = nullptr);

  [[nodiscard]] const Mesh& mesh() const { return *patches_.mesh; }
  /// Faces around v, and around the irregular vertex next to it if there is one.
  [[nodiscard]] std::vector<int> disc(int v) const;
  /// The disc of v is a disc, its normals have a positive product with the axis, and its boundary goes once around the limit of
  /// v (or the middle of the limits of v and its irregular neighbour), always forward, seen along the axis. Then it projects
  /// one to one.
  [[nodiscard]] bool is_graph(int v, const std::array<int, 3>& axis) const;
  /// A direction for is_graph: not checked.
  [[nodiscard]] std::array<int, 3> likely_axis(int v) const;

  /// Pairs f < g of faces without a common vertex whose boxes (outward-rounded) overlap: all others are apart.
  [[nodiscard]] std::vector<std::pair<int, int>> close_pairs() const;
  /// The patch of a face; the parts at its corner and the regular ones of a piece.
  [[nodiscard]] PatchPiece& piece(int face) { return pieces_[static_cast<std::size_t>(face)]; }
  [[nodiscard]] std::array<PatchPiece, 4>& parts(PatchPiece& whole) const;
  /// Whether a plane across the direction separates them.
  [[nodiscard]] static bool are_separated(const PatchPiece& a, const PatchPiece& b, int direction);

 private:
  [[nodiscard]] int irregular_neighbour(int v) const;  // v itself if it is; -1
  [[nodiscard]] bool has_normals_along(int face, const std::array<int, 3>& axis) const;
  [[nodiscard]] std::optional<std::vector<int>> boundary(const std::vector<int>& faces) const;
  [[nodiscard]] bool goes_round(const std::vector<int>& boundary, const std::array<Interval, 3>& centre,
                                const std::array<int, 3>& axis) const;
  [[nodiscard]] std::optional<Points<Interval>> edge_curve(int half_edge) const;
  [[nodiscard]] std::array<Interval, 3> limit_of(int v) const;

  [[nodiscard]] static PatchPiece piece_of(Points<Interval> net);

  EnclosedPatches patches_;
  std::vector<PatchPiece> pieces_;  // per face
  std::map<int, PatchStep<Interval>> steps_;
  std::vector<std::optional<NormalCone<Interval>>> cone_;  // per face, irregular ones
  std::vector<Points<Interval>> bezier_, normal_;          // per face, regular ones
  std::map<int, Interval> weight_;                         // by valence
  std::vector<std::vector<int>> rings_;
};

}  // namespace udcp
