// Text output of numbers: shortest decimals that read back to the same double, without streams or locale. Also what every writer
// of surfaces needs from the points.
#pragma once

#include <charconv>
#include <string>
#include <string_view>
#include <type_traits>

#include "operators/surface.h"

namespace udcp {

class TextWriter {
 public:
  explicit TextWriter(std::size_t expected_size) { text_.reserve(expected_size); }

  TextWriter& operator<<(std::string_view part) {
    text_.append(part);
    return *this;
  }
  TextWriter& operator<<(char c) {
    text_.push_back(c);
    return *this;
  }
  template <class Number>
  requires std::is_arithmetic_v<Number> TextWriter& operator<<(Number value) {
    char digits[40];
    const auto result = std::to_chars(digits, digits + sizeof digits, value);
    text_.append(digits, static_cast<std::size_t>(result.ptr - digits));
    return *this;
  }
  std::string take() { return std::move(text_); }

 private:
  std::string text_;
};

/// "Made by udcp" and the word, in one line.
std::string comment_line(const std::string& word);

/// Coordinate c of a vertex; missing coordinates are 0.
inline double coordinate(const Points<double>& points, Eigen::Index row, Eigen::Index c) {
  return c < points.cols() ? points(row, c) : 0.0;
}

/// Throws Error{input}: what validate throws, more than three columns (E_DIMENSION), E_NOT_FINITE naming the vertex.
void check_for_writing(const Surface<double>& surface);
/// The same, and E_FLOAT_RANGE for coordinates that do not fit a float.
void check_for_floats(const Surface<double>& surface);

/// Area-weighted sums of face normals, not of unit length: per vertex, three columns.
Points<double> area_normals(const Surface<double>& surface);

/// Corner triples: quads along the shorter diagonal, larger faces as fans.
std::vector<std::array<int, 3>> triangles(const Surface<double>& surface);

}  // namespace udcp
