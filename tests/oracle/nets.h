// Nets of three rings around a vertex, numbered as ring_mesh numbers them: the shapes on which fills are compared.
#pragma once

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "operators/matrix.h"
#include "operators/methods/filling/patch_surface.h"
#include "operators/schemes.h"
#include "tests/oracle/inputs.h"

namespace udcp::oracle {

inline Points<double> points_of(const nlohmann::json& list) {
  Points<double> result(static_cast<Eigen::Index>(list.size()), 3);
  for (std::size_t i = 0; i < list.size(); ++i)
    for (std::size_t c = 0; c < 3; ++c)
      result(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(c)) = list[i][c].get<double>();
  return result;
}

/// The three rings around a vertex of a mesh.
inline Points<double> rings_around(const Surface<double>& surface, int v) {
  const std::vector<int> ring = ring_vertices(*surface.mesh, surface.mesh->outgoing[Mesh::i(v)], 3);
  Points<double> result(static_cast<Eigen::Index>(ring.size()), 3);
  for (std::size_t k = 0; k < ring.size(); ++k) result.row(static_cast<Eigen::Index>(k)) = surface.points.row(ring[k]);
  return result;
}

/// A polyhedron with two poles of valence n and 2 n vertices of valence 3 on zigzags between them.
inline Surface<double> trapezohedron(int n) {
  const double a = std::numbers::pi / n, d = (1 - std::cos(a)) / (1 + std::cos(a));
  Surface<double> result;
  result.points.resize(2 * n + 2, 3);
  result.points.row(0) << 0, 0, 1;
  result.points.row(1) << 0, 0, -1;
  for (int k = 0; k < 2 * n; ++k) result.points.row(2 + k) << std::cos(a * k), std::sin(a * k), k % 2 == 0 ? d : -d;
  Faces faces;
  const auto z = [n](int k) { return 2 + k % (2 * n); };
  for (int i = 0; i < n; ++i) {
    faces.push_back({0, z(2 * i), z(2 * i + 1), z(2 * i + 2)});
    faces.push_back({1, z(2 * i + 3), z(2 * i + 2), z(2 * i + 1)});
  }
  result.mesh = std::make_shared<const Mesh>(make_mesh(2 * n + 2, faces));
  return result;
}

/// The pole of the trapezohedron after two Catmull-Clark steps: convex.
inline Points<double> apex_net(int n) { return rings_around(run(schemes::catmull_clark(), trapezohedron(n), 2), 0); }

/// Three rings of a net after `steps` Catmull-Clark steps.
inline Points<double> refined_net(const Points<double>& net, int n, int steps) {
  Surface<double> surface = ring_mesh(n, 3);
  for (surface.points = net; steps > 0; --steps) surface.points = rings_around(run(schemes::catmull_clark(), surface, 1), 0);
  return surface.points;
}

/// z = height (x^2 - y^2) over the flat net, refined twice: negative curvature.
inline Points<double> saddle_net(int n, double height = 0.15) {
  Points<double> net = ring_mesh(n, 3).points;
  for (Eigen::Index i = 0; i < net.rows(); ++i) net(i, 2) = height * (net(i, 0) * net(i, 0) - net(i, 1) * net(i, 1));
  return refined_net(net, n, 2);
}

/// No sensible surface: every point of the flat net somewhere near its place.
inline Points<double> bumpy_net(int n) {
  Dice dice(static_cast<unsigned>(900 + n));
  Points<double> net = ring_mesh(n, 3).points;
  for (Eigen::Index k = 0; k < net.size(); ++k) net.data()[k] += dice.fraction().to_double() / 100;
  return net;
}

}  // namespace udcp::oracle
