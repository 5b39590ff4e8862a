// libFuzzer: every text either gives a SyntaxError with a place inside it, or a program that survives printing and parsing again.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "grammar/parse.h"
#include "grammar/print.h"

using namespace udcp::grammar;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view source(reinterpret_cast<const char*>(data), size);
  Program program;
  try {
    program = parse(source);
  } catch (const SyntaxError& error) {
    if (error.code.empty() || error.span.begin > error.span.end || error.span.end > size) std::abort();
    static_cast<void>(excerpt(source, error.span, error.label));
    return 0;
  }
  const std::string text = to_string(program);
  const Program again = parse(text);  // an exception ends the run as a finding
  if (!same(program, again) || to_string(again) != text) std::abort();
  return 0;
}
