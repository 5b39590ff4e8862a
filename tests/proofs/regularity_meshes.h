// The regularity meshes and what is expected of them, and nets for properties. Exact.
#pragma once

#include <doctest/doctest.h>

#include <fstream>
#include <random>

#include "files/geometry_file.h"
#include "operators/run.h"
#include "operators/schemes.h"
#include "proofs/regularity/adaptive.h"
#include "proofs/regularity/quad_mesh.h"

namespace udcp::oracle {

inline const Json& expected_regularity() {
  static const Json all = Json::parse(std::ifstream(UDCP_TEST_DATA "/regularity.json"));
  return all;
}

inline Surface<Rational> regularity_mesh(const std::string& name) {
  return with_one_face_corners(load<Rational>(UDCP_TEST_DATA "/regularity/" + name + ".obj"));
}

inline Surface<Rational> refined(Surface<Rational> surface, int steps) {
  return run(schemes::catmull_clark(), std::move(surface), steps);
}

/// The patches of a mode, as decide_patches takes them.
struct Patches {
  std::vector<int> faces;  // per patch
  std::vector<BicubicNet> nets;
  std::vector<int> groups;
};
inline Patches patches(const QuadMesh& mesh, RegularityMode mode) {
  Patches result;
  const std::vector<int> groups = mesh.groups(mode);
  for (int f = 0; f < mesh.mesh().faces(); ++f) {
    if (mesh.kind_of(f, mode) != FaceKind::patch) continue;
    result.faces.push_back(f);
    result.nets.push_back(mesh.net(f));
    result.groups.push_back(groups[static_cast<std::size_t>(f)]);
  }
  return result;
}

inline int count(const QuadMesh& mesh, RegularityMode mode, FaceKind kind) {
  int n = 0;
  for (int f = 0; f < mesh.mesh().faces(); ++f) n += mesh.kind_of(f, mode) == kind ? 1 : 0;
  return n;
}

/// Random nets, fixed seed: a grid with noise, so that every gap between the tests occurs.
inline BicubicNet random_net(std::mt19937& random, bool planar, int noise) {
  std::uniform_int_distribution<int> jitter(-noise, noise), side(0, 3);
  BicubicNet net;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) net.at(i, j) = {10 * j + jitter(random), 10 * i + jitter(random), planar ? 0 : jitter(random)};
  return net;
}

}  // namespace udcp::oracle
