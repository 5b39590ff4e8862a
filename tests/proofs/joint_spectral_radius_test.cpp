// Joint spectral radii: brackets of the specification, matrices of known radius, and certificates with anything changed.
#include "proofs/joint_spectral_radius.h"

#include <doctest/doctest.h>

#include "proofs/linear_algebra.h"
#include "proofs/symbol.h"
#include "tests/oracle/expected_curves.h"
#include "tests/oracle/inputs.h"

using namespace udcp;
using oracle::ratio;

namespace {

/// The mask of one round of UCP in the parameters a, b of the specification.
Mask<Rational> ucp(const Rational& a, const Rational& b) {
  const Rational half = ratio(1, 2);
  return {2, -3, Rational(0), {-b, a, half + b, Rational(1) - Rational(2) * a, half + b, a, -b}};
}

Points<Rational> matrix(int n, std::vector<Rational> entries) {
  Points<Rational> result(n, n);
  for (int k = 0; k < n * n; ++k) result(k / n, k % n) = entries[static_cast<std::size_t>(k)];
  return result;
}

/// What the search says must also pass the checks that certificates go through.
template <class S>
void check_sound(const Mask<S>& mask, const JointSpectralRadius<S>& radius) {
  const auto matrices = transition_matrices(mask);
  CHECK(product_reaches(matrices, radius.lower.product, radius.lower.value));
  CHECK(radius.lower.value <= radius.upper.value);
  if (radius.upper.polytope) {
    CHECK(S(radius.upper.polytope->bound) == radius.upper.value);
    CHECK(polytope_holds(matrices, *radius.upper.polytope));
    CHECK(polytope_from(Json::parse(to_json(*radius.upper.polytope).dump())).vectors == radius.upper.polytope->vectors);
  } else {
    S power(1);
    for (int k = 0; k < radius.upper.length; ++k) power *= radius.upper.value;
    CHECK(norm(iterated(mask, radius.upper.length)) <= power);
  }
}

}  // namespace

TEST_SUITE_BEGIN("proofs");

TEST_CASE("joint spectral radii of words lie where the specification says") {
  for (const Json& record : oracle::expected_curves()["static"]) {
    CAPTURE(record["program"].get<std::string>());
    CAPTURE(record["params"].dump());
    const Mask<Rational> m = mask<Rational>(oracle::expected_word(record)), top = difference_mask(m, sum_rules(m));
    Budget budget{SearchLimits{}};
    const auto radius = joint_spectral_radius(top, budget);
    const Json& expected = record["jsr"];
    CHECK(sum_rules(m) == expected["m"].get<int>());
    if (expected.contains("exact")) {
      CHECK(radius.exact());
      CHECK(radius.upper.value == Rational::parse(expected["exact"].get<std::string>()));
    } else {
      const Rational lower = Rational::parse(expected["lower"].get<std::string>()),
                     upper = Rational::parse(expected["upper"].get<std::string>());
      CHECK(radius.upper.value >= lower);
      CHECK(radius.lower.value <= upper);
      CHECK(radius.upper.value - radius.lower.value <= upper - lower);
    }
    check_sound(top, radius);
  }
}

TEST_CASE("brackets over the plane of a and b are those of the specification") {
  for (const Json& record : oracle::expected_curves()["ucp_ab_plane"]) {
    CAPTURE(record.dump());
    const auto number_at = [](const Json& text) { return Rational::parse(text.get<std::string>()); };
    const Mask<Rational> second = difference_mask(ucp(number_at(record["a"]), number_at(record["b"])), 2);
    Budget budget{SearchLimits{}};
    const auto radius = joint_spectral_radius(second, budget);
    const Rational lower = number_at(record["rho_S2"][0]), upper = number_at(record["rho_S2"][1]);
    CHECK(radius.upper.value >= lower);
    CHECK(radius.lower.value <= upper);
    CHECK(radius.upper.value - radius.lower.value <= upper - lower);
    CHECK((radius.upper.value < Rational(1)) == record["converges"].get<bool>());
    CHECK((radius.upper.value < ratio(1, 2)) == record["C1"].get<bool>());
    CHECK((radius.lower.value >= ratio(1, 2)) != record["C1"].get<bool>());
    check_sound(second, radius);
  }
}

TEST_CASE("the four-point family has radius (1 + sqrt(1 - 16 w))/4 for w up to 1/16") {
  for (const Rational& w : {ratio(1, 100), ratio(3, 100), ratio(1, 18)}) {
    Budget budget{SearchLimits{}};
    const auto radius = joint_spectral_radius(difference_mask(ucp(Rational(0), w), 2), budget);
    // rho = (1 + r)/4 with r^2 = 1 - 16 w, and squares keep the order of positive numbers
    const auto square = [](const Rational& rho) { return (Rational(4) * rho - Rational(1)) * (Rational(4) * rho - Rational(1)); };
    CHECK(square(radius.lower.value) <= Rational(1) - Rational(16) * w);
    CHECK(square(radius.upper.value) >= Rational(1) - Rational(16) * w);
    CHECK(radius.upper.value - radius.lower.value < ratio(1, 100'000));
  }
}

TEST_CASE("an eigenvalue on the bound is found exactly by a polytope") {
  Budget budget{SearchLimits{}};
  const auto radius = joint_spectral_radius(difference_mask(ucp(Rational(0), ratio(7, 16)), 2), budget);
  CHECK(radius.exact());
  CHECK(radius.upper.value == ratio(7, 8));
  CHECK(radius.upper.polytope);
}

TEST_CASE("complex leading eigenvalues and reducible families have their radius") {
  // Rotation by 3/5 + 4/5 i scaled by 1/2, and a projection scaled by 1/3: radius 1/2.
  const auto turn = matrix(2, {ratio(3, 10), ratio(-2, 5), ratio(2, 5), ratio(3, 10)}), flat = matrix(2, {ratio(1, 3), 0, 0, 0});
  Budget budget{SearchLimits{}};
  const auto found = find_polytope<Rational>({turn, flat}, ratio(51, 100), budget);
  REQUIRE(found);
  CHECK(polytope_holds<Rational>({turn, flat}, *found));
  CHECK(product_reaches<Rational>({turn, flat}, {0}, ratio(1, 2)));
  CHECK_FALSE(product_reaches<Rational>({turn, flat}, {0}, ratio(501, 1000)));
  // Block triangular with radii 1/4 and 1/2.
  const auto p = matrix(2, {ratio(1, 4), 1, 0, ratio(-1, 2)}), q = matrix(2, {ratio(-1, 4), 0, 0, ratio(1, 3)});
  CHECK(find_polytope<Rational>({p, q}, ratio(501, 1000), budget));
}

TEST_CASE("no polytope is found below the joint spectral radius") {
  // (1 1; 0 1) and (1 0; 1 1): the golden ratio, by the product of both.
  const auto a = matrix(2, {1, 1, 0, 1}), b = matrix(2, {1, 0, 1, 1});
  Budget budget{SearchLimits{}};
  CHECK_FALSE(find_polytope<Rational>({a, b}, ratio(1618, 1000), budget));
  const auto found = find_polytope<Rational>({a, b}, ratio(16181, 10000), budget);
  REQUIRE(found);
  Polytope wrong = *found;
  wrong.bound = ratio(1618, 1000);
  CHECK_FALSE(polytope_holds<Rational>({a, b}, wrong));
  CHECK(leading_products<Rational>({a, b}, budget).words.front() == std::vector{0, 1});
}

TEST_CASE("a polytope of the corners holds inside a box of parameters") {
  std::vector<Points<Rational>> corners;
  for (const Rational& a : {Rational(0), ratio(1, 20)})
    for (const Rational& b : {ratio(1, 16), ratio(1, 10)})
      for (const Points<Rational>& t : transition_matrices(difference_mask(ucp(a, b), 2))) corners.push_back(t);
  Budget budget{SearchLimits{}};
  const auto found = find_polytope(corners, ratio(49, 100), budget);
  REQUIRE(found);
  CHECK(polytope_holds(corners, *found));
  // In the middle of the box the image of a vector is the mean of its images at the corners: so is the combination.
  const auto middle = transition_matrices(difference_mask(ucp(ratio(1, 40), ratio(13, 160)), 2));
  Polytope inside = *found;
  inside.images.assign(2, std::vector<Polytope::Combination>(found->vectors.size()));
  for (std::size_t e = 0; e < 2; ++e) {
    for (std::size_t k = 0; k < found->vectors.size(); ++k) {
      std::map<int, Rational> weights;
      for (std::size_t c = e; c < 8; c += 2)
        for (const auto& [vector, weight] : found->images[c][k]) weights[vector] += weight / Rational(4);
      for (const auto& [vector, weight] : weights) inside.images[e][k].push_back({vector, weight});
    }
  }
  CHECK(polytope_holds(middle, inside));
}

TEST_CASE("zeros within a disc agree with roots that were put in") {
  const Polynomial<Rational> p =
      Polynomial<Rational>({ratio(-1, 2), 1}) * Polynomial<Rational>({ratio(9, 16), 0, 1});  // 1/2, 3/4 i
  CHECK(zeros_within(p, ratio(76, 100)));
  CHECK_FALSE(zeros_within(p, ratio(3, 4)));
  CHECK_FALSE(zeros_within(p, ratio(1, 2)));
  CHECK_FALSE(zeros_within(p, Rational(0)));
  CHECK(zeros_within(Polynomial<Rational>({Rational(5)}), ratio(1, 1000)));
  const Polynomial<Algebraic> q({Algebraic(-2), Algebraic(0), Algebraic(1)});
  CHECK_FALSE(zeros_within(q, sqrt(Algebraic(2))));
  CHECK(zeros_within(q, Algebraic(ratio(1415, 1000))));
}

TEST_CASE("the transition matrices carry the norm of the scheme") {
  oracle::Dice dice(21);
  for (const int arity : {2, 3, 4}) {
    Mask<Rational> m{arity, -2, Rational(0), {}};
    for (int k = 0; k < 8; ++k) m.coefficients.push_back(Rational(dice.between(1, 9)) * Rational(dice.one_in(2) ? 1 : -1));
    const auto matrices = transition_matrices(m);
    Rational most(0);
    for (const auto& a : matrices) {
      for (const auto& b : matrices) {
        const Points<Rational> both = a * b;
        for (Eigen::Index i = 0; i < both.rows(); ++i) {
          Rational sum(0);
          for (Eigen::Index j = 0; j < both.cols(); ++j) sum += abs(both(i, j));
          most = std::max(most, sum);
        }
      }
    }
    CHECK(most == norm(iterated(m, 2)));
    CHECK(transition_size(m) == static_cast<std::int64_t>(matrices.size()) * matrices[0].size());
  }
}

TEST_CASE("a search without nodes still gives bounds and a stopped one is interrupted") {
  const Mask<Rational> second = difference_mask(ucp(Rational(0), ratio(1, 8)), 2);
  SearchLimits none;
  none.nodes = 0;
  Budget empty(none);
  const auto radius = joint_spectral_radius(second, empty);
  CHECK(radius.lower.value <= radius.upper.value);
  CHECK(radius.upper.value == norm(second));
  const std::atomic<bool> stop{true};
  SearchLimits stopped;
  stopped.stop = &stop;
  Budget budget(stopped);
  CHECK_THROWS_AS((void)joint_spectral_radius(second, budget), Error);
}

TEST_SUITE_END();
