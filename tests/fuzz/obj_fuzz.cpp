// Fuzz target of the OBJ reader, as a mesh, as a curve and in exact numbers.
#include "round_trip.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  try {
    const auto curve = udcp::load_curve_bytes<udcp::Rational>(bytes, "fuzz");
    validate(curve);
  } catch (const udcp::Error& error) {
    if (error.kind == udcp::ErrorKind::internal) std::abort();
  }
  return udcp::round_trip(data, size, "obj", true);
}
