// Levels of a mesh, the differences that are compared on each, and their sectors.
#include "interpreter/sectors.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "operators/interrupt.h"
#include "operators/schemes.h"
#include "proofs/regularity/adaptive.h"
#include "proofs/regularity/covered_surface.h"
#include "proofs/regularity/global_test.h"
#include "proofs/regularity/half_space.h"

namespace udcp {
namespace {

constexpr std::int64_t most_faces = 50'000;

std::size_t at(int k) { return Mesh::i(k); }
double degrees(double radians) { return radians * 180 / std::numbers::pi; }

std::vector<Direction> directions_of(const std::vector<Vector3>& vectors) {
  std::vector<Direction> result;
  result.reserve(vectors.size());
  for (const Vector3& w : vectors) result.push_back(direction_of(w));
  return result;
}

/// The non-zero vectors on their rays, each once.
std::vector<Vector3> distinct_rays(const std::vector<Vector3>& vectors) {
  std::vector<Vector3> result;
  for (const Vector3& w : vectors)
    if (!is_zero(w)) result.push_back(primitive(w));
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

std::vector<Vector3> joined(const std::vector<Vector3>& a, const std::vector<Vector3>& b, bool opposite) {
  std::vector<Vector3> result = a;
  for (const Vector3& w : b) result.push_back(opposite ? -w : w);
  return result;
}

/// The largest gap between directions of the plane, and the direction after it.
void measure_gap(Sector& sector) {
  std::vector<double> angles;
  for (const Vector3& w : sector.directions) {
    const Direction d = direction_of(w);
    angles.push_back(degrees(std::atan2(d[1], d[0])));
  }
  std::sort(angles.begin(), angles.end());
  double largest = -1;
  for (std::size_t k = 0; k < angles.size(); ++k) {
    const double before = k == 0 ? angles.back() - 360 : angles[k - 1];
    if (angles[k] - before <= largest) continue;
    largest = angles[k] - before;
    sector.from = angles[k];
  }
  sector.width = 360 - largest;
}

/// The extreme directions of a pointed cone of the plane.
void measure_ends(Sector& sector) {
  Vector3 low = sector.directions.front(), high = low;
  for (const Vector3& w : sector.directions) {
    if (cross(low, w)[2].sign() < 0) low = w;
    if (cross(w, high)[2].sign() < 0) high = w;
  }
  const Direction a = direction_of(low), b = direction_of(high);
  sector.from = degrees(std::atan2(a[1], a[0]));
  sector.width = degrees(std::atan2(cross(a, b)[2], dot(a, b)));
  sector.ends = {low, high};
}

Sector sector_of(const std::vector<Vector3>& vectors, bool pointed, bool planar) {
  Sector sector;
  sector.directions = distinct_rays(vectors);
  if (sector.directions.empty()) return sector;
  if (planar && pointed) {
    measure_ends(sector);
  } else if (planar) {
    measure_gap(sector);
  } else if (const auto cone = smallest_round_cone(directions_of(sector.directions)); pointed && cone) {
    sector.width = 2 * cone->angle;
  }
  return sector;
}

/// Between two sectors of the plane, on the nearer side.
double planar_gap(const Sector& a, double from, double width) {
  const double apart = std::abs(std::remainder(a.from + a.width / 2 - from - width / 2, 360));
  return apart - (a.width + width) / 2;
}

/// The round cone around U and W has the angle (width of U + width of W + gap)/2 in the plane; in space this is what gap means
/// here: how far U and -W are from being separated by nothing but a plane.
std::optional<double> gap_in_space(const Sector& u, const Sector& v, bool opposite) {
  const auto cone = smallest_round_cone(directions_of(joined(u.directions, v.directions, opposite)));
  if (!cone) return std::nullopt;
  return 180 - 2 * cone->angle;
}

void measure(ConeLevel& level, const Differences& differences, ConeTest test) {
  const bool planar = level.mesh.is_planar();
  level.test = std::move(test);
  level.u = sector_of(differences.u, level.test.pointed_u, planar);
  level.v = sector_of(differences.v, level.test.pointed_v, planar);
  if (!level.test.pointed_u || !level.test.pointed_v || level.u.directions.empty() || level.v.directions.empty()) return;
  if (planar) {
    level.gap = planar_gap(level.u, level.v.from, level.v.width);
    level.gap_to_opposite = planar_gap(level.u, level.v.from + 180, level.v.width);
  } else {
    if (level.test.n) level.gap = gap_in_space(level.u, level.v, true);
    if (level.test.m) level.gap_to_opposite = gap_in_space(level.u, level.v, false);
  }
}

/// How far a patch is from failing, between -1 and 1: the least sine of an angle from a u to a v, counted along the mean normal.
double margin(const Differences& differences) {
  const std::vector<Vector3> u_rays = distinct_rays(differences.u), v_rays = distinct_rays(differences.v);
  const std::vector<Direction> us = directions_of(u_rays), vs = directions_of(v_rays);
  std::vector<Direction> normals;
  Direction mean{};
  for (const Direction& u : us) {
    for (const Direction& v : vs) {
      normals.push_back(cross(u, v));
      for (std::size_t c = 0; c < 3; ++c) mean[c] += normals.back()[c];
    }
  }
  const double length = std::sqrt(dot(mean, mean));
  double least = 1;
  for (const Direction& w : normals) least = std::min(least, length > 0 ? dot(w, mean) / length : -1.0);
  return normals.empty() ? -1 : least;
}

void mark_faces(ConeLevel& level, const std::vector<int>& faces) {
  const Mesh& mesh = level.mesh.mesh();
  level.marked.assign(at(mesh.faces()), 0);
  std::vector<char> near(at(mesh.vertices()), 0);
  for (const int f : faces) {
    level.marked[at(f)] = 1;
    for (const int v : mesh.corners(f)) near[at(v)] = 1;
  }
  const auto is_near = [&](int f) {
    const auto corners = mesh.corners(f);
    return std::any_of(corners.begin(), corners.end(), [&](int v) { return near[at(v)] != 0; });
  };
  std::vector<int> turn(at(mesh.faces()), -1), stack{faces.front()};
  turn[at(faces.front())] = 0;
  while (!stack.empty()) {
    const int f = stack.back();
    stack.pop_back();
    for (int side = 0; side < 4; ++side) {
      const int h = mesh.face_begin[at(f)] + side, across = mesh.twin[at(h)];
      level.family[at(mesh.edge[at(h)])] = static_cast<char>(1 + (side - turn[at(f)] + 4) % 2);
      if (across < 0 || turn[at(mesh.face[at(across)])] >= 0 || !is_near(mesh.face[at(across)])) continue;
      const int g = mesh.face[at(across)];
      turn[at(g)] = (across - mesh.face_begin[at(g)] - side + turn[at(f)] + 6) % 4;  // the shared edge runs the other way
      stack.push_back(g);
    }
  }
}

/// All edges, component by component; the first that fails is shown.
bool study_mesh(ConeLevel& level) {
  const auto components = edge_differences(level.mesh);
  const auto frame = global_frame(level.mesh.mesh());
  if (!components || !frame) return false;
  level.parts = static_cast<int>(components->size());
  level.shown = -1;
  std::vector<ConeTest> tests;
  for (int k = 0; k < level.parts; ++k) {
    tests.push_back(test_cones((*components)[at(k)], true));
    level.passed += tests.back().separated() ? 1 : 0;
    if (!tests.back().separated() && level.shown < 0) level.shown = k;
  }
  level.shown = std::max(level.shown, 0);
  measure(level, (*components)[at(level.shown)], tests[at(level.shown)]);
  const Mesh& mesh = level.mesh.mesh();
  for (int e = 0; e < mesh.edges(); ++e) {
    const int h = mesh.edge_half[at(e)], f = mesh.face[at(h)];
    level.family[at(e)] = static_cast<char>(1 + (h - mesh.face_begin[at(f)] - (*frame)[at(f)] + 4) % 2);
  }
  return true;
}

void study_worst_patch(ConeLevel& level, RegularityMode mode, const RunControl& control) {
  level.parts = 0;
  double worst = 5;
  for (int f = 0; f < level.mesh.mesh().faces(); ++f) {
    if (level.mesh.kind_of(f, mode) != FaceKind::patch) continue;
    if (f % 64 == 0) throw_if_stopped(control.stop);
    const BicubicNet net = level.mesh.net(f);
    const bool passed = find_witness(net, RegularityTest::t2, level.mesh.is_planar()).has_value();
    const double here = margin(differences(net)) + (passed ? 3 : 0);
    ++level.parts;
    level.passed += passed ? 1 : 0;
    if (here >= worst) continue;
    worst = here;
    level.shown = f;
  }
  if (level.parts == 0) return;
  const BicubicNet net = level.mesh.net(level.shown);
  measure(level, differences(net), test_cones(differences(net), !has_full_corners(net)));
  mark_faces(level, {level.shown});
}

/// All parts of the patch after so many steps.
void study_face(ConeLevel& level, const BicubicNet& patch, int face, int steps) {
  std::vector<BicubicNet> nets{patch};
  for (int k = 0; k < steps; ++k) {
    std::vector<BicubicNet> next;
    for (const BicubicNet& net : nets)
      for (int quarter = 0; quarter < 4; ++quarter) next.push_back(child(net, quarter));
    nets = std::move(next);
  }
  Differences all;
  bool full = true;
  for (const BicubicNet& net : nets) {
    const Differences d = differences(net);
    all.u.insert(all.u.end(), d.u.begin(), d.u.end());
    all.v.insert(all.v.end(), d.v.begin(), d.v.end());
    full = full && has_full_corners(net);
    level.passed += find_witness(net, RegularityTest::t2, level.mesh.is_planar()) ? 1 : 0;
  }
  level.parts = static_cast<int>(nets.size());
  level.shown = face;
  measure(level, all, test_cones(all, !full));
  // A quad f becomes the quads 4f .. 4f + 3, the first of which has its u and v (topology.h).
  std::vector<int> faces(nets.size());
  std::iota(faces.begin(), faces.end(), face * static_cast<int>(nets.size()));
  mark_faces(level, faces);
}

void check_size(std::int64_t faces, int steps, std::int64_t allowed) {
  const std::int64_t limit = std::min(allowed, most_faces);
  for (int k = 0; k < steps && faces <= limit; ++k) faces *= 4;
  if (faces <= limit) return;
  throw Error(
      ErrorKind::limit, "E_MAX_FACES",
      "cones would be measured on a mesh of at least " + std::to_string(faces) + " faces; the limit is " + std::to_string(limit),
      "write steps = 0, or take a smaller part of the mesh");
}

ConeLevel level_of(const Surface<Rational>& surface, RegularityMode mode) {
  ConeLevel level{QuadMesh(surface), 0, 0, 1, 0, 0, {}, {}, {}, {}, {}, {}, {}};
  const Mesh& mesh = level.mesh.mesh();
  for (int f = 0; f < mesh.faces(); ++f) {
    level.patches += level.mesh.kind_of(f, mode) == FaceKind::patch ? 1 : 0;
    level.excluded += level.mesh.kind_of(f, mode) == FaceKind::excluded ? 1 : 0;
  }
  level.family.assign(at(mesh.edges()), 0);
  level.marked.assign(at(mesh.faces()), 0);
  return level;
}

}  // namespace

Direction direction_of(const Vector3& vector) {
  const Rational largest = std::max({abs(vector[0]), abs(vector[1]), abs(vector[2])});
  Direction d{};
  for (std::size_t c = 0; c < 3; ++c) d[c] = (vector[c] / largest).to_double();
  return unit(d);
}

ConeTest test_cones(const Differences& differences, bool zeros_matter) {
  const std::vector<Vector3> u = distinct_rays(differences.u), v = distinct_rays(differences.v);
  const auto zero = [](const Vector3& w) { return is_zero(w); };
  ConeTest test;
  test.has_zero = zeros_matter && (std::any_of(differences.u.begin(), differences.u.end(), zero) ||
                                   std::any_of(differences.v.begin(), differences.v.end(), zero));
  test.n = half_space(joined(u, v, true));
  test.m = half_space(joined(u, v, false));
  test.pointed_u = test.n || test.m || half_space(u);
  test.pointed_v = test.n || test.m || half_space(v);
  if (test.pointed_u && test.pointed_v) {
    test.apart = test.n.has_value();
    test.apart_from_opposite = test.m.has_value();
  }
  return test;
}

/// The point of the convex hull of unit vectors that is nearest to 0 gives the centre (Mitchell, Demyanov, Malozemov 1974).
std::optional<RoundCone> smallest_round_cone(const std::vector<Direction>& directions) {
  if (directions.empty()) return std::nullopt;
  std::vector<double> weight(directions.size(), 0);
  weight[0] = 1;
  Direction p = directions[0];
  for (int step = 0; step < 3000; ++step) {
    std::size_t far = 0, near = 0;
    double farthest = -2, nearest = 2;
    for (std::size_t k = 0; k < directions.size(); ++k) {
      const double value = dot(directions[k], p);
      if (weight[k] > 0 && value > farthest) farthest = value, far = k;
      if (value < nearest) nearest = value, near = k;
    }
    Direction move{};
    for (std::size_t c = 0; c < 3; ++c) move[c] = directions[near][c] - directions[far][c];
    const double squared = dot(move, move);
    if (farthest - nearest < 1e-13 || !(squared > 0)) break;
    const double share = std::min(weight[far], (farthest - nearest) / squared);
    weight[near] += share;
    weight[far] = share < weight[far] ? weight[far] - share : 0;
    for (std::size_t c = 0; c < 3; ++c) p[c] += share * move[c];
  }
  const double length = std::sqrt(dot(p, p));
  if (!(length > 1e-9)) return std::nullopt;
  for (double& x : p) x /= length;
  double least = 1;
  for (const Direction& d : directions) least = std::min(least, dot(d, p));
  if (!(least > 0)) return std::nullopt;
  return RoundCone{p, degrees(std::acos(std::min(least, 1.0)))};
}

void require_face(const Mesh& mesh, int face) {
  if (face >= 0 && face < mesh.faces()) return;
  throw Error(
      ErrorKind::input, "E_INDEX",
      "face " + std::to_string(face) + " does not exist; the mesh has the faces 0 .. " + std::to_string(mesh.faces() - 1));
}

std::string why_no_patch(const QuadMesh& mesh, int face, RegularityMode mode) {
  std::string text = "face " + std::to_string(face) + " is no patch";
  for (const int v : mesh.mesh().corners(face)) {
    const VertexClass c = mesh.class_of(v);
    const bool plain = c == VertexClass::boundary || c == VertexClass::corner;
    if (c == VertexClass::interior || (plain && mode == RegularityMode::bspline)) continue;
    const int valence = mesh.mesh().valence(v), faces = mesh.mesh().on_boundary(v) ? valence - 1 : valence;
    text += ": its vertex " + std::to_string(v) + " is " + (mesh.mesh().on_boundary(v) ? "on the boundary" : "inside") +
            ", with " + std::to_string(faces) + (faces == 1 ? " face" : " faces");
    if (plain) text += ", and mode interior leaves the boundary out";
    return text + " (class " + to_string(c) + ")";
  }
  return text;
}

ConeStudy study_cones(const Surface<Rational>& surface, const ConeOptions& options) {
  validate(surface);
  ConeStudy study;
  study.mode = options.mode;
  study.is_refined = options.mode == RegularityMode::bspline || is_closed(*surface.mesh);
  const int steps = study.is_refined ? options.steps : 0;
  check_size(surface.mesh->faces(), steps, options.control.max_faces);
  study.levels.push_back(level_of(surface, options.mode));
  std::optional<BicubicNet> patch;
  if (options.face) {
    const QuadMesh& mesh = study.levels[0].mesh;
    study.subject = ConeStudy::Subject::face;
    study.face = *options.face;
    require_face(mesh.mesh(), study.face);
    if (mesh.kind_of(study.face, options.mode) != FaceKind::patch)
      throw Error(ErrorKind::input, "E_NO_PATCH", why_no_patch(mesh, study.face, options.mode),
                  "cones are those of the differences of patches");
    patch = mesh.net(study.face);
  }
  for (int step = 0; step <= steps; ++step) {
    throw_if_stopped(options.control.stop);
    if (step > 0)
      study.levels.push_back(
          level_of(run(schemes::catmull_clark(), study.levels.back().mesh.surface(), 1, options.control), options.mode));
    ConeLevel& level = study.levels.back();
    if (patch) {
      study_face(level, *patch, study.face, step);
    } else if (study.subject == ConeStudy::Subject::worst_patch || !study_mesh(level)) {
      study.subject = ConeStudy::Subject::worst_patch;
      study_worst_patch(level, options.mode, options.control);
    }
  }
  if (study.levels.back().parts == 0)
    throw Error(ErrorKind::input, "E_NO_PATCH",
                "no face of the mesh is a regular patch" +
                    (study.is_refined ? ", before or after " + std::to_string(steps) + " steps"
                                      : " in mode interior, which has no boundary rule and so does not refine an open mesh"),
                study.is_refined ? "patches are quads whose vertices are regular; two Catmull-Clark steps make some"
                                 : "mode bspline has a boundary rule");
  return study;
}

}  // namespace udcp
