// Checks, normals and triangles for the writers.
#include "files/text_writer.h"

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <limits>

namespace udcp {
namespace {

using Vector = Eigen::Vector3d;

Vector point(const Surface<double>& surface, int v) {
  return {coordinate(surface.points, v, 0), coordinate(surface.points, v, 1), coordinate(surface.points, v, 2)};
}

}  // namespace

std::string comment_line(const std::string& word) {
  std::string line = "made by udcp";
  if (!word.empty()) line += ": ";
  for (const char c : word) line += c == '\n' || c == '\r' || c == '\0' ? ' ' : c;
  if (line.ends_with('\\')) line += ' ';  // a backslash would join the next line to the comment
  return line;
}

void check_for_writing(const Surface<double>& surface) {
  validate(surface);
  if (surface.points.cols() > 3) {
    throw Error(ErrorKind::input, "E_DIMENSION",
                "points with " + std::to_string(surface.points.cols()) + " coordinates; files hold three");
  }
  for (Eigen::Index v = 0; v < surface.points.rows(); ++v) {
    if (surface.points.row(v).allFinite()) continue;
    throw Error(ErrorKind::input, "E_NOT_FINITE",
                "vertex " + std::to_string(v) + " has a coordinate that is not finite; nothing was written",
                "look for a division by zero or an overflow in the parameters");
  }
}

void check_for_floats(const Surface<double>& surface) {
  check_for_writing(surface);
  for (Eigen::Index v = 0; v < surface.points.rows(); ++v) {
    if (surface.points.row(v).cwiseAbs().maxCoeff() <= double{std::numeric_limits<float>::max()}) continue;
    throw Error(ErrorKind::input, "E_FLOAT_RANGE",
                "vertex " + std::to_string(v) + " has a coordinate beyond 3.4e38, which STL and glTF cannot hold",
                "save as OBJ, OFF or PLY");
  }
}

Points<double> area_normals(const Surface<double>& surface) {
  const Mesh& mesh = *surface.mesh;
  Points<double> normals = Points<double>::Zero(mesh.vertices(), 3);
  for (int f = 0; f < mesh.faces(); ++f) {
    const auto corners = mesh.corners(f);
    const Vector origin = point(surface, corners[0]);
    Vector area = Vector::Zero();
    for (std::size_t k = 1; k + 1 < corners.size(); ++k) {
      area += (point(surface, corners[k]) - origin).cross(point(surface, corners[k + 1]) - origin);
    }
    for (const int v : corners) normals.row(v) += area.transpose();
  }
  return normals;
}

std::vector<std::array<int, 3>> triangles(const Surface<double>& surface) {
  const Mesh& mesh = *surface.mesh;
  std::vector<std::array<int, 3>> result;
  result.reserve(static_cast<std::size_t>(mesh.half_edges() - 2 * mesh.faces()));
  for (int f = 0; f < mesh.faces(); ++f) {
    const auto c = mesh.corners(f);
    const bool turn = c.size() == 4 && (point(surface, c[1]) - point(surface, c[3])).squaredNorm() <
                                           (point(surface, c[0]) - point(surface, c[2])).squaredNorm();
    const std::size_t start = turn ? 1 : 0;
    for (std::size_t k = 1; k + 1 < c.size(); ++k) {
      result.push_back({c[start], c[(start + k) % c.size()], c[(start + k + 1) % c.size()]});
    }
  }
  return result;
}

}  // namespace udcp
