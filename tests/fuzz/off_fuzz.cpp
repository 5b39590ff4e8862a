// Fuzz target of the reader of OFF.
#include "round_trip.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return udcp::round_trip(data, size, "off", true);
}
