// Masks, stencils and matrices against each other and against the running word; reach; regular neighbourhoods.
#include "operators/matrix.h"

#include <doctest/doctest.h>

#include "tests/oracle/inputs.h"
#include "tests/oracle/refusal.h"
#include "tests/oracle/words.h"

using namespace udcp;
using namespace udcp::oracle;

namespace {

Word random_scheme(Dice& dice, std::string& text) {
  text = random_atoms(dice);
  return scheme(text, constant(dice.positive()), constant(dice.fraction()), constant(dice.fraction()));
}

Rational coefficient(const Mask<Rational>& m, int k) {
  const int i = k - m.first;
  return i < 0 || i >= static_cast<int>(m.coefficients.size()) ? Rational(0) : m.coefficients[static_cast<std::size_t>(i)];
}

}  // namespace

TEST_SUITE("operators") {
  TEST_CASE("rows of the subdivision matrix are the mask") {
    Dice dice(21);
    for (int trial = 0; trial < 60; ++trial) {
      std::string text;
      const Word word = random_scheme(dice, text);
      CAPTURE(text);
      const Mask<Rational> m = mask<Rational>(word);
      const int n = std::max(3, static_cast<int>(m.coefficients.size()) / m.arity + 3);
      const Points<Rational> matrix = subdivision_matrix<Rational>(word, random_curve<Rational>(dice, n, true));
      REQUIRE(matrix.rows() == n * m.arity);
      bool same = true;
      for (int k = 0; k < n * m.arity; ++k)
        for (int i = 0; i < n; ++i) {
          Rational sum;
          for (int turns = -3; turns <= 3; ++turns) sum += coefficient(m, k - m.arity * (i + n * turns));
          same &= matrix(k, i) == sum;
        }
      CHECK(same);
    }
  }

  TEST_CASE("stencils are the rows that the mask stands for and sum to 1") {
    Dice dice(22);
    for (int trial = 0; trial < 60; ++trial) {
      std::string text;
      const Word word = random_scheme(dice, text);
      CAPTURE(text);
      const Mask<Rational> m = mask<Rational>(word);
      const auto rows = stencils(m);
      REQUIRE(static_cast<int>(rows.size()) == m.arity);
      Rational total;
      for (int r = 0; r < m.arity; ++r) {
        const auto& row = rows[static_cast<std::size_t>(r)];
        Rational sum;
        for (std::size_t i = 0; i < row.weights.size(); ++i) {
          sum += row.weights[i];
          CHECK(row.weights[i] == coefficient(m, r - m.arity * (row.first + static_cast<int>(i))));
        }
        CHECK(sum == Rational(1));
      }
      for (const Rational& c : m.coefficients) total += c;
      CHECK(total == Rational(m.arity));
    }
  }

  TEST_CASE("a new point lies at (k + shift)/arity of a line") {
    Dice dice(23);
    const std::vector<std::string> words{"UD", "UDUD", "U3D", "U4DUD", "UDDD", "UCUCP", "U3CP", "DU", "DUDU3"};
    for (const std::string& text : words) {
      const Mask<Rational> m = mask<Rational>(scheme(text, nullptr, constant(dice.fraction()), constant(dice.fraction())));
      CAPTURE(text);
      for (int k = 0; k < m.arity; ++k) {
        Rational place;
        for (int i = -30; i <= 30; ++i) place += coefficient(m, k - m.arity * i) * Rational(i);
        CHECK(place == (Rational(k) + m.shift) / Rational(m.arity));
      }
    }
    CHECK(mask<Rational>(scheme("UD")).shift == ratio(1, 2));
    CHECK(mask<Rational>(scheme("UDUD")).shift == ratio(3, 2));
    CHECK(mask<Rational>(scheme("U3D")).shift == ratio(1, 2));
    CHECK(mask<Rational>(scheme("DU3")).shift == ratio(3, 2));
  }

  TEST_CASE("the reach is never smaller than the support") {
    Dice dice(24);
    for (int trial = 0; trial < 150; ++trial) {
      std::string text;
      const Word word = random_scheme(dice, text);
      CAPTURE(text);
      const Reach reach = reach_of_round(word);
      const int a = arity(word), n = 60;
      Polyline<Rational> curve{Points<Rational>::Zero(n, 1), true, {}, {}};
      curve.points(n / 2, 0) = Rational(1);
      const Points<Rational> fine = run(word, curve, 1).points;
      REQUIRE(fine.rows() == a * n);
      for (int k = 0; k < a * n; ++k) {
        const int from_centre = k - a * (n / 2);
        if (from_centre < reach.low || from_centre > reach.high) CHECK(fine(k, 0) == Rational(0));
      }
      CHECK(reach.high - reach.low < a * n / 2);  // the search above sees all of it
    }
  }

  TEST_CASE("omega 0 narrows the reach of P") {
    CHECK(reach_of_round(scheme("UCP")).high == 3);
    CHECK(reach_of_round(scheme("UCP", nullptr, value(0))).high == 2);
    CHECK(reach_of_round(scheme("UCP", nullptr, value(0))).low == -2);
  }

  TEST_CASE("masks of later rounds start where the rounds before ended") {
    Word word =
        scheme("UC", formula([](const auto& c) { return std::decay_t<decltype(c.alpha)>(c.round + 1); }, {false, false, true}));
    word.head = items("U");
    for (int round = 0; round < 3; ++round) {
      const Rational f(round + 2);  // h is 0 in the head
      CHECK(mask<Rational>(word, round).coefficients == mask<Rational>(scheme("UC", constant(f))).coefficients);
    }
  }

  TEST_CASE("a matrix acts like the word also on meshes and later rounds") {
    Dice dice(25);
    Word word = scheme("UCP", formula([](const auto& c) { return Rational(1) + Rational(c.round) / Rational(3) + 0 * c.alpha; },
                                      {false, false, true}));
    for (int round = 0; round < 2; ++round) {
      const Surface<Rational> surface = random_surface<Rational>(dice, prism(5));
      RunControl control;
      control.first_item = word.items(round);
      const Points<Rational> matrix = subdivision_matrix<Rational>(word, surface, round);
      CHECK(Points<Rational>(matrix * surface.points) == run(word, surface, 1, control).points);
    }
  }

  TEST_CASE("what has no mask says so") {
    const auto vertex = formula([](const auto& c) { return c.attribute("w"); }, {false, true, false});
    CHECK(refusal([&] { mask<Rational>(scheme("UCP", nullptr, nullptr, vertex)); }) ==
          "E_MASK_VARIES: the word has parameters that differ from point to point (v.name or noise), so it has no mask");
    CHECK(refusal([] { mask<Rational>(operation("UC"), 1); }) == "E_NO_ROUND: the word has no round 1");
    CHECK(refusal([] { mask<Rational>(scheme("UC"), -1); }) == "E_NO_ROUND: the word has no round -1");
    CHECK(refusal([] { arity(scheme("U9U9U9U9U9U9U9")); }) ==
          "E_ARITY: one round of the word multiplies the points by more than 1000000");
    CHECK(refusal([] { reach_of_round(scheme("U9U9U9U9U9U9U9")); }) ==
          "E_ARITY: the mask of one round would have more than 1000000 coefficients");
    CHECK(refusal([] { mask<Rational>(on_triangles(scheme("UC"))); }) == "E_CURVE_WORD: `on triangles` has no meaning on curves");
  }

  TEST_CASE("ring meshes have their vertices where the spokes say") {
    for (const bool triangles : {false, true}) {
      for (int n = 3; n <= 7; ++n) {
        const int rings = 3;
        const Surface<double> star = ring_mesh(n, rings, triangles);
        CAPTURE(n);
        CAPTURE(triangles);
        CHECK(star.mesh->vertices() == 1 + (triangles ? n * rings * (rings + 1) / 2 : n * rings * (rings + 1)));
        CHECK(star.mesh->faces() == n * rings * rings);
        CHECK(star.mesh->valence(0) == n);
        CHECK_FALSE(star.mesh->on_boundary(0));
        double area = 0;  // every face the same, and all counter-clockwise
        for (int f = 0; f < star.mesh->faces(); ++f) {
          double doubled = 0;
          const auto corners = star.mesh->corners(f);
          for (std::size_t k = 0; k < corners.size(); ++k) {
            const int a = corners[k], b = corners[(k + 1) % corners.size()];
            doubled += star.points(a, 0) * star.points(b, 1) - star.points(b, 0) * star.points(a, 1);
          }
          CHECK(doubled > 0.1);
          area += doubled / 2;
        }
        const double angle = 2 * std::acos(-1.0) / n, one = std::sin(angle);
        CHECK(area == doctest::Approx(n * rings * rings * (triangles ? one / 2 : one)).epsilon(1e-12));
      }
    }
    CHECK(refusal([] { ring_mesh(2, 1); }).starts_with("E_RING_MESH: no neighbourhood of 1 rings around a vertex of valence 2"));
    CHECK(refusal([] { ring_mesh(10'000, 50); }).starts_with("E_RING_MESH"));
  }
}
