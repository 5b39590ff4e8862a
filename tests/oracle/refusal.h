// What a call throws, as text to pin: "E_CODE: message", with "item 3: " in front where a word item is meant.
#pragma once

#include <string>

#include "operators/error.h"

namespace udcp::oracle {

template <class F>
std::string refusal(F call) {
  try {
    call();
  } catch (const Error& error) {
    return (error.item < 0 ? "" : "item " + std::to_string(error.item) + ": ") + error.code + ": " + error.what();
  }
  return "accepted";
}

}  // namespace udcp::oracle
