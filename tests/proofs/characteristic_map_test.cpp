// Characteristic maps: dependence sets, nets, Bernstein coefficients, hulls, pictures.
#include "proofs/characteristic_map.h"

#include <doctest/doctest.h>

#include "proofs/characteristic_picture.h"
#include "proofs/characteristic_ring.h"
#include "proofs/eigenvalues.h"
#include "proofs/surface_facts.h"
#include "tests/proofs/surface_words.h"

using namespace udcp;
using oracle::ratio;

namespace {

template <class S>
CharacteristicNet net_of(const SurfaceFacts<S>& facts) {
  const Points<Interval> matrix = block(facts.local.enclosed, facts.local.radius, 1);
  const std::optional<ApproximatePair> near = approximate_eigenpair(matrix);
  REQUIRE(near.has_value());
  return characteristic_net(facts, enclose_eigenpair(matrix, *near).value());
}

double area(const std::array<std::complex<double>, 4>& corners) {
  double twice = 0;
  for (std::size_t k = 0; k < 4; ++k) twice += (std::conj(corners[k]) * corners[(k + 1) % 4]).imag();
  return twice / 2;
}

}  // namespace

TEST_SUITE_BEGIN("proofs");

TEST_CASE("cells depend on the expected numbers of points") {
  const auto words = oracle::surface_words();
  for (const auto& [name, values] : oracle::surface_values()["schemes"].items()) {
    const std::string of_word = name;  // clang 14 captures no bindings
    CAPTURE(of_word);
    const Word& word = words.at(name);
    const auto part = regular_part(lattice_mask<Rational>(word), word.triangles);
    REQUIRE(part.has_value());
    const CellSets sets = cell_sets(*part, values["kind"] == "dual");
    CHECK(sets.position.size() == values["hull"]["K"].get<std::size_t>());
    CHECK(sets.du.size() == values["hull"]["Ku"].get<std::size_t>());
    CHECK(sets.dv.size() == sets.du.size());
    const std::optional<Ring> ring = ring_of(sets);
    REQUIRE(ring.has_value());
    CHECK(ring->first == values["valence"][0]["ring"]["i0"].get<int>());
    CHECK(ring->cells.size() == static_cast<std::size_t>(3 * ring->first * ring->first));
    // The constants of the expected values come from the same inequality.
    const std::optional<RingTest> test = RingTest::of(*part, sets);
    REQUIRE(test.has_value());
    CHECK(test->hulls()[0] == doctest::Approx(values["hull"]["position"].get<double>()).epsilon(1e-6));
    CHECK(test->hulls()[1] == doctest::Approx(values["hull"]["du"].get<double>()).epsilon(1e-6));
    CHECK(test->hulls()[2] == doctest::Approx(values["hull"]["dv"].get<double>()).epsilon(1e-6));
  }
}

TEST_CASE("around a regular point the characteristic net is the lattice") {
  for (const char* atoms : {"UC", "UCC", "UCP", "UCCP"}) {
    CAPTURE(atoms);
    const SurfaceFacts<Rational> facts = surface_facts<Rational>(oracle::scheme(atoms), 4);
    const CharacteristicNet net = net_of(facts);
    const Rational step = ratio(1, 2) / net.at({2, 0}).re.lower();
    for (const Place& place : {Place{2, 2}, {4, 0}, {4, 2}, {6, 4}}) {
      const Complex value = net.at(place);
      CHECK(abs(value.re * Interval(step) - Interval(ratio(place.x, 4))) < Interval(ratio(1, 1'000'000'000)));
      CHECK(abs(value.im * Interval(step) - Interval(ratio(place.y, 4))) < Interval(ratio(1, 1'000'000'000)));
    }
  }
}

TEST_CASE("the least Bernstein coefficients of Catmull and Clark are the expected ones") {
  for (const auto& at : oracle::surface_values()["schemes"]["catmull-clark"]["valence"]) {
    const int n = at["n"];
    CAPTURE(n);
    const SurfaceFacts<Rational> facts = surface_facts<Rational>(oracle::catmull_clark(), n);
    REQUIRE(is_bicubic(facts.part.mask));
    const BernsteinBounds bounds = bernstein_bounds(net_of(facts));
    CHECK(bounds.jacobian.midpoint() == doctest::Approx(at["bernstein_min"].get<double>()).epsilon(1e-8));
    CHECK(bounds.half_plane > Interval(0));
  }
}

TEST_CASE("rows that are not regular on the ring are noticed") {
  const SurfaceFacts<Rational> facts = surface_facts<Rational>(oracle::catmull_clark(), 5);
  CHECK(rows_are_regular(facts.local.patch, facts.part.mask, facts.sets, facts.ring));
  Patch<Rational> broken = facts.local.patch;
  Row<Rational>& row = broken.rows.at({0, 6, 2});
  row.begin()->second += ratio(1, 100);
  CHECK_FALSE(rows_are_regular(broken, facts.part.mask, facts.sets, facts.ring));
  // One cell nearer, the extraordinary vertex is among the points.
  CHECK_FALSE(rows_are_regular(facts.local.patch, facts.part.mask, facts.sets, Ring{1, {{0, 0}, {2, 0}}}));
}

TEST_CASE("boxes of limits hold the limits") {
  // On the regular lattice the data x + iy have the limit x + iy and the derivatives 1 and i.
  const SurfaceFacts<Rational> facts = surface_facts<Rational>(oracle::scheme("UCP"), 4);
  const std::optional<CellScheme> scheme = CellScheme::of(facts.part.mask, facts.sets.position);
  REQUIRE(scheme.has_value());
  CellScheme::Data data;
  for (const Place& k : scheme->points()) data.values.emplace_back(k.x / 2.0, k.y / 2.0);
  const CellScheme::Box box = scheme->limits(data, 1.0);
  CHECK(box.re[0] <= 0);
  CHECK(box.re[1] >= 1);
  CellScheme::Data corner = data;
  for (int round = 0; round < 30; ++round) corner = scheme->child(corner, 3);
  const CellScheme::Box limit = scheme->limits(corner, 1.0);
  CHECK(limit.re[0] == doctest::Approx(1));
  CHECK(limit.im[1] == doctest::Approx(1));
  CHECK(corner.error < 1e-6);  // at most the norm of a round, about 1.6, to the power 30, times a few roundings
}

TEST_CASE("folded nets are not accepted") {
  // The net of the lattice turned inside out: the Jacobian is negative everywhere.
  const SurfaceFacts<Rational> facts = surface_facts<Rational>(oracle::scheme("UCP"), 5);
  const std::optional<RingTest> test = RingTest::of(facts.part, facts.sets);
  REQUIRE(test.has_value());
  const CharacteristicNet net = net_of(facts);
  RingTest::Cell cell = test->cell(net, facts.ring.cells.back());
  for (int depth = 0; depth < 4; ++depth) cell = test->child(cell, 0);
  REQUIRE(test->accepts(cell, 5));
  RingTest::Cell folded = cell;
  std::swap(folded.du.values, folded.dv.values);
  CHECK_FALSE(test->accepts(folded, 5));
  RingTest::Cell behind = cell;
  for (auto& value : behind.position.values) value = -value;
  CHECK_FALSE(test->accepts(behind, 5));
  RingTest::Cell vague = cell;
  vague.du.error = 10;
  CHECK_FALSE(test->accepts(vague, 5));
}

TEST_CASE("pictures of characteristic maps reproduce themselves") {
  for (const int n : {3, 8}) {
    CAPTURE(n);
    for (const Word& word : {oracle::catmull_clark(), oracle::loop(), oracle::scheme("UD"), oracle::scheme("UCP")}) {
      const std::vector<CharacteristicCell> one = characteristic_cells(word, n, 1, 1), two = characteristic_cells(word, n, 1, 2);
      REQUIRE(!one.empty());
      CHECK(two.size() == 2 * one.size());
      double least = 1e9, most = 0;  // on spoke 0
      for (const CharacteristicCell& cell : one) {
        CHECK(cell.jacobian > 0);
        CHECK(area(cell.corners) > 0);
        for (const auto& corner : cell.corners) {
          if (cell.sector != 0 || std::abs(corner.imag()) > 1e-3) continue;
          least = std::min(least, corner.real());
          most = std::max(most, corner.real());
        }
      }
      // The limit reproduces itself: the ring ends where its copy times lambda begins.
      const double lambda = std::abs(two[one.size()].corners[0] / one[0].corners[0]);
      CHECK(least == doctest::Approx(lambda * most).epsilon(1e-3));
    }
  }
  std::string why;
  CHECK(characteristic_cells(oracle::scheme("UUC"), 5, 2, 1, &why).empty());
  CHECK_FALSE(why.empty());
}

TEST_SUITE_END();
