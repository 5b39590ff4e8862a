// Places, excerpts and encodings of texts.
#include "grammar/source.h"

#include <doctest/doctest.h>

using namespace udcp::grammar;

TEST_SUITE_BEGIN("grammar");

TEST_CASE("places count lines and characters from one") {
  const std::string text = "ab\nωδ x\n\n";
  CHECK(place_of(text, 0).line == 1);
  CHECK(place_of(text, 0).column == 1);
  CHECK(place_of(text, 2).column == 3);
  CHECK(place_of(text, 3).line == 2);
  CHECK(place_of(text, 8).column == 4);  // x stands behind two letters of two bytes and a blank
  CHECK(place_of(text, 10).line == 3);
  CHECK(place_of(text, 99).line == 4);
  CHECK(place_of("", 0).line == 1);
}

TEST_CASE("an excerpt shows the line under its number with carets and a label") {
  CHECK(excerpt("U\nC\n(UDP)*\n", {7, 8}, "one D since the last U; P needs an even number") ==
        " 3 | (UDP)*\n   |    ^ one D since the last U; P needs an even number\n");
  CHECK(excerpt("abc", {0, 3}, "") == " 1 | abc\n   | ^^^\n");
  CHECK(excerpt("abc", {3, 3}, "end") == " 1 | abc\n   |    ^ end\n");
  CHECK(excerpt("", {0, 0}, "x") == " 1 | \n   | ^ x\n");
}

TEST_CASE("the gutter of an excerpt grows with the line number") {
  const std::string text = std::string(9, '\n') + "x = 1\n";
  CHECK(excerpt(text, {9, 10}, "here") == " 10 | x = 1\n    | ^ here\n");
}

TEST_CASE("carets stay on the first line of a span and count characters") {
  CHECK(excerpt("ab\ncd", {1, 5}, "") == " 1 | ab\n   |  ^\n");
  CHECK(excerpt("αβγ + x\n", {4, 6}, "") == " 1 | αβγ + x\n   |   ^\n");
  CHECK(excerpt("ab\r\ncd", {1, 5}, "") == " 1 | ab\n   |  ^\n");
}

TEST_CASE("tabs in front of a span are kept so that carets align") {
  CHECK(excerpt("\tx\ty = 1", {3, 4}, "here") == " 1 | \tx\ty = 1\n   | \t \t^ here\n");
}

TEST_CASE("a very long line is clipped around the span") {
  const std::string text = std::string(1000, 'a') + "!" + std::string(1000, 'b');
  const std::string shown = excerpt(text, {1000, 1001}, "here");
  CHECK(shown == " 1 | …" + std::string(60, 'a') + "!" + std::string(139, 'b') + "…\n   | " + std::string(61, ' ') + "^ here\n");
  const std::string wide = excerpt(text, {0, 2001}, "");
  CHECK(wide == " 1 | " + std::string(200, 'a') + "…\n   | " + std::string(200, '^') + "\n");
  const std::string exact(200, 'c');
  CHECK(excerpt(exact, {0, 1}, "") == " 1 | " + exact + "\n   | ^\n");
}

TEST_CASE("bad bytes are found where they stand") {
  CHECK(find_bad_byte("plain ω € 😀") == std::string_view::npos);
  CHECK(find_bad_byte(std::string_view("ab\0c", 4)) == 2);
  for (const std::string_view bad : {"\x80", "\xC0\xAF", "\xC3", "\xE0\x80\x80", "\xED\xA0\x80", "\xF0\x80\x80\x80",
                                     "\xF4\x90\x80\x80", "\xFF", "\xE2\x82", "\xF5\x80\x80\x80", "\xC3("}) {
    CAPTURE(bad);
    CHECK(find_bad_byte("ab" + std::string(bad)) == 2);
  }
  CHECK(character_length("aω€😀", 0) == 1);
  CHECK(character_length("aω€😀", 1) == 2);
  CHECK(character_length("aω€😀", 3) == 3);
  CHECK(character_length("aω€😀", 6) == 4);
}

TEST_SUITE_END();
