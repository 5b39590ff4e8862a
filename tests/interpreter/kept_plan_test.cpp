// Plans kept between the rounds of a loop give what run() gives.
#include "interpreter/kept_plan.h"

#include <doctest/doctest.h>

#include "interpreter/session.h"
#include "operators/schemes.h"
#include "operators/shapes.h"

namespace udcp {
namespace {

constexpr int rounds = 5;  // a torus of 6 x 4 quads becomes 24,576 faces

Surface<double> moved(Surface<double> surface, double t) {
  for (int v = 0; v < surface.mesh->vertices(); ++v) surface.points(v, 0) += t * surface.points(v, 1) * surface.points(v, 1) + t;
  return surface;
}

double largest(const Points<double>& difference) { return difference.cwiseAbs().maxCoeff(); }

}  // namespace

TEST_SUITE("interpreter") {
  TEST_CASE("a kept plan gives the points of run in the order of run") {
    const Word word = schemes::catmull_clark();
    const Surface<double> base = torus<double>(6, 4, 2, 1);
    KeptPlan kept;
    CHECK_FALSE(kept.refine(word, base, rounds, {}));
    const Surface<double> first = run(word, base, rounds);
    kept.remember(word, base, rounds, first);
    for (const double t : {0.25, 0.5, 1.0}) {
      const Surface<double> surface = moved(base, t);
      const std::optional<Surface<double>> found = kept.refine(word, surface, rounds, {});
      REQUIRE(found);
      CHECK(found->mesh == first.mesh);
      CHECK(found->tags.edge == first.tags.edge);
      CHECK(largest(found->points - run(word, surface, rounds).points) < 1e-12 * largest(surface.points));
    }
  }

  TEST_CASE("a kept plan keeps apart the equal parts of a mesh") {
    const Word word = schemes::catmull_clark();
    const Surface<double> one = torus<double>(6, 4, 2, 1);
    const int n = one.mesh->vertices();
    std::vector<int> begin = one.mesh->face_begin, corners = one.mesh->vertex;
    for (const int v : one.mesh->vertex) corners.push_back(n + v);
    for (int f = 0; f < one.mesh->faces(); ++f) begin.push_back(begin.back() + 4);
    Surface<double> two;
    two.mesh = std::make_shared<const Mesh>(make_mesh(2 * n, std::move(begin), std::move(corners)));
    two.points.resize(2 * n, 3);
    two.points << one.points, (one.points * 0.5).array() + 4;
    KeptPlan kept;
    kept.remember(word, two, rounds, run(word, two, rounds));
    const Surface<double> surface = moved(two, 0.5);
    const std::optional<Surface<double>> found = kept.refine(word, surface, rounds, {});
    REQUIRE(found);
    CHECK(largest(found->points - run(word, surface, rounds).points) < 1e-12 * largest(surface.points));
  }

  TEST_CASE("a kept plan serves no other word and no other connectivity") {
    const Word word = schemes::catmull_clark();
    const Surface<double> base = torus<double>(6, 4, 2, 1);
    KeptPlan kept;
    kept.remember(word, base, rounds, run(word, base, rounds));
    Word other = word;
    other.tail.back().delta = formula([](const auto& c) { return c.alpha; });
    CHECK_FALSE(kept.refine(other, base, rounds, {}));
    CHECK_FALSE(kept.refine(word, base, rounds - 1, {}));
    CHECK_FALSE(kept.refine(word, torus<double>(4, 6, 2, 1), rounds, {}));
    Surface<double> untagged = base;
    untagged.tags = {};
    CHECK_FALSE(kept.refine(word, untagged, rounds, {}));
    CHECK(kept.refine(word, base, rounds, {}));
  }

  TEST_CASE("meshes that move in a loop refine as they do outside of it") {
    Session session;
    session.load_prelude();
    session.run(
        "m = torus(6, 4, 2, 1)\n"
        "fine = m |> catmull_clark^5\n"
        "sweep k in 1 .. 3 { assert approx(m |> scale(k) |> catmull_clark^5, fine |> scale(k), 1/10^12) }");
    CHECK(session.outcome() == Outcome::done);
  }
}

}  // namespace udcp
