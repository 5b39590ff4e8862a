// One class per family of iterations; columns are solved in step.
#include "operators/methods/offset/offset_iterations.h"
#include "operators/interrupt.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace udcp {
namespace {

std::size_t at(int k) { return static_cast<std::size_t>(k); }

using Vectors = Points<double>;
using Row = Eigen::RowVectorXd;

/// K x.
Vectors times(const OffsetSystem& system, const Vectors& x) {
  Vectors result(x.rows(), x.cols());
  for (int i = 0; i < system.size(); ++i) {
    result.row(i) = system.weight[at(i)] * x.row(i);
    for (const int j : system.around(i)) add(result, i, 1.0, x, j);
  }
  return result;
}

double diagonal(const OffsetSystem& system, int i) { return system.weight[at(i)] + system.valence[at(i)]; }

/// A way from one iterate to the next; `rest` is b - K x of the iterate.
using Step = std::function<void(Vectors& x, const Vectors& rest)>;

class GaussSeidel {
 public:
  GaussSeidel(const OffsetSystem& system, const Vectors& b) : system_(system), b_(b) {}
  void operator()(Vectors& x, const Vectors&) const {
    for (int i = 0; i < system_.size(); ++i) {
      x.row(i) = b_.row(i);
      for (const int j : system_.around(i)) add(x, i, -1.0, x, j);
      x.row(i) /= system_.weight[at(i)];
    }
  }

 private:
  const OffsetSystem& system_;
  const Vectors& b_;
};

/// x += t / scale_i times the residual: Jacobi (scale w, t = 1) and Richardson (scale w + N).
class Diagonal {
 public:
  Diagonal(const OffsetSystem& system, double t, bool weights_only) : factor_(at(system.size())) {
    for (int i = 0; i < system.size(); ++i) factor_[at(i)] = t / (weights_only ? system.weight[at(i)] : diagonal(system, i));
  }
  void operator()(Vectors& x, const Vectors& rest) {
    for (Eigen::Index i = 0; i < x.rows(); ++i) x.row(i) += factor_[static_cast<std::size_t>(i)] * rest.row(i);
  }

 private:
  std::vector<double> factor_;
};

class ConjugateGradients {
 public:
  explicit ConjugateGradients(const OffsetSystem& system) : system_(system) {}
  void operator()(Vectors& x, const Vectors& rest) {
    Vectors z = rest;
    for (int i = 0; i < system_.size(); ++i) z.row(i) /= diagonal(system_, i);
    const Row product = rest.cwiseProduct(z).colwise().sum();
    if (direction_.size() == 0) {
      direction_ = z;
    } else {
      for (Eigen::Index c = 0; c < x.cols(); ++c)
        direction_.col(c) = z.col(c) + (before_[c] > 0 ? product[c] / before_[c] : 0.0) * direction_.col(c);
    }
    const Vectors image = times(system_, direction_);
    for (Eigen::Index c = 0; c < x.cols(); ++c) {
      const double energy = direction_.col(c).dot(image.col(c));
      if (energy > 0) x.col(c) += product[c] / energy * direction_.col(c);
    }
    before_ = product;
  }

 private:
  const OffsetSystem& system_;
  Vectors direction_;
  Row before_;
};

class LocalSets {
 public:
  LocalSets(const OffsetSystem& system, const Vectors& b, bool star, const std::atomic<bool>* stop)
      : rules_(edge_iteration(system, star, stop)), constant_(Vectors::Zero(b.rows(), b.cols())) {
    for (int i = 0; i < system.size(); ++i) {
      if (rules_.lambda[at(i)] > contraction_) contraction_ = rules_.lambda[at(i)];
      if (rules_.lambda[at(i)] >= 1 - 1e-13) refuse(system, i);
      for (int k = rules_.begin_right[at(i)]; k < rules_.begin_right[at(i) + 1]; ++k)
        add(constant_, i, rules_.right_value[at(k)], b, rules_.right_index[at(k)]);
    }
  }
  void operator()(Vectors& x, const Vectors&) const {
    Vectors next = constant_;
    for (Eigen::Index i = 0; i < x.rows(); ++i) {
      const int row = static_cast<int>(i);
      for (int k = rules_.begin_old[at(row)]; k < rules_.begin_old[at(row) + 1]; ++k)
        add(next, row, rules_.old_value[at(k)], x, rules_.old_index[at(k)]);
    }
    x = std::move(next);
  }
  [[nodiscard]] double contraction() const { return contraction_; }

 private:
  [[noreturn]] void refuse(const OffsetSystem& system, int i) const {
    throw Error(ErrorKind::input, "E_NOT_CONTRACTIVE",
                "the iteration is not known to converge: at vertex " + std::to_string(system.vertex[at(i)]) + " of valence " +
                    std::to_string(system.valence[at(i)]) + " its contraction bound is " + to_text(rules_.lambda[at(i)]),
                "refine the mesh once, after which the bound is below 1, or use another solver");
  }

  EdgeIteration rules_;
  Vectors constant_;
  double contraction_ = 0;
};

Step make_step(const OffsetSystem& system, const Vectors& b, const SolveOptions& options, double& contraction) {
  switch (options.solver) {
    case OffsetSolver::edge:
    case OffsetSolver::star: {
      LocalSets sets(system, b, options.solver == OffsetSolver::star, options.stop);
      contraction = sets.contraction();
      return sets;
    }
    case OffsetSolver::gauss_seidel:
      return GaussSeidel(system, b);
    case OffsetSolver::richardson:
      return Diagonal(system, 2 / (1 + least_eigenvalue_bound(system)), false);
    case OffsetSolver::jacobi:
      return Diagonal(system, 1, true);
    default:
      return ConjugateGradients(system);
  }
}

double size_of(const OffsetSystem& system, const Vectors& rest) {
  double worst = 0;
  for (int i = 0; i < system.size(); ++i) worst = std::max(worst, rest.row(i).cwiseAbs().maxCoeff() / diagonal(system, i));
  return worst;
}

[[noreturn]] void give_up(const SolveOptions& options, int count, double reached, const char* how) {
  throw Error(ErrorKind::limit, "E_NO_CONVERGENCE",
              "the solver " + std::string(name_of(options.solver)) + " " + how + " after " + std::to_string(count) +
                  " iterations with a residual of " + to_text(reached) + ", not " + to_text(options.tolerance),
              "use the solver direct, or a larger tolerance");
}

}  // namespace

Iterations iterate(const OffsetSystem& system, const Vectors& b, Vectors x, double scale, const SolveOptions& options) {
  Iterations result;
  Step step = make_step(system, b, options, result.contraction);
  double best = std::numeric_limits<double>::infinity(), start = 0;
  int best_at = 0;
  for (;; ++result.count) {
    throw_if_stopped(options.stop);
    const Vectors rest = b - times(system, x);
    const double residual = scale > 0 ? size_of(system, rest) / scale : 0;
    if (residual <= options.tolerance) break;
    if (result.count == 0) start = residual;
    if (residual < 0.999 * best) best = residual, best_at = result.count;
    // Divergence guard: growth, or 100 iterations without progress (rounding, or an eigenvalue of modulus 1).
    if (!(residual < 1e3 * std::max(start, options.tolerance)) || result.count - best_at > 100)
      give_up(options, result.count, residual, "diverged");
    if (result.count >= options.max_iterations) give_up(options, result.count, residual, "stopped");
    if (options.progress && start > options.tolerance)
      options.progress(std::clamp(std::log(residual / start) / std::log(options.tolerance / start), 0.0, 1.0));
    step(x, rest);
  }
  result.x = std::move(x);
  return result;
}

}  // namespace udcp
