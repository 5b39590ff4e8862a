// Compares a plan's result with the atoms one by one: the same faces, found by walking both meshes at once, and the same points.
#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "operators/plan/correspondence.h"
#include "operators/plan/refine.h"

namespace udcp::test {

/// The largest difference between a plan and run(), over the size of the points. -1 where the faces differ, -2 without a plan.
template <class R>
double difference_to_run(const Word& word, const Surface<double>& surface, int rounds, PlanControl control = {}) {
  control.always = true;
  const Compiled<R> compiled = compile<R>(word, surface, rounds, control);
  if (!compiled.plan) return -2;
  FlatMesh<R> flat;
  execute(*compiled.plan, surface.points, flat, control);
  const Surface<double> expected = run(word, surface, rounds, control.run);
  const Mesh mesh = half_edges_of(flat);
  const std::vector<int> counterpart = numbers_in_plan(*expected.mesh, mesh, *compiled.plan->mesh);
  if (counterpart.empty()) return -1;
  for (int v = 0; v < surface.mesh->vertices(); ++v)
    if (counterpart[Mesh::i(v)] != v) return -1;
  double difference = 0;
  const double size = std::max(expected.points.cwiseAbs().maxCoeff(), surface.points.cwiseAbs().maxCoeff());
  for (int v = 0; v < expected.mesh->vertices(); ++v) {
    for (int c = 0; c < expected.points.cols(); ++c) {
      const double found = flat.points[3 * Mesh::i(counterpart[Mesh::i(v)]) + Mesh::i(c)];
      const double apart = std::abs(found - expected.points(v, c));
      difference = std::isnan(apart) ? 1e300 : std::max(difference, apart);
    }
  }
  return difference / size;
}

}  // namespace udcp::test
