// Catmull-Clark: the words against the textbook, and by how much they differ next to faces that are no quads.
#include <doctest/doctest.h>

#include "operators/run.h"
#include "tests/oracle/catmull_clark.h"
#include "tests/oracle/inputs.h"
#include "tests/oracle/schemes.h"
#include "tests/oracle/words.h"

using namespace udcp;
using namespace udcp::oracle;

namespace {

Word dual_catmull_clark() {
  Word word = catmull_clark();
  word.tail[1].ngon = Ngon::dual;
  return word;
}

void compare(const Word& word, Surface<Rational> surface, int rounds) {
  Refined<Rational> expected{faces_of(*surface.mesh), surface.points};
  std::vector<char> corner = surface.tags.corner;
  for (int round = 0; round < rounds; ++round) {
    CAPTURE(round);
    expected = catmull_clark_step(expected.faces, expected.points, corner);
    if (!corner.empty()) corner.resize(static_cast<std::size_t>(expected.points.rows()), 0);
    surface = run(word, surface, 1);
    CHECK(faces_of(*surface.mesh) == expected.faces);
    CHECK(surface.points == expected.points);
    CHECK(surface.tags.corner == corner);
  }
}

}  // namespace

TEST_SUITE("operators") {
  TEST_CASE("UCP with omega 0 and delta (N-4)/N is Catmull-Clark on quads") {
    Dice dice(41);
    for (const NamedMesh& named : quad_meshes()) {
      CAPTURE(named.name);
      const auto surface = random_surface<Rational>(dice, named.mesh);
      compare(dual_catmull_clark(), surface, 2);
      compare(catmull_clark(), surface, 2);
    }
  }

  TEST_CASE("C with ngon = classic makes it Catmull-Clark on every polygon mesh") {
    Dice dice(42);
    for (const NamedMesh& named : polygon_meshes()) {
      CAPTURE(named.name);
      compare(catmull_clark(), random_surface<Rational>(dice, named.mesh), 2);
    }
    for (int trial = 0; trial < 20; ++trial) {
      const Mesh mesh = random_mesh(dice);
      Surface<Rational> surface = random_surface<Rational>(dice, mesh);
      surface.tags = random_corners(dice, mesh, 3);
      CAPTURE(trial);
      compare(catmull_clark(), surface, 1);
    }
  }

  TEST_CASE("without it the edge points next to a face that is no quad differ by the known formula") {
    Dice dice(43);
    for (const NamedMesh& named : polygon_meshes()) {
      CAPTURE(named.name);
      const Mesh& mesh = named.mesh;
      const auto surface = random_surface<Rational>(dice, mesh);
      const Points<Rational>& p = surface.points;
      const auto fine = run(dual_catmull_clark(), surface, 1).points;
      Points<Rational> expected = catmull_clark_step(faces_of(mesh), p).points;
      const int first_face_point = mesh.vertices() + mesh.edges();
      for (int e = 0; e < mesh.edges(); ++e) {
        if (mesh.is_boundary_edge(e)) continue;
        const int h = mesh.edge_half[Mesh::i(e)], twin = mesh.twin[Mesh::i(h)];
        // (4 E + 2 (V1 + V2) + sum over both faces of 2 F + the two side midpoints)/16
        Points<Rational> sum = Rational(4) * (p.row(mesh.vertex[Mesh::i(h)]) + p.row(mesh.tip(h)));  // 4 E is 2 (V1 + V2)
        for (const int side : {h, twin}) {
          sum.row(0) += Rational(2) * expected.row(first_face_point + mesh.face[Mesh::i(side)]);
          for (const int other : {mesh.prev(side), mesh.next(side)})
            sum.row(0) += (p.row(mesh.vertex[Mesh::i(other)]) + p.row(mesh.tip(other))) / Rational(2);
        }
        const Points<Rational> point = sum / Rational(16);
        const bool quads = mesh.size(mesh.face[Mesh::i(h)]) == 4 && mesh.size(mesh.face[Mesh::i(twin)]) == 4;
        CHECK((point.row(0) == expected.row(mesh.vertices() + e)) == quads);
        expected.row(mesh.vertices() + e) = point.row(0);
      }
      CHECK(fine == expected);
    }
  }

  TEST_CASE("from the second round on it is Catmull-Clark of the first") {
    Dice dice(44);
    for (const NamedMesh& named : polygon_meshes()) {
      CAPTURE(named.name);
      compare(dual_catmull_clark(), run(dual_catmull_clark(), random_surface<Rational>(dice, named.mesh), 1), 1);
    }
  }
}
