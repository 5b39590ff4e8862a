// Formulas as a paper prints them, evaluated: linear forms in the points of a grid, and tables of numbers. Knows the notation,
// not what is right.
#pragma once

#include <string>

#include "proofs/regularity/difference_schemes.h"

namespace udcp {

/// Points of a grid by name: p12 before subdivision, p'12 after one round, p''12 after two, in the numbering of the paper.
class PrintedPoints {
 public:
  PrintedPoints(int rows, int columns);
  [[nodiscard]] int rows() const { return rows_; }
  [[nodiscard]] int columns() const { return columns_; }
  /// The weights of old points in a formula of points, fractions, + - * / and brackets: "(p'11 + p'13)/4 + 6p12/16".
  /// Throws Error{internal} for anything else.
  [[nodiscard]] Points<Rational> form(const std::string& formula) const;

 private:
  int rows_, columns_;
  std::vector<RefinedGrid> levels_;
};

/// "(3/16, 1/16)" or "3/16 1/16; 0 1": rows between semicolons. Throws Error{internal} for rows of unequal length.
Points<Rational> printed_table(const std::string& text);
/// The same, as the digits stand there.
std::vector<std::vector<std::string>> printed_entries(const std::string& text);
/// Half a unit of the last digit of a decimal number: 1/20000 for "0.3333".
Rational half_unit(const std::string& decimal);

/// "(p11 + 6 p12)/16": weights of the points of a grid with one denominator.
std::string form_text(const Points<Rational>& weights, int columns);
/// "(3, 1, 0)/16": a row with one denominator.
std::string row_text(const Points<Rational>& row);

}  // namespace udcp
