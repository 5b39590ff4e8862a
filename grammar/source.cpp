// Places and excerpts of a text. Offsets are bytes; everything shown to people counts characters.
#include "grammar/source.h"

#include <algorithm>

namespace udcp::grammar {
namespace {

constexpr std::size_t widest_excerpt = 200;  // characters of a source line that are shown
constexpr std::size_t margin = 60;           // characters kept on the left of the span in a clipped line

unsigned byte_at(std::string_view text, std::size_t offset) { return static_cast<unsigned char>(text[offset]); }
bool is_continuation(char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; }

std::size_t characters(std::string_view text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) { return !is_continuation(c); }));
}

/// The first `count` characters of text, as bytes.
std::size_t bytes_of(std::string_view text, std::size_t count) {
  std::size_t offset = 0;
  for (; count > 0 && offset < text.size(); --count) {
    ++offset;
    while (offset < text.size() && is_continuation(text[offset])) ++offset;
  }
  return offset;
}

/// Length of the well-formed sequence at `offset`, 0 if there is none: no overlong forms, surrogates or values above U+10FFFF.
std::size_t sequence_length(std::string_view text, std::size_t offset) {
  const unsigned lead = byte_at(text, offset);
  if (lead < 0x80) return lead == 0 ? 0 : 1;
  const std::size_t length = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
  if (lead < 0xC2 || lead > 0xF4 || offset + length > text.size()) return 0;
  for (std::size_t i = 1; i < length; ++i) {
    if (!is_continuation(text[offset + i])) return 0;
  }
  const unsigned second = byte_at(text, offset + 1);
  if (lead == 0xE0 && second < 0xA0) return 0;
  if (lead == 0xED && second > 0x9F) return 0;
  if (lead == 0xF0 && second < 0x90) return 0;
  if (lead == 0xF4 && second > 0x8F) return 0;
  return length;
}

/// What is shown of a line: its visible part, and the span in it as characters before and under the carets.
struct Window {
  std::string shown;
  std::string before;  // the shown text on the left of the carets
  std::size_t carets = 1;
};

Window window(std::string_view line, std::size_t begin, std::size_t end) {
  const std::size_t left = characters(line.substr(0, begin));
  const std::size_t width = std::max<std::size_t>(1, characters(line.substr(begin, end - begin)));
  if (characters(line) <= widest_excerpt) return {std::string(line), std::string(line.substr(0, begin)), width};
  const std::size_t skipped = left > margin ? left - margin : 0;
  const std::size_t from = bytes_of(line, skipped);
  const std::size_t size = bytes_of(line.substr(from), widest_excerpt);
  const std::string head = skipped > 0 ? "…" : "";
  const std::string tail = from + size < line.size() ? "…" : "";
  const std::size_t room = widest_excerpt - (left - skipped);
  return {head + std::string(line.substr(from, size)) + tail, head + std::string(line.substr(from, begin - from)),
          std::min(width, room)};
}

}  // namespace

Place place_of(std::string_view text, std::size_t offset) {
  const std::string_view before = text.substr(0, std::min(offset, text.size()));
  const std::size_t newline = before.rfind('\n');
  const std::string_view line = newline == std::string_view::npos ? before : before.substr(newline + 1);
  return {1 + static_cast<int>(std::count(before.begin(), before.end(), '\n')), 1 + static_cast<int>(characters(line))};
}

std::string excerpt(std::string_view text, Span span, std::string_view label) {
  std::size_t begin = std::min(span.begin, text.size());
  const std::size_t newline = begin == 0 ? std::string_view::npos : text.rfind('\n', begin - 1);
  const std::size_t line_begin = newline == std::string_view::npos ? 0 : newline + 1;
  std::size_t line_end = std::min(text.find('\n', begin), text.size());
  if (line_end > line_begin && text[line_end - 1] == '\r') --line_end;
  begin = std::min(begin, line_end);
  const std::string_view line = text.substr(line_begin, line_end - line_begin);
  const std::size_t end = std::clamp(span.end, begin, line_end);
  const Window shown = window(line, begin - line_begin, end - line_begin);

  const std::string number = std::to_string(place_of(text, begin).line);
  std::string result = " ";
  result.append(number).append(" | ").append(shown.shown).append("\n");
  result += std::string(number.size() + 1, ' ') + " | ";
  for (const char c : shown.before) {
    if (!is_continuation(c)) result += c == '\t' ? '\t' : ' ';
  }
  result += std::string(shown.carets, '^');
  if (!label.empty()) result.append(" ").append(label);
  return result + "\n";
}

std::size_t find_bad_byte(std::string_view text) {
  for (std::size_t offset = 0; offset < text.size();) {
    const std::size_t length = sequence_length(text, offset);
    if (length == 0) return offset;
    offset += length;
  }
  return std::string_view::npos;
}

std::size_t character_length(std::string_view text, std::size_t offset) { return bytes_of(text.substr(offset), 1); }

}  // namespace udcp::grammar
