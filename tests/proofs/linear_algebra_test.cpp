// Exact linear algebra on matrices of known rank, eigenvalues and Jordan form.
#include "proofs/linear_algebra.h"

#include <doctest/doctest.h>

#include "tests/oracle/inputs.h"

using namespace udcp;
using oracle::Dice;

namespace {

template <class S>
Points<S> random_matrix(Dice& dice, int rows, int columns) {
  Points<S> a = oracle::random_points<S>(dice, rows, columns);
  if constexpr (std::is_same_v<S, Algebraic>) {
    const Algebraic golden = Algebraic::cosine(Rational(1) / Rational(5));
    for (Eigen::Index k = 0; k < a.size(); ++k) a.data()[k] += Algebraic(dice.between(-1, 1)) * golden;
  }
  return a;
}

/// A random matrix times the inverse of another random one gives every Jordan form in disguise.
Points<Rational> disguised(Dice& dice, const Points<Rational>& form) {
  const auto n = static_cast<int>(form.rows());
  for (;;) {
    const Points<Rational> basis = random_matrix<Rational>(dice, n, n);
    if (rank(basis) < n) continue;
    const Points<Rational> right = *solve<Rational>(basis, Points<Rational>::Identity(n, n));
    return (basis * form * right).eval();
  }
}

}  // namespace

TEST_SUITE_BEGIN("proofs");

TEST_CASE_TEMPLATE("the rank of a product is that of its narrow middle and the kernel has the rest", S, Rational, Algebraic) {
  Dice dice(4);
  for (int middle = 0; middle <= 3; ++middle) {
    const Points<S> a = (random_matrix<S>(dice, 4, middle) * random_matrix<S>(dice, middle, 5)).eval();
    CHECK(rank(a) == middle);
    const Points<S> basis = kernel(a);
    CHECK(basis.cols() == 5 - middle);
    CHECK(rank(basis) == 5 - middle);
    const Points<S> image = a * basis;
    for (Eigen::Index k = 0; k < image.size(); ++k) CHECK(image.data()[k].is_zero());
  }
}

TEST_CASE_TEMPLATE("solutions satisfy their system and inconsistent systems have none", S, Rational, Algebraic) {
  Dice dice(5);
  const Points<S> a = random_matrix<S>(dice, 4, 3), x = random_matrix<S>(dice, 3, 2), b = a * x;
  const auto found = solve(a, b);
  REQUIRE(found);
  const Points<S> image = a * *found;
  CHECK(image == b);
  Points<S> wrong = b;
  wrong(3, 0) += S(1);
  CHECK_FALSE(solve(a, wrong));
  const Points<S> wide = a.transpose();
  const Points<S> right = wide * random_matrix<S>(dice, 4, 1);
  const Points<S> again = wide * *solve(wide, right);
  CHECK(again == right);
}

TEST_CASE_TEMPLATE("a matrix is a zero of its characteristic polynomial", S, Rational, Algebraic) {
  Dice dice(6);
  for (int n = 1; n <= 5; ++n) {
    Points<S> a = random_matrix<S>(dice, n, n);
    if (n > 2)
      for (int i = 2; i < n; ++i)
        for (int j = 0; j < 2; ++j) a(i, j) = S(0);  // two blocks
    const Polynomial<S> p = characteristic_polynomial(a);
    CHECK(p.degree() == n);
    CHECK(p.coefficients.back() == S(1));
    S trace(0);
    for (int i = 0; i < n; ++i) trace += a(i, i);
    CHECK(p.coefficients[static_cast<std::size_t>(n) - 1] == S(-trace));
    Points<S> value = Points<S>::Zero(n, n);
    for (std::size_t k = p.coefficients.size(); k-- > 0;) {
      value = (value * a).eval();
      for (int i = 0; i < n; ++i) value(i, i) += p.coefficients[k];
    }
    const Points<S> zero = Points<S>::Zero(n, n);
    CHECK(value == zero);
  }
}

TEST_CASE("the companion matrix has the polynomial that it was made of") {
  const Polynomial<Rational> p({Rational(3), Rational(-5), Rational(0), Rational(7) / Rational(2), Rational(1)});
  Points<Rational> companion = Points<Rational>::Zero(4, 4);
  for (int i = 0; i < 4; ++i) {
    companion(i, 3) = -p.coefficients[static_cast<std::size_t>(i)];
    if (i > 0) companion(i, i - 1) = Rational(1);
  }
  CHECK(characteristic_polynomial(companion) == p);
  CHECK(characteristic_polynomial(Points<Rational>()) == Polynomial<Rational>({Rational(1)}));
}

TEST_CASE("Jordan blocks are found in any basis") {
  Dice dice(7);
  Points<Rational> form = Points<Rational>::Zero(7, 7);
  const Rational half = Rational(1) / Rational(2);
  for (int i = 0; i < 6; ++i) form(i, i) = half;
  form(0, 1) = form(1, 2) = form(3, 4) = Rational(1);  // blocks 3, 2, 1 and the eigenvalue 2
  form(6, 6) = Rational(2);
  const Points<Rational> a = disguised(dice, form);
  CHECK(jordan_blocks(a, half) == std::vector{3, 2, 1});
  CHECK(jordan_blocks(a, Rational(2)) == std::vector{1});
  CHECK(jordan_blocks(a, Rational(3)).empty());
}

TEST_CASE("an irrational eigenvalue has its Jordan block") {
  const Algebraic root_two = sqrt(Algebraic(2));
  Points<Algebraic> a(2, 2);
  a << root_two, Algebraic(5), Algebraic(), root_two;
  CHECK(jordan_blocks(a, root_two) == std::vector{2});
  CHECK(jordan_blocks(a, Algebraic(Rational(7) / Rational(5))).empty());
}

TEST_SUITE_END();
