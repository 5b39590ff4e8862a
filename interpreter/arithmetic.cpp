// Operators and functions of numbers by name, and the step from exact numbers to enclosures or doubles.
#include "interpreter/arithmetic.h"

#include <algorithm>
#include <functional>

#include "interpreter/evaluate.h"

namespace udcp {

namespace {

std::size_t size_in_bits(const Rational& value) { return value.bits(); }
std::size_t size_in_bits(const Algebraic& value) {
  std::size_t bits = 0;
  for (const Rational& c : value.coefficients()) bits += c.bits();
  return bits;
}
std::size_t size_in_bits(const Parametric& value) { return value.bits(); }
std::size_t size_in_bits(const Interval&) { return 0; }
std::size_t size_in_bits(const Jet&) { return 0; }
std::size_t size_in_bits(double) { return 0; }

template <class S>
Quantity<S> checked(Quantity<S> value) {
  const bool is_number = value.kind() == Quantity<S>::Kind::number;
  const std::size_t bits = is_number ? size_in_bits(value.value()) : value.exact().bits();
  if (bits > max_number_bits)
    throw Error(ErrorKind::limit, "E_NUMBER_SIZE",
                "an exact number grew to " + std::to_string(bits) + " bits; the limit is " + std::to_string(max_number_bits),
                "round it earlier with approximate(x), or use smaller exponents");
  return value;
}

template <class S>
Quantity<S> extreme(const std::vector<Quantity<S>>& arguments, bool least) {
  Quantity<S> best = arguments[0];
  for (std::size_t i = 1; i < arguments.size(); ++i) best = least ? min(best, arguments[i]) : max(best, arguments[i]);
  return best;
}

/// Runs `f` on exact numbers; on enclosures where exactness ends; on doubles if a double is among the operands.
template <class Result, class F>
Result promote(const std::vector<NumberValue>& operands, F f) {
  const auto all = [&]<class S>(std::type_identity<S>) {
    std::vector<Quantity<S>> values;
    for (const NumberValue& v : operands) values.push_back(quantity<S>(v));
    return f(values);
  };
  bool enclosed = false;
  for (const NumberValue& v : operands) {
    if (std::holds_alternative<Parametric>(v.value)) return Result(all(std::type_identity<Parametric>{}));
  }
  for (const NumberValue& v : operands) {
    if (std::holds_alternative<double>(v.value)) return Result(all(std::type_identity<double>{}));
    enclosed = enclosed || std::holds_alternative<Interval>(v.value);
  }
  if (!enclosed) {
    try {
      return Result(all(std::type_identity<Algebraic>{}));
    } catch (const Error& error) {
      if (error.kind != ErrorKind::not_exact && error.code != "E_FIELD_DEGREE") throw;
    }
  }
  return Result(all(std::type_identity<Interval>{}));
}

/// Wraps the results of promote as values of the language.
struct Wrapped {
  NumberValue number;
  explicit Wrapped(const Quantity<double>& q) : number{q.value()} {}
  explicit Wrapped(const Quantity<Algebraic>& q) : number{q} {}
  explicit Wrapped(const Quantity<Parametric>& q) {
    if (q.kind() == Quantity<Parametric>::Kind::number) {
      number.value = q.value();
    } else {
      number.value =
          q.kind() == Quantity<Parametric>::Kind::rational ? Quantity<Algebraic>(q.exact()) : Quantity<Algebraic>::pi(q.exact());
    }
  }
  explicit Wrapped(const Quantity<Interval>& q) {
    if (q.kind() == Quantity<Interval>::Kind::number)
      number.value = q.value();
    else
      number.value =
          q.kind() == Quantity<Interval>::Kind::rational ? Quantity<Algebraic>(q.exact()) : Quantity<Algebraic>::pi(q.exact());
  }
};

/// quantity<S> of a function of the parameters of a claim.
template <class S>
S from_parametric(const Parametric& value) {
  throw Error(ErrorKind::not_exact, "E_PARAMETER",
              value.to_string().substr(0, 200) + " depends on the parameters of a claim and has no value",
              "claims over parameters speak of words whose weights are rational functions of them");
}
template <>
Parametric from_parametric<Parametric>(const Parametric& value) {
  return value;
}

/// quantity<S> of an enclosure or a double, by number type.
template <class S>
S from_interval(const Interval&) {
  throw Error(ErrorKind::not_exact, "E_NOT_EXACT", "an enclosure has no exact value",
              "use exact numbers, or approximate(shape) for double");
}
template <>
Interval from_interval<Interval>(const Interval& value) {
  return value;
}
template <>
Jet from_interval<Jet>(const Interval& value) {
  return Jet(value);
}
template <>
double from_interval<double>(const Interval& value) {
  return value.midpoint();
}

}  // namespace

template <class S>
Quantity<S> binary(const std::string& op, const Quantity<S>& a, const Quantity<S>& b) {
  if (op == "+") return checked(a + b);
  if (op == "-") return checked(a - b);
  if (op == "*") return checked(a * b);
  if (op == "/") return checked(a / b);
  if (op == "^") return checked(pow(a, b));
  throw Error(ErrorKind::word, "E_TYPE", "'" + op + "' does not make a number");
}

template <class S>
Quantity<S> number_function(const std::string& name, const std::vector<Quantity<S>>& arguments) {
  const bool many = name == "min" || name == "max";
  if (many ? arguments.empty() : arguments.size() != 1)
    throw Error(
        ErrorKind::word, "E_ARGUMENTS",
        name + (many ? " takes one or more numbers, not none" : " takes one number, not " + std::to_string(arguments.size())));
  const Quantity<S>& x = arguments[0];
  if (name == "sqrt") return checked(sqrt(x));
  if (name == "cos") return checked(cos(x));
  if (name == "sin") return checked(sin(x));
  if (name == "tan") return checked(tan(x));
  if (name == "exp") return checked(exp(x));
  if (name == "log") return checked(log(x));
  if (name == "abs") return checked(abs(x));
  return extreme(arguments, name == "min");
}

#define X(S)                                                                                      \
  template Quantity<S> binary(const std::string& op, const Quantity<S>& a, const Quantity<S>& b); \
  template Quantity<S> number_function(const std::string& name, const std::vector<Quantity<S>>& arguments);
UDCP_FOR_EACH_NUMBER(X)
#undef X

bool is_comparison(const std::string& op) {
  return op == "==" || op == "!=" || op == "<" || op == "<=" || op == ">" || op == ">=";
}

bool holds(const std::string& comparison, int sign) {
  if (comparison == "==") return sign == 0;
  if (comparison == "!=") return sign != 0;
  if (comparison == "<") return sign < 0;
  if (comparison == "<=") return sign <= 0;
  if (comparison == ">") return sign > 0;
  return sign >= 0;
}

const std::vector<std::string>& number_functions() {
  static const std::vector<std::string> names = {"abs", "cos", "exp", "log", "max", "min", "sin", "sqrt", "tan"};
  return names;
}

bool is_number_function(const std::string& name) {
  return std::binary_search(number_functions().begin(), number_functions().end(), name);
}

template <class S>
Quantity<S> quantity(const NumberValue& number_value) {
  if (const auto* exact = std::get_if<Quantity<Algebraic>>(&number_value.value))
    return convert_quantity<S, Algebraic>(*exact, [](const Algebraic& value) { return number<S>(value); });
  if (const auto* function = std::get_if<Parametric>(&number_value.value)) return Quantity<S>::of(from_parametric<S>(*function));
  if (const auto* enclosure = std::get_if<Interval>(&number_value.value)) return Quantity<S>::of(from_interval<S>(*enclosure));
  return Quantity<S>::of(number_from_double<S>(std::get<double>(number_value.value)));
}
#define X(S) template Quantity<S> quantity<S>(const NumberValue&);
UDCP_FOR_EACH_NUMBER(X)
#undef X

NumberValue exact_number(const Algebraic& value) {
  return {value.is_rational() ? Quantity<Algebraic>(value.rational()) : Quantity<Algebraic>::of(value)};
}

NumberValue apply_operator(const std::string& op, const NumberValue& a, const NumberValue& b) {
  return promote<Wrapped>({a, b}, [&](const auto& v) { return binary(op, v[0], v[1]); }).number;
}

NumberValue negate(const NumberValue& a) {
  return promote<Wrapped>({a}, [&](const auto& v) { return -v[0]; }).number;
}

NumberValue call_number_function(const std::string& name, const std::vector<NumberValue>& arguments) {
  return promote<Wrapped>(arguments, [&](const auto& v) { return number_function(name, v); }).number;
}

int compare(const NumberValue& a, const NumberValue& b) {
  return promote<int>({a, b}, [](const auto& v) { return compare(v[0], v[1]); });
}

}  // namespace udcp
