// Parts of OBJ lines: keywords that are passed over, and corners of faces in their four forms. Knows no reader and no mesh.
#pragma once

#include <algorithm>
#include <array>
#include <string_view>

#include "files/scanner.h"

namespace udcp {

inline bool is_known(std::string_view keyword) {
  constexpr std::array<std::string_view, 16> known{"vt",         "usemtl",    "mtllib", "s",   "usemap",   "maplib",
                                                   "shadow_obj", "trace_obj", "bevel",  "lod", "c_interp", "d_interp",
                                                   "mg",         "call",      "csh",    "vp"};
  return std::ranges::find(known, keyword) != known.end();
}

inline bool is_free_form(std::string_view keyword) {
  constexpr std::array<std::string_view, 18> words{"cstype", "deg",  "bmat", "step", "curv", "curv2", "surf",  "parm", "trim",
                                                   "hole",   "scrv", "sp",   "end",  "con",  "ctech", "stech", "bsp",  "bzp"};
  return std::ranges::find(words, keyword) != words.end();
}

/// Which of the four forms of a corner this is.
inline int form_of(std::string_view token) {
  const auto slash = token.find('/');
  if (slash == std::string_view::npos) return 0;
  if (token.substr(slash).starts_with("//")) return 1;
  return token.find('/', slash + 1) == std::string_view::npos ? 2 : 3;
}

/// One corner of positive indices, in any of the four forms. False where it is anything else.
struct PlainCorner {
  int vertex = 0, normal = 0, form = 0;  // 0: none; form as form_of says
  bool read(const char*& at, const char* end) {
    vertex = plain_index(at, end);
    if (vertex == 0 || at == end || *at != '/') return vertex != 0;
    ++at;
    const bool texture = at != end && *at != '/';
    if (texture && plain_index(at, end) == 0) return false;
    form = texture ? 2 : 1;
    if (at == end || *at != '/') return texture;
    ++at;
    if (texture) form = 3;
    normal = plain_index(at, end);
    return normal != 0;
  }
};

}  // namespace udcp
