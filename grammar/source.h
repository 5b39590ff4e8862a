// Program text: places, lines and the excerpt with carets that every diagnostic shows. Knows no grammar.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace udcp::grammar {

/// Bytes [begin, end) of the text.
struct Span {
  std::size_t begin = 0, end = 0;
  friend bool operator==(const Span&, const Span&) = default;
};

/// Counted from 1; columns count characters (UTF-8 code points), not bytes.
struct Place {
  int line = 1, column = 1;
};
/// An offset behind the end counts as the end.
Place place_of(std::string_view text, std::size_t offset);

/// The source line under its number, and carets below the span (clipped to its first line, at least one caret), followed by
/// `label`:
///  3 | (UDP)*
///    |    ^ label
/// Both lines end with a newline. Tabs stay, so that carets align; of a very long line only the surroundings of the span are
/// shown, between "…".
std::string excerpt(std::string_view text, Span span, std::string_view label);

/// Offset of the first byte that is NUL or no part of well-formed UTF-8; npos if there is none.
std::size_t find_bad_byte(std::string_view text);

/// Length in bytes of the UTF-8 character at `offset` of a well-formed text.
std::size_t character_length(std::string_view text, std::size_t offset);

}  // namespace udcp::grammar
