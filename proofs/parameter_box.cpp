// The search for cells: norms of one or two rounds first, then a polytope for the corners, then a cut through the longest side.
#include "proofs/parameter_box.h"

#include <algorithm>
#include <chrono>

#include "operators/interrupt.h"
#include "operators/matrix.h"
#include "proofs/checkers.h"
#include "proofs/curve_smoothness.h"
#include "proofs/joint_spectral_radius.h"

namespace udcp {
namespace {

using Clock = std::chrono::steady_clock;

Json to_json(const ParameterRange& range) {
  return {{"name", range.name},
          {"lower", range.lower ? udcp::to_json(*range.lower) : Json(nullptr)},
          {"upper", range.upper ? udcp::to_json(*range.upper) : Json(nullptr)},
          {"lower_open", range.lower_open},
          {"upper_open", range.upper_open}};
}

std::map<std::string, Rational> middle_of(const ParameterBox& box, const std::vector<Side>& cell) {
  std::map<std::string, Rational> values;
  for (std::size_t v = 0; v < box.size(); ++v)
    values[box[v].name] = from_finite(box[v], (cell[v].lower + cell[v].upper) / Rational(2));
  return values;
}

/// Cuts are made where the side, measured against the whole box, is longest.
std::size_t longest_side(const BoxScheme& scheme, const std::vector<Side>& cell) {
  std::size_t longest = 0;
  Rational best(0);
  for (std::size_t v = 0; v < cell.size(); ++v) {
    const Rational whole = scheme.box[v].upper - scheme.box[v].lower;
    if (whole.is_zero()) continue;
    const Rational share = (cell[v].upper - cell[v].lower) / whole;
    if (share > best) {
      best = share;
      longest = v;
    }
  }
  return longest;
}

class Search {
 public:
  Search(const Word& word, const BoxScheme& scheme, const ParameterBox& box, const SearchLimits& limits)
      : word_(word), scheme_(scheme), box_(box), limits_(limits), start_(Clock::now()), affine_(is_multi_affine(scheme)) {
    for (int k = 0; k < scheme.smoothness; ++k) bound_ /= Rational(scheme.arity);
  }

  /// The certificate of the cell; null where it is not proved: then `failed` says where.
  Json cell(const std::vector<Side>& sides, int depth) {
    throw_if_stopped(limits_.stop);
    if (++nodes_ > limits_.nodes || seconds() > limits_.seconds)
      return give_up(sides, "the time or the number of cells is used up");
    for (const int length : {1, 2}) {
      if (contracts_on(scheme_, length, sides)) return {{"norm", length}};
    }
    if (affine_ && depth >= 1) {
      const Json found = polytope(sides);
      if (!found.is_null()) return found;
    }
    if (depth >= 3 && depth % 2 == 1 && refuted_in_the_middle(sides)) return nullptr;
    if (depth >= 40) return give_up(sides, "a cell as small as 2^-40 of the domain is still undecided");
    const std::size_t v = longest_side(scheme_, sides);
    const Rational middle = (sides[v].lower + sides[v].upper) / Rational(2);
    if (middle == sides[v].lower) return give_up(sides, "a point of the domain is undecided");
    std::vector<Side> part = sides;
    part[v] = {sides[v].lower, middle, sides[v].lower_open, false};
    const Json below = cell(part, depth + 1);
    if (below.is_null()) return nullptr;
    part[v] = {middle, sides[v].upper, false, sides[v].upper_open};
    const Json above = cell(part, depth + 1);
    if (above.is_null()) return nullptr;
    return {{"split", static_cast<int>(v)}, {"at", udcp::to_json(middle)}, {"below", below}, {"above", above}};
  }

  std::string why;
  std::map<std::string, Rational> where;
  std::optional<Result> refutation;
  [[nodiscard]] int nodes() const { return nodes_; }

 private:
  [[nodiscard]] double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

  Json give_up(const std::vector<Side>& sides, const std::string& reason) {
    why = reason;
    where = middle_of(box_, sides);
    if (!refutation) (void)refuted_in_the_middle(sides);
    return nullptr;
  }

  Json polytope(const std::vector<Side>& sides) const {
    try {
      const std::vector<Points<Rational>> matrices = transitions_on(scheme_, sides);
      if (matrices.empty()) return nullptr;
      SearchLimits limits = limits_;
      limits.seconds = std::min(2.0, limits_.seconds - seconds());
      Budget budget(limits);
      const Rational below = bound_ * Rational(99'999) / Rational(100'000);
      const std::optional<Polytope> found = find_polytope(matrices, below, budget);
      if (found && found->bound < bound_ && polytope_holds(matrices, *found)) return {{"polytope", udcp::to_json(*found)}};
    } catch (const Rejected&) {
      // Unbounded weights at a corner: smaller cells may do.
    }
    return nullptr;
  }

  bool refuted_in_the_middle(const std::vector<Side>& sides) {
    const std::map<std::string, Rational> values = middle_of(box_, sides);
    SearchLimits limits = limits_;
    limits.seconds = 1;
    Result result = prove_smooth(at_point(word_, values), scheme_.smoothness, limits);
    if (result.verdict != Verdict::refuted) return false;
    where = values;
    refutation = std::move(result);
    return true;
  }

  const Word& word_;
  const BoxScheme& scheme_;
  const ParameterBox& box_;
  const SearchLimits& limits_;
  Clock::time_point start_;
  Rational bound_{1};
  bool affine_;
  int nodes_ = 0;
};

Json point_to_json(const std::map<std::string, Rational>& point) {
  Json json = Json::object();
  for (const auto& [name, value] : point) json[name] = udcp::to_json(value);
  return json;
}

/// The coefficients of det(x - a) as polynomials on the box, highest power first left away: Faddeev and LeVerrier on polynomials.
using BoxMatrix = std::vector<std::vector<BoxPolynomial>>;

BoxMatrix times(const BoxMatrix& a, const BoxMatrix& b, std::size_t variables) {
  const std::size_t n = a.size();
  BoxMatrix result(n, std::vector<BoxPolynomial>(n, BoxPolynomial::constant(Rational(0), variables)));
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < n; ++k) {
      if (a[i][k].is_zero()) continue;
      for (std::size_t j = 0; j < n; ++j) {
        if (!b[k][j].is_zero()) result[i][j] = result[i][j] + a[i][k] * b[k][j];
      }
    }
  }
  return result;
}

BoxMatrix transition(const BoxScheme& scheme, int e) {
  const int n = static_cast<int>(scheme.numerators.size()) - 1, a = scheme.arity;
  const auto size = static_cast<std::size_t>(std::max(1, (n + a - 2) / (a - 1)));
  BoxMatrix t(size, std::vector<BoxPolynomial>(size, BoxPolynomial::constant(Rational(0), scheme.box.size())));
  for (std::size_t row = 0; row < size; ++row) {
    for (std::size_t column = 0; column < size; ++column) {
      const int index = a * static_cast<int>(column) + e - static_cast<int>(row);
      if (index >= 0 && index <= n) t[row][column] = scheme.numerators[static_cast<std::size_t>(index)];
    }
  }
  return t;
}

/// det(x D^l - a) at x = `at`, D^l the denominator of a: negative (times the sign of at^n) only if an eigenvalue lies beyond
/// `at`.
BoxPolynomial determinant_at(const BoxMatrix& a, const BoxPolynomial& denominator, const Rational& at, std::size_t variables) {
  const std::size_t n = a.size();
  BoxMatrix m(n, std::vector<BoxPolynomial>(n, BoxPolynomial::constant(Rational(0), variables)));
  BoxPolynomial value = BoxPolynomial::constant(Rational(1), variables), c = value;
  for (std::size_t k = 1; k <= n; ++k) {  // M_k = a M_{k-1} + c_{n-k+1} I, c_{n-k} = -tr(a M_k)/k
    m = times(a, m, variables);
    for (std::size_t i = 0; i < n; ++i) m[i][i] = m[i][i] + c;
    const BoxMatrix product = times(a, m, variables);
    BoxPolynomial trace = BoxPolynomial::constant(Rational(0), variables);
    for (std::size_t i = 0; i < n; ++i) trace = trace + product[i][i];
    c = Rational(-1) / Rational(static_cast<int>(k)) * trace;
    value = value * (at * denominator) + c;  // Horner in at * denominator
  }
  return value;
}

/// The determinants that refute: a product of up to three transition matrices, at A^-kl and at -A^-kl.
std::vector<BoxPolynomial> refuting_polynomials(const BoxScheme& scheme) {
  std::vector<BoxPolynomial> result;
  const std::size_t variables = scheme.box.size();
  std::vector<BoxMatrix> letters, words;
  for (int e = 0; e < scheme.arity; ++e) letters.push_back(transition(scheme, e));
  if (letters.front().size() > 8) return result;
  words = letters;
  BoxPolynomial denominator = scheme.denominator;
  Rational bound(1);
  for (int length = 1; length <= 3; ++length) {
    for (int k = 0; k < scheme.smoothness; ++k) bound /= Rational(scheme.arity);
    for (const BoxMatrix& word : words) {
      const bool odd = word.size() % 2 == 1;
      result.push_back(determinant_at(word, denominator, bound, variables));
      result.push_back(Rational(odd ? -1 : 1) * determinant_at(word, denominator, -bound, variables));
    }
    std::vector<BoxMatrix> longer;
    for (const BoxMatrix& word : words)
      for (const BoxMatrix& letter : letters) longer.push_back(times(word, letter, variables));
    words = std::move(longer);
    denominator = denominator * scheme.denominator;
  }
  return result;
}

class Region {
 public:
  Region(const BoxScheme& scheme, const SearchLimits& limits)
      : scheme_(scheme),
        limits_(limits),
        start_(Clock::now()),
        refuting_(refuting_polynomials(scheme)),
        affine_(is_multi_affine(scheme)) {
    for (int k = 0; k < scheme.smoothness; ++k) bound_ /= Rational(scheme.arity);
  }

  void cut(const std::vector<Side>& cell, int depth, std::vector<RegionCell>& cells) {
    const Verdict verdict = decide(cell);
    if (verdict != Verdict::undecided || depth == 0) {
      RegionCell result;
      result.verdict = verdict;
      for (const Side& side : cell) {
        result.lower.push_back(side.lower);
        result.upper.push_back(side.upper);
      }
      cells.push_back(std::move(result));
      return;
    }
    const std::size_t v = longest_side(scheme_, cell);
    const Rational middle = (cell[v].lower + cell[v].upper) / Rational(2);
    std::vector<Side> part = cell;
    part[v] = {cell[v].lower, middle, cell[v].lower_open, false};
    cut(part, depth - 1, cells);
    part[v] = {middle, cell[v].upper, false, cell[v].upper_open};
    cut(part, depth - 1, cells);
  }

 private:
  Verdict decide(const std::vector<Side>& cell) {
    throw_if_stopped(limits_.stop);
    if (std::chrono::duration<double>(Clock::now() - start_).count() > limits_.seconds) return Verdict::undecided;
    for (const BoxPolynomial& p : refuting_) {
      if (positive_on(Rational(-1) * p, cell)) return Verdict::refuted;
    }
    if (contracts_on(scheme_, 1, cell)) return Verdict::proved;
    if (!affine_) return contracts_on(scheme_, 2, cell) ? Verdict::proved : Verdict::undecided;
    try {
      SearchLimits limits = limits_;
      limits.seconds = 0.2;
      Budget budget(limits);
      const Rational below = bound_ * Rational(99'999) / Rational(100'000);
      const std::vector<Points<Rational>> matrices = transitions_on(scheme_, cell);
      if (!matrices.empty() && find_polytope(matrices, below, budget)) return Verdict::proved;
    } catch (const Rejected&) {
      // Unbounded weights at a corner: smaller cells may do.
    }
    return Verdict::undecided;
  }

  const BoxScheme& scheme_;
  const SearchLimits& limits_;
  Clock::time_point start_;
  std::vector<BoxPolynomial> refuting_;
  Rational bound_{1};
  bool affine_;
};

}  // namespace

std::vector<RegionCell> region_of_smoothness(const Word& word, int smoothness, const ParameterBox& box, int depth,
                                             const SearchLimits& limits) {
  for (const ParameterRange& range : box) {
    if (!range.lower || !range.upper)
      throw Error(ErrorKind::word, "E_DOMAIN", "a region needs a finite range of '" + range.name + "'", "write 0 .. 1/4");
  }
  std::vector<RegionCell> cells;
  try {
    const BoxScheme scheme = difference_scheme_on_box(word, smoothness, box);
    Region(scheme, limits).cut(scheme.box, depth, cells);
  } catch (const Rejected& rejected) {
    throw Error(ErrorKind::word, "E_NO_REGION", rejected.what(),
                "the weights of the word must be rational functions of the parameters");
  }
  return cells;
}

Word at_point(const Word& word, const std::map<std::string, Rational>& values) {
  const auto fixed = [&](const KernelPtr& kernel) -> KernelPtr {
    if (!kernel) return kernel;
    return formula(
        [kernel, values](const auto& c) {
          using S = std::decay_t<decltype(c.alpha.value())>;
          const Context<Parametric> context{{}, c.valence, 0, -1, nullptr};
          return Quantity<S>(kernel->at(context).value().at(values));
        },
        Needs{kernel->needs().valence, false, false});
  };
  Word result = word;
  for (Item& item : result.tail) {
    item.f = Directional<KernelPtr>::all(fixed(item.f.plain));
    item.omega = Directional<KernelPtr>::all(fixed(item.omega.plain));
    item.omega_face = fixed(item.omega_face);
    item.delta = fixed(item.delta);
  }
  return result;
}

Result prove_smooth_on_box(const Word& word, int smoothness, const ParameterBox& box, const SearchLimits& limits) {
  const std::string claim = smoothness == 0 ? "the scheme converges" : "the scheme is C^" + std::to_string(smoothness);
  BoxScheme scheme;
  Json json_word;
  try {
    json_word = to_json(word, {word.triangles ? 6 : 4});
    scheme = difference_scheme_on_box(word, smoothness, box);
  } catch (const Rejected& rejected) {
    return undecided(claim, rejected.what());
  }
  Search search(word, scheme, box, limits);
  const Json cells = search.cell(scheme.box, 0);
  const std::string for_all = describe(json_word) + (smoothness == 0 ? " converges" : " is C^" + std::to_string(smoothness)) +
                              " for all parameters of the domain";
  if (cells.is_null()) {
    Result result = undecided(for_all, search.why);
    result.witness = {{"parameters", point_to_json(search.where)}};
    result.details = {{"cells", search.nodes()}};
    if (search.refutation) {
      result.verdict = Verdict::refuted;
      result.reason = "at the parameters of the witness: " + search.refutation->reason;
      result.certificate = search.refutation->certificate;
    }
    return result;
  }
  Json ranges = Json::array();
  for (const ParameterRange& range : box) ranges.push_back(to_json(range));
  const Json data = {{"word", json_word}, {"smoothness", smoothness}, {"box", ranges}, {"cells", cells}};
  try {
    Result result = concluded(Verdict::proved, "the domain is covered by cells with a contraction each",
                              seal("curve-box", check_curve_box(data), data));
    result.details = {{"cells", search.nodes()}};
    return result;
  } catch (const Rejected& rejected) {
    return undecided(claim, rejected.what());
  }
}

}  // namespace udcp
