// Self-intersections of offsets: verdicts and counts of the reference, geometry of triangles, prediction from curvature.
#include "operators/methods/offset/self_intersection.h"

#include <Eigen/Geometry>
#include <random>

#include "operators/methods/offset/box_tree.h"
#include "operators/methods/offset/offset.h"
#include "tests/operators/offset_golden.h"
#include "tests/oracle/refusal.h"

namespace udcp {
namespace {

using namespace oracle;
using Vector = Eigen::Vector3d;
using Triangle = std::array<Vector, 3>;

OffsetResult offset_by(const Surface<double>& mesh, double distance) {
  OffsetOptions options;
  options.distance = distance;
  return offset(mesh, options);
}

Vector random_point(std::mt19937& engine) {
  std::uniform_real_distribution<double> unit(-1, 1);
  const double x = unit(engine), y = unit(engine), z = unit(engine);
  return {x, y, z};
}

Triangle random_triangle(std::mt19937& engine) {
  const Vector centre = random_point(engine);
  Triangle t;
  for (Vector& corner : t) corner = centre + 0.7 * random_point(engine);
  return t;
}

TEST_SUITE("operators") {
  TEST_CASE("self-intersections are found as in the reference") {
    for (const auto& test : offset_golden()["self_intersection"]) {
      CAPTURE(test["mesh"].get<std::string>());
      CAPTURE(test["dis"].get<std::string>());
      const OffsetResult result = offset_by(case_mesh(test), decimal(test["dis"]));
      const SelfIntersection found = find_self_intersections(result.base, result.d, test["level"].get<int>());
      CHECK(found.surface.mesh->faces() == test["faces"].get<int>());
      CHECK(name_of(found.verdict) == test["verdict"].get<std::string>());
      const auto near = [](std::size_t count, const OffsetJson& expected) {
        const double wanted = expected.get<double>();
        CHECK(std::abs(static_cast<double>(count) - wanted) <= 0.05 * wanted);
      };
      near(found.hits.size(), test["hits"]);
      near(found.folds.size(), test["folds"]);
      near(found.inverted.size(), test["inverted"]);
    }
  }

  TEST_CASE("hits are pairs of faces and colour them") {
    const OffsetResult result = offset_by(offset_mesh("horseshoe.obj", 1), 0.5);
    const SelfIntersection found = find_self_intersections(result.base, result.d);
    const std::vector<std::pair<int, int>> pairs = coarse_hits(found);
    REQUIRE(!pairs.empty());
    CHECK(pairs.size() <= found.hits.size());
    for (const auto& [f, g] : pairs) CHECK(f < g);
    const std::vector<double> colours = marks(found);
    for (const auto& [f, g] : found.hits)
      for (const int v : found.surface.mesh->corners(f)) CHECK(colours[static_cast<std::size_t>(v)] == 1);
    // The ends of the horseshoe meet each other: hits join points on both sides of the gap.
    const auto middle = [&](int f) {
      Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
      for (const int v : result.base.mesh->corners(f)) sum += result.base.points.row(v) / 3;
      return sum;
    };
    for (const auto& [f, g] : pairs) CHECK((middle(f) - middle(g)).norm() > 0.5);
    CHECK(refusal([&] { find_self_intersections(result.base, result.d, 1, {}, 3); }) ==
          "E_MAX_HITS: more than 3 pairs of faces meet");
    std::atomic<bool> stop = true;
    RunControl control;
    control.stop = &stop;
    CHECK(refusal([&] { find_self_intersections(result.base, result.d, 1, control); }) == "E_INTERRUPTED: interrupted");
  }

  TEST_CASE("triangles meet exactly where no axis separates them") {
    // Two triangles have a common point iff their difference body holds 0: no separating direction among the 17 candidates
    // of the separating axis theorem.
    const auto separated = [](const Triangle& a, const Triangle& b) {
      std::vector<Vector> axes{(a[1] - a[0]).cross(a[2] - a[0]), (b[1] - b[0]).cross(b[2] - b[0])};
      for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) axes.push_back((a[(i + 1) % 3] - a[i]).cross(b[(j + 1) % 3] - b[j]));
        axes.push_back(axes[0].cross(a[(i + 1) % 3] - a[i]));
        axes.push_back(axes[1].cross(b[(i + 1) % 3] - b[i]));
      }
      for (const Vector& axis : axes) {
        const auto range = [&](const Triangle& t) { return std::minmax({axis.dot(t[0]), axis.dot(t[1]), axis.dot(t[2])}); };
        const auto [a0, a1] = range(a);
        const auto [b0, b1] = range(b);
        if (a1 < b0 || b1 < a0) return true;
      }
      return false;
    };
    std::mt19937 engine(7);
    int meeting = 0;
    for (int k = 0; k < 5000; ++k) {
      const Triangle a = random_triangle(engine), b = random_triangle(engine);
      CAPTURE(k);
      CHECK(triangles_meet(a, b) == !separated(a, b));
      CHECK(triangles_meet(a, b) == triangles_meet(b, a));
      meeting += triangles_meet(a, b);
    }
    CHECK(meeting > 100);
  }

  TEST_CASE("the nearest point of a triangle is no farther than any other") {
    std::mt19937 engine(11);
    for (int k = 0; k < 300; ++k) {
      const Triangle t = random_triangle(engine);
      const Vector point = random_point(engine), weights = nearest_in_triangle(point, t);
      CHECK(weights.minCoeff() >= 0);
      CHECK(weights.sum() == doctest::Approx(1));
      const double found = (weights[0] * t[0] + weights[1] * t[1] + weights[2] * t[2] - point).norm();
      for (int i = 0; i <= 12; ++i)
        for (int j = 0; i + j <= 12; ++j)
          CHECK(found <= ((12 - i - j) * t[0] + i * t[1] + j * t[2] - 12 * point).norm() / 12 + 1e-12);
    }
  }

  TEST_CASE("a tree of boxes finds all pairs and the nearest") {
    std::mt19937 engine(3);
    std::vector<SpaceBox> boxes(200);
    for (SpaceBox& box : boxes) {
      const Vector centre = random_point(engine);
      for (int k = 0; k < 3; ++k) box.include((centre + 0.15 * random_point(engine)).array());
    }
    const BoxTree tree(boxes);
    std::vector<std::pair<int, int>> found, expected;
    tree.pairs([&](int i, int j) {
      found.emplace_back(i, j);
      return true;
    });
    for (int i = 0; i < 200; ++i)
      for (int j = i + 1; j < 200; ++j)
        if (boxes[static_cast<std::size_t>(i)].overlaps(boxes[static_cast<std::size_t>(j)])) expected.emplace_back(i, j);
    std::ranges::sort(found);
    CHECK(found == expected);
    int visited = 0;
    tree.pairs([&](int, int) { return ++visited < 3; });
    CHECK(visited == 3);
    for (int k = 0; k < 50; ++k) {
      const Vector point = random_point(engine);
      const auto distance = [&](int i) { return boxes[static_cast<std::size_t>(i)].distance_to(point.array()); };
      double least = HUGE_VAL;
      for (int i = 0; i < 200; ++i) least = std::min(least, distance(i));
      CHECK(distance(tree.nearest(point, distance)) == least);
    }
    CHECK(BoxTree({}).nearest(Vector::Zero(), [](int) { return 0.0; }) == -1);
  }

  TEST_CASE("curvature predicts where the exact offset of the horseshoe folds") {
    const CurvatureRange range = curvature_range(offset_mesh("horseshoe.obj"));
    // Published from fewer samples: k in [-0.656, 3.12], so folds from -0.32 on at the latest.
    CHECK(range.least == doctest::Approx(-0.656).epsilon(0.03));
    CHECK(range.greatest >= 3.12);
    CHECK(range.lowest_distance() >= -0.32);
    CHECK(range.highest_distance() == doctest::Approx(1 / 0.656).epsilon(0.03));
    const CurvatureRange sphere = curvature_range(offset_mesh("icosphere2.obj"));  // of radius 1, roughly
    CHECK(sphere.least >= 0.85);
    CHECK(sphere.greatest <= 1.3);
    CHECK(range.excluded == 2);  // the pole caps, of valence 8
    const CurvatureRange flat = curvature_range(offset_mesh("plane.obj"));
    CHECK(std::abs(flat.least) < 1e-12);
    CHECK(std::abs(flat.greatest) < 1e-12);
  }
}

}  // namespace
}  // namespace udcp
