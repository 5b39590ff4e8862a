// A quad mesh as the regularity theorems see it: classes of vertices, the patches of a mode with their nets, groups, and the
// global frame of the paper's own test. Exact coordinates, scaled to integers once. Decides nothing.
#pragma once

#include <optional>

#include "operators/surface.h"
#include "proofs/regularity/bicubic_net.h"

namespace udcp {

/// interior: no boundary rule, the faces all of whose vertices are regular interior ones (the paper's reading). bspline: the
/// whole mesh with cubic B-spline boundary curves.
enum class RegularityMode { interior, bspline };

enum class VertexClass {
  interior,        // inside, valence 4
  extraordinary,   // inside, another valence
  boundary,        // two faces, no corner
  corner,          // one face, fixed
  smooth1,         // one face, not fixed: always singular
  bextraordinary,  // three faces or more, no corner
  tagged           // two faces or more, fixed
};
std::string to_string(VertexClass);

enum class FaceKind { patch, excluded, outside };

class QuadMesh {
 public:
  /// Corners are the tagged vertices. Coordinates of up to three columns are scaled by one integer. Throws what validate throws,
  /// Error{input, "E_NOT_QUADS"} naming the first face that is no quad, E_CORNER for tagged
  /// vertices inside, and Error{limit, "E_TOO_LARGE"} for coordinates of more
  /// than 10,000 bits in their common scale.
  explicit QuadMesh(const Surface<Rational>& surface);

  [[nodiscard]] const Surface<Rational>& surface() const { return surface_; }
  [[nodiscard]] const Mesh& mesh() const { return *surface_.mesh; }
  [[nodiscard]] bool is_planar() const { return planar_; }  // every z is 0
  [[nodiscard]] const Rational& scale() const { return scale_; }
  /// The point times scale(): integers.
  [[nodiscard]] const Vector3& point(int v) const { return points_[static_cast<std::size_t>(v)]; }
  [[nodiscard]] VertexClass class_of(int v) const { return classes_[static_cast<std::size_t>(v)]; }
  [[nodiscard]] FaceKind kind_of(int face, RegularityMode mode) const;
  /// The net of a patch: u from the first corner of the face to its second, v from the first to the fourth.
  [[nodiscard]] BicubicNet net(int face) const;
  /// Per face its group: patch faces connected through shared vertices; -1 for other faces.
  [[nodiscard]] std::vector<int> groups(RegularityMode mode) const;

 private:
  Surface<Rational> surface_;
  Rational scale_;
  std::vector<Vector3> points_;
  std::vector<VertexClass> classes_;
  bool planar_ = true;
};

/// The least positive integer that makes all coordinates integers. Error{limit, "E_TOO_LARGE"} above 10,000 bits.
Rational common_denominator(const Points<Rational>& points);

/// Every boundary vertex with one face becomes a corner, besides those that are already.
Surface<Rational> with_one_face_corners(Surface<Rational> surface);

/// Per face the corner at which +u begins, consistent over all shared edges; nothing if there is no such choice.
std::optional<std::vector<int>> global_frame(const Mesh& mesh);

}  // namespace udcp
