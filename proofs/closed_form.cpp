// Reading and evaluating prefix formulas, in every number type.
#include "proofs/closed_form.h"

#include <algorithm>
#include <array>
#include <vector>

namespace udcp {
namespace {

struct Node {
  std::string name;  // of the operator or the name; empty: the number
  Rational number;
  std::vector<Node> operands;
};

[[noreturn]] void refuse(const std::string& why) {
  throw Error(ErrorKind::input, "E_CLOSED_FORM", "a formula in prefix form: " + why, "such as (cos (/ alpha 2))");
}

std::size_t operands_of(const std::string& name) {
  static constexpr std::array<const char*, 7> two = {"+", "-", "*", "/", "^", "min", "max"};
  static constexpr std::array<const char*, 8> one = {"neg", "sqrt", "cos", "sin", "tan", "exp", "log", "abs"};
  if (std::find(two.begin(), two.end(), name) != two.end()) return 2;
  return std::find(one.begin(), one.end(), name) != one.end() ? 1 : 0;
}

class Reader {
 public:
  explicit Reader(const std::string& text) : text_(text) {}

  Node whole() {
    Node node = part(0);
    blanks();
    if (at_ != text_.size()) refuse("something follows its end");
    return node;
  }

 private:
  void blanks() {
    while (at_ < text_.size() && text_[at_] == ' ') ++at_;
  }

  std::string token() {
    const std::size_t begin = at_;
    while (at_ < text_.size() && text_[at_] != ' ' && text_[at_] != '(' && text_[at_] != ')') ++at_;
    return text_.substr(begin, at_ - begin);
  }

  Node part(int level) {
    if (level > 100) refuse("more than 100 levels");
    blanks();
    if (at_ == text_.size()) refuse("it ends too early");
    if (text_[at_] != '(') return leaf(token());
    ++at_;
    Node node{token(), {}, {}};
    const std::size_t expected = operands_of(node.name);
    if (expected == 0) refuse("there is no operator '" + node.name.substr(0, 20) + "'");
    for (std::size_t k = 0; k < expected; ++k) node.operands.push_back(part(level + 1));
    blanks();
    if (at_ == text_.size() || text_[at_] != ')') refuse("'" + node.name + "' has too many operands or no ')'");
    ++at_;
    return node;
  }

  static Node leaf(const std::string& word) {
    if (word == "alpha" || word == "N" || word == "pi") return {word, {}, {}};
    if (word.empty() || word.find_first_not_of("-0123456789/") != std::string::npos)
      refuse("'" + word.substr(0, 20) + "' is no number");
    return {"", Rational::parse(word), {}};
  }

  const std::string& text_;
  std::size_t at_ = 0;
};

std::string text_of(const Node& node) {
  if (node.operands.empty()) return node.name.empty() ? node.number.to_string() : node.name;
  std::string text = "(" + node.name;
  for (const Node& operand : node.operands) text += " " + text_of(operand);
  return text + ")";
}

bool mentions(const Node& node, const std::string& name) {
  return node.name == name ||
         std::any_of(node.operands.begin(), node.operands.end(), [&](const Node& n) { return mentions(n, name); });
}

template <class S>
Quantity<S> value_of(const Node& node, const Context<S>& context) {
  const std::string& name = node.name;
  if (node.operands.empty()) {
    if (name.empty()) return Quantity<S>(node.number);
    if (name == "alpha") return context.alpha;
    return name == "N" ? Quantity<S>(context.valence) : Quantity<S>::pi();
  }
  const Quantity<S> a = value_of(node.operands[0], context);
  if (node.operands.size() == 1) {
    if (name == "neg") return -a;
    if (name == "sqrt") return sqrt(a);
    if (name == "cos") return cos(a);
    if (name == "sin") return sin(a);
    if (name == "tan") return tan(a);
    if (name == "exp") return exp(a);
    return name == "log" ? log(a) : abs(a);
  }
  const Quantity<S> b = value_of(node.operands[1], context);
  if (name == "+") return a + b;
  if (name == "-") return a - b;
  if (name == "*") return a * b;
  if (name == "/") return a / b;
  if (name == "^") return pow(a, b);
  return name == "min" ? min(a, b) : max(a, b);
}

/// cos(alpha/2), also as cos(1/2*alpha) and cos(alpha*1/2).
bool is_half_cosine(const Node& node) {
  if (node.name != "cos") return false;
  const Node& half = node.operands[0];
  if (half.operands.size() != 2) return false;
  const Node &a = half.operands[0], &b = half.operands[1];
  const auto is = [](const Node& n, const Rational& value) { return n.operands.empty() && n.name.empty() && n.number == value; };
  const Rational one_half = Rational(1) / Rational(2);
  return (half.name == "/" && a.name == "alpha" && is(b, Rational(2))) ||
         (half.name == "*" && ((a.name == "alpha" && is(b, one_half)) || (b.name == "alpha" && is(a, one_half))));
}

Parametric in_half_cosine(const Node& node) {
  if (is_half_cosine(node)) return Parametric::variable("X");
  if (node.operands.empty() && node.name.empty()) return Parametric(node.number);
  if (node.name == "neg") return -in_half_cosine(node.operands[0]);
  if (node.operands.size() == 2) {
    const Parametric a = in_half_cosine(node.operands[0]), b = in_half_cosine(node.operands[1]);
    if (node.name == "+") return a + b;
    if (node.name == "-") return a - b;
    if (node.name == "*") return a * b;
    if (node.name == "/") return a / b;
    if (node.name == "^" && b.is_constant() && b.constant().fits_int()) return pow(a, b.constant().to_int());
  }
  throw Error(ErrorKind::not_exact, "E_PARAMETER",
              "'" + text_of(node).substr(0, 60) + "' is no rational function of cos(alpha/2)");
}

class ClosedForm final : public Kernel {
 public:
  explicit ClosedForm(Node root) : root_(std::move(root)) {}
  [[nodiscard]] Needs needs() const override { return {mentions(root_, "N"), false, mentions(root_, "alpha")}; }
  [[nodiscard]] std::string closed_form() const override { return text_of(root_); }
#define UDCP_KERNEL_AT(S) \
  [[nodiscard]] Quantity<S> at(const Context<S>& context) const override { return value_of(root_, context); }
  UDCP_FOR_EACH_NUMBER(UDCP_KERNEL_AT)
#undef UDCP_KERNEL_AT

 private:
  Node root_;
};

}  // namespace

Parametric value_in_half_cosine(const std::string& text) {
  if (text.size() > 10'000) refuse("more than 10,000 characters");
  return in_half_cosine(Reader(text).whole());
}

KernelPtr kernel_from(const std::string& text) {
  if (text.size() > 10'000) refuse("more than 10,000 characters");
  return std::make_shared<ClosedForm>(Reader(text).whole());
}

}  // namespace udcp
