// The linear system M d = right side whose solution has given limit points: boundary curves first, then the interior, which is
// symmetric positive definite after scaling ("Offset approximation of Loop subdivision surfaces", eq. (7)). Knows no offsets.
#pragma once

#include <atomic>
#include <functional>
#include <string_view>
#include <vector>

#include "operators/methods/offset/loop_limit.h"

namespace udcp {

/// `automatic`: direct up to 100,000 unknowns, conjugate gradients beyond, where a factorisation takes long and cannot be
/// stopped.
enum class OffsetSolver { automatic, direct, edge, star, gauss_seidel, richardson, conjugate_gradients, jacobi };
std::string_view name_of(OffsetSolver solver);

struct SolveOptions {
  OffsetSolver solver = OffsetSolver::automatic;
  double tolerance = 1e-13;  // of iterative solvers: largest entry of |M d - r| by the largest entry of |r|
  int max_iterations = 2000;
  const std::atomic<bool>* stop = nullptr;        // set: Error{interrupted}
  std::function<void(double fraction)> progress;  // of an estimate from the residual
};

struct OffsetSolution {
  Points<double> d;
  OffsetSolver solver = OffsetSolver::direct;
  int iterations = 0;      // 0 for direct
  double residual = 0;     // as for `tolerance`
  double contraction = 0;  // edge and star: the largest Lambda, else 0
};

/// The interior rows K x = b, K = W + A: diagonal w_i, 1 per edge between two interior vertices (of the active ones).
struct OffsetSystem {
  std::vector<int> vertex;            // per unknown
  std::vector<int> unknown;           // per vertex, -1 for none
  std::vector<double> weight;         // w per unknown
  std::vector<int> valence;           // N per unknown: all neighbours, also those without an unknown
  std::vector<int> begin, neighbour;  // unknowns next to each unknown, counter-clockwise
  [[nodiscard]] int size() const { return static_cast<int>(vertex.size()); }
  [[nodiscard]] std::span<const int> around(int i) const {
    const auto k = static_cast<std::size_t>(i);
    return {neighbour.data() + begin[k], static_cast<std::size_t>(begin[k + 1] - begin[k])};
  }
};
/// `active`, a flag per vertex, may leave vertices out; null: all interior vertices.
OffsetSystem offset_system(const LoopLimit<double>& limit, const std::vector<char>* active = nullptr);

/// d with M d = wanted at the active vertices and d = 0 at the others (all are active if null). Any number of columns. Throws
/// Error{limit, "E_NO_CONVERGENCE"} with the residual reached, Error{input, "E_NOT_CONTRACTIVE"} where Lambda_i >= 1 for edge and
/// star, Error{interrupted}.
OffsetSolution solve_offset(const LoopLimit<double>& limit, const Points<double>& wanted, const SolveOptions& options = {},
                            const std::vector<char>* active = nullptr);

/// The paper's iteration: d_i <- sum of `old` coefficients times d - values, plus sum of `right` coefficients times b. Per
/// unknown i its entries are begin_*[i] .. begin_*[i+1] - 1, and `set` lists its local set, i first.
struct EdgeIteration {
  std::vector<int> begin_old, old_index, begin_right, right_index;
  std::vector<double> old_value, right_value;
  std::vector<double> lambda;  // sum of |old coefficients| per unknown
};
/// Local sets: with `star` i and all neighbours; else (paper) that for valence 3 and 4, and i and its regular neighbour of
/// smallest vertex otherwise; without one, the partner of smallest Lambda.
EdgeIteration edge_iteration(const OffsetSystem& system, bool star = false, const std::atomic<bool>* stop = nullptr);
/// Lambda(i, j) of a pair of interior vertices of these valences whose other neighbours are all different.
double pair_contraction(int valence_i, int valence_j);
/// Lambda of the star of a vertex with regular neighbours: 3 N/(8 w - N).
double star_contraction(int valence);
/// The theorem's lower bound of the eigenvalues of M on closed meshes: the least of (w - N/2)/(w + N).
double least_eigenvalue_bound(const OffsetSystem& system);

}  // namespace udcp
