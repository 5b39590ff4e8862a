// Eigenvalues from Eigen, clustered; eigenvectors as kernels, which stay accurate where eigenvalues coincide or are defective.
#include "operators/modes.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <complex>

namespace udcp {
namespace {

constexpr double cluster_width = 1e-5;  // a triple defective eigenvalue spreads by the cube root of the rounding
constexpr double rank_threshold = 1e-9;

Eigen::MatrixXd shifted(const Eigen::MatrixXd& a, double eigenvalue) {
  return a - eigenvalue * Eigen::MatrixXd::Identity(a.rows(), a.cols());
}

Eigen::MatrixXd kernel(const Eigen::MatrixXd& a) {
  Eigen::FullPivLU<Eigen::MatrixXd> lu(a);
  lu.setThreshold(rank_threshold);
  if (lu.dimensionOfKernel() == 0) return Eigen::MatrixXd(a.cols(), 0);
  return lu.kernel();
}

bool same(const ModeGroup& a, const ModeGroup& b) { return std::abs(a.eigenvalue - b.eigenvalue) <= cluster_width * a.modulus; }

// Vectors that the left eigenvectors see, in the generalised eigenspace: column i pairs to 1 with row i and to 0 with the others.
Eigen::MatrixXd dual_vectors(const Eigen::MatrixXd& a, const Eigen::MatrixXd& left, const ModeGroup& group) {
  const Eigen::MatrixXd shift = shifted(a, group.eigenvalue);
  Eigen::MatrixXd power = shift;
  for (int k = 1; k < group.algebraic; ++k) power = power * shift;
  const Eigen::MatrixXd space = kernel(power);
  const Eigen::MatrixXd pairing = left * space;
  return space * pairing.transpose() * (pairing * pairing.transpose()).inverse();
}

// The end of the Jordan chain of x: where powers of the matrix carry it.
Eigen::VectorXd end_of_chain(const Eigen::MatrixXd& a, Eigen::VectorXd x, const ModeGroup& group) {
  const Eigen::MatrixXd shift = shifted(a, group.eigenvalue);
  for (int k = 1; k < group.algebraic; ++k) {
    const Eigen::VectorXd next = shift * x;
    if (next.norm() <= 1e-7 * x.norm()) break;
    x = next;
  }
  return x;
}

}  // namespace

std::vector<ModeGroup> mode_groups(const Eigen::MatrixXd& a) {
  const Eigen::EigenSolver<Eigen::MatrixXd> solver(a, false);
  std::vector<std::complex<double>> values(solver.eigenvalues().begin(), solver.eigenvalues().end());
  std::stable_sort(values.begin(), values.end(), [](const auto& x, const auto& y) { return std::abs(x) > std::abs(y); });
  std::vector<ModeGroup> groups;
  for (std::size_t begin = 0; begin < values.size() && std::abs(values[begin]) > 1e-7;) {
    ModeGroup group;
    std::size_t end = begin;
    while (end < values.size() && std::abs(values[begin]) - std::abs(values[end]) <= cluster_width * std::abs(values[begin]))
      ++end;
    std::complex<double> mean = 0;
    for (std::size_t k = begin; k < end; ++k) mean += values[k];
    mean /= static_cast<double>(end - begin);
    group.modulus = std::abs(values[begin]);
    group.eigenvalue = mean.real();
    group.algebraic = static_cast<int>(end - begin);
    for (std::size_t k = begin; k < end; ++k)
      group.is_one_real &= std::abs(values[k] - mean.real()) <= cluster_width * group.modulus;
    groups.push_back(group);
    begin = end;
  }
  return groups;
}

Eigen::MatrixXd left_eigenvectors(const Eigen::MatrixXd& a, const ModeGroup& group) {
  if (!group.is_one_real) return Eigen::MatrixXd(a.rows(), 0);
  return kernel(shifted(a, group.eigenvalue).transpose());
}

Eigen::MatrixXd right_answers(const Eigen::MatrixXd& a, const Eigen::MatrixXd& left, const ModeGroup& first,
                              const ModeGroup& second) {
  Eigen::MatrixXd result(a.rows(), 2);
  if (same(first, second)) {
    const Eigen::MatrixXd dual = dual_vectors(a, left, first);
    for (int k = 0; k < 2; ++k) result.col(k) = end_of_chain(a, dual.col(k), first);
    return result;
  }
  result.col(0) = end_of_chain(a, dual_vectors(a, left.topRows(1), first), first);
  result.col(1) = end_of_chain(a, dual_vectors(a, left.bottomRows(1), second), second);
  return result;
}

}  // namespace udcp
