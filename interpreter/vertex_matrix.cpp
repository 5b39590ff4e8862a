// The refined neighbourhood is laid over a larger copy of the old one: U alone, run on the flat ring mesh, says which new point
// takes which place. So the numbering of U is not repeated here.
#include "interpreter/vertex_matrix.h"

#include <cmath>
#include <map>

#include "operators/matrix.h"
#include "operators/run.h"

namespace udcp {

namespace {

int ring_size(int valence, int rings, bool triangles) {
  int size = 1;
  for (int r = 1; r <= rings; ++r) size += valence * (triangles ? r : 2 * r);
  return size;
}

using Cell = std::pair<long, long>;
Cell cell(double x, double y) { return {std::lround(x * 1e6), std::lround(y * 1e6)}; }

/// For every point of the rings (in their numbering) the row of the refined mesh that lies there.
std::vector<int> rows_of_rings(const Word& word, const Surface<double>& flat, int valence, int rings, int arity) {
  Word splits;
  for (const auto* part : {&word.head, &word.tail})
    for (const Item& item : *part)
      if (item.atom == Atom::up) (part == &word.head ? splits.head : splits.tail).push_back(item);
  splits.triangles = word.triangles;
  if (splits.head.empty())
    splits.head = std::exchange(splits.tail, {});
  else if (!splits.tail.empty())
    splits.head = std::exchange(splits.tail, {});  // one round of the tail, as the matrix is
  const Surface<double> fine = run(splits, flat, 1);
  std::map<Cell, int> row_at;
  for (int v = 0; v < fine.mesh->vertices(); ++v) row_at[cell(fine.points(v, 0) * arity, fine.points(v, 1) * arity)] = v;
  const Surface<double> places = ring_mesh(valence, rings, word.triangles);
  std::vector<int> rows;
  for (int v = 0; v < places.mesh->vertices(); ++v) {
    const double x = places.points(v, 0), y = places.points(v, 1);
    auto found = row_at.end();
    for (long dx = -1; dx <= 1 && found == row_at.end(); ++dx)  // the two sums may round to neighbouring cells
      for (long dy = -1; dy <= 1 && found == row_at.end(); ++dy)
        found = row_at.find({cell(x, y).first + dx, cell(x, y).second + dy});
    if (found == row_at.end()) return {};
    rows.push_back(found->second);
  }
  return rows;
}

int sections_of(const std::vector<Item>& items) {
  int product = 1;
  for (const Item& item : items)
    if (item.atom == Atom::up) product *= item.sections;
  return product;
}

/// The square part, or nothing if a row reaches beyond it.
template <class S>
std::optional<Points<S>> square_part(const Points<S>& all, const std::vector<int>& rows, int size) {
  Points<S> square(size, size);
  for (int i = 0; i < size; ++i) {
    for (int j = 0; j < static_cast<int>(all.cols()); ++j) {
      const S& entry = all(rows[static_cast<std::size_t>(i)], j);
      if (j < size)
        square(i, j) = entry;
      else if (!is_zero(entry))
        return std::nullopt;
    }
  }
  return square;
}

bool ends_dual(const std::vector<Item>& items) {
  int d = 0;
  for (const Item& item : items) {
    if (item.atom == Atom::up) d = 0;
    if (item.atom == Atom::average) ++d;
  }
  return d % 2 == 1;
}

template <class S>
std::optional<Points<S>> try_rings(const Word& word, int valence, int rings, int round) {
  const int columns = ring_size(valence, rings + 2, word.triangles);
  if (columns > 800)  // four times as many rows, and some 150 bytes an exact entry
    throw Error(ErrorKind::limit, "E_MAX_MEMORY",
                "the matrix of " + std::to_string(rings) + " rings at valence " + std::to_string(valence) + " is too large",
                "take a smaller valence or fewer rings");
  const Surface<double> flat = ring_mesh(valence, rings + 2, word.triangles);
  Surface<S> start;
  start.mesh = flat.mesh;
  start.points = Points<S>::Constant(flat.points.rows(), 1, S(0));
  const Points<S> all = subdivision_matrix(word, start, round);
  const std::vector<int> rows = rows_of_rings(word, flat, valence, rings, sections_of(word.is_scheme() ? word.tail : word.head));
  if (rows.empty()) return std::nullopt;
  return square_part(all, rows, ring_size(valence, rings, word.triangles));
}

}  // namespace

VertexMatrix vertex_matrix(const Word& word, int valence, int rings, int round) {
  if (ends_dual(word.is_scheme() ? word.tail : word.head))
    throw Error(ErrorKind::word, "E_MATRIX_DUAL", "a word that ends in the dual state has no matrix at a vertex",
                "matrix(word, points = n) gives the matrix on a closed curve");
  for (int r = rings > 0 ? rings : 1; r <= (rings > 0 ? rings : 6); ++r) {
    VertexMatrix result{r, {}};
    const bool found = std::visit(
        [&](auto&& square) {
          if (square) result.matrix.entries = std::move(*square);
          return square.has_value();
        },
        exact_or_enclosed([&]<class S>(std::type_identity<S>) { return try_rings<S>(word, valence, r, round); }));
    if (found) return result;
  }
  throw Error(ErrorKind::word, "E_MATRIX_RINGS",
              rings > 0 ? "the new points of " + std::to_string(rings) + " rings depend on old points outside of them"
                        : "no neighbourhood of up to 6 rings maps to itself under this word",
              rings > 0 ? "take more rings, or leave rings away" : "");
}

}  // namespace udcp
