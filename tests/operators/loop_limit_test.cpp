// Weights of Loop limits against closed forms, reference values and the limits of the word found numerically.
#include "operators/methods/offset/loop_limit.h"

#include "operators/limit.h"
#include "operators/matrix.h"
#include "tests/operators/offset_golden.h"
#include "tests/oracle/refusal.h"

namespace udcp {
namespace {

using namespace oracle;

/// 24 N/(40 - q), q = (3 + 2 cos(2 pi/N))^2.
template <class S>
S closed_weight(int n) {
  const S root = S(3) + S(2) * cosine<S>(Rational(2) / Rational(n));
  return S(24 * n) / (S(40) - root * root);
}

TEST_SUITE("operators") {
  TEST_CASE("the weight of a vertex in its limit has the closed form for valences 3 to 50") {
    for (int n = 3; n <= 50; ++n) {
      CAPTURE(n);
      CHECK(loop_weight<double>(n) == doctest::Approx(closed_weight<double>(n)).epsilon(1e-14));
      const Interval difference = loop_weight<Interval>(n) - closed_weight<Interval>(n);
      CHECK(difference.contains_zero());
      CHECK(difference.width() < 1e-30);
    }
    for (const int n : {3, 4, 6}) CHECK(loop_weight<Rational>(n) == closed_weight<Rational>(n));
    for (const int n : {5, 7, 8, 12}) CHECK(loop_weight<Algebraic>(n) == closed_weight<Algebraic>(n));
  }

  TEST_CASE("weights of Loop limits agree with the reference table") {
    for (const auto& row : offset_golden()["masks"]) {
      const int n = row["N"].get<int>();
      CAPTURE(n);
      const double w = loop_weight<double>(n);
      CHECK(std::abs(w - decimal(row["w"])) <= 1e-14 * w);
      CHECK(std::abs(w / (w + n) - decimal(row["centre"])) <= 1e-14);
      CHECK(std::abs(1 / (w + n) - decimal(row["neighbour"])) <= 1e-14);
      CHECK(std::abs(3 / (8 * w) - decimal(row["beta"])) <= 1e-14);
      CHECK(std::abs((w - n / 2.0) / (w + n) - decimal(row["lambda_min_bound"])) <= 1e-14);
    }
    for (const auto& [valence, row] : offset_golden()["masks_exact"].items()) {
      const int n = std::stoi(valence);
      const Rational w = loop_weight<Rational>(n);
      CHECK(w == Rational::parse(row["w"].get<std::string>()));
      CHECK(w / (w + Rational(n)) == Rational::parse(row["centre"].get<std::string>()));
    }
    CHECK(loop_boundary_weights<Rational>().centre == Rational(2) / Rational(3));
    CHECK(loop_boundary_weights<Rational>().end == Rational(1) / Rational(6));
  }

  TEST_CASE("tangents across smooth boundaries agree with the closed form") {
    for (const auto& row : offset_golden()["boundary_tangent"]) {
      const int k = row["K"].get<int>();
      CAPTURE(k);
      const std::vector<double> weights = loop_boundary_tangent<double>(k);
      REQUIRE(weights.size() == row["across"].size());
      for (std::size_t i = 0; i < weights.size(); ++i) CHECK(std::abs(weights[i] - decimal(row["across"][i])) <= 1e-14);
    }
    const std::vector<Rational> three = loop_boundary_tangent<Rational>(3);
    CHECK(three == std::vector<Rational>{Rational(-1), Rational(0), Rational(1), Rational(0)});
  }

  TEST_CASE("limits at vertices agree with those of the word found from its eigenvectors") {
    for (int n = 3; n <= 50; ++n) {
      Surface<double> fan = ring_mesh(n, 2, true);
      for (Eigen::Index v = 0; v < fan.points.rows(); ++v)  // some height
        fan.points(v, 2) = std::sin(1.7 * static_cast<double>(v)) / 4;
      const LoopLimit<double> limit_of = loop_limit(fan);
      INFO(n);
      const Limit found = limit(schemes::loop(), fan);
      CAPTURE(n);
      CHECK(largest_difference(limit_of.points(fan.points).row(0), found.points.row(0)) <= 1e-12);
      CHECK(largest_difference(normals_of<double>(limit_of.tangents(fan.points).row(0)), found.normals.row(0)) <= 1e-9);
    }
  }

  TEST_CASE("limits on boundaries agree with those of the word found from its eigenvectors") {
    for (const char* name : {"cap.obj", "cap_corners.obj", "strip9.obj", "openfan5.obj"}) {
      const Surface<double> mesh = offset_mesh(name);
      const LoopLimit<double> limit_of = loop_limit(mesh);
      const Limit found = limit(schemes::loop(), mesh);
      CAPTURE(name);
      CHECK(largest_difference(limit_of.points(mesh.points), found.points) <= 1e-12);
      CHECK(largest_difference(limit_normals(limit_of, mesh.points), found.normals) <= 1e-9);
    }
  }

  TEST_CASE("limit points and normals agree with the reference values") {
    for (const auto& test : offset_golden()["cases"]) {
      CAPTURE(test["mesh"].get<std::string>());
      CAPTURE(test["refine"].get<int>());
      const Surface<double> mesh = case_mesh(test);
      CHECK(mesh.mesh->vertices() == test["vertices"].get<int>());
      CHECK(mesh.mesh->faces() == test["faces"].get<int>());
      const LoopLimit<double> limit_of = loop_limit(mesh);
      const Points<double> points = decimal_rows(test["limit_points"]), normals = decimal_rows(test["normals"]);
      const std::vector<int> which = reference_vertices(test);
      CHECK(largest_difference(rows_at(limit_of.points(mesh.points), which, points.rows()), points) <= 1e-13);
      CHECK(largest_difference(rows_at(limit_normals(limit_of, mesh.points), which, normals.rows()), normals) <= 1e-13);
    }
  }

  TEST_CASE("a normal does not depend on where the ring starts and turns with the faces") {
    const Surface<double> mesh = offset_mesh("spot188.obj");
    std::vector<std::vector<int>> turned, reversed;
    for (int f = 0; f < mesh.mesh->faces(); ++f) {
      const auto c = mesh.mesh->corners(f);
      turned.push_back({c[1], c[2], c[0]});
      reversed.push_back({c[2], c[1], c[0]});
    }
    const auto normals = [&](const std::vector<std::vector<int>>& faces) {
      const Surface<double> other{std::make_shared<const Mesh>(make_mesh(mesh.mesh->vertices(), faces)), mesh.points, {}, {}};
      return limit_normals(loop_limit(other), other.points);
    };
    const Points<double> normal = limit_normals(loop_limit(mesh), mesh.points);
    CHECK(largest_difference(normals(turned), normal) <= 1e-13);
    CHECK(largest_difference(normals(reversed), -normal) <= 1e-13);
  }

  TEST_CASE("meshes that Loop surfaces cannot have are refused as specified") {
    const std::map<std::string, std::string> codes{
        {"EmptyMesh", "E_NO_FACES"},         {"NotTriangle", "E_NOT_TRIANGLES"},
        {"IndexOutOfRange", "E_INDEX"},      {"DegenerateFace", "E_FACE_REPEATS"},
        {"NonManifoldEdge", "E_EDGE_FACES"}, {"InconsistentOrientation", "E_ORIENTATION"},
        {"IsolatedVertex", "E_ISOLATED"},    {"NonManifoldVertex", "E_VERTEX_FANS"},
        {"ValenceTooLow", "E_VALENCE2"},     {"CornerNotOnBoundary", "E_CORNER_INSIDE"},
        {"ZeroNormal", "E_ZERO_NORMAL"},     {"BoundaryValenceTooHigh", "E_BOUNDARY_VALENCE"}};
    int moebius = 0;
    for (const auto& test : offset_golden()["invalid"]) {
      CAPTURE(test["code"].get<std::string>());
      const std::string text = refusal([&] {
        Surface<double> surface;
        surface.points = test["vertices"].empty() ? Points<double>(0, 3) : decimal_rows(test["vertices"]);
        surface.mesh = std::make_shared<const Mesh>(
            make_mesh(static_cast<int>(surface.points.rows()), test["faces"].get<std::vector<std::vector<int>>>()));
        for (const auto& v : test["corners"]) {
          surface.tags.corner.resize(static_cast<std::size_t>(surface.points.rows()), 0);
          surface.tags.corner[v.get<std::size_t>()] = 1;
        }
        validate_control_mesh(surface);
        limit_normals(loop_limit(surface), surface.points);
      });
      const std::string code = text.substr(0, text.find(':'));
      if (code == "E_NOT_ORIENTABLE") {
        ++moebius;
        CHECK(test["code"] == "InconsistentOrientation");
      } else {
        CHECK(code == codes.at(test["code"].get<std::string>()));
      }
    }
    CHECK(moebius == 1);
  }

  TEST_CASE("what is wrong with a control mesh is named") {
    Surface<double> mesh = offset_mesh("octa.obj");
    mesh.points(3, 1) = std::nan("");
    CHECK(refusal([&] { validate_control_mesh(mesh); }) == "E_NOT_FINITE: a coordinate of vertex 3 is not finite");
    mesh.points = mesh.points.leftCols(2).eval();
    CHECK(refusal([&] { validate_control_mesh(mesh); }) ==
          "E_DIMENSION: the points have 2 coordinates; surfaces here have three");
    CHECK(refusal([] { loop_weight<double>(2); }) ==
          "E_VALENCE2: interior vertices of Loop surfaces have valence 3 or more, not 2");
    CHECK(refusal([] { loop_weight<Rational>(5); }).substr(0, 11) == "E_NOT_EXACT");
    CHECK(refusal([] { loop_boundary_tangent<double>(1); }) ==
          "E_BOUNDARY_VALENCE: a boundary vertex has two or more neighbours, not 1");
    CHECK(refusal([] {
            validate_loop_mesh(make_mesh(4, {{0, 1, 2, 3}}), {});
          }) == "E_NOT_TRIANGLES: face 0 has 4 corners; Loop surfaces need a mesh of triangles");
  }
}

}  // namespace
}  // namespace udcp
