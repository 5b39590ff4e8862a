// What number.h promises for every number type: conversion, nearest cosines, text, and matrices of them in Eigen.
#include "operators/number.h"

#define DOCTEST_CONFIG_SUPER_FAST_ASSERTS  // compiles twice as fast; nothing here is expected to throw unasked
#include <doctest/doctest.h>

#include <Eigen/LU>
#include <cmath>

using udcp::Algebraic;
using udcp::Error;
using udcp::Interval;
using udcp::Jet;
using udcp::Parametric;
using udcp::Points;
using udcp::Rational;

namespace {

Rational fraction(long p, long q) { return Rational(p) / Rational(q); }

}  // namespace

TEST_SUITE_BEGIN("operators");

TEST_CASE("exact values enter every number type") {
  CHECK(udcp::number<double>(fraction(1, 3)) == 1.0 / 3.0);
  CHECK(udcp::number<Algebraic>(fraction(1, 3)) == Algebraic(fraction(1, 3)));
  CHECK(udcp::number<Interval>(fraction(1, 3)).contains(fraction(1, 3)));
  CHECK(udcp::number<double>(udcp::sqrt(Algebraic(3))) == std::sqrt(3.0));
  CHECK(udcp::number<Rational>(Algebraic(fraction(2, 7))) == fraction(2, 7));
  CHECK(udcp::number<Parametric>(Algebraic(fraction(2, 7))) == Parametric(fraction(2, 7)));
  CHECK(
      (udcp::number<Jet>(udcp::sqrt(Algebraic(3))) * udcp::number<Jet>(udcp::sqrt(Algebraic(3)))).value().contains(Rational(3)));
  CHECK(udcp::number_from_double<Interval>(0.1).contains(Rational::from_double(0.1)));
  CHECK_THROWS_AS(udcp::number<double>(pow(Rational(10), 400)), Error);
  CHECK_THROWS_AS(udcp::number<Rational>(udcp::sqrt(Algebraic(3))), Error);
  CHECK_THROWS_AS(udcp::number<Parametric>(udcp::sqrt(Algebraic(3))), Error);
  CHECK_THROWS_AS(udcp::number_from_double<Rational>(0.5), Error);
  CHECK_THROWS_AS(udcp::number_from_double<Parametric>(0.5), Error);
  CHECK_THROWS_AS(udcp::number_from_double<Algebraic>(0.5), Error);
}

TEST_CASE("the cosine in double is the nearest one") {
  CHECK(udcp::cosine<double>(fraction(1, 6)) == std::sqrt(0.75));  // IEEE square roots are correctly rounded
  CHECK(udcp::cosine<double>(fraction(1, 4)) == std::sqrt(0.5));
  CHECK(udcp::cosine<double>(fraction(5, 6)) == -std::sqrt(0.75));
  CHECK(udcp::cosine<double>(pow(Rational(10), 40) + fraction(1, 6)) == std::sqrt(0.75));
  CHECK(udcp::cosine<double>(fraction(1, 2) + pow(Rational(2), -80)) < 0);
}

TEST_CASE("numbers print as the language reads them") {
  CHECK(udcp::to_text(0.1) == "0.1");
  CHECK(udcp::to_text(1e300) == "1e+300");
  CHECK(udcp::to_text(fraction(-7, 12)) == "-7/12");
  CHECK(udcp::to_text(Interval(fraction(1, 2))) == "[0.5, 0.5]");
  CHECK(udcp::to_text(udcp::sqrt(Algebraic(2))) == "sqrt(2)");
}

// All products below have the one type Points<S> * Points<S>: Eigen compiles each other combination anew.
TEST_CASE_TEMPLATE("Eigen adds and multiplies matrices of every number type", S, double, Rational, Algebraic, Interval,
                   Parametric, Jet) {
  Points<S> a(2, 2);
  a << S(1), S(2), S(3), S(4);
  const Points<S> square = a * a;
  const Points<S> identity = Points<S>::Identity(2, 2);
  const Points<S> same = a * identity;
  const Points<S> difference = square - a;
  CHECK(square(0, 0) == S(7));
  CHECK(square(0, 1) == S(10));
  CHECK(square(1, 0) == S(15));
  CHECK(square(1, 1) == S(22));
  CHECK(same(1, 0) == S(3));
  CHECK(difference(1, 1) == S(18));
  CHECK(square.sum() == S(54));
  a.resize(3, 2);
  a.setZero();
  CHECK(udcp::is_zero<S>(a(2, 1)));
  CHECK_FALSE(udcp::is_nonzero<S>(a(2, 1)));
  Points<S> to = Points<S>::Zero(1, 2);
  udcp::add(to, 0, S(3), square, 1);
  CHECK(to(0, 1) == S(66));
}

TEST_CASE("Eigen decompositions of Rational are exact") {
  using Matrix = Points<Rational>;
  const int n = 6;
  Matrix hilbert(n, n);
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) hilbert(i, j) = fraction(1, i + j + 1);
  }
  const Matrix identity = Matrix::Identity(n, n);
  const Matrix inverse = Eigen::PartialPivLU<Matrix>(hilbert).solve(identity);
  const Matrix product = inverse * hilbert;
  CHECK(product == identity);
  CHECK(inverse(0, 0) == Rational(n * n));  // known: the first entry of the inverse Hilbert matrix
  Matrix singular(3, 3);
  for (int i = 0; i < 9; ++i) singular(i / 3, i % 3) = Rational(i);
  const Eigen::FullPivLU<Matrix> decomposition(singular);
  CHECK(decomposition.rank() == 2);
  const Matrix kernel = decomposition.kernel();
  CHECK(kernel.cols() == 1);
  const Matrix image = singular * kernel;
  for (int i = 0; i < 3; ++i) CHECK(image(i, 0).is_zero());
}

TEST_SUITE_END();
