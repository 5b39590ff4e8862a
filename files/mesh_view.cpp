// Views of surfaces and flat meshes, their checks, and the numbers that every binary format needs.
#include "files/mesh_view.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "files/geometry_file.h"

namespace udcp {
namespace {

using Vector = Eigen::Vector3d;

[[noreturn]] void fail(const char* code, const std::string& message, const std::string& help = {}) {
  throw Error(ErrorKind::input, code, message, help);
}

/// The first row of three with a value beyond `most`, which may be infinite; the number of rows if there is none.
template <class R>
std::size_t first_beyond(std::span<const R> values, R most) {
  constexpr std::size_t block = 3 * 1024;
  for (std::size_t start = 0; start < values.size(); start += block) {
    const auto part = values.subspan(start, std::min(block, values.size() - start));
    unsigned bad = 0;  // counted without a branch, so that the compiler makes vectors of it
    for (const R value : part) bad += std::abs(value) <= most ? 0U : 1U;
    if (bad == 0) continue;
    const auto found = std::ranges::find_if(part, [most](R value) { return !(std::abs(value) <= most); });
    return (start + static_cast<std::size_t>(found - part.begin())) / 3;
  }
  return values.size() / 3;
}

template <class R>
Vector point(const MeshView<R>& mesh, std::uint32_t v) {
  const auto p = mesh.point(v);
  return {p[0], p[1], p[2]};
}

/// Twice the area of a face times its normal.
template <class R>
Vector area_of(const MeshView<R>& mesh, std::span<const std::uint32_t> corners) {
  const Vector origin = point(mesh, corners[0]);
  Vector last = point(mesh, corners[1]) - origin, area = Vector::Zero();
  for (std::size_t k = 2; k < corners.size(); ++k) {
    const Vector next = point(mesh, corners[k]) - origin;
    area += last.cross(next);
    last = next;
  }
  return area;
}

/// Area-weighted sums of face normals, not of unit length, three numbers per vertex.
template <class R>
std::vector<double> area_normals(const MeshView<R>& mesh) {
  std::vector<double> normals(mesh.points.size(), 0.0);
  const std::size_t faces = mesh.faces();
  for (std::size_t f = 0; f < faces; ++f) {
    const auto corners = mesh.face(f);
    const Vector area = area_of(mesh, corners);
    for (const std::uint32_t v : corners) {
      for (std::size_t c = 0; c < 3; ++c) normals[std::size_t{3} * v + c] += area[static_cast<Eigen::Index>(c)];
    }
  }
  return normals;
}

/// Squared lengths in this range come out of their own sum without loss.
bool is_plain(double squared) { return squared > 1e-200 && squared < 1e200; }

bool has_direction(const double* n) {
  return is_plain(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]) ||
         (std::isfinite(n[0]) && std::isfinite(n[1]) && std::isfinite(n[2]) && (n[0] != 0 || n[1] != 0 || n[2] != 0));
}

/// The unit vector of that direction, as floats.
char* put_unit(char* to, const double* n) {
  const double squared = n[0] * n[0] + n[1] * n[1] + n[2] * n[2];
  if (is_plain(squared)) {
    const double scale = 1 / std::sqrt(squared);
    for (std::size_t c = 0; c < 3; ++c) to = put_bytes(to, static_cast<float>(n[c] * scale));
    return to;
  }
  const Vector unit = Vector(n[0], n[1], n[2]).stableNormalized();
  for (Eigen::Index c = 0; c < 3; ++c) to = put_bytes(to, static_cast<float>(unit(c)));
  return to;
}

/// Whether all normals have length 1 but for the rounding of floats.
bool are_units(std::span<const float> normals) {
  bool all = true;
  for (std::size_t k = 0; k + 2 < normals.size(); k += 3) {
    const double x{normals[k]}, y{normals[k + 1]}, z{normals[k + 2]};
    all = all && std::abs(x * x + y * y + z * z - 1) < 1e-6;
  }
  return all;
}

}  // namespace

MeshView<double> view_of(const Surface<double>& surface, const SaveOptions& options, Points<double>& padded) {
  validate(surface);
  if (surface.points.cols() > 3) {
    fail("E_DIMENSION", "points with " + std::to_string(surface.points.cols()) + " coordinates; files hold three");
  }
  if (options.normals && (options.normals->rows() != surface.points.rows() || options.normals->cols() != 3)) {
    fail("E_POINTS", "the normals do not fit the surface: one row of three numbers per vertex is needed");
  }
  const auto all = [](const Points<double>& points) { return std::span(points.data(), static_cast<std::size_t>(points.size())); };
  const bool narrow = surface.points.cols() < 3;
  if (narrow) {
    padded = Points<double>::Zero(surface.points.rows(), 3);
    padded.leftCols(surface.points.cols()) = surface.points;
  }
  const Mesh& mesh = *surface.mesh;
  MeshView<double> view;
  view.points = all(narrow ? padded : surface.points);
  if (options.normals) view.normals = all(*options.normals);
  view.corners = {reinterpret_cast<const std::uint32_t*>(mesh.vertex.data()), mesh.vertex.size()};  // none is negative
  view.begin = mesh.face_begin;
  view.surface = &surface;
  return view;
}

template <class R>
MeshView<R> view_of(const FlatMesh<R>& mesh, const SaveOptions& options) {
  if (mesh.corners_per_face < 3) {
    fail("E_FACE_SIZE", "the faces have " + std::to_string(mesh.corners_per_face) + " corners; faces need at least three");
  }
  const auto sides = static_cast<std::size_t>(mesh.corners_per_face);
  if (mesh.corners.empty()) fail("E_NO_FACES", "the mesh has no face", "a mesh needs at least one face of three corners");
  if (mesh.points.size() % 3 != 0 || mesh.corners.size() % sides != 0)
    fail("E_POINTS", "the arrays of the mesh end inside a vertex or a face");
  if (!mesh.normals.empty() && mesh.normals.size() != mesh.points.size())
    fail("E_POINTS", "the normals do not fit the mesh: three numbers per vertex are needed");
  if (options.normals) fail("E_POINTS", "normals are given beside the mesh; a flat mesh holds its own");
  return {mesh.points.span(), mesh.normals.span(), mesh.corners.span(), {}, sides, nullptr};
}

template <class R>
void check_for_writing(const MeshView<R>& mesh) {
  const std::size_t v = first_beyond(mesh.points, std::numeric_limits<R>::max());
  if (v < mesh.vertices()) {
    fail("E_NOT_FINITE", "vertex " + std::to_string(v) + " has a coordinate that is not finite; nothing was written",
         "look for a division by zero or an overflow in the parameters");
  }
  if (mesh.surface) return;  // its corners were checked when its mesh was made
  std::uint32_t most = 0;
  for (const std::uint32_t corner : mesh.corners) most = std::max(most, corner);
  if (most < mesh.vertices()) return;
  const auto found = std::ranges::find_if(mesh.corners, [&](std::uint32_t corner) { return corner >= mesh.vertices(); });
  fail("E_INDEX", "face " + std::to_string(static_cast<std::size_t>(found - mesh.corners.begin()) / mesh.sides) +
                      " names vertex " + std::to_string(*found) + ", but there are " + std::to_string(mesh.vertices()) +
                      " vertices");
}

void check_for_writing(const Surface<double>& surface) {
  Points<double> padded;
  check_for_writing(view_of(surface, {}, padded));
}

template <class R>
void check_for_floats(const MeshView<R>& mesh) {
  check_for_writing(mesh);
  if constexpr (std::is_same_v<R, float>) return;
  const std::size_t v = first_beyond(mesh.points, R{std::numeric_limits<float>::max()});
  if (v == mesh.vertices()) return;
  fail("E_FLOAT_RANGE", "vertex " + std::to_string(v) + " has a coordinate beyond 3.4e38, which STL and glTF cannot hold",
       "save as OBJ, OFF or PLY");
}

template <class R>
void check_normals(const MeshView<R>& mesh) {
  const std::size_t v = first_beyond(mesh.normals, std::numeric_limits<R>::max());
  if (3 * v == mesh.normals.size()) return;
  fail("E_NOT_FINITE", "vertex " + std::to_string(v) + " has a normal that is not finite; nothing was written");
}

template <class R>
void write_floats(Writer& out, const MeshView<R>& mesh) {
  if constexpr (std::is_same_v<R, float>) return out.write(mesh.points);
  for (const R value : mesh.points) out.filled(put_bytes(out.room(4), static_cast<float>(value)));
}

template <class R>
void write_unit_normals(Writer& out, const MeshView<R>& mesh) {
  if constexpr (std::is_same_v<R, float>) {
    if (!mesh.normals.empty() && are_units(mesh.normals)) return out.write(mesh.normals);
  }
  std::vector<double> weighted;  // made when the first vertex needs it
  const double up[3] = {0, 0, 1};
  for (std::size_t k = 0; k < mesh.points.size(); k += 3) {
    double given[3] = {0, 0, 0};
    if (!mesh.normals.empty()) std::copy_n(mesh.normals.data() + k, 3, given);
    const double* normal = given;
    if (!has_direction(normal)) {
      if (weighted.empty()) weighted = area_normals(mesh);
      normal = weighted.data() + k;
    }
    if (!has_direction(normal)) normal = up;
    out.filled(put_unit(out.room(12), normal));
  }
}

#define UDCP_MESH_VIEW(R)                                               \
  template MeshView<R> view_of(const FlatMesh<R>&, const SaveOptions&); \
  template void check_for_writing(const MeshView<R>&);                  \
  template void check_for_floats(const MeshView<R>&);                   \
  template void check_normals(const MeshView<R>&);                      \
  template void write_floats(Writer&, const MeshView<R>&);              \
  template void write_unit_normals(Writer&, const MeshView<R>&);
UDCP_MESH_VIEW(float)
UDCP_MESH_VIEW(double)
#undef UDCP_MESH_VIEW

}  // namespace udcp
