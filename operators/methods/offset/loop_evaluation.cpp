// Finds the patch of a point: the face itself, or a child of it after refining the faces around.
#include "operators/methods/offset/loop_evaluation.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "operators/methods/offset/loop_limit.h"
#include "operators/neighbourhood.h"
#include "operators/run.h"
#include "operators/schemes.h"

namespace udcp {
namespace {

std::size_t at(int k) { return static_cast<std::size_t>(k); }

constexpr int deepest = 60;
constexpr int kept_valence = 24;  // matrices of larger valences are rare and large; such faces are refined as meshes

using Jacobian = std::array<std::array<double, 2>, 2>;
constexpr Jacobian identity{{{1, 0}, {0, 1}}};

Jacobian operator*(const Jacobian& a, const Jacobian& b) {
  Jacobian c{};
  for (std::size_t i = 0; i < 2; ++i)
    for (std::size_t j = 0; j < 2; ++j) c[i][j] = a[i][0] * b[0][j] + a[i][1] * b[1][j];
  return c;
}

/// Part of a mesh around a face, the face, and where the point lies in it; `jacobian` is of (v, w) by the parameters asked for.
struct Place {
  Surface<double> surface;
  int face = 0;
  double v = 0, w = 0;
  Jacobian jacobian = identity;
};

/// The faces around the corners of a face: two rings around its first corner. Their refinement is right near the face.
Place cut_out(const Mesh& mesh, const Tags& tags, const Points<double>& field, int face) {
  const int first = mesh.face_begin[at(face)], c = mesh.vertex[at(first)];
  const Neighbourhood local = neighbourhood(mesh, tags, mesh.on_boundary(c) ? mesh.outgoing[at(c)] : first, 2);
  Place place;
  place.surface = {std::make_shared<const Mesh>(local.mesh),
                   Points<double>(static_cast<Eigen::Index>(local.vertex.size()), field.cols()),
                   local.tags,
                   {}};
  for (std::size_t k = 0; k < local.vertex.size(); ++k)
    place.surface.points.row(static_cast<Eigen::Index>(k)) = field.row(local.vertex[k]);
  const auto is_same = [&](int f, int turn) {
    for (int j = 0; j < 3; ++j)
      if (local.vertex[at(local.mesh.corners(f)[at((j + turn) % 3)])] != mesh.corners(face)[at(j)]) return false;
    return true;
  };
  for (int f = 0; f < local.mesh.faces(); ++f)
    for (int turn = 0; turn < 3; ++turn)
      if (is_same(f, turn)) {
        place.face = 3 * f + turn;  // as the half-edge of its first corner
        return place;
      }
  throw Error(ErrorKind::internal, "E_INTERNAL", "a face is not in the neighbourhood of its corner");
}

/// v, w from the corner that half-edge 3 f + turn leaves, given those from the first corner of the face.
void turn_parameters(int turn, double& v, double& w, Jacobian& jacobian) {
  static constexpr std::array<Jacobian, 3> turns{{identity, {{{0, 1}, {-1, -1}}}, {{{-1, -1}, {1, 0}}}}};
  const double u = 1 - v - w, old_v = v, old_w = w;
  if (turn == 1) v = old_w, w = u;
  if (turn == 2) v = u, w = old_v;
  jacobian = turns[at(turn)] * jacobian;
}

/// The child of a face that contains the point, numbered as the split does.
int child_of(double& v, double& w, Jacobian& jacobian) {
  static constexpr std::array<Jacobian, 4> steps{
      {{{{2, 0}, {0, 2}}}, {{{0, 2}, {-2, -2}}}, {{{-2, -2}, {2, 0}}}, {{{2, 2}, {-2, 0}}}}};
  const double u = 1 - v - w, old_v = v, old_w = w;
  const int child = u >= 0.5 ? 0 : v >= 0.5 ? 1 : w >= 0.5 ? 2 : 3;
  if (child == 0) v = 2 * old_v, w = 2 * old_w;
  if (child == 1) v = 2 * old_w, w = 2 * u;
  if (child == 2) v = 2 * u, w = 2 * old_v;
  if (child == 3) v = 1 - 2 * u, w = 1 - 2 * old_v;
  v = std::max(0.0, v);
  w = std::max(0.0, w);
  jacobian = steps[at(child)] * jacobian;
  return child;
}

/// The limit at a vertex of a cut-out, which has its whole ring there.
Points<double> limit_at(const Surface<double>& surface, int v) {
  const Mesh& mesh = *surface.mesh;
  if (surface.tags.is_corner(v)) return surface.points.row(v);
  const std::vector<int> ring = vertex_ring(mesh, v);
  if (mesh.on_boundary(v)) {
    const BoundaryWeights<double> weights = loop_boundary_weights<double>();
    return weights.centre * surface.points.row(v) +
           weights.end * (surface.points.row(ring.front()) + surface.points.row(ring.back()));
  }
  const double w = loop_weight<double>(static_cast<int>(ring.size()));
  Points<double> sum = w * surface.points.row(v);
  for (const int u : ring) sum += surface.points.row(u);
  return sum / (w + static_cast<double>(ring.size()));
}

[[noreturn]] void refuse_parameters(double v, double w) {
  throw Error(ErrorKind::input, "E_PARAMETER_RANGE",
              "the point (" + to_text(v) + ", " + to_text(w) + ") is not in the triangle v >= 0, w >= 0, v + w <= 1", "");
}

}  // namespace

LoopEvaluation::LoopEvaluation(std::shared_ptr<const Mesh> mesh, Tags tags) : mesh_(std::move(mesh)), tags_(std::move(tags)) {
  validate_loop_mesh(*mesh_, tags_);
  steps_.emplace(6, PatchStep<double>{});
  for (int v = 0; v < mesh_->vertices(); ++v) {
    const int n = mesh_->valence(v);
    if (!mesh_->on_boundary(v) && n <= kept_valence && !steps_.contains(n)) steps_.emplace(n, patch_step<double>(n));
  }
}

LoopPoint LoopEvaluation::at(const Points<double>& field, int face, double v, double w) const {
  if (face < 0 || face >= mesh_->faces())
    throw Error(ErrorKind::input, "E_INDEX", "there is no face " + std::to_string(face), "");
  if (!(v >= 0 && w >= 0 && v + w <= 1 + 1e-15)) refuse_parameters(v, w);
  const Mesh* mesh = mesh_.get();
  const Tags* tags = &tags_;
  const Points<double>* points = &field;
  Place place;
  Jacobian jacobian = identity;
  for (int depth = 0;; ++depth) {
    const std::optional<LoopPatch> patch = loop_patch(*mesh, *tags, face);
    if (patch && steps_.contains(patch->valence)) {
      turn_parameters(patch->half_edge - mesh->face_begin[udcp::at(face)], v, w, jacobian);
      LoopPoint result{evaluate_patch(patch_net(*patch, *points), steps_.at(patch->valence), std::max(0.0, v), std::max(0.0, w)),
                       false};
      result.has_derivatives = result.values.rows() == 6;
      if (result.has_derivatives) change_parameters(result.values, jacobian);
      return result;
    }
    place = cut_out(*mesh, *tags, *points, face);
    const double u = 1 - v - w;
    const int corner = u >= 1 ? 0 : v >= 1 ? 1 : w >= 1 ? 2 : -1;
    if (corner >= 0 || depth == deepest) {
      const int nearest = corner >= 0 ? corner : u >= std::max(v, w) ? 0 : v >= w ? 1 : 2;
      const int f = place.face / 3, turn = place.face % 3;
      return {limit_at(place.surface, place.surface.mesh->corners(f)[udcp::at((turn + nearest) % 3)]), false};
    }
    const int f = place.face / 3;
    const int turn = place.face % 3;
    turn_parameters((3 - turn) % 3, v, w, jacobian);  // to the first corner of the local face
    const int child = child_of(v, w, jacobian);
    place.surface = run(schemes::loop(), std::move(place.surface), 1);
    face = 4 * f + child;
    mesh = place.surface.mesh.get();
    tags = &place.surface.tags;
    points = &place.surface.points;
  }
}

Curvature curvature(const Points<double>& values) {
  const Eigen::Vector3d xv = values.row(1).transpose(), xw = values.row(2).transpose();
  const Eigen::Vector3d cross = xv.cross(xw);
  const double area = cross.norm();
  if (!(area > 1e-13 * xv.norm() * xw.norm()))
    throw Error(ErrorKind::input, "E_ZERO_NORMAL", "the surface has no normal at this point", "");
  const Eigen::Vector3d n = cross / area;
  const double e = xv.dot(xv), f = xv.dot(xw), g = xw.dot(xw);
  const double l = values.row(3).dot(n.transpose()), m = values.row(4).dot(n.transpose()), k = values.row(5).dot(n.transpose());
  // Eigenvalues of -I^-1 II: trace and determinant.
  const double det = e * g - f * f;
  const double mean = -(e * k - 2 * f * m + g * l) / (2 * det), gauss = (l * k - m * m) / det;
  const double root = std::sqrt(std::max(0.0, mean * mean - gauss));
  return {mean - root, mean + root, values.row(0), n.transpose()};
}

}  // namespace udcp
