// Limit points: closed forms of the classical schemes, and that refining first changes nothing.
#include "operators/limit.h"

#include <doctest/doctest.h>

#include "tests/oracle/inputs.h"
#include "tests/oracle/loop.h"
#include "tests/oracle/refusal.h"
#include "tests/oracle/schemes.h"
#include "tests/oracle/words.h"

using namespace udcp;
using namespace udcp::oracle;

namespace {

double distance(const Points<double>& a, const Points<double>& b) {
  return a.rows() == b.rows() ? (a - b).cwiseAbs().maxCoeff() : 1e300;
}

Surface<double> rough(Dice& dice, const Mesh& mesh) { return random_surface<double>(dice, mesh); }

// The limit of the vertices before a round is that of the same vertices after it; `later` is the word as it goes on.
double change_by_refining(const Word& word, const Word& later, const Surface<double>& surface) {
  const Limit before = limit(word, surface), after = limit(later, run(word, surface, 1));
  return distance(before.points, after.points.topRows(before.points.rows()));
}

}  // namespace

TEST_SUITE("operators") {
  TEST_CASE("refining first leaves the limit points of stationary words where they are") {
    Dice dice(141);
    for (const Mesh& mesh : {prism(5), l_shape(), *cube<Rational>().mesh, *ring_mesh(5, 1).mesh}) {
      const auto surface = rough(dice, mesh);
      for (const Word& word : {catmull_clark(), scheme("UCP", nullptr, value(1, 2), value(1, 3)),
                               scheme("UCCP", nullptr, value(1), value(1, 2)), scheme("UDD"), scheme("UDDDD", value(1, 2))})
        CHECK(change_by_refining(word, word, surface) < 1e-9);
    }
    for (const Mesh& mesh : {*octahedron<Rational>().mesh, *ring_mesh(5, 1, true).mesh}) {
      const auto surface = rough(dice, mesh);
      CHECK(change_by_refining(loop(), loop(), surface) < 1e-9);
      const Word word = on_triangles(scheme("UCP", nullptr, value(1, 2), value(1, 3)));
      CHECK(change_by_refining(word, word, surface) < 1e-9);
    }
  }

  TEST_CASE("refining first leaves the limit points of circle words where they are") {
    Dice dice(142);
    Word word = circle(5, "UCP", ratio(1, 2)), later = word;
    later.alpha0 = Directional<KernelPtr>::all(turn(ratio(1, 5)));
    CHECK(change_by_refining(word, later, rough(dice, *cube<Rational>().mesh)) < 1e-9);
    const auto curve = random_curve<double>(dice, 6, true);
    const Points<double> before = limit(word, curve), after = limit(later, run(word, curve, 1));
    for (Eigen::Index i = 0; i < before.rows(); ++i) CHECK((before.row(i) - after.row(2 * i)).norm() < 1e-9);
  }

  TEST_CASE("interpolating words have the points themselves as limits") {
    Dice dice(143);
    for (const Mesh& mesh : {prism(5), *cube<Rational>().mesh, *grid<Rational>(3, 2).mesh}) {
      const auto surface = rough(dice, mesh);
      CHECK(distance(limit(scheme("UCP"), surface).points, surface.points) < 1e-12);
    }
    for (const bool closed : {true, false}) {
      const auto curve = random_curve<double>(dice, 7, closed);
      CHECK(distance(limit(scheme("UCP"), curve), curve.points) < 1e-12);
    }
  }

  TEST_CASE("limits of spline curves have the weights of the B-spline") {
    Dice dice(144);
    const auto curve = random_curve<double>(dice, 7, true, 3);
    const auto p = [&](int i) { return curve.points.row((i + 7) % 7); };
    const Points<double> cubic = limit(scheme("UC"), curve), quintic = limit(scheme("UCC"), curve);
    for (int i = 0; i < 7; ++i) {
      CHECK((cubic.row(i) - (p(i - 1) + 4 * p(i) + p(i + 1)) / 6).norm() < 1e-12);
      CHECK((quintic.row(i) - (p(i - 2) + 26 * p(i - 1) + 66 * p(i) + 26 * p(i + 1) + p(i + 2)) / 120).norm() < 1e-12);
    }
  }

  TEST_CASE("ends and corners of curves are limits and cut the rest") {
    Dice dice(145);
    auto curve = random_curve<double>(dice, 6, true);
    curve.corner = {0, 0, 0, 1, 0, 0};
    const Points<double> limits = limit(scheme("UC"), curve);
    CHECK((limits.row(3) - curve.points.row(3)).norm() < 1e-12);
    CHECK((limits.row(0) - (curve.points.row(5) + 4 * curve.points.row(0) + curve.points.row(1)) / 6).norm() < 1e-12);
    auto open = random_curve<double>(dice, 2, false);
    CHECK(distance(limit(scheme("UC"), open), open.points) < 1e-12);
  }

  TEST_CASE("a head is run before the limit is taken") {
    Dice dice(146);
    Word word = catmull_clark(), tail = word;
    word.head = items("UCP");
    const auto surface = rough(dice, prism(4));
    const Points<double> expected = limit(tail, run(operation("UCP"), surface, 1)).points;
    CHECK(distance(limit(word, surface).points, expected.topRows(8)) < 1e-12);
    Word curve_word = scheme("UC");
    curve_word.head = items("U3C");
    const auto curve = random_curve<double>(dice, 5, false);
    const Points<double> all = limit(scheme("UC"), run(operation("U3C"), curve, 1)), found = limit(curve_word, curve);
    for (int i = 0; i < 5; ++i) CHECK((found.row(i) - all.row(3 * i)).norm() < 1e-12);
  }

  TEST_CASE("the limit of Catmull-Clark at valence n has its closed form") {
    Dice dice(147);
    for (int n = 3; n <= 12; ++n) {
      CAPTURE(n);
      const auto surface = rough(dice, *ring_mesh(n, 3).mesh);
      Eigen::RowVector3d edges = Eigen::RowVector3d::Zero(), faces = edges;
      for (int k = 0; k < n; ++k) {  // ring 1: spoke, diagonal, spoke, ...
        edges += surface.points.row(1 + 2 * k);
        faces += surface.points.row(2 + 2 * k);
      }
      const Eigen::RowVector3d expected = (n * n * surface.points.row(0) + 4 * edges + faces) / (n * (n + 5));
      CHECK((limit(catmull_clark(), surface).points.row(0) - expected).norm() < 1e-10);
    }
  }

  TEST_CASE("the limit of Loop at valence n has its closed form") {
    Dice dice(148);
    for (int n = 3; n <= 50; ++n) {
      CAPTURE(n);
      const auto surface = rough(dice, *ring_mesh(n, 3, true).mesh);
      const double share = 1 / (n + 3 / (8 * loop_beta<double>(n)));
      Eigen::RowVector3d expected = (1 - n * share) * surface.points.row(0);
      for (int k = 0; k < n; ++k) expected += share * surface.points.row(1 + k);
      CHECK((limit(loop(), surface).points.row(0) - expected).norm() < 1e-10);
    }
  }

  TEST_CASE("words without a limit say why") {
    const auto shape = cube<double>();
    const auto curve = polygon<double>(5);
    CHECK(refusal([&] { limit(scheme("UD"), shape); }) ==
          "E_LIMIT_DUAL: the word has an odd number of D, so its new points do not correspond to the old ones");
    CHECK(refusal([&] { limit(scheme("UDUD"), curve); }).starts_with("E_LIMIT_DUAL"));
    CHECK(refusal([&] { limit(operation("UC"), shape); }) == "E_NO_SCHEME: a finite operator has no limit");
    const KernelPtr missing = formula([](const auto& c) { return c.attribute("w"); }, {false, true, false});
    CHECK(refusal([&] { limit(scheme("UCP", nullptr, nullptr, missing), shape); }) ==
          "E_LIMIT_VARIES: parameters that differ from point to point (v.name, noise) have no limit stencils");
    Word varied = scheme("UC", half_cosine());
    varied.alpha0.plain = missing;
    CHECK(refusal([&] { limit(varied, curve); }) ==
          "E_LIMIT_VARIES: an alpha0 that differs from point to point has no limit stencils");
    CHECK(refusal([&] { limit(scheme("DD"), shape); }) ==
          "E_NO_LIMIT: a round of the word has no U, so its points do not approach a curve or surface");
  }

  TEST_CASE("points that diverge or oscillate have no limit") {
    // the symmetric eigenvalue 1/2 - 2a with a = (1 - delta)/8 is 7/2, -3/2 and -1
    for (const Rational& delta : {Rational(13), Rational(-7), Rational(-5)}) {
      CAPTURE(delta.to_string());
      const Word word = scheme("UCP", nullptr, value(0), constant(delta));
      CHECK(refusal([&] { limit(word, polygon<double>(7)); }) ==
            "E_NO_LIMIT: the points do not settle: the scheme seems to diverge or to oscillate");
    }
  }
}
