// Dense polynomials on boxes, one variable at a time.
#include "proofs/bernstein.h"

#include <algorithm>

namespace udcp {
namespace {

constexpr std::size_t largest_size = 200'000;

std::size_t size_of(const std::vector<int>& degrees) {
  std::size_t size = 1;
  for (const int d : degrees) {
    size *= static_cast<std::size_t>(d) + 1;
    if (size > largest_size)
      throw Error(ErrorKind::limit, "E_PARAMETRIC_SIZE",
                  "a polynomial in the parameters would have more than " + std::to_string(largest_size) + " coefficients",
                  "use fewer parameters, or parameters of lower degree");
  }
  return size;
}

/// Distance in `coefficients` between neighbours in variable v.
std::size_t stride_of(const std::vector<int>& degrees, std::size_t v) {
  std::size_t stride = 1;
  for (std::size_t k = v + 1; k < degrees.size(); ++k) stride *= static_cast<std::size_t>(degrees[k]) + 1;
  return stride;
}

/// Calls f(first, stride) for every line of coefficients in direction v: entries first, first + stride, ...
template <class F>
void for_lines(const BoxPolynomial& p, std::size_t v, F f) {
  const std::size_t stride = stride_of(p.degrees, v), length = static_cast<std::size_t>(p.degrees[v]) + 1;
  for (std::size_t block = 0; block < p.coefficients.size(); block += stride * length)
    for (std::size_t k = 0; k < stride; ++k) f(block + k, stride);
}

BoxPolynomial with_degrees(const BoxPolynomial& p, const std::vector<int>& degrees) {
  if (p.degrees == degrees) return p;
  BoxPolynomial result{degrees, std::vector<Rational>(size_of(degrees))};
  std::vector<int> index(degrees.size(), 0);
  for (const Rational& c : p.coefficients) {
    std::size_t at = 0;
    for (std::size_t v = 0; v < degrees.size(); ++v)
      at = at * (static_cast<std::size_t>(degrees[v]) + 1) + static_cast<std::size_t>(index[v]);
    result.coefficients[at] = c;
    for (std::size_t v = degrees.size(); v-- > 0;) {
      if (++index[v] <= p.degrees[v]) break;
      index[v] = 0;
    }
  }
  return result;
}

std::vector<int> common_degrees(const BoxPolynomial& a, const BoxPolynomial& b) {
  std::vector<int> degrees(a.degrees.size());
  for (std::size_t v = 0; v < degrees.size(); ++v) degrees[v] = std::max(a.degrees[v], b.degrees[v]);
  return degrees;
}

/// Replaces x_v^j by the polynomial powers[j] (all of length degree + 1).
BoxPolynomial substitute(BoxPolynomial p, std::size_t v, const std::vector<std::vector<Rational>>& powers) {
  const auto length = static_cast<std::size_t>(p.degrees[v]) + 1;
  for_lines(p, v, [&](std::size_t first, std::size_t stride) {
    std::vector<Rational> line(length);
    for (std::size_t j = 0; j < length; ++j) {
      const Rational& c = p.coefficients[first + j * stride];
      if (c.is_zero()) continue;
      for (std::size_t i = 0; i < length; ++i) line[i] += c * powers[j][i];
    }
    for (std::size_t i = 0; i < length; ++i) p.coefficients[first + i * stride] = line[i];
  });
  return p;
}

/// (constant + linear x)^j x^(extra j'), for j = 0 .. degree; extra: the power of x that makes the total degree `degree`.
std::vector<std::vector<Rational>> powers_of(const Rational& constant, const Rational& linear, int degree, bool fill_up) {
  const auto n = static_cast<std::size_t>(degree) + 1;
  std::vector<std::vector<Rational>> result;
  std::vector<Rational> power(n);
  power[0] = Rational(1);
  for (std::size_t j = 0; j < n; ++j) {
    std::vector<Rational> shifted = power;
    if (fill_up) {
      const std::size_t extra = n - 1 - j;
      for (std::size_t i = n; i-- > 0;) shifted[i] = i >= extra ? power[i - extra] : Rational(0);
    }
    result.push_back(std::move(shifted));
    for (std::size_t i = n; i-- > 0;) power[i] = constant * power[i] + (i > 0 ? linear * power[i - 1] : Rational(0));
  }
  return result;
}

BoxPolynomial to_unit_box(BoxPolynomial p, const std::vector<Side>& box) {
  for (std::size_t v = 0; v < box.size(); ++v) {
    const auto powers = powers_of(box[v].lower, box[v].upper - box[v].lower, p.degrees[v], false);
    p = substitute(std::move(p), v, powers);
  }
  return p;
}

/// Power basis on [0, 1] to Bernstein basis: b_i = sum_{j <= i} C(i, j)/C(d, j) a_j.
BoxPolynomial to_bernstein(BoxPolynomial p) {
  for (std::size_t v = 0; v < p.degrees.size(); ++v) {
    const auto d = static_cast<std::size_t>(p.degrees[v]);
    for_lines(p, v, [&](std::size_t first, std::size_t stride) {
      // Differences are cheaper than binomials: with a_j / C(d, j) in place, d rounds of sums.
      Rational binomial(1);
      for (std::size_t j = 0; j <= d; ++j) {
        p.coefficients[first + j * stride] /= binomial;
        binomial = binomial * Rational(static_cast<int>(d - j)) / Rational(static_cast<int>(j) + 1);
      }
      for (std::size_t round = 1; round <= d; ++round)
        for (std::size_t j = d; j >= round; --j) p.coefficients[first + j * stride] += p.coefficients[first + (j - 1) * stride];
    });
  }
  return p;
}

enum class Part { inside, lower, upper };

/// Some coefficient on the face given by `parts` is not 0.
bool some_on_face(const BoxPolynomial& b, const std::vector<Part>& parts) {
  std::vector<int> index(b.degrees.size(), 0);
  for (const Rational& c : b.coefficients) {
    bool on = !c.is_zero();
    for (std::size_t v = 0; on && v < parts.size(); ++v)
      on = parts[v] == Part::inside || index[v] == (parts[v] == Part::lower ? 0 : b.degrees[v]);
    if (on) return true;
    for (std::size_t v = b.degrees.size(); v-- > 0;) {
      if (++index[v] <= b.degrees[v]) break;
      index[v] = 0;
    }
  }
  return false;
}

bool positive_on_faces(const BoxPolynomial& b, const std::vector<Side>& box, std::vector<Part>& parts) {
  const std::size_t v = parts.size();
  if (v == box.size()) return some_on_face(b, parts);
  for (const Part part : {Part::inside, Part::lower, Part::upper}) {
    const bool point = box[v].lower == box[v].upper;
    if ((part == Part::lower && box[v].lower_open) || (part == Part::upper && box[v].upper_open)) continue;
    if (part == Part::inside && point) continue;
    parts.push_back(part);
    const bool good = positive_on_faces(b, box, parts);
    parts.pop_back();
    if (!good) return false;
  }
  return true;
}

}  // namespace

BoxPolynomial BoxPolynomial::constant(const Rational& value, std::size_t variables) {
  return {std::vector<int>(variables, 0), {value}};
}

bool BoxPolynomial::is_zero() const {
  return std::all_of(coefficients.begin(), coefficients.end(), [](const Rational& c) { return c.is_zero(); });
}

Rational BoxPolynomial::at(const std::vector<Rational>& point) const {
  std::vector<Rational> values = coefficients;
  for (std::size_t v = degrees.size(); v-- > 0;) {  // Horner, the last variable first
    const auto length = static_cast<std::size_t>(degrees[v]) + 1;
    std::vector<Rational> next(values.size() / length);
    for (std::size_t k = 0; k < next.size(); ++k)
      for (std::size_t j = length; j-- > 0;) next[k] = next[k] * point[v] + values[k * length + j];
    values = std::move(next);
  }
  return values.front();
}

BoxPolynomial operator+(const BoxPolynomial& a, const BoxPolynomial& b) {
  const std::vector<int> degrees = common_degrees(a, b);
  BoxPolynomial result = with_degrees(a, degrees);
  const BoxPolynomial other = with_degrees(b, degrees);
  for (std::size_t k = 0; k < result.coefficients.size(); ++k) result.coefficients[k] += other.coefficients[k];
  return result;
}

BoxPolynomial operator*(const Rational& factor, BoxPolynomial a) {
  for (Rational& c : a.coefficients) c *= factor;
  return a;
}

BoxPolynomial operator-(const BoxPolynomial& a, const BoxPolynomial& b) { return a + Rational(-1) * b; }

BoxPolynomial operator*(const BoxPolynomial& a, const BoxPolynomial& b) {
  std::vector<int> degrees(a.degrees.size());
  for (std::size_t v = 0; v < degrees.size(); ++v) degrees[v] = a.degrees[v] + b.degrees[v];
  BoxPolynomial result{degrees, std::vector<Rational>(size_of(degrees))};
  // In one common layout the index of a product is the sum of the indices.
  const BoxPolynomial wide = with_degrees(a, degrees), other = with_degrees(b, degrees);
  for (std::size_t i = 0; i < wide.coefficients.size(); ++i) {
    if (wide.coefficients[i].is_zero()) continue;
    for (std::size_t j = 0; j < other.coefficients.size(); ++j) {
      if (!other.coefficients[j].is_zero()) result.coefficients[i + j] += wide.coefficients[i] * other.coefficients[j];
    }
  }
  return result;
}

Side finite_side(const ParameterRange& range) {
  if (range.lower && range.upper) return {*range.lower, *range.upper, range.lower_open, range.upper_open};
  if (!range.lower && !range.upper)
    throw Error(ErrorKind::input, "E_DOMAIN", "the range of '" + range.name + "' has no end at all", "split it at 0");
  // g = 0 is infinity, g = 1 the finite end
  return {Rational(0), Rational(1), true, range.lower ? range.lower_open : range.upper_open};
}

BoxPolynomial in_finite_coordinates(BoxPolynomial p, const ParameterBox& box) {
  for (std::size_t v = 0; v < box.size(); ++v) {
    if (box[v].lower && box[v].upper) continue;
    // x = (s g + t)/g with t = 1 (from lower) or -1 (from upper); x^j g^d = (t + s g)^j g^(d - j)
    const bool up = box[v].lower.has_value();
    const Rational s = up ? *box[v].lower - Rational(1) : *box[v].upper + Rational(1);
    const auto powers = powers_of(Rational(up ? 1 : -1), s, p.degrees[v], true);
    p = substitute(std::move(p), v, powers);
  }
  return p;
}

Rational from_finite(const ParameterRange& range, const Rational& value) {
  if (range.lower && range.upper) return value;
  return range.lower ? *range.lower - Rational(1) + Rational(1) / value : *range.upper + Rational(1) - Rational(1) / value;
}

bool non_negative_on(const BoxPolynomial& p, const std::vector<Side>& box) {
  const BoxPolynomial b = to_bernstein(to_unit_box(p, box));
  return std::all_of(b.coefficients.begin(), b.coefficients.end(), [](const Rational& c) { return c.sign() >= 0; });
}

bool positive_on(const BoxPolynomial& p, const std::vector<Side>& box) {
  const BoxPolynomial b = to_bernstein(to_unit_box(p, box));
  if (!std::all_of(b.coefficients.begin(), b.coefficients.end(), [](const Rational& c) { return c.sign() >= 0; })) return false;
  std::vector<Part> parts;
  return positive_on_faces(b, box, parts);
}

}  // namespace udcp
