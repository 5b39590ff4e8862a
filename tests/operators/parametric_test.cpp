// Rational functions in named parameters against rational numbers, and words on symbols against words on numbers.
#include "operators/numbers/parametric.h"

#include <doctest/doctest.h>

#include <limits>

#include "operators/matrix.h"
#include "operators/numbers/parametric_polynomial.h"
#include "tests/oracle/inputs.h"
#include "tests/oracle/refusal.h"
#include "tests/oracle/words.h"

using namespace udcp;
using namespace udcp::oracle;

namespace {

using Point = std::map<std::string, Rational>;
const char* const names[] = {"f", "omega", "delta"};

Parametric parameter(const char* name) { return Parametric::variable(name); }

/// Fractions that no random formula below vanishes at by accident: large primes in the denominators.
Point random_point(Dice& dice) {
  Point point;
  for (const char* name : names) point[name] = Rational(dice.between(1, 1000)) / Rational(1009) + Rational(dice.between(-3, 3));
  return point;
}

/// A random formula together with its value, computed beside it in Rational. False where a division by zero came up.
struct Both {
  Parametric formula;
  Rational value;
};
Both random_formula(Dice& dice, const Point& point, int depth) {
  if (depth == 0 || dice.one_in(6)) {
    if (dice.one_in(3)) {
      const Rational number = dice.fraction();
      return {number, number};
    }
    const char* name = names[dice.below(3)];
    return {parameter(name), point.at(name)};
  }
  const Both a = random_formula(dice, point, depth - 1), b = random_formula(dice, point, depth - 1);
  switch (dice.below(4)) {
    case 0:
      return {a.formula + b.formula, a.value + b.value};
    case 1:
      return {a.formula - b.formula, a.value - b.value};
    case 2:
      return {a.formula * b.formula, a.value * b.value};
    default:
      if (b.value.is_zero()) return a;
      return {a.formula / b.formula, a.value / b.value};
  }
}

ParametricPolynomial random_polynomial(Dice& dice, int terms, int degree) {
  ParametricPolynomial result;
  for (int k = 0; k < terms; ++k) {
    ParametricPolynomial term{Rational(dice.between(-9, 9))};
    for (int d = dice.below(degree + 1); d > 0; --d) term = term * ParametricPolynomial::variable(names[dice.below(3)]);
    result = result + term;
  }
  return result;
}

bool is_reduced(const Parametric& x) {
  return gcd(x.numerator(), x.denominator()) == ParametricPolynomial(Rational(1)) &&
         x.denominator().terms.front().coefficient.sign() > 0;
}

/// Coefficient k of a mask, 0 beyond its ends.
template <class S>
S coefficient(const Mask<S>& mask, int k) {
  const int i = k - mask.first;
  return i < 0 || i >= static_cast<int>(mask.coefficients.size()) ? S(0) : mask.coefficients[static_cast<std::size_t>(i)];
}

Word symbolic_scheme(const std::string& atoms) { return scheme(atoms, symbol("f"), symbol("omega"), symbol("delta")); }
Word scheme_at(const std::string& atoms, const Point& at) {
  return scheme(atoms, constant(at.at("f")), constant(at.at("omega")), constant(at.at("delta")));
}

int disagreements(const Points<Parametric>& formulas, const Points<Rational>& values, const Point& point) {
  REQUIRE(formulas.rows() == values.rows());
  int bad = 0;
  for (Eigen::Index k = 0; k < values.size(); ++k) bad += formulas.data()[k].at(point) != values.data()[k];
  return bad;
}

}  // namespace

TEST_SUITE("operators") {
  TEST_CASE("formulas in parameters have the values of their computation in Rational") {
    Dice dice(701);
    for (int trial = 0; trial < 400; ++trial) {
      const Point point = random_point(dice);
      const Both x = random_formula(dice, point, 4);
      CAPTURE(x.formula);
      CHECK(x.formula.at(point) == x.value);
      CHECK(is_reduced(x.formula));
    }
  }

  TEST_CASE("formulas in parameters are a field and equal functions are equal") {
    Dice dice(702);
    for (int trial = 0; trial < 150; ++trial) {
      const Point point = random_point(dice);
      const Parametric x = random_formula(dice, point, 3).formula, y = random_formula(dice, point, 3).formula,
                       z = random_formula(dice, point, 3).formula;
      CAPTURE(x);
      CAPTURE(y);
      CAPTURE(z);
      CHECK((x + y) + z == x + (y + z));
      CHECK((x * y) * z == x * (y * z));
      CHECK((x + y) * z == x * z + y * z);
      CHECK(x + y == y + x);
      CHECK(x * y == y * x);
      CHECK(x - y == -(y - x));
      CHECK((x - x).is_zero());
      if (!y.is_zero()) CHECK(x / y * y == x);
      CHECK((x == y) == (x.numerator() * y.denominator() == y.numerator() * x.denominator()));
    }
  }

  TEST_CASE("fractions in parameters are reduced and print as the language reads them") {
    const Parametric f = parameter("f"), omega = parameter("omega"), delta = parameter("delta");
    CHECK(((Parametric(3) * omega * delta + 4) / (Parametric(8) * f + 8)).to_string() == "(3*delta*omega + 4)/(8*f + 8)");
    CHECK(((Parametric(1) - f * f) / (f + 1)).to_string() == "-f + 1");
    CHECK((-f / (omega * omega)).to_string() == "-f/omega^2");
    CHECK((f / (omega * delta)).to_string() == "f/(delta*omega)");
    CHECK((f / 2).to_string() == "f/2");
    CHECK((f / (omega * 2)).to_string() == "f/(2*omega)");
    CHECK((Parametric(1) / (-f - omega)).to_string() == "-1/(f + omega)");
    CHECK((f - f).to_string() == "0");
    CHECK((f * f / f / f).constant() == Rational(1));
    Parametric sum;
    for (int k = 1; k <= 12; ++k) sum += Parametric(1) / pow(f + 1, k);  // a geometric series
    CHECK(sum == (Parametric(1) - pow(f + 1, -12)) / f);
    CHECK(sum.denominator().degree("f") == 12);
    CHECK(sum.variables() == std::vector<std::string>{"f"});
  }

  TEST_CASE("common divisors of polynomials are found whatever values the cofactors share") {
    Dice dice(703);
    for (int trial = 0; trial < 150; ++trial) {
      const ParametricPolynomial a = random_polynomial(dice, 4, 3), b = random_polynomial(dice, 4, 3),
                                 g = random_polynomial(dice, 4, 3);
      if (a.is_zero() || b.is_zero() || g.is_zero()) continue;
      CAPTURE(a.to_string());
      CAPTURE(b.to_string());
      CAPTURE(g.to_string());
      const ParametricPolynomial common = gcd(a * g, b * g);
      CHECK(divide_exactly(common, g).has_value());
      CHECK(divide_exactly(a * g, common).has_value());
      CHECK(divide_exactly(b * g, common).has_value());
      CHECK(common == gcd(gcd(a, b) * g, {}));
    }
    // x(x + 1) and 2(x + 2) are both even at every integer, but have no common divisor.
    const ParametricPolynomial x = ParametricPolynomial::variable("x"), one(Rational(1)), two(Rational(2));
    CHECK(gcd(x * (x + one), two * (x + two)) == one);
    CHECK(gcd(two * x * (x + one), two * (x + two)) == two);
    CHECK(gcd({}, x - x) == ParametricPolynomial());
    CHECK_FALSE(divide_exactly(x * x + one, x + one).has_value());
    CHECK(content(x * ParametricPolynomial(ratio(4, 3)) + ParametricPolynomial(ratio(2, 5))) == ratio(2, 15));
  }

  TEST_CASE("the derivative is the difference quotient at step zero") {
    Dice dice(704);
    for (int trial = 0; trial < 60; ++trial) {
      const Parametric x = random_formula(dice, random_point(dice), 3).formula;
      CAPTURE(x);
      const Parametric step = parameter("step");
      const Parametric quotient = (x.substitute("f", parameter("f") + step) - x) / step;
      CHECK(quotient.substitute("step", 0) == x.derivative("f"));
    }
    CHECK(Parametric(7).derivative("f").is_zero());
  }

  TEST_CASE("values may be put in for parameters one by one, all at once or as enclosures") {
    Dice dice(705);
    for (int trial = 0; trial < 60; ++trial) {
      const Point point = random_point(dice);
      const Both x = random_formula(dice, point, 3);
      CAPTURE(x.formula);
      CHECK(x.formula.substitute("f", point.at("f")).substitute("omega", point.at("omega")).at(point) == x.value);
      std::map<std::string, Interval> enclosures;
      std::map<std::string, Algebraic> numbers;
      for (const auto& [name, value] : point) {
        const Rational width = Rational(1) / pow(Rational(10), 9);
        enclosures.emplace(name, Interval(value - width, value + width));
        numbers.emplace(name, value);
      }
      CHECK(x.formula.at(numbers) == Algebraic(x.value));
      try {
        CHECK(x.formula.at(enclosures).contains(x.value));
      } catch (const Error& error) {
        CHECK(error.code == "E_DIV0");  // a denominator near zero
      }
    }
    const Parametric pole = Parametric(1) / (parameter("f") - 2);
    CHECK(refusal([&] { (void)pole.at(Point{{"f", 2}}); }) == "E_DIV0: division by zero among formulas in free parameters");
    CHECK(refusal([&] { (void)pole.substitute("f", 2); }).starts_with("E_DIV0"));
    CHECK(refusal([&] { (void)pole.at(Point{{"omega", 2}}); }) == "E_NAME: the parameter 'f' has no value");
    CHECK(pole.at(std::map<std::string, Algebraic>{{"f", sqrt(Algebraic(2))}}) == -Algebraic(1) - sqrt(Algebraic(2)) / 2);
  }

  TEST_CASE("formulas in parameters are ordered only where their difference is a number") {
    const Parametric f = parameter("f");
    CHECK(f + 1 > f);
    CHECK(f <= f);
    CHECK(f != Parametric(0));
    CHECK(is_nonzero(f));
    CHECK_FALSE(is_zero(f));
    CHECK(refusal([&] { (void)(f < Parametric(1)); }) == "E_UNDECIDED: the sign of f - 1 depends on its parameters");
    CHECK(refusal([&] { (void)abs(f); }).starts_with("E_UNDECIDED"));
    CHECK(abs(Parametric(-3)) == Parametric(3));
    CHECK(sqrt(Parametric(ratio(4, 9))) == Parametric(ratio(2, 3)));
    CHECK(refusal([&] { (void)sqrt(f * f); }) == "E_NOT_EXACT: sqrt(f^2) is no rational function of its parameters");
    CHECK(refusal([&] { (void)f.constant(); }) == "E_NOT_EXACT: f is a formula in free parameters, not a number");
    CHECK(refusal([&] { (void)number<Parametric>(sqrt(Algebraic(2))); }).starts_with("E_NOT_EXACT"));
    CHECK(refusal([&] { (void)(f / (f - f)); }).starts_with("E_DIV0"));
    using Q = Quantity<Parametric>;
    CHECK(Q::of(f / f).kind() == Q::Kind::rational);
    CHECK(compare(Q::of(f), Q::of(f)) == 0);
    CHECK(refusal([&] { (void)compare(Q::of(f), Q(0)); }).starts_with("E_UNDECIDED"));
    for (const auto function :
         {cos<Parametric>, sin<Parametric>, tan<Parametric>, exp<Parametric>, log<Parametric>, sqrt<Parametric>})
      CHECK(refusal([&] { (void)function(Q::of(f)); }).starts_with("E_NOT_EXACT"));
    CHECK(refusal([&] { (void)pow(Q::of(f), Q(ratio(1, 2))); }).starts_with("E_NOT_EXACT"));
    CHECK(pow(Q::of(f), Q(-2)).value() == Parametric(1) / (f * f));
  }

  TEST_CASE("formulas that grow too large are refused before they fill the memory") {
    Parametric many;
    for (int k = 0; k < 6; ++k) many += Parametric::variable("x" + std::to_string(k));
    CHECK(refusal([&] { many += parameter("y"); }) ==
          "E_PARAMETRIC_SIZE: a formula in free parameters has more than 6 parameters");
    CHECK(refusal([&] { (void)pow(many, 9); }) == "E_PARAMETRIC_SIZE: a formula in free parameters has more than 2000 terms");
    const Parametric f = parameter("f");
    CHECK(pow(f, 200).numerator().degree() == 200);
    CHECK(refusal([&] { (void)(pow(f, 200) * f); }) == "E_PARAMETRIC_SIZE: a formula in free parameters has a degree above 200");
    CHECK(refusal([&] { (void)pow(f, -201); }) == "E_PARAMETRIC_SIZE: a power of f has a degree above 200");
    CHECK(refusal([&] { (void)pow(f + 1, std::numeric_limits<int>::min()); }).starts_with("E_PARAMETRIC_SIZE"));
    for (const char* name : {"", "2f", "a b", "f+1", "\xc3\xa9"})
      CHECK(refusal([&] { (void)Parametric::variable(name); }).starts_with("E_NAME: '" + std::string(name) + "' is no name"));
  }

  TEST_CASE("the mask of UCP in f and omega and delta is the one of the push-back paper") {
    const Parametric f = parameter("f"), omega = parameter("omega"), delta = parameter("delta");
    const Parametric a = (Parametric(1) - delta) / (4 * (f + 1)), b = omega * delta / (8 * (f + 1)), half = ratio(1, 2);
    const Mask<Parametric> found = mask<Parametric>(symbolic_scheme("UCP"));
    CHECK(found.first == -3);
    CHECK(found.coefficients == std::vector<Parametric>{-b, a, half + b, Parametric(1) - 2 * a, half + b, a, -b});
    CHECK(found.coefficients[0].to_string() == "-delta*omega/(8*f + 8)");
  }

  TEST_CASE("masks in parameters have the values of the masks at numbers") {
    Dice dice(706);
    std::vector<std::string> words{"UCCP", "UCUCP", "U3CP", "UDD", "UCPCP"};
    for (int k = 0; k < 6; ++k) words.push_back("U" + random_atoms(dice));
    for (const std::string& atoms : words) {
      CAPTURE(atoms);
      const Mask<Parametric> formulas = mask<Parametric>(symbolic_scheme(atoms));
      for (int trial = 0; trial < 3; ++trial) {
        const Point point = random_point(dice);
        const Mask<Rational> numbers = mask<Rational>(scheme_at(atoms, point));
        const int last = formulas.first + static_cast<int>(formulas.coefficients.size());
        CHECK(numbers.first >= formulas.first);
        CHECK(numbers.first + static_cast<int>(numbers.coefficients.size()) <= last);
        for (int k = formulas.first; k < last; ++k) {
          CAPTURE(k);
          CHECK(coefficient(formulas, k).at(point) == coefficient(numbers, k));
        }
      }
      Parametric sum;
      for (const Parametric& c : formulas.coefficients) sum += c;
      CHECK(sum == Parametric(formulas.arity));
    }
  }

  TEST_CASE("words on meshes run on symbols") {
    Dice dice(707);
    const Point point = random_point(dice);
    for (const NamedMesh& named : {polygon_meshes()[1], quad_meshes()[1]}) {
      CAPTURE(named.name);
      const auto surface = random_surface<Rational>(dice, named.mesh, 1);
      CHECK(disagreements(run(symbolic_scheme("UCP"), convert<Parametric>(surface), 1).points,
                          run(scheme_at("UCP", point), surface, 1).points, point) == 0);
    }
    const auto fan = random_surface<Rational>(dice, *ring_mesh(5, 1, true).mesh, 1);
    CHECK(disagreements(run(on_triangles(symbolic_scheme("UCP")), convert<Parametric>(fan), 1).points,
                        run(on_triangles(scheme_at("UCP", point)), fan, 1).points, point) == 0);
  }

  TEST_CASE("a symbol has no value in other number types") {
    CHECK(refusal([] { (void)symbol("f")->at(Context<double>{}); }) ==
          "E_NOT_EXACT: the free parameter f has no value in this number type");
    CHECK(refusal([] { (void)mask<Rational>(symbolic_scheme("UCP")); }).starts_with("E_NOT_EXACT"));
    CHECK(refusal([] { (void)symbol("1"); }).starts_with("E_NAME"));
  }
}
