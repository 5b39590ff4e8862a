// Exact elimination, characteristic polynomials (Berkowitz, block by block) and Jordan structure by ranks.
#include "proofs/linear_algebra.h"

#include <algorithm>

namespace udcp {
namespace {

using Index = Eigen::Index;

void require_square(Index rows, Index columns) {
  if (rows != columns)
    throw Error(ErrorKind::internal, "E_INTERNAL",
                "a square matrix is needed here, not " + std::to_string(rows) + " x " + std::to_string(columns));
}

/// Row `to` -= factor times row `from`, from the column `first` on.
template <class S>
void eliminate(Points<S>& a, Index to, Index from, Index first) {
  const S factor = a(to, first);
  if (factor.is_zero()) return;
  for (Index j = first; j < a.cols(); ++j)
    if (!a(from, j).is_zero()) a(to, j) -= factor * a(from, j);
}

/// Reduced row echelon form in the first `columns` columns; the pivot column of each of the first rows.
template <class S>
std::vector<Index> reduce(Points<S>& a, Index columns) {
  std::vector<Index> pivots;
  for (Index column = 0; column < columns; ++column) {
    const auto row = static_cast<Index>(pivots.size());
    Index found = row;
    while (found < a.rows() && a(found, column).is_zero()) ++found;
    if (found == a.rows()) continue;
    if (found != row) a.row(row).swap(a.row(found));
    const S inverse = S(1) / a(row, column);
    for (Index j = column; j < a.cols(); ++j) a(row, j) *= inverse;
    for (Index i = 0; i < a.rows(); ++i)
      if (i != row) eliminate(a, i, row, column);
    pivots.push_back(column);
  }
  return pivots;
}

/// Groups of indices that reach each other along nonzero entries: the diagonal blocks of a block triangular form.
template <class S>
std::vector<std::vector<Index>> irreducible_blocks(const Points<S>& a) {
  const Index n = a.rows();
  Eigen::Matrix<char, Eigen::Dynamic, Eigen::Dynamic> reaches(n, n);
  for (Index i = 0; i < n; ++i)
    for (Index j = 0; j < n; ++j) reaches(i, j) = i == j || !a(i, j).is_zero();
  for (Index k = 0; k < n; ++k)
    for (Index i = 0; i < n; ++i)
      for (Index j = 0; reaches(i, k) != 0 && j < n; ++j) reaches(i, j) = reaches(i, j) != 0 || reaches(k, j) != 0;
  std::vector<std::vector<Index>> blocks;
  for (Index i = 0; i < n; ++i) {
    const auto home = std::find_if(blocks.begin(), blocks.end(), [&](const std::vector<Index>& block) {
      return reaches(i, block.front()) != 0 && reaches(block.front(), i) != 0;
    });
    if (home == blocks.end())
      blocks.push_back({i});
    else
      home->push_back(i);
  }
  return blocks;
}

/// det(x - a) by Berkowitz' algorithm: no division, so no growth beyond the entries' own.
template <class S>
Polynomial<S> berkowitz(const Points<S>& a) {
  const Index n = a.rows();
  std::vector<S> p{S(1)};  // highest first, of the leading k x k block
  for (Index k = 0; k < n; ++k) {
    std::vector<S> toeplitz{S(1), S(-a(k, k))};
    Points<S> column = a.block(0, k, k, 1);
    for (Index power = 0; power < k; ++power) {
      S product(0);
      for (Index j = 0; j < k; ++j) product -= a(k, j) * column(j, 0);
      toeplitz.push_back(product);
      if (power + 1 == k) break;
      Points<S> next = Points<S>::Zero(k, 1);
      for (Index i = 0; i < k; ++i)
        for (Index j = 0; j < k; ++j)
          if (!a(i, j).is_zero()) next(i, 0) += a(i, j) * column(j, 0);
      column = std::move(next);
    }
    std::vector<S> next(p.size() + 1, S(0));
    for (std::size_t i = 0; i < next.size(); ++i)
      for (std::size_t j = 0; j <= std::min(i, p.size() - 1); ++j) next[i] += toeplitz[i - j] * p[j];
    p = std::move(next);
  }
  std::reverse(p.begin(), p.end());
  return Polynomial<S>(std::move(p));
}

}  // namespace

template <class S>
int rank(const Points<S>& a) {
  Points<S> work = a;
  return static_cast<int>(reduce(work, work.cols()).size());
}

template <class S>
Points<S> kernel(const Points<S>& a) {
  Points<S> work = a;
  const std::vector<Index> pivots = reduce(work, work.cols());
  Points<S> basis = Points<S>::Zero(a.cols(), a.cols() - static_cast<Index>(pivots.size()));
  Index column = 0;
  for (Index free = 0; free < a.cols(); ++free) {
    if (std::find(pivots.begin(), pivots.end(), free) != pivots.end()) continue;
    basis(free, column) = S(1);
    for (std::size_t row = 0; row < pivots.size(); ++row) basis(pivots[row], column) = -work(static_cast<Index>(row), free);
    ++column;
  }
  return basis;
}

template <class S>
std::optional<Points<S>> solve(const Points<S>& a, const Points<S>& b) {
  if (a.rows() != b.rows())
    throw Error(ErrorKind::internal, "E_INTERNAL", "the right side of a linear system needs as many rows as the matrix");
  Points<S> work(a.rows(), a.cols() + b.cols());
  work << a, b;
  const std::vector<Index> pivots = reduce(work, a.cols());
  for (Index i = static_cast<Index>(pivots.size()); i < work.rows(); ++i)
    for (Index j = a.cols(); j < work.cols(); ++j)
      if (!work(i, j).is_zero()) return std::nullopt;
  Points<S> x = Points<S>::Zero(a.cols(), b.cols());
  for (std::size_t row = 0; row < pivots.size(); ++row)
    for (Index j = 0; j < b.cols(); ++j) x(pivots[row], j) = work(static_cast<Index>(row), a.cols() + j);
  return x;
}

template <class S>
Polynomial<S> characteristic_polynomial(const Points<S>& a) {
  require_square(a.rows(), a.cols());
  Polynomial<S> product({S(1)});
  for (const std::vector<Index>& block : irreducible_blocks(a)) {
    const auto n = static_cast<Index>(block.size());
    Points<S> part(n, n);
    for (Index i = 0; i < n; ++i)
      for (Index j = 0; j < n; ++j) part(i, j) = a(block[static_cast<std::size_t>(i)], block[static_cast<std::size_t>(j)]);
    product = product * berkowitz(part);
  }
  return product;
}

template <class S>
std::vector<int> jordan_blocks(const Points<S>& a, const S& eigenvalue) {
  require_square(a.rows(), a.cols());
  const auto n = static_cast<int>(a.rows());
  Points<S> shifted = a;
  for (Index i = 0; i < a.rows(); ++i) shifted(i, i) -= eigenvalue;
  // at_least[k]: the number of blocks of size k + 1 and more, which is rank((a - x)^k) - rank((a - x)^(k + 1)).
  std::vector<int> at_least;
  Points<S> power = shifted;
  for (int before = n, now = rank(shifted); now < before;) {
    at_least.push_back(before - now);
    power = (power * shifted).eval();
    before = std::exchange(now, rank(power));
  }
  std::vector<int> sizes(at_least.empty() ? 0 : static_cast<std::size_t>(at_least.front()), 0);
  for (const int count : at_least)
    for (std::size_t block = 0; block < static_cast<std::size_t>(count); ++block) ++sizes[block];
  return sizes;
}

#define UDCP_INSTANTIATE(S)                                                    \
  template int rank(const Points<S>&);                                         \
  template Points<S> kernel(const Points<S>&);                                 \
  template std::optional<Points<S>> solve(const Points<S>&, const Points<S>&); \
  template Polynomial<S> characteristic_polynomial(const Points<S>&);          \
  template std::vector<int> jordan_blocks(const Points<S>&, const S&);
UDCP_INSTANTIATE(Rational)
UDCP_INSTANTIATE(Algebraic)
#undef UDCP_INSTANTIATE

}  // namespace udcp
