// Nets of regular patches: the cubic mask of the running word in both directions, and the B-spline basis that it has.
#include "proofs/regularity/bicubic_net.h"

#include "operators/matrix.h"
#include "operators/schemes.h"
#include "proofs/certificate.h"

namespace udcp {
namespace {

/// Row e: weights of the four old points at the new point e, times 8; from the mask of a round on regular points.
using Refinement = std::array<std::array<Rational, 4>, 5>;
const Refinement& refinement() {
  static const Refinement rows = [] {
    const Mask<Rational> cubic = mask<Rational>(schemes::catmull_clark());
    Refinement result;
    for (int e = 0; e < 5; ++e) {
      for (int i = 0; i < 4; ++i) {
        const int k = e + 1 - 2 * i - cubic.first;  // the new point 2i lies at the old point i
        const bool inside = k >= 0 && k < static_cast<int>(cubic.coefficients.size());
        result[static_cast<std::size_t>(e)][static_cast<std::size_t>(i)] =
            inside ? Rational(8) * cubic.coefficients[static_cast<std::size_t>(k)] : Rational(0);
      }
    }
    return result;
  }();
  return rows;
}

void add_multiple(Vector3& to, const Rational& weight, const Vector3& from) {
  if (weight.is_zero()) return;
  for (std::size_t c = 0; c < 3; ++c)
    if (!from[c].is_zero()) to[c] += weight * from[c];
}

/// sum of weights[i] line[i * stride]
template <std::size_t N>
Vector3 combination(const std::array<Rational, N>& weights, const Vector3* line, std::size_t stride) {
  Vector3 sum{};
  for (std::size_t i = 0; i < N; ++i) add_multiple(sum, weights[i], line[i * stride]);
  return sum;
}

/// The 5 x 5 refined points.
std::array<Vector3, 25> refined(const BicubicNet& net) {
  const Refinement& rows = refinement();
  std::array<Vector3, 20> in_v;  // 5 rows of 4
  for (std::size_t e = 0; e < 5; ++e)
    for (std::size_t j = 0; j < 4; ++j) in_v[4 * e + j] = combination(rows[e], net.points.data() + j, 4);
  std::array<Vector3, 25> result;
  for (std::size_t e = 0; e < 5; ++e)
    for (std::size_t g = 0; g < 5; ++g) result[5 * e + g] = combination(rows[g], in_v.data() + 4 * e, 1);
  return result;
}

BicubicNet cut(const BicubicNet& net, const std::array<Vector3, 25>& points, int number) {
  const int r = number / 2, c = number % 2;
  BicubicNet result;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) result.at(i, j) = points[static_cast<std::size_t>(5 * (r + i) + c + j)];
  const auto keep = [&](PatchSide side, bool kept) {
    result.flagged[static_cast<std::size_t>(side)] = kept && net.is_flagged(side);
  };
  keep(PatchSide::bottom, r == 0);
  keep(PatchSide::top, r == 1);
  keep(PatchSide::left, c == 0);
  keep(PatchSide::right, c == 1);
  return result;
}

/// Which rows (or columns) of a net carry differences along them, and which steps across rows they take: all, but not the
/// reflected ones.
struct Extent {
  int first_line = 0, last_line = 3, first_step = 0, last_step = 2;
};
/// low, high: the flagged sides where lines end; before, after: where steps end.
Extent extent(bool low, bool high, bool before, bool after) { return {low ? 1 : 0, high ? 2 : 3, before ? 1 : 0, after ? 1 : 2}; }

Extent extent_u(const BicubicNet& net) {
  return extent(net.is_flagged(PatchSide::bottom), net.is_flagged(PatchSide::top), net.is_flagged(PatchSide::left),
                net.is_flagged(PatchSide::right));
}
Extent extent_v(const BicubicNet& net) {
  return extent(net.is_flagged(PatchSide::left), net.is_flagged(PatchSide::right), net.is_flagged(PatchSide::bottom),
                net.is_flagged(PatchSide::top));
}

Vector3 step_u(const BicubicNet& net, int row, int column) { return net.at(row, column + 1) - net.at(row, column); }
Vector3 step_v(const BicubicNet& net, int row, int column) { return net.at(row + 1, column) - net.at(row, column); }

/// Whether some difference is not zero in the stencil of the corner at this line and position p (1 or 2 each): three lines and
/// two steps, on a boundary the boundary line alone, and at the end of a line the one step inside.
template <class Step>
bool has_nonzero(const Extent& e, int line, int p, Step step) {
  const bool on_boundary = (line == 1 && e.first_line == 1) || (line == 2 && e.last_line == 2);
  const int first = on_boundary ? line : line - 1, last = on_boundary ? line : line + 1;
  for (int k = first; k <= last; ++k)
    for (int s = std::max(p - 1, e.first_step); s <= std::min(p, e.last_step); ++s)
      if (!is_zero(step(k, s))) return true;
  return false;
}

}  // namespace

void reflect(BicubicNet& net) {
  const bool bottom = net.is_flagged(PatchSide::bottom), top = net.is_flagged(PatchSide::top);
  const auto reflected = [](const Vector3& first, const Vector3& second) { return Rational(2) * first - second; };
  for (int i = bottom ? 1 : 0; i <= (top ? 2 : 3); ++i) {
    if (net.is_flagged(PatchSide::left)) net.at(i, 0) = reflected(net.at(i, 1), net.at(i, 2));
    if (net.is_flagged(PatchSide::right)) net.at(i, 3) = reflected(net.at(i, 2), net.at(i, 1));
  }
  for (int j = 0; j < 4; ++j) {
    if (bottom) net.at(0, j) = reflected(net.at(1, j), net.at(2, j));
    if (top) net.at(3, j) = reflected(net.at(2, j), net.at(1, j));
  }
}

BicubicNet child(const BicubicNet& net, int number) { return cut(net, refined(net), number); }

std::array<BicubicNet, 4> children(const BicubicNet& net) {
  const std::array<Vector3, 25> points = refined(net);
  return {cut(net, points, 0), cut(net, points, 1), cut(net, points, 2), cut(net, points, 3)};
}

BicubicNet descendant(BicubicNet net, const std::string& path) {
  require(path.size() <= 60, "a path has more than 60 steps");
  for (const char digit : path) {
    require(digit >= '0' && digit <= '3', "a path must consist of the digits 0 to 3");
    net = child(net, digit - '0');
  }
  return net;
}

CornerValues corner(const BicubicNet& net, int r, int c) {
  const std::array<Rational, 3> value = {1, 4, 1}, slope = {-1, 0, 1};
  const auto tensor = [&](const std::array<Rational, 3>& in_v, const std::array<Rational, 3>& in_u) {
    Vector3 sum{};
    for (std::size_t i = 0; i < 3; ++i) add_multiple(sum, in_v[i], combination(in_u, &net.at(r + static_cast<int>(i), c), 1));
    return sum;
  };
  return {tensor(value, value), tensor(value, slope), tensor(slope, value)};
}

Differences differences(const BicubicNet& net) {
  Differences result;
  const Extent u = extent_u(net), v = extent_v(net);
  for (int i = u.first_line; i <= u.last_line; ++i)
    for (int j = u.first_step; j <= u.last_step; ++j) result.u.push_back(step_u(net, i, j));
  for (int i = v.first_step; i <= v.last_step; ++i)
    for (int j = v.first_line; j <= v.last_line; ++j) result.v.push_back(step_v(net, i, j));
  return result;
}

bool has_full_corners(const BicubicNet& net) {
  const Extent u = extent_u(net), v = extent_v(net);
  for (int r = 1; r <= 2; ++r) {
    for (int c = 1; c <= 2; ++c) {
      if (!has_nonzero(u, r, c, [&](int row, int column) { return step_u(net, row, column); })) return false;
      if (!has_nonzero(v, c, r, [&](int column, int row) { return step_v(net, row, column); })) return false;
    }
  }
  return true;
}

BicubicNet bezier(const BicubicNet& net) {
  static const std::array<std::array<Rational, 4>, 4> rows = {{{{1, 4, 1, 0}}, {{0, 4, 2, 0}}, {{0, 2, 4, 0}}, {{0, 1, 4, 1}}}};
  BicubicNet in_v, result;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j) in_v.points[4 * i + j] = combination(rows[i], net.points.data() + j, 4);
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j) result.points[4 * i + j] = combination(rows[j], in_v.points.data() + 4 * i, 1);
  result.flagged = net.flagged;
  return result;
}

std::array<Vector3, 36> normal_net(const BicubicNet& net) {
  static constexpr std::array<int, 3> square = {1, 2, 1};
  static constexpr std::array<int, 4> cube = {1, 3, 3, 1};
  static constexpr std::array<int, 6> share = {10, 2, 1, 1, 2, 10};  // 10 / binomial(5, k)
  const BicubicNet b = bezier(net);
  std::array<Vector3, 36> result{};
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 3; ++j) {
      const Vector3 u = step_u(b, i, j);
      if (is_zero(u)) continue;
      for (int p = 0; p < 3; ++p) {
        for (int q = 0; q < 4; ++q) {
          const auto at = [](const auto& list, int k) { return list[static_cast<std::size_t>(k)]; };
          const int k = j + q, l = i + p;
          const int weight = at(square, j) * at(cube, q) * at(share, k) * at(cube, i) * at(square, p) * at(share, l);
          add_multiple(result[static_cast<std::size_t>(6 * l + k)], Rational(weight), cross(u, step_v(b, p, q)));
        }
      }
    }
  }
  return result;
}

}  // namespace udcp
