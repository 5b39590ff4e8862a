// The difference schemes of Catmull-Clark surfaces: the exact values of the specification, textbook refinement of random points,
// B-spline functions from their recursion, and what the comparison with the paper's print must find.
#include "proofs/regularity/difference_schemes.h"

#include <doctest/doctest.h>

#include <fstream>
#include <set>

#include "proofs/regularity/cell_weights.h"
#include "proofs/regularity/printed_differences.h"
#include "proofs/regularity/printed_formula.h"
#include "proofs/verdict.h"
#include "tests/oracle/inputs.h"

using namespace udcp;
using Form = Points<Rational>;

namespace {

const Json& expected() {
  static const Json json = [] {
    std::ifstream file(std::string(UDCP_TEST_DATA) + "/regularity.json");
    return Json::parse(file);
  }();
  return json;
}

const DifferenceSchemes& schemes() {
  static const DifferenceSchemes made = difference_schemes();
  return made;
}

Form row_from(const Json& numbers) {
  Form row(1, static_cast<Eigen::Index>(numbers.size()));
  for (std::size_t j = 0; j < numbers.size(); ++j)
    row(0, static_cast<Eigen::Index>(j)) = Rational::parse(numbers[j].get<std::string>());
  return row;
}

/// "1 2; 3 4"
Form matrix(const std::string& text) { return printed_table(text); }
Form row_of(const Form& a, Eigen::Index i) { return a.row(i); }
Rational half() { return Rational(1) / Rational(2); }

std::vector<Rational> with_multiplicity(const RationalSpectrum& spectrum) {
  std::vector<Rational> values;
  for (const RationalEigenvalue& v : spectrum.values)
    values.insert(values.end(), static_cast<std::size_t>(v.multiplicity), v.value);
  return values;
}

std::vector<Rational> numbers(const Json& list) {
  const Form row = row_from(list);
  return {row.data(), row.data() + row.size()};
}

/// Random points of a 3 x 4 grid, three coordinates.
Form random_grid(oracle::Dice& dice) { return oracle::random_points<Rational>(dice, 12, 3); }

/// p_ij of a grid of four columns, from 1.
Form at(const Form& points, int i, int j) { return points.row(4 * (i - 1) + j - 1); }
Form face(const Form& p, int i, int j) {
  return (at(p, i, j) + at(p, i + 1, j) + at(p, i, j + 1) + at(p, i + 1, j + 1)) / Rational(4);
}
/// p'_rs of the paper by the textbook rules: faces, edges and vertices of valence 4 inside a 3 x 4 grid.
Form textbook_point(const Form& p, int r, int s) {
  const int i = (r + 1) / 2, j = (s + 1) / 2;
  const bool on_row = r % 2 == 0, on_column = s % 2 == 0;
  const int y = r / 2 + 1, x = s / 2 + 1;  // of an old row or column
  if (!on_row && !on_column) return face(p, i, j);
  if (!on_row) return (at(p, i, x) + at(p, i + 1, x) + face(p, i, x - 1) + face(p, i, x)) / Rational(4);
  if (!on_column) return (at(p, y, j) + at(p, y, j + 1) + face(p, y - 1, j) + face(p, y, j)) / Rational(4);
  const Form faces = (face(p, y - 1, x - 1) + face(p, y - 1, x) + face(p, y, x - 1) + face(p, y, x)) / Rational(4);
  const Form middles =
      (at(p, y - 1, x) + at(p, y + 1, x) + at(p, y, x - 1) + at(p, y, x + 1) + Rational(4) * at(p, y, x)) / Rational(8);
  return (faces + Rational(2) * middles + at(p, y, x)) / Rational(4);
}

/// The B-spline functions of a degree that do not vanish on [0, 1], knots at the integers, by the recursion of Cox and de Boor.
std::vector<Polynomial<Rational>> b_splines(int degree) {
  std::vector<Polynomial<Rational>> now{Polynomial<Rational>({Rational(1)})};
  for (int d = 1; d <= degree; ++d) {
    std::vector<Polynomial<Rational>> next(static_cast<std::size_t>(d) + 1);
    for (int i = 0; i <= d; ++i) {
      // Function i starts at the knot i - d: ((t - (i - d)) B_{i-1} + (i + 1 - t) B_i)/d in the functions of one degree less.
      const Rational scale = Rational(1) / Rational(d);
      if (i > 0)
        next[static_cast<std::size_t>(i)] =
            Polynomial<Rational>({Rational(d - i) * scale, scale}) * now[static_cast<std::size_t>(i - 1)];
      if (i < d)
        next[static_cast<std::size_t>(i)] =
            next[static_cast<std::size_t>(i)] +
            Polynomial<Rational>({Rational(i + 1) * scale, -scale}) * now[static_cast<std::size_t>(i)];
    }
    now = std::move(next);
  }
  return now;
}

Polynomial<Rational> polynomial(std::initializer_list<int> coefficients, int denominator) {
  std::vector<Rational> values;
  for (const int c : coefficients) values.push_back(Rational(c) / Rational(denominator));
  return Polynomial<Rational>(std::move(values));
}

}  // namespace

TEST_SUITE_BEGIN("proofs");

TEST_CASE("the rows of forward and central differences are those of the specification") {
  for (int k = 0; k < 6; ++k) {
    CAPTURE(k);
    CHECK(row_of(schemes().xi, k) == row_from(expected()["xi"][std::to_string(k + 1)]));
    CHECK(row_of(schemes().xi, k) == row_from(expected()["S"][static_cast<std::size_t>(k)]));
    CHECK(row_of(schemes().omega, k) == row_from(expected()["omega"]));
  }
  for (int k = 0; k < 4; ++k) {
    CAPTURE(k);
    CHECK(row_of(schemes().alpha, k) == row_from(expected()["alpha"][std::to_string(k + 1)]));
    CHECK(row_of(schemes().alpha_limit, k) == row_from(expected()["S9_left_eigenvector"]));
  }
  for (int k = 0; k < 9; ++k) CHECK(row_of(schemes().s9, k) == row_from(expected()["S9"][static_cast<std::size_t>(k)]));
}

TEST_CASE("eigenvalues with multiplicities and limits of both doubled schemes are exact") {
  CHECK(with_multiplicity(schemes().twice_xi) == numbers(expected()["S1_eigenvalues"]));
  CHECK(with_multiplicity(schemes().twice_s9) == numbers(expected()["S9_times_2_eigenvalues"]));
  CHECK(schemes().twice_xi.is_diagonalisable());
  CHECK(schemes().twice_s9.is_diagonalisable());
  CHECK(common_row(schemes().limit) == row_from(expected()["S1_left_eigenvector"]));
  CHECK(common_row(schemes().limit9) == row_from(expected()["S9_left_eigenvector"]));
  CHECK(tangent_row(schemes().xi) == common_row(schemes().limit));
  for (const RationalSpectrum* spectrum : {&schemes().twice_xi, &schemes().twice_s9}) {
    const Form doubled = Rational(2) * (spectrum == &schemes().twice_xi ? schemes().xi : schemes().s9);
    for (const RationalEigenvalue& v : spectrum->values) {
      CAPTURE(v.value);
      CHECK(doubled * v.right == v.value * v.right);
      CHECK(v.left * doubled == v.value * v.left);
      CHECK(v.right.cols() == v.multiplicity);
    }
  }
}

TEST_CASE("the univariate factors have the rows and eigenvectors of cubic splines") {
  const UnivariateRows rows = univariate_rows();
  CHECK(rows.averaging == matrix("1/2 1/2 0; 1/8 6/8 1/8; 0 1/2 1/2"));
  CHECK(rows.differences == matrix("3/8 1/8; 1/8 3/8"));
  CHECK(rows.differences_of_four == matrix("3/8 1/8 0; 1/8 3/8 0; 0 3/8 1/8"));
  CHECK(rows.boundary_averaging == matrix("1 0 0; 1/2 1/2 0; 1/8 6/8 1/8"));
  CHECK(rows.boundary_differences == matrix("1/2 0; 3/8 1/8"));
  // Columns (1,1,1), (1,0,-1), (2,-1,2); (1,1,1), (1,-1,-3), (0,0,1).
  const Form v = matrix("1 1 2; 1 0 -1; 1 -1 2"), d = matrix("1 1 0; 1 -1 0; 1 -3 1");
  const Form powers = matrix("1 0 0; 0 1/2 0; 0 0 1/4");
  CHECK(rows.averaging * v == v * powers);
  CHECK(Rational(2) * rows.differences_of_four * d == d * powers);
  CHECK(Rational(2) * schemes().s9 * tensor(v, d) == tensor(v, d) * tensor(powers, powers));
  CHECK(with_multiplicity(rational_spectrum(rows.boundary_averaging)) == std::vector<Rational>{1, half(), half() / 4});
  CHECK(with_multiplicity(rational_spectrum(Rational(2) * rows.boundary_differences)) == std::vector<Rational>{1, half() / 2});
}

TEST_CASE("differences of points refined by the textbook are what the rows say") {
  oracle::Dice dice(20);
  for (int trial = 0; trial < 10; ++trial) {
    const Form p = random_grid(dice);
    const Form gamma = difference_rows(3, 4, Direction::u) * p;
    for (int k = 0; k < 9; ++k) {
      const int r = k / 3 + 1, s = k % 3 + 1;
      CAPTURE(k);
      CHECK(Form(row_of(schemes().s9, k) * gamma) == Form(textbook_point(p, r, s + 1) - textbook_point(p, r, s)));
    }
    for (const auto& [k, r, s] : {std::tuple{0, 1, 3}, {1, 1, 2}, {2, 2, 3}, {3, 2, 2}}) {
      CHECK(Form(row_of(schemes().alpha, k) * gamma) == Form(textbook_point(p, r, s + 1) - textbook_point(p, r, s - 1)));
    }
  }
}

TEST_CASE("boundary and corner schemes have non-negative weights of sum one half and the tangents of spline boundaries") {
  const DifferenceSchemes& s = schemes();
  const UnivariateRows rows = univariate_rows();
  CHECK(s.along == tensor(rows.boundary_averaging, rows.differences));
  CHECK(s.across == tensor(rows.boundary_differences, rows.averaging));
  CHECK(s.corner_u == tensor(rows.boundary_averaging, rows.boundary_differences));
  CHECK(s.corner_v == tensor(rows.boundary_differences, rows.boundary_averaging));
  for (const Form* scheme : {&s.xi, &s.s9, &s.along, &s.across, &s.corner_u, &s.corner_v}) CHECK(has_rows_of(*scheme, half()));
  CHECK(has_rows_of(s.alpha, Rational(1)));
  CHECK(tangent_row(s.along) == matrix("1/2 1/2 0 0 0 0"));
  CHECK(tangent_row(s.across) == matrix("1/6 4/6 1/6 0 0 0"));
  CHECK(tangent_row(s.corner_u) == matrix("1 0 0 0 0 0"));
  CHECK(tangent_row(s.corner_v) == matrix("1 0 0 0 0 0"));
  for (const DifferenceFact& fact : difference_facts(s, rows)) {
    CAPTURE(fact.sentence);
    CHECK(fact.holds);
  }
}

TEST_CASE("facts about other matrices do not hold") {
  DifferenceSchemes wrong = schemes();
  wrong.xi(0, 0) += Rational(1) / Rational(64);
  wrong.omega(2, 2) += Rational(1);
  wrong.along(0, 0) = Rational(-1);
  UnivariateRows rows = univariate_rows();
  rows.boundary_averaging(0, 1) = Rational(1);
  int failing = 0;
  for (const DifferenceFact& fact : difference_facts(wrong, rows)) failing += fact.holds ? 0 : 1;
  CHECK(failing == 6);  // weights of S, S = V x D2, eigenvectors, omega, boundary, corner
  CHECK_FALSE(has_rows_of(matrix("1 -1/2"), half()));
  CHECK_FALSE(has_rows_of(matrix("1/2 0; 1/4 0"), half()));
}

TEST_CASE("the limit on a cell is given by B-spline functions and by their boundary forms") {
  const CellWeights inside = cell_weights(false, false);
  CHECK(inside.points == b_splines(3));
  CHECK(inside.differences == b_splines(2));
  // Next to one boundary: (t^3 - 6t + 6, 6t - 2t^3, t^3)/6; between two: 1 - t, t.
  const CellWeights start = cell_weights(true, false), end = cell_weights(false, true), both = cell_weights(true, true);
  CHECK(start.points == std::vector{polynomial({6, -6, 0, 1}, 6), polynomial({0, 6, 0, -2}, 6), polynomial({0, 0, 0, 1}, 6)});
  CHECK(both.points == std::vector{polynomial({1, -1}, 1), polynomial({0, 1}, 1)});
  CHECK(both.differences == std::vector{polynomial({1}, 1)});
  for (std::size_t i = 0; i < 3; ++i) CHECK(composed(start.points[i], Rational(1), Rational(-1)) == end.points[2 - i]);
  for (std::size_t j = 0; j < 2; ++j) CHECK(composed(start.differences[j], Rational(1), Rational(-1)) == end.differences[1 - j]);
  for (const CellWeights* cell : {&inside, &start, &end, &both}) {
    CHECK(are_convex(cell->points));
    CHECK(are_convex(cell->differences));
  }
}

TEST_CASE("the derivative of a random patch is the combination of differences that theorem 1 asserts") {
  oracle::Dice dice(3);
  const CellWeights cell = cell_weights(false, false);
  const std::vector<Polynomial<Rational>> cubic = b_splines(3);
  for (int trial = 0; trial < 5; ++trial) {
    const Form net = oracle::random_points<Rational>(dice, 16, 3);
    const Form d = difference_rows(4, 4, Direction::u) * net;
    const Rational u = Rational(dice.between(0, 9)) / 9, v = Rational(dice.between(0, 7)) / 7;
    Form by_points = Form::Zero(1, 3), by_differences = by_points;
    Rational sum;
    for (int i = 0; i < 4; ++i) {
      for (int j = 0; j < 4; ++j) {
        const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>(j);
        by_points += Rational(cubic[b].derivative().at(u) * cubic[a].at(v)) * net.row(4 * i + j);
        if (j == 3) continue;
        const Rational weight = cell.differences[b].at(u) * cell.points[a].at(v);
        CHECK(weight >= Rational(0));
        sum += weight;
        by_differences += weight * d.row(3 * i + j);
      }
    }
    CHECK(sum == Rational(1));
    CHECK(by_points == by_differences);
  }
}

TEST_CASE("weights that are negative somewhere or do not sum to one are not convex") {
  CHECK_FALSE(are_convex({polynomial({1, -2}, 1), polynomial({0, 2}, 1)}));
  CHECK_FALSE(are_convex({polynomial({1, -1}, 2), polynomial({0, 1}, 1)}));
  CHECK_FALSE(are_convex({}));
  CHECK(bernstein_coefficients(polynomial({0, 0, 1}, 1), 3) == std::vector<Rational>{0, 0, Rational(1) / 3, 1});
  CHECK_THROWS_AS(bernstein_coefficients(polynomial({0, 0, 1}, 1), 1), Error);
}

TEST_CASE("rational spectra see Jordan blocks and refuse irrational eigenvalues") {
  const RationalSpectrum block = rational_spectrum(matrix("1/2 1 0; 0 1/2 0; 0 0 -2/3"));
  REQUIRE(block.values.size() == 2);
  CHECK(block.values[0].blocks == std::vector<int>{2});
  CHECK(block.values[0].multiplicity == 2);
  CHECK(block.values[1].value == Rational(-2) / Rational(3));
  CHECK_FALSE(block.is_diagonalisable());
  CHECK(limit_of_powers(block) == Form(Form::Zero(3, 3)));
  CHECK_THROWS_AS(rational_spectrum(matrix("0 2; 1 0")), Error);
  CHECK_THROWS_AS(rational_spectrum(matrix("0 -1; 1 0")), Error);
  for (const char* no_limit : {"1 1; 0 1", "2 0; 0 1/2", "-1 0; 0 1"}) {
    CAPTURE(no_limit);
    CHECK_THROWS_AS(limit_of_powers(rational_spectrum(matrix(no_limit))), Error);
  }
  CHECK(limit_of_powers(rational_spectrum(matrix("1 0; 1/2 1/2"))) == matrix("1 0; 1 0"));
}

TEST_CASE("differences in v direction are no combination of those in u direction") {
  const Form forms = difference_rows(3, 3, Direction::v);
  CHECK_THROWS_AS(in_differences(forms, 3, 3, Direction::u), Error);
  CHECK(in_differences(forms, 3, 3, Direction::v) == Form(Form::Identity(6, 6)));
}

TEST_CASE("the comparison with the print finds the known misprints and nothing else") {
  const std::vector<PrintedItem> items = compare_with_print(schemes());
  std::set<std::tuple<std::string, std::string, std::string>> misprints;
  std::set<std::pair<std::string, std::string>> failing;
  for (const PrintedItem& item : items) {
    if (item.verdict == PrintVerdict::misprint) misprints.insert({item.place, item.object, item.printed});
    if (item.verdict == PrintVerdict::fails) failing.insert({item.place, item.object});
  }
  CHECK(misprints ==
        decltype(misprints){{"1.1.2 item 1", "p'12 - p'11", "(0, 0, 1/16, 3/16, 1/16, 3/16)"},
                            {"1.1.2 item 2", "p'12", "(p11 + p13 + p12 + p22)/4"},
                            {"1.1.2 item 3", "p'22", "((p11 + p13 + p31 + p33)/8 + p22/2 + (p12 + p21 + p23 + p32 + 4p22)/8)/2"},
                            {"1.2.2 item 1", "p'14 - p'12", "(p12 + 6p13 + p14 + p22 + 6p23 + p24)/16"},
                            {"1.2.2 n = 2", "p''14 - p''12", "(1/16, 6/16, 1/16, 1/16, 6/16, 1/16, 0, 0, 0)"},
                            {"1.2.3", "eigenvalue of column 3 of P", "0.625"},
                            {"1.3 i = j = 2", "p22 - p21", "p22 - p12"},
                            {"1.3 i = j = 2", "p22 - p21", "p13 - p12"}});
  CHECK(failing == decltype(failing){{"1.1.3", "lim xi_k S^(n-1)"},
                                     {"1.2.3", "lim alpha_k S^(n-1)"},
                                     {"1.2.3", "alpha_k S_1^inf"},
                                     {"Theorem 3", "p_ij = (j - i, 0)"}});
  CHECK(items.size() == 67);
  for (const PrintedItem& item : items) {
    CAPTURE(item.place);
    CAPTURE(item.printed);
    // Where a formula or the eigenvalue is wrong there is a reading; it was checked against the exact value.
    const bool is_row = item.printed.starts_with("(0, 0, 1/16") || item.printed.starts_with("(1/16, 6/16");
    if (item.verdict == PrintVerdict::misprint) CHECK(item.reading.empty() == is_row);
    if (item.printed == "0.625") CHECK(item.exact == "1/16");
  }
}

TEST_CASE("other matrices disagree with the print") {
  DifferenceSchemes wrong = schemes();
  wrong.s9(8, 0) += Rational(1) / Rational(1000);  // below the blocks of the spectrum
  int misprints = 0;
  for (const PrintedItem& item : compare_with_print(wrong)) {
    if (item.object != "S_9, 81 entries") continue;
    CHECK(item.verdict == PrintVerdict::misprint);
    ++misprints;
  }
  CHECK(misprints == 2);
  wrong = schemes();
  for (RationalEigenvalue& v : wrong.twice_s9.values)
    for (Eigen::Index k = 0; k < v.right.rows(); ++k) v.right(k, 0) += Rational(k);
  for (const PrintedItem& item : compare_with_print(wrong))
    if (item.object == "column 3 of P") CHECK(item.verdict == PrintVerdict::misprint);
}

TEST_CASE("printed digits belong to a subspace or not") {
  const Form plane = matrix("1 0; 0 1; 1 1");
  const Rational tolerance = half_unit("0.0000");
  CHECK(tolerance == Rational(1) / Rational(20000));
  CHECK(half_unit("3") == half());
  CHECK(has_member_near(plane, matrix("0.3333; 0.3333; 0.6666"), tolerance));
  CHECK(has_member_near(plane, matrix("0.3333; 0.3333; 0.6667"), tolerance));  // (1/3, 1/3, 2/3)
  CHECK_FALSE(has_member_near(plane, matrix("0.3333; 0.3333; 0.6668"), tolerance));
  // The least-squares solution is 0.00005 + 1/3000000 off in one entry; the vector (1.00005, 1.00005, 2.0001) is near enough.
  CHECK(has_member_near(plane, matrix("1; 1; 2.00015"), tolerance));
  CHECK_FALSE(has_member_near(plane, matrix("1; 1; 2.000150001"), tolerance));
}

TEST_CASE("printed formulas are read as they stand") {
  const PrintedPoints points(3, 4);
  CHECK(points.form("p11 - p12 * 2/4 + (p12)/2") == points.form("p11"));
  CHECK(points.form("1/2 (p'12 + 0.5p'12) - p'12 3/4") == Form(Form::Zero(1, 12)));
  CHECK(form_text(points.form("6p12/16 - p34/16"), 4) == "(6 p12 - p34)/16");
  CHECK(form_text(points.form("p11 - p11"), 4) == "0");
  CHECK(row_text(matrix("(1/2, -1/4, 0)")) == "(2, -1, 0)/4");
  for (const char* broken : {"", "p", "p1", "p51", "p15", "p00", "p'''11", "p11 p12", "1/p11", "p11/0", "(p11", "p11)", "3",
                             "p11 +", "p11 & p12", "p11 + 1"}) {
    CAPTURE(broken);
    CHECK_THROWS_AS((void)points.form(broken), Error);
  }
  CHECK_THROWS_AS((void)points.form(std::string(100, '(') + "p11" + std::string(100, ')')), Error);
  for (const char* broken : {"", "1 2; 3", ";", "1 x"}) {
    CAPTURE(broken);
    CHECK_THROWS_AS((void)printed_table(broken), Error);
  }
}

TEST_SUITE_END();
