// Formulas of words in the prefix form that certificates carry (proofs/closed_form.h).
#pragma once

#include <string>

#include "interpreter/evaluate.h"

namespace udcp {

/// The formula with all names replaced by what they stand for: "(cos (/ alpha 2))". Empty if it has conditions, h, noise,
/// attributes, or numbers that are neither rational nor rational multiples of pi.
std::string prefix_form(const FormulaText& formula);

}  // namespace udcp
