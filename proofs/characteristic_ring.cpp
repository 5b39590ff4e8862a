// Hull constants, refinement of cell data, boxes and the two inequalities of the ring.
#include "proofs/characteristic_ring.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace udcp {
namespace {

constexpr double unit_roundoff = 0x1p-53;
// Covers the roundings of bounds that are computed from fewer than 10^5 non-negative doubles.
double inflated(double bound) { return bound * (1 + 1e-10); }

/// A mask in double, every coefficient within `error`.
struct Rounded {
  LatticeMask<double> mask;
  double error = 0;
};

template <class S>
Rounded rounded(const LatticeMask<S>& mask) {
  Rounded result{{mask.x0, mask.y0, mask.nx, mask.ny, {}}, 0};
  for (const S& c : mask.coefficients) {
    const double value = approximate(c);
    result.mask.coefficients.push_back(value);
    if (!is_zero(S(c - number<S>(Rational::from_double(value)))))
      result.error = std::max(result.error, 2 * unit_roundoff * std::abs(value) + std::numeric_limits<double>::min());
  }
  return result;
}

/// The largest sum of moduli over a residue class modulo 2: the sup norm of one round.
double norm_of(const Rounded& scheme) {
  std::array<double, 4> sums{};
  for (int j = 0; j < scheme.mask.ny; ++j)
    for (int i = 0; i < scheme.mask.nx; ++i)
      sums[static_cast<std::size_t>(i % 2 + 2 * (j % 2))] +=
          std::abs(scheme.mask.coefficients[static_cast<std::size_t>(j * scheme.mask.nx + i)]) + scheme.error;
  return inflated(*std::max_element(sums.begin(), sums.end()));
}

std::size_t terms_of(const LatticeMask<double>& mask) {
  return static_cast<std::size_t>((mask.nx + 1) / 2) * static_cast<std::size_t>((mask.ny + 1) / 2);
}

double largest(const LatticeMask<double>& mask) {
  double result = 0;
  for (const double c : mask.coefficients) result = std::max(result, std::abs(c));
  return result;
}

/// After `length` rounds: the error of a coefficient of the mask that iterated() computes in double.
double error_after(const Rounded& scheme, double largest_before, double error_before) {
  const auto terms = static_cast<double>(terms_of(scheme.mask));
  const double norm = norm_of(scheme);
  return inflated(terms * (largest_before + error_before) * scheme.error + norm * error_before +
                  (terms + 2) * unit_roundoff * 2 * norm * largest_before + terms * std::numeric_limits<double>::min());
}

/// Middle and half width of the values of one basis function's data on the window of a subcell, summed over the basis functions:
/// for data in [-1, 1] the limit over the subcell lies within alpha + beta Lambda. The maxima over all subcells.
struct Windows {
  double alpha = 0, beta = 0;
};

Windows windows(const LatticeMask<double>& power, const std::vector<Place>& points, int length) {
  Windows result;
  const int period = 1 << length;
  for (int wy = 0; wy < period; ++wy) {
    for (int wx = 0; wx < period; ++wx) {
      double alpha = 0, beta = 0;
      for (const Place& k : points) {
        double low = std::numeric_limits<double>::infinity(), high = -low;
        for (const Place& y : points) {
          const double value = power.at({y.x + 2 * wx - period * k.x, y.y + 2 * wy - period * k.y});
          low = std::min(low, value);
          high = std::max(high, value);
        }
        alpha += std::abs(low + high) / 2;
        beta += (high - low) / 2;
      }
      result.alpha = std::max(result.alpha, alpha);
      result.beta = std::max(result.beta, beta);
    }
  }
  return result;
}

/// Lambda <= alpha + beta Lambda, and Lambda is finite because the scheme converges.
std::optional<double> hull_constant(const Rounded& scheme, const std::vector<Place>& points) {
  const auto size = static_cast<double>(points.size());
  LatticeMask<double> power = scheme.mask;
  double error = scheme.error;
  std::optional<double> best;
  for (int length = 1; length <= 8 && std::ldexp(size * size, 2 * length) < 5e7; ++length) {
    if (length > 1) {
      error = error_after(scheme, largest(power), error);
      power = iterated(scheme.mask, length);
    }
    const Windows bounds = windows(power, points, length);
    const double alpha = inflated(bounds.alpha + size * error), beta = inflated(bounds.beta + size * error);
    if (beta < 0.99) best = inflated(alpha / (1 - beta));
    if (beta <= 0.5) break;
  }
  return best;
}

template <class S>
bool is_non_negative(const LatticeMask<S>& mask) {
  return std::all_of(mask.coefficients.begin(), mask.coefficients.end(), [](const S& c) { return !(c < S(0)); });
}

}  // namespace

template <class S>
std::optional<CellScheme> CellScheme::of(const LatticeMask<S>& mask, const std::vector<Place>& points,
                                         std::optional<double> hull) {
  const Rounded scheme = rounded(mask);
  CellScheme result;
  result.points_ = points;
  result.error_ = scheme.error;
  result.sum_ = norm_of(scheme);
  result.terms_ = terms_of(scheme.mask);
  if (!is_non_negative(mask)) {
    if (!hull) hull = hull_constant(scheme, points);
    if (!hull) return std::nullopt;
    result.hull_ = *hull;
  }
  for (int number = 0; number < 4; ++number) {
    for (const Place& y : points) {
      std::vector<Weight>& row = result.children_[static_cast<std::size_t>(number)].emplace_back();
      for (std::size_t k = 0; k < points.size(); ++k) {
        const double weight =
            scheme.mask.at({y.x + 2 * (number % 2) - 2 * points[k].x, y.y + 2 * (number / 2) - 2 * points[k].y});
        if (weight != 0) row.push_back({k, weight});
      }
    }
  }
  return result;
}

CellScheme::Data CellScheme::child(const Data& data, int number) const {
  Data result;
  double size = 0;
  for (const auto& value : data.values) size = std::max({size, std::abs(value.real()), std::abs(value.imag())});
  for (const auto& row : children_[static_cast<std::size_t>(number)]) {
    std::complex<double> sum = 0;
    for (const Weight& weight : row) sum += weight.value * data.values[weight.from];
    result.values.push_back(sum);
  }
  const auto terms = static_cast<double>(terms_);
  result.error = inflated(sum_ * data.error + (size + data.error) * terms * error_ +
                          (terms + 2) * unit_roundoff * 2 * sum_ * size + terms * std::numeric_limits<double>::min());
  return result;
}

CellScheme::Box CellScheme::limits(const Data& data, std::complex<double> factor) const {
  const double huge = std::numeric_limits<double>::infinity();
  Box box{{huge, -huge}, {huge, -huge}};
  double size = 0;
  for (const auto& value : data.values) {
    const double re = value.real() * factor.real() - value.imag() * factor.imag();
    const double im = value.real() * factor.imag() + value.imag() * factor.real();
    size = std::max({size, std::abs(value.real()), std::abs(value.imag())});
    box.re = {std::min(box.re[0], re), std::max(box.re[1], re)};
    box.im = {std::min(box.im[0], im), std::max(box.im[1], im)};
  }
  // The turned values are off by at most 2 error (both parts, factor of modulus 1) and a few roundings of their size.
  const double slack = 2 * data.error + 16 * unit_roundoff * size;
  const auto widen = [&](std::array<double, 2>& range) {
    const double middle = (range[0] + range[1]) / 2, half = (range[1] - range[0]) / 2;
    const double radius = inflated(hull_ * (half + slack) + slack);
    range = {middle - radius, middle + radius};
  };
  widen(box.re);
  widen(box.im);
  return box;
}

namespace {

/// One scheme is the other with x and y exchanged: then both have the same constants.
template <class S>
bool are_mirror_images(const LatticeMask<S>& a, const std::vector<Place>& a_points, const LatticeMask<S>& b,
                       std::vector<Place> b_points) {
  if (a.x0 != b.y0 || a.y0 != b.x0 || a.nx != b.ny || a.ny != b.nx || a_points.size() != b_points.size()) return false;
  for (int j = 0; j < a.ny; ++j)
    for (int i = 0; i < a.nx; ++i)
      if (!is_zero(S(a.at({a.x0 + 2 * i, a.y0 + 2 * j}) - b.at({a.y0 + 2 * j, a.x0 + 2 * i})))) return false;
  for (Place& p : b_points) std::swap(p.x, p.y);
  std::sort(b_points.begin(), b_points.end());
  return std::equal(a_points.begin(), a_points.end(), b_points.begin());  // sets are sorted
}

}  // namespace

template <class S>
std::optional<RingTest> RingTest::of(const RegularPart<S>& part, const CellSets& sets) {
  auto position = CellScheme::of(part.mask, sets.position), du = CellScheme::of(part.derivative[0], sets.du);
  if (!du) return std::nullopt;
  const bool mirrored = are_mirror_images(part.derivative[0], sets.du, part.derivative[1], sets.dv);
  auto dv = CellScheme::of(part.derivative[1], sets.dv, mirrored ? std::optional(du->hull()) : std::nullopt);
  if (!position || !dv) return std::nullopt;
  return RingTest(std::move(*position), std::move(*du), std::move(*dv));
}

namespace {

/// Appends an enclosed number as a double and lets the error cover it.
void append(CellScheme::Data& data, const Complex& value) {
  const std::complex<double> middle{value.re.midpoint(), value.im.midpoint()};
  const auto error = [](const Interval& x, double m) { return x.width() + 2 * unit_roundoff * std::abs(m); };
  data.values.push_back(middle);
  data.error = std::max({data.error, inflated(error(value.re, middle.real())), inflated(error(value.im, middle.imag()))});
}

std::complex<double> mean(const CellScheme::Data& data) {
  std::complex<double> sum = 0;
  for (const auto& value : data.values) sum += value;
  return sum / static_cast<double>(data.values.size());
}

}  // namespace

RingTest::Cell RingTest::cell(const CharacteristicNet& net, Place corner) const {
  Cell result;
  const auto value = [&](const Place& k, int dx, int dy) { return net.at({corner.x + k.x + dx, corner.y + k.y + dy}); };
  for (const Place& k : position_.points()) append(result.position, value(k, 0, 0));
  for (const Place& k : du_.points()) append(result.du, value(k, 1, 0) - value(k, -1, 0));
  for (const Place& k : dv_.points()) append(result.dv, value(k, 0, 1) - value(k, 0, -1));
  return result;
}

RingTest::Cell RingTest::child(const Cell& cell, int number) const {
  return {position_.child(cell.position, number), du_.child(cell.du, number), dv_.child(cell.dv, number)};
}

bool RingTest::accepts(const Cell& cell, int valence) const {
  const std::complex<double> direction = mean(cell.du);
  const double length = std::abs(direction);
  if (!std::isfinite(length) || !(length > 0)) return false;
  // Turning both derivatives by the same number of modulus about 1 changes no sign of the Jacobian; the factor is shrunk so that
  // its modulus is below 1.
  const std::complex<double> turn = std::conj(direction) / length * (1 - 1e-12);
  const CellScheme::Box u = du_.limits(cell.du, turn), v = dv_.limits(cell.dv, turn);
  double size = 0, least = std::numeric_limits<double>::infinity(), most = -least;
  const auto largest_of = [](const CellScheme::Box& b) {
    return std::max({std::abs(b.re[0]), std::abs(b.re[1]), std::abs(b.im[0]), std::abs(b.im[1])});
  };
  size = largest_of(u) * largest_of(v);
  for (const double a : u.re)
    for (const double b : v.im) least = std::min(least, a * b);
  for (const double a : u.im)
    for (const double b : v.re) most = std::max(most, a * b);
  if (!(least - most > 1e-13 * size)) return false;
  const Complex bisector = unit(1, valence);
  const std::complex<double> back{bisector.re.midpoint() * (1 - 1e-12), -bisector.im.midpoint() * (1 - 1e-12)};
  const CellScheme::Box image = position_.limits(cell.position, back);
  return image.re[0] > 1e-13 * largest_of(image);
}

double RingTest::typical_jacobian(const Cell& cell) {
  const std::complex<double> u = mean(cell.du), v = mean(cell.dv);
  return u.real() * v.imag() - u.imag() * v.real();
}

#define UDCP_INSTANTIATE(S)                                                                                                   \
  template std::optional<CellScheme> CellScheme::of(const LatticeMask<S>&, const std::vector<Place>&, std::optional<double>); \
  template std::optional<RingTest> RingTest::of(const RegularPart<S>&, const CellSets&);
UDCP_INSTANTIATE(Rational)
UDCP_INSTANTIATE(Algebraic)
#undef UDCP_INSTANTIATE

}  // namespace udcp
