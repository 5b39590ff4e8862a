// Shared by the two files that define Quantity: its kinds by name, and the errors that both throw.
#pragma once

#include <string>

#include "operators/quantity.h"

namespace udcp {

template <class S>
bool is_number(const Quantity<S>& x) {
  return x.kind() == Quantity<S>::Kind::number;
}
template <class S>
bool is_rational(const Quantity<S>& x) {
  return x.kind() == Quantity<S>::Kind::rational;
}
template <class S>
bool is_pi_multiple(const Quantity<S>& x) {
  return x.kind() == Quantity<S>::Kind::pi_multiple;
}
template <class S>
bool is_plain_zero(const Quantity<S>& x) {
  return is_rational(x) && x.exact().is_zero();
}

inline std::string shorten(const std::string& text) { return text.size() <= 80 ? text : text.substr(0, 77) + "..."; }

[[noreturn]] inline void no_exact_value(const std::string& what) {
  throw Error(ErrorKind::not_exact, "E_NOT_EXACT", shorten(what) + " has no exact value here",
              "compute in enclosures or floating point, or use values with an exact form such as cos(2*pi/5)");
}

[[noreturn]] inline void division_by_zero(const std::string& what) {
  throw Error(ErrorKind::input, "E_DIV0", "division by zero in " + shorten(what),
              "check the denominator, or guard it with if ... then ... else");
}

}  // namespace udcp
