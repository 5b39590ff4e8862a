// Kernel: one formula for f, omega, delta or alpha0, callable in every number type.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "operators/quantity.h"

namespace udcp {

/// What a formula may look at. `valence` is the regular value on curves, on boundaries and at edge and face points.
template <class S>
struct Context {
  Quantity<S> alpha;  // alpha@t in a formula for direction t
  int valence = 4;
  int round = 0;    // h: the number of U before the last one
  int vertex = -1;  // index of the point, for noise and attributes; -1 where the formula said it needs none
  const std::map<std::string, std::vector<S>>* attributes = nullptr;

  /// v.name at this point. Throws Error{word, "E_ATTRIBUTE"} where there is none.
  [[nodiscard]] Quantity<S> attribute(const std::string& name) const;
};

/// What a formula depends on: it is evaluated once per round, once per valence, or once per vertex accordingly.
struct Needs {
  bool valence = false;  // N
  bool vertex = false;   // v.name, noise
  bool round = true;     // alpha, h: without it every round is the same
  bool level = false;    // h itself, not only through alpha
};

struct Kernel {
  virtual ~Kernel() = default;
  [[nodiscard]] virtual Needs needs() const = 0;
  /// The formula as a text of its own, in prefix form: "(cos (/ alpha 2))"; empty where there is none. For certificates.
  [[nodiscard]] virtual std::string closed_form() const { return {}; }
#define UDCP_KERNEL_AT(S) [[nodiscard]] virtual Quantity<S> at(const Context<S>&) const = 0;
  UDCP_FOR_EACH_NUMBER(UDCP_KERNEL_AT)
#undef UDCP_KERNEL_AT
};
using KernelPtr = std::shared_ptr<const Kernel>;

/// A kernel from a generic lambda: formula([](const auto& c) { return cos(c.alpha / 2); }), evaluated once per valence
/// (pass Needs{true, true, true} for one that uses c.vertex or c.attribute).
template <class F>
KernelPtr formula(F f, Needs needs = {true, false, true}) {
  struct Formula final : Kernel {
    Formula(F function, Needs what) : function_(std::move(function)), needs_(what) {}
    [[nodiscard]] Needs needs() const override { return needs_; }
#define UDCP_KERNEL_AT(S) \
  [[nodiscard]] Quantity<S> at(const Context<S>& c) const override { return Quantity<S>(function_(c)); }
    UDCP_FOR_EACH_NUMBER(UDCP_KERNEL_AT)
#undef UDCP_KERNEL_AT
    F function_;
    Needs needs_;
  };
  return std::make_shared<Formula>(std::move(f), needs);
}

KernelPtr constant(const Rational& value);
/// The free parameter `name` of Parametric, for words that run on symbols. Error{not_exact, "E_NOT_EXACT"} in every other number
/// type; Error{input, "E_NAME"} for what is no name.
KernelPtr symbol(const std::string& name);
/// The variable of Jet on `range`; all of the range in Interval, its middle in double. Error{not_exact, "E_NOT_EXACT"} in exact
/// types.
KernelPtr variable(const Interval& range);

}  // namespace udcp
