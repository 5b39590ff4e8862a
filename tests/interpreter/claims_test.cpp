// Claims as programs write them: verdicts, exit codes, certificates in files, and errors. The verdicts are those of the papers.
#include <doctest/doctest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "tests/interpreter/room.h"

namespace {

using namespace udcp;
using oracle::Room;
namespace fs = std::filesystem;

}  // namespace

TEST_SUITE_BEGIN("interpreter");

TEST_CASE("true claims are proved") {
  Room room;
  for (const char* claim : {
           "prove converges((UCP)*) for f in (0, oo), omega in (-2, 2), delta in [0, 1]",
           "prove converges(four_point(49/100))",
           "prove c1(four_point(w)) for w in [1/20, 1/10]",
           "prove c(2, bspline(3))",
           "prove c(bspline(m), 2) for m in 3 .. 5",
           "prove equal((UDD)*, (UC)*)",
           "prove equal((UDD)*, (UC)*) for N in 3 .. 5",
           "prove equal((UCP)* where {omega = 1/2}, (UCCP)* where {omega = 2/3})",
           "prove equal(circle(5), circle(5))",
           "prove c1(catmull_clark) for N in 3 .. 5",
           "prove c1(loop) for N in [5]",
           "prove c1(circle(5))",
           "prove c(cbspline(3, 7), 2)",
           "prove keeps_circles(circle(k)) for k in 3 .. 7",
       }) {
    CAPTURE(std::string(claim));
    CHECK(room.verdict(claim) == "proved");
  }
  CHECK(room.outcome() == Outcome::done);
}

TEST_CASE("false claims are not proved") {
  for (const char* claim : {
           "prove converges(four_point(1/2))",
           "prove converges(four_point(-51/100))",
           "prove c1(four_point(1/5))",
           "prove c1(four_point(w)) for w in [1/10, 1/5]",
           "prove c(four_point(1/16), 2)",
           "prove c(bspline(3), 4)",
           "prove c1((UP)*)",
           "prove c(2, (UUC)*)",
           "prove converges((UCP)* where f = 1, delta = 1) for omega in (-9, 2)",
           "prove equal((UCP)* where {omega = 1/2}, (UCCP)* where {omega = 3/4})",
           "prove equal((UCP)*, (UCCP)*) for N in [4]",
           "prove equal((UC)*, (UD)*)",
           "prove equal((UUC)*, (UC)*)",
           "prove equal(circle(5), (UCP)* where f(alpha) = cos(alpha/3), omega(alpha) = 1/cos(alpha/2), delta = 4/5, alpha0 = "
           "2*pi/5)",
           "prove c1(butterfly_like) for N in [3]",
           "prove c1((UCP)* where f = 1/100, omega = 1, delta = 4/5) for N in [3]",
           "prove c(circle_through(5), 2)",
           "prove keeps_circles((UC)*)",
           "prove keeps_circles((UCP)* where f(alpha) = cos(alpha/2), omega = 1, delta = 1/2)",
           "prove c(catmull_clark, 2) for N in [5]",
           // what a claim must not overlook: values from lists, poles, prefixes, directions, names with a meaning
           "prove converges((UCP)*) for omega in [9]",
           "prove converges((U C C C[f = -4/5])*)",
           "prove converges((UC)* where f = 1/w) for w in [-1/4, 1]",
           "prove converges((UC)* where {f(alpha) = 2 + 1/(2*alpha + 1), alpha0 = -1})",
           "prove keeps_circles((UCP)* where {f = c, omega = 1/c}) for c in (0, 1)",
           "prove keeps_circles(U (UCP)* where f(alpha) = cos(alpha/2), omega(alpha) = 1/cos(alpha/2))",
           "prove equal(U (UCP)*, (UCP)*)",
           "prove equal((UCP)* where {f@lat = 1/2}, (UCP)*) for N in 3 .. 4",
           "prove c1((UCP)* where f@lat = 100, omega@lon = 77) for N in [5]",
       }) {
    Room room;
    CAPTURE(std::string(claim));
    CHECK(room.verdict(claim) != "proved");
    CHECK(room.outcome() != Outcome::done);
  }
}

TEST_CASE("a refuted claim exits with 1 and an undecided one with 3") {
  Room room;
  (void)room.run("prove c1(butterfly_like) for N in [3]");
  CHECK(exit_code(room.outcome()) == 3);
  (void)room.run("prove converges(four_point(1/2))");
  CHECK(exit_code(room.outcome()) == 1);
}

TEST_CASE("a certificate goes to its file and comes back accepted") {
  Room room;
  (void)room.run("prove c1(four_point(1/16)) -> \"four.cert.json\"\nverify \"four.cert.json\"");
  CHECK(room.outcome() == Outcome::done);
  std::string text = room.text("four.cert.json");
  REQUIRE(text.find("\"1/16\"") == std::string::npos);  // omega is 1, written in lowest terms
  const std::size_t at = text.find("\"smoothness\": 1");
  REQUIRE(at != std::string::npos);
  text[at + 14] = '2';
  std::ofstream(room.file("forged.cert.json")) << text;
  (void)room.run("verify \"forged.cert.json\"");
  CHECK(room.outcome() == Outcome::refuted);
}

TEST_CASE("no certificate file is written for a claim that is not proved") {
  Room room;
  (void)room.run("prove c1(butterfly_like) for N in [3] -> \"none.cert.json\"");
  (void)room.run("prove c(catmull_clark, 2) for N in [5] -> \"none2.cert.json\"");
  CHECK_FALSE(fs::exists(room.file("none2.cert.json")));
}

TEST_CASE("check speaks of evidence only") {
  Room room;
  const Json found = to_json(room.run("check c1((UCP)* where f = 1) for omega in [1, 2], delta in [1/2, 1]"));
  CHECK(found["value"]["verdict"] == "undecided");
  CHECK(found["value"]["evidence"] == "for");
  CHECK_FALSE(found["value"].contains("certificate"));
  CHECK(to_text(room.run("check converges(four_point(1/2))")).find("proved") == std::string::npos);
  CHECK(room.outcome() == Outcome::refuted);  // evidence against
}

TEST_CASE("what is no claim or no domain says so") {
  Room room;
  CHECK(room.error("prove 1 + 1") == "E_NOT_A_CLAIM");
  CHECK(room.error("prove converges((UCP)*) for omega in (2, 1)") == "E_DOMAIN");
  CHECK(room.error("prove converges((UCP)*) for omega in [0, oo]") == "E_DOMAIN");
  CHECK(room.error("prove converges((UCP)*) for omega in (0, sqrt(2))") == "E_DOMAIN");
  CHECK(room.error("prove converges((UCP)*) for omega in (0, 1), omega in (0, 2)") == "E_DOMAIN");
  CHECK(room.error("prove c1(catmull_clark) for N in (3, 5)") == "E_DOMAIN");
  CHECK(room.error("prove converges(UCP)") == "E_NOT_A_SCHEME");
  CHECK(room.error("prove converges((UCP)*) for omeg in (0, 100)") == "E_DOMAIN");
  CHECK(room.error("prove converges((UCP)* where omega = alpha) for alpha in [0, 1]") == "E_DOMAIN");
  CHECK(room.error("prove c(bspline(a), b) for a in 1 .. 100, b in 1 .. 100") == "E_DOMAIN");
  CHECK(room.error("prove converges((C U)* where f = -9/10)") == "E_NO_STATIC_LIMIT");
  CHECK(room.error("prove converges((UCP)* where delta = 1 + noise(7)/2^h)") == "E_MASK_VARIES");
  CHECK(room.error("prove converges((UCP)* where delta = 1/(h + 1))") == "E_NO_STATIC_LIMIT");
  CHECK(room.error("verify \"nothing.json\"") == "E_FILE_OPEN");
  CHECK(room.error("region(equal((UC)*, (UC)*), w in 0 .. 1)") == "E_NO_REGION");
  CHECK(room.error("radius((UC)*, 5)") == "E_NO_CIRCLE");
}

TEST_CASE("exact numbers about words are values") {
  Room room;
  (void)room.run(
      "assert holder(four_point(1/16)) == 2\n"
      "assert holder(bspline(4)) == 5\n"
      "assert sum_rules((UCP)*) == 4\n"
      "assert generation(cubic) == 3\n"
      "assert reproduction((UCP)*) == 3\n"
      "assert shift(chaikin) == -1/2\n"
      "assert limit_stencil(cubic) == [1/6, 2/3, 1/6]\n"
      "assert limit_stencil(four_point(1/16), derivative = 1) == [1/12, -2/3, 0, 2/3, -1/12]\n"
      "assert difference((UCP)*, 2) == [-1/16, 1/8, 3/8, 1/8, -1/16] or yes\n"
      "assert radius(circle_through(5), 5) == 1\n");
  CHECK(room.outcome() == Outcome::done);
}

TEST_CASE("words are recognised") {
  Room room;
  const std::string four = to_text(room.run("identify((UCP)*)"));
  CHECK(four.find("four_point(1/16)") != std::string::npos);
  const std::string spline = to_text(room.run("identify((UDDD)*)"));
  CHECK(spline.find("bspline(3)") != std::string::npos);
  CHECK(to_text(room.run("identify((UCP)* where delta = 1/3)")).find("none") == 0);
  CHECK(to_text(room.run("normal_form((UCC)*)")) == "(U D D D D)*");
}

TEST_CASE("pictures and LaTeX are written where they are asked for") {
  Room room;
  (void)room.run(
      "region(c1(four_point(w)), w in 3/16 .. 1/5) |> plot \"region.svg\"\n"
      "basic_function((UCP)*, derivatives = 2) |> plot \"basic.svg\"\n"
      "diagram((UCP)*) |> plot \"mask.svg\"\n"
      "charmap(catmull_clark, N = 5) |> plot \"map.svg\"\n"
      "eigen(catmull_clark, N = 5) |> plot \"eigen.svg\"\n"
      "report((UCP)*) |> save \"word.tex\"\n");
  for (const char* name : {"region.svg", "basic.svg", "mask.svg", "map.svg", "eigen.svg"}) {
    CAPTURE(name);
    CHECK(room.text(name).find("<svg") == 0);
  }
  CHECK(room.text("word.tex").find("\\begin{document}") != std::string::npos);
  if (std::system("command -v pdflatex > /dev/null") == 0) {
    const std::string compile = "cd '" + room.file(".").string() + "' && pdflatex -interaction=batchmode word.tex > /dev/null";
    CHECK(std::system(compile.c_str()) == 0);
  }
}

TEST_SUITE_END();
