// The theorem on circles: regular polygons stay regular, with the radius that the formula gives.
#include <doctest/doctest.h>

#include <cmath>

#include "operators/limit.h"
#include "operators/run.h"
#include "tests/oracle/inputs.h"
#include "tests/oracle/words.h"

using namespace udcp;
using namespace udcp::oracle;

namespace {

std::string atoms(int k) { return "U" + std::string(static_cast<std::size_t>(k), 'C') + "P"; }

// rho + delta (1 - rho) with rho = cos(th/2) cos(th/4)^(2(k-1)), th = (2 pi/corners)/2^h.
template <class S>
S factor(int corners, int k, const Rational& delta, int h) {
  const Rational th = ratio(2, corners) / pow(Rational(2), h);
  S rho = cosine<S>(th / Rational(2));
  const S quarter = cosine<S>(th / Rational(4));
  for (int i = 0; i < 2 * (k - 1); ++i) rho = rho * quarter;
  return rho + number<S>(delta) * (S(1) - rho);
}

const std::vector<Rational> deltas{ratio(-1, 10), Rational(0), ratio(1, 2), ratio(4, 5), Rational(1)};

double limit_radius(int corners, int k, double delta) {
  double radius = 1;
  for (int h = 0; h < 40; ++h) {
    const double th = 2 * std::acos(-1.0) / corners / std::pow(2.0, h);
    const double rho = std::cos(th / 2) * std::pow(std::cos(th / 4), 2 * (k - 1));
    radius *= rho + delta * (1 - rho);
  }
  return radius;
}

}  // namespace

TEST_SUITE("operators") {
  TEST_CASE("one round takes a pentagon to a decagon of exactly the radius of the theorem") {
    for (int k = 1; k <= 2; ++k) {
      for (const Rational& delta : deltas) {
        CAPTURE(k);
        CAPTURE(delta.to_string());
        const auto fine = run(circle(5, atoms(k), delta), polygon<Algebraic>(5, Algebraic(3)), 1);
        const Algebraic radius = Algebraic(3) * factor<Algebraic>(5, k, delta, 0);
        REQUIRE(fine.size() == 10);
        const auto expected = polygon<Algebraic>(10, radius);
        CHECK(fine.points == expected.points);
      }
    }
  }

  TEST_CASE("three rounds enclose the radius of the theorem narrowly") {
    for (int corners = 3; corners <= 9; ++corners) {
      for (int k = 1; k <= 2; ++k) {
        for (const Rational& delta : deltas) {
          CAPTURE(corners);
          CAPTURE(k);
          CAPTURE(delta.to_string());
          auto curve = polygon<Interval>(corners);
          const Word word = circle(corners, atoms(k), delta);
          for (int round = 0; round < 3; ++round) {
            RunControl control;
            control.first_item = word.items(round);
            curve = run(word, curve, 1, control);
            const Interval expected = [&] {
              const Interval::Precision finer(256);
              Interval product(1);
              for (int h = 0; h <= round; ++h) product *= factor<Interval>(corners, k, delta, h);
              return product;
            }();
            CHECK(expected.width() < 1e-25);
            double widest = 0;
            bool contained = true;
            for (int i = 0; i < curve.size(); ++i) {
              const Interval radius = sqrt(curve.points(i, 0) * curve.points(i, 0) + curve.points(i, 1) * curve.points(i, 1));
              contained &= radius.contains(expected);
              widest = std::max(widest, radius.width());
            }
            CHECK(contained);
            CHECK(widest < 1e-25);
          }
        }
      }
    }
  }

  TEST_CASE("radii after three rounds and in the limit are the published ones") {
    // The table of an independent computation: corners, k, delta, radius after three rounds, limit radius.
    struct Published {
      int corners, k;
      Rational delta;
      double after_three, limit;
    };
    const std::vector<Published> table{{3, 1, Rational(1), 1.0, 1.0},
                                       {3, 1, Rational(0), 0.41825815186890397, 0.41349667156634407},
                                       {5, 1, ratio(4, 5), 0.9500435002733065, 0.9492625705317671},
                                       {4, 2, ratio(1, 2), 0.7463227822203755, 0.7427365277000754},
                                       {7, 3, ratio(3, 10), 0.832351163145672, 0.8299100987616361},
                                       {6, 2, Rational(0), 0.757366262395877, 0.7541274995148415},
                                       {5, 1, ratio(-1, 10), 0.7372693955546511, 0.7339386929160857}};
    for (const Published& row : table) {
      CAPTURE(row.corners);
      CAPTURE(row.k);
      CAPTURE(row.delta.to_string());
      const Word word = circle(row.corners, atoms(row.k), row.delta);
      const auto start = polygon<double>(row.corners);
      const auto fine = run(word, start, 3);
      CHECK((fine.points.rowwise().norm().array() - row.after_three).abs().maxCoeff() < 1e-12);
      const Points<double> limits = limit(word, start);
      CHECK((limits.rowwise().norm().array() - row.limit).abs().maxCoeff() < 1e-12);
      CHECK(std::abs(limit_radius(row.corners, row.k, row.delta.to_double()) - row.limit) < 1e-12);
    }
  }

  TEST_CASE("U D^m takes polygons to circles of radius sin(th)/th times powers of the half angle") {
    for (int m = 1; m <= 4; ++m) {
      const int corners = 6;
      Word word = scheme("U" + std::string(static_cast<std::size_t>(m), 'D'), half_cosine());
      word.alpha0 = Directional<KernelPtr>::all(turn(ratio(2, corners)));
      const auto fine = run(word, polygon<double>(corners), 10);
      const double th = 2 * std::acos(-1.0) / corners, half = std::sin(th / 2) / (th / 2);
      const double expected = std::sin(th) / th * std::pow(half, m - 2);
      CAPTURE(m);
      // what the rounds after the tenth would still change: a factor of 1 - O((th/2^10)^2), below 1e-6
      CHECK((fine.points.rowwise().norm().array() - expected).abs().maxCoeff() < 1e-6);
      CHECK(fine.points.rowwise().norm().maxCoeff() - fine.points.rowwise().norm().minCoeff() < 1e-13);
    }
  }

  TEST_CASE("a kernel for another polygon leaves the circle") {
    const auto fine = run(circle(6, "UCP", ratio(1, 2)), polygon<Algebraic>(5), 1);
    const auto square = [&](int i) -> Algebraic {
      return fine.points(i, 0) * fine.points(i, 0) + fine.points(i, 1) * fine.points(i, 1);
    };
    CHECK(square(0) != square(1));
  }
}
