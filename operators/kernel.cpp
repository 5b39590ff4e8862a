// Attribute look-up; constants, symbols and variables as kernels.
#include "operators/kernel.h"

namespace udcp {
namespace {

[[noreturn]] void has_no_value(const std::string& what) {
  throw Error(ErrorKind::not_exact, "E_NOT_EXACT", what + " has no value in this number type",
              "give it a number for this computation");
}

template <class S>
S in_type(const Parametric& symbol) {
  has_no_value("the free parameter " + symbol.to_string());
}
template <>
Parametric in_type(const Parametric& symbol) {
  return symbol;
}

template <class S>
S in_type(const Interval& range) {
  has_no_value("a variable on " + range.to_string(6));
}
template <>
double in_type(const Interval& range) {
  return range.midpoint();
}
template <>
Interval in_type(const Interval& range) {
  return range;
}
template <>
Jet in_type(const Interval& range) {
  return Jet::variable(range);
}

}  // namespace

template <class S>
Quantity<S> Context<S>::attribute(const std::string& name) const {
  if (attributes != nullptr && vertex >= 0) {
    const auto found = attributes->find(name);
    if (found != attributes->end()) return Quantity<S>::of(found->second[static_cast<std::size_t>(vertex)]);
  }
  throw Error(ErrorKind::word, "E_ATTRIBUTE", "the points have no attribute '" + name + "'",
              "attribute(shape, \"" + name + "\", values) adds one; files bring theirs along");
}

KernelPtr constant(const Rational& value) {
  return formula([value](const auto& c) { return decltype(c.alpha)(value); }, Needs{false, false, false});
}

KernelPtr symbol(const std::string& name) {
  return formula([value = Parametric::variable(name)]<class S>(const Context<S>&) { return Quantity<S>::of(in_type<S>(value)); },
                 Needs{false, false, false});
}

KernelPtr variable(const Interval& range) {
  return formula([range]<class S>(const Context<S>&) { return Quantity<S>::of(in_type<S>(range)); }, Needs{false, false, false});
}

#define UDCP_INSTANTIATE(S) template Quantity<S> Context<S>::attribute(const std::string&) const;
UDCP_FOR_EACH_NUMBER(UDCP_INSTANTIATE)
#undef UDCP_INSTANTIATE

}  // namespace udcp
