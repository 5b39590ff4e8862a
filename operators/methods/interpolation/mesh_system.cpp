// Cholesky, conjugate gradients and exact elimination for one shape of matrix.
#include "operators/methods/interpolation/mesh_system.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "operators/interrupt.h"
#include "operators/methods/sparse_solvers.h"

namespace udcp {
namespace {

std::size_t at(int k) { return static_cast<std::size_t>(k); }

constexpr int preferred_cholesky = 20'000;  // beyond, conjugate gradients are faster unless the system is nearly singular
constexpr int largest_cholesky = 300'000;
constexpr int quick_iterations = 1'000, most_iterations = 100'000;
constexpr std::int64_t most_entries = 20'000'000;

// Calls visit(i, j, weight) for every contribution with i >= j.
template <class S, class Visit>
void for_each_entry(const MeshSystem<S>& system, Visit visit) {
  for (int i = 0; i < system.size(); ++i) visit(i, i, system.diagonal[at(i)]);
  for (const auto& [a, b] : system.edges) visit(std::max(a, b), std::min(a, b), S(1));
  for (int f = 0; f < system.faces(); ++f) {
    for (int p = system.face_begin[at(f)]; p < system.face_begin[at(f + 1)]; ++p)
      for (int q = system.face_begin[at(f)]; q <= p; ++q)
        visit(std::max(system.member[at(p)], system.member[at(q)]), std::min(system.member[at(p)], system.member[at(q)]),
              system.face_weight[at(f)]);
  }
}

std::int64_t entries_of(const std::vector<int>& face_begin) {
  std::int64_t result = 0;
  for (std::size_t f = 1; f < face_begin.size(); ++f) {
    const std::int64_t m = face_begin[f] - face_begin[f - 1];
    result += m * (m + 1) / 2;
  }
  return result;
}

Points<double> solve_by_cholesky(const MeshSystem<double>& system, const Points<double>& right) {
  std::vector<Entry> entries;
  for_each_entry(system, [&](int i, int j, double weight) { entries.push_back({i, j, weight}); });
  return solve_positive_definite(system.size(), entries, right);
}

// Preconditioned by the diagonal; all columns at once, so that one pass over the mesh serves them. Nothing if they do not settle.
std::optional<Points<double>> solve_by_gradients(const MeshSystem<double>& system, const Points<double>& right, int iterations,
                                                 const RunControl& control) {
  Eigen::VectorXd inverse = Eigen::VectorXd::Map(system.diagonal.data(), system.size());
  for (int f = 0; f < system.faces(); ++f)
    for (int p = system.face_begin[at(f)]; p < system.face_begin[at(f + 1)]; ++p)
      inverse[system.member[at(p)]] += system.face_weight[at(f)];
  inverse = inverse.cwiseInverse().eval();
  Points<double> x = inverse.asDiagonal() * right, r = right - apply(system, x), z = inverse.asDiagonal() * r, d = z;
  const double target = 1e-15 * right.norm();
  double rz = r.cwiseProduct(z).sum(), best = r.norm();
  for (int k = 0, since_best = 0; r.norm() > target && since_best < 50; ++k) {
    throw_if_stopped(control.stop);
    if (k >= iterations) return std::nullopt;
    const Points<double> product = apply(system, d);
    const double step = rz / d.cwiseProduct(product).sum();
    x += step * d;
    r -= step * product;
    z = inverse.asDiagonal() * r;
    const double next = r.cwiseProduct(z).sum();
    d = z + next / rz * d;
    rz = next;
    since_best = r.norm() < best ? 0 : since_best + 1;
    best = std::min(best, r.norm());
  }
  if ((right - apply(system, x)).norm() > 1e-13 * right.norm()) return std::nullopt;  // stuck before the end
  return x;
}

// Elimination in the order of fewest neighbours. Without pivoting, as the matrix is positive definite.
template <class S>
class Elimination {
 public:
  Elimination(const MeshSystem<S>& system, Points<S> right) : rows_(at(system.size())), right_(std::move(right)) {
    for_each_entry(system, [&](int i, int j, const S& weight) {
      rows_[at(i)].try_emplace(j, S(0)).first->second += weight;
      if (i != j) rows_[at(j)].try_emplace(i, S(0)).first->second += weight;
    });
  }

  Points<S> solve(const RunControl& control) {
    std::vector<char> done(rows_.size(), 0);
    for (std::size_t k = 0; k < rows_.size(); ++k) {
      throw_if_stopped(control.stop);
      const int p = fewest_neighbours(done);
      done[at(p)] = 1;
      order_.push_back(p);
      eliminate(p);
    }
    for (auto p = order_.rbegin(); p != order_.rend(); ++p) substitute(*p);
    return std::move(right_);
  }

 private:
  [[nodiscard]] int fewest_neighbours(const std::vector<char>& done) const {
    int best = -1;
    for (std::size_t i = 0; i < rows_.size(); ++i)
      if (done[i] == 0 && (best < 0 || rows_[i].size() < rows_[at(best)].size())) best = static_cast<int>(i);
    return best;
  }

  void eliminate(int p) {
    std::map<int, S>& pivot = rows_[at(p)];
    const S diagonal = pivot.at(p);
    if (!is_nonzero(diagonal))
      throw Error(ErrorKind::limit, "E_SINGULAR", "a pivot of the linear system cannot be told from 0", "");
    for (auto& [j, value] : pivot) value = value / diagonal;
    for (Eigen::Index c = 0; c < right_.cols(); ++c) right_(p, c) = right_(p, c) / diagonal;
    pivot.erase(p);
    for (const auto& [i, ratio] : pivot) {
      std::map<int, S>& row = rows_[at(i)];
      const S factor = row.at(p);
      row.erase(p);
      for (const auto& [j, value] : pivot) row.try_emplace(j, S(0)).first->second -= factor * value;
      add(right_, i, S(-factor), Points<S>(right_.row(p)), 0);
    }
  }

  void substitute(int p) {
    for (const auto& [j, value] : rows_[at(p)]) add(right_, p, S(-value), Points<S>(right_.row(j)), 0);
  }

  std::vector<std::map<int, S>> rows_;
  Points<S> right_;
  std::vector<int> order_;
};

}  // namespace

template <class S>
Points<S> apply(const MeshSystem<S>& system, const Points<S>& x) {
  Points<S> result = Points<S>::Zero(x.rows(), x.cols());
  for (int i = 0; i < system.size(); ++i) add(result, i, system.diagonal[at(i)], x, i);
  for (const auto& [a, b] : system.edges) {
    add(result, a, S(1), x, b);
    add(result, b, S(1), x, a);
  }
  Points<S> sum(1, x.cols());
  for (int f = 0; f < system.faces(); ++f) {
    sum.setZero();
    for (int p = system.face_begin[at(f)]; p < system.face_begin[at(f + 1)]; ++p) add(sum, 0, S(1), x, system.member[at(p)]);
    for (int p = system.face_begin[at(f)]; p < system.face_begin[at(f + 1)]; ++p)
      add(result, system.member[at(p)], system.face_weight[at(f)], sum, 0);
  }
  return result;
}

namespace {

template <class S>
Points<S> solve_in(const MeshSystem<S>& system, const Points<S>& right, const RunControl& control) {
  if (system.size() > largest_exact_system || entries_of(system.face_begin) > most_entries)
    throw Error(ErrorKind::limit, "E_TOO_LARGE",
                "an exact solution for " + std::to_string(system.size()) + " vertices would take too long; the limit is " +
                    std::to_string(largest_exact_system),
                "use floating point, or step1 = local, which needs no linear system");
  return Elimination<S>(system, right).solve(control);
}

Points<double> solve_in(const MeshSystem<double>& system, const Points<double>& right, const RunControl& control) {
  const bool can_factor = system.size() <= largest_cholesky && entries_of(system.face_begin) <= most_entries;
  if (!can_factor || system.size() > preferred_cholesky) {
    const int iterations = can_factor ? quick_iterations : most_iterations;
    if (std::optional<Points<double>> x = solve_by_gradients(system, right, iterations, control)) return *std::move(x);
    if (!can_factor)
      throw Error(ErrorKind::limit, "E_SINGULAR",
                  "the linear system is nearly singular: its solution does not settle within " + std::to_string(most_iterations) +
                      " iterations",
                  "take lambda further away from 7/20");
  }
  return solve_by_cholesky(system, right);
}

}  // namespace

template <class S>
Points<S> solve(const MeshSystem<S>& system, const Points<S>& right, const RunControl& control) {
  if (system.size() == 0) return right;
  throw_if_stopped(control.stop);
  Points<S> x = solve_in(system, right, control);
  throw_if_stopped(control.stop);
  return x;
}

#define UDCP_INSTANTIATE(S)                                         \
  template Points<S> apply(const MeshSystem<S>&, const Points<S>&); \
  template Points<S> solve(const MeshSystem<S>&, const Points<S>&, const RunControl&);
UDCP_FOR_EACH_COORDINATE(UDCP_INSTANTIATE)
#undef UDCP_INSTANTIATE

}  // namespace udcp
