// Typed arguments of builtins: taken by position or name, and refused with the name of the argument and what was expected.
#pragma once

#include <optional>

#include "interpreter/builtins.h"
#include "interpreter/expressions.h"

namespace udcp {

const Value& need(const Arguments&, std::size_t position, std::string_view name);  // E_ARGUMENTS if it is missing
const MeshValue& need_mesh(const Arguments&, std::size_t position, std::string_view name = "mesh");
const WordValue& need_word(const Arguments&, std::size_t position, std::string_view name = "word");
NumberValue need_number(const Arguments&, std::size_t position, std::string_view name);
std::string need_text(const Arguments&, std::size_t position, std::string_view name);
int need_whole(const Arguments&, std::size_t position, std::string_view name, int least, int most);
int whole_or(const Arguments&, std::size_t position, std::string_view name, int otherwise, int least, int most);
/// One of the names, the first one if the argument is left away. Error{word, "E_TYPE"} listing them otherwise.
std::string choice_or(const Arguments&, std::size_t position, std::string_view name,
                      std::initializer_list<std::string_view> names);
std::string choice_or(const Arguments&, std::string_view name, std::initializer_list<std::string_view> names);  // only by name
bool flag_or(const Arguments&, std::size_t position, std::string_view name, bool otherwise);

/// The number in S: exact kinds stay exact; Error{not_exact} for what S cannot hold.
template <class S>
S number_as(const NumberValue& value) {
  return quantity<S>(value).value();
}
/// A list of lists of numbers of equal length, as rows.
template <class S>
Points<S> points_from(const Value& list, std::string_view name);
std::vector<int> indices_from(const Value& list, std::string_view name, int size);
std::vector<Value> list_items(const Value& list, std::string_view name);

/// f(type_identity<S>) for S = Algebraic or double; the result becomes the shape of a value.
template <class F>
auto with_number_type(bool exact, F f) {
  using Made = std::variant<decltype(f(std::type_identity<double>{})), decltype(f(std::type_identity<Algebraic>{}))>;
  if (exact) return Made(f(std::type_identity<Algebraic>{}));
  return Made(f(std::type_identity<double>{}));
}

Value whole_value(std::int64_t value);
Value number_of(const Algebraic& value);
Value number_of(const Interval& value);
Value number_of(double value);

}  // namespace udcp
