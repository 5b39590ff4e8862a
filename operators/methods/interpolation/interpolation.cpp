// Puts the steps together and says what happened.
#include "operators/methods/interpolation/interpolation.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "operators/interrupt.h"
#include "operators/methods/interpolation/mesh_system.h"
#include "operators/schemes.h"

namespace udcp {
namespace {

std::size_t at(int k) { return Mesh::i(k); }

void check_lists(const Surface<double>& cage, const InterpolateOptions& options) {
  for (const auto* list : {&options.skipped_points, &options.skipped_normals})
    if (!list->empty() && list->size() != at(cage.mesh->vertices()))
      throw Error(
          ErrorKind::input, "E_ARGUMENTS",
          "a list of " + std::to_string(list->size()) + " flags for " + std::to_string(cage.mesh->vertices()) + " vertices",
          "give one per vertex");
}

std::string places(int count) { return std::to_string(count) + (count == 1 ? " vertex" : " vertices"); }

PointOptions point_options(const InterpolateOptions& options) {
  return {options.step1, options.lambda, options.skipped_points, options.control};
}

// The share of the whole that a part of the work has.
RunControl part(const RunControl& control, double from, double to) {
  RunControl result = control;
  if (control.progress)
    result.progress = [&control, from, to](double fraction) { control.progress(from + (to - from) * fraction); };
  return result;
}

void two_levels(const Surface<double>& cage, const Points<double>& normals, const InterpolateOptions& options,
                Interpolation& result) {
  PointOptions points = point_options(options);
  points.control = part(options.control, 0, 0.4);
  result.control = interpolate_points(cage, points);
  if (options.step1 != PointStep::plain)
    result.control = run(schemes::catmull_clark(), std::move(result.control), 1, part(options.control, 0.4, 0.9));
  if (normals.rows() == 0) return;
  throw_if_stopped(options.control.stop);
  TurnedNormals turned = turn_normals(result.control, normals, {options.step2, options.skipped_normals});
  result.control.points = std::move(turned.points);
  result.vertices = std::move(turned.reports);
}

// What a correction at M1 did to the ring of each vertex, for the report.
std::vector<VertexReport> compare(const Surface<double>& before, const Surface<double>& after, const Points<double>& normals,
                                  const InterpolateOptions& options, Correction correction) {
  std::vector<VertexReport> reports(at(static_cast<int>(normals.rows())));
  RingMasks masks;
  Fan fan;
  for (int v = 0; v < static_cast<int>(reports.size()); ++v) {
    if (!options.skipped_normals.empty() && options.skipped_normals[at(v)] != 0) continue;
    VertexReport& report = reports[at(v)];
    collect_fan(*before.mesh, v, fan);
    const RingWeights& weights = *masks.weights(fan);
    const RingTangents old = tangents_at(before.points, v, fan, weights);
    report.correction = correction;
    report.angle_before = is_degenerate(old) ? std::nan("") : angle_between(normal_of(old), normals.row(v));
    report.length_ratio = normal_of(tangents_at(after.points, v, fan, weights)).norm() / normal_of(old).norm();
    for (std::size_t k = 0; k < fan.e.size() + fan.f.size(); ++k) {
      const double moved = (after.points.row(fan_point(fan, k)) - before.points.row(fan_point(fan, k))).norm();
      report.displacement = std::max(report.displacement, moved);
      report.squared_displacement += moved * moved;
    }
  }
  return reports;
}

void literally(const Surface<double>& cage, const Points<double>& normals, const InterpolateOptions& options,
               Interpolation& result) {
  if (options.step2 == NormalStep::rotate)
    throw Error(ErrorKind::input, "E_ARGUMENTS", "the sweeps of the paper project tangents; they have no rotation",
                "step2 = tied or free, or method = two_level");
  SweepOptions sweeps{point_options(options), options.step2 == NormalStep::free ? Spread::free : Spread::tied, options.order,
                      options.sweeps, options.skipped_normals};
  Sweeps swept = sweep(cage, normals, sweeps);
  const bool tied = sweeps.spread == Spread::tied;
  result.vertices =
      compare(modified_step(cage, options.lambda), swept.control, normals, options, tied ? Correction::tied : Correction::free);
  result.control = std::move(swept.control);
  result.sweeps = std::move(swept.errors);
  result.growth = swept.growth;
  result.rounds = 1;
  if (result.growth > 1)
    result.notes.push_back("the sweeps diverge: each changes " + to_text(std::round(result.growth * 1000) / 1000) +
                           " times as much as the one before");
}

void all_at_once(const Surface<double>& cage, const Points<double>& normals, const InterpolateOptions& options,
                 Interpolation& result) {
  const PointOptions points = point_options(options);
  LeastCorrection least = least_correction(cage, normals, points, options.skipped_normals);
  result.vertices = compare(interpolate_points(cage, points), least.control, normals, options, Correction::free);
  result.control = std::move(least.control);
  result.rank = least.rank;
  result.rows = least.rows;
  result.rounds = 1;
}

void note_vertices(Interpolation& result) {
  int over = 0, flat = 0, fixed = 0, off = 0, none = 0;
  for (const VertexReport& report : result.vertices) {
    over += report.turns_over();
    flat += report.length_ratio < 1e-9;
    fixed += report.correction == Correction::fixed;
    off += report.off_boundary > 1e-9;
    none += report.correction == Correction::no_plane;
  }
  const auto note = [&](int count, const std::string& text) {
    if (count > 0) result.notes.push_back(places(count) + text);
  };
  note(over, ": the normal was more than 90 degrees off, so the surface folds there or keeps the opposite normal");
  note(flat, ": no tangent plane is left there; step2 = rotate keeps one");
  note(result.errors.reversed, ": the surface has the opposite of the normal there");
  note(fixed, ": the boundary curve alone decides the normal there");
  note(none, ": Catmull-Clark has no tangent plane at boundary vertices with four faces or more, so the normal is left alone");
  note(off, ": the normal was not across the boundary curve, so its part along the curve was left out");
}

}  // namespace

double signed_volume(const Surface<double>& surface) {
  const Mesh& mesh = *surface.mesh;
  double volume = 0;
  const Eigen::RowVector3d origin = surface.points.colwise().mean();
  for (int f = 0; f < mesh.faces(); ++f) {
    const auto corners = mesh.corners(f);
    Eigen::RowVector3d mean = Eigen::RowVector3d::Zero();
    for (const int v : corners) mean += (surface.points.row(v) - origin) / static_cast<double>(corners.size());
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const Eigen::RowVector3d a = surface.points.row(corners[k]) - origin;
      const Eigen::RowVector3d b = surface.points.row(corners[(k + 1) % corners.size()]) - origin;
      volume += mean.dot(a.cross(b)) / 6;
    }
  }
  return volume;
}

Surface<double> flipped(const Surface<double>& surface) {
  const Mesh& mesh = *surface.mesh;
  std::vector<int> corners = mesh.vertex;
  for (int f = 0; f < mesh.faces(); ++f)
    std::reverse(corners.begin() + mesh.face_begin[at(f)], corners.begin() + mesh.face_begin[at(f + 1)]);
  Surface<double> result = surface;
  result.mesh = std::make_shared<const Mesh>(make_mesh(mesh.vertices(), mesh.face_begin, std::move(corners)));
  if (surface.tags.edge.empty()) return result;
  // Half-edge k of a face, turned over, is the old half-edge before the mirror image of its corner.
  for (int f = 0; f < mesh.faces(); ++f) {
    const int begin = mesh.face_begin[at(f)], end = mesh.face_begin[at(f + 1)];
    for (int h = begin; h < end; ++h)
      result.tags.edge[at(result.mesh->edge[at(h)])] = surface.tags.edge[at(mesh.edge[at(mesh.prev(begin + end - 1 - h))])];
  }
  return result;
}

Interpolation interpolate(const Surface<double>& original, const Points<double>& normals, const InterpolateOptions& options) {
  check_cage(original);
  check_lists(original, options);
  const bool with_normals = normals.rows() > 0;
  if (with_normals) check_normals(normals, original.mesh->vertices(), options.skipped_normals);
  if (original.points.cols() != 3)
    throw Error(ErrorKind::input, "E_DIMENSION", "interpolation of normals needs points of three coordinates", "");
  const Surface<double> cage = options.flip ? flipped(original) : original;
  Interpolation result;
  for (int e = 0; e < cage.mesh->edges(); ++e) result.is_closed = result.is_closed && !cage.mesh->is_boundary_edge(e);
  if (result.is_closed) result.signed_volume = signed_volume(cage);
  if (result.signed_volume < 0)
    result.notes.emplace_back("the faces point inward (the volume is negative), and normals are meant on the side of the faces");
  if (options.step1 != PointStep::global && options.lambda != InterpolateOptions().lambda)
    result.notes.emplace_back("lambda shapes the result of step1 = global only");
  if (options.method == InterpolationMethod::two_level)
    two_levels(cage, normals, options, result);
  else if (options.method == InterpolationMethod::literal)
    literally(cage, normals, options, result);
  else
    all_at_once(cage, normals, options, result);
  result.errors = interpolation_errors(result.control, cage.points, normals, options.skipped_points, options.skipped_normals);
  note_vertices(result);
  if (options.control.progress) options.control.progress(1);
  return result;
}

}  // namespace udcp
