// Messages about arguments are made here and nowhere else.
#include "interpreter/arguments.h"

#include <algorithm>

#include "interpreter/formula.h"

namespace udcp {

namespace {

std::string quoted(std::string_view name) { return "'" + std::string(name) + "'"; }

template <class T>
const T& need_as(const Arguments& arguments, std::size_t position, std::string_view name, const char* expected) {
  const Value& value = need(arguments, position, name);
  if (const T* typed = value.as<T>()) return *typed;
  throw wrong_type("the argument " + quoted(name), expected, value);
}

}  // namespace

const Value& need(const Arguments& arguments, std::size_t position, std::string_view name) {
  if (const Value* value = arguments.get(position, name)) return *value;
  throw Error(ErrorKind::word, "E_ARGUMENTS", "the argument " + quoted(name) + " is missing");
}

const MeshValue& need_mesh(const Arguments& a, std::size_t position, std::string_view name) {
  return need_as<MeshValue>(a, position, name, "a mesh");
}
const WordValue& need_word(const Arguments& a, std::size_t position, std::string_view name) {
  return need_as<WordValue>(a, position, name, "a word");
}
NumberValue need_number(const Arguments& a, std::size_t position, std::string_view name) {
  return need_as<NumberValue>(a, position, name, "a number");
}
std::string need_text(const Arguments& a, std::size_t position, std::string_view name) {
  return need_as<TextValue>(a, position, name, "a text").value;
}

int need_whole(const Arguments& a, std::size_t position, std::string_view name, int least, int most) {
  return whole_number(need(a, position, name), "the argument " + quoted(name), least, most);
}

int whole_or(const Arguments& a, std::size_t position, std::string_view name, int otherwise, int least, int most) {
  return a.get(position, name) ? need_whole(a, position, name, least, most) : otherwise;
}

std::string choice_or(const Arguments& a, std::string_view name, std::initializer_list<std::string_view> names) {
  return choice_or(a, a.positional.size(), name, names);
}

std::string choice_or(const Arguments& a, std::size_t position, std::string_view name,
                      std::initializer_list<std::string_view> names) {
  if (!a.get(position, name)) return std::string(*names.begin());
  const std::string given = need_text(a, position, name);
  if (std::find(names.begin(), names.end(), given) != names.end()) return given;
  std::string list;
  for (const std::string_view n : names) list += (list.empty() ? "" : n == *(names.end() - 1) ? " or " : ", ") + std::string(n);
  throw Error(ErrorKind::word, "E_TYPE",
              "the argument '" + std::string(name) + "' must be " + list + ", but it is '" + given + "'");
}

bool flag_or(const Arguments& a, std::size_t position, std::string_view name, bool otherwise) {
  return a.get(position, name) ? need_as<Boolean>(a, position, name, "yes or no").value : otherwise;
}

std::vector<Value> list_items(const Value& list, std::string_view name) {
  if (const auto* items = list.as<ListValue>()) return items->items;
  throw wrong_type(quoted(name), "a list", list);
}

template <class S>
Points<S> points_from(const Value& list, std::string_view name) {
  const std::vector<Value> rows = list_items(list, name);
  Points<S> points;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::vector<Value> row = list_items(rows[i], "row " + std::to_string(i) + " of " + std::string(name));
    if (i == 0) points = Points<S>::Constant(static_cast<Eigen::Index>(rows.size()), static_cast<Eigen::Index>(row.size()), S(0));
    if (static_cast<Eigen::Index>(row.size()) != points.cols())
      throw Error(ErrorKind::input, "E_DIMENSION",
                  "point " + std::to_string(i) + " has " + std::to_string(row.size()) + " coordinates, but point 0 has " +
                      std::to_string(points.cols()));
    for (std::size_t c = 0; c < row.size(); ++c) {
      const auto* number = row[c].as<NumberValue>();
      if (!number) throw wrong_type("coordinate " + std::to_string(c) + " of point " + std::to_string(i), "a number", row[c]);
      points(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(c)) = number_as<S>(*number);
    }
  }
  return points;
}
template Points<double> points_from(const Value&, std::string_view);
template Points<Algebraic> points_from(const Value&, std::string_view);

std::vector<int> indices_from(const Value& list, std::string_view name, int size) {
  std::vector<int> result;
  for (const Value& item : list_items(list, name)) {
    const int i =
        whole_number(item, "an index in " + quoted(name), std::numeric_limits<int>::min(), std::numeric_limits<int>::max());
    if (i < 0 || i >= size)
      throw Error(ErrorKind::input, "E_INDEX",
                  "index " + std::to_string(i) + " in " + quoted(name) + " is outside 0 .. " + std::to_string(size - 1));
    result.push_back(i);
  }
  return result;
}

Value whole_value(std::int64_t value) { return Value{NumberValue{Quantity<Algebraic>(Rational(static_cast<long long>(value)))}}; }
Value number_of(const Algebraic& value) { return Value{exact_number(value)}; }
Value number_of(const Interval& value) { return Value{NumberValue{value}}; }
Value number_of(double value) { return Value{NumberValue{value}}; }

}  // namespace udcp
