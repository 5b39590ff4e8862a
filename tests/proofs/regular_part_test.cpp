// Masks on regular lattices and their difference schemes.
#include "proofs/regular_part.h"

#include <doctest/doctest.h>

#include "operators/matrix.h"
#include "tests/proofs/surface_words.h"

using namespace udcp;
using oracle::ratio;

TEST_SUITE_BEGIN("proofs");

TEST_CASE("lattice masks of words without P are tensor products of the masks on curves") {
  for (const char* atoms : {"UC", "UD", "UCC", "UDDD", "U"}) {
    CAPTURE(atoms);
    const Mask<Rational> curve = mask<Rational>(oracle::scheme(atoms));
    const LatticeMask<Rational> found = lattice_mask<Rational>(oracle::scheme(atoms));
    const int width = static_cast<int>(curve.coefficients.size());
    REQUIRE(found.nx == width);
    REQUIRE(found.ny == width);
    CHECK(found.x0 == -(width - 1));  // symmetric: half steps
    for (std::size_t k = 0; k < found.coefficients.size(); ++k) {
      const auto n = static_cast<std::size_t>(width);
      CHECK(found.coefficients[k] == curve.coefficients[k % n] * curve.coefficients[k / n]);
    }
  }
}

TEST_CASE("the interpolating scheme on triangles has the stencil of ten points") {
  // omega = delta = 1: the stencil of an edge point has ten points, as that of the butterfly scheme with its two ends.
  const LatticeMask<Rational> found = lattice_mask<Rational>(oracle::on_triangles(oracle::scheme("UCP")));
  int stencil = 0;
  Rational sum(0);
  for (int i = -6; i <= 6; ++i) {
    for (int j = -6; j <= 6; ++j) {
      const Rational weight = found.at({2 + 4 * i, 4 * j});  // the edge point between 0 and the first neighbour
      if (!weight.is_zero()) ++stencil;
      sum += weight;
    }
  }
  CHECK(stencil == 10);
  CHECK(sum == Rational(1));
  for (int i = -3; i <= 3; ++i)
    for (int j = -3; j <= 3; ++j) CHECK(found.at({4 * i, 4 * j}) == Rational(i == 0 && j == 0 ? 1 : 0));  // interpolating
}

TEST_CASE("difference masks multiply back") {
  const LatticeMask<Rational> a = lattice_mask<Rational>(oracle::on_triangles(oracle::scheme("UCP")));
  for (const Place d : {Place{1, 0}, {0, 1}, {-1, 1}}) {
    const std::optional<LatticeMask<Rational>> q = difference_mask(a, d);
    REQUIRE(q.has_value());
    for (int x = a.x0 - 4; x <= a.x0 + 2 * a.nx + 4; x += 2)
      for (int y = a.y0 - 4; y <= a.y0 + 2 * a.ny + 4; y += 2)
        CHECK(q->at({x + d.x, y + d.y}) + q->at({x - d.x, y - d.y}) == a.at({x, y}));
  }
  CHECK_FALSE(difference_mask(lattice_mask<Rational>(oracle::scheme("U")), {1, 1}).has_value());
}

TEST_CASE("regular parts contract by the expected bounds") {
  const auto words = oracle::surface_words();
  for (const auto& [name, values] : oracle::surface_values()["schemes"].items()) {
    const std::string of_word = name;  // clang 14 captures no bindings
    CAPTURE(of_word);
    const Word& word = words.at(name);
    const std::optional<RegularPart<Rational>> part = regular_part(lattice_mask<Rational>(word), word.triangles);
    REQUIRE(part.has_value());
    const int length = values["regular_C1"]["L"];
    CHECK(regular_bound(*part, length) == Rational::from_double(values["regular_C1"]["value"].get<double>()));
    for (int shorter = 1; shorter < length; ++shorter) CHECK_FALSE(regular_bound(*part, shorter) < Rational(1));
  }
}

TEST_CASE("words that are not factorable have no regular part") {
  std::string why;
  const LatticeMask<Rational> a = lattice_mask<Rational>(oracle::scheme("UCP", nullptr, oracle::value(2)));
  CHECK_FALSE(regular_part(a, false, &why).has_value());
  CHECK(why.find("not factorable") != std::string::npos);
  LatticeMask<Rational> doubled = lattice_mask<Rational>(oracle::scheme("UC"));
  for (Rational& c : doubled.coefficients) c *= Rational(2);
  CHECK_FALSE(regular_part(doubled, false, &why).has_value());
  CHECK(why.find("sum to 1") != std::string::npos);
  // Divisible once along each axis and along no direction again: shifts of the four corners.
  const LatticeMask<Rational> constant{0, 0, 2, 2, {Rational(1), Rational(1), Rational(1), Rational(1)}};
  CHECK_FALSE(regular_part(constant, false, &why).has_value());
  CHECK(why.find("twice") != std::string::npos);
}

TEST_CASE("linear interpolation is factorable and does not contract") {
  for (const bool triangles : {false, true}) {
    Word word = oracle::scheme("U");
    word.triangles = triangles;
    const std::optional<RegularPart<Rational>> part = regular_part(lattice_mask<Rational>(word), triangles);
    REQUIRE(part.has_value());
    for (int length = 1; length <= 4; ++length) CHECK_FALSE(regular_bound(*part, length) < Rational(1));
  }
}

TEST_CASE("a mask of several rounds is that of one round after another") {
  const LatticeMask<Rational> a = lattice_mask<Rational>(oracle::scheme("UC"));
  const LatticeMask<Rational> twice = iterated(a, 2);
  for (int x = -14; x <= 14; x += 2) {
    for (int y = -14; y <= 14; y += 2) {
      Rational sum(0);
      for (int i = -4; i <= 4; ++i)
        for (int j = -4; j <= 4; ++j) sum += a.at({x - 4 * i, y - 4 * j}) * a.at({2 * i, 2 * j});
      CHECK(twice.at({x, y}) == sum);
    }
  }
  CHECK(contraction(a, 3) == Rational(1));  // non-negative with row sums 1
  CHECK_THROWS_AS((void)iterated(a, 20), Error);
}

TEST_SUITE_END();
