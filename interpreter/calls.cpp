// Calls of user functions and builtins, and the steps of a pipe.
#include <algorithm>

#include "interpreter/apply.h"
#include "interpreter/builtins.h"
#include "interpreter/formula.h"
#include "interpreter/report.h"
#include "interpreter/words.h"

namespace udcp {

namespace {

using Named = std::vector<std::pair<std::string, Value>>;

/// The body of a function is evaluated in the function's own scope and text; afterwards the caller's come back.
class Frame {
 public:
  Frame(CallContext& context, const FunctionValue& function, std::shared_ptr<const Environment> scope)
      : context_(context),
        scope_(context.scope),
        source_(context.source),
        function_(context.function),
        path_text_(context.path_text) {
    context.scope = std::move(scope);
    if (function.source) context.source = function.source;
    context.function = &function;
    context.path_text = false;
  }
  ~Frame() {
    context_.scope = std::move(scope_);
    context_.source = std::move(source_);
    context_.function = function_;
    context_.path_text = path_text_;
  }
  Frame(const Frame&) = delete;
  Frame& operator=(const Frame&) = delete;

 private:
  CallContext& context_;
  std::shared_ptr<const Environment> scope_;
  SourcePtr source_;
  const FunctionValue* function_;
  bool path_text_;
};

std::shared_ptr<Environment> bind_parameters(const FunctionValue& function, std::vector<Value> positional, Named named) {
  auto frame = std::make_shared<Environment>();
  frame->frame = true;
  frame->outer = function.scope;
  if (positional.size() + named.size() != function.parameters.size())
    throw wrong_count(function, positional.size() + named.size());
  for (std::size_t i = 0; i < positional.size(); ++i) frame->names.emplace(function.parameters[i], std::move(positional[i]));
  for (auto& [name, value] : named) {
    const bool known = std::find(function.parameters.begin(), function.parameters.end(), name) != function.parameters.end();
    if (!known)
      throw Error(ErrorKind::word, "E_ARGUMENTS", "'" + function.name + "' has no parameter '" + name + "'",
                  "the definition is " + signature(function));
    if (!frame->names.emplace(name, std::move(value)).second)
      throw Error(ErrorKind::word, "E_ARGUMENTS", "the parameter '" + name + "' of '" + function.name + "' is given twice");
  }
  return frame;
}

/// A word that a function made is shown as the call that made it: circle(5).
void name_word(Value& result, const FunctionValue& function, const Environment& frame) {
  auto* word = std::get_if<WordValue>(&result.data);
  if (!word || function.parameters.empty()) return;
  std::string text = function.name + "(";
  for (const std::string& p : function.parameters) {
    const auto* number = frame.names.at(p).as<NumberValue>();
    const auto* exact = number ? std::get_if<Quantity<Algebraic>>(&number->value) : nullptr;
    if (!exact || exact->kind() == Quantity<Algebraic>::Kind::number) return;
    const std::string factor = exact->exact().to_string();
    text += (p == function.parameters[0] ? "" : ", ") + factor +
            (exact->kind() == Quantity<Algebraic>::Kind::pi_multiple ? "*pi" : "");
  }
  word->source = text + ")";
}

Value call_function(const FunctionValue& callee, std::vector<Value> positional, Named named, CallContext& context) {
  const FunctionValue function = callee;  // the callee may live in a scope that the call replaces
  const auto scope = bind_parameters(function, std::move(positional), std::move(named));
  try {
    const Frame frame(context, function, scope);
    Value result = evaluate(*function.body, context);
    name_word(result, function, *scope);
    return result;
  } catch (const Located& error) {
    rethrow_from(function, error);
  }
}

Value call_builtin(const Builtin& builtin, std::vector<Value> positional, Named named, CallContext& context) {
  const std::string signature(builtin.signature), name(builtin.name);
  const int given = static_cast<int>(positional.size());
  if (given < builtin.least || given > builtin.most)
    throw Error(
        ErrorKind::word, "E_ARGUMENTS",
        "'" + name + "' cannot take " + std::to_string(given) + (given == 1 ? " argument" : " arguments") + " without a name",
        "write " + signature);
  for (const auto& [key, value] : named) {
    if (std::find(builtin.named.begin(), builtin.named.end(), key) == builtin.named.end())
      throw Error(ErrorKind::word, "E_ARGUMENTS", "'" + name + "' has no argument '" + key + "'", "write " + signature);
  }
  return builtin.call(context, Arguments{std::move(positional), std::move(named)});
}

Value call_numbers(const std::string& name, const std::vector<Value>& positional, const Named& named) {
  if (!named.empty()) throw Error(ErrorKind::word, "E_ARGUMENTS", "'" + name + "' takes no named arguments");
  std::vector<NumberValue> numbers;
  const auto* list = positional.size() == 1 ? positional[0].as<ListValue>() : nullptr;
  const std::vector<Value>& values = list && (name == "min" || name == "max") ? list->items : positional;
  for (const Value& value : values) {
    const auto* number = value.as<NumberValue>();
    if (!number) throw wrong_type("the argument of '" + name + "'", "a number", value);
    numbers.push_back(*number);
  }
  return Value{call_number_function(name, numbers)};
}

const FunctionValue* find_function(const std::string& name, const CallContext& context) {
  const Value* found = context.scope->find(name);
  if (const auto* function = found ? found->as<FunctionValue>() : nullptr) return function;
  return !found && context.function && context.function->name == name ? context.function : nullptr;
}

Error unknown_function(const std::string& name, const CallContext& context) {
  if (const Value* found = context.scope->find(name)) {
    if (found->as<WordValue>())
      return Error(ErrorKind::word, "E_TYPE", "'" + name + "' is a word, not a function",
                   "write shape |> " + name + "^4 to apply it");
    return wrong_type("'" + name + "'", "a function", *found);
  }
  std::vector<std::string> known;
  for (const Builtin& b : builtins()) known.emplace_back(b.name);
  return unknown_name(name, *context.scope, false, known);
}

/// print inside a pipe.
Value print_step(Value input, const grammar::Step& step, CallContext& context) {
  if (!step.arguments.empty()) throw Error(ErrorKind::word, "E_ARGUMENTS", "the step print takes no arguments");
  if (context.output.value) context.output.value(input);
  return input;
}

/// save and plot hand their input on.
Value file_step(Value input, const grammar::Step& step, CallContext& context) {
  if (step.verb == "print") return print_step(std::move(input), step, context);
  const Builtin* builtin = find_builtin(step.verb);
  if (!builtin) throw unknown_function(step.verb, context);
  std::vector<Value> positional;
  positional.push_back(Value{});  // the input's place
  Named named;
  const bool before = std::exchange(context.path_text, true);
  for (const grammar::Argument& a : step.arguments) {
    Value value = evaluate(*a.value, context);
    if (a.name.empty())
      positional.push_back(std::move(value));
    else
      named.emplace_back(a.name, std::move(value));
  }
  context.path_text = before;
  if (static_cast<int>(positional.size()) > builtin->most)
    throw Error(ErrorKind::word, "E_ARGUMENTS", "'" + step.verb + "' has too many arguments",
                "write shape |> " + step.verb + " \"file\"");
  for (const auto& [key, value] : named) {
    if (std::find(builtin->named.begin(), builtin->named.end(), key) == builtin->named.end())
      throw Error(ErrorKind::word, "E_ARGUMENTS", "'" + step.verb + "' has no argument '" + key + "'",
                  "write " + std::string(builtin->signature));
  }
  Arguments arguments{std::move(positional), std::move(named)};
  arguments.positional[0] = std::move(input);
  builtin->call(context, arguments);
  return std::move(arguments.positional[0]);
}

Value apply_value(const Value& step, Value input, CallContext& context) {
  if (const auto* word = step.as<WordValue>()) return apply(*word, std::move(input), context);
  std::vector<Value> positional;
  positional.push_back(std::move(input));
  if (const auto* function = step.as<FunctionValue>()) return call_function(*function, std::move(positional), {}, context);
  throw wrong_type("a step", "a word, a function, save, plot or print", step);
}

/// x |> f(a): f(x, a); but x |> circle(5) applies the word that circle(5) is.
Value call_step(Value input, const grammar::Expr& step, const grammar::Call& c, CallContext& context) {
  const FunctionValue* function = find_function(c.name, context);
  if (function && function->parameters.size() == c.arguments.size())
    return apply_value(evaluate(step, context), std::move(input), context);
  const Builtin* builtin = function ? nullptr : find_builtin(c.name);
  if (builtin && builtin->special && !builtin->call) return builtin->special(context, c);
  // The arguments alone are evaluated through a list, so that symbols and file names are read as in any call.
  std::vector<Value> positional;
  positional.push_back(std::move(input));
  Named named;
  for (const grammar::Argument& a : c.arguments) {
    Value value = evaluate_argument(a, context, builtin);
    if (a.name.empty())
      positional.push_back(std::move(value));
    else
      named.emplace_back(a.name, std::move(value));
  }
  return call(c.name, std::move(positional), std::move(named), context);
}

}  // namespace

const Value* Arguments::find(std::string_view name) const {
  for (const auto& [key, value] : named) {
    if (key == name) return &value;
  }
  return nullptr;
}

const Value* Arguments::get(std::size_t position, std::string_view name) const {
  return position < positional.size() ? &positional[position] : find(name);
}

Value call(const std::string& name, std::vector<Value> positional, Named named, CallContext& context) {
  if (const FunctionValue* function = find_function(name, context))
    return call_function(*function, std::move(positional), std::move(named), context);
  if (is_number_function(name)) return call_numbers(name, positional, named);
  const Builtin* builtin = find_builtin(name);
  if (builtin && builtin->call) return call_builtin(*builtin, std::move(positional), std::move(named), context);
  if (builtin) return builtin->special(context, grammar::Call{name, {}});
  if (name == "noise") throw Error(ErrorKind::word, "E_NAME", "noise has a value only inside the formulas of a word");
  throw unknown_function(name, context);
}

Value apply_step(Value input, const grammar::Expr& step, CallContext& context) {
  try {
    if (const auto* verb = std::get_if<grammar::Step>(&step.node)) return file_step(std::move(input), *verb, context);
    if (const auto* c = std::get_if<grammar::Call>(&step.node)) return call_step(std::move(input), step, *c, context);
    const auto* name = std::get_if<grammar::Name>(&step.node);
    if (name && !context.scope->find(name->name) && (find_builtin(name->name) || is_number_function(name->name))) {
      std::vector<Value> positional;
      positional.push_back(std::move(input));
      return call(name->name, std::move(positional), {}, context);
    }
    return apply_value(evaluate(step, context), std::move(input), context);
  } catch (const Located&) {
    throw;
  } catch (const Error& error) {
    throw Located(error, step.span);
  }
}

}  // namespace udcp
