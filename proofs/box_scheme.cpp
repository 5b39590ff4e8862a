// Masks in parameters, divided exactly, and their norms over cells by Bernstein coefficients.
#include "proofs/box_scheme.h"

#include <algorithm>

#include "operators/matrix.h"

namespace udcp {
namespace {

BoxPolynomial on_box(const ParametricPolynomial& p, const ParameterBox& box) {
  std::vector<int> degrees;
  for (const ParameterRange& range : box) degrees.push_back(std::max(0, p.degree(range.name)));
  for (const std::string& name : p.names) {
    const bool known = std::any_of(box.begin(), box.end(), [&](const ParameterRange& r) { return r.name == name; });
    require(known, "the parameter '" + name + "' has no domain");
  }
  BoxPolynomial result = BoxPolynomial::constant(Rational(0), box.size());
  for (const ParametricPolynomial::Term& term : p.terms) {
    std::vector<int> exponents(box.size(), 0);
    for (std::size_t v = 0; v < p.names.size(); ++v) {
      for (std::size_t k = 0; k < box.size(); ++k) {
        if (box[k].name == p.names[v]) exponents[k] = term.exponents[v];
      }
    }
    std::size_t size = 1;
    for (const int e : exponents) {
      size *= static_cast<std::size_t>(e) + 1;
      require(size <= 200'000, "a parameter stands in too high a power");
    }
    BoxPolynomial monomial{exponents, std::vector<Rational>(size)};
    monomial.coefficients.back() = term.coefficient;
    result = result + monomial;
  }
  // All polynomials of a scheme get the same degrees, so that one change of variables has the same factor for all of them.
  return result;
}

BoxPolynomial raised(const BoxPolynomial& p, const std::vector<int>& degrees) {
  std::size_t size = 1;
  for (const int d : degrees) {
    size *= static_cast<std::size_t>(d) + 1;
    require(size <= 200'000, "the parameters stand in too high powers");
  }
  return p + BoxPolynomial{degrees, std::vector<Rational>(size)};
}

ParametricPolynomial common_denominator(const std::vector<Parametric>& values) {
  ParametricPolynomial common(Rational(1));
  for (const Parametric& value : values) {
    const ParametricPolynomial d = value.denominator();
    if (divide_exactly(common, d)) continue;
    common = *divide_exactly(common * d, gcd(common, d));
  }
  return common;
}

/// Division by 1 + z + ... + z^{A-1}; Rejected if it leaves a remainder.
std::vector<Parametric> divided(std::vector<Parametric> a, int arity, int order) {
  const auto n = static_cast<std::size_t>(arity);
  std::vector<Parametric> quotient;
  for (std::size_t k = 0; k + n <= a.size(); ++k) {
    const Parametric q = a[k];
    for (std::size_t j = 0; j < n; ++j) a[k + j] -= q;
    quotient.push_back(q);
  }
  const bool exact = std::all_of(a.begin(), a.end(), [](const Parametric& c) { return c.is_zero(); });
  require(exact, "the mask satisfies sum rules of order " + std::to_string(order) + " only");
  return quotient;
}

/// The sign that p keeps on the box, by bisection to a small depth; 0 if that does not show one.
int sign_on(const BoxPolynomial& p, std::vector<Side> box, int depth) {
  if (positive_on(p, box)) return 1;
  if (positive_on(Rational(-1) * p, box)) return -1;
  if (depth == 0) return 0;
  std::size_t longest = 0;
  for (std::size_t v = 1; v < box.size(); ++v) {
    if (box[v].upper - box[v].lower > box[longest].upper - box[longest].lower) longest = v;
  }
  const Side whole = box[longest];
  const Rational middle = (whole.lower + whole.upper) / Rational(2);
  box[longest] = {whole.lower, middle, whole.lower_open, false};
  const int low = sign_on(p, box, depth - 1);
  if (low == 0) return 0;
  box[longest] = {middle, whole.upper, false, whole.upper_open};
  return sign_on(p, box, depth - 1) == low ? low : 0;
}

/// Every parameter of the word has a value everywhere on the box; in the masks its poles may cancel.
void require_values_on(const Word& word, const ParameterBox& box) {
  std::vector<Side> sides;
  for (const ParameterRange& range : box) sides.push_back(finite_side(range));
  for (const Item& item : word.tail) {
    for (const KernelPtr& kernel : {item.f.plain, item.omega.plain, item.omega_face, item.delta}) {
      if (!kernel) continue;
      const Parametric value = kernel->at(Context<Parametric>{{}, word.triangles ? 6 : 4, 0, -1, nullptr}).value();
      if (value.is_constant()) continue;
      const BoxPolynomial denominator = in_finite_coordinates(on_box(value.denominator(), box), box);
      require(sign_on(denominator, sides, 8) != 0,
              "a parameter of the word is not shown to have values everywhere on the domain");
    }
  }
}

/// sum |entries| < bound on the cell. Entries without a sign there are tried with both.
bool sum_below(std::vector<BoxPolynomial> entries, const BoxPolynomial& bound, const std::vector<Side>& cell) {
  BoxPolynomial rest = bound;
  std::vector<BoxPolynomial> open;
  for (BoxPolynomial& entry : entries) {
    if (entry.is_zero()) continue;
    if (non_negative_on(entry, cell)) {
      rest = rest - entry;
    } else if (non_negative_on(Rational(-1) * entry, cell)) {
      rest = rest + entry;
    } else {
      open.push_back(std::move(entry));
    }
  }
  if (open.size() > 8) return false;
  for (std::size_t signs = 0; signs < (std::size_t{1} << open.size()); ++signs) {
    BoxPolynomial difference = rest;
    for (std::size_t k = 0; k < open.size(); ++k)
      difference = (signs >> k & 1U) != 0 ? difference + open[k] : difference - open[k];
    if (!positive_on(difference, cell)) return false;
  }
  return true;
}

}  // namespace

BoxScheme difference_scheme_on_box(const Word& word, int smoothness, const ParameterBox& box) {
  require_values_on(word, box);
  const Mask<Parametric> symbolic = mask<Parametric>(word);
  BoxScheme scheme;
  scheme.arity = symbolic.arity;
  scheme.smoothness = smoothness;
  for (const ParameterRange& range : box) scheme.box.push_back(finite_side(range));
  require(symbolic.arity >= 2, "a word without U makes no difference scheme");
  std::vector<Parametric> c = symbolic.coefficients;
  for (int j = 0; j <= smoothness; ++j) c = divided(std::move(c), symbolic.arity, j);
  require(!c.empty(), "the mask is 0");
  const ParametricPolynomial common = common_denominator(c);
  const Parametric factor = Parametric::quotient(common, ParametricPolynomial(Rational(1)));
  std::vector<BoxPolynomial> all{on_box(common, box)};
  for (const Parametric& entry : c) {
    const Parametric numerator = entry * factor;
    all.push_back(Rational(1) / numerator.denominator().constant() * on_box(numerator.numerator(), box));
  }
  std::vector<int> degrees(box.size(), 0);
  for (const BoxPolynomial& p : all) {
    for (std::size_t v = 0; v < box.size(); ++v) degrees[v] = std::max(degrees[v], p.degrees[v]);
  }
  for (BoxPolynomial& p : all) p = in_finite_coordinates(raised(p, degrees), box);
  const int sign = sign_on(all.front(), scheme.box, 8);
  require(sign != 0, "the common denominator of the weights is not shown to keep its sign on the domain");
  scheme.denominator = Rational(sign) * all.front();
  for (std::size_t k = 1; k < all.size(); ++k) scheme.numerators.push_back(Rational(sign) * all[k]);
  return scheme;
}

bool contracts_on(const BoxScheme& scheme, int length, const std::vector<Side>& cell) {
  const std::size_t variables = scheme.box.size();
  std::vector<BoxPolynomial> product = scheme.numerators;
  BoxPolynomial denominator = scheme.denominator;
  long power = scheme.arity;
  for (int l = 1; l < length; ++l, power *= scheme.arity) {  // times c(z^{A^l})
    const auto step = static_cast<std::size_t>(power);
    const std::size_t size = product.size() + step * (scheme.numerators.size() - 1);
    if (size > 5000) return false;
    std::vector<BoxPolynomial> next(size, BoxPolynomial::constant(Rational(0), variables));
    for (std::size_t i = 0; i < product.size(); ++i) {
      for (std::size_t j = 0; j < scheme.numerators.size(); ++j)
        next[i + step * j] = next[i + step * j] + product[i] * scheme.numerators[j];
    }
    product = std::move(next);
    denominator = denominator * scheme.denominator;
  }
  Rational scale(1);
  for (int l = 0; l < length * scheme.smoothness; ++l) scale *= Rational(scheme.arity);
  const BoxPolynomial bound = Rational(1) / scale * denominator;
  const auto residues = static_cast<std::size_t>(power);
  for (std::size_t r = 0; r < residues && r < product.size(); ++r) {
    std::vector<BoxPolynomial> entries;
    for (std::size_t i = r; i < product.size(); i += residues) entries.push_back(product[i]);
    if (!sum_below(std::move(entries), bound, cell)) return false;
  }
  return true;
}

ScaledTransitions transitions_at(const BoxScheme& scheme, const std::vector<Rational>& point) {
  std::vector<Rational> c;
  for (const BoxPolynomial& p : scheme.numerators) c.push_back(p.at(point));
  const int n = static_cast<int>(c.size()) - 1, a = scheme.arity;
  const int size = std::max(1, (n + a - 2) / (a - 1));
  ScaledTransitions result;
  result.denominator = scheme.denominator.at(point);
  for (int e = 0; e < a; ++e) {
    Points<Rational> t = Points<Rational>::Zero(size, size);
    for (int row = 0; row < size; ++row) {
      for (int column = 0; column < size; ++column) {
        const int index = a * column + e - row;
        if (index >= 0 && index <= n) t(row, column) = c[static_cast<std::size_t>(index)];
      }
    }
    result.matrices.push_back(std::move(t));
  }
  return result;
}

bool is_multi_affine(const BoxScheme& scheme) {
  const auto affine = [](const BoxPolynomial& p) {
    return std::all_of(p.degrees.begin(), p.degrees.end(), [](int d) { return d <= 1; });
  };
  return affine(scheme.denominator) && std::all_of(scheme.numerators.begin(), scheme.numerators.end(), affine);
}

std::vector<std::vector<Rational>> corners_of(const std::vector<Side>& cell) {
  std::vector<std::vector<Rational>> corners{{}};
  for (const Side& side : cell) {
    std::vector<std::vector<Rational>> next;
    for (const std::vector<Rational>& corner : corners) {
      for (const Rational& end : {side.lower, side.upper}) {
        next.push_back(corner);
        next.back().push_back(end);
      }
    }
    corners = std::move(next);
  }
  return corners;
}

}  // namespace udcp
