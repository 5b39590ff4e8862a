// Matrix Market text.
#include "files/matrix_market.h"

#include "helpers.h"

using namespace udcp;
using namespace udcp::test;

TEST_SUITE("files") {
  TEST_CASE("a matrix of doubles is written in both layouts") {
    Points<double> matrix(2, 3);
    matrix << 1, 0, -0.1, 0, 1e-300, 2;
    CHECK(matrix_market(matrix) == "%%MatrixMarket matrix coordinate real general\n2 3 4\n1 1 1\n1 3 -0.1\n2 2 1e-300\n2 3 2\n");
    CHECK(matrix_market(matrix, MatrixLayout::array, "a\nb") ==
          "%%MatrixMarket matrix array real general\n% a\n% b\n2 3\n1\n0\n0\n1e-300\n-0.1\n2\n");
    matrix(1, 0) = NAN;
    CHECK(refusal([&] { matrix_market(matrix); }) == "E_NOT_FINITE: entry (2, 1) of the matrix is not finite");
  }

  TEST_CASE("exact entries stand in comments") {
    Points<Rational> matrix(1, 2);
    matrix << Rational::parse("1/3"), Rational(0);
    CHECK(matrix_market(matrix) ==
          "%%MatrixMarket matrix coordinate real general\n% The entries below are rounded to double; what they stand for:\n"
          "% (1, 1) = 1/3\n1 2 1\n1 1 0.3333333333333333\n");
    Points<Interval> enclosed(1, 1);
    enclosed << Interval(Rational::parse("1/3"));
    CHECK(matrix_market(enclosed).find("% (1, 1) = [0.33333") != std::string::npos);
  }
}
