// The same word on the same input in every number type: equal where exact, enclosed, or near.
#include <doctest/doctest.h>

#include "operators/run.h"
#include "tests/oracle/inputs.h"
#include "tests/oracle/words.h"

using namespace udcp;
using namespace udcp::oracle;

namespace {

bool agrees(const Rational& exact, const Rational& value) { return exact == value; }
bool agrees(const Rational& exact, const Algebraic& value) { return Algebraic(exact) == value; }
bool agrees(const Rational& exact, const Interval& value) { return value.contains(exact) && value.width() < 1e-20; }
bool agrees(const Rational& exact, const Parametric& value) { return Parametric(exact) == value; }
bool agrees(const Rational& exact, const Jet& value) { return value.is_constant() && agrees(exact, value.value()); }
// Below a hundred roundings each of values below 1e4.
bool agrees(const Rational& exact, double value) { return std::abs(exact.to_double() - value) < 1e-10; }

template <class S>
int disagreements(const Points<Rational>& exact, const Points<S>& values) {
  REQUIRE(exact.rows() == values.rows());
  int bad = 0;
  for (Eigen::Index k = 0; k < exact.size(); ++k) bad += !agrees(exact.data()[k], values.data()[k]);
  return bad;
}

Word random_scheme(Dice& dice, const std::string& atoms) {
  Word word = scheme(atoms, constant(dice.positive()), constant(dice.fraction()), constant(dice.fraction()));
  word.alpha0 = Directional<KernelPtr>::all(turn(ratio(2, 3)));
  return word;
}

// A circle kernel that is rational at alpha = 2 pi/3: cos(pi/3) = 1/2.
Word rational_circle(const std::string& atoms) {
  Word word = operation(atoms, half_cosine(), inverse_half_cosine(), value(4, 5));
  word.alpha0 = Directional<KernelPtr>::all(turn(ratio(2, 3)));
  return word;
}

}  // namespace

TEST_SUITE("operators") {
  TEST_CASE_TEMPLATE("all number types agree on curves", S, double, Rational, Algebraic, Interval, Parametric, Jet) {
    Dice dice(131);
    for (int trial = 0; trial < 25; ++trial) {
      const std::string atoms = random_atoms(dice);
      CAPTURE(atoms);
      const Word word = random_scheme(dice, atoms);
      const auto curve = random_curve<Rational>(dice, 4, dice.one_in(2));
      CHECK(disagreements(run(word, curve, 1).points, run(word, convert<S>(curve), 1).points) == 0);
    }
    const auto curve = random_curve<Rational>(dice, 3, true);
    CHECK(disagreements(run(rational_circle("UCP"), curve, 1).points, run(rational_circle("UCP"), convert<S>(curve), 1).points) ==
          0);
  }

  TEST_CASE_TEMPLATE("all number types agree on meshes", S, double, Rational, Algebraic, Interval, Parametric, Jet) {
    Dice dice(132);
    for (const auto& list : {quad_meshes(), polygon_meshes()}) {
      for (const NamedMesh& named : list) {
        CAPTURE(named.name);
        const auto surface = random_surface<Rational>(dice, named.mesh, 2);
        for (const char* atoms : {"UCP", "UDDD"}) {
          const Word word = random_scheme(dice, atoms);
          CHECK(disagreements(run(word, surface, 1).points, run(word, convert<S>(surface), 1).points) == 0);
        }
        Word classic = rational_circle("UCP");
        classic.head[1].ngon = Ngon::classic;
        CHECK(disagreements(run(classic, surface, 1).points, run(classic, convert<S>(surface), 1).points) == 0);
      }
    }
    for (const NamedMesh& named : triangle_meshes()) {
      CAPTURE(named.name);
      const auto surface = random_surface<Rational>(dice, named.mesh, 2);
      const Word word = on_triangles(random_scheme(dice, "UCP"));
      CHECK(disagreements(run(word, surface, 1).points, run(word, convert<S>(surface), 1).points) == 0);
    }
    auto ring = random_surface<Rational>(dice, *torus<double>(4, 3, 2, 1).mesh, 2);
    ring.tags = torus<double>(4, 3, 2, 1).tags;
    Word word = rational_circle("UCP");
    word.rings = Rings::both;
    CHECK(disagreements(run(word, ring, 1).points, run(word, convert<S>(ring), 1).points) == 0);
  }

  TEST_CASE_TEMPLATE("constants are reproduced whatever the parameters are", S, double, Rational, Algebraic, Interval, Parametric,
                     Jet) {
    const KernelPtr rough =
        formula([]<class T>(const Context<T>& c) { return Rational(2) + noise<T>(Rational(5), c.round, c.vertex) / Rational(4); },
                {true, true, true});
    Dice dice(133);
    const auto constant_points = [](int n) { return Points<Rational>::Constant(n, 1, Rational(7)).eval(); };
    for (const char* atoms : {"UCP", "UDD", "UCCP", "UD"}) {
      CAPTURE(atoms);
      const Word word = scheme(atoms, rough, rough, rough);
      const Polyline<Rational> curve{constant_points(4), false, {}, {}};
      const auto fine = run(word, convert<S>(curve), 1).points;
      CHECK(disagreements(constant_points(static_cast<int>(fine.rows())), fine) == 0);
      for (const Mesh& mesh : {prism(5), l_shape()}) {
        const Surface<Rational> surface{std::make_shared<const Mesh>(mesh), constant_points(mesh.vertices()), {}, {}};
        const auto points = run(word, convert<S>(surface), 1).points;
        CHECK(disagreements(constant_points(static_cast<int>(points.rows())), points) == 0);
      }
    }
  }
}
