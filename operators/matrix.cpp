// Unit vectors through run(): matrices, masks, stencils; and the regular neighbourhoods that they are made on.
#include "operators/matrix.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

namespace udcp {
namespace {

int floor_div(int a, int b) { return a >= 0 ? a / b : -((-a + b - 1) / b); }

RunControl from_round(const Word& word, int round) {
  if (round < 0 || (round > 0 && !word.is_scheme()))
    throw Error(ErrorKind::word, "E_NO_ROUND", "the word has no round " + std::to_string(round),
                "a finite operator has round 0 only; a scheme (...)* has rounds 0, 1, 2, ...");
  RunControl control;
  control.first_item = word.is_scheme() ? word.items(round) : 0;
  return control;
}

const std::vector<Item>& round_of(const Word& word) { return word.is_scheme() ? word.tail : word.head; }

// Where new point 0 lies, in units of the new spacing: every realised dual moves it by one half.
Rational shift_of(const std::vector<Item>& items) {
  Rational shift;
  bool dual = false;
  const auto realise = [&] {
    if (dual) shift += Rational(1) / Rational(2);
    dual = false;
  };
  for (const Item& item : items) {
    if (item.atom == Atom::average) dual = !dual;
    if (item.atom != Atom::up) continue;
    realise();
    shift *= Rational(item.sections);
  }
  realise();
  return shift;
}

void require_constant(const Word& word) {
  const auto check = [](const KernelPtr& kernel) {
    if (kernel && kernel->needs().vertex)
      throw Error(ErrorKind::word, "E_MASK_VARIES",
                  "the word has parameters that differ from point to point (v.name or noise), so it has no mask",
                  "matrix(word, ...) gives the rows at every point");
  };
  for (const std::vector<Item>* items : {&word.head, &word.tail}) {
    for (const Item& item : *items) {
      for (const KernelPtr& kernel : {item.f.plain, item.omega.plain, item.delta}) check(kernel);
    }
  }
  check(word.alpha0.plain);
}

// omega is the constant 0, as in Catmull-Clark and Loop.
bool spreads_nothing(const Item& item) {
  const auto zero = [](const KernelPtr& kernel) {
    if (!kernel) return false;
    const Needs needs = kernel->needs();
    if (needs.valence || needs.vertex || needs.round) return false;
    try {
      const Quantity<double> value = kernel->at(Context<double>{});
      return value.kind() == Quantity<double>::Kind::rational && value.exact().sign() == 0;
    } catch (const Error& error) {
      if (error.kind != ErrorKind::not_exact) throw;
      return false;  // a symbol
    }
  };
  return zero(item.omega.plain) && zero(item.omega.latitude) && zero(item.omega.longitude) &&
         (!item.omega_face || zero(item.omega_face));
}

template <class S, class Shape>
Points<S> matrix_of(const Word& word, Shape shape, int round) {
  const Eigen::Index n = shape.points.rows();
  shape.points = Points<S>::Identity(n, n);
  return run(word, std::move(shape), 1, from_round(word, round)).points;
}

}  // namespace

Reach reach_of_round(const Word& word) {
  Reach now, old;
  int sections = 2;
  bool dual = false;
  const auto spread = [&](Reach r) { return Reach{sections * r.low - sections + 1, sections * r.high + sections - 1}; };
  for (const Item& item : round_of(word)) {
    switch (item.atom) {
      case Atom::up:
        old = now;
        sections = item.sections;
        dual = false;
        now = spread(now);
        break;
      case Atom::average:
        dual ? ++now.high : --now.low;
        dual = !dual;
        break;
      case Atom::convolve:
        now = {now.low - 1, now.high + 1};
        break;
      case Atom::push_back: {
        if (spreads_nothing(item)) break;
        const Reach moved =
            spread({std::min(old.low, -floor_div(-now.low, sections)), std::max(old.high, floor_div(now.high, sections))});
        now = {std::min(now.low, moved.low), std::max(now.high, moved.high)};
        break;
      }
    }
    if (now.high - now.low > 1'000'000)
      throw Error(ErrorKind::limit, "E_ARITY", "the mask of one round would have more than 1000000 coefficients",
                  "use fewer U in a round");
  }
  return now;
}

template <class S>
Points<S> subdivision_matrix(const Word& word, const Polyline<S>& curve, int round) {
  return matrix_of<S>(word, curve, round);
}

template <class S>
Points<S> subdivision_matrix(const Word& word, const Surface<S>& surface, int round) {
  return matrix_of<S>(word, surface, round);
}

int arity(const Word& word) {
  int product = 1;
  for (const Item& item : round_of(word)) {
    if (item.atom != Atom::up) continue;
    if (product > 1'000'000 / item.sections)
      throw Error(ErrorKind::limit, "E_ARITY", "one round of the word multiplies the points by more than 1000000",
                  "use fewer U in a round");
    product *= item.sections;
  }
  return product;
}

template <class S>
Mask<S> mask(const Word& word, int round) {
  validate_for_curve(word);
  require_constant(word);
  Mask<S> result;
  result.arity = arity(word);
  result.shift = shift_of(round_of(word));
  const Reach reach = reach_of_round(word);
  // Long enough that the new points around the unit vector do not meet round the back.
  const int points = std::max(3, (reach.high - reach.low) / result.arity + 4);
  Polyline<S> curve;
  curve.points = Points<S>::Zero(points, 1);
  curve.points(0, 0) = S(1);
  const Points<S> fine = run(word, std::move(curve), 1, from_round(word, round)).points;
  const int n = static_cast<int>(fine.rows());
  const auto value = [&](int k) -> const S& { return fine((k % n + n) % n, 0); };
  int low = reach.low, high = reach.high;
  while (low < high && is_zero(value(low))) ++low;
  while (high > low && is_zero(value(high))) --high;
  result.first = low;
  for (int k = low; k <= high; ++k) result.coefficients.push_back(value(k));
  return result;
}

template <class S>
std::vector<Stencil<S>> stencils(const Mask<S>& mask) {
  std::vector<Stencil<S>> result;
  const int a = mask.arity, last = mask.first + static_cast<int>(mask.coefficients.size()) - 1;
  for (int r = 0; r < a; ++r) {
    // p_new[a j + r] takes coefficient(r - a i) from p_old[j + i]
    Stencil<S> stencil;
    stencil.first = -floor_div(last - r, a);
    const int end = floor_div(r - mask.first, a);
    for (int i = stencil.first; i <= end; ++i)
      stencil.weights.push_back(mask.coefficients[static_cast<std::size_t>(r - a * i - mask.first)]);
    result.push_back(std::move(stencil));
  }
  return result;
}

namespace {

// A place of the star: i steps along spoke s, j along spoke s + 1; (s, 0, j) is (s + 1, j, 0).
struct Place {
  int s, i, j;
};

class Star {
 public:
  Star(int valence, int rings, bool triangles) : n_(valence), rings_(rings), triangles_(triangles) {
    vertices_.push_back({0, 0, 0});
    for (int r = 1; r <= rings; ++r)
      for (int s = 0; s < n_; ++s) add_ring(s, r);
  }

  Surface<double> surface() const {
    Surface<double> result;
    result.mesh = std::make_shared<const Mesh>(make_mesh(static_cast<int>(vertices_.size()), faces()));
    result.points = Points<double>::Zero(static_cast<Eigen::Index>(vertices_.size()), 3);
    const double angle = 2 * std::acos(-1.0) / n_;
    for (std::size_t k = 0; k < vertices_.size(); ++k) {
      const auto [s, i, j] = vertices_[k];
      result.points(static_cast<Eigen::Index>(k), 0) = i * std::cos(s * angle) + j * std::cos((s + 1) * angle);
      result.points(static_cast<Eigen::Index>(k), 1) = i * std::sin(s * angle) + j * std::sin((s + 1) * angle);
    }
    return result;
  }

 private:
  void add_ring(int s, int r) {
    vertices_.push_back({s, r, 0});
    if (triangles_) {
      for (int k = 1; k < r; ++k) vertices_.push_back({s, r - k, k});
      return;
    }
    for (int j = 1; j <= r; ++j) vertices_.push_back({s, r, j});
    for (int i = r - 1; i >= 1; --i) vertices_.push_back({s, i, r});
  }

  [[nodiscard]] int index(int s, int i, int j) const {
    if (i == 0 && j == 0) return 0;
    if (i == 0) return index(s + 1, j, 0);
    s %= n_;
    if (triangles_) {
      const int r = i + j;
      return 1 + n_ * r * (r - 1) / 2 + s * r + j;
    }
    const int r = std::max(i, j);
    return 1 + n_ * r * (r - 1) + 2 * r * s + (i == r ? j : r + (r - i));
  }

  [[nodiscard]] std::vector<std::vector<int>> faces() const {
    std::vector<std::vector<int>> result;
    for (int r = 0; r < rings_; ++r)
      for (int s = 0; s < n_; ++s) triangles_ ? add_triangles(s, r, result) : add_quads(s, r, result);
    return result;
  }

  void add_quads(int s, int r, std::vector<std::vector<int>>& result) const {
    const auto cell = [&](int i, int j) {
      result.push_back({index(s, i, j), index(s, i + 1, j), index(s, i + 1, j + 1), index(s, i, j + 1)});
    };
    for (int j = 0; j <= r; ++j) cell(r, j);
    for (int i = r - 1; i >= 0; --i) cell(i, r);
  }

  void add_triangles(int s, int r, std::vector<std::vector<int>>& result) const {
    for (int j = 0; j <= r; ++j) {
      const int i = r - j;
      result.push_back({index(s, i, j), index(s, i + 1, j), index(s, i, j + 1)});
      if (i > 0) result.push_back({index(s, i, j), index(s, i, j + 1), index(s, i - 1, j + 1)});
    }
  }

  int n_, rings_;
  bool triangles_;
  std::vector<Place> vertices_;
};

}  // namespace

Surface<double> ring_mesh(int valence, int rings, bool triangles) {
  if (valence < 3 || valence > 10'000 || rings < 1 || rings > 50 || static_cast<long>(valence) * rings * rings > 1'000'000)
    throw Error(ErrorKind::input, "E_RING_MESH",
                "no neighbourhood of " + std::to_string(rings) + " rings around a vertex of valence " + std::to_string(valence) +
                    "; valences from 3 and rings from 1 to 50 with valence * rings^2 <= 1000000",
                "");
  return Star(valence, rings, triangles).surface();
}

#define UDCP_INSTANTIATE(S)                                                    \
  template Points<S> subdivision_matrix(const Word&, const Polyline<S>&, int); \
  template Points<S> subdivision_matrix(const Word&, const Surface<S>&, int);  \
  template Mask<S> mask(const Word&, int);                                     \
  template std::vector<Stencil<S>> stencils(const Mask<S>&);
UDCP_FOR_EACH_NUMBER(UDCP_INSTANTIATE)
#undef UDCP_INSTANTIATE

}  // namespace udcp
