// Constants of rings around vertices: published values, eigenvectors, powers.
#include <doctest/doctest.h>

#include "proofs/regularity/ring_certificate.h"
#include "tests/proofs/regularity_meshes.h"

using namespace udcp;

namespace {

using Index = Eigen::Index;

Points<Interval> enclosed(const Points<Rational>& a) {
  Points<Interval> result(a.rows(), a.cols());
  for (Index i = 0; i < a.rows(); ++i)
    for (Index j = 0; j < a.cols(); ++j) result(i, j) = Interval(a(i, j));
  return result;
}

/// The largest distance to 0 of a matrix of enclosures, all of which must hold it.
double largest_around_zero(const Points<Interval>& a) {
  double result = 0;
  for (Index i = 0; i < a.rows(); ++i) {
    for (Index j = 0; j < a.cols(); ++j) {
      CHECK(a(i, j).contains_zero());
      result = std::max(result, a(i, j).width());
    }
  }
  return result;
}

}  // namespace

TEST_SUITE_BEGIN("proofs");

TEST_CASE("constants of a valence are the published ones") {
  for (const auto& entry : oracle::expected_regularity()["ring"].items()) {
    const Json& expected = entry.value();
    const int n = std::stoi(entry.key());
    CAPTURE(n);
    const auto number = [&](const char* name) { return std::stod(expected[name].get<std::string>()); };
    const std::shared_ptr<const RingConstants> c = ring_constants(n);
    CHECK(c->lambda.midpoint() == doctest::Approx(number("lambda")).epsilon(1e-15));
    CHECK(c->kappa.midpoint() == doctest::Approx(number("kappa")).epsilon(1e-11));
    CHECK(c->size.midpoint() == doctest::Approx(number("G")).epsilon(1e-11));
    CHECK(c->difference.to_double() == doctest::Approx(number("D")).epsilon(1e-11));
    CHECK(c->contraction.midpoint() == doctest::Approx(number("q")).epsilon(1e-8));
    CHECK(c->tail.midpoint() == doctest::Approx(number("C")).epsilon(1e-8));
    CHECK(c->splits == expected["split"].get<int>());
    CHECK(c->power == expected["K"].get<int>());
    for (const Interval& x : {c->lambda, c->kappa, c->size, c->contraction, c->tail}) CHECK(x.width() < 1e-40);
  }
}

TEST_CASE("norms of difference rows are exact fractions") {
  CHECK(ring_constants(3)->difference == Rational(3) / Rational(4));
  CHECK(ring_constants(5)->difference == Rational(17) / Rational(20));
  CHECK(ring_constants(6)->difference == Rational(35) / Rational(36));
  CHECK(ring_constants(12)->difference == Rational(85) / Rational(144));
}

TEST_CASE("eigenvectors around a vertex solve their equations and are dual") {
  const Interval::Precision precision(ring_precision);
  for (const int n : {3, 4, 5, 8, 11}) {
    CAPTURE(n);
    const std::shared_ptr<const RingConstants> c = ring_constants(n);
    const Points<Interval> a = enclosed(c->outer.topRows(1 + 6 * n)), w = enclosed(c->mean);
    CHECK(largest_around_zero(a * c->right - c->lambda * c->right) < 1e-40);
    CHECK(largest_around_zero(c->left * a - c->lambda * c->left) < 1e-40);
    CHECK(largest_around_zero(c->left * c->right - Points<Interval>::Identity(2, 2)) < 1e-40);
    CHECK(largest_around_zero(w * c->right) < 1e-40);
    CHECK(largest_around_zero(c->left.rowwise().sum()) < 1e-40);
    CHECK(Points<Rational>(c->mean * c->outer.topRows(1 + 6 * n)) == c->mean);
    CHECK((c->right(1, 0) - Interval(1)).contains_zero());
  }
}

TEST_CASE("left eigenvectors around a vertex are those of the closed form") {
  const Interval::Precision precision(ring_precision);
  for (const int n : {3, 5, 7}) {
    CAPTURE(n);
    const std::shared_ptr<const RingConstants> c = ring_constants(n);
    const auto turn = [&](int j) { return cosine<Interval>(Rational(2 * j) / Rational(n)); };
    const Interval a_n = Interval(16) * c->lambda - Interval(4), unit = c->left(0, 1) / a_n;
    for (int j = 0; j < n; ++j) {
      CHECK((c->left(0, 1 + 2 * j) - unit * a_n * turn(j)).contains_zero());
      CHECK((c->left(0, 2 + 2 * j) - unit * (turn(j) + turn(j + 1))).contains_zero());
    }
    CHECK(largest_around_zero(c->left.rightCols(4 * n)) < 1e-40);
  }
}

TEST_CASE("norms of powers of the subdivision matrix are those of explicit products") {
  const Interval::Precision precision(ring_precision);
  const int n = 5;
  const std::shared_ptr<const RingConstants> c = ring_constants(n);
  const Index size = 1 + 6 * n;
  const Points<Interval> a = enclosed(c->outer.topRows(size)),
                         limit = Points<Interval>::Constant(size, 1, Interval(1)) * enclosed(c->mean), plane = c->right * c->left;
  const Points<Interval> b = (a - limit - c->lambda * plane) / c->lambda;
  const auto norm = [](const Points<Interval>& m) {
    Interval result(0);
    for (Index i = 0; i < m.rows(); ++i) {
      Interval sum(0);
      for (Index j = 0; j < m.cols(); ++j) sum += abs(m(i, j));
      result = max(result, sum);
    }
    return result;
  };
  Points<Interval> power = Points<Interval>::Identity(size, size);
  const Points<Interval> projector = power - limit - plane;
  Interval largest(0);
  for (int r = 0; r < c->power; ++r) {
    if (r > 0) CHECK(norm(power) > Interval(1) / Interval(2));
    largest = max(largest, norm(projector * power));
    power = (power * b).eval();
  }
  CHECK((norm(power) - c->contraction).contains_zero());
  CHECK((largest - c->tail).contains_zero());
}

TEST_SUITE_END();
