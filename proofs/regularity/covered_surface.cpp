// Refined meshes and what covers their faces; sentences.
#include "proofs/regularity/covered_surface.h"

#include <algorithm>

#include "operators/run.h"
#include "operators/schemes.h"

namespace udcp {
namespace {

/// All corners of the faces at the vertex, but the vertex itself, are inside and of valence 4.
bool has_regular_ring(const QuadMesh& quads, int v) {
  const Mesh& mesh = quads.mesh();
  const int start = mesh.outgoing[static_cast<std::size_t>(v)];
  int h = start;
  do {
    for (const int w : mesh.corners(mesh.face[static_cast<std::size_t>(h)]))
      if (w != v && quads.class_of(w) != VertexClass::interior) return false;
    h = mesh.around(h);
  } while (h != start);
  return true;
}

Vector3 row(const Points<Rational>& points, Eigen::Index v) { return {points(v, 0), points(v, 1), points(v, 2)}; }

/// Points of a plane in coordinates of the plane, so that the verdict does not depend on where the plane lies: regularity does
/// not change under affine maps, and refinement commutes with them. Other points stay as they are.
Surface<Rational> flattened(Surface<Rational> surface) {
  Points<Rational>& points = surface.points;
  if (points.cols() != 3) return surface;
  const Vector3 origin = row(points, 0);
  Vector3 p{}, normal{};
  bool is_flat = true, is_level = true;
  for (Eigen::Index v = 0; v < points.rows() && is_flat; ++v) {
    const Vector3 x = row(points, v) - origin;
    is_level = is_level && points(v, 2).is_zero();
    if (is_zero(p)) p = x;
    if (is_zero(normal)) normal = cross(p, x);
    is_flat = dot(normal, x).is_zero();
  }
  if (!is_flat || is_level || is_zero(normal)) return surface;
  const Vector3 q = cross(normal, p);
  for (Eigen::Index v = 0; v < points.rows(); ++v) {
    const Vector3 x = row(points, v) - origin;
    points(v, 0) = dot(x, p);
    points(v, 1) = dot(x, q);
    points(v, 2) = Rational(0);
  }
  return surface;
}

Surface<Rational> refined(const Surface<Rational>& surface, RegularityMode mode, int steps, const RunControl& control) {
  (void)common_denominator(surface.points);  // before the numbers grow
  if (steps == 0) return surface;
  if (mode == RegularityMode::interior && !is_closed(*surface.mesh))
    throw Rejected("mode interior has no boundary rule, so an open mesh cannot be refined in it");
  const std::int64_t sides = surface.mesh->half_edges();
  if (steps > most_regularity_steps || sides * (std::int64_t{1} << (2 * (steps - 1))) > most_regularity_faces)
    throw Error(ErrorKind::limit, "E_TOO_LARGE",
                "the mesh after " + std::to_string(steps) + " steps would have more than " +
                    std::to_string(most_regularity_faces) + " faces",
                "take a part of the mesh");
  return run(schemes::catmull_clark(), surface, steps, control);
}

void sort_faces(CoveredSurface& s) {
  const Mesh& mesh = s.mesh.mesh();
  std::vector<char> has_rings(static_cast<std::size_t>(mesh.vertices()), 0), blamed(has_rings);
  for (int v = 0; v < mesh.vertices(); ++v) {
    if (s.mesh.class_of(v) != VertexClass::extraordinary || !has_regular_ring(s.mesh, v)) continue;
    has_rings[static_cast<std::size_t>(v)] = 1;
    s.rings.push_back(v);
  }
  for (int f = 0; f < mesh.faces(); ++f) {
    const FaceKind kind = s.mesh.kind_of(f, s.mode);
    if (kind == FaceKind::patch) s.patches.push_back(f);
    if (kind != FaceKind::excluded) continue;
    const auto corners = mesh.corners(f);
    if (std::any_of(corners.begin(), corners.end(), [&](int v) { return has_rings[static_cast<std::size_t>(v)] != 0; })) continue;
    s.uncovered.push_back(f);
    for (const int v : corners) {
      const VertexClass c = s.mesh.class_of(v);
      if (c != VertexClass::interior && c != VertexClass::boundary && c != VertexClass::corner)
        blamed[static_cast<std::size_t>(v)] = 1;
    }
  }
  for (int v = 0; v < mesh.vertices(); ++v)
    if (blamed[static_cast<std::size_t>(v)] != 0) s.uncovered_around.push_back(v);
}

std::string plural(std::size_t n, const std::string& one, const std::string& many) {
  return std::to_string(n) + " " + (n == 1 ? one : many);
}

}  // namespace

bool is_closed(const Mesh& mesh) { return std::find(mesh.twin.begin(), mesh.twin.end(), -1) == mesh.twin.end(); }

std::string to_string(RegularityMode mode) { return mode == RegularityMode::interior ? "interior" : "bspline"; }

CoveredSurface cover(const Surface<Rational>& surface, RegularityMode mode, int steps, const RunControl& control) {
  CoveredSurface result{
      QuadMesh(refined(flattened(surface), mode, steps, control)), mode, steps, surface.mesh->all_faces_have(4), {}, {}, {}, {}};
  sort_faces(result);
  return result;
}

bool is_isolated(const CoveredSurface& surface) {
  if (surface.patches.empty()) return false;
  return std::none_of(surface.uncovered_around.begin(), surface.uncovered_around.end(),
                      [&](int v) { return surface.mesh.class_of(v) == VertexClass::extraordinary; });
}

bool leaves_out_boundary_only(const CoveredSurface& surface) {
  return std::all_of(surface.uncovered_around.begin(), surface.uncovered_around.end(),
                     [&](int v) { return surface.mesh.mesh().on_boundary(v); });
}

std::string name_of_surface(const Json& mesh, RegularityMode mode) {
  return std::string("the Catmull-Clark surface of the mesh with ") + plural(mesh["points"].size(), "vertex", "vertices") +
         " and " + plural(mesh["faces"].size(), "face", "faces") + " (digest " + digest(mesh.dump()) + ")" +
         (mode == RegularityMode::interior ? ", over the faces without boundary vertices," : "");
}

std::string regular_statement(const Json& mesh, const CoveredSurface& surface, bool embedded) {
  std::string text = name_of_surface(mesh, surface.mode) + " is regular";
  if (!surface.uncovered.empty())
    text += " except perhaps on " + plural(surface.uncovered.size(), "face", "faces") + " of level " +
            std::to_string(surface.steps) + " around " +
            plural(surface.uncovered_around.size(), "boundary vertex", "boundary vertices");
  return text + (embedded ? " and does not meet itself" : "");
}

std::string irregular_statement(const Json& mesh, RegularityMode mode) { return name_of_surface(mesh, mode) + " is not regular"; }

}  // namespace udcp
