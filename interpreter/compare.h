// Equality of values: exact, decided or refused; and the first difference in words.
#pragma once

#include <string>

#include "interpreter/value.h"

namespace udcp {

/// What a comparison found. `difference` is empty if equal: "item 2: 9/16 and 1/2".
struct Comparison {
  bool equal = true;
  std::string difference;
};

/// Lists, numbers, matrices, words, shapes and reports, element by element. Throws Error{not_exact}: E_UNDECIDED for enclosures
/// that overlap without being one point, E_NOT_EXACT for doubles (approx(a, b, tolerance) compares those). Different types are
/// different.
Comparison compare_values(const Value& a, const Value& b);
/// |x - y| <= tolerance for all numbers in a and b, which must have the same structure.
Comparison compare_approximately(const Value& a, const Value& b, double tolerance);

}  // namespace udcp
