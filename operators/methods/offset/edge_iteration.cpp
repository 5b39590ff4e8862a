// The paper's edge iteration and the star variant: rows of inverses of small local matrices, precomputed per vertex.
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "operators/interrupt.h"
#include "operators/methods/offset/offset_system.h"
#include "operators/methods/sparse_solvers.h"

namespace udcp {
namespace {

std::size_t at(int k) { return static_cast<std::size_t>(k); }

/// The first column of the inverse of a small symmetric positive definite matrix (row by row), by Cholesky.
std::vector<double> first_of_inverse(std::vector<double> a, std::size_t n) {
  std::vector<double> y(n, 0.0);
  y[0] = 1;
  for (std::size_t k = 0; k < n; ++k) {
    for (std::size_t i = k + 1; i < n; ++i) {
      const double factor = a[i * n + k] / a[k * n + k];
      if (factor == 0) continue;
      for (std::size_t j = k; j < n; ++j) a[i * n + j] -= factor * a[k * n + j];
      y[i] -= factor * y[k];
    }
  }
  for (std::size_t k = n; k-- > 0;) {
    for (std::size_t j = k + 1; j < n; ++j) y[k] -= a[k * n + j] * y[j];
    y[k] /= a[k * n + k];
  }
  return y;
}

class Builder {
 public:
  Builder(const OffsetSystem& system, bool star)
      : system_(system), star_(star), place_(at(system.size()), -1), sum_(at(system.size()), 0.0) {}

  EdgeIteration build(const std::atomic<bool>* stop) {
    result_.begin_old.push_back(0);
    result_.begin_right.push_back(0);
    for (int i = 0; i < system_.size(); ++i) {
      if (i % 64 == 0) throw_if_stopped(stop);
      const std::vector<int> set = local_set(i);
      add_rule(set, inverse_row(set));
    }
    return std::move(result_);
  }

 private:
  [[nodiscard]] bool is_regular(int i) const { return system_.valence[at(i)] == 6; }

  [[nodiscard]] std::vector<int> local_set(int i) {
    const std::span<const int> around = system_.around(i);
    std::vector<int> set{i};
    if (star_ || system_.valence[at(i)] <= 4) {
      set.insert(set.end(), around.begin(), around.end());
      return set;
    }
    int partner = -1;
    for (const int j : around)
      if (is_regular(j) && (partner < 0 || system_.vertex[at(j)] < system_.vertex[at(partner)])) partner = j;
    if (partner < 0) partner = best_partner(i);
    if (partner >= 0) set.push_back(partner);
    return set;
  }

  [[nodiscard]] int best_partner(int i) {
    int best = -1;
    double least = std::numeric_limits<double>::infinity();
    std::vector<int> candidates(system_.around(i).begin(), system_.around(i).end());
    std::sort(candidates.begin(), candidates.end(), [&](int j, int k) { return system_.vertex[at(j)] < system_.vertex[at(k)]; });
    for (const int j : candidates) {
      const std::vector<int> set{i, j};
      const double lambda = contraction(set, inverse_row(set));
      if (!(lambda < least - 1e-14)) continue;
      least = lambda;
      best = j;
    }
    return best;
  }

  [[nodiscard]] std::vector<double> inverse_row(const std::vector<int>& set) {
    const std::size_t n = set.size();
    for (std::size_t k = 0; k < n; ++k) place_[at(set[k])] = static_cast<int>(k);
    std::vector<double> row = n <= 32 ? dense_row(set) : sparse_row(set);
    for (const int i : set) place_[at(i)] = -1;
    return row;
  }

  [[nodiscard]] std::vector<double> dense_row(const std::vector<int>& set) const {
    const std::size_t n = set.size();
    std::vector<double> matrix(n * n, 0.0);
    for (std::size_t k = 0; k < n; ++k) {
      matrix[k * n + k] = system_.weight[at(set[k])];
      for (const int j : system_.around(set[k]))
        if (place_[at(j)] >= 0) matrix[k * n + at(place_[at(j)])] += 1;
    }
    return first_of_inverse(std::move(matrix), n);
  }

  [[nodiscard]] std::vector<double> sparse_row(const std::vector<int>& set) const {
    std::vector<Entry> lower;
    for (std::size_t k = 0; k < set.size(); ++k) {
      const int row = static_cast<int>(k);
      lower.push_back({row, row, system_.weight[at(set[k])]});
      for (const int j : system_.around(set[k]))
        if (place_[at(j)] >= 0 && place_[at(j)] < row) lower.push_back({row, place_[at(j)], 1.0});
    }
    Points<double> unit = Points<double>::Zero(static_cast<Eigen::Index>(set.size()), 1);
    unit(0, 0) = 1;
    const Points<double> y = solve_positive_definite(static_cast<int>(set.size()), lower, unit);
    return {y.data(), y.data() + y.rows()};
  }

  /// Gathers the coefficients of old values outside the set into sum_, and lists their unknowns.
  std::vector<int> gather(const std::vector<int>& set, const std::vector<double>& row) {
    for (const int i : set) place_[at(i)] = 0;
    std::vector<int> outside;
    for (std::size_t k = 0; k < set.size(); ++k) {
      for (const int j : system_.around(set[k])) {
        if (place_[at(j)] >= 0) continue;
        if (sum_[at(j)] == 0) outside.push_back(j);
        sum_[at(j)] -= row[k];
      }
    }
    for (const int i : set) place_[at(i)] = -1;
    std::ranges::sort(outside);
    outside.erase(std::unique(outside.begin(), outside.end()), outside.end());
    return outside;
  }

  double contraction(const std::vector<int>& set, const std::vector<double>& row) {
    double sum = 0;
    for (const int j : gather(set, row)) sum += std::abs(std::exchange(sum_[at(j)], 0.0));
    return sum;
  }

  void add_rule(const std::vector<int>& set, const std::vector<double>& row) {
    double lambda = 0;
    for (const int j : gather(set, row)) {
      const double value = std::exchange(sum_[at(j)], 0.0);
      result_.old_index.push_back(j);
      result_.old_value.push_back(value);
      lambda += std::abs(value);
    }
    for (std::size_t k = 0; k < set.size(); ++k) {
      result_.right_index.push_back(set[k]);
      result_.right_value.push_back(row[k]);
    }
    result_.begin_old.push_back(static_cast<int>(result_.old_index.size()));
    result_.begin_right.push_back(static_cast<int>(result_.right_index.size()));
    result_.lambda.push_back(lambda);
  }

  const OffsetSystem& system_;
  bool star_;
  std::vector<int> place_;   // of an unknown in the local set, -1 elsewhere
  std::vector<double> sum_;  // zero between uses
  EdgeIteration result_;
};

}  // namespace

EdgeIteration edge_iteration(const OffsetSystem& system, bool star, const std::atomic<bool>* stop) {
  return Builder(system, star).build(stop);
}

double pair_contraction(int valence_i, int valence_j) {
  const double w = loop_weight<double>(valence_i), other = loop_weight<double>(valence_j);
  return (other * (valence_i - 3) + (valence_j - 3) + 2 * (other - 1)) / (w * other - 1);
}

double star_contraction(int valence) { return 3 * valence / (8 * loop_weight<double>(valence) - valence); }

double least_eigenvalue_bound(const OffsetSystem& system) {
  double least = 1;
  for (int i = 0; i < system.size(); ++i) {
    const double w = system.weight[at(i)], n = system.valence[at(i)];
    least = std::min(least, (w - n / 2) / (w + n));
  }
  return least;
}

}  // namespace udcp
