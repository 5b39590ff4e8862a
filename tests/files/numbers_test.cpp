// Decimals: the strict grammar, rounding, and the ends of the range, for doubles and exact numbers alike.
#include <random>

#include "files/scanner.h"
#include "files/writer.h"
#include "helpers.h"

using namespace udcp;

TEST_SUITE("files") {
  TEST_CASE("doubles and rationals accept the same decimals") {
    for (const std::string text : {"", "+", "-", ".", "e5", "1e", "1e+", "0x1", "1_0", "1,5", "--1", "+-1", "1.2.3", "1f", "1d5",
                                   "one", "1/2", " 1", "1 "}) {
      CAPTURE(text);
      double rounded = 0;
      Rational exact;
      CHECK(to_number(text, rounded) == NumberError::malformed);
      CHECK(to_number(text, exact) == NumberError::malformed);
    }
    for (const std::string text : {"nan", "NaN", "-nan", "nan(1)", "inf", "-Infinity", "+inf", "1.#INF"}) {
      CAPTURE(text);
      double rounded = 0;
      Rational exact;
      CHECK(to_number(text, rounded) == NumberError::not_finite);
      CHECK(to_number(text, exact) == NumberError::not_finite);
    }
    for (const char* text :
         {"0", "-0", "+7", "007", ".5", "5.", "-.5e1", "1e3", "1E+03", "2.5e-3", "123456789012345678901234567890"}) {
      CAPTURE(text);
      double rounded = 0;
      Rational exact;
      CHECK(to_number(text, rounded) == NumberError::none);
      CHECK(to_number(text, exact) == NumberError::none);
      CHECK(exact.to_double() == rounded);
    }
  }

  TEST_CASE("what underflows is zero and what overflows is refused") {
    double value = 1;
    CHECK(to_number("1e-400", value) == NumberError::none);
    CHECK(value == 0);
    CHECK(to_number("0.00000001e-320", value) == NumberError::none);
    CHECK(value == 0);
    CHECK(to_number("4.9e-324", value) == NumberError::none);
    CHECK(value == std::numeric_limits<double>::denorm_min());
    CHECK(to_number("1.7976931348623157e308", value) == NumberError::none);
    CHECK(to_number("1.7976931348623159e308", value) == NumberError::too_large);
    CHECK(to_number("0.001e999", value) == NumberError::too_large);
    CHECK(to_number("1e99999999999999999999", value) == NumberError::too_large);
    CHECK(to_number("0e99999999999999999999", value) == NumberError::none);
    Rational exact;
    CHECK(to_number("1e400", exact) == NumberError::none);
    CHECK(to_number("1e1001", exact) == NumberError::too_large);
  }

  TEST_CASE("random doubles come back from their shortest text") {
    std::mt19937_64 random(3);
    for (int trial = 0; trial < 2000; ++trial) {
      const double value = std::bit_cast<double>(random());
      if (!std::isfinite(value)) continue;
      Writer out(32);
      out << value;
      const std::string text = out.take();
      CAPTURE(text);
      double back = 0;
      CHECK(to_number(text, back) == NumberError::none);
      CHECK(std::bit_cast<std::uint64_t>(back) == std::bit_cast<std::uint64_t>(value));
    }
  }
}
