// Masks on lattices and their difference schemes.
#include "proofs/regular_part.h"

#include <algorithm>
#include <cmath>

namespace udcp {

template <class S>
S LatticeMask<S>::at(Place offset) const {
  const int i = offset.x - x0, j = offset.y - y0;
  if (i < 0 || j < 0 || i % 2 != 0 || j % 2 != 0 || i >= 2 * nx || j >= 2 * ny) return S(0);
  return coefficients[static_cast<std::size_t>(j / 2 * nx + i / 2)];
}

namespace {

template <class S>
using Sparse = std::map<Place, S>;

template <class S>
LatticeMask<S> dense(const Sparse<S>& entries) {
  LatticeMask<S> result;
  if (entries.empty()) return result;
  Place low = entries.begin()->first, high = low;
  for (const auto& [place, value] : entries) {
    low = {std::min(low.x, place.x), std::min(low.y, place.y)};
    high = {std::max(high.x, place.x), std::max(high.y, place.y)};
  }
  result = {low.x, low.y, (high.x - low.x) / 2 + 1, (high.y - low.y) / 2 + 1, {}};
  result.coefficients.assign(static_cast<std::size_t>(result.nx * result.ny), S(0));
  for (const auto& [place, value] : entries)
    result.coefficients[static_cast<std::size_t>((place.y - low.y) / 2 * result.nx + (place.x - low.x) / 2)] = value;
  return result;
}

template <class S>
Sparse<S> sparse(const LatticeMask<S>& mask) {
  Sparse<S> result;
  for (int j = 0; j < mask.ny; ++j) {
    for (int i = 0; i < mask.nx; ++i) {
      const S& value = mask.coefficients[static_cast<std::size_t>(j * mask.nx + i)];
      if (!is_zero(value)) result.emplace(Place{mask.x0 + 2 * i, mask.y0 + 2 * j}, value);
    }
  }
  return result;
}

/// The place of a point of the regular lattice in the frame of sector 0.
Place unfolded(const Sectors& sectors, const Label& label) {
  Place place{label.a, label.b};
  for (int s = 0; s < label.s; ++s) place = sectors.turned(place);
  return place;
}

int modulo(int x, int m) { return ((x % m) + m) % m; }

template <class S>
bool sums_are_one(const LatticeMask<S>& mask) {
  std::array<S, 4> sums{S(0), S(0), S(0), S(0)};
  for (const auto& [place, value] : sparse(mask))
    sums[static_cast<std::size_t>(modulo((place.x - mask.x0) / 2, 2) + 2 * modulo((place.y - mask.y0) / 2, 2))] += value;
  return std::all_of(sums.begin(), sums.end(), [](const S& sum) { return is_zero(S(sum - S(1))); });
}

}  // namespace

template <class S>
LatticeMask<S> lattice_mask(const Patch<S>& regular) {
  const Sectors& sectors = regular.sectors;
  if (sectors.valence != sectors.regular_valence())
    throw Error(ErrorKind::internal, "E_INTERNAL", "a mask needs the patch of a regular point");
  const int odd = sectors.dual ? 1 : 0;
  Sparse<S> result;
  // One new point per parity class, all in sector 0.
  for (const Place& y : {Place{2 + odd, odd}, {2 + odd, 2 + odd}, {4 - 3 * odd, 2 + odd}, {4 - 3 * odd, odd}}) {
    for (const auto& [label, weight] : regular.rows.at({0, y.x, y.y})) {
      const Place k = unfolded(sectors, label);
      result.emplace(Place{y.x - 2 * k.x, y.y - 2 * k.y}, weight);
    }
  }
  return dense(result);
}

template <class S>
LatticeMask<S> lattice_mask(const Word& word) {
  return lattice_mask(patch<S>(word, word.triangles ? 6 : 4, 6));
}

template <class S>
std::optional<LatticeMask<S>> difference_mask(const LatticeMask<S>& a, Place d) {
  Sparse<S> rest = sparse(a), quotient;
  // q(o) + q(o - d) = a(o): take the entries in an order in which o comes after o - d.
  const auto key = [&](const Place& o) { return o.x * d.x + o.y * d.y; };
  std::vector<Place> places;
  for (int j = -1; j <= a.ny; ++j)
    for (int i = -1; i <= a.nx; ++i) places.push_back({a.x0 + 2 * i, a.y0 + 2 * j});
  std::stable_sort(places.begin(), places.end(), [&](const Place& p, const Place& q) { return key(p) < key(q); });
  for (const Place& o : places) {
    S value = rest.contains(o) ? rest.at(o) : S(0);
    const auto before = quotient.find({o.x - 2 * d.x, o.y - 2 * d.y});
    if (before != quotient.end()) value -= before->second;
    if (is_zero(value)) continue;
    if (o.x < a.x0 || o.y < a.y0 || o.x >= a.x0 + 2 * a.nx || o.y >= a.y0 + 2 * a.ny) return std::nullopt;
    quotient.emplace(o, value);
  }
  Sparse<S> moved;  // z^(1/2) to the midpoints
  for (const auto& [o, value] : quotient) moved.emplace(Place{o.x + d.x, o.y + d.y}, value);
  return dense(moved);
}

template <class S>
LatticeMask<S> iterated(const LatticeMask<S>& a, int length) {
  const double period = std::ldexp(1.0, length - 1), width = period * a.nx,
               height = period * a.ny;  // before the last round, about
  if (4 * width * height > 4e6 || width * height * a.nx * a.ny > 3e7)
    throw Error(ErrorKind::limit, "E_TOO_LARGE", "the mask of " + std::to_string(length) + " rounds is too large",
                "use fewer rounds");
  LatticeMask<S> result{0, 0, 1, 1, {S(1)}};
  for (int round = 0; round < length; ++round) {
    // points before at j (the impulse response so far) become points after at y: a(y - 2 j)
    LatticeMask<S> next{a.x0 + 2 * result.x0, a.y0 + 2 * result.y0, a.nx + 2 * (result.nx - 1), a.ny + 2 * (result.ny - 1), {}};
    next.coefficients.assign(static_cast<std::size_t>(next.nx) * static_cast<std::size_t>(next.ny), S(0));
    for (int j = 0; j < result.ny; ++j) {
      for (int i = 0; i < result.nx; ++i) {
        const S& old = result.coefficients[static_cast<std::size_t>(j * result.nx + i)];
        if (is_zero(old)) continue;
        for (int v = 0; v < a.ny; ++v)
          for (int u = 0; u < a.nx; ++u)
            next.coefficients[static_cast<std::size_t>((2 * j + v) * next.nx + 2 * i + u)] +=
                old * a.coefficients[static_cast<std::size_t>(v * a.nx + u)];
      }
    }
    result = std::move(next);
  }
  return result;
}

template <class S>
S contraction(const LatticeMask<S>& a, int length) {
  using std::abs;
  const LatticeMask<S> power = iterated(a, length);
  const int period = 1 << length;
  std::vector<S> sums(static_cast<std::size_t>(period) * static_cast<std::size_t>(period), S(0));
  for (int j = 0; j < power.ny; ++j)
    for (int i = 0; i < power.nx; ++i)
      sums[static_cast<std::size_t>(j % period * period + i % period)] +=
          abs(power.coefficients[static_cast<std::size_t>(j * power.nx + i)]);
  S result(0);
  for (const S& sum : sums)
    if (result < sum) result = sum;
  return result;
}

template <class S>
std::optional<RegularPart<S>> regular_part(const LatticeMask<S>& mask, bool triangles, std::string* why) {
  const auto refuse = [&](const char* reason) {
    if (why != nullptr) *why = reason;
    return std::nullopt;
  };
  if (!sums_are_one(mask)) return refuse("the rows of the regular part do not sum to 1");
  RegularPart<S> result{mask, {}, {}};
  std::vector<Place> directions{{1, 0}, {0, 1}};
  if (triangles) directions.push_back({-1, 1});
  for (std::size_t axis = 0; axis < 2; ++axis) {
    std::optional<LatticeMask<S>> derivative = difference_mask(mask, directions[axis]);
    if (!derivative) return refuse("the regular part is not factorable: its mask is not divisible by 1 + z along the axes");
    for (S& c : derivative->coefficients) c *= S(2);
    result.derivative[axis] = std::move(*derivative);
    for (const Place& direction : directions) {
      std::optional<LatticeMask<S>> differences = difference_mask(result.derivative[axis], direction);
      if (differences) result.differences[axis].push_back(std::move(*differences));
    }
    if (result.differences[axis].size() < 2)
      return refuse("the regular part is not factorable twice: the schemes of its derivatives have no difference schemes");
  }
  return result;
}

template <class S>
S regular_bound(const RegularPart<S>& part, int length) {
  S result(0);
  for (const auto& differences : part.differences) {
    std::vector<S> norms;
    for (const LatticeMask<S>& mask : differences) norms.push_back(contraction(mask, length));
    std::sort(norms.begin(), norms.end());
    if (result < norms[1]) result = norms[1];
  }
  return result;
}

#define UDCP_INSTANTIATE(S)                                                                       \
  template struct LatticeMask<S>;                                                                 \
  template LatticeMask<S> lattice_mask(const Patch<S>&);                                          \
  template LatticeMask<S> lattice_mask(const Word&);                                              \
  template std::optional<LatticeMask<S>> difference_mask(const LatticeMask<S>&, Place);           \
  template S contraction(const LatticeMask<S>&, int);                                             \
  template LatticeMask<S> iterated(const LatticeMask<S>&, int);                                   \
  template std::optional<RegularPart<S>> regular_part(const LatticeMask<S>&, bool, std::string*); \
  template S regular_bound(const RegularPart<S>&, int);
UDCP_INSTANTIATE(Rational)
UDCP_INSTANTIATE(Algebraic)
#undef UDCP_INSTANTIATE
template struct LatticeMask<double>;
template LatticeMask<double> iterated(const LatticeMask<double>&, int);

}  // namespace udcp
