// Exact checks of bounds of joint spectral radii.
#include "proofs/polytope.h"

#include <algorithm>

#include "proofs/linear_algebra.h"

namespace udcp {
namespace {

using Index = Eigen::Index;

int window(int arity, std::size_t coefficients) {
  const int last = static_cast<int>(coefficients) - 1;
  return std::max(1, (last + arity - 2) / (arity - 1));
}

template <class S>
S moduli(const Polytope::Combination& combination) {
  S sum(0);
  for (const auto& [vector, weight] : combination) sum += abs(S(weight));
  return sum;
}

void check_shape(const Polytope& polytope, std::size_t n, std::size_t matrices) {
  const std::size_t count = polytope.vectors.size();
  for (const auto& vector : polytope.vectors)
    require(vector.size() == n, "the vectors of the polytope need " + std::to_string(n) + " entries");
  require(polytope.units.size() == n, "the polytope needs a combination for every unit vector");
  require(polytope.images.size() == matrices, "the polytope needs images for each of the matrices");
  const auto check = [&](const Polytope::Combination& combination) {
    for (const auto& [vector, weight] : combination)
      require(vector >= 0 && vector < static_cast<int>(count), "a combination names a vector that the polytope has not");
  };
  for (const auto& combination : polytope.units) check(combination);
  for (const auto& images : polytope.images) {
    require(images.size() == count, "the polytope needs an image of each of its vectors");
    for (const auto& combination : images) check(combination);
  }
}

}  // namespace

template <class S>
std::int64_t transition_size(const Mask<S>& mask) {
  const std::int64_t m = window(mask.arity, mask.coefficients.size());
  return m * m * mask.arity;
}

template <class S>
std::vector<Points<S>> transition_matrices(const Mask<S>& mask) {
  const int m = window(mask.arity, mask.coefficients.size()), size = static_cast<int>(mask.coefficients.size());
  std::vector<Points<S>> result;
  for (int e = 0; e < mask.arity; ++e) {
    Points<S> matrix = Points<S>::Zero(m, m);
    for (int s = 0; s < m; ++s) {
      for (int t = 0; t < m; ++t) {
        const int k = mask.arity * t + e - s;
        if (k >= 0 && k < size) matrix(s, t) = mask.coefficients[static_cast<std::size_t>(k)];
      }
    }
    result.push_back(std::move(matrix));
  }
  return result;
}

template <class S>
Points<S> product(const std::vector<Points<S>>& matrices, const std::vector<int>& letters) {
  Points<S> result = Points<S>::Identity(matrices.front().rows(), matrices.front().rows());
  for (const int e : letters) result = (result * matrices[static_cast<std::size_t>(e)]).eval();
  return result;
}

template <class S>
bool zeros_within(const Polynomial<S>& p, const S& radius) {
  if (p.is_zero() || radius.sign() <= 0) return false;
  std::vector<S> c = p.coefficients;  // of p(radius z), made monic, highest first
  S power(1);
  for (S& value : c) {
    value *= power;
    power *= radius;
  }
  std::reverse(c.begin(), c.end());
  const S lead = S(1) / c.front();
  for (S& value : c) value *= lead;
  while (c.size() > 1) {
    const S last = c.back(), defect = S(1) - last * last;
    if (defect.sign() <= 0) return false;
    std::vector<S> next;
    const S scale = S(1) / defect;
    for (std::size_t k = 0; k + 1 < c.size(); ++k) next.push_back((c[k] - last * c[c.size() - 1 - k]) * scale);
    c = std::move(next);
  }
  return true;
}

template <class S>
bool product_reaches(const std::vector<Points<S>>& matrices, const std::vector<int>& letters, const S& bound) {
  if (matrices.front().rows() > most_rows) return false;
  S radius(1);
  for (std::size_t k = 0; k < letters.size(); ++k) radius *= bound;
  return !zeros_within(characteristic_polynomial(product(matrices, letters)), radius);
}

template <class S>
S rest_of(const Polytope& polytope, const Polytope::Combination& combination, const std::vector<S>& x) {
  S sum(0);
  for (std::size_t i = 0; i < x.size(); ++i) {
    Rational combined(0);
    for (const auto& [vector, weight] : combination) combined += weight * polytope.vectors[static_cast<std::size_t>(vector)][i];
    sum += abs(S(x[i] - S(combined)));
  }
  return sum;
}

Rational reach_of(const Polytope& polytope, std::size_t dimension) {
  Rational rest(0), most(0);
  for (std::size_t i = 0; i < dimension; ++i) {
    std::vector<Rational> unit(dimension, Rational(0));
    unit[i] = Rational(1);
    rest = std::max(rest, rest_of(polytope, polytope.units[i], unit));
    most = std::max(most, moduli<Rational>(polytope.units[i]));
  }
  require(rest < Rational(1), "the polytope does not show that its vectors span the space");
  return most / (Rational(1) - rest);
}

template <class S>
void check_polytope(const std::vector<Points<S>>& matrices, const Polytope& polytope) {
  const auto n = static_cast<std::size_t>(matrices.front().rows());
  check_shape(polytope, n, matrices.size());
  const S reach(reach_of(polytope, n)), bound(polytope.bound);
  for (std::size_t e = 0; e < matrices.size(); ++e) {
    for (std::size_t k = 0; k < polytope.vectors.size(); ++k) {
      std::vector<S> image(n, S(0));
      for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j)
          image[i] += matrices[e](static_cast<Index>(i), static_cast<Index>(j)) * S(polytope.vectors[k][j]);
      const Polytope::Combination& combination = polytope.images[e][k];
      require(moduli<S>(combination) + reach * rest_of(polytope, combination, image) <= bound,
              "matrix " + std::to_string(e) + " takes vector " + std::to_string(k) +
                  " out of the polytope, as far as its combination shows");
    }
  }
}

template <class S>
bool polytope_holds(const std::vector<Points<S>>& matrices, const Polytope& polytope) {
  try {
    check_polytope(matrices, polytope);
  } catch (const Rejected&) {
    return false;
  }
  return true;
}

Json to_json(const Polytope& polytope) {
  const auto text = [](const std::vector<Polytope::Combination>& combinations) {
    Json result = Json::array();
    for (const Polytope::Combination& combination : combinations) {
      Json terms = Json::object();
      for (const auto& [vector, weight] : combination) terms[std::to_string(vector)] = to_json(weight);
      result.push_back(std::move(terms));
    }
    return result;
  };
  Json vectors = Json::array(), images = Json::array();
  for (const auto& vector : polytope.vectors) vectors.push_back(to_json(vector));
  for (const auto& of_matrix : polytope.images) images.push_back(text(of_matrix));
  return {{"kind", "polytope"},
          {"bound", to_json(polytope.bound)},
          {"vectors", std::move(vectors)},
          {"units", text(polytope.units)},
          {"images", std::move(images)}};
}

Polytope polytope_from(const Json& json) {
  require_entries(json, {"kind", "bound", "vectors", "units", "images"}, "the polytope");
  require(entry(json, "kind") == "polytope", "the kind of the bound is not \"polytope\"");
  const auto combinations = [](const Json& list) {
    require(list.is_array(), "combinations come in lists");
    std::vector<Polytope::Combination> result;
    for (const Json& terms : list) {
      require(terms.is_object(), "a combination maps vectors to weights");
      Polytope::Combination& combination = result.emplace_back();
      for (const auto& [name, weight] : terms.items()) {
        const int before = combination.empty() ? -1 : combination.back().vector;
        require(!name.empty() && name.size() < 7 && name.find_first_not_of("0123456789") == std::string::npos,
                "a combination names its vectors by numbers");
        combination.push_back({std::stoi(name), rational_from(weight, "a weight")});
        require(std::to_string(combination.back().vector) == name && combination.back().vector > before,
                "a combination names its vectors in rising order");
        require(!combination.back().weight.is_zero(), "a weight is zero");
      }
    }
    return result;
  };
  require(entry(json, "vectors").is_array() && entry(json, "images").is_array(), "vectors and images of the polytope are lists");
  Polytope result{rational_from(entry(json, "bound"), "bound"), {}, combinations(entry(json, "units")), {}};
  for (const Json& vector : json["vectors"]) result.vectors.push_back(rationals_from(vector, "a vector of the polytope"));
  for (const Json& of_matrix : json["images"]) result.images.push_back(combinations(of_matrix));
  return result;
}

#define UDCP_INSTANTIATE(S)                                                                        \
  template std::int64_t transition_size(const Mask<S>&);                                           \
  template std::vector<Points<S>> transition_matrices(const Mask<S>&);                             \
  template Points<S> product(const std::vector<Points<S>>&, const std::vector<int>&);              \
  template bool zeros_within(const Polynomial<S>&, const S&);                                      \
  template bool product_reaches(const std::vector<Points<S>>&, const std::vector<int>&, const S&); \
  template S rest_of(const Polytope&, const Polytope::Combination&, const std::vector<S>&);        \
  template void check_polytope(const std::vector<Points<S>>&, const Polytope&);                    \
  template bool polytope_holds(const std::vector<Points<S>>&, const Polytope&);
UDCP_INSTANTIATE(Rational)
UDCP_INSTANTIATE(Algebraic)
#undef UDCP_INSTANTIATE

}  // namespace udcp
