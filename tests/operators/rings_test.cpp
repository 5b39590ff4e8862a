// Surfaces of revolution: with the ring pass every latitude ring stays a regular polygon; without it only straight profiles do.
#include <doctest/doctest.h>

#include <numeric>

#include "operators/run.h"
#include "tests/oracle/inputs.h"
#include "tests/oracle/refusal.h"
#include "tests/oracle/words.h"

using namespace udcp;
using namespace udcp::oracle;

namespace {

template <class S>
Points<S> profile(const std::vector<std::pair<int, int>>& rows) {
  Points<S> result(static_cast<Eigen::Index>(rows.size()), 2);
  for (std::size_t j = 0; j < rows.size(); ++j) {
    result(static_cast<Eigen::Index>(j), 0) = S(rows[j].first);
    result(static_cast<Eigen::Index>(j), 1) = S(rows[j].second);
  }
  return result;
}

const std::vector<std::pair<int, int>> vase{{2, 0}, {5, 1}, {1, 3}, {3, 4}}, square_loop{{5, 0}, {7, 1}, {4, 3}};

Word revolve(int m, KernelPtr f, KernelPtr omega, KernelPtr delta, Rings rings = Rings::latitude) {
  Word word = scheme("UCP", std::move(f), std::move(omega), std::move(delta));
  word.alpha0 = Directional<KernelPtr>::all(turn(ratio(2, m)));
  word.rings = rings;
  return word;
}

// The word `pipe`: kernels for circles along latitudes, plain ones along longitudes.
Word pipe(int m, const Rational& delta) {
  Word word = revolve(m, nullptr, nullptr, constant(delta), Rings::off);
  for (Item& item : word.tail) {
    item.f.latitude = half_cosine();
    item.omega.latitude = inverse_half_cosine();
  }
  return word;
}

// What a latitude edge of a regular ring of n points leaves at 0: difference of heights, of squared radii, and p.q - r^2 cos(2
// pi/n).
template <class S>
std::array<S, 3> defects(const Surface<S>& surface, int e, int n) {
  const int h = surface.mesh->edge_half[Mesh::i(e)], a = surface.mesh->vertex[Mesh::i(h)], b = surface.mesh->tip(h);
  const auto dot = [&](int i, int j) -> S {
    return surface.points(i, 0) * surface.points(j, 0) + surface.points(i, 1) * surface.points(j, 1);
  };
  return {S(surface.points(a, 2) - surface.points(b, 2)), S(dot(a, a) - dot(b, b)),
          S(dot(a, b) - dot(a, a) * cosine<S>(ratio(2, n)))};
}

template <class S, class Good>
int bad_edges(const Surface<S>& surface, int n, Good good) {
  int bad = 0, seen = 0;
  for (int e = 0; e < surface.mesh->edges(); ++e) {
    if (surface.tags.of_edge(e) != EdgeTag::latitude) continue;
    ++seen;
    for (const S& defect : defects(surface, e, n)) bad += !good(defect);
  }
  REQUIRE(seen > 0);
  REQUIRE(seen % n == 0);
  return bad;
}

int bad_edges(const Surface<Algebraic>& surface, int n) {
  return bad_edges(surface, n, [](const Algebraic& x) { return x == Algebraic(0); });
}

std::vector<Word> ring_words(Dice& dice, int m) {
  std::vector<Word> words;
  for (int k = 0; k < 2; ++k)
    words.push_back(revolve(m, constant(dice.positive()), constant(dice.fraction()), constant(dice.fraction())));
  words.push_back(revolve(m, half_cosine(), inverse_half_cosine(), value(4, 5)));
  return words;
}

}  // namespace

TEST_SUITE("operators") {
  TEST_CASE("with the ring pass all rings of tubes and tori are exactly regular after a round") {
    Dice dice(61);
    for (const int m : {4, 5, 6}) {
      for (const Word& word : ring_words(dice, m)) {
        CAPTURE(m);
        CHECK(bad_edges(run(word, tube<Algebraic>(m, profile<Algebraic>(vase)), 1), 2 * m) == 0);
        CHECK(bad_edges(run(word, tube<Algebraic>(m, profile<Algebraic>(square_loop), true), 1), 2 * m) == 0);
      }
    }
  }

  TEST_CASE("after two rounds the defects of all rings are enclosures of 0 and narrow") {
    Dice dice(62);
    for (const int m : {5, 7}) {
      for (const Word& word : ring_words(dice, m)) {
        CAPTURE(m);
        const auto narrow_zero = [](const Interval& x) { return x.contains_zero() && x.width() < 1e-20; };
        CHECK(bad_edges(run(word, tube<Interval>(m, profile<Interval>(vase)), 2), 4 * m, narrow_zero) == 0);
      }
    }
  }

  TEST_CASE("a torus with rings in both directions and delta 1 stays exactly on the torus") {
    for (const auto& size : {std::pair{6, 4}, {4, 4}, {4, 6}}) {
      const int m = size.first, k = size.second;  // clang 14 cannot CAPTURE a binding
      CAPTURE(m);
      CAPTURE(k);
      const Algebraic R(3), r(1);
      Word word = revolve(m, half_cosine(), inverse_half_cosine(), value(1), Rings::both);
      word.alpha0.longitude = turn(ratio(2, k));
      const auto fine = run(word, torus<Algebraic>(m, k, R, r), 1);
      int off = 0;
      for (Eigen::Index v = 0; v < fine.points.rows(); ++v) {
        const Algebraic axis = fine.points(v, 0) * fine.points(v, 0) + fine.points(v, 1) * fine.points(v, 1);
        const Algebraic sum = axis + fine.points(v, 2) * fine.points(v, 2) + R * R - r * r;
        off += sum * sum != Algebraic(4) * R * R * axis;
      }
      CHECK(off == 0);
      CHECK(bad_edges(fine, 2 * m) == 0);
    }
  }

  TEST_CASE("without the ring pass a curved profile fails") {
    CHECK(bad_edges(run(pipe(5, ratio(1, 2)), tube<Algebraic>(5, profile<Algebraic>(vase)), 1), 10) > 0);
    Word plain = pipe(5, Rational(1));
    CHECK(bad_edges(run(plain, tube<Algebraic>(5, profile<Algebraic>(vase)), 1), 10) > 0);
    plain.rings = Rings::latitude;
    CHECK(bad_edges(run(plain, tube<Algebraic>(5, profile<Algebraic>(vase)), 1), 10) == 0);
  }

  TEST_CASE("cylinders and cones of even rings need no ring pass for any delta") {
    for (const Rational& delta : {ratio(-1, 10), Rational(0), ratio(4, 5), Rational(1)}) {
      CAPTURE(delta.to_string());
      CHECK(bad_edges(run(pipe(5, delta), tube<Algebraic>(5, profile<Algebraic>({{2, 0}, {2, 1}, {2, 2}})), 1), 10) == 0);
      CHECK(bad_edges(run(pipe(5, delta), tube<Algebraic>(5, profile<Algebraic>({{1, 0}, {2, 3}, {3, 6}, {4, 9}})), 1), 10) == 0);
    }
  }

  TEST_CASE("f along latitudes and longitudes weighs V by both and E by the edge that crosses") {
    Dice dice(63);
    Word word = operation("UD");
    const Rational lat = dice.positive(), lon = dice.positive();
    word.head[1].f = {value(7), constant(lat), constant(lon)};
    Surface<Rational> surface = random_surface<Rational>(dice, make_mesh(4, Faces{{0, 1, 2, 3}}));
    surface.tags.edge = {EdgeTag::latitude, EdgeTag::longitude, EdgeTag::latitude, EdgeTag::longitude};
    const Points<Rational> dual = run(word, surface, 1).points, &p = surface.points;
    const Points<Rational> u = (p.row(0) + p.row(1)) / Rational(2), v = (p.row(0) + p.row(3)) / Rational(2);
    const Points<Rational> centre = (p.row(0) + p.row(1) + p.row(2) + p.row(3)) / Rational(4);
    // the edge from the point of a latitude edge to the centre is a longitude
    const Rational total = lat * lon + lon + lat + Rational(1);
    const Points<Rational> expected = (lat * lon * p.row(0) + lon * u + lat * v + centre) / total;
    CHECK(dual.row(0) == expected.row(0));
    // boundary edge values: the curve rule with f of the tag of the edge
    const Points<Rational> on_edge = (lat * p.row(0) + u) / (lat + Rational(1));
    CHECK(dual.row(4) == on_edge.row(0));
  }

  TEST_CASE("face points of tagged quads get omega of both directions and omega@face replaces omega squared") {
    Dice dice(64);
    Surface<Rational> surface = random_surface<Rational>(dice, *torus<double>(4, 3, 2, 1).mesh);
    const Rational lat = dice.fraction(), lon = dice.fraction(), plain = dice.fraction(), face = dice.fraction(),
                   delta = dice.fraction();
    Word word = operation("UCP", nullptr, nullptr, constant(delta));
    word.head[2].omega = {constant(plain), constant(lat), constant(lon)};
    const auto tags = torus<double>(4, 3, 2, 1).tags;
    const auto smooth = run(operation("UC"), surface, 1).points;
    const auto check = [&](const Word& w, const Rational& weight) {
      const Points<Rational> fine = run(w, surface, 1).points;
      const Mesh& mesh = *surface.mesh;
      for (int f = 0; f < mesh.faces(); ++f) {
        const int i = mesh.vertices() + mesh.edges() + f;
        Points<Rational> expected = smooth.row(i);
        for (const int v : mesh.corners(f))
          expected.row(0) += weight * delta * (surface.points.row(v) - smooth.row(v)) / Rational(4);
        CHECK(fine.row(i) == expected.row(0));
      }
    };
    check(word, plain * plain);
    surface.tags = tags;
    check(word, lat * lon);
    word.head[2].omega_face = constant(face);
    check(word, face);
    surface.tags = {};
    check(word, face);
  }

  TEST_CASE("a point without a complete ring keeps its value") {
    // open rings: a strip of three tagged quads; at its two ends no ring goes on
    Surface<Rational> surface = grid<Rational>(3, 1);
    surface.tags.edge.assign(Mesh::i(surface.mesh->edges()), EdgeTag::longitude);
    for (int h = 0; h < surface.mesh->half_edges(); h += 2)
      surface.tags.edge[Mesh::i(surface.mesh->edge[Mesh::i(h)])] = EdgeTag::latitude;
    Dice dice(65);
    surface.points = random_points<Rational>(dice, 8, 3);
    Word with = operation("UCP", nullptr, nullptr, value(1, 3)), without = with;
    with.rings = Rings::latitude;
    const Points<Rational> a = run(with, surface, 1).points, b = run(without, surface, 1).points;
    std::vector<int> changed;
    for (Eigen::Index v = 0; v < a.rows(); ++v)
      if (a.row(v) != b.row(v)) changed.push_back(static_cast<int>(v));
    // the middle latitude edges of both sides and the middle face
    const Mesh& mesh = *surface.mesh;
    const int low = 8 + mesh.edge[4], high = 8 + mesh.edge[6], face = 8 + mesh.edges() + 1;
    std::vector<int> expected{low, high, face};
    std::sort(expected.begin(), expected.end());
    CHECK(changed == expected);
    const Points<Rational> middle = ratio(9, 16) * (b.row(1) + b.row(2)) - ratio(1, 16) * (b.row(0) + b.row(3));
    CHECK(a.row(low) == middle.row(0));  // alpha 0: c = 1, w = 1/16
  }

  TEST_CASE("the ring pass refuses an angle whose half has cosine 0") {
    Word word = operation("UCP");
    word.rings = Rings::latitude;
    word.alpha0 = Directional<KernelPtr>::all(turn(Rational(1)));
    const auto shape = tube<double>(5, profile<double>(vase));
    CHECK(refusal([&] { run(word, shape, 1); }) == "E_DIV0: the ring pass divides by c(1 + c) with c = cos(alpha/2) = 0");
  }
}
