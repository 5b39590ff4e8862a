// Boundary curves by tridiagonal elimination, the interior by the solver asked for.
#include "operators/methods/offset/offset_system.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "operators/interrupt.h"
#include "operators/methods/offset/offset_iterations.h"
#include "operators/methods/sparse_solvers.h"

namespace udcp {
namespace {

std::size_t at(int k) { return static_cast<std::size_t>(k); }

constexpr int largest_direct = 100'000;

bool is_active(const std::vector<char>* active, int v) { return active == nullptr || (*active)[at(v)] != 0; }

/// Rows centre x_k + end (x_{k-1} + x_{k+1}) = right_k along vertices of a boundary curve, where x is 0 beyond the ends.
Points<double> solve_chain(const BoundaryWeights<double>& weights, Points<double> right) {
  const Eigen::Index n = right.rows();
  std::vector<double> ratio(static_cast<std::size_t>(n));
  double pivot = weights.centre;
  for (Eigen::Index k = 0; k < n; ++k) {
    if (k > 0) {
      pivot = weights.centre - weights.end * ratio[static_cast<std::size_t>(k - 1)];
      right.row(k) -= weights.end * right.row(k - 1);
    }
    right.row(k) /= pivot;
    ratio[static_cast<std::size_t>(k)] = weights.end / pivot;
  }
  for (Eigen::Index k = n - 1; k-- > 0;) right.row(k) -= ratio[static_cast<std::size_t>(k)] * right.row(k + 1);
  return right;
}

/// The same along a closed curve of n >= 3 vertices: the chain of all but the last, corrected so that the last row holds.
Points<double> solve_cycle(const BoundaryWeights<double>& weights, const Points<double>& right) {
  const Eigen::Index n = right.rows();
  Points<double> chain = Points<double>::Zero(n - 1, right.cols() + 1);
  chain.leftCols(right.cols()) = right.topRows(n - 1);
  chain(0, right.cols()) = chain(n - 2, right.cols()) = -weights.end;  // what x_{n-1} = 1 moves to the right side
  chain = solve_chain(weights, std::move(chain));
  const Eigen::RowVectorXd ends = chain.row(0) + chain.row(n - 2);
  const Eigen::RowVectorXd last =
      (right.row(n - 1) - weights.end * ends.head(right.cols())) / (weights.centre + weights.end * ends[right.cols()]);
  Points<double> result(n, right.cols());
  result.topRows(n - 1) = chain.leftCols(right.cols()) + chain.col(right.cols()) * last;
  result.row(n - 1) = last;
  return result;
}

/// Writes the solution along one boundary curve to d.
void solve_curve(const LoopLimit<double>& limit, const std::vector<int>& curve, const Points<double>& wanted,
                 const std::vector<char>* active, Points<double>& d) {
  const auto is_fixed = [&](int v) { return limit.tags().is_corner(v) || !is_active(active, v); };
  const int n = static_cast<int>(curve.size());
  int first = 0;
  while (first < n && !is_fixed(curve[at(first)])) ++first;
  const auto rows = [&](const std::vector<int>& vertices) {
    Points<double> right(static_cast<Eigen::Index>(vertices.size()), wanted.cols());
    for (std::size_t k = 0; k < vertices.size(); ++k) right.row(static_cast<Eigen::Index>(k)) = wanted.row(vertices[k]);
    return right;
  };
  const auto write = [&](const std::vector<int>& vertices, const Points<double>& values) {
    for (std::size_t k = 0; k < vertices.size(); ++k) d.row(vertices[k]) = values.row(static_cast<Eigen::Index>(k));
  };
  if (first == n) return write(curve, solve_cycle(limit.boundary_weights(), rows(curve)));
  for (const int v : curve)
    if (is_fixed(v) && is_active(active, v)) d.row(v) = wanted.row(v);
  std::vector<int> chain;
  for (int k = 1; k <= n; ++k) {
    const int v = curve[at((first + k) % n)];
    if (!is_fixed(v)) {
      chain.push_back(v);
      continue;
    }
    if (!chain.empty()) {
      Points<double> right = rows(chain);
      right.row(0) -= limit.boundary_weights().end * d.row(curve[at((first + k - 1 - static_cast<int>(chain.size()) + n) % n)]);
      right.row(right.rows() - 1) -= limit.boundary_weights().end * d.row(v);
      write(chain, solve_chain(limit.boundary_weights(), std::move(right)));
    }
    chain.clear();
  }
}

Points<double> solve_boundary(const LoopLimit<double>& limit, const Points<double>& wanted, const std::vector<char>* active) {
  const Mesh& mesh = limit.mesh();
  Points<double> d = Points<double>::Zero(wanted.rows(), wanted.cols());
  std::vector<char> seen(at(mesh.vertices()), 0);
  for (int start = 0; start < mesh.vertices(); ++start) {
    if (!mesh.on_boundary(start) || seen[at(start)] != 0) continue;
    std::vector<int> curve;
    for (int v = start; seen[at(v)] == 0; v = mesh.tip(mesh.outgoing[at(v)])) {
      seen[at(v)] = 1;
      curve.push_back(v);
    }
    solve_curve(limit, curve, wanted, active, d);
  }
  return d;
}

Points<double> solve_directly(const OffsetSystem& system, const Points<double>& right) {
  std::vector<Entry> lower;
  lower.reserve(at(system.size()) + system.neighbour.size() / 2);
  for (int i = 0; i < system.size(); ++i) {
    lower.push_back({i, i, system.weight[at(i)]});
    for (const int j : system.around(i))
      if (j < i) lower.push_back({i, j, 1.0});
  }
  return solve_positive_definite(system.size(), lower, right);
}

/// Right side of K x = b: (w + N) wanted - what known neighbours contribute.
Points<double> right_side(const LoopLimit<double>& limit, const OffsetSystem& system, const Points<double>& wanted,
                          const Points<double>& known) {
  Points<double> b(system.size(), wanted.cols());
  for (int i = 0; i < system.size(); ++i) {
    const int v = system.vertex[at(i)];
    b.row(i) = (system.weight[at(i)] + system.valence[at(i)]) * wanted.row(v);
    for (const int u : limit.rings().of(v))
      if (system.unknown[at(u)] < 0) b.row(i) -= known.row(u);
  }
  return b;
}

double residual_of(const LoopLimit<double>& limit, const Points<double>& d, const Points<double>& wanted,
                   const std::vector<char>* active) {
  const Points<double> reached = limit.points(d);
  double worst = 0, scale = 0;
  for (int v = 0; v < limit.mesh().vertices(); ++v) {
    if (!is_active(active, v)) continue;
    worst = std::max(worst, (reached.row(v) - wanted.row(v)).cwiseAbs().maxCoeff());
    scale = std::max(scale, wanted.row(v).cwiseAbs().maxCoeff());
  }
  return scale > 0 ? worst / scale : 0;
}

}  // namespace

std::string_view name_of(OffsetSolver solver) {
  static constexpr std::array<std::string_view, 8> names{
      "automatic", "direct", "edge", "star", "gauss-seidel", "richardson", "conjugate-gradients", "jacobi"};
  return names[static_cast<std::size_t>(solver)];
}

OffsetSystem offset_system(const LoopLimit<double>& limit, const std::vector<char>* active) {
  OffsetSystem system;
  const int vertices = limit.mesh().vertices();
  system.unknown.assign(at(vertices), -1);
  for (int v = 0; v < vertices; ++v) {
    if (!limit.is_interior(v) || !is_active(active, v)) continue;
    system.unknown[at(v)] = system.size();
    system.vertex.push_back(v);
    system.weight.push_back(limit.weight(v));
    system.valence.push_back(limit.mesh().valence(v));
  }
  system.begin.push_back(0);
  for (const int v : system.vertex) {
    for (const int u : limit.rings().of(v))
      if (system.unknown[at(u)] >= 0) system.neighbour.push_back(system.unknown[at(u)]);
    system.begin.push_back(static_cast<int>(system.neighbour.size()));
  }
  return system;
}

OffsetSolution solve_offset(const LoopLimit<double>& limit, const Points<double>& wanted, const SolveOptions& options,
                            const std::vector<char>* active) {
  throw_if_stopped(options.stop);
  OffsetSolution solution;
  solution.d = solve_boundary(limit, wanted, active);
  const OffsetSystem system = offset_system(limit, active);
  solution.solver = options.solver != OffsetSolver::automatic ? options.solver
                    : system.size() <= largest_direct         ? OffsetSolver::direct
                                                              : OffsetSolver::conjugate_gradients;
  if (system.size() > 0) {
    const Points<double> b = right_side(limit, system, wanted, solution.d);
    Points<double> x(system.size(), wanted.cols());
    if (solution.solver == OffsetSolver::direct) {
      x = solve_directly(system, b);
    } else {
      for (int i = 0; i < system.size(); ++i) x.row(i) = wanted.row(system.vertex[at(i)]);
      Iterations made = iterate(system, b, std::move(x), wanted.size() > 0 ? wanted.cwiseAbs().maxCoeff() : 0, options);
      x = std::move(made.x);
      solution.iterations = made.count;
      solution.contraction = made.contraction;
    }
    for (int i = 0; i < system.size(); ++i) solution.d.row(system.vertex[at(i)]) = x.row(i);
  }
  solution.residual = residual_of(limit, solution.d, wanted, active);
  return solution;
}

}  // namespace udcp
