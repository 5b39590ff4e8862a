// The reference values of the operators, all of them through the language: words, bindings and points as text, exact and in
// double.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "grammar/parse.h"
#include "interpreter/evaluate.h"
#include "interpreter/session.h"

namespace {

using namespace udcp;

const Json& golden() {
  static const Json data = [] {
    std::ifstream in(std::string(UDCP_TEST_DATA) + "/operators.json");
    REQUIRE(in);
    return Json::parse(in);
  }();
  return data;
}

std::string list_of(const Json& rows, bool texts) {
  std::string text = "[";
  for (const Json& row : rows) {
    text += text.size() > 1 ? ", " : "";
    if (row.is_array())
      text += list_of(row, texts);
    else
      text += row.is_string() ? row.get<std::string>() : row.dump();
  }
  return text + "]";
}

/// A word with every binding written out: a missing f is 1, a missing omega or delta is 0 in the reference data.
std::string word_text(const Json& test) {
  const Json& params = test["params"];
  std::string text = test["program"].get<std::string>();
  const bool pushes = text.find('P') != std::string::npos, smooths = text.find_first_of("CD") != std::string::npos;
  std::vector<std::string> bindings;
  for (const auto& [name, value] : params.items()) {
    const std::string v = value.get<std::string>();
    if (name == "on")
      text += " on " + v;
    else
      bindings.push_back(name + " = " + v);
  }
  if (pushes && !params.contains("omega")) bindings.emplace_back("omega = 0");
  if (pushes && !params.contains("delta")) bindings.emplace_back("delta = 0");
  if (smooths && !params.contains("f")) bindings.emplace_back("f = 1");
  for (std::size_t i = 0; i < bindings.size(); ++i) text += (i ? ", " : " where ") + bindings[i];
  return text;
}

std::string program_text(const Json& test, bool exact) {
  const bool mesh = test["kind"] == "mesh";
  std::string text = "w = " + word_text(test) + "\n";
  text += "s = " + std::string(mesh ? "mesh(" : "curve(") + list_of(test["points"], true);
  if (mesh)
    text += ", " + list_of(test["faces"], false);
  else
    text += ", closed = " + std::string(test["closed"].get<bool>() ? "yes" : "no");
  text += ", exact = " + std::string(exact ? "yes" : "no") + ")\n";
  if (test.contains("corners")) text += "s = s |> tag(corner, " + list_of(test["corners"], false) + ")\n";
  if (test.contains("tags")) {
    for (const char* tag : {"lat", "lon"}) {
      Json edges = Json::array();
      for (const Json& t : test["tags"])
        if (t[2] == tag) edges.push_back(Json::array({t[0], t[1]}));
      if (!edges.empty()) text += "s = s |> tag(" + std::string(tag) + ", " + list_of(edges, false) + ")\n";
    }
  }
  if (test.contains("attrs"))
    for (const auto& [name, values] : test["attrs"].items())
      text += "s = s |> attribute(\"" + name + "\", " + list_of(values, true) + ")\n";
  const bool star = test["program"].get<std::string>().find('*') != std::string::npos;
  return text + (star ? "s |> w^" + std::to_string(test["rounds"].get<int>()) : "s |> w") + "\n";
}

double value_of(const Json& number) {
  return number.is_string() ? Rational::parse(number.get<std::string>()).to_double() : number.get<double>();
}

void check_number(const Algebraic& value, const Json& expected, double size) {
  if (expected.is_string())
    CHECK(value == Algebraic(Rational::parse(expected.get<std::string>())));
  else
    CHECK(std::abs(value.to_double() - expected.get<double>()) <= 1e-12 * size);
}
void check_number(double value, const Json& expected, double size) {
  CHECK(std::abs(value - value_of(expected)) <= 1e-12 * size);
}

template <class S>
void check_points(const Points<S>& points, const Json& expect) {
  if (expect.contains("n_points")) CHECK(points.rows() == expect["n_points"].get<int>());
  if (expect.contains("points")) {
    REQUIRE(points.rows() == static_cast<Eigen::Index>(expect["points"].size()));
    double size = 1;
    for (const Json& row : expect["points"])
      for (const Json& c : row) size = std::max(size, std::abs(value_of(c)));
    for (Eigen::Index i = 0; i < points.rows(); ++i)
      for (Eigen::Index c = 0; c < points.cols(); ++c)
        check_number(points(i, c), expect["points"][static_cast<std::size_t>(i)][static_cast<std::size_t>(c)], size);
  }
  if (!expect.contains("weighted_sum")) return;
  for (Eigen::Index c = 0; c < points.cols(); ++c) {
    S sum(0);
    double size = 1;
    for (Eigen::Index i = 0; i < points.rows(); ++i) {
      const S term = S(static_cast<int>(i) + 1) * points(i, c);
      sum += term;
      size += std::abs(approximate(term));
    }
    check_number(sum, expect["weighted_sum"][static_cast<std::size_t>(c)], size);
  }
}

void check_faces(const Mesh& mesh, const Json& expect) {
  if (expect.contains("n_faces")) CHECK(mesh.faces() == expect["n_faces"].get<int>());
  if (expect.contains("face_sum")) {
    std::int64_t sum = 0;
    for (int f = 0; f < mesh.faces(); ++f)
      for (int j = 0; j < mesh.size(f); ++j) sum += std::int64_t{f + 1} * (j + 1) * mesh.corners(f)[static_cast<std::size_t>(j)];
    CHECK(sum == expect["face_sum"].get<std::int64_t>());
  }
  if (!expect.contains("faces")) return;
  Json faces = Json::array();
  for (int f = 0; f < mesh.faces(); ++f) faces.push_back(std::vector<int>(mesh.corners(f).begin(), mesh.corners(f).end()));
  CHECK(faces == expect["faces"]);
}

template <class S>
void check_tags(const Surface<S>& s, const Json& expect) {
  const Mesh& mesh = *s.mesh;
  std::vector<std::tuple<int, int, std::string>> tags;
  double ring_error = 0;
  for (int e = 0; e < mesh.edges(); ++e) {
    const EdgeTag tag = s.tags.of_edge(e);
    if (tag == EdgeTag::none) continue;
    const int h = mesh.edge_half[Mesh::i(e)];
    const int a = mesh.vertex[Mesh::i(h)], b = mesh.tip(h);
    tags.emplace_back(std::min(a, b), std::max(a, b), tag == EdgeTag::latitude ? "lat" : "lon");
    if (tag != EdgeTag::latitude || !expect.contains("ring_error")) continue;
    const auto at = [&](int v, int c) { return approximate(s.points(v, c)); };
    ring_error = std::max(
        {ring_error, std::abs(at(a, 2) - at(b, 2)), std::abs(std::hypot(at(a, 0), at(a, 1)) - std::hypot(at(b, 0), at(b, 1)))});
  }
  if (expect.contains("ring_error")) CHECK(ring_error <= expect["tolerance"].get<double>());
  if (!expect.contains("tags")) return;
  std::sort(tags.begin(), tags.end());
  std::vector<std::tuple<int, int, std::string>> expected;
  for (const Json& t : expect["tags"]) expected.emplace_back(t[0].get<int>(), t[1].get<int>(), t[2].get<std::string>());
  std::sort(expected.begin(), expected.end());
  CHECK(tags == expected);
}

template <class S>
void check_result(const Value& value, const Json& expect) {
  if (const auto* curve = value.as<CurveValue>()) return check_points(std::get<Polyline<S>>(curve->shape).points, expect);
  const auto* mesh = value.as<MeshValue>();
  REQUIRE(mesh);
  const auto& surface = std::get<Surface<S>>(mesh->shape);
  check_points(surface.points, expect);
  check_faces(*surface.mesh, expect);
  check_tags(surface, expect);
}

/// False if the case has no exact values (a cosine of an angle that is no multiple of pi, or a field that is too large).
bool run_case(const Json& test, bool exact) {
  Session session;
  const std::string text = program_text(test, exact);
  CAPTURE(text);
  const bool fails = test["expect"].contains("error");
  try {
    const Value value = session.run(text);
    CHECK_FALSE(fails);
    if (exact)
      check_result<Algebraic>(value, test["expect"]);
    else
      check_result<double>(value, test["expect"]);
  } catch (const ProgramError& error) {
    if (exact && !fails && (error.kind == ErrorKind::not_exact || error.code == "E_FIELD_DEGREE")) return false;
    CAPTURE(std::string(error.what()));
    REQUIRE(fails);
    CHECK(error.code == test["expect"]["error"].get<std::string>());
  }
  return true;
}

}  // namespace

TEST_SUITE("interpreter") {
  TEST_CASE("the reference cases of the operators hold in double") {
    REQUIRE(golden()["cases"].size() == 45);
    for (const Json& test : golden()["cases"]) {
      const std::string id = test["id"];
      CAPTURE(id);
      CHECK(run_case(test, false));
    }
  }

  TEST_CASE("the reference cases of the operators hold exactly") {
    std::vector<std::string> without;
    for (const Json& test : golden()["cases"]) {
      const std::string id = test["id"];
      CAPTURE(id);
      if (!run_case(test, true)) without.push_back(id);
    }
    // alpha0 = 20 is no multiple of pi: cos(10) has no exact value.
    CHECK(without == std::vector<std::string>{"table 1 row d"});
  }

  TEST_CASE("the reference expressions have their values") {
    for (const Json& test : golden()["expressions"]) {
      const std::string text = test["expr"];
      CAPTURE(text);
      Context<Algebraic> context;
      if (test["env"].contains("N")) context.valence = std::stoi(test["env"]["N"].get<std::string>());
      const Environment nothing;
      std::string error;
      Quantity<Algebraic> value;
      try {
        if (test["env"].contains("alpha"))
          context.alpha = evaluate(*grammar::parse_expression(test["env"]["alpha"].get<std::string>()), context, nothing);
        value = evaluate(*grammar::parse_expression(text), context, nothing);
      } catch (const Error& e) {
        error = e.code;
      } catch (const grammar::SyntaxError& e) {
        error = e.code;
      }
      CHECK(error == test.value("error", ""));
      if (test.contains("error")) continue;
      if (test["kind"] == "rational") {
        CHECK(value.kind() == Quantity<Algebraic>::Kind::rational);
        CHECK(value.exact() == Rational::parse(test["value"].get<std::string>()));
      } else if (test["kind"] == "pi") {
        CHECK(value.kind() == Quantity<Algebraic>::Kind::pi_multiple);
        CHECK(value.exact().to_string() + "*pi" == test["value"].get<std::string>());
      } else {
        CHECK(value.value().to_double() == doctest::Approx(test["value"].get<double>()).epsilon(1e-15));
      }
    }
  }

  TEST_CASE("the reference words have their atoms or their errors") {
    for (const Json& test : golden()["programs"]) {
      const std::string text = test["program"];
      CAPTURE(text);
      Session session;
      std::string code, found;
      try {
        const Value value = session.run(text);
        if (const auto* word = value.as<WordValue>()) found = atoms(word->word, test["rounds"].get<int>());
      } catch (const ProgramError& error) {
        code = error.code;
      }
      if (test.contains("error")) {
        // An empty program is a program; U[1] is refused when its number is known, under its own code.
        if (text.empty())
          CHECK(found.empty());
        else if (text == "U[1]C")
          CHECK((code == "E_SYNTAX" || code == "E_SECTIONS"));
        else
          CHECK(code == test["error"].get<std::string>());
        continue;
      }
      std::string expected;
      for (const Json& round : test["atoms"]) expected += (expected.empty() ? "" : " ") + round.get<std::string>();
      CHECK(found == expected);
    }
  }

  TEST_CASE("circles have the radii of Theorem 1") {
    for (const Json& test : golden()["circle"]) {
      const int corners = test["K"], k = test["k"];
      const std::string delta = test["delta"];
      const auto radius = [&](int rounds) {
        Session session;
        const Value value = session.run("w = (U C^" + std::to_string(k) +
                                        " P)* where f(alpha) = cos(alpha/2), omega(alpha) = 1/cos(alpha/2), delta = " + delta +
                                        ", alpha0 = 2*pi/" + std::to_string(corners) + "\npolygon(" + std::to_string(corners) +
                                        ") |> w^" + std::to_string(rounds));
        const auto& points = std::get<Polyline<double>>(value.as<CurveValue>()->shape).points;
        for (Eigen::Index i = 0; i < points.rows(); ++i) CHECK(std::abs(points.row(i).norm() - points.row(0).norm()) <= 1e-13);
        return points.row(0).norm();
      };
      CAPTURE(test.dump());
      CHECK(std::abs(radius(3) - test["radius_after_3"].get<double>()) <= 1e-13);
      // The radius converges like 1/4^n, and 13 rounds leave less than 1e-7.
      CHECK(std::abs(radius(13) - test["limit_radius"].get<double>()) <= 1e-7);
    }
  }
}
