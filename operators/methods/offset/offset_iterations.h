// Iterative solvers of K x = b, K = W + A: each is a way from one iterate to the next; when to stop is common to all.
#pragma once

#include "operators/methods/offset/offset_system.h"

namespace udcp {

struct Iterations {
  Points<double> x;
  int count = 0;
  double contraction = 0;
};

/// From x until the largest entry of |D^-1 (K x - b)|, D = diag(w + N), is at most tolerance * scale. Throws what solve_offset
/// throws. options.solver is one of the iterative ones.
Iterations iterate(const OffsetSystem& system, const Points<double>& b, Points<double> x, double scale,
                   const SolveOptions& options);

}  // namespace udcp
