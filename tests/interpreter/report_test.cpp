// Values as text and JSON. Expected digits are the published expansions of sqrt(2), sqrt(5) and pi.
#include "interpreter/report.h"

#include <doctest/doctest.h>

#include "interpreter/report_parts.h"
#include "operators/shapes.h"

using namespace udcp;

namespace {

Value exact(const Quantity<Algebraic>& number) { return Value{NumberValue{number}}; }
Value exact(const Algebraic& number) { return exact(Quantity<Algebraic>::of(number)); }
Value exact(const Rational& number) { return exact(Quantity<Algebraic>(number)); }
Value measured(double number) { return Value{NumberValue{number}}; }
Algebraic root(int radicand) { return sqrt(Algebraic(radicand)); }
Rational fraction(int p, int q) { return Rational(p) / Rational(q); }

/// lo and hi of a JSON enclosure as exact numbers.
std::pair<Rational, Rational> bounds(const Json& json) {
  return {Rational::parse(json["lo"].get<std::string>()), Rational::parse(json["hi"].get<std::string>())};
}

ProgramError dual_error() {
  ProgramError error("P needs the points to correspond to the vertices before U, but here they are dual");
  error.kind = ErrorKind::word;
  error.code = "E_P_DUAL";
  error.file = "tour.udcp";
  error.source = "# words\n\n(UDP)*\n";
  error.span = {12, 13};
  error.label = "one D since the last U; P needs an even number";
  error.help = "write (UDDP)* or (UCP)*";
  return error;
}

}  // namespace

TEST_SUITE("interpreter") {
  TEST_CASE("fractions and integers print without decimals") {
    CHECK(to_text(exact(Rational(7))) == "7");
    CHECK(to_text(exact(fraction(-1, 16))) == "-1/16");
    CHECK(to_text(exact(Algebraic(fraction(2, 3)))) == "2/3");
  }

  TEST_CASE("a fraction too long to be read is followed by its size") {
    const Rational third = (pow(Rational(10), 30) + Rational(1)) / (pow(Rational(10), 30) * Rational(3));
    const std::string text = to_text(exact(third));
    CHECK(text.ends_with("  (= 0.333333333333…)"));
    CHECK(text.starts_with(third.to_string()));
  }

  TEST_CASE("irrational numbers print exactly and then cut off") {
    const Algebraic number = Algebraic(fraction(-17, 48)) + Algebraic(fraction(5, 48)) * root(5);
    // 5 * 2.2360679774997896964... / 48 - 17/48
    CHECK(to_text(exact(number)) == number.to_string() + "  (= -0.121242919010…)");
    CHECK(to_text(exact(root(2))).ends_with("  (= 1.41421356237…)"));
    CHECK(to_text(exact(-root(2))).ends_with("  (= -1.41421356237…)"));
  }

  TEST_CASE("decimals are right where doubles would have lost every digit") {
    // sqrt(2) = 1.4142135623730950488016887242096980785...
    const Rational near = Rational::parse("1.414213562373095048");
    CHECK(decimals(Quantity<Algebraic>::of(root(2) - Algebraic(near)), 12) == "8.01688724209…e-19");
    CHECK(decimals(Quantity<Algebraic>::of(root(2) * Algebraic(pow(Rational(10), 40))), 12) == "1.41421356237…e40");
    CHECK(decimals(Quantity<Algebraic>::of(root(2) * Algebraic(1000)), 6) == "1414.21…");
    CHECK(decimals(Quantity<Algebraic>::of(root(2)), 30) == "1.41421356237309504880168872420…");
  }

  TEST_CASE("the decimals of fractions end where the fraction does") {
    CHECK(decimals(fraction(1, 4), 12) == "0.25");
    CHECK(decimals(fraction(-1, 3), 5) == "-0.33333…");
    CHECK(decimals(Rational(120), 12) == "120");
    CHECK(decimals(Rational(0), 12) == "0");
    CHECK(decimals(Rational(1234567), 4) == "1.234…e6");
  }

  TEST_CASE("multiples of pi keep their name") {
    CHECK(exact_text(Quantity<Algebraic>::pi(fraction(2, 5))) == "2*pi/5");
    CHECK(exact_text(Quantity<Algebraic>::pi(Rational(1))) == "pi");
    CHECK(exact_text(Quantity<Algebraic>::pi(fraction(-1, 3))) == "-pi/3");
    CHECK(exact_text(Quantity<Algebraic>::pi(Rational(-4))) == "-4*pi");
    // 2 pi / 5 = 1.2566370614359172953...
    CHECK(to_text(exact(Quantity<Algebraic>::pi(fraction(2, 5)))) == "2*pi/5  (= 1.25663706143…)");
  }

  TEST_CASE("doubles have 12 digits in text and a sign that they are not exact") {
    CHECK(to_text(measured(0.1)) == "≈ 0.1");
    CHECK(to_text(measured(1.0 / 3)) == "≈ 0.333333333333");
    CHECK(to_text(measured(-0.0)) == "≈ 0");
    CHECK(to_text(measured(1e-20)) == "≈ 1e-20");
    CHECK(to_json(measured(0.1)).dump() == R"({"kind":"number","value":0.1})");
    CHECK(to_json(measured(1.0 / 3)).dump() == R"({"kind":"number","value":0.3333333333333333})");
  }

  TEST_CASE("enclosures print as intervals that contain the number") {
    const Interval third(fraction(1, 3));
    CHECK(to_text(Value{NumberValue{third}}).starts_with("[0.33333333333"));
    const Json json = to_json(Value{NumberValue{third}});
    CHECK(json["kind"] == "number");
    const auto [lo, hi] = bounds(json["value"]);
    CHECK(lo < fraction(1, 3));
    CHECK(fraction(1, 3) < hi);
    CHECK(hi - lo < pow(Rational(2), -120));
  }

  TEST_CASE("JSON of exact numbers is exact") {
    CHECK(to_json(exact(fraction(-3, 4))).dump() == R"({"kind":"number","value":"-3/4"})");
    CHECK(to_json(exact(Rational(5))).dump() == R"({"kind":"number","value":"5"})");
    const Json json = to_json(exact(root(5)))["value"];
    CHECK(json["exact"] == root(5).to_string());
    const auto [lo, hi] = bounds(json);
    CHECK(lo * lo < Rational(5));
    CHECK(Rational(5) < hi * hi);
  }

  TEST_CASE("lists nest and quote their texts") {
    const Value list{ListValue{{exact(fraction(1, 2)), Value{TextValue{"a"}}, Value{ListValue{{Value{Boolean{true}}}}}}}};
    CHECK(to_text(list) == "[1/2, \"a\", [true]]");
    CHECK(to_json(list).dump() == R"({"kind":"list","value":["1/2","a",[true]]})");
    CHECK(to_text(Value{ListValue{{measured(0.5), measured(2)}}}) == "≈ [0.5, 2]");
    CHECK(to_text(Value{ListValue{}}) == "[]");
  }

  TEST_CASE("a text prints without quotes and a report prints its text") {
    CHECK(to_text(Value{TextValue{"a \"b\""}}) == "a \"b\"");
    const Value report{ReportValue{"three lines", Json{{"lines", 3}}, {}}};
    CHECK(to_text(report) == "three lines");
    CHECK(to_json(report).dump() == R"({"kind":"report","value":{"lines":3}})");
  }

  TEST_CASE("matrices align their columns") {
    Points<Algebraic> entries(2, 2);
    entries << Algebraic(1), Algebraic(fraction(-3, 8)), Algebraic(0), Algebraic(fraction(1, 2));
    CHECK(to_text(Value{MatrixValue{entries}}) == "2 x 2 matrix\n[ 1  -3/8 ]\n[ 0   1/2 ]");
    CHECK(to_json(Value{MatrixValue{entries}}).dump() ==
          R"({"kind":"matrix","value":{"rows":2,"cols":2,"entries":[["1","-3/8"],["0","1/2"]]}})");
  }

  TEST_CASE("a large matrix is shown in part and says so") {
    const Points<double> entries = Points<double>::Identity(100, 100);
    const std::string text = to_text(Value{MatrixValue{entries}});
    CHECK(text.starts_with("100 x 100 matrix, double\n"));
    CHECK(text.ends_with("… shown in part; |> save \"matrix.mtx\" writes all of it"));
    CHECK(to_json(Value{MatrixValue{entries}})["value"]["entries"].size() == 100);
  }

  TEST_CASE("curves print a summary and keep their points in JSON") {
    Polyline<Algebraic> square;
    square.points.resize(4, 2);
    square.points << Algebraic(0), Algebraic(0), Algebraic(2), Algebraic(0), Algebraic(2), Algebraic(fraction(1, 2)),
        Algebraic(0), Algebraic(fraction(1, 2));
    square.corner = {0, 1, 0, 0};
    const Value curve{CurveValue{square}};
    CHECK(to_text(curve) == "closed curve: 4 points in 2 dimensions, exact, 1 corner, box ≈ [0, 2] x [0, 0.5]");
    const Json json = to_json(curve);
    CHECK(json["kind"] == "curve");
    CHECK(json["value"]["points"].dump() == R"([["0","0"],["2","0"],["2","1/2"],["0","1/2"]])");
    CHECK(json["value"]["corners"].dump() == "[1]");
    CHECK(json["value"]["box"].dump() == R"({"min":[0.0,0.0],"max":[2.0,0.5]})");
  }

  TEST_CASE("meshes print counts and keep their points in JSON while they are small") {
    Surface<double> tetrahedron;
    tetrahedron.mesh = std::make_shared<const Mesh>(make_mesh(4, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}));
    tetrahedron.points.resize(4, 3);
    tetrahedron.points << 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1;
    const Value mesh{MeshValue{tetrahedron, "", nullptr}};
    CHECK(to_text(mesh) ==
          "mesh: 4 vertices, 6 edges, 4 faces (triangles), closed in 3 dimensions, double, box ≈ [0, 1] x [0, 1] x [0, 1]");
    const Json json = to_json(mesh)["value"];
    CHECK(json["polygons"].dump() == "[[0,2,1],[0,1,3],[1,2,3],[2,0,3]]");
    CHECK(json["points"].size() == 4);
    CHECK_FALSE(mesh_json(*mesh.as<MeshValue>(), 4).contains("points"));
    CHECK(mesh_json(*mesh.as<MeshValue>(), 4)["vertices"] == 4);
  }

  TEST_CASE("a word prints its text and lists bindings and defaults in JSON") {
    const Value word{WordValue{{}, "(UCP)* where omega = 1/2, f(alpha) = cos(alpha/2)", {"delta = 1"}, {}}};
    CHECK(to_text(word) == "(UCP)* where omega = 1/2, f(alpha) = cos(alpha/2)");
    const Json json = to_json(word);
    CHECK(json["kind"] == "word");
    CHECK(json["value"] == "(UCP)* where omega = 1/2, f(alpha) = cos(alpha/2)");
    CHECK(json["bindings"].size() == 2);
    CHECK(json["bindings"][0] == "omega = 1/2");
    CHECK(json["defaults"].dump() == R"(["delta = 1"])");
  }

  TEST_CASE("an error shows its place with a caret and what to do") {
    CHECK(to_text(dual_error(), false) ==
          "error[W03]: P needs the points to correspond to the vertices before U, but here they are dual\n"
          "  --> tour.udcp:3:4\n"
          " 3 | (UDP)*\n"
          "   |    ^ one D since the last U; P needs an even number\n"
          "help: write (UDDP)* or (UCP)*");
  }

  TEST_CASE("colour is used only when asked for") {
    CHECK(to_text(dual_error(), false).find('\033') == std::string::npos);
    const std::string coloured = to_text(dual_error(), true);
    CHECK(coloured.starts_with("\033[1;31merror[W03]\033[0m"));
    CHECK(coloured.find("\033[1;36mhelp:\033[0m") != std::string::npos);
  }

  TEST_CASE("an error as JSON has place and code") {
    const Json json = to_json(dual_error());
    CHECK(json["kind"] == "error");
    CHECK(json["code"] == "W03");
    CHECK(json["symbol"] == "E_P_DUAL");
    CHECK(json["file"] == "tour.udcp");
    CHECK(json["line"] == 3);
    CHECK(json["column"] == 4);
    CHECK(json["help"] == "write (UDDP)* or (UCP)*");
  }

  TEST_CASE("an error without program text has no place") {
    const ProgramError error = make_error(ErrorKind::file, "E_FILE_OPEN", "'a.obj' cannot be opened", "");
    CHECK(to_text(error, false) == "error[F01]: 'a.obj' cannot be opened");
    CHECK(to_json(error)["line"].is_null());
    CHECK(to_json(error)["help"].is_null());
  }

  TEST_CASE("a code that the table lacks is shown with its symbol") {
    const ProgramError error = make_error(ErrorKind::input,
                                          "E_"
                                          "NEW_IN_TEST",
                                          "something", "");
    CHECK(to_text(error, false) ==
          "error[X02]: something (E_"
          "NEW_IN_TEST)");
  }

  TEST_CASE("warnings look like errors") {
    CHECK(warning_text("f is unused", false) == "warning: f is unused");
    CHECK(warning_json("f is unused").dump() == R"({"kind":"warning","message":"f is unused"})");
  }

  TEST_CASE("kinds of errors and outcomes have the documented exit codes") {
    CHECK(exit_code(ErrorKind::input) == 2);
    CHECK(exit_code(ErrorKind::word) == 2);
    CHECK(exit_code(ErrorKind::not_exact) == 2);
    CHECK(exit_code(ErrorKind::limit) == 4);
    CHECK(exit_code(ErrorKind::file) == 5);
    CHECK(exit_code(ErrorKind::interrupted) == 130);
    CHECK(exit_code(ErrorKind::internal) == 70);
    CHECK(exit_code(Outcome::done) == 0);
    CHECK(exit_code(Outcome::refuted) == 1);
    CHECK(exit_code(Outcome::undecided) == 3);
  }

  TEST_CASE("lost memory is a limit and an unknown exception an internal error") {
    const auto converted = [](const auto& thrown) {
      try {
        throw thrown;
      } catch (...) {
        return current_error();
      }
    };
    CHECK(converted(std::bad_alloc()).kind == ErrorKind::limit);
    CHECK(converted(std::logic_error("x")).kind == ErrorKind::internal);
    CHECK(converted(17).code == "E_INTERNAL");
    CHECK(converted(Error(ErrorKind::file, "E_FILE_OPEN", "x", "y")).help == "y");
  }
}
