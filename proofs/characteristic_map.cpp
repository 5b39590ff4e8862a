// Dependence sets, the ring, the extended eigenvector, Bezier patches.
#include "proofs/characteristic_map.h"

#include <algorithm>
#include <set>

namespace udcp {
namespace {

/// The smallest set with `start` that holds, with y, every k from which the mask carries weight to y in a child cell.
template <class S>
std::vector<Place> closed_set(const LatticeMask<S>& mask, const std::vector<Place>& start) {
  std::set<Place> known(start.begin(), start.end());
  std::vector<Place> open = start;
  const auto visit = [&](const Place& point) {  // y + 2 e
    for (int v = 0; v < mask.ny; ++v) {
      for (int u = 0; u < mask.nx; ++u) {
        const Place twice{point.x - mask.x0 - 2 * u, point.y - mask.y0 - 2 * v};
        if (twice.x % 2 != 0 || twice.y % 2 != 0) continue;
        const Place k{twice.x / 2, twice.y / 2};
        if ((k.x - start[0].x) % 2 != 0 || (k.y - start[0].y) % 2 != 0) continue;
        if (is_nonzero(mask.at({point.x - 2 * k.x, point.y - 2 * k.y})) && known.insert(k).second) open.push_back(k);
      }
    }
  };
  while (!open.empty()) {
    const Place y = open.back();
    open.pop_back();
    for (const int ex : {0, 2})
      for (const int ey : {0, 2}) visit({y.x + ex, y.y + ey});
  }
  return {known.begin(), known.end()};
}

bool is_regular_cell(const CellSets& sets, Place cell) {
  bool right = false, left = false;
  const auto visit = [&](int x, int y) {
    right = right || y < 0;
    left = left || x < 0;
  };
  for (const Place& k : sets.position) visit(cell.x + k.x, cell.y + k.y);
  for (const Place& k : sets.du)
    for (const int d : {-1, 1}) visit(cell.x + k.x + d, cell.y + k.y);
  for (const Place& k : sets.dv)
    for (const int d : {-1, 1}) visit(cell.x + k.x, cell.y + k.y + d);
  return !(right && left);
}

std::vector<Place> cells_between(int low, int high) {
  std::vector<Place> result;
  for (int i = 0; i < high; ++i)
    for (int j = 0; j < high; ++j)
      if (std::max(i, j) >= low) result.push_back({2 * i, 2 * j});
  return result;
}

/// The new points, in the frame of sector 0, that the children of the ring's cells depend on.
std::set<Place> new_points(const CellSets& sets, const Ring& ring) {
  std::set<Place> result;
  for (const Place& cell : ring.cells)
    for (const Place& y : sets.position)
      for (const int ex : {0, 2})
        for (const int ey : {0, 2}) result.insert({2 * cell.x + ex + y.x, 2 * cell.y + ey + y.y});
  return result;
}

}  // namespace

template <class S>
CellSets cell_sets(const RegularPart<S>& part, bool dual) {
  if (dual)
    return {closed_set(part.mask, {{1, 1}}), closed_set(part.derivative[0], {{0, 1}, {2, 1}}),
            closed_set(part.derivative[1], {{1, 0}, {1, 2}})};
  return {closed_set(part.mask, {{0, 0}, {2, 0}, {0, 2}, {2, 2}}), closed_set(part.derivative[0], {{1, 0}, {1, 2}}),
          closed_set(part.derivative[1], {{0, 1}, {2, 1}})};
}

std::optional<Ring> ring_of(const CellSets& sets) {
  int reach = 0;
  for (const Place& k : sets.position) reach = std::max({reach, -k.x, -k.y});
  for (int first = 1; first <= 6; ++first) {
    // Cells that are farther out than the sets reach back are regular.
    const std::vector<Place> near = cells_between(first, std::max(first, reach) + 2);
    if (std::all_of(near.begin(), near.end(), [&](const Place& cell) { return is_regular_cell(sets, cell); }))
      return Ring{first, cells_between(first, 2 * first)};
  }
  return std::nullopt;
}

int rows_needed(const Sectors& sectors, const CellSets& sets, const Ring& ring) {
  int result = 0;
  for (const Place& p : new_points(sets, ring)) result = std::max(result, sectors.radius(sectors.label(0, p)));
  return result;
}

int net_needed(const Sectors& sectors, const CellSets& sets, const Ring& ring) {
  int result = 0;
  const auto visit = [&](const Place& p) { result = std::max(result, sectors.radius(sectors.label(0, p))); };
  for (const Place& cell : ring.cells) {
    for (const Place& k : sets.position) visit({cell.x + k.x, cell.y + k.y});
    for (const Place& k : sets.du)
      for (const int d : {-1, 1}) visit({cell.x + k.x + d, cell.y + k.y});
    for (const Place& k : sets.dv)
      for (const int d : {-1, 1}) visit({cell.x + k.x, cell.y + k.y + d});
  }
  return result;
}

namespace {

/// From the second round on, the points that the ring's cells depend on are too far from the centre for their rows to see it.
bool are_grandchildren_far(const Sectors& sectors, const CellSets& sets, const Ring& ring, int reach) {
  for (const Place& cell : ring.cells)
    for (const Place& y : sets.position)
      for (int ex = 0; ex < 8; ex += 2)
        for (int ey = 0; ey < 8; ey += 2)
          if (sectors.radius(sectors.label(0, {4 * cell.x + ex + y.x, 4 * cell.y + ey + y.y})) <= reach) return false;
  return true;
}

}  // namespace

template <class S>
bool rows_are_regular(const Patch<S>& patch, const LatticeMask<S>& mask, const CellSets& sets, const Ring& ring) {
  const Sectors& sectors = patch.sectors;
  const int odd = sectors.dual ? 1 : 0;
  const auto is_regular = [&](const Place& p) {
    Row<S> expected;
    for (int v = 0; v < mask.ny; ++v) {
      for (int u = 0; u < mask.nx; ++u) {
        const S& weight = mask.coefficients[static_cast<std::size_t>(v * mask.nx + u)];
        const Place twice{p.x - mask.x0 - 2 * u, p.y - mask.y0 - 2 * v};
        // twice a place of the lattice: a multiple of 4, or 2 modulo 4 around a face
        if (is_zero(weight) || ((twice.x % 4) + 4) % 4 != 2 * odd || ((twice.y % 4) + 4) % 4 != 2 * odd) continue;
        expected[sectors.label(0, {twice.x / 2, twice.y / 2})] += weight;
      }
    }
    const Label label = sectors.label(0, p);
    const auto actual = patch.rows.find(label.is_centre() ? label : Label{0, label.a, label.b});
    if (actual == patch.rows.end() || actual->second.size() != expected.size()) return false;
    return std::all_of(actual->second.begin(), actual->second.end(), [&](const auto& entry) {
      const auto found = expected.find(sectors.rotated(entry.first, label.s));
      return found != expected.end() && is_zero(S(found->second - entry.second));
    });
  };
  const std::set<Place> points = new_points(sets, ring);
  return are_grandchildren_far(sectors, sets, ring, patch.reach) && std::all_of(points.begin(), points.end(), is_regular);
}

CharacteristicNet::CharacteristicNet(const Patch<Interval>& patch, int invariant, const Eigenpair& pair, int extent)
    : sectors_(patch.sectors) {
  const std::vector<Coordinate> names = coordinates(sectors_, invariant);
  std::vector<Complex> turns;
  for (int s = 0; s < sectors_.valence; ++s) turns.push_back(unit(2 * s, sectors_.valence));
  const auto set = [&](const Label& orbit, const Complex& value) {
    for (int s = 0; s < sectors_.valence; ++s) values_[sectors_.rotated(orbit, s)] = turns[static_cast<std::size_t>(s)] * value;
  };
  values_[Label{}] = {Interval(0), Interval(0)};
  for (const Label& orbit : patch.orbits(invariant)) set(orbit, value_at(patch, 1, orbit, pair.vector, names));
  // Beyond, a row uses smaller radii than its own.
  std::vector<Label> outer = patch.orbits(extent);
  std::erase_if(outer, [&](const Label& l) { return sectors_.radius(l) <= invariant; });
  std::stable_sort(outer.begin(), outer.end(),
                   [&](const Label& a, const Label& b) { return sectors_.radius(a) < sectors_.radius(b); });
  for (const Label& orbit : outer) {
    Complex sum{Interval(0), Interval(0)};
    for (const auto& [label, weight] : patch.rows.at(orbit)) {
      const Complex& value = values_.at(label);
      sum.re += weight * value.re;
      sum.im += weight * value.im;
    }
    set(orbit, {sum.re / pair.value, sum.im / pair.value});
  }
}

const Complex& CharacteristicNet::at(Place place) const { return values_.at(sectors_.label(0, place)); }

template <class S>
bool is_bicubic(const LatticeMask<S>& mask) {
  constexpr std::array<int, 5> cubic{1, 4, 6, 4, 1};
  if (mask.nx != 5 || mask.ny != 5 || mask.x0 != -4 || mask.y0 != -4) return false;
  for (std::size_t k = 0; k < 25; ++k)
    if (!is_zero(S(mask.coefficients[k] - S(cubic[k % 5] * cubic[k / 5]) / S(64)))) return false;
  return true;
}

namespace {

using Grid = std::vector<std::vector<Complex>>;  // [i][j], i along u

/// Bezier points of the bicubic patch over the cell: Q G Q^T.
Grid bezier_points(const CharacteristicNet& net, Place cell) {
  constexpr std::array<std::array<int, 4>, 4> q{{{1, 4, 1, 0}, {0, 4, 2, 0}, {0, 2, 4, 0}, {0, 1, 4, 1}}};
  Grid result(4, std::vector<Complex>(4));
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      for (int k = 0; k < 4; ++k) {
        for (int l = 0; l < 4; ++l) {
          const int weight = q[i][static_cast<std::size_t>(k)] * q[j][static_cast<std::size_t>(l)];
          if (weight == 0) continue;
          const Interval w(Rational(weight) / Rational(36));
          const Complex& point = net.at({cell.x + 2 * (k - 1), cell.y + 2 * (l - 1)});
          result[i][j] = result[i][j] + Complex{w * point.re, w * point.im};
        }
      }
    }
  }
  return result;
}

int binomial(int n, int k) { return k == 0 ? 1 : binomial(n - 1, k - 1) * n / k; }

/// The least Bernstein coefficient of det(d_u, d_v): derivatives of bidegree (2, 3) and (3, 2), their product of bidegree (5, 5).
Interval least_jacobian(const Grid& b) {
  Grid du(3, std::vector<Complex>(4)), dv(4, std::vector<Complex>(3));
  const Interval three(3);
  const auto times_three = [&](const Complex& x) { return Complex{three * x.re, three * x.im}; };
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      du[i][j] = times_three(b[i + 1][j] - b[i][j]);
      dv[j][i] = times_three(b[j][i + 1] - b[j][i]);
    }
  }
  std::vector<Interval> sums(36, Interval(0));
  for (int i = 0; i < 12; ++i) {
    for (int j = 0; j < 12; ++j) {
      const int ui = i / 4, uj = i % 4, vi = j / 3, vj = j % 3;
      const Complex& u = du[static_cast<std::size_t>(ui)][static_cast<std::size_t>(uj)];
      const Complex& v = dv[static_cast<std::size_t>(vi)][static_cast<std::size_t>(vj)];
      const Rational share = Rational(binomial(2, ui) * binomial(3, vi) * binomial(3, uj) * binomial(2, vj)) /
                             Rational(binomial(5, ui + vi) * binomial(5, uj + vj));
      sums[static_cast<std::size_t>(6 * (ui + vi) + uj + vj)] += Interval(share) * (u.re * v.im - u.im * v.re);
    }
  }
  Interval result = sums[0];
  for (const Interval& sum : sums) result = min(result, sum);
  return result;
}

}  // namespace

BernsteinBounds bernstein_bounds(const CharacteristicNet& net) {
  std::optional<BernsteinBounds> result;
  const Complex bisector = unit(1, net.sectors().valence);
  for (const Place& cell : cells_between(1, 2)) {
    const Grid points = bezier_points(net, cell);
    Interval jacobian = least_jacobian(points);
    if (result) jacobian = min(jacobian, result->jacobian);
    Interval half_plane = result ? result->half_plane : Interval(1);
    for (const auto& row : points)
      for (const Complex& point : row) half_plane = min(half_plane, point.re * bisector.re + point.im * bisector.im);
    result = BernsteinBounds{jacobian, half_plane};
  }
  return *result;
}

#define UDCP_INSTANTIATE(S)                                                                             \
  template CellSets cell_sets(const RegularPart<S>&, bool);                                             \
  template bool rows_are_regular(const Patch<S>&, const LatticeMask<S>&, const CellSets&, const Ring&); \
  template bool is_bicubic(const LatticeMask<S>&);
UDCP_INSTANTIATE(Rational)
UDCP_INSTANTIATE(Algebraic)
#undef UDCP_INSTANTIATE

}  // namespace udcp
