// Recursive descent over linear forms: a value is its constant part and the weights of the points.
#include "proofs/regularity/printed_formula.h"

#include <algorithm>
#include <sstream>

namespace udcp {
namespace {

using Index = Eigen::Index;

[[noreturn]] void refuse(const std::string& text, const std::string& why) {
  throw Error(ErrorKind::internal, "E_INTERNAL", "the printed formula " + text + " cannot be read: " + why);
}

struct Linear {
  Rational constant;
  Points<Rational> weights;
  [[nodiscard]] bool is_number() const {
    return std::all_of(weights.data(), weights.data() + weights.size(), [](const Rational& w) { return w.is_zero(); });
  }
};

Linear scaled(Linear value, const Rational& factor) {
  value.constant *= factor;
  for (Index k = 0; k < value.weights.size(); ++k) value.weights.data()[k] *= factor;
  return value;
}

class FormulaReader {
 public:
  FormulaReader(const std::string& text, const std::vector<RefinedGrid>& levels) : text_(text), levels_(levels) {}

  Points<Rational> read() {
    const Linear value = sum(0);
    skip();
    if (at_ != text_.size()) refuse(text_, "it goes on after its end");
    if (!value.constant.is_zero()) refuse(text_, "it is no combination of points");
    return value.weights;
  }

 private:
  Linear sum(int depth) {
    if (depth > 20) refuse(text_, "too many brackets");
    Linear total = accept('-') ? scaled(product(depth), Rational(-1)) : product(depth);
    while (true) {
      const bool minus = peek() == '-';
      if (!accept('-') && !accept('+')) return total;
      const Linear next = product(depth);
      total.constant += minus ? -next.constant : next.constant;
      total.weights = minus ? Points<Rational>(total.weights - next.weights) : Points<Rational>(total.weights + next.weights);
    }
  }

  /// Factors from left to right; a sign of multiplication may be missing: 6p12, 1/16 (p12 - p11).
  Linear product(int depth) {
    Linear value = factor(depth);
    while (true) {
      if (accept('/')) {
        const Linear divisor = factor(depth);
        if (!divisor.is_number() || divisor.constant.is_zero()) refuse(text_, "it divides by what is no number");
        value = scaled(value, Rational(1) / divisor.constant);
      } else if (accept('*') || peek() == '(' || peek() == 'p' || is_digit(peek())) {
        const Linear other = factor(depth);
        if (!value.is_number() && !other.is_number()) refuse(text_, "it multiplies points");
        value = value.is_number() ? scaled(other, value.constant) : scaled(value, other.constant);
      } else {
        return value;
      }
    }
  }

  Linear factor(int depth) {
    if (accept('(')) {
      const Linear inside = sum(depth + 1);
      if (!accept(')')) refuse(text_, "a bracket is missing");
      return inside;
    }
    return peek() == 'p' ? point() : literal();
  }

  Linear literal() {
    const std::size_t from = at_;
    while (at_ < text_.size() && (is_digit(text_[at_]) || text_[at_] == '.')) ++at_;
    if (from == at_) refuse(text_, "a number or a point is missing");
    return {Rational::parse(text_.substr(from, at_ - from)), Points<Rational>::Zero(1, width())};
  }

  Linear point() {
    std::size_t level = 0;
    for (++at_; at_ < text_.size() && text_[at_] == '\''; ++at_) ++level;
    if (level >= levels_.size() || at_ + 2 > text_.size() || !is_digit(text_[at_]) || !is_digit(text_[at_ + 1]))
      refuse(text_, "a point needs a row and a column");
    const RefinedGrid& grid = levels_[level];
    const int i = text_[at_] - '0', j = text_[at_ + 1] - '0';
    at_ += 2;
    if (i < 1 || j < 1 || i > grid.rows() || j > grid.columns()) refuse(text_, "a point is outside the grid");
    return {Rational(0), grid.printed_point(i, j)};
  }

  [[nodiscard]] Index width() const { return levels_.front().rows() * levels_.front().columns(); }
  static bool is_digit(char c) { return c >= '0' && c <= '9'; }
  void skip() {
    while (at_ < text_.size() && text_[at_] == ' ') ++at_;
  }
  char peek() {
    skip();
    return at_ < text_.size() ? text_[at_] : '\0';
  }
  bool accept(char c) {
    if (peek() != c) return false;
    ++at_;
    return true;
  }

  const std::string& text_;
  const std::vector<RefinedGrid>& levels_;
  std::size_t at_ = 0;
};

Rational common_denominator(const Points<Rational>& row) {
  Rational common(1);
  for (Index k = 0; k < row.size(); ++k) common *= (common * row.data()[k]).denominator();
  return common;
}

std::string over(const Rational& denominator) {
  return denominator == Rational(1) ? std::string() : "/" + denominator.to_string();
}

}  // namespace

PrintedPoints::PrintedPoints(int rows, int columns) : rows_(rows), columns_(columns) {
  for (int rounds = 0; rounds <= 2; ++rounds) levels_.emplace_back(rows, columns, rounds);
}

Points<Rational> PrintedPoints::form(const std::string& formula) const { return FormulaReader(formula, levels_).read(); }

std::vector<std::vector<std::string>> printed_entries(const std::string& text) {
  std::vector<std::vector<std::string>> rows;
  std::stringstream lines(text);
  for (std::string line; std::getline(lines, line, ';');) {
    std::replace_if(
        line.begin(), line.end(), [](char c) { return c == '(' || c == ')' || c == ','; }, ' ');
    std::stringstream entries(line);
    rows.emplace_back();
    for (std::string entry; entries >> entry;) rows.back().push_back(entry);
    if (rows.back().empty() || rows.back().size() != rows.front().size()) refuse(text, "rows of unequal length");
  }
  if (rows.empty()) refuse(text, "it is empty");
  return rows;
}

Points<Rational> printed_table(const std::string& text) {
  const std::vector<std::vector<std::string>> rows = printed_entries(text);
  Points<Rational> result(static_cast<Index>(rows.size()), static_cast<Index>(rows.front().size()));
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (std::size_t j = 0; j < rows[i].size(); ++j)
      result(static_cast<Index>(i), static_cast<Index>(j)) = Rational::parse(rows[i][j]);
  return result;
}

Rational half_unit(const std::string& decimal) {
  const std::size_t point = decimal.find('.');
  const int digits = point == std::string::npos ? 0 : static_cast<int>(decimal.size() - point - 1);
  return pow(Rational(1) / Rational(10), digits) / Rational(2);
}

std::string form_text(const Points<Rational>& weights, int columns) {
  const Rational denominator = common_denominator(weights);
  std::string text;
  int terms = 0;
  for (Index k = 0; k < weights.size(); ++k) {
    const Rational w = denominator * weights.data()[k];
    if (w.is_zero()) continue;
    const std::string sign = w.sign() < 0 ? (terms > 0 ? " - " : "-") : (terms > 0 ? " + " : "");
    const Index i = k / columns + 1, j = k % columns + 1;
    text += sign + (abs(w) == Rational(1) ? "" : abs(w).to_string() + " ") + "p" + std::to_string(i) + std::to_string(j);
    ++terms;
  }
  if (terms == 0) return "0";
  return terms > 1 && denominator != Rational(1) ? "(" + text + ")" + over(denominator) : text + over(denominator);
}

std::string row_text(const Points<Rational>& row) {
  const Rational denominator = common_denominator(row);
  std::string text;
  for (Index k = 0; k < row.size(); ++k) text += (k > 0 ? ", " : "") + (denominator * row.data()[k]).to_string();
  return "(" + text + ")" + over(denominator);
}

}  // namespace udcp
