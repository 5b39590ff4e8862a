// One pass over the vertices; rings that do not meet need no order.
#include "operators/methods/interpolation/interpolate_normals.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "operators/methods/interpolation/interpolate_points.h"
#include "operators/methods/interpolation/ring_tangents.h"

namespace udcp {
namespace {

std::size_t at(int k) { return Mesh::i(k); }

constexpr double steep = 0.1;  // the cosine of the angle from which on `automatic` turns instead of projecting

bool is_skipped(const std::vector<char>& skipped, int v) { return !skipped.empty() && skipped[at(v)] != 0; }

// What is to be done at one vertex: its fan, weights and the normal aimed at.
struct Aim {
  const RingWeights* weights = nullptr;  // null: nothing can be done on this boundary
  RingTangents tangents;
  Eigen::RowVector3d normal;
  double off_boundary = 0;
};

[[noreturn]] void degenerate(int v) {
  throw Error(ErrorKind::input, "E_TANGENTS",
              "the surface has no tangent plane at vertex " + std::to_string(v) + ": its limit tangents are parallel",
              "move its neighbours apart, or leave its normal free");
}

Aim aim_at(const Surface<double>& fine, int v, const Eigen::RowVector3d& normal, Fan& fan, RingMasks& masks) {
  Aim aim;
  collect_fan(*fine.mesh, v, fan);
  if (fine.tags.is_corner(v)) return aim;
  aim.weights = masks.weights(fan);
  if (aim.weights == nullptr) return aim;
  aim.tangents = tangents_at(fine.points, v, fan, *aim.weights);
  aim.normal = normal / normal.stableNorm();
  if (fan.inside || aim.tangents.first.isZero(0)) return aim;
  const Eigen::RowVector3d along = aim.tangents.first / aim.tangents.first.stableNorm();
  const Eigen::RowVector3d across = aim.normal - aim.normal.dot(along) * along;
  if (across.norm() <= 1e-8)
    throw Error(ErrorKind::input, "E_TANGENTS",
                "the normal at vertex " + std::to_string(v) + " has the direction of the boundary curve there",
                "on the boundary a normal must not be tangent to the curve");
  aim.off_boundary = angle_between(aim.normal, across);
  aim.normal = (across / across.norm()).eval();
  aim.normal -= aim.normal.dot(along) * along;  // once more for the digits lost above
  return aim;
}

// Which correction serves the vertex, and the change of tangents that it makes.
std::pair<Correction, RingTangents> choose(const Aim& aim, const Fan& fan, NormalStep step, bool flat, double angle, int v) {
  if (step == NormalStep::automatic) step = !flat && std::cos(angle) > steep ? NormalStep::free : NormalStep::rotate;
  if (step == NormalStep::rotate) {
    if (flat) degenerate(v);
    return {Correction::rotate, change_by_turn(aim.tangents, aim.normal)};
  }
  const bool tied = step == NormalStep::tied && fan.inside;
  return {tied ? Correction::tied : Correction::free, change_to_plane(aim.tangents, aim.normal)};
}

VertexReport turn_vertex(const Aim& aim, const Fan& fan, NormalStep step, int v, Points<double>& points) {
  VertexReport report;
  report.off_boundary = aim.off_boundary;
  const bool flat = is_degenerate(aim.tangents);
  const Eigen::RowVector3d before = normal_of(aim.tangents);
  report.angle_before = flat ? std::numeric_limits<double>::quiet_NaN() : angle_between(before, aim.normal);
  const auto [correction, change] = choose(aim, fan, step, flat, report.angle_before, v);
  report.correction = correction;
  const Points<double> rows =
      ring_corrections(fan, *aim.weights, change, correction == Correction::tied ? Spread::tied : Spread::free);
  for (Eigen::Index k = 0; k < rows.rows(); ++k) {
    points.row(fan_point(fan, static_cast<std::size_t>(k))) += rows.row(k);
    report.displacement = std::max(report.displacement, rows.row(k).norm());
    report.squared_displacement += rows.row(k).squaredNorm();
  }
  const RingTangents after = tangents_at(points, v, fan, *aim.weights);
  report.length_ratio = flat ? 0 : normal_of(after).norm() / before.norm();
  return report;
}

}  // namespace

std::string to_string(Correction correction) {
  switch (correction) {
    case Correction::none:
      return "none";
    case Correction::free:
      return "free";
    case Correction::tied:
      return "tied";
    case Correction::rotate:
      return "rotate";
    case Correction::fixed:
      return "fixed";
    case Correction::no_plane:
      return "no plane";
  }
  return "";
}

void check_normals(const Points<double>& normals, int count, const std::vector<char>& skipped) {
  if (normals.rows() != count || normals.cols() != 3)
    throw Error(ErrorKind::input, "E_NORMALS",
                "there are " + std::to_string(normals.rows()) + " normals of " + std::to_string(normals.cols()) +
                    " numbers for " + std::to_string(count) + " vertices",
                "give one normal of three numbers per vertex");
  for (int v = 0; v < count; ++v) {
    if (is_skipped(skipped, v)) continue;
    const Eigen::RowVector3d n = normals.row(v);
    if (!n.allFinite() || n.isZero(0) || !std::isfinite(1 / n.cwiseAbs().maxCoeff()))
      throw Error(ErrorKind::input, "E_NORMAL",
                  "the normal at vertex " + std::to_string(v) + (n.allFinite() ? " is zero" : " is not finite"),
                  "give a direction, or leave the vertex out");
  }
}

template <class S>
Points<S> area_normals(const Surface<S>& surface) {
  const Mesh& mesh = *surface.mesh;
  if (surface.points.cols() != 3) throw Error(ErrorKind::input, "E_DIMENSION", "normals need points of three coordinates", "");
  Points<S> result = Points<S>::Zero(mesh.vertices(), 3), area(1, 3);
  for (int f = 0; f < mesh.faces(); ++f) {
    const auto corners = mesh.corners(f);
    area.setZero();
    for (std::size_t k = 1; k + 1 < corners.size(); ++k) {
      std::array<S, 3> a, b;
      for (int c = 0; c < 3; ++c) {
        a[at(c)] = surface.points(corners[k], c) - surface.points(corners[0], c);
        b[at(c)] = surface.points(corners[k + 1], c) - surface.points(corners[0], c);
      }
      for (int c = 0; c < 3; ++c)
        area(0, c) += (a[at((c + 1) % 3)] * b[at((c + 2) % 3)] - a[at((c + 2) % 3)] * b[at((c + 1) % 3)]) / S(2);
    }
    for (const int v : corners) add(result, v, S(1), area, 0);
  }
  return result;
}

#define UDCP_INSTANTIATE(S) template Points<S> area_normals(const Surface<S>&);
UDCP_FOR_EACH_COORDINATE(UDCP_INSTANTIATE)
#undef UDCP_INSTANTIATE

TurnedNormals turn_normals(const Surface<double>& fine, const Points<double>& normals, const NormalOptions& options) {
  const int count = static_cast<int>(normals.rows());
  if (fine.points.cols() != 3) throw Error(ErrorKind::input, "E_DIMENSION", "normals need points of three coordinates", "");
  check_normals(normals, std::min(count, fine.mesh->vertices()), options.skipped);
  TurnedNormals result{fine.points, std::vector<VertexReport>(at(count))};
  RingMasks masks;
  Fan fan;
  for (int v = 0; v < count; ++v) {
    if (is_skipped(options.skipped, v)) continue;
    const Aim aim = aim_at(fine, v, normals.row(v), fan, masks);
    if (aim.weights == nullptr)
      result.reports[at(v)].correction = fan.faces() > 3 && !fine.tags.is_corner(v) ? Correction::no_plane : Correction::fixed;
    else
      result.reports[at(v)] = turn_vertex(aim, fan, options.step, v, result.points);
  }
  return result;
}

InterpolationErrors interpolation_errors(const Surface<double>& fine, const Points<double>& points, const Points<double>& normals,
                                         const std::vector<char>& skipped_points, const std::vector<char>& skipped_normals) {
  InterpolationErrors errors;
  const Points<double> limits = limit_points(fine, static_cast<int>(points.rows()));
  for (int v = 0; v < static_cast<int>(points.rows()); ++v)
    if (!is_skipped(skipped_points, v)) errors.position = std::max(errors.position, (limits.row(v) - points.row(v)).norm());
  RingMasks masks;
  Fan fan;
  for (int v = 0; v < static_cast<int>(normals.rows()); ++v) {
    if (is_skipped(skipped_normals, v)) continue;
    const Aim aim = aim_at(fine, v, normals.row(v), fan, masks);
    if (aim.weights == nullptr) continue;
    const bool flat = is_degenerate(aim.tangents);
    const double angle = flat ? std::acos(-1.0) : angle_between(normal_of(aim.tangents), aim.normal);
    errors.normal = std::max(errors.normal, angle);
    errors.reversed += !flat && normal_of(aim.tangents).dot(aim.normal) <= 0;
  }
  return errors;
}

}  // namespace udcp
