// The table of checkers.
#include "proofs/checkers.h"

#include <array>

namespace udcp {

std::string check_all_of(const Json& data, StopFlag stop) {
  require_entries(data, {"parts"}, "data");
  const Json& parts = entry(data, "parts");
  require(parts.is_array() && parts.size() >= 2 && parts.size() <= 1000, "data.parts must be a list of 2 to 1000 parts");
  std::string statement;
  for (const Json& part : parts) {
    require_entries(part, {"kind", "data"}, "a part");
    bool known = false;
    for (const Checker& checker : checkers()) {
      if (checker.kind == "all-of" || !part["kind"].is_string() || part["kind"] != checker.kind) continue;
      statement += (statement.empty() ? "" : "; ") + checker.check(part["data"], stop);
      known = true;
    }
    require(known, "a part has an unknown kind");
  }
  return statement;
}

std::span<const Checker> checkers() {
  static constexpr std::array table = {
      Checker{"all-of", check_all_of},
      Checker{"curve-smoothness", check_curve_smoothness},
      Checker{"curve-refutation", check_curve_refutation},
      Checker{"curve-regularity", check_curve_regularity},
      Checker{"surface-c1", check_surface_c1},
      Checker{"surface-spectrum", check_surface_spectrum},
      Checker{"curve-box", check_curve_box},
      Checker{"asymptotic", check_asymptotic},
      Checker{"equality", check_equality},
      Checker{"circle", check_circle},
      Checker{"regular-surface", check_regular_surface},
      Checker{"irregular-surface", check_irregular_surface},
      Checker{"interpolation", check_interpolation},
      Checker{"interpolation-reversed", check_interpolation_reversed},
      Checker{"interpolation-threshold", check_interpolation_threshold},
      Checker{"interpolation-checkerboard", check_interpolation_checkerboard},
      Checker{"g2-fill", check_g2_fill},
      Checker{"g2-print", check_g2_print},
      Checker{"offset-contraction", check_offset_contraction},
      Checker{"offset-definite", check_offset_definite},
      Checker{"offset-error", check_offset_error},
      Checker{"embedded-surface", check_embedded_surface},
  };
  return table;
}

}  // namespace udcp
