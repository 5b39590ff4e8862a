// The comparison with the print: formulas as linear forms, rows in differences, decimals by their digits, eigenvectors by exact
// vectors that have those digits.
#include "proofs/regularity/printed_differences.h"

#include <algorithm>
#include <bit>

#include "proofs/regularity/printed_differences_data.h"
#include "proofs/regularity/printed_formula.h"

namespace udcp {
namespace {

using Index = Eigen::Index;

PrintVerdict verdict(bool agrees, PrintVerdict otherwise = PrintVerdict::misprint) {
  return agrees ? PrintVerdict::agrees : otherwise;
}

PrintedItem compared(const printed::Formula& line, const PrintedPoints& points) {
  const Points<Rational> exact = points.form(line.object);
  PrintedItem item{line.place, line.object, line.text, form_text(exact, points.columns()),
                   verdict(points.form(line.text) == exact)};
  if (line.reading != nullptr && item.verdict == PrintVerdict::misprint && points.form(line.reading) == exact)
    item.reading = line.reading;
  return item;
}

/// eta are the differences of 3 x 3 points, gamma those of 3 x 4.
PrintedItem compared(const printed::Row& line) {
  const Points<Rational> found = printed_table(line.text);
  const int columns = static_cast<int>(found.cols()) / 3 + 1;
  const Points<Rational> exact = in_differences(PrintedPoints(3, columns).form(line.object), 3, columns, Direction::u);
  return {line.place, line.object, line.text, row_text(exact), verdict(found == exact)};
}

std::string decimal(const Rational& value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value.to_double());
  return text;
}

Points<Rational> column_of(const Points<Rational>& a, Index j) { return a.col(j); }

Rational largest_modulus(const Points<Rational>& a) {
  Rational most;
  for (Index k = 0; k < a.size(); ++k) most = std::max(most, abs(a.data()[k]));
  return most;
}

/// The one eigenvalue to which the printed digits of an eigenvector belong; null if there is none or more than one.
const RationalEigenvalue* eigenvalue_of(const Points<Rational>& column, const RationalSpectrum& spectrum) {
  const RationalEigenvalue* found = nullptr;
  for (const RationalEigenvalue& v : spectrum.values) {
    if (!has_member_near(v.right, column, half_unit(printed::digits))) continue;
    if (found != nullptr) return nullptr;
    found = &v;
  }
  return found;
}

void add_eigenvectors(const DifferenceSchemes& exact, std::vector<PrintedItem>& items) {
  const Points<Rational> p = printed_table(printed::eigenvectors);
  const std::vector<std::vector<std::string>> entries = printed_entries(printed::eigenvectors);
  for (Index j = 0; j < p.cols(); ++j) {
    const std::string number = std::to_string(j + 1);
    const Points<Rational> column = column_of(p, j);
    std::string digits;
    for (const std::vector<std::string>& row : entries) digits += (digits.empty() ? "" : ", ") + row[static_cast<std::size_t>(j)];
    PrintedItem value{"1.2.3", "eigenvalue of column " + number + " of P", printed::diagonal[j], "", PrintVerdict::misprint};
    PrintedItem vector{"1.2.3", "column " + number + " of P", "(" + digits + ")", "", PrintVerdict::misprint};
    if (const RationalEigenvalue* found = eigenvalue_of(column, exact.twice_s9)) {
      const Points<Rational> image = exact.s9 * column;
      const Points<Rational> residual = Rational(2) * image - found->value * column;
      value.exact = found->value.to_string();
      value.verdict = verdict(Rational::parse(value.printed) == found->value);
      if (value.verdict == PrintVerdict::misprint) value.reading = decimal(found->value);
      vector.exact = "the digits of an eigenvector of " + value.exact + ", residual " + decimal(largest_modulus(residual));
      vector.verdict = PrintVerdict::agrees;
    } else {
      value.exact = vector.exact = "the column has the digits of no eigenvector";
    }
    items.push_back(std::move(value));
    items.push_back(std::move(vector));
  }
}

void add_matrices(const DifferenceSchemes& exact, std::vector<PrintedItem>& items) {
  const Points<Rational> s9 = printed_table(printed::s9);
  for (const char* place : {"1.2.2 n = 2", "1.2.3"})
    items.push_back({place, "S_9, 81 entries", "rows " + row_text(s9.topRows(1)) + ", ..",
                     "rows " + row_text(exact.s9.topRows(1)) + ", ..", verdict(s9 == exact.s9)});
  const PrintedPoints points(3, 4);
  const Points<Rational> two_rounds = in_differences(points.form("p''14 - p''12"), 3, 4, Direction::u);
  items.push_back(
      {"1.2.2 n = 2", "p''14 - p''12", "alpha_1 S_9", row_text(two_rounds), verdict(exact.alpha.topRows(1) * s9 == two_rounds)});
  add_eigenvectors(exact, items);
  const Points<Rational> row = printed_table(printed::limit_row);
  bool agrees = row.cols() == exact.limit9.cols();
  for (Index i = 0; agrees && i < exact.limit9.rows(); ++i) {
    const Points<Rational> off = exact.limit9.row(i) - row.row(0);
    agrees = largest_modulus(off) <= half_unit(printed::digits);
  }
  items.push_back({"1.2.3", "S_1^inf, 81 entries", std::string("nine rows ") + printed::limit_row,
                   "nine rows " + row_text(common_row(exact.limit9)), verdict(agrees)});
}

/// Whether the entries lie in 0 .. 1 and every row has this sum; "entries 0 .. 9/32, sums 1/2".
PrintedItem compared_weights(const std::string& place, const std::string& object, const std::string& text,
                             const Points<Rational>& weights, const Rational& sum) {
  const Points<Rational> sums = weights.rowwise().sum();
  const auto range = [](const Points<Rational>& values) {
    const auto [least, most] = std::minmax_element(values.data(), values.data() + values.size());
    return least->to_string() + (*least == *most ? "" : " .. " + most->to_string());
  };
  const bool small =
      std::all_of(weights.data(), weights.data() + weights.size(), [](const Rational& w) { return w <= Rational(1); });
  return {place, object, text, "entries " + range(weights) + ", sums " + range(sums),
          verdict(has_rows_of(weights, sum) && small, PrintVerdict::fails)};
}

/// The paper drops the factor 2 of S_1 = 2 S on the way to its limit: without it the differences tend to 0.
PrintedItem compared_limit(const std::string& place, const std::string& name, const Points<Rational>& rows,
                           const Points<Rational>& matrix, const Points<Rational>& scaled_limit) {
  const Points<Rational> limit = rows * limit_of_powers(rational_spectrum(matrix));
  return {place, "lim " + name + " S^(n-1)", name + " S_1^inf, S_1 = 2 S",
          row_text(common_row(limit)) + "; 2^(n-1) times it tends to " + row_text(common_row(scaled_limit)),
          verdict(limit == scaled_limit, PrintVerdict::fails)};
}

/// Theorem 3 as printed, on the points p_ij = (j - i, 0): all u-differences are (1, 0), all v-differences (-1, 0).
PrintedItem compared_theorem3(const DifferenceSchemes& exact) {
  Points<Rational> points = Points<Rational>::Zero(9, 2);
  for (int k = 0; k < 9; ++k) points(k, 0) = Rational(k % 3 - k / 3);
  const Points<Rational> u = difference_rows(3, 3, Direction::u) * points, v = difference_rows(3, 3, Direction::v) * points;
  bool cones_meet_in_zero = true;  // all on one line, u and v on opposite sides
  for (Index i = 0; i < u.rows(); ++i)
    for (Index j = 0; j < v.rows(); ++j)
      cones_meet_in_zero = cones_meet_in_zero && u(i, 1).is_zero() && v(j, 1).is_zero() && (u(i, 0) * v(j, 0)).sign() < 0;
  // The differences of a kind are one vector, so the order in which the weights of S_u meet those of v does not matter.
  const Points<Rational> weights = common_row(exact.limit);
  const Points<Rational> du = weights * u, dv = weights * v;
  const Rational determinant = du(0, 0) * dv(0, 1) - du(0, 1) * dv(0, 0);
  return {"Theorem 3", "p_ij = (j - i, 0)", "cones of differences that do not meet make the surface regular",
          "cones " + std::string(cones_meet_in_zero ? "meet in 0 only" : "meet") + ", det(S_u, S_v) = " + determinant.to_string(),
          verdict(!cones_meet_in_zero || !determinant.is_zero(), PrintVerdict::fails)};
}

void add_statements(const DifferenceSchemes& exact, std::vector<PrintedItem>& items) {
  const Rational half = Rational(1) / Rational(2);
  items.push_back(compared_weights("1.1.3", "xi_1 .. xi_6", "entries in 0 .. 1, sum 0.5", exact.xi, half));
  items.push_back(compared_limit("1.1.3", "xi_k", exact.xi, exact.xi, exact.omega));
  items.push_back(compared_weights("Theorem 1", "omega_1 .. omega_6", "entries in 0 .. 1", exact.omega, half));
  items.push_back(compared_weights("1.2.3", "alpha_1 .. alpha_4", "entries in 0 .. 1, sum 1", exact.alpha, Rational(1)));
  items.push_back(compared_limit("1.2.3", "alpha_k", exact.alpha, exact.s9, exact.alpha_limit));
  const Points<Rational> product = exact.alpha.topRows(1) * exact.limit9;
  items.push_back({"1.2.3", "alpha_k S_1^inf", "a column vector",
                   std::to_string(product.rows()) + " x " + std::to_string(product.cols()) + ", a row vector",
                   verdict(product.cols() == 1, PrintVerdict::fails)});
  items.push_back(compared_weights("Theorem 2", "alpha_k S_1^inf", "entries in 0 .. 1", exact.alpha_limit, Rational(1)));
  items.push_back(compared_theorem3(exact));
}

}  // namespace

std::string to_string(PrintVerdict verdict) {
  return verdict == PrintVerdict::agrees ? "agrees" : verdict == PrintVerdict::misprint ? "misprint" : "does not hold";
}

std::vector<PrintedItem> compare_with_print(const DifferenceSchemes& exact) {
  std::vector<PrintedItem> items;
  const PrintedPoints points(3, 4);
  for (const printed::Formula& line : printed::formulas) items.push_back(compared(line, points));
  for (const printed::Row& line : printed::rows) items.push_back(compared(line));
  add_matrices(exact, items);
  add_statements(exact, items);
  std::stable_sort(items.begin(), items.end(), [](const PrintedItem& a, const PrintedItem& b) { return a.place < b.place; });
  return items;
}

// The vectors within the tolerance are a bounded polytope in the coordinates of the span, so if there is one there is a corner:
// as many entries as coordinates are off by exactly the tolerance.
bool has_member_near(const Points<Rational>& basis, const Points<Rational>& column, const Rational& tolerance) {
  const auto dimension = static_cast<int>(basis.cols());
  const auto n = static_cast<unsigned>(basis.rows());
  for (unsigned subset = 0; subset < (1U << n); ++subset) {
    if (std::popcount(subset) != dimension) continue;
    Points<Rational> chosen(dimension, dimension), right(dimension, 1);
    Index row = 0;
    for (unsigned i = 0; i < n; ++i)
      if ((subset >> i & 1U) != 0) chosen.row(row) = basis.row(i), right(row++, 0) = column(i, 0);
    if (rank(chosen) < dimension) continue;
    for (unsigned signs = 0; signs < (1U << dimension); ++signs) {
      Points<Rational> ends = right;
      for (int k = 0; k < dimension; ++k) ends(k, 0) += (signs >> k & 1U) != 0 ? tolerance : -tolerance;
      const Points<Rational> off = basis * solve(chosen, ends).value() - column;
      if (largest_modulus(off) <= tolerance) return true;
    }
  }
  return false;
}

}  // namespace udcp
