// Random exact inputs, the same on every machine, and a catalogue of small meshes with boundaries, extraordinary vertices and
// n-gons.
#pragma once

#include <map>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "operators/matrix.h"
#include "operators/polyline.h"
#include "operators/shapes.h"
#include "operators/surface.h"

namespace udcp::oracle {

using Faces = std::vector<std::vector<int>>;

class Dice {
 public:
  explicit Dice(unsigned seed) : engine_(seed) {}
  int below(int n) { return static_cast<int>(engine_() % static_cast<unsigned>(n)); }
  int between(int low, int high) { return low + below(high - low + 1); }
  bool one_in(int n) { return below(n) == 0; }
  /// p/q with |p| <= 30 and q <= 9.
  Rational fraction() { return Rational(between(-30, 30)) / Rational(between(1, 9)); }
  Rational positive() { return Rational(between(1, 30)) / Rational(between(1, 9)); }

 private:
  std::mt19937 engine_;
};

template <class S>
Points<S> random_points(Dice& dice, int n, int columns) {
  Points<S> points(n, columns);
  for (Eigen::Index k = 0; k < points.size(); ++k) points.data()[k] = number<S>(dice.fraction());
  return points;
}

template <class S>
Polyline<S> random_curve(Dice& dice, int n, bool closed, int columns = 2) {
  return {random_points<S>(dice, n, columns), closed, {}, {}};
}

template <class S>
Surface<S> random_surface(Dice& dice, const Mesh& mesh, int columns = 3) {
  return {std::make_shared<const Mesh>(mesh), random_points<S>(dice, mesh.vertices(), columns), {}, {}};
}

inline Faces faces_of(const Mesh& mesh) {
  Faces faces;
  for (int f = 0; f < mesh.faces(); ++f) faces.emplace_back(mesh.corners(f).begin(), mesh.corners(f).end());
  return faces;
}

struct NamedMesh {
  std::string name;
  Mesh mesh;
};

inline Mesh prism(int n) {
  Faces faces(2);
  for (int i = 0; i < n; ++i) {
    faces[0].push_back(n - 1 - i);
    faces[1].push_back(n + i);
    faces.push_back({i, (i + 1) % n, n + (i + 1) % n, n + i});
  }
  return make_mesh(2 * n, faces);
}

/// Two rings of pentagons and two caps: vertices 0-4 top cap, 5-9 below it, 10-14 above the bottom cap, 15-19 bottom cap.
inline Mesh dodecahedron() {
  Faces faces{{0, 1, 2, 3, 4}, {19, 18, 17, 16, 15}};
  for (int i = 0; i < 5; ++i) {
    const int j = (i + 1) % 5;
    faces.push_back({i, 5 + i, 10 + i, 5 + j, j});
    faces.push_back({15 + i, 15 + j, 10 + j, 5 + j, 10 + i});
  }
  return make_mesh(20, faces);
}

/// Three quads round a reflex corner (vertex 4, on the boundary, with three faces).
inline Mesh l_shape() { return make_mesh(8, Faces{{0, 1, 4, 3}, {1, 2, 5, 4}, {3, 4, 7, 6}}); }

inline std::vector<NamedMesh> quad_meshes() {
  return {
      {"cube", *cube<Rational>().mesh},           {"grid", *grid<Rational>(3, 2).mesh},       {"L", l_shape()},
      {"star 3", *ring_mesh(3, 2).mesh},          {"star 5", *ring_mesh(5, 2).mesh},          {"star 7", *ring_mesh(7, 1).mesh},
      {"torus", *torus<double>(4, 3, 2, 1).mesh}, {"quad", make_mesh(4, Faces{{0, 1, 2, 3}})}};
}

inline std::vector<NamedMesh> polygon_meshes() {
  return {{"dodecahedron", dodecahedron()},
          {"prism 5", prism(5)},
          {"prism 7", prism(7)},
          {"tetrahedron", *tetrahedron<Rational>().mesh},
          {"pyramid", make_mesh(6, Faces{{0, 1, 5}, {1, 2, 5}, {2, 3, 5}, {3, 4, 5}, {4, 0, 5}, {4, 3, 2, 1, 0}})},
          {"triangle", make_mesh(3, Faces{{0, 1, 2}})},
          // a hexagon, two quads, a pentagon and a triangle round the inner vertices 1 and 4, open
          {"mixed", make_mesh(12, Faces{{0, 5, 1}, {1, 5, 6, 4}, {0, 1, 2, 3}, {1, 4, 7, 8, 9, 2}, {4, 6, 10, 11, 7}})}};
}

inline std::vector<NamedMesh> triangle_meshes() {
  std::vector<NamedMesh> result{{"tetrahedron", *tetrahedron<Rational>().mesh},
                                {"octahedron", *octahedron<Rational>().mesh},
                                {"triangle", make_mesh(3, Faces{{0, 1, 2}})},
                                {"strip", make_mesh(5, Faces{{0, 1, 2}, {2, 1, 3}, {2, 3, 4}})}};
  for (int n = 3; n <= 8; ++n) result.push_back({"star " + std::to_string(n), *ring_mesh(n, 2, true).mesh});
  return result;
}

/// A piece of a grid with holes, some cells cut into triangles, random vertex numbers, faces in random order and turned at
/// random.
inline Mesh random_mesh(Dice& dice, bool quads_only = false) {
  for (;;) {
    const int nx = dice.between(1, 4), ny = dice.between(1, 4);
    Faces faces;
    std::map<int, int> index;
    const auto push = [&](std::vector<int> corners) {
      for (int& v : corners) v = index.try_emplace(v, static_cast<int>(index.size())).first->second;
      std::rotate(corners.begin(), corners.begin() + dice.below(static_cast<int>(corners.size())), corners.end());
      faces.push_back(corners);
    };
    for (int cell = 0; cell < nx * ny; ++cell) {
      if (dice.one_in(5)) continue;
      const int v = cell / nx * (nx + 1) + cell % nx, w = v + nx + 1;
      if (!quads_only && dice.one_in(4)) {
        push({v, v + 1, w});
        push({w, v + 1, w + 1});
      } else {
        push({v, v + 1, w + 1, w});
      }
    }
    for (std::size_t k = 1; k < faces.size(); ++k)
      std::swap(faces[k], faces[static_cast<std::size_t>(dice.below(static_cast<int>(k) + 1))]);
    try {
      return make_mesh(static_cast<int>(index.size()), faces);
    } catch (const Error&) {  // cells that meet in a vertex only, or none at all: another one
    }
  }
}

/// The atoms of a word that validates: some D before the first U, sections 2 to 4, P where parity allows.
inline std::string random_atoms(Dice& dice) {
  std::string atoms(static_cast<std::size_t>(dice.below(3)), 'D');
  const int ups = dice.between(1, 2);
  for (int u = 0; u < ups; ++u) {
    atoms += dice.one_in(3) ? "U" + std::to_string(dice.between(3, 4)) : "U";
    int averages = 0;
    for (int k = dice.between(0, 3); k > 0; --k) {
      const char letter = "DCP"[dice.below(3)];
      if (letter == 'P' && averages % 2 != 0) continue;
      averages += letter == 'D';
      atoms += letter;
    }
  }
  return atoms;
}

/// Every boundary vertex a corner with chance 1 in n.
inline Tags random_corners(Dice& dice, const Mesh& mesh, int n) {
  Tags tags;
  tags.corner.assign(Mesh::i(mesh.vertices()), 0);
  for (int v = 0; v < mesh.vertices(); ++v) tags.corner[Mesh::i(v)] = mesh.on_boundary(v) && dice.one_in(n);
  return tags;
}

}  // namespace udcp::oracle
