// Every number and formula on differences that "On Regularity of Catmull-Clark Subdivision Surfaces" prints, next to the exact
// one. Whether they agree is computed. The texts stand in printed_differences_data.h.
#pragma once

#include "proofs/regularity/difference_schemes.h"

namespace udcp {

/// agrees: equal, or for decimals a right rounding. misprint: another formula or number. fails: a statement that is not so.
enum class PrintVerdict { agrees, misprint, fails };
std::string to_string(PrintVerdict);  // "agrees", "misprint", "does not hold"

struct PrintedItem {
  std::string place;    // "1.1.2 item 1"
  std::string object;   // "p'12 - p'11", "eigenvalue of column 3 of P"
  std::string printed;  // as in the paper, in ASCII
  std::string exact;
  PrintVerdict verdict = PrintVerdict::agrees;
  std::string reading = {};  // of a misprint: what must be meant, if there is a formula of which that was checked
};
/// Formulas, rows of weights, matrices and their spectra, statements; by section, the theorems last.
std::vector<PrintedItem> compare_with_print(const DifferenceSchemes& exact);

/// Whether some vector of the span of the columns of `basis` (independent, at most three) differs from `column` by at most
/// `tolerance` in every entry.
bool has_member_near(const Points<Rational>& basis, const Points<Rational>& column, const Rational& tolerance);

}  // namespace udcp
