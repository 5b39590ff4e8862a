// U, D, P on open and closed curves with corners, point by point.
#include <doctest/doctest.h>

#include "operators/atoms.h"
#include "operators/run.h"
#include "tests/oracle/inputs.h"
#include "tests/oracle/refusal.h"
#include "tests/oracle/words.h"

using namespace udcp;
using namespace udcp::oracle;

TEST_SUITE("operators") {
  TEST_CASE("U[d] puts d - 1 points on every edge") {
    Dice dice(111);
    for (const bool closed : {true, false}) {
      for (int d = 2; d <= 5; ++d) {
        const auto curve = random_curve<Rational>(dice, 4, closed, 3);
        const auto fine = up(curve, d);
        REQUIRE(fine.size() == (closed ? 4 * d : 3 * d + 1));
        for (int i = 0; i < curve.edges(); ++i)
          for (int s = 0; s < d; ++s) {
            const Points<Rational> point =
                (Rational(d - s) * curve.points.row(i) + Rational(s) * curve.points.row((i + 1) % 4)) / Rational(d);
            CHECK(fine.points.row(d * i + s) == point.row(0));
          }
        if (!closed) CHECK(fine.points.row(3 * d) == curve.points.row(3));
      }
    }
  }

  TEST_CASE("UD on an open curve cuts corners and keeps the ends") {
    Dice dice(112);
    const auto curve = random_curve<Rational>(dice, 3, false);
    const auto& p = curve.points;
    const auto fine = run(scheme("UD"), curve, 1);
    Points<Rational> expected(6, 2);
    expected.row(0) = p.row(0);
    expected.row(1) = (Rational(3) * p.row(0) + p.row(1)) / Rational(4);
    expected.row(2) = (p.row(0) + Rational(3) * p.row(1)) / Rational(4);
    expected.row(3) = (Rational(3) * p.row(1) + p.row(2)) / Rational(4);
    expected.row(4) = (p.row(1) + Rational(3) * p.row(2)) / Rational(4);
    expected.row(5) = p.row(2);
    CHECK(fine.points == expected);
    CHECK_FALSE(fine.closed);
  }

  TEST_CASE("realising the dual takes each corner before its edge") {
    Dice dice(113);
    auto curve = random_curve<Rational>(dice, 4, true);
    curve.corner = {0, 1, 0, 0};
    const auto dual = run(operation("D"), curve, 1);
    const auto& p = curve.points;
    Points<Rational> expected(5, 2);
    const Rational two(2);
    expected.row(0) = (p.row(0) + p.row(1)) / two;
    expected.row(1) = p.row(1);
    expected.row(2) = (p.row(1) + p.row(2)) / two;
    expected.row(3) = (p.row(2) + p.row(3)) / two;
    expected.row(4) = (p.row(3) + p.row(0)) / two;
    CHECK(dual.points == expected);
    CHECK(dual.corner == std::vector<char>{0, 1, 0, 0, 0});
  }

  TEST_CASE("corners and ends stay where they are under every word") {
    Dice dice(114);
    for (int trial = 0; trial < 60; ++trial) {
      auto curve = random_curve<Rational>(dice, dice.between(3, 6), dice.one_in(2));
      curve.corner.assign(static_cast<std::size_t>(curve.size()), 0);
      for (char& c : curve.corner) c = dice.one_in(3);
      const std::string text = random_atoms(dice);
      CAPTURE(text);
      CAPTURE(trial);
      const auto fine =
          run(scheme(text, constant(dice.positive()), constant(dice.fraction()), constant(dice.fraction())), curve, 1);
      std::vector<int> before, after;
      for (int i = 0; i < curve.size(); ++i)
        if (curve.is_corner(i)) before.push_back(i);
      for (int i = 0; i < fine.size(); ++i)
        if (fine.is_corner(i)) after.push_back(i);
      REQUIRE(before.size() == after.size());
      for (std::size_t k = 0; k < before.size(); ++k) CHECK(fine.points.row(after[k]) == curve.points.row(before[k]));
    }
  }

  TEST_CASE("a corner cuts a closed curve into an open one") {
    Dice dice(115);
    for (const char* atoms : {"UCP", "UD", "UDDD", "U3CP", "UDUD"}) {
      CAPTURE(atoms);
      const Word word = scheme(atoms, value(2, 3), value(5, 7), value(-3, 2));
      const auto open = random_curve<Rational>(dice, 5, false);
      Polyline<Rational> closed{open.points.topRows(4), true, {1, 0, 0, 0}, {}};
      Polyline<Rational> ring = open;
      ring.points.row(4) = ring.points.row(0);
      const Points<Rational> cut = run(word, ring, 1).points, fine = run(word, closed, 1).points;
      REQUIRE(cut.rows() == fine.rows() + 1);
      CHECK(fine == cut.topRows(fine.rows()));
    }
  }

  TEST_CASE("D weighs old points by the kernel when it acts") {
    Dice dice(116);
    const Rational f = dice.positive();
    for (const int d : {2, 3}) {
      const auto curve = random_curve<Rational>(dice, 4, true);
      const auto fine = up(curve, d);
      KernelWeights<Rational> weights;
      weights.f = Directional<Parameter<Rational>>::all(Parameter<Rational>::constant(f));
      weights.sections = d;
      const Points<Rational> dual = to_dual(fine, &weights);
      for (int i = 0; i < fine.size(); ++i) {
        const int j = (i + 1) % fine.size();
        const Rational a = i % d == 0 ? f : Rational(1), b = j % d == 0 ? f : Rational(1);
        const Points<Rational> point = (a * fine.points.row(i) + b * fine.points.row(j)) / (a + b);
        CHECK(dual.row(i) == point.row(0));
      }
      const Points<Rational> back = to_primal(fine, dual);
      for (int i = 0; i < fine.size(); ++i) {
        const Points<Rational> point = (dual.row((i + fine.size() - 1) % fine.size()) + dual.row(i)) / Rational(2);
        CHECK(back.row(i) == point.row(0));
      }
    }
  }

  TEST_CASE("P after U[d] spreads the differences linearly") {
    Dice dice(117);
    for (const bool closed : {true, false}) {
      for (const int d : {2, 3, 5}) {
        CAPTURE(d);
        const std::string u = "U" + std::to_string(d) + "C";
        const Rational omega = dice.fraction(), delta = dice.fraction();
        const auto curve = random_curve<Rational>(dice, 5, closed);
        const auto smooth = run(operation(u), curve, 1).points;
        const auto fine = run(operation(u + "P", nullptr, constant(omega), constant(delta)), curve, 1).points;
        const auto difference = [&](int i) {
          const bool corner = !closed && (i == 0 || i == 4);
          return Points<Rational>((corner ? Rational(0) : delta) * (curve.points.row(i) - smooth.row(d * i)));
        };
        for (int i = 0; i < curve.edges(); ++i)
          for (int s = 0; s < d; ++s) {
            const Rational t = ratio(s, d), weight = s == 0 ? Rational(1) : omega;
            const Points<Rational> expected =
                smooth.row(d * i + s) + weight * ((Rational(1) - t) * difference(i) + t * difference((i + 1) % 5));
            CHECK(fine.row(d * i + s) == expected.row(0));
          }
      }
    }
  }

  TEST_CASE("weights that sum to 0 have no average") {
    CHECK(refusal([] { run(scheme("UC", value(-1)), polygon<double>(4), 1); }) ==
          "E_WEIGHT: the weights of D at the ends of edge 0 sum to 0, so they have no average");
    CHECK(refusal([] { run(scheme("UC", value(-1)), polygon<Rational>(4), 1); }).starts_with("E_WEIGHT"));
    CHECK(refusal([] { run(scheme("UC", value(-1)), polygon<Interval>(4), 1); }).starts_with("E_WEIGHT"));
  }
}
