// The symmetric linear systems of interpolation: a diagonal, weight 1 along edges, and a mean over every face. Knows how to solve
// them, not where they come from.
#pragma once

#include <array>
#include <vector>

#include "operators/run.h"

namespace udcp {

/// x goes to diagonal x + the sum over the edges at each unknown + the sum over its faces of face_weight times the sum of the
/// face's members.
template <class S>
struct MeshSystem {
  std::vector<S> diagonal;                // per unknown
  std::vector<std::array<int, 2>> edges;  // pairs of unknowns
  std::vector<int> face_begin{0};         // the members of face f are member[face_begin[f]] .. member[face_begin[f + 1] - 1]
  std::vector<int> member;
  std::vector<S> face_weight;  // per face
  [[nodiscard]] int size() const { return static_cast<int>(diagonal.size()); }
  [[nodiscard]] int faces() const { return static_cast<int>(face_weight.size()); }
};

template <class S>
Points<S> apply(const MeshSystem<S>& system, const Points<S>& x);

/// x with apply(system, x) = right, for a positive definite system. double: sparse Cholesky with one step of refinement; beyond
/// 20,000 unknowns conjugate gradients, whose work is linear, with Cholesky behind them for nearly singular systems of up to
/// 300,000. The other types: elimination without rounding (enclosures: outward), refused beyond `largest_exact_system` unknowns
/// with Error{limit, "E_TOO_LARGE"}. Throws Error{limit, "E_SINGULAR"} where a pivot cannot be told from 0 or nothing settles,
/// and Error{interrupted}.
template <class S>
Points<S> solve(const MeshSystem<S>& system, const Points<S>& right, const RunControl& control = {});

inline constexpr int largest_exact_system = 400;

}  // namespace udcp
