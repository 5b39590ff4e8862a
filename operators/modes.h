// The dominant modes of a subdivision matrix in double: which directions survive repeated refinement. Numerical, for evaluation;
// nothing is proved from them.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace udcp {

/// Eigenvalues of (nearly) the same modulus, by falling modulus; number 0 is the eigenvalue 1.
struct ModeGroup {
  double modulus = 0;
  double eigenvalue = 0;    // their mean, accurate also where the eigenvalue is defective
  int algebraic = 0;        // how many
  bool is_one_real = true;  // all of them are one real eigenvalue; only then are there vectors
};

/// Groups of the square matrix `a`, down to modulus 1e-7.
std::vector<ModeGroup> mode_groups(const Eigen::MatrixXd& a);

/// Columns: left eigenvectors of the group, as many as its geometric multiplicity.
Eigen::MatrixXd left_eigenvectors(const Eigen::MatrixXd& a, const ModeGroup& group);

/// For two left eigenvectors (rows) of `a`, of the groups `first` and `second`: the two columns of vectors along which a^n grows
/// in answer to them, so that a^n x is about c1(n) (left0 x) column0 + c2(n) (left1 x) column1, c1, c2 > 0. Also for defective
/// groups.
Eigen::MatrixXd right_answers(const Eigen::MatrixXd& a, const Eigen::MatrixXd& left, const ModeGroup& first,
                              const ModeGroup& second);

}  // namespace udcp
