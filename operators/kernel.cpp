// Attribute look-up and the constant kernel.
#include "operators/kernel.h"

namespace udcp {

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

#define UDCP_INSTANTIATE(S) template Quantity<S> Context<S>::attribute(const std::string&) const;
UDCP_FOR_EACH_NUMBER(UDCP_INSTANTIATE)
#undef UDCP_INSTANTIATE

}  // namespace udcp
