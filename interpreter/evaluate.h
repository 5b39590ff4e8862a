// Expressions as numbers: one evaluation, generic in the number type of the computation, that serves the formulas inside words
// and the arithmetic of programs. Knows no geometry; what a program does with other values is in expressions.h.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "interpreter/value.h"
#include "operators/kernel.h"

namespace udcp {

/// An error with the smallest expression it belongs to. `source` null: the text that is being run.
struct Located : Error {
  Located(const Error& error, grammar::Span place, SourcePtr text = nullptr)
      : Error(error), span(place), source(std::move(text)) {}
  grammar::Span span;
  SourcePtr source;
};

/// What leaves the body of a user function: an error there is shown there, except in the prelude, whose text nobody wants to see;
/// such an error is handed on without a place, so that the call gets it.
[[noreturn]] void rethrow_from(const FunctionValue& function, const Located& error);

/// What bounds an evaluation.
struct Bounds {
  std::uint64_t seed = 0;                                   // added to every noise seed
  std::shared_ptr<const std::atomic<bool>> stop = nullptr;  // set: Error{interrupted}
};

inline constexpr int max_call_depth = 200;
inline constexpr int max_nesting =
    1000;  // expressions inside each other, calls followed: what the stack holds, sanitizers included
inline constexpr std::int64_t max_steps = 2'000'000;

/// The value of an expression in the number type S, exact as long as Quantity is. Names: those of `scope`, alpha, N, h, pi,
/// v.name. Throws Located: E_NAME, E_TYPE, E_ARGUMENTS, E_DIV0, not_exact, E_UNDECIDED, E_CALL_DEPTH, E_STEPS, E_NUMBER_SIZE.
template <class S>
Quantity<S> evaluate(const grammar::Expr&, const Context<S>&, const Environment& scope, const Bounds& bounds = {});

/// A number of the language in the number type S. Error{not_exact} where S cannot hold it.
template <class S>
Quantity<S> quantity(const NumberValue&);

/// A rational where the value is one.
NumberValue exact_number(const Algebraic&);

/// A function of numbers (sqrt cos sin tan exp log abs min max), or a binary operator + - * / ^, on exact values as long as that
/// goes, then on enclosures, or on doubles if one of them is a double.
NumberValue apply_operator(const std::string& op, const NumberValue&, const NumberValue&);
NumberValue negate(const NumberValue&);
bool is_number_function(const std::string& name);
const std::vector<std::string>& number_functions();
NumberValue call_number_function(const std::string& name, const std::vector<NumberValue>& arguments);
/// -1, 0, 1. Throws Error{not_exact, "E_UNDECIDED"} for enclosures that overlap.
int compare(const NumberValue&, const NumberValue&);

/// A formula of a word: an expression closed over the bindings that were in force.
struct FormulaText {
  grammar::ExprPtr body;
  std::shared_ptr<const Environment> scope;
  std::string parameter;   // f(x) = …: another name for `stands_for`; may be empty
  std::string stands_for;  // "alpha" or "N"
  SourcePtr source;
  Bounds bounds;
};
/// A constant without alpha, N, h, attributes and noise is evaluated here, once. Throws Located for what is wrong already now:
/// E_NAME for unknown names, E_DIV0 and the like for constants.
KernelPtr make_kernel(FormulaText formula);

/// What a formula mentions, functions followed. For warnings and for the list of defaults.
struct Uses {
  bool alpha = false, valence = false, round = false, vertex = false;
};
/// Of a kernel that make_kernel made; everything for others.
Uses uses(const Kernel& kernel);
/// True if the two formulas certainly are the same: equal constants, or the same text with equal values of its names. Null:
/// `otherwise`.
bool same_kernel(const KernelPtr& a, const KernelPtr& b, int otherwise);

/// Distance-limited guess for an unknown name, as a help text: "did you mean 'cube'?"; empty if nothing is near.
std::string did_you_mean(const std::string& name, const std::vector<std::string>& known);
/// Names that `scope` can see.
std::vector<std::string> visible_names(const Environment& scope);

}  // namespace udcp
