// Fourier blocks and their eigenvalues against closed forms, expected values and matrices of known spectrum.
#include "proofs/spectrum.h"

#include <doctest/doctest.h>

#include "proofs/eigenvalues.h"
#include "proofs/surface_facts.h"
#include "tests/proofs/surface_words.h"

using namespace udcp;
using oracle::ratio;

namespace {

Patch<Algebraic> rows_of(const Word& word, int n) { return patch<Algebraic>(word, n, 9); }

Points<Interval> matrix(std::initializer_list<std::initializer_list<int>> rows, int denominator) {
  Points<Interval> result(static_cast<Eigen::Index>(rows.size()), static_cast<Eigen::Index>(rows.size()));
  Eigen::Index i = 0, j = 0;
  for (const auto& row : rows) {
    j = 0;
    for (const int x : row) result(i, j++) = Interval(ratio(x, denominator));
    ++i;
  }
  return result;
}

/// The dominant eigenvalue of B_1.
Interval subdominant(const Word& word, int n) {
  const Patch<Interval> rows = converted<Interval>(rows_of(word, n));
  const Points<Interval> b = block(rows, invariant_radius(rows_of(word, n)), 1);
  const std::optional<ApproximatePair> near = approximate_eigenpair(b);
  REQUIRE(near.has_value());
  const std::optional<Eigenpair> pair = enclose_eigenpair(b, *near);
  REQUIRE(pair.has_value());
  CHECK(is_nearest(*near, *pair));
  return pair->value;
}

}  // namespace

TEST_SUITE_BEGIN("proofs");

TEST_CASE("subdominant eigenvalues have the closed forms of the literature") {
  for (const int n : {3, 4, 5, 6, 7, 9, 12}) {
    CAPTURE(n);
    const Interval c = cosine<Interval>(ratio(2, n));
    const auto agrees = [](const Interval& x, const Interval& y) {
      CHECK(abs(x - y) < Interval(ratio(1, 1'000'000'000) * ratio(1, 1'000'000'000)));
    };
    // Catmull and Clark: (5 + c + sqrt((c + 9)(c + 1)))/16; Loop: 3/8 + c/4; U D: 1/2 + c/4.
    const Interval root = sqrt((c + Interval(9)) * (c + Interval(1)));
    agrees(subdominant(oracle::catmull_clark(), n), (Interval(5) + c + root) / Interval(16));
    agrees(subdominant(oracle::loop(), n), Interval(ratio(3, 8)) + c / Interval(4));
    agrees(subdominant(oracle::scheme("UD"), n), Interval(ratio(1, 2)) + c / Interval(4));
  }
}

TEST_CASE("moduli of eigenvalues by frequency are the expected ones") {
  const auto words = oracle::surface_words();
  for (const auto& [name, values] : oracle::surface_values()["schemes"].items()) {
    const std::string of_word = name;  // clang 14 captures no bindings
    CAPTURE(of_word);
    for (const auto& at : values["valence"]) {
      const int n = at["n"];
      if (n > 6 && n != 12) continue;
      CAPTURE(n);
      const Patch<Algebraic> rows = rows_of(words.at(name), n);
      const int radius = invariant_radius(rows);
      CHECK((Rational(radius) / Rational(2)).to_string() == at["r"].get<std::string>());
      CHECK(coordinates(rows.sectors, radius).size() == at["block"].get<std::size_t>());
      const auto found = eigenvalues_by_frequency(converted<Interval>(rows), radius);
      for (const auto& [m, moduli] : at["moduli"].items()) {
        const std::string frequency = m;
        CAPTURE(frequency);
        const auto& here = found.at(static_cast<std::size_t>(std::stoi(m)));
        for (std::size_t k = 0; k < moduli.size(); ++k)
          CHECK(std::abs(here.at(k)) == doctest::Approx(moduli[k].get<double>()).epsilon(1e-4));
      }
    }
  }
}

TEST_CASE("characteristic polynomials in x and the cosine are the expected ones") {
  const std::map<std::string, Word> words{
      {"UC quad", oracle::scheme("UC")},
      {"UD dual", oracle::scheme("UD")},
      {"UDDD dual", oracle::scheme("UDDD")},
      {"UC tri", oracle::on_triangles(oracle::scheme("UC"))},
      {"UCP omega=1 delta=1 quad", oracle::scheme("UCP")},
      {"UCCP omega=1 delta=1 quad", oracle::scheme("UCCP")},
      {"UCP omega=1 delta=1 tri", oracle::on_triangles(oracle::scheme("UCP"))},
  };
  for (const auto& [name, values] : oracle::surface_values()["charpoly_in_x_and_c"].items()) {
    const std::string of_word = name;  // clang 14 captures no bindings
    CAPTURE(of_word);
    const Patch<Algebraic> rows = converted<Algebraic>(patch<Rational>(words.at(name), 12, 9));
    const int radius = closed_radius(rows);
    CHECK((Rational(radius) / Rational(2)).to_string() == values["r"].get<std::string>());
    const std::vector<std::vector<Algebraic>> found = polynomial_in_cosine(rows, radius);
    const auto& expected = values["coefficients"];
    REQUIRE(found.size() == expected.size());
    const Rational leading = Rational(expected.back()[0].get<int>());
    for (std::size_t i = 0; i < found.size(); ++i) {
      REQUIRE(found[i].size() == expected[i].size());
      for (std::size_t j = 0; j < found[i].size(); ++j)
        CHECK(found[i][j] == Algebraic(Rational(expected[i][j].get<int>()) / leading));
    }
    // The polynomial of one block is this one at its cosine, times powers of x.
    for (const int n : {3, 5, 8}) {
      const Patch<Algebraic> here = converted<Algebraic>(patch<Rational>(words.at(name), n, 9));
      const Algebraic c = Algebraic::cosine(ratio(2, n));
      std::vector<Algebraic> coefficients;
      for (const auto& row : found) {
        Algebraic value(0), power(1);
        for (const Algebraic& entry : row) {
          value += entry * power;
          power *= c;
        }
        coefficients.push_back(value);
      }
      CHECK(block_polynomial(here, radius, 1) == Polynomial<Algebraic>(coefficients));
    }
  }
}

TEST_CASE("the interpolating scheme on triangles has a double eigenvalue at valence 3") {
  const Patch<Algebraic> rows = rows_of(oracle::on_triangles(oracle::scheme("UCP")), 3);
  // (4x - 1)^2 (16x - 1) on the closed neighbourhood
  const auto factor = [](int p, int q) { return Polynomial<Algebraic>({Algebraic(-ratio(p, q)), Algebraic(1)}); };
  CHECK(block_polynomial(rows, 4, 1) == factor(1, 4) * factor(1, 4) * factor(1, 16));
  CHECK(block_jordan(rows, 6, 1, Algebraic(ratio(1, 4))) == std::vector<int>{2});
  CHECK(is_multiple_and_dominant(rows, 6, ratio(1, 4)));
  CHECK_FALSE(is_multiple_and_dominant(rows, 6, ratio(1, 16)));
  CHECK_FALSE(is_multiple_and_dominant(rows, 6, ratio(1, 5)));
  CHECK_FALSE(is_multiple_and_dominant(rows_of(oracle::on_triangles(oracle::scheme("UCP")), 4), 6, ratio(1, 4)));
}

TEST_CASE("Jordan structure at regular points is that of polynomials") {
  // Around a regular vertex of bicubic B-splines, x^i y^j has the eigenvalue 2^-(i+j): 1/4 once in frequency 0 (x^2 + y^2) and
  // twice in frequency 2 (x^2 - y^2, xy).
  const Patch<Algebraic> rows = rows_of(oracle::scheme("UC"), 4);
  CHECK(block_jordan(rows, 4, 0, Algebraic(1)) == std::vector<int>{1});
  CHECK(block_jordan(rows, 4, 1, Algebraic(ratio(1, 2))) == std::vector<int>{1});
  CHECK(block_jordan(rows, 4, 0, Algebraic(ratio(1, 4))) == std::vector<int>{1});
  CHECK(block_jordan(rows, 4, 2, Algebraic(ratio(1, 4))) == std::vector<int>{1, 1});
  CHECK(block_jordan(rows, 4, 2, Algebraic(ratio(1, 2))).empty());
}

TEST_CASE("bounds of the spectral radius hold it") {
  const auto check = [](const Points<Interval>& a, double radius, double slack) {
    const double upper = spectral_radius_bound(a), lower = spectral_radius_lower_bound(a);
    CHECK(upper >= radius);
    CHECK(upper <= radius * (1 + slack));
    CHECK(lower <= radius);
    CHECK(lower >= radius * (1 - slack));
  };
  check(matrix({{3, 1}, {0, 2}}, 4), 0.75, 1e-3);
  check(matrix({{1, 1000}, {0, 1}}, 2), 0.5, 2e-3);  // a Jordan block, far from normal
  check(matrix({{0, 1}, {-1, 0}}, 2), 0.5, 1e-3);    // a rotation
  check(matrix({{3, -4}, {4, 3}}, 10), 0.5, 1e-3);
  CHECK(spectral_radius_bound(matrix({{0, 1}, {0, 0}}, 1)) < 1e-100);
  CHECK(spectral_radius_lower_bound(matrix({{0, 1}, {0, 0}}, 1)) == 0);
  const double early = spectral_radius_bound(matrix({{1, 1000}, {0, 1}}, 2), 0.9);
  CHECK(early < 0.9);
  CHECK(early >= 0.5);
}

TEST_CASE("eigenpairs are enclosed and nothing else is") {
  const Points<Interval> a = matrix({{2, 1}, {1, 2}}, 1);
  const Rational tiny = ratio(1, 1000);
  const std::optional<Eigenpair> pair = enclose_eigenpair(a, {Rational(3) + tiny, {Rational(1), Rational(1) - tiny}});
  REQUIRE(pair.has_value());
  CHECK(pair->value.contains(Rational(3)));
  CHECK(pair->vector[1].contains(Rational(1)));
  CHECK(pair->value.width() < 1e-4);
  CHECK_FALSE(enclose_eigenpair(a, {Rational(2), {Rational(1), Rational(0)}}).has_value());  // between both
  CHECK_FALSE(enclose_eigenpair(a, {Rational(3), {Rational(1)}}).has_value());               // wrong size
  CHECK_FALSE(
      enclose_eigenpair(matrix({{1, 1}, {0, 1}}, 2), {ratio(1, 2), {Rational(1), Rational(0)}}).has_value());  // defective
  CHECK(spectral_radius_bound(deflated(a, *pair)) == doctest::Approx(1).epsilon(1e-2));  // 3 is gone, 1 is left
  const ApproximatePair exact{Rational(3), {Rational(1), Rational(1)}};
  const std::optional<Eigenpair> sharp = enclose_eigenpair(a, exact);
  REQUIRE(sharp.has_value());
  CHECK(is_nearest(exact, *sharp));
  ApproximatePair moved = exact;
  moved.vector[1] += pow(Rational(2), -eigenpair_bits);
  CHECK_FALSE(is_nearest(moved, *sharp));
  moved.vector[1] = Rational(1) + pow(Rational(2), -eigenpair_bits - 3);
  CHECK_FALSE(is_nearest(moved, *sharp));
}

TEST_SUITE_END();
