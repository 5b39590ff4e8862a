// The operators and functions of numbers, once for every number type; evaluate.cpp (formulas) and expressions.cpp (programs)
// share them.
#pragma once

#include <string>
#include <vector>

#include "operators/quantity.h"

namespace udcp {

/// + - * / ^. Throws what Quantity throws and Error{limit, "E_NUMBER_SIZE"} for exact results above max_number_bits.
template <class S>
Quantity<S> binary(const std::string& op, const Quantity<S>& a, const Quantity<S>& b);

/// sqrt cos sin tan exp log abs (one argument), min max (one or more). Error{word, "E_ARGUMENTS"} for a wrong number of
/// arguments.
template <class S>
Quantity<S> number_function(const std::string& name, const std::vector<Quantity<S>>& arguments);

/// == != < <= > >=, from the sign of the difference.
bool holds(const std::string& comparison, int sign);
bool is_comparison(const std::string& op);

/// The values of both number types with exact kinds kept.
template <class T, class S>
Quantity<T> convert_quantity(const Quantity<S>& value, T (*number)(const S&)) {
  switch (value.kind()) {
    case Quantity<S>::Kind::rational:
      return Quantity<T>(value.exact());
    case Quantity<S>::Kind::pi_multiple:
      return Quantity<T>::pi(value.exact());
    default:
      return Quantity<T>::of(number(value.value()));
  }
}

inline constexpr std::size_t max_number_bits = 4'000'000;

}  // namespace udcp
