// The classical curve schemes among the words, coefficient by coefficient, and the symbols of the theorems.
#include <doctest/doctest.h>

#include "operators/matrix.h"
#include "operators/run.h"
#include "tests/oracle/inputs.h"
#include "tests/oracle/polynomial.h"
#include "tests/oracle/words.h"

using namespace udcp;
using namespace udcp::oracle;

namespace {

std::vector<Rational> over(std::vector<int> numerators, int denominator) {
  std::vector<Rational> result;
  for (const int p : numerators) result.push_back(ratio(p, denominator));
  return result;
}

Rational binomial(int n, int k) { return k == 0 ? Rational(1) : binomial(n - 1, k - 1) * ratio(n, k); }

// 1 + 2 c z + z^2 with c = cos(alpha/2) for alpha = q pi, and 1 + z.
Polynomial<Algebraic> circle_factor(const Rational& q) { return {1, Algebraic(2) * cosine<Algebraic>(q / Rational(2)), 1}; }
const Polynomial<Algebraic> line_factor{1, 1};

Word push_back_word(int k, const Rational& delta, const Rational& turns) {
  Word word =
      scheme("U" + std::string(static_cast<std::size_t>(k), 'C') + "P", half_cosine(), inverse_half_cosine(), constant(delta));
  word.alpha0 = Directional<KernelPtr>::all(turn(turns));
  return word;
}

}  // namespace

TEST_SUITE("operators") {
  TEST_CASE("UCP is the four-point scheme and UCCP the same on curves") {
    const auto four_point = over({-1, 0, 9, 16, 9, 0, -1}, 16);
    for (const char* atoms : {"UCP", "UCCP"}) {
      const Mask<Rational> m = mask<Rational>(scheme(atoms));
      CHECK(m.coefficients == four_point);
      CHECK(m.first == -3);
      CHECK(m.arity == 2);
      CHECK(m.shift == Rational(0));
    }
  }

  TEST_CASE("on meshes UCCP differs from UCP") {
    Dice dice(11);
    const auto surface = random_surface<Rational>(dice, *torus<double>(6, 5, 2, 1).mesh);
    CHECK(run(scheme("UCP"), surface, 1).points != run(scheme("UCCP"), surface, 1).points);
  }

  TEST_CASE("UCP with delta -1/2 is UCC and the quintic spline") {
    const auto quintic = over({1, 6, 15, 20, 15, 6, 1}, 32);
    CHECK(mask<Rational>(scheme("UCP", nullptr, nullptr, value(-1, 2))).coefficients == quintic);
    CHECK(mask<Rational>(scheme("UCC")).coefficients == quintic);
  }

  TEST_CASE("UC is the cubic spline") {
    const Mask<Rational> m = mask<Rational>(scheme("UC"));
    CHECK(m.coefficients == over({1, 4, 6, 4, 1}, 8));
    CHECK(m.first == -2);
  }

  TEST_CASE("U D^m is the spline of degree m + 1") {
    for (int m = 1; m <= 6; ++m) {
      CAPTURE(m);
      const Mask<Rational> found = mask<Rational>(scheme("U" + std::string(static_cast<std::size_t>(m), 'D')));
      std::vector<Rational> expected;
      for (int i = 0; i <= m + 2; ++i) expected.push_back(binomial(m + 2, i) / pow(Rational(2), m + 1));
      CHECK(found.coefficients == expected);
      CHECK(found.shift == (m % 2 == 0 ? Rational(0) : ratio(1, 2)));
      CHECK(found.first == -(m + 3) / 2);
    }
  }

  TEST_CASE("U D^m with f = cos(alpha/2) is the exponential spline of order m + 2") {
    for (const Rational& q : {ratio(2, 5), ratio(1, 3), ratio(2, 7), ratio(1, 2)}) {
      for (int m = 1; m <= 4; ++m) {
        for (int round = 0; round < 2; ++round) {
          CAPTURE(q.to_string());
          CAPTURE(m);
          CAPTURE(round);
          Word word = scheme("U" + std::string(static_cast<std::size_t>(m), 'D'), half_cosine());
          word.alpha0 = Directional<KernelPtr>::all(turn(q));
          const Rational now = q / pow(Rational(2), round);
          const Algebraic f = cosine<Algebraic>(now / Rational(2));
          auto expected = times(power(line_factor, m), circle_factor(now));
          for (Algebraic& c : expected) c /= pow(Algebraic(2), m) * (Algebraic(1) + f);
          CHECK(mask<Algebraic>(word, round).coefficients == expected);
        }
      }
    }
  }

  TEST_CASE("symbols of U C^k P generate lines and circles for every delta") {
    Dice dice(12);
    for (int k = 1; k <= 3; ++k) {
      for (const Rational& q : {ratio(2, 5), ratio(1, 3), ratio(2, 7)}) {
        const Rational delta = dice.fraction();
        CAPTURE(k);
        CAPTURE(q.to_string());
        CAPTURE(delta.to_string());
        const auto divisor = times(power(line_factor, 2), circle_factor(q));
        for (const Algebraic& rest : remainder(mask<Algebraic>(push_back_word(k, delta, q)).coefficients, divisor))
          CHECK(rest == Algebraic(0));
      }
    }
  }

  TEST_CASE("a kernel for another angle does not generate the circle") {
    const auto divisor = times(power(line_factor, 2), circle_factor(ratio(2, 5)));
    bool exact = true;
    for (const Algebraic& rest : remainder(mask<Algebraic>(push_back_word(1, ratio(1, 2), ratio(1, 3))).coefficients, divisor))
      exact &= rest == Algebraic(0);
    CHECK_FALSE(exact);
  }

  TEST_CASE("UCP with delta 1 reproduces circles as the four-point scheme with w = 1/(8c(1+c))") {
    for (const Rational& q : {ratio(2, 5), ratio(1, 3), ratio(2, 9)}) {
      for (int round = 0; round < 3; ++round) {
        CAPTURE(q.to_string());
        CAPTURE(round);
        const Algebraic c = cosine<Algebraic>(q / pow(Rational(2), round + 1));
        const Algebraic w = Algebraic(1) / (Algebraic(8) * c * (Algebraic(1) + c)), near = Algebraic(ratio(1, 2)) + w;
        CHECK(mask<Algebraic>(push_back_word(1, Rational(1), q), round).coefficients ==
              std::vector<Algebraic>{-w, Algebraic(0), near, Algebraic(1), near, Algebraic(0), -w});
      }
    }
  }

  TEST_CASE("the mask of UCP with constant parameters is the formula of the paper") {
    Dice dice(13);
    for (int trial = 0; trial < 50; ++trial) {
      const Rational f = dice.positive(), omega = dice.fraction(), delta = dice.fraction();
      CAPTURE(f.to_string());
      CAPTURE(omega.to_string());
      CAPTURE(delta.to_string());
      const Rational four = Rational(4) * (Rational(1) + f), a = (Rational(1) - delta) / four,
                     b = omega * delta / (Rational(2) * four);
      const Rational half = ratio(1, 2) + b, middle = Rational(1) - Rational(2) * a;
      const std::vector<Rational> expected{-b, a, half, middle, half, a, -b};
      const Mask<Rational> m = mask<Rational>(scheme("UCP", constant(f), constant(omega), constant(delta)));
      for (int k = -3; k <= 3; ++k) {
        const auto i = static_cast<std::size_t>(k - m.first);
        CHECK((k < m.first || i >= m.coefficients.size() ? Rational(0) : m.coefficients[i]) ==
              expected[static_cast<std::size_t>(k + 3)]);
      }
    }
  }

  TEST_CASE("C after U has the even and odd rule of the paper") {
    const Rational f = ratio(3, 7), sum = Rational(2) + Rational(2) * f;
    const Mask<Rational> m = mask<Rational>(scheme("UC", constant(f)));
    // applied to the points of U: even (P' + 2f P' + P')/(2 + 2f), odd (f P' + 2 P' + f P')/(2 + 2f)
    const std::vector<Rational> even{Rational(1) / sum, Rational(2) * f / sum, Rational(1) / sum};
    const std::vector<Rational> odd{f / sum, Rational(2) / sum, f / sum};
    const std::vector<Rational> up{ratio(1, 2), Rational(1), ratio(1, 2)};  // mask of U, from -1
    for (int k = -2; k <= 2; ++k) {
      Rational expected;
      for (int j = -1; j <= 1; ++j)  // new point k reads the points k + j of U
        if (k + j >= -1 && k + j <= 1)
          expected += (k % 2 == 0 ? even : odd)[static_cast<std::size_t>(j + 1)] * up[static_cast<std::size_t>(k + j + 1)];
      CHECK(m.coefficients[static_cast<std::size_t>(k - m.first)] == expected);
    }
  }
}
