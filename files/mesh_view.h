// What writers see of a mesh, whether it is a Surface or a FlatMesh: flat arrays of points, normals and corners. Checks, unit
// normals and triangles are defined here once, so that both kinds of mesh give the same files. Knows no format.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "files/writer.h"
#include "operators/plan/flat_mesh.h"
#include "operators/surface.h"

namespace udcp {

struct SaveOptions;

/// Arrays of a mesh that lives elsewhere. R = float or double.
template <class R>
struct MeshView {
  std::span<const R> points;               // three per vertex
  std::span<const R> normals;              // empty, or three per vertex
  std::span<const std::uint32_t> corners;  // of all faces
  std::span<const int> begin;              // as in Mesh; empty: all faces have `sides` corners
  std::size_t sides = 0;
  const Surface<double>* surface = nullptr;  // for what the arrays do not say: tags, attributes, edges

  [[nodiscard]] std::size_t vertices() const { return points.size() / 3; }
  [[nodiscard]] std::size_t faces() const { return begin.empty() ? corners.size() / sides : begin.size() - 1; }
  [[nodiscard]] std::size_t triangles() const { return corners.size() - 2 * faces(); }
  [[nodiscard]] std::span<const std::uint32_t> face(std::size_t f) const {
    if (begin.empty()) return {corners.data() + f * sides, sides};
    return {corners.data() + begin[f], static_cast<std::size_t>(begin[f + 1] - begin[f])};
  }
  [[nodiscard]] std::array<double, 3> point(std::uint32_t v) const {
    const R* p = points.data() + std::size_t{3} * v;
    return {double{p[0]}, double{p[1]}, double{p[2]}};
  }
};

/// Throws Error{input}: what validate throws, more than three columns (E_DIMENSION), normals in the options that do not fit
/// (E_POINTS). `padded` holds the points where they have fewer than three columns.
MeshView<double> view_of(const Surface<double>& surface, const SaveOptions& options, Points<double>& padded);
/// Throws Error{input}: no face (E_NO_FACES), fewer than three corners a face (E_FACE_SIZE), arrays that do not fit each other or
/// normals in the options, where those of the mesh are meant (E_POINTS).
template <class R>
MeshView<R> view_of(const FlatMesh<R>& mesh, const SaveOptions& options);

/// Throws Error{input}: E_NOT_FINITE naming the vertex, E_INDEX for a corner beyond the vertices.
template <class R>
void check_for_writing(const MeshView<R>& mesh);
/// What view_of and this throw, for a surface.
void check_for_writing(const Surface<double>& surface);
/// The same, and E_FLOAT_RANGE for coordinates that do not fit a float.
template <class R>
void check_for_floats(const MeshView<R>& mesh);
/// Throws Error{input, "E_NOT_FINITE"} for a normal that is not finite.
template <class R>
void check_normals(const MeshView<R>& mesh);

/// Three floats per vertex: the points.
template <class R>
void write_floats(Writer& out, const MeshView<R>& mesh);
/// Three floats per vertex: unit normals. Those of the mesh; where they have no direction, area-weighted sums of face normals;
/// where these have none either, up.
template <class R>
void write_unit_normals(Writer& out, const MeshView<R>& mesh);

/// Calls visit(a, b, c) for the triangles of the faces: quads are cut along the shorter diagonal (the one from the first corner
/// if they are equal), larger faces are fans.
template <class R, class Visit>
void for_each_triangle(const MeshView<R>& mesh, Visit visit) {
  const auto squared_distance = [&mesh](std::uint32_t v, std::uint32_t w) {
    const auto p = mesh.point(v), q = mesh.point(w);
    const double x = p[0] - q[0], y = p[1] - q[1], z = p[2] - q[2];
    return x * x + y * y + z * z;
  };
  const std::size_t faces = mesh.faces();
  for (std::size_t f = 0; f < faces; ++f) {
    const auto c = mesh.face(f);
    if (c.size() == 4) {
      const bool turn = squared_distance(c[1], c[3]) < squared_distance(c[0], c[2]);
      visit(c[turn ? 1 : 0], c[turn ? 2 : 1], c[turn ? 3 : 2]);
      visit(c[turn ? 1 : 0], c[turn ? 3 : 2], c[turn ? 0 : 3]);
      continue;
    }
    for (std::size_t k = 1; k + 1 < c.size(); ++k) visit(c[0], c[k], c[k + 1]);
  }
}

}  // namespace udcp
