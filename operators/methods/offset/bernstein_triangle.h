// Polynomials on triangles in Bernstein form, in any number type: products, vector products and derivatives of patches, and the
// ranges that their coefficients give. A field of columns is a row per coefficient, in the order of bernstein_index.
#pragma once

#include <algorithm>
#include <vector>

#include "operators/methods/offset/loop_patch.h"

namespace udcp {

/// n!/(i! j! (n-i-j)!) in the order of bernstein_index.
inline std::vector<int> multinomials(int degree) {
  std::vector<int> result;
  for (int i = 0; i <= degree; ++i) {
    for (int j = 0; i + j <= degree; ++j) {
      long value = 1;
      for (int k = 1; k <= i; ++k) value = value * (degree - i + k) / k;  // binomial(degree, i)
      for (int k = 1; k <= j; ++k) value = value * (degree - i - j + k) / k;
      result.push_back(static_cast<int>(value));
    }
  }
  return result;
}

template <class S>
struct BernsteinTriangle {
  int degree = 0;
  std::vector<S> c;
};

/// One column of a field of the degree.
template <class S>
BernsteinTriangle<S> column_of(const Points<S>& field, int degree, int column) {
  BernsteinTriangle<S> result{degree, std::vector<S>(static_cast<std::size_t>(field.rows()))};
  for (Eigen::Index k = 0; k < field.rows(); ++k) result.c[static_cast<std::size_t>(k)] = field(k, column);
  return result;
}

/// sum += sign * x * y; sum has the degree of the product.
template <class S>
void add_product(BernsteinTriangle<S>& sum, int sign, const BernsteinTriangle<S>& x, const BernsteinTriangle<S>& y) {
  const std::vector<int> of_x = multinomials(x.degree), of_y = multinomials(y.degree), of_sum = multinomials(sum.degree);
  std::vector<S> scaled(sum.c.size(), S(0)), right = y.c;
  for (std::size_t b = 0; b < right.size(); ++b) right[b] *= S(of_y[b]);
  std::size_t a = 0;
  for (int i = 0; i <= x.degree; ++i) {
    for (int j = 0; i + j <= x.degree; ++j, ++a) {
      const S left = S(sign * of_x[a]) * x.c[a];
      std::size_t b = 0;
      for (int k = 0; k <= y.degree; ++k)
        for (int l = 0; k + l <= y.degree; ++l, ++b)
          scaled[static_cast<std::size_t>(bernstein_index(sum.degree, i + k, j + l))] += left * right[b];
    }
  }
  for (std::size_t k = 0; k < scaled.size(); ++k) sum.c[k] += scaled[k] / S(of_sum[k]);
}

template <class S>
BernsteinTriangle<S> zero_form(int degree) {
  return {degree, std::vector<S>(static_cast<std::size_t>(bernstein_size(degree)), S(0))};
}

/// x . y of fields with the same columns.
template <class S>
BernsteinTriangle<S> dot_product(const Points<S>& x, int degree_x, const Points<S>& y, int degree_y) {
  BernsteinTriangle<S> result = zero_form<S>(degree_x + degree_y);
  for (int c = 0; c < x.cols(); ++c) add_product(result, 1, column_of(x, degree_x, c), column_of(y, degree_y, c));
  return result;
}

/// x cross y of fields with three columns, or the determinant of fields with two (one column).
template <class S>
Points<S> cross_product(const Points<S>& x, int degree_x, const Points<S>& y, int degree_y) {
  const int columns = x.cols() == 2 ? 1 : 3;
  Points<S> result(bernstein_size(degree_x + degree_y), columns);
  for (int c = 0; c < columns; ++c) {
    const int a = columns == 1 ? 0 : (c + 1) % 3, b = columns == 1 ? 1 : (c + 2) % 3;
    BernsteinTriangle<S> sum = zero_form<S>(degree_x + degree_y);
    add_product(sum, 1, column_of(x, degree_x, a), column_of(y, degree_y, b));
    add_product(sum, -1, column_of(x, degree_x, b), column_of(y, degree_y, a));
    for (std::size_t k = 0; k < sum.c.size(); ++k) result(static_cast<Eigen::Index>(k), c) = sum.c[k];
  }
  return result;
}

/// Derivatives by v (direction 0) and w (direction 1), of one degree less.
template <class S>
Points<S> derivative(const Points<S>& b, int degree, int direction) {
  Points<S> result(bernstein_size(degree - 1), b.cols());
  for (int i = 0; i < degree; ++i)
    for (int j = 0; i + j < degree; ++j)
      for (Eigen::Index c = 0; c < b.cols(); ++c)
        result(bernstein_index(degree - 1, i, j), c) =
            S(degree) * (b(bernstein_index(degree, i + 1 - direction, j + direction), c) - b(bernstein_index(degree, i, j), c));
  return result;
}

/// The smallest and the largest coefficient: the polynomial lies between them on the triangle.
template <class S>
S least_coefficient(const BernsteinTriangle<S>& form) {
  using std::min;
  S result = form.c[0];
  for (const S& value : form.c) result = min(result, value);
  return result;
}
template <class S>
S greatest_coefficient(const BernsteinTriangle<S>& form) {
  using std::max;
  S result = form.c[0];
  for (const S& value : form.c) result = max(result, value);
  return result;
}

}  // namespace udcp
