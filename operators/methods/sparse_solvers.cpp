// Eigen's sparse decompositions behind two functions.
#include "operators/methods/sparse_solvers.h"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseQR>

namespace udcp {
namespace {

using Sparse = Eigen::SparseMatrix<double, Eigen::ColMajor, int>;

Sparse sparse(int rows, int columns, const std::vector<Entry>& entries, bool transposed) {
  std::vector<Eigen::Triplet<double, int>> triplets;
  triplets.reserve(entries.size());
  for (const Entry& e : entries) triplets.emplace_back(transposed ? e.column : e.row, transposed ? e.row : e.column, e.value);
  Sparse result(transposed ? columns : rows, transposed ? rows : columns);
  result.setFromTriplets(triplets.begin(), triplets.end());
  result.makeCompressed();
  return result;
}

}  // namespace

Points<double> solve_positive_definite(int size, const std::vector<Entry>& entries, const Points<double>& right) {
  const Sparse matrix = sparse(size, size, entries, false);
  const Eigen::SimplicialLLT<Sparse, Eigen::Lower> cholesky(matrix);
  if (cholesky.info() != Eigen::Success)
    throw Error(ErrorKind::limit, "E_SINGULAR", "the linear system is not positive definite in double precision", "");
  Points<double> result(right.rows(), right.cols());
  for (Eigen::Index c = 0; c < right.cols(); ++c) {
    const Eigen::VectorXd column = right.col(c);
    Eigen::VectorXd x = cholesky.solve(column);
    const Eigen::VectorXd rest = column - matrix.selfadjointView<Eigen::Lower>() * x;
    x += cholesky.solve(rest);  // one step of refinement
    result.col(c) = x;
  }
  return result;
}

// With a^T P = Q R of rank k the first k columns of a^T P span the row space: x = Q y where R11^T y is the right side of those
// rows.
LeastNorm least_norm_solution(int rows, int columns, const std::vector<Entry>& entries, const Eigen::VectorXd& right) {
  Eigen::SparseQR<Sparse, Eigen::COLAMDOrdering<int>> qr;
  qr.compute(sparse(rows, columns, entries, true));
  if (qr.info() != Eigen::Success) throw Error(ErrorKind::limit, "E_SINGULAR", "the linear system could not be solved", "");
  const Eigen::Index k = qr.rank();
  const Eigen::VectorXd permuted = qr.colsPermutation().transpose() * right;
  const Eigen::SparseMatrix<double, Eigen::RowMajor, int> sorted(qr.matrixR());  // its columns are not in order
  const Sparse triangle = sorted.topLeftCorner(k, k);
  Eigen::VectorXd y = Eigen::VectorXd::Zero(columns);
  y.head(k) = triangle.triangularView<Eigen::Upper>().transpose().solve(permuted.head(k));
  return {qr.matrixQ() * y, static_cast<int>(k)};
}

}  // namespace udcp
