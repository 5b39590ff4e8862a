// Builtins: arguments, shapes, matrices, limits, counts.
#include <doctest/doctest.h>

#include <set>

#include "interpreter/builtins.h"
#include "interpreter/report.h"
#include "interpreter/session.h"
#include "operators/matrix.h"

namespace {

using namespace udcp;

Value value(const std::string& text) {
  Session session;
  session.load_prelude();
  return session.run(text);
}

std::string text(const std::string& program) { return to_text(value(program)); }

ProgramError error_of(const std::string& program) {
  try {
    value(program);
  } catch (const ProgramError& error) {
    return error;
  }
  return ProgramError("no error");
}

bool holds(const std::string& condition) {
  const Value result = value(condition);
  REQUIRE(result.as<Boolean>());
  return result.as<Boolean>()->value;
}

}  // namespace

TEST_SUITE("interpreter") {
  TEST_CASE("the table of builtins is sorted and complete in itself") {
    std::string before;
    for (const Builtin& b : builtins()) {
      CAPTURE(b.name);
      CHECK(std::string(b.name) > before);
      before = b.name;
      CHECK((b.call != nullptr || b.special != nullptr));
      CHECK_FALSE(b.help.empty());
      CHECK(b.signature.starts_with(b.name));
      CHECK(b.least <= b.most);
      CHECK(find_builtin(b.name) == &b);
    }
    CHECK(find_builtin("nothing") == nullptr);
  }

  TEST_CASE("wrong arguments are named with the signature") {
    const ProgramError few = error_of("polygon()");
    CHECK(few.code == "E_ARGUMENTS");
    CHECK(few.help == "write polygon(corners, radius = 1, exact = no)");
    CHECK(error_of("polygon(5, 1, 2, 3)").code == "E_ARGUMENTS");
    CHECK(error_of("polygon(5, raduis = 2)").code == "E_ARGUMENTS");
    const ProgramError type = error_of("polygon(\"five\")");
    CHECK(type.code == "E_TYPE");
    CHECK(std::string(type.what()) == "the argument 'corners' must be a whole number, but it is a text");
    CHECK(error_of("polygon(2)").code == "E_TYPE");
    CHECK(error_of("faces(5)").code == "E_TYPE");
    CHECK(error_of("cube").code == "E_TYPE");
    CHECK(error_of("cbue()").help == "did you mean 'cube'?");
  }

  TEST_CASE("exact shapes are exact and others are double") {
    CHECK(holds("sum(points(cube(exact = yes))[0]) == -3"));
    CHECK(error_of("points(cube())[0] == points(cube())[0]").code == "E_NOT_EXACT");
    CHECK(holds("approx(cube(), cube(exact = yes), 0)"));
    CHECK(holds("polygon(5, exact = yes) == rotate(polygon(5, exact = yes), 0)"));
    CHECK(holds("rotate(rotate(polygon(4, exact = yes), pi/2), 3*pi/2) == polygon(4, exact = yes)"));
  }

  TEST_CASE("shapes are built from lists and checked") {
    CHECK(holds("mesh(points(cube(exact = yes)), face_list(cube()), exact = yes) == cube(exact = yes)"));
    CHECK(error_of("curve([[1, 2], [3]])").code == "E_DIMENSION");
    CHECK(error_of("curve([[1, 2]])").code == "E_POINTS");
    CHECK(error_of("mesh([[0, 0, 0]], [[0, 1, 2]])").code == "E_INDEX");
    CHECK(error_of("set max_faces = 10\ngrid(4, 4)").code == "E_MAX_FACES");
    CHECK(error_of("tube(5, [[1, 2, 3]])").code == "E_DIMENSION");
  }

  TEST_CASE("translation and scaling and reversal keep the connectivity") {
    CHECK(holds("bounds(cube(exact = yes) |> scale([1, 2, 3]) |> translate([1, 0, 0])) == [[0, -2, -3], [2, 2, 3]]"));
    CHECK(holds("reverse(reverse(torus(4, 3, 2, 1, exact = yes))) == torus(4, 3, 2, 1, exact = yes)"));
    CHECK(holds("tags(reverse(torus(4, 3, 2, 1))) != []"));
    CHECK(error_of("cube() |> scale([1, 2])").code == "E_DIMENSION");
  }

  TEST_CASE("loops around an axis are the rings of a tube and the crossing edges become the other direction") {
    CHECK(
        holds("tags(untag(tube(6, [[1, 0], [2, 1], [1, 3]])) |> tag(lat, loops(axis = z))) == tags(tube(6, [[1, 0], [2, 1], [1, "
              "3]]))"));
    CHECK(holds("length(tags(cube() |> tag(lat, all))) == 12"));
    CHECK(holds("tags(cube() |> tag(lat, [[0, 1]])) == [[0, 1, \"lat\"]]"));
    CHECK(error_of("cube() |> tag(lat, [[0, 7]])").code == "E_TAGS");
    CHECK(error_of("cube() |> tag(corner, [0])").code == "E_CORNER");
    CHECK(holds("corners(grid(2, 2) |> tag(corner, one_face)) == [0, 2, 6, 8]"));
  }

  TEST_CASE("attributes come from numbers and lists and functions") {
    CHECK(
        holds("m = cube(exact = yes) |> attribute(\"d\", 1/2)\n(m |> (UCP where {delta = v.d})) == (cube(exact = yes) |> (UCP "
              "where {delta = 1/2}))"));
    CHECK(
        holds("g(x, y, z) = x*x/2\nm = cube(exact = yes) |> attribute(\"d\", g)\n(m |> (UCP where {delta = v.d})) == (cube(exact "
              "= yes) |> (UCP where {delta = 1/2}))"));
    CHECK(error_of("cube() |> attribute(\"d\", [1, 2])").code == "E_ATTRIBUTE_SIZE");
    CHECK(error_of("cube() |> attribute(\"a b\", 1)").code == "E_ATTRIBUTE");
  }

  TEST_CASE("masks and stencils and supports are those of the literature") {
    CHECK(holds("mask(cubic) == [1/8, 1/2, 3/4, 1/2, 1/8]"));
    CHECK(holds("mask(chaikin) == [1/4, 3/4, 3/4, 1/4]"));
    CHECK(holds("stencils(cubic) == [[1/8, 3/4, 1/8], [1/2, 1/2]]"));
    CHECK(holds("support(four_point(1/16)) == [-3, 3]"));
    CHECK(holds("sum(mask(quintic)) == 2"));
    // The symbol of the rounds h of U C P with f = cos(alpha/2), omega = 1/f, delta = 1 has w = 1/(8c(1+c)), c = cos(alpha_h/2).
    CHECK(holds("c = cos(pi/5/2)\nmask(circle_through(5), round = 1)[0] == -1/(8*c*(1 + c))"));
    CHECK(error_of("mask(loop)").code == "E_CURVE_WORD");
  }

  TEST_CASE("the matrix at a vertex is that of Catmull-Clark") {
    // Row of the centre: 1 - 7/(4n), then 3/(2n^2) per neighbour and 1/(4n^2) per diagonal; rows sum to 1.
    const Value result = value("matrix(catmull_clark, N = 5)");
    const auto& m = std::get<Points<Algebraic>>(result.as<MatrixValue>()->entries);
    CHECK(m.rows() == 11);
    CHECK(m.cols() == 11);
    CHECK(m(0, 0) == Algebraic(Rational::parse("13/20")));
    Algebraic edge_points(0), diagonals(0);
    for (int j = 1; j < 11; ++j) (m(0, j) == Algebraic(Rational::parse("3/50")) ? edge_points : diagonals) += m(0, j);
    CHECK(edge_points == Algebraic(Rational::parse("3/10")));
    CHECK(diagonals == Algebraic(Rational::parse("1/20")));
    for (int i = 0; i < 11; ++i) {
      Algebraic sum(0);
      for (int j = 0; j < 11; ++j) sum += m(i, j);
      CHECK(sum == Algebraic(1));
    }
    CHECK(error_of("matrix(chaikin, N = 5)").code == "E_MATRIX_DUAL");
    CHECK(error_of("matrix(catmull_clark)").code == "E_ARGUMENTS");
  }

  TEST_CASE("the matrix at a vertex does not change when more rings are taken") {
    const Value small = value("matrix(loop, N = 5)"), large = value("matrix(loop, N = 5, rings = 2)");
    const auto& a = std::get<Points<Algebraic>>(small.as<MatrixValue>()->entries);
    const auto& b = std::get<Points<Algebraic>>(large.as<MatrixValue>()->entries);
    REQUIRE(a.rows() == 6);
    REQUIRE(b.rows() == 16);
    for (int i = 0; i < 6; ++i)
      for (int j = 0; j < 6; ++j) CHECK(a(i, j) == b(i, j));
    CHECK(error_of("matrix((UCP)*, N = 5, rings = 1)").code == "E_MATRIX_RINGS");
  }

  TEST_CASE("the matrix of a curve word is its mask") {
    CHECK(text("matrix(cubic, points = 4)") == text("matrix((UDD)*, points = 4)"));
    const Value result = value("matrix(cubic, points = 5)");
    const auto& m = std::get<Points<Algebraic>>(result.as<MatrixValue>()->entries);
    CHECK(m.rows() == 10);
    CHECK(m(0, 0) == Algebraic(Rational::parse("3/4")));
    CHECK(m(1, 0) == Algebraic(Rational::parse("1/2")));
  }

  TEST_CASE("counts are those of the refined mesh and cost nothing") {
    for (const char* word : {"catmull_clark", "doo_sabin_averaging", "zorin_schroeder"}) {
      CAPTURE(word);
      const std::string w = word;
      CHECK(holds("m = cube() |> " + w + "^3\ncounts(cube() |> " + w + "^3) == [vertices(m), edges(m), faces(m)]"));
    }
    CHECK(holds("counts(polygon(5) |> chaikin^2) == [20]"));
    CHECK(holds("counts(cube()) == [8, 12, 6]"));
    CHECK(holds("(cube() |> counts) == [8, 12, 6]"));
    CHECK(text("counts(cube() |> catmull_clark^20)") == "6597069766658 vertices, 13194139533312 edges, 6597069766656 faces");
    CHECK(error_of("counts(cube() |> catmull_clark)").code == "E_ROUNDS");
    CHECK(error_of("counts(5)").code == "E_TYPE");
  }

  TEST_CASE("limit points of the cube under Catmull-Clark") {
    // The limit stencil (n^2 V + 4 sum of neighbours + sum of diagonals)/(n(n+5)) at a corner of the cube: (9 + 4 - 1)/24 = 1/2.
    CHECK(holds("approx(limit(cube(), catmull_clark), cube() |> scale(1/2), 1/10^12)"));
    CHECK(holds("approx(points(cube() |> limit(catmull_clark)), points(cube() |> scale(1/2)), 1/10^12)"));
    CHECK(holds("approx(limit(polygon(4), cubic), polygon(4) |> scale(2/3), 1/10^12)"));
    CHECK(error_of("limit(cube(), (UCP))").code == "E_NOT_A_SCHEME");
  }
}
