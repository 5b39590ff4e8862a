// Expressions as values of the language: names, calls, lists, words, pipes. Numbers inside formulas are evaluate.h's part.
#pragma once

#include <filesystem>
#include <map>

#include "interpreter/evaluate.h"
#include "interpreter/session.h"

namespace udcp {

/// Frames of an animation, by the file they will be saved to.
using AnimationFrames = std::map<std::filesystem::path, std::vector<Surface<double>>>;

struct Builtin;
struct ClaimDomain;
class KeptPlan;

/// What evaluation sees of the running session. Lives for one run().
struct CallContext {
  Settings& settings;
  const Output& output;
  std::shared_ptr<std::atomic<bool>> stop;
  std::filesystem::path folder;  // where relative paths start
  std::shared_ptr<const Environment> scope;
  SourcePtr source;
  const FunctionValue* function = nullptr;  // whose body is being evaluated: it may call itself
  const Value* last = nullptr;              // _
  AnimationFrames* animation = nullptr;     // inside animate: save collects here
  KeptPlan* kept = nullptr;                 // inside animate and sweep: what one round leaves for the next
  const ClaimDomain* domain = nullptr;      // inside a claim: what it speaks of
  bool path_text = false;                   // "{d}" goes into a file name: 1/4 is written 0.25, 1/3 is written 1_3
  int depth = 0;
  std::int64_t steps = 0;

  [[nodiscard]] Bounds bounds() const { return {settings.seed, stop}; }
};

/// Throws Located.
Value evaluate(const grammar::Expr&, CallContext&);
/// Calls `name` (a user function, a builtin or a function of numbers) with values.
Value call(const std::string& name, std::vector<Value> positional, std::vector<std::pair<std::string, Value>> named,
           CallContext&);
/// f(x, a) for x |> f(a): also words, and functions that make words.
Value apply_step(Value input, const grammar::Expr& step, CallContext&);

/// The text of a literal with every "{expression}" replaced by its value; "{{" and "}}" are braces.
std::string interpolate(const std::string& text, CallContext&);

/// A whole number at top level, `what` in messages: E_TYPE unless it is one between least and most.
int whole_number(const Value&, const std::string& what, int least, int most);

/// Names and calls in `expr` that nothing defines: throws Located E_NAME. Variables of formulas and `extra` are known.
void check_names(const grammar::Expr&, const CallContext&, const std::vector<std::string>& extra = {});

/// "tour.udcp:3:4: " for warnings.
std::string place_prefix(const CallContext&, grammar::Span);
void warn(const CallContext&, grammar::Span, const std::string& message);

/// An argument of a call: a symbol stands for its own name, unless it is bound; where a builtin takes one of some names (mode =
/// bspline) even then. `callee` is null for functions of programs.
Value evaluate_argument(const grammar::Argument&, CallContext&, const Builtin* callee);
/// Names such as lat, both, x, one_face: texts where a builtin takes them.
bool is_symbol(const std::string& name);

}  // namespace udcp
