// What the text readers share: tokens and lines of a text in memory, numbers and indices in any number type, and errors that name
// the file and the line. Knows no format.
#pragma once

#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

#include "files/geometry_file.h"
#include "operators/number.h"

namespace udcp {

/// Bytes of a file with the name that stands in messages.
struct Input {
  std::string_view bytes;
  std::string name;
  Warnings* warnings = nullptr;
  std::filesystem::path folder;  // glTF: where buffers may lie; empty: none are read

  void warn(std::int64_t line, const std::string& message) const {
    if (warnings) warnings->push_back(place(line) + message);
  }
  /// "cage.obj:9: ", or "cage.glb: " for line 0.
  [[nodiscard]] std::string place(std::int64_t line) const {
    std::string text = name;
    if (line > 0) (text += ':') += std::to_string(line);
    return text += ": ";
  }
  [[noreturn]] void fail(std::int64_t line, const char* code, const std::string& message, const std::string& help = {}) const {
    throw Error(ErrorKind::file, code, place(line) + message, help);
  }
};

/// The token between quotes, short and printable.
std::string in_quotes(std::string_view token);

/// Refuses what is no text: UTF-16, NUL bytes. Returns the text after a UTF-8 byte order mark.
std::string_view text_of(const Input& input);

enum class NumberError { none, malformed, not_finite, too_large };
/// Decimal text to a number: rounded to nearest for double, exact or enclosed otherwise.
NumberError to_number(std::string_view token, double& value);
template <class S>
NumberError to_number(std::string_view token, S& value);
/// Where a plain decimal at `at` ends, after which anything may stand; null where there is none, or none for this number type.
inline const char* plain_number(const char* at, const char* end, double& value) {
  const auto [rest, error] = std::from_chars(at, end, value);
  return error == std::errc() && std::isfinite(value) ? rest : nullptr;
}
template <class S>
const char* plain_number(const char*, const char*, S&) {
  return nullptr;
}
/// A positive integer of at most nine digits at `at`, which moves behind it; 0 where there is none.
inline int plain_index(const char*& at, const char* end) {
  int value = 0;
  for (const char* stop = end - at > 9 ? at + 9 : end; at != stop && *at >= '0' && *at <= '9'; ++at)
    value = 10 * value + (*at - '0');
  return at != end && *at >= '0' && *at <= '9' ? 0 : value;
}
/// Moves over spaces; whether the line ends there, with LF or CR LF or the text.
inline bool at_line_end(const char*& at, const char* end) {
  while (at != end && *at == ' ') ++at;
  return at == end || *at == '\n' || (*at == '\r' && at + 1 != end && at[1] == '\n');
}

[[noreturn]] void fail_number(const Input& input, std::int64_t line, NumberError error, std::string_view token, const char* what);

/// The value of a binary floating-point number, which is exact in the exact types.
template <class S>
S exact_from(double value) {
  return number<S>(Rational::from_double(value));
}
template <>
inline double exact_from<double>(double value) {
  return value;
}

/// How a format writes its lines: where the flag is set, a backslash before a line end joins two lines, and '#' at the start of a
/// token opens a comment.
struct LineRules {
  bool backslash_joins = false;
  bool hash_comments = true;
};

/// Walks over a text token by token. Lines end with LF, CR LF or CR.
class Scanner {
 public:
  Scanner(const Input& input, std::string_view text, LineRules rules)
      : input_(&input), at_(text.data()), end_(text.data() + text.size()), rules_(rules) {}

  /// The next token of this line; empty at its end.
  std::string_view token() {
    skip_blanks();
    if (at_ == end_ || (rules_.hash_comments && *at_ == '#')) return {};
    const char* start = at_;
    while (at_ != end_ && (!may_end_token(*at_) || (*at_ == '\\' && !at_join()))) ++at_;
    return {start, static_cast<std::size_t>(at_ - start)};
  }

  /// Moves to the next line; false if there is none.
  bool next_line() {
    while (at_ != end_ && !is_newline(*at_)) ++at_;
    if (at_ == end_) return false;
    skip_newline();
    return true;
  }

  /// The next token of this line or a later one; empty at the end of the text.
  std::string_view word() {
    for (;;) {
      const std::string_view found = token();
      if (!found.empty() || !next_line()) return found;
    }
  }

  /// The rest of the line as it stands.
  std::string_view rest() {
    skip_blanks();
    const char* start = at_;
    while (at_ != end_ && !is_newline(*at_)) ++at_;
    return {start, static_cast<std::size_t>(at_ - start)};
  }

  /// For readers that know a plain form of a line: where the scanner is, and a place further on in the same line to go on from.
  [[nodiscard]] std::string_view ahead() const { return {at_, remaining()}; }
  void jump(const char* place) { at_ = place; }

  [[nodiscard]] std::int64_t line() const { return line_; }
  [[nodiscard]] bool saw_bare_cr() const { return bare_cr_; }
  [[nodiscard]] std::size_t remaining() const { return static_cast<std::size_t>(end_ - at_); }
  /// What follows the rest of this line.
  [[nodiscard]] std::string_view after_line() {
    next_line();
    return {at_, remaining()};
  }

  template <class... Arguments>
  [[noreturn]] void fail(const char* code, const Arguments&... arguments) const {
    input_->fail(line_, code, arguments...);
  }

  /// A number from the next token of the line; `what` names it in messages ("the x coordinate").
  template <class S>
  S number(const char* what) {
    const std::string_view found = token();
    if (found.empty()) fail("E_FILE_SYNTAX", std::string(what) + " is missing");
    return number_of<S>(found, what);
  }
  template <class S>
  S number_of(std::string_view found, const char* what) const {
    S value{};
    const NumberError error = to_number(found, value);
    if (error != NumberError::none) fail_number(*input_, line_, error, found, what);
    return value;
  }
  /// An integer; one that does not fit 64 bits is an error, not a wrapped value.
  std::int64_t integer_of(std::string_view found, const char* what) const;

 private:
  static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }
  static bool is_newline(char c) { return c == '\n' || c == '\r'; }
  /// One comparison for nearly every character of a token.
  static bool may_end_token(char c) { return static_cast<unsigned char>(c) <= ' ' ? is_blank(c) || is_newline(c) : c == '\\'; }
  [[nodiscard]] bool at_join() const { return rules_.backslash_joins && *at_ == '\\' && at_ + 1 != end_ && is_newline(at_[1]); }
  void skip_blanks() {
    while (at_ != end_) {
      if (is_blank(*at_)) {
        ++at_;
      } else if (at_join()) {
        ++at_;
        skip_newline();
      } else {
        return;
      }
    }
  }
  void skip_newline() {
    if (*at_ == '\r') {
      if (at_ + 1 != end_ && at_[1] == '\n') {
        ++at_;
      } else {
        bare_cr_ = true;
      }
    }
    ++at_;
    ++line_;
  }

  const Input* input_;
  const char* at_;
  const char* end_;
  std::int64_t line_ = 1;
  LineRules rules_;
  bool bare_cr_ = false;
};

}  // namespace udcp
