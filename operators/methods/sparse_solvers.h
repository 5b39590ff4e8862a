// Sparse solvers in double; the only file behind this header is the only one that knows Eigen's sparse matrices.
#pragma once

#include <vector>

#include "operators/number.h"

namespace udcp {

struct Entry {
  int row = 0, column = 0;
  double value = 0;
};

/// Solves a x = right for a positive definite matrix of `size` rows, of which `entries` hold the diagonal and what lies below it
/// (equal places are added). Sparse Cholesky. Error{limit, "E_SINGULAR"} if the matrix is not positive definite.
Points<double> solve_positive_definite(int size, const std::vector<Entry>& entries, const Points<double>& right);

/// The shortest x with a x = right, a consistent system of any rank: sparse QR of the transpose.
struct LeastNorm {
  Eigen::VectorXd x;
  int rank = 0;
};
LeastNorm least_norm_solution(int rows, int columns, const std::vector<Entry>& entries, const Eigen::VectorXd& right);

}  // namespace udcp
