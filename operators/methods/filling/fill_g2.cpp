// The conditions of the fill, and the fill of a mesh.
#include "operators/methods/filling/fill_g2.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "operators/interrupt.h"
#include "operators/matrix.h"
#include "operators/schemes.h"
#include "operators/topology.h"

namespace udcp {
namespace {

std::size_t at(int k) { return Mesh::i(k); }

bool is_extraordinary(const Mesh& mesh, int v) { return !mesh.on_boundary(v) && mesh.valence(v) != 4; }

/// What keeps a vertex from being filled, or a face from being a patch.
struct Obstacle {
  int vertex = -1;
  std::string why;
};

std::string name(int v) { return "vertex " + std::to_string(v); }

/// The first face that has more or fewer than four corners.
std::optional<Obstacle> other_face(const Mesh& mesh) {
  for (int f = 0; f < mesh.faces(); ++f) {
    if (mesh.size(f) == 4) continue;
    const int v = mesh.vertex[at(mesh.face_begin[at(f)])];
    return Obstacle{v, name(v) + " is a corner of face " + std::to_string(f) + ", which has " + std::to_string(mesh.size(f)) +
                           " corners; the fill needs quads"};
  }
  return std::nullopt;
}

/// The first extraordinary vertex whose faces have a corner that is extraordinary too, or on the boundary. All faces are quads.
std::optional<Obstacle> crowded_vertex(const Mesh& mesh) {
  for (int v = 0; v < mesh.vertices(); ++v) {
    if (!is_extraordinary(mesh, v)) continue;
    int h = mesh.outgoing[at(v)];
    do {
      for (const int w : {mesh.tip(h), mesh.tip(mesh.next(h))}) {
        const std::string who = name(v) + " of valence " + std::to_string(mesh.valence(v)) + " cannot be filled: " + name(w) +
                                " of the faces around it ";
        if (mesh.on_boundary(w)) return Obstacle{v, who + "is on the boundary"};
        if (mesh.valence(w) != 4) return Obstacle{v, who + "has valence " + std::to_string(mesh.valence(w)) + ", not 4"};
      }
      h = mesh.around(h);
    } while (h != mesh.outgoing[at(v)]);
  }
  return std::nullopt;
}

std::optional<Obstacle> obstacle(const Mesh& mesh) {
  std::optional<Obstacle> found = other_face(mesh);
  return found ? found : crowded_vertex(mesh);
}

std::string help_with_steps(int steps) {
  return steps == 1 ? "1 Catmull-Clark step makes it possible: steps = 1, or steps = auto"
                    : std::to_string(steps) + " Catmull-Clark steps make it possible: steps = " + std::to_string(steps) +
                          ", or steps = auto";
}

void check_valences(const Mesh& mesh) {
  for (int v = 0; v < mesh.vertices(); ++v) {
    if (mesh.on_boundary(v)) continue;
    if (mesh.valence(v) < 3)
      throw Error(ErrorKind::input, "E_FILL_VALENCE",
                  name(v) + " has valence 2; there is no fill below 3, and steps do not change it", "join its two faces to one");
    if (mesh.valence(v) > largest_fill_valence)
      throw Error(ErrorKind::limit, "E_FILL_VALENCE",
                  name(v) + " has valence " + std::to_string(mesh.valence(v)) + "; fills are made up to " +
                      std::to_string(largest_fill_valence),
                  "");
  }
  for (int f = 0; f < mesh.faces(); ++f)  // becomes a vertex of this valence
    if (mesh.size(f) > largest_fill_valence)
      throw Error(ErrorKind::limit, "E_FILL_VALENCE",
                  "face " + std::to_string(f) + " has " + std::to_string(mesh.size(f)) +
                      " corners; fills are made up to valence " + std::to_string(largest_fill_valence),
                  "");
}

void check_boundary(const Mesh& mesh, const Tags& tags) {
  for (int v = 0; v < mesh.vertices(); ++v) {
    if (!mesh.on_boundary(v) || mesh.valence(v) == (tags.is_corner(v) ? 2 : 3)) continue;
    const std::string what = tags.is_corner(v) ? "is a corner with " : "is on the boundary with ";
    throw Error(ErrorKind::input, "E_FILL_BOUNDARY",
                name(v) + " " + what + std::to_string(mesh.valence(v) - 1) +
                    " faces; there are patches for two faces on a boundary or one at a corner, and steps do not change it",
                "leave_out = yes makes the surface without the patches next to it");
  }
}

void check_points(const Surface<double>& surface) {
  for (Eigen::Index v = 0; v < surface.points.rows(); ++v)
    for (Eigen::Index c = 0; c < surface.points.cols(); ++c)
      if (!std::isfinite(surface.points(v, c)))
        throw Error(ErrorKind::input, "E_NOT_FINITE",
                    "coordinate " + std::to_string(c) + " of " + name(static_cast<int>(v)) + " is not finite", "");
}

void check_parameters(const std::vector<double>& c, int vertices) {
  if (c.size() > 1 && static_cast<int>(c.size()) != vertices)
    throw Error(ErrorKind::input, "E_ATTRIBUTE_SIZE",
                "c has " + std::to_string(c.size()) + " values for " + std::to_string(vertices) + " vertices", "");
  for (std::size_t v = 0; v < c.size(); ++v)
    if (!(c[v] >= 0 && c[v] <= 1))
      throw Error(ErrorKind::input, "E_ADJUSTABLE_C",
                  "c = " + to_text(c[v]) + (c.size() > 1 ? " at " + name(static_cast<int>(v)) : "") + " is not between 0 and 1",
                  "c = 1/2 is Catmull-Clark, smaller values stay closer to the mesh");
}

Surface<double> in_space(const Surface<double>& surface) {
  validate(surface);
  check_points(surface);
  if (surface.points.cols() > 3)
    throw Error(ErrorKind::input, "E_DIMENSION",
                "the points have " + std::to_string(surface.points.cols()) + " coordinates, not 3", "");
  Surface<double> result{surface.mesh, Points<double>::Zero(surface.points.rows(), 3), surface.tags, {}};
  result.points.leftCols(surface.points.cols()) = surface.points;
  return with_corners(std::move(result));
}

/// One parameter per vertex, or none if all are 1/2.
std::vector<double> spread(const std::vector<double>& c, int vertices) {
  if (std::all_of(c.begin(), c.end(), [](double x) { return x == 0.5; })) return {};
  return c.size() == 1 ? std::vector<double>(at(vertices), c[0]) : c;
}

Surface<double> refine(Surface<double> surface, const std::vector<double>& c, int steps, const RunControl& control) {
  if (c.empty()) return run(schemes::catmull_clark(), std::move(surface), steps, control);
  surface.attributes["c"] = c;
  for (int k = 0; k < steps; ++k) surface = hybrid_step(surface, "c", control);
  surface.attributes.clear();
  return surface;
}

int steps_of(const FillOptions& options, const Mesh& mesh, bool has_parameters) {
  if (options.steps > 20)
    throw Error(ErrorKind::input, "E_FILL_STEPS",
                "the number of steps is " + std::to_string(options.steps) + "; it can be 0 to 20", "");
  const int needed = fill_steps(mesh);
  if (options.steps < 0) return std::max(needed, has_parameters ? 1 : 0);
  if (options.steps < needed) {
    // The obstacle that is left after the steps asked for is the one to name; without any it is a vertex that the user knows.
    const std::optional<Obstacle> found = obstacle(mesh);
    throw Error(ErrorKind::input, "E_FILL_ISOLATED", found->why, help_with_steps(needed));
  }
  return options.steps;
}

/// The parameters near filled vertices; those of the regular patches must not be 0.
void check_final_parameters(const Mesh& mesh, const std::vector<double>& c) {
  for (int v = 0; v < mesh.vertices() && !c.empty(); ++v) {
    if (c[at(v)] == 0)
      throw Error(ErrorKind::input, "E_ADJUSTABLE_C",
                  "c = 0 at " + name(v) + " has no smooth limit; without steps c must be above 0", help_with_steps(1));
    if (!is_extraordinary(mesh, v)) continue;
    for (const int w : ring_vertices(mesh, mesh.outgoing[at(v)], 2))
      if (c[at(w)] != 0.5)
        throw Error(ErrorKind::input, "E_FILL_C",
                    name(v) + " cannot be filled: c is " + to_text(c[at(w)]) + " at " + name(w) +
                        " in its two rings, where the fill needs 1/2",
                    help_with_steps(1));
  }
}

void fill_vertex(PatchSurface& surface, int v, FillMasks& masks) {
  const Mesh& mesh = *surface.cage.mesh;
  const int n = mesh.valence(v);
  const std::vector<int> ring = ring_vertices(mesh, mesh.outgoing[at(v)], 2);
  Points<double> points(static_cast<Eigen::Index>(ring.size()), 3);
  for (std::size_t k = 0; k < ring.size(); ++k) points.row(static_cast<Eigen::Index>(k)) = surface.cage.points.row(ring[k]);
  const Points<double> bezier = apply(masks.of(n), points);
  int spoke = mesh.outgoing[at(v)];
  for (int i = 0; i < n; ++i) {
    const int f = mesh.face[at(spoke)];
    surface.first[at(f)] = spoke;
    surface.patches[at(f)] = {fill_degree, fill_degree, bezier.middleRows(fill_points * i, fill_points)};
    spoke = mesh.around(spoke);
  }
  surface.filled.push_back(v);
}

}  // namespace

int fill_steps(const Mesh& mesh) {
  if (!obstacle(mesh)) return 0;
  return other_face(mesh) && obstacle(split_mesh(mesh, {})) ? 2 : 1;
}

PatchSurface fill_g2(const Surface<double>& surface, const FillOptions& options) {
  Surface<double> cage = in_space(surface);
  const int vertices = cage.mesh->vertices();
  check_parameters(options.c, vertices);
  check_valences(*cage.mesh);
  if (!options.leave_out) check_boundary(*cage.mesh, cage.tags);
  std::vector<double> c = spread(options.c, vertices);
  const int steps = steps_of(options, *cage.mesh, !c.empty());
  if (steps > 0) {
    cage = refine(std::move(cage), c, steps, options.control);
    c.clear();
  }
  check_final_parameters(*cage.mesh, c);
  PatchSurface result = regular_patches(std::move(cage), c, options.tangents);
  result.steps = steps;
  FillMasks own;
  const Mesh& mesh = *result.cage.mesh;
  for (int v = 0; v < mesh.vertices(); ++v) {
    throw_if_stopped(options.control.stop);
    if (is_extraordinary(mesh, v)) fill_vertex(result, v, options.masks ? *options.masks : own);
  }
  return result;
}

PatchSurface plain_surface(const Surface<double>& surface, int steps, const RunControl& control) {
  PatchSurface result = regular_patches(run(schemes::catmull_clark(), in_space(surface), steps, control));
  result.steps = steps;
  return result;
}

namespace {

/// The three rings around a vertex as a surface of their own.
Surface<double> three_rings(const Surface<double>& surface, int vertex) {
  const Mesh& mesh = *surface.mesh;
  Surface<double> net = ring_mesh(mesh.valence(vertex), 3);
  const std::vector<int> ring = ring_vertices(mesh, mesh.outgoing[at(vertex)], 3);
  for (std::size_t k = 0; k < ring.size(); ++k) net.points.row(static_cast<Eigen::Index>(k)) = surface.points.row(ring[k]);
  return net;
}

void check_rings(const Mesh& mesh, int vertex) {
  if (vertex < 0 || vertex >= mesh.vertices() || mesh.on_boundary(vertex))
    throw Error(ErrorKind::input, "E_INDEX", "there is no interior " + name(vertex), "");
  const FaceRings around = face_rings(mesh, vertex);
  const auto is_regular = [&](int f, int w) {
    return mesh.size(f) == 4 && (w == vertex || (!mesh.on_boundary(w) && mesh.valence(w) == 4));
  };
  bool regular = static_cast<int>(around.outer.size()) == 3 * mesh.valence(vertex);
  for (const auto& list : {around.inner, around.outer})
    for (const int f : list)
      for (const int w : mesh.corners(f)) regular &= is_regular(f, w);
  if (!regular)
    throw Error(ErrorKind::input, "E_FILL_ISOLATED", name(vertex) + " has no two rings of regular vertices around it",
                "refine the mesh first, by up to three Catmull-Clark steps");
}

}  // namespace

std::vector<std::vector<BezierPatch>> catmull_clark_rings(const Surface<double>& surface, int vertex, int levels) {
  const Surface<double> start = in_space(surface);
  check_rings(*start.mesh, vertex);
  Surface<double> net = three_rings(start, vertex);
  std::vector<std::vector<BezierPatch>> result;
  for (int level = 0; level <= levels; ++level) {
    result.emplace_back();
    for (const int f : face_rings(*net.mesh, 0).outer)
      result.back().push_back({3, 3, hybrid_patch<double>(*regular_net(net, net.mesh->face_begin[at(f)]), {0.5, 0.5, 0.5, 0.5})});
    net = three_rings(run(schemes::catmull_clark(), net, 1), 0);
  }
  return result;
}

std::vector<CurvatureExtrema> catmull_clark_curvature(const Surface<double>& surface, int vertex, int levels) {
  std::vector<CurvatureExtrema> result;
  for (const std::vector<BezierPatch>& ring : catmull_clark_rings(surface, vertex, levels)) {
    result.emplace_back();
    for (const BezierPatch& patch : ring) result.back().include(patch, 3);
  }
  return result;
}

}  // namespace udcp
