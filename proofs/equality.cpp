// Comparison of masks on curves and of matrices on small meshes.
#include "proofs/equality.h"

#include <optional>

#include "operators/matrix.h"
#include "proofs/checkers.h"

namespace udcp {
namespace {

/// So many rounds as one, for mask().
Word rounds_as_one(const Word& word, int rounds) {
  Word result = word;
  for (int k = 1; k < rounds; ++k) result.tail.insert(result.tail.end(), word.tail.begin(), word.tail.end());
  return result;
}

std::optional<RoundsToCompare> rounds_of_equal_arity(const Word& first, const Word& second) {
  const long a = arity(first), b = arity(second);
  long p = 1;
  for (int i = 1; i <= 6; ++i) {
    p *= a;
    long q = 1;
    for (int j = 1; j <= 6; ++j) {
      q *= b;
      if (p == q && p <= 1'000'000) return RoundsToCompare{i, j};
      if (q > p) break;
    }
    if (p > 1'000'000) break;
  }
  return std::nullopt;
}

/// f with the cheapest exact number type that can hold the parameters.
template <class F>
auto exactly(F f) {
  try {
    return f(std::type_identity<Rational>{});
  } catch (const Error& error) {
    if (error.kind != ErrorKind::not_exact) throw;
  }
  try {
    return f(std::type_identity<Algebraic>{});
  } catch (const Error& error) {
    if (error.kind != ErrorKind::not_exact) throw;
  }
  return f(std::type_identity<Parametric>{});
}

std::string offset_text(int k) { return "the new point " + std::to_string(k); }

template <class S>
std::string difference_of(const Mask<S>& a, const Mask<S>& b) {
  const int last_a = a.first + static_cast<int>(a.coefficients.size()),
            last_b = b.first + static_cast<int>(b.coefficients.size());
  const auto at = [](const Mask<S>& m, int k) {
    const int i = k - m.first;
    return i >= 0 && i < static_cast<int>(m.coefficients.size()) ? m.coefficients[static_cast<std::size_t>(i)] : S(0);
  };
  for (int k = std::min(a.first, b.first); k < std::max(last_a, last_b); ++k) {
    const S x = at(a, k), y = at(b, k);
    if (x != y)
      return offset_text(k) + " takes " + to_text(x) + " of the old point 0 in the first word and " + to_text(y) +
             " in the second";
  }
  return {};
}

/// A vertex of this valence, or (dual) a face with so many corners, in two rings.
template <class S>
Surface<S> test_mesh(int valence, bool triangles, bool dual) {
  Surface<double> ring = ring_mesh(valence, dual ? 3 : 2, triangles);
  if (dual) {
    Word average;
    Item item;
    item.atom = Atom::average;
    average.head.push_back(item);
    ring = run(average, std::move(ring), 1);
  }
  Surface<S> result;
  result.mesh = ring.mesh;
  result.tags = ring.tags;
  const Eigen::Index n = ring.points.rows();
  result.points = Points<S>::Identity(n, n);
  return result;
}

template <class S>
std::string difference_on_mesh(const Word& first, const Word& second, RoundsToCompare rounds, const Surface<S>& mesh,
                               const std::string& where) {
  RunControl control;
  control.max_bytes = std::int64_t{1} << 29;
  const Surface<S> a = run(first, mesh, rounds.first, control), b = run(second, mesh, rounds.second, control);
  if (a.points.rows() != b.points.rows() || a.mesh->vertex != b.mesh->vertex || a.mesh->face_begin != b.mesh->face_begin)
    return "the meshes that they make " + where + " have different connectivity";
  for (Eigen::Index i = 0; i < a.points.rows(); ++i) {
    for (Eigen::Index j = 0; j < a.points.cols(); ++j) {
      if (a.points(i, j) != b.points(i, j))
        return where + ", the new point " + std::to_string(i) + " takes " + to_text(a.points(i, j)) + " of the old point " +
               std::to_string(j) + " in the first word and " + to_text(b.points(i, j)) + " in the second";
    }
  }
  return {};
}

}  // namespace

namespace equality {

std::string difference_on_curves(const Word& first, const Word& second, RoundsToCompare rounds) {
  const Word a = rounds_as_one(first, rounds.first), b = rounds_as_one(second, rounds.second);
  return exactly([&]<class S>(std::type_identity<S>) { return difference_of(mask<S>(a), mask<S>(b)); });
}

std::string difference_on_meshes(const Word& first, const Word& second, RoundsToCompare rounds, int valence) {
  return exactly([&]<class S>(std::type_identity<S>) {
    const std::string n = std::to_string(valence);
    std::string difference = difference_on_mesh(first, second, rounds, test_mesh<S>(valence, first.triangles, false),
                                                "around a vertex of valence " + n);
    if (difference.empty() && !first.triangles)
      difference =
          difference_on_mesh(first, second, rounds, test_mesh<S>(valence, false, true), "around a face with " + n + " corners");
    return difference;
  });
}

}  // namespace equality

Result prove_equal(const Word& first, const Word& second, const std::vector<int>& valences) {
  std::vector<int> of_parameters = valences;
  of_parameters.push_back(first.triangles ? 6 : 4);
  const Json a = to_json(first, of_parameters), b = to_json(second, of_parameters);
  const std::string claim = describe(a) + " and " + describe(b) + " are the same operator";
  Result different;
  different.claim = claim;
  different.verdict = Verdict::refuted;
  if (first.triangles != second.triangles) {
    different.reason = "one of the words acts on triangles, the other does not";
    return different;
  }
  const std::optional<RoundsToCompare> rounds = rounds_of_equal_arity(first, second);
  if (!rounds) {
    different.verdict = Verdict::undecided;
    different.reason = "no numbers of rounds up to 6 multiply the points alike: the arities are " + std::to_string(arity(first)) +
                       " and " + std::to_string(arity(second));
    return different;
  }
  std::string difference = valences.empty() ? equality::difference_on_curves(first, second, *rounds) : "";
  for (std::size_t k = 0; k < valences.size() && difference.empty(); ++k)
    difference = equality::difference_on_meshes(first, second, *rounds, valences[k]);
  if (!difference.empty()) {
    different.reason = "their weights differ";
    different.witness = {{"rounds", {rounds->first, rounds->second}}, {"difference", difference}};
    return different;
  }
  const Json data = {{"first", a}, {"second", b}, {"rounds", {rounds->first, rounds->second}}, {"valences", valences}};
  std::string statement;
  try {
    statement = check_equality(data);
  } catch (const Rejected& rejected) {
    return undecided(claim, rejected.what());
  }
  return concluded(Verdict::proved, "the weights of all new points are equal, in exact arithmetic",
                   seal("equality", statement, data));
}

}  // namespace udcp
