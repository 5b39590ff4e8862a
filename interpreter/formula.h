// What evaluate.cpp, formula.cpp and expressions.cpp share: evaluation of a closed formula and the errors that all of them raise.
#pragma once

#include <string>

#include "interpreter/evaluate.h"

namespace udcp {

template <class S>
Quantity<S> evaluate_formula(const FormulaText& formula, const Context<S>& context);

/// E_NAME with a suggestion from the names in scope and `more`. `in_formula`: alpha, N and h are known there.
Error unknown_name(const std::string& name, const Environment& scope, bool in_formula, const std::vector<std::string>& more = {});
/// E_TYPE: "'x' must be a number, but it is a mesh".
Error wrong_type(const std::string& what, const std::string& expected, const Value& given);
Error not_a_number(const std::string& what);
/// E_ARGUMENTS with the signature.
Error wrong_count(const FunctionValue& function, std::size_t given);
Error too_deep();
/// Counts one level up and, at the end of the block, down again.
class Nesting {
 public:
  explicit Nesting(int& depth) : depth_(depth) { ++depth_; }
  ~Nesting() { --depth_; }
  Nesting(const Nesting&) = delete;
  Nesting& operator=(const Nesting&) = delete;

 private:
  int& depth_;
};

/// E_INDEX unless 0 <= i < size.
void check_index(int i, std::size_t size);
std::string signature(const FunctionValue& function);
/// "a mesh", "an interval": with its article.
std::string with_article(const std::string& noun);

inline std::string kind_of_node(const grammar::Text&) { return "a text"; }
inline std::string kind_of_node(const grammar::List&) { return "a list"; }
inline std::string kind_of_node(const grammar::Range&) { return "a range"; }
inline std::string kind_of_node(const grammar::Interval&) { return "an interval"; }
inline std::string kind_of_node(const grammar::WordExpr&) { return "a word"; }
inline std::string kind_of_node(const grammar::Method&) { return "a method call"; }
inline std::string kind_of_node(const grammar::Pipe&) { return "a pipe"; }
inline std::string kind_of_node(const grammar::Step&) { return "a step"; }

}  // namespace udcp
