// Rows around extraordinary points against the published stencils.
#include "proofs/patch.h"

#include <doctest/doctest.h>

#include <set>

#include "tests/oracle/loop.h"
#include "tests/proofs/surface_words.h"

using namespace udcp;

namespace {

/// The index of a lattice point in ring_mesh, as its comment numbers them.
int index_of(int n, bool triangles, int s, int i, int j) {
  if (i == 0 && j == 0) return 0;
  if (i == 0) return index_of(n, triangles, s + 1, j, 0);
  s %= n;
  if (triangles) return 1 + n * (i + j) * (i + j - 1) / 2 + s * (i + j) + j;
  const int r = std::max(i, j);
  return 1 + n * r * (r - 1) + 2 * r * s + (i == r ? j : r + (r - i));
}

std::vector<std::vector<int>> faces_of(const Mesh& mesh) {
  std::vector<std::vector<int>> result;
  for (int f = 0; f < mesh.faces(); ++f) result.emplace_back(mesh.corners(f).begin(), mesh.corners(f).end());
  return result;
}

/// The old points whose mean the new point (0, x, y), in units of the new spacing, stands at.
std::set<int> parents(int n, bool triangles, int x, int y) {
  const int i = x / 2, j = y / 2, u = x % 2, v = y % 2;
  const auto at = [&](int a, int b) { return index_of(n, triangles, 0, a, b); };
  if (triangles && u == 1 && v == 1) return {at(i + 1, j), at(i, j + 1)};
  std::set<int> result;
  for (int a = 0; a <= u; ++a)
    for (int b = 0; b <= v; ++b) result.insert(at(i + a, j + b));
  return result;
}

/// Compares row after row with a textbook step on one column of numbers.
template <class S>
void compare(const Word& word, int n, bool triangles) {
  constexpr int rings = 6, radius = 8;
  const Surface<double> ring = ring_mesh(n, rings, triangles);
  const std::vector<std::vector<int>> faces = faces_of(*ring.mesh);
  Points<S> old(ring.mesh->vertices(), 1);
  for (int v = 0; v < ring.mesh->vertices(); ++v) old(v, 0) = S((v * v * 31 + v * 17 + 5) % 1009);
  const oracle::Refined<S> refined = triangles ? oracle::loop_step(faces, old) : oracle::catmull_clark_step(faces, old);
  const oracle::EdgeTable table(faces);
  const Patch<S> rows = patch<S>(word, n, radius);
  for (const auto& [label, row] : rows.rows) {
    const Label at = label;
    CAPTURE(at.a);
    CAPTURE(at.b);
    const std::set<int> from = parents(n, triangles, label.a / 2, label.b / 2);
    int fine = *from.begin();
    if (from.size() == 2) fine = ring.mesh->vertices() + table.of(*from.begin(), *from.rbegin());
    if (from.size() == 4) {
      const auto found = std::find_if(faces.begin(), faces.end(), [&](const std::vector<int>& face) {
        return std::set<int>(face.begin(), face.end()) == from;
      });
      fine = ring.mesh->vertices() + static_cast<int>(table.edges.size()) + static_cast<int>(found - faces.begin());
    }
    S value(0);
    for (const auto& [place, weight] : row) value += weight * old(index_of(n, triangles, place.s, place.a / 2, place.b / 2), 0);
    CHECK(value == refined.points(fine, 0));
  }
}

}  // namespace

TEST_SUITE_BEGIN("proofs");

TEST_CASE("rows of a patch are the published stencils of Catmull and Clark") {
  for (const int n : {3, 4, 5, 8}) {
    CAPTURE(n);
    compare<Rational>(oracle::catmull_clark(), n, false);
  }
}

TEST_CASE("rows of a patch are the published stencils of Loop") {
  for (const int n : {3, 4, 6}) {
    CAPTURE(n);
    compare<Rational>(oracle::loop(), n, true);
  }
  for (const int n : {5, 7}) {
    CAPTURE(n);
    compare<Algebraic>(oracle::loop(), n, true);
  }
}

TEST_CASE("rows around a face are means of the corner with its edges and its face") {
  // U D at a corner v of an n-gon: (v + (v + left)/2 + (v + right)/2 + mean)/4.
  for (const int n : {3, 4, 5, 9}) {
    CAPTURE(n);
    const Patch<Rational> rows = patch<Rational>(oracle::scheme("UD"), n, 5);
    const Row<Rational>& row = rows.rows.at({0, 1, 1});
    REQUIRE(row.size() == static_cast<std::size_t>(n));
    for (int s = 0; s < n; ++s) {
      const Rational share = oracle::ratio(1, 4 * n);
      const Rational own = s == 0 ? oracle::ratio(1, 2) : s == 1 || s == n - 1 ? oracle::ratio(1, 8) : Rational(0);
      CHECK(row.at({s, 1, 1}) == own + share);
    }
    // Away from the face, Chaikin's weights in both directions.
    const Row<Rational>& outer = rows.rows.at({0, 5, 5});
    CHECK(outer.size() == 4);
    CHECK(outer.at({0, 3, 3}) == oracle::ratio(9, 16));
    CHECK(outer.at({0, 1, 3}) == oracle::ratio(3, 16));
    CHECK(outer.at({0, 1, 1}) == oracle::ratio(1, 16));
  }
}

TEST_CASE("patches reproduce constants and are mirror symmetric") {
  for (const auto& [name, word] : oracle::surface_words()) {
    const std::string of_word = name;  // clang 14 captures no bindings
    CAPTURE(of_word);
    const Patch<Algebraic> rows = patch<Algebraic>(word, 5, 9);
    CHECK(reproduces_constants(rows));
    CHECK(is_mirror_symmetric(rows));
    Patch<Algebraic> broken = rows;
    const Label beside = rows.sectors.dual ? Label{0, 5, 3} : Label{0, 4, 2};  // neither on a spoke nor on the diagonal
    broken.rows.at(beside).begin()->second += Algebraic(1);
    CHECK_FALSE(reproduces_constants(broken));
    CHECK_FALSE(is_mirror_symmetric(broken));
  }
}

TEST_CASE("mirror images and rotations come back") {
  for (const bool triangles : {false, true}) {
    const Sectors sectors{5, triangles, false};
    for (const Label& label : {Label{0, 2, 0}, Label{3, 4, 2}, Label{1, 2, 2}, Label{}}) {
      CHECK(sectors.mirrored(sectors.mirrored(label)) == label);
      CHECK(sectors.rotated(sectors.rotated(label, 2), -2) == label);
      for (const int s : {label.s - 1, label.s, label.s + 1}) CHECK(sectors.label(s, sectors.seen_from(s, label)) == label);
    }
    CHECK(sectors.mirrored({0, 2, 0}) == Label{0, 2, 0});
    CHECK(sectors.mirrored({0, 4, 2}) == Label{4, 2, 4});
  }
}

TEST_CASE("invariant radii are half the width of the mask") {
  const auto radius = [](const Word& word) { return invariant_radius(patch<Rational>(word, 5, 10)); };
  CHECK(radius(oracle::catmull_clark()) == 4);
  CHECK(radius(oracle::scheme("UCP")) == 6);
  CHECK(radius(oracle::scheme("UCCP")) == 6);
  CHECK(radius(oracle::scheme("UCC")) == 6);
  CHECK(radius(oracle::scheme("UD")) == 3);
  CHECK(radius(oracle::scheme("UDDD")) == 5);
  CHECK(radius(oracle::on_triangles(oracle::scheme("UC"))) == 4);
  CHECK(radius(oracle::on_triangles(oracle::scheme("UCP"))) == 6);
}

TEST_CASE("patches that cannot be are refused") {
  CHECK_THROWS_AS((void)patch<Rational>(oracle::scheme("UC"), 2, 4), Error);
  CHECK_THROWS_AS((void)patch<Rational>(oracle::scheme("UC"), 100'000, 40), Error);
  CHECK_THROWS_AS((void)patch<Rational>(oracle::loop(), 5, 4), Error);  // irrational
  CHECK(has_one_split(oracle::scheme("UC")));
  for (const char* atoms : {"UCUC", "U3C", "CU"}) {
    CAPTURE(atoms);
    std::string why;
    CHECK_FALSE(has_one_split(oracle::scheme(atoms), &why));
    CHECK_FALSE(why.empty());
  }
}

TEST_SUITE_END();
