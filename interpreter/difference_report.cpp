// The report on the difference schemes of Catmull-Clark surfaces and on what the paper about them prints: tables for people, JSON
// for programs. The numbers come from proofs/regularity/difference_schemes.h and printed_differences.h.
#include <algorithm>

#include "interpreter/analysis.h"
#include "interpreter/arguments.h"
#include "proofs/regularity/cell_weights.h"
#include "proofs/regularity/printed_differences.h"
#include "proofs/regularity/printed_formula.h"

namespace udcp {
namespace {

using Index = Eigen::Index;
using Table = std::vector<std::vector<std::string>>;

/// Rows of cells under a title, columns aligned; the last one runs free.
std::string text_of(const std::string& title, const Table& table) {
  std::vector<std::size_t> widths;
  for (const std::vector<std::string>& row : table) {
    widths.resize(std::max(widths.size(), row.size()));
    for (std::size_t c = 0; c < row.size(); ++c) widths[c] = std::max(widths[c], row[c].size());
  }
  std::string text = "\n" + title + "\n";
  for (const std::vector<std::string>& row : table) {
    std::string line = " ";
    for (std::size_t c = 0; c < row.size(); ++c)
      line += " " + row[c] + (c + 1 < row.size() ? std::string(widths[c] - row[c].size() + 1, ' ') : "");
    text += line + "\n";
  }
  return text;
}

Points<Rational> row_of(const Points<Rational>& matrix, Index i) { return matrix.row(i); }
Points<Rational> doubled(const Points<Rational>& matrix) { return Rational(2) * matrix; }

Json json_of(const Points<Rational>& matrix) {
  Json rows = Json::array();
  for (Index i = 0; i < matrix.rows(); ++i) {
    Json row = Json::array();
    for (Index j = 0; j < matrix.cols(); ++j) row.push_back(matrix(i, j).to_string());
    rows.push_back(std::move(row));
  }
  return rows;
}

/// "1 - 3 t + 1/2 t^2"
std::string polynomial_text(const Polynomial<Rational>& p) {
  std::string text;
  for (std::size_t k = 0; k < p.coefficients.size(); ++k) {
    const Rational& c = p.coefficients[k];
    if (c.is_zero()) continue;
    const std::string power = k == 0 ? "" : k == 1 ? "t" : "t^" + std::to_string(k);
    const std::string size = abs(c) == Rational(1) && k > 0 ? "" : abs(c).to_string() + (k > 0 ? " " : "");
    text += (text.empty() ? (c.sign() < 0 ? "-" : "") : (c.sign() < 0 ? " - " : " + ")) + size + power;
  }
  return text.empty() ? "0" : text;
}

/// What is computed, once; text, JSON and parts are made from it.
struct Material {
  DifferenceSchemes schemes = difference_schemes();
  UnivariateRows rows = univariate_rows();
  std::vector<DifferenceFact> facts = difference_facts(schemes, rows);
  std::vector<PrintedItem> items = compare_with_print(schemes);

  /// The matrices by name, doubled where the limit is that of the doubled ones.
  [[nodiscard]] std::vector<std::pair<std::string, Points<Rational>>> limit_matrices() const {
    return {{"2 S", doubled(schemes.xi)},
            {"2 S_9", doubled(schemes.s9)},
            {"V", rows.averaging},
            {"2 D2", doubled(rows.differences)},
            {"2 D3", doubled(rows.differences_of_four)},
            {"Vb", rows.boundary_averaging},
            {"2 Db", doubled(rows.boundary_differences)}};
  }
  /// Schemes of forward differences by place, with the tangent that they tend to.
  [[nodiscard]] std::vector<std::tuple<std::string, std::string, Points<Rational>>> tangents() const {
    return {{"inside, on eta", "S_u at p22", schemes.xi},      {"inside, on gamma", "S_u at p22", schemes.s9},
            {"along a boundary", "S_u at p12", schemes.along}, {"across a boundary", "S_v at p12", schemes.across},
            {"at a corner", "S_u at p11", schemes.corner_u},   {"at a corner", "S_v at p11", schemes.corner_v}};
  }
};

// ---- Text

std::string schemes_text(const Material& m) {
  const char* forward[] = {"p'12 - p'11", "p'13 - p'12", "p'22 - p'21", "p'23 - p'22", "p'32 - p'31", "p'33 - p'32"};
  const char* central[] = {"p'14 - p'12", "p'13 - p'11", "p'24 - p'22", "p'23 - p'21"};
  Table xi, alpha, s9;
  for (Index k = 0; k < 6; ++k) xi.push_back({"xi_" + std::to_string(k + 1), forward[k], row_text(row_of(m.schemes.xi, k))});
  for (Index k = 0; k < 4; ++k)
    alpha.push_back({"alpha_" + std::to_string(k + 1), central[k], row_text(row_of(m.schemes.alpha, k))});
  for (Index k = 0; k < 9; ++k) {
    const std::string i = std::to_string(k / 3 + 1);
    s9.push_back(
        {"p'" + i + std::to_string(k % 3 + 2) + " - p'" + i + std::to_string(k % 3 + 1), row_text(row_of(m.schemes.s9, k))});
  }
  return text_of("Forward differences, weights of eta; together the matrix S", xi) +
         text_of("Central differences, weights of gamma", alpha) +
         text_of("The matrix S_9: forward differences, weights of gamma", s9);
}

std::string univariate_text(const Material& m) {
  Table table;
  const auto add = [&](const std::string& name, const std::string& what, const Points<Rational>& matrix) {
    for (Index i = 0; i < matrix.rows(); ++i)
      table.push_back({i == 0 ? name : "", i == 0 ? what : "", row_text(row_of(matrix, i))});
  };
  add("V", "averaging of points", m.rows.averaging);
  add("D2", "differences, from two", m.rows.differences);
  add("D3", "differences, from three", m.rows.differences_of_four);
  add("Vb", "averaging from a boundary point on", m.rows.boundary_averaging);
  add("Db", "differences from a boundary point on", m.rows.boundary_differences);
  return text_of("The factors of the tensor products, from curves", table);
}

std::string eigenvalues_text(const RationalSpectrum& spectrum) {
  std::string text;
  for (const RationalEigenvalue& v : spectrum.values)
    text += (text.empty() ? "" : ", ") + v.value.to_string() +
            (v.multiplicity > 1 ? " (" + std::to_string(v.multiplicity) + " times)" : "");
  return text;
}

std::string spectra_text(const Material& m) {
  Table values, tangents;
  for (const auto& [name, matrix] : m.limit_matrices()) {
    const RationalSpectrum spectrum = rational_spectrum(matrix);
    values.push_back({name, eigenvalues_text(spectrum),
                      "rows of the limit of its powers: " + row_text(common_row(limit_of_powers(spectrum)))});
  }
  for (const auto& [place, what, scheme] : m.tangents()) tangents.push_back({place, what, row_text(tangent_row(scheme))});
  return text_of("Eigenvalues", values) +
         text_of("Limits: 2^n times the forward differences of level n at a vertex tend to this combination of old differences",
                 tangents);
}

std::string cells_text() {
  Table table{{"ends", "weights of", "", "Bernstein coefficients"}};
  for (const auto& [start, end, name] :
       {std::tuple{false, false, "inside"}, {true, false, "boundary at t = 0"}, {true, true, "boundary at both"}}) {
    const CellWeights weights = cell_weights(start, end);
    std::string shown = name;
    const auto add = [&](const char* what, const std::vector<Polynomial<Rational>>& polynomials, int degree) {
      for (const Polynomial<Rational>& p : polynomials) {
        const std::vector<Rational> coefficients = bernstein_coefficients(p, degree);
        Points<Rational> row(1, static_cast<Index>(coefficients.size()));
        std::copy(coefficients.begin(), coefficients.end(), row.data());
        table.push_back({std::exchange(shown, ""), std::exchange(what, ""), polynomial_text(p), row_text(row)});
      }
    };
    add("points", weights.points, 3);
    add("differences", weights.differences, 2);
  }
  return text_of("Limit curves on a cell, 0 <= t <= 1; S_u has the weights (differences in u) x (points in v)", table);
}

std::string items_text(const Material& m) {
  Table table;
  int agree = 0, misprints = 0;
  for (const PrintedItem& item : m.items) {
    const bool good = item.verdict == PrintVerdict::agrees;
    agree += good ? 1 : 0;
    misprints += item.verdict == PrintVerdict::misprint ? 1 : 0;
    table.push_back({to_string(item.verdict), item.place, item.object, "printed: " + item.printed});
    table.push_back({"", "", "", "exact:   " + item.exact});
    if (good && item.exact == item.printed) table.pop_back();
    if (!item.reading.empty()) table.push_back({"", "", "", "read:    " + item.reading});
  }
  const int failing = static_cast<int>(m.items.size()) - agree - misprints;
  return text_of("The paper's print", table) + "\nOf " + std::to_string(m.items.size()) + " places " + std::to_string(agree) +
         " agree, " + std::to_string(misprints) + " are misprints, " + std::to_string(failing) + " say what does not hold.";
}

std::string text_of(const Material& m) {
  Table facts;
  for (const DifferenceFact& fact : m.facts) facts.push_back({fact.holds ? "yes" : "NO", fact.sentence});
  return "Difference schemes of Catmull-Clark surfaces on regular meshes, from unit vectors run through catmull_clark;\n"
         "\"On Regularity of Catmull-Clark Subdivision Surfaces\" (Wang, Lin, Wang, Lu).\n"
         "p_ij is in row i (v direction) and column j (u direction); p'_ij after one round, p'11 a face point, p'22 a vertex.\n"
         "d_ij = p_i,j+1 - p_ij, eta = (d11, d12, d21, d22, d31, d32), gamma = (d11, d12, d13, d21, .., d33).\n" +
         schemes_text(m) + univariate_text(m) + spectra_text(m) + cells_text() + text_of("Computed facts", facts) + items_text(m);
}

// ---- JSON

Json json_of(const std::vector<Polynomial<Rational>>& polynomials) {
  Json list = Json::array();
  for (const Polynomial<Rational>& p : polynomials) list.push_back(to_json(p.coefficients));
  return list;
}

Json spectra_json(const Material& m) {
  Json json = Json::object();
  for (const auto& [name, matrix] : m.limit_matrices()) {
    const RationalSpectrum spectrum = rational_spectrum(matrix);
    Json values = Json::array();
    for (const RationalEigenvalue& v : spectrum.values)
      values.push_back({{"value", v.value.to_string()},
                        {"multiplicity", v.multiplicity},
                        {"jordan_blocks", v.blocks},
                        {"right", json_of(v.right)},
                        {"left", json_of(v.left)}});
    json[name] = {{"polynomial", to_json(spectrum.polynomial.coefficients)},
                  {"eigenvalues", std::move(values)},
                  {"diagonalisable", spectrum.is_diagonalisable()},
                  {"limit_row", json_of(common_row(limit_of_powers(spectrum)))[0]}};
  }
  return json;
}

Json cells_json() {
  Json json = Json::array();
  for (const bool start : {false, true}) {
    for (const bool end : {false, true}) {
      const CellWeights weights = cell_weights(start, end);
      json.push_back({{"boundary_at_0", start},
                      {"boundary_at_1", end},
                      {"points", json_of(weights.points)},
                      {"differences", json_of(weights.differences)},
                      {"convex", are_convex(weights.points) && are_convex(weights.differences)}});
    }
  }
  return json;
}

Json json_of(const Material& m) {
  Json tangents = Json::array(), facts = Json::array(), items = Json::array();
  for (const auto& [place, what, scheme] : m.tangents())
    tangents.push_back({{"place", place}, {"tangent", what}, {"weights", json_of(tangent_row(scheme))[0]}});
  for (const DifferenceFact& fact : m.facts) facts.push_back({{"fact", fact.sentence}, {"holds", fact.holds}});
  for (const PrintedItem& item : m.items) {
    items.push_back({{"place", item.place},
                     {"object", item.object},
                     {"printed", item.printed},
                     {"exact", item.exact},
                     {"verdict", to_string(item.verdict)}});
    if (!item.reading.empty()) items.back()["reading"] = item.reading;
  }
  return {{"kind", "difference schemes"},
          {"xi", json_of(m.schemes.xi)},
          {"alpha", json_of(m.schemes.alpha)},
          {"S9", json_of(m.schemes.s9)},
          {"omega", json_of(m.schemes.omega)},
          {"alpha_limit", json_of(m.schemes.alpha_limit)},
          {"V", json_of(m.rows.averaging)},
          {"D2", json_of(m.rows.differences)},
          {"D3", json_of(m.rows.differences_of_four)},
          {"Vb", json_of(m.rows.boundary_averaging)},
          {"Db", json_of(m.rows.boundary_differences)},
          {"boundary", {{"along", json_of(m.schemes.along)}, {"across", json_of(m.schemes.across)}}},
          {"corner", {{"u", json_of(m.schemes.corner_u)}, {"v", json_of(m.schemes.corner_v)}}},
          {"spectra", spectra_json(m)},
          {"tangents", std::move(tangents)},
          {"cells", cells_json()},
          {"facts", std::move(facts)},
          {"print", std::move(items)}};
}

// ---- Parts

Value list_of(const Points<Rational>& matrix) {
  ListValue rows;
  for (Index i = 0; i < matrix.rows(); ++i) {
    ListValue row;
    for (Index j = 0; j < matrix.cols(); ++j) row.items.push_back(number_of(Algebraic(matrix(i, j))));
    rows.items.push_back(Value{std::move(row)});
  }
  return Value{std::move(rows)};
}

/// What the print gets wrong, a text each.
Value list_of(const std::vector<PrintedItem>& items) {
  ListValue list;
  for (const PrintedItem& item : items)
    if (item.verdict != PrintVerdict::agrees)
      list.items.push_back(
          Value{TextValue{item.place + ", " + item.object + ": printed " + item.printed + ", exact " + item.exact}});
  return Value{std::move(list)};
}

}  // namespace

Value show_difference_schemes(CallContext&, const Arguments&) {
  const Material material;
  ReportValue report;
  report.text = text_of(material);
  report.json = json_of(material);
  report.parts = {list_of(material.schemes.xi),    list_of(material.schemes.alpha),       list_of(material.schemes.s9),
                  list_of(material.schemes.omega), list_of(material.schemes.alpha_limit), list_of(material.items)};
  return Value{std::move(report)};
}

}  // namespace udcp
