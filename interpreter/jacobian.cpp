// Derivatives by the corner formula of the nets, evaluated exactly on the refined points, which are doubles.
#include "interpreter/jacobian.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "operators/interrupt.h"
#include "operators/schemes.h"
#include "proofs/regularity/quad_mesh.h"

namespace udcp {
namespace {

constexpr std::int64_t most_faces = 250'000;

std::size_t at(int k) { return Mesh::i(k); }

bool is_regular(VertexClass c) { return c == VertexClass::interior || c == VertexClass::boundary || c == VertexClass::corner; }

void check_size(std::int64_t faces, int steps) {
  for (int k = 0; k < steps && faces <= most_faces; ++k) faces *= 4;
  if (faces <= most_faces) return;
  throw Error(ErrorKind::limit, "E_MAX_FACES",
              "jacobian would make at least " + std::to_string(faces) + " faces; its limit is " + std::to_string(most_faces),
              "take fewer steps");
}

/// The corners that QuadMesh wants, and its error for other faces than quads.
Tags checked_tags(const Surface<double>& surface) {
  validate(surface);
  Surface<Rational> bare{surface.mesh, Points<Rational>::Constant(surface.points.rows(), 1, Rational(0)), surface.tags, {}};
  return QuadMesh(with_one_face_corners(std::move(bare))).surface().tags;
}

QuadMesh exact_mesh(const Surface<double>& surface) {
  Points<Rational> points(surface.points.rows(), surface.points.cols());
  for (Eigen::Index k = 0; k < points.size(); ++k) points.data()[k] = Rational::from_double(surface.points.data()[k]);
  return QuadMesh({surface.mesh, std::move(points), surface.tags, {}});
}

/// The length, or in the plane the determinant. A number that is not 0 does not become 0, which would look singular.
double stretch_of(const Vector3& normal, bool planar) {
  std::array<double, 3> n{};
  for (std::size_t c = 0; c < 3; ++c) n[c] = normal[c].to_double();
  const double value = planar ? n[2] : std::hypot(n[0], n[1], n[2]);
  if (std::isfinite(value) && (value != 0 || is_zero(normal))) return value;
  throw Error(ErrorKind::input, "E_NOT_FINITE",
              std::string("a value of the Jacobian is too ") + (value == 0 ? "small" : "large") +
                  " for floating point: it grows with the square of the coordinates",
              "scale the mesh to another size");
}

/// S_u x S_v at each regular vertex, and which those are. `unit`: what the corner values of a net have to be divided by.
struct Stretch {
  std::vector<double> value;
  std::vector<char> known;
};
Stretch stretch_of(const QuadMesh& quads, const Rational& unit, const std::atomic<bool>* stop) {
  const Mesh& mesh = quads.mesh();
  Stretch result{std::vector<double>(at(mesh.vertices()), 0), std::vector<char>(at(mesh.vertices()), 0)};
  for (int v = 0; v < mesh.vertices(); ++v) {
    if (!is_regular(quads.class_of(v))) continue;
    if (v % 256 == 0) throw_if_stopped(stop);
    const int h = mesh.outgoing[at(v)], face = mesh.face[at(h)], number = h - mesh.face_begin[at(face)];
    const CornerValues values = corner(quads.net(face), number / 2, (number == 1 || number == 2) ? 1 : 0);
    result.value[at(v)] = stretch_of(Rational(1) / unit * cross(values.du, values.dv), quads.is_planar());
    result.known[at(v)] = 1;
  }
  return result;
}

/// The other vertices, from their neighbours inwards.
void fill_from_neighbours(const Mesh& mesh, Stretch& stretch) {
  for (bool changed = true; changed;) {
    changed = false;
    std::vector<double> sum(stretch.value.size(), 0);
    std::vector<int> count(stretch.value.size(), 0);
    for (const int h : mesh.edge_half) {
      const int a = mesh.vertex[at(h)], b = mesh.tip(h);
      for (const auto& [from, to] : {std::pair(a, b), std::pair(b, a)}) {
        if (stretch.known[at(from)] == 0 || stretch.known[at(to)] != 0) continue;
        sum[at(to)] += stretch.value[at(from)];
        ++count[at(to)];
      }
    }
    for (std::size_t v = 0; v < count.size(); ++v) {
      if (count[v] == 0) continue;
      stretch.value[v] = sum[v] / count[v];
      stretch.known[v] = 1;
      changed = true;
    }
  }
}

/// Faces may be given clockwise: the sign that most of a component has becomes positive.
void orient_components(const Mesh& mesh, std::vector<double>& values) {
  std::vector<int> component(values.size(), -1), stack;
  for (int start = 0; start < mesh.vertices(); ++start) {
    if (component[at(start)] >= 0) continue;
    std::vector<int> members;
    stack.push_back(start);
    component[at(start)] = start;
    double sum = 0;
    while (!stack.empty()) {
      const int v = stack.back();
      stack.pop_back();
      members.push_back(v);
      sum += values[at(v)];
      for (int h = mesh.outgoing[at(v)], first = h; h >= 0;) {
        for (const int w : {mesh.tip(h), mesh.vertex[at(mesh.prev(h))]}) {
          if (component[at(w)] >= 0) continue;
          component[at(w)] = start;
          stack.push_back(w);
        }
        h = mesh.around(h);
        if (h == first) break;
      }
    }
    if (sum >= 0) continue;
    for (const int v : members) values[at(v)] = -values[at(v)];
  }
}

}  // namespace

JacobianSurface jacobian_surface(Surface<double> surface, int steps, RunControl control) {
  surface.tags = checked_tags(surface);
  check_size(surface.mesh->faces(), steps);
  surface.attributes.clear();
  const Word& word = schemes::catmull_clark();
  JacobianSurface result{run(word, std::move(surface), steps, control), {}};
  const QuadMesh quads = exact_mesh(result.surface);
  const Rational unit =
      Rational(144) * quads.scale() * quads.scale() / pow(Rational(4), steps);  // a step halves the unit of both parameters
  Stretch stretch = stretch_of(quads, unit, control.stop);
  fill_from_neighbours(quads.mesh(), stretch);
  if (quads.is_planar()) orient_components(quads.mesh(), stretch.value);
  control.first_item = word.items(steps);
  Limit limits = limit(word, result.surface, control);
  result.surface.points = std::move(limits.points);
  result.surface.attributes["jacobian"] = std::move(stretch.value);
  result.normals = std::move(limits.normals);
  return result;
}

}  // namespace udcp
