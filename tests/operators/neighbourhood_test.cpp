// Neighbourhoods: the faces of the original within the rings, and equal signatures where things look the same.
#include "operators/neighbourhood.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>

#include "tests/oracle/inputs.h"

using namespace udcp;
using namespace udcp::oracle;

namespace {

std::vector<int> cycle(std::vector<int> face) {
  std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
  return face;
}

// Faces that touch a vertex at most rings - 1 faces away from v.
std::set<std::vector<int>> faces_within(const Mesh& mesh, int v, int rings) {
  std::set<int> vertices{v};
  std::set<std::vector<int>> result;
  for (int ring = 0; ring < rings; ++ring) {
    std::set<int> next = vertices;
    for (const auto& face : faces_of(mesh)) {
      if (std::none_of(face.begin(), face.end(), [&](int u) { return vertices.contains(u); })) continue;
      result.insert(cycle(face));
      next.insert(face.begin(), face.end());
    }
    vertices = next;
  }
  return result;
}

Neighbourhood around(const Mesh& mesh, const Tags& tags, int v, int rings) {
  return neighbourhood(mesh, tags, mesh.outgoing[Mesh::i(v)], rings);
}

}  // namespace

TEST_SUITE("operators") {
  TEST_CASE("a neighbourhood holds exactly the faces within its rings") {
    for (const auto& list : {quad_meshes(), polygon_meshes(), triangle_meshes()}) {
      for (const NamedMesh& named : list) {
        for (int v = 0; v < named.mesh.vertices(); ++v) {
          for (int rings = 1; rings <= 2; ++rings) {
            CAPTURE(named.name);
            CAPTURE(v);
            CAPTURE(rings);
            const Neighbourhood local = around(named.mesh, {}, v, rings);
            CHECK(local.vertex[0] == v);
            CHECK(local.mesh.corners(0)[0] == 0);
            std::set<std::vector<int>> found;
            for (auto face : faces_of(local.mesh)) {
              for (int& u : face) u = local.vertex[Mesh::i(u)];
              found.insert(cycle(face));
            }
            CHECK(found == faces_within(named.mesh, v, rings));
            CHECK(static_cast<int>(found.size()) == local.mesh.faces());
            CHECK(local.mesh.valence(0) == named.mesh.valence(v));
            CHECK(local.mesh.on_boundary(0) == named.mesh.on_boundary(v));
          }
        }
      }
    }
  }

  TEST_CASE("signatures are equal where the meshes look the same and differ elsewhere") {
    const Mesh torus_mesh = *torus<double>(9, 8, 2, 1).mesh;
    const auto first = around(torus_mesh, {}, 0, 2);
    for (int v = 1; v < torus_mesh.vertices(); ++v) CHECK(around(torus_mesh, {}, v, 2).signature == first.signature);
    const Mesh box = *cube<Rational>().mesh;
    for (int v = 1; v < 8; ++v) CHECK(around(box, {}, v, 1).signature == around(box, {}, 0, 1).signature);
    const Mesh board = *grid<Rational>(6, 6).mesh;
    CHECK(around(board, {}, 24, 2).signature == first.signature);
    CHECK(around(board, {}, 17, 3).signature != around(torus_mesh, {}, 0, 3).signature);  // the boundary comes into view
    CHECK(around(board, {}, 0, 1).signature != around(board, {}, 1, 1).signature);
    CHECK(around(board, {}, 2, 1).signature == around(board, {}, 3, 1).signature);
  }

  TEST_CASE("corners and tags count and a boundary is told from a rim") {
    const Mesh board = *grid<Rational>(2, 2).mesh, larger = *grid<Rational>(4, 4).mesh;
    CHECK(around(board, {}, 4, 1).signature == around(larger, {}, 12, 1).signature);  // the rim of one ring may be anything
    CHECK(around(board, {}, 4, 2).signature != around(larger, {}, 12, 2).signature);
    Tags tags;
    tags.corner.assign(9, 0);
    tags.corner[0] = 1;
    CHECK(around(board, tags, 4, 1).signature != around(board, {}, 4, 1).signature);
    CHECK(around(board, tags, 4, 1).tags.corner.size() == 9);
    Tags edges;
    edges.edge.assign(Mesh::i(board.edges()), EdgeTag::none);
    const auto untagged = around(board, edges, 4, 1).signature;
    edges.edge[3] = EdgeTag::latitude;
    CHECK(around(board, edges, 4, 1).signature != untagged);
  }
}
