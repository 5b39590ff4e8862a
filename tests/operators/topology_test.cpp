// Split and dual in closed form against make_mesh of their own face lists; numbering; tags.
#include "operators/topology.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "operators/run.h"
#include "tests/oracle/inputs.h"
#include "tests/oracle/refusal.h"
#include "tests/oracle/words.h"

using namespace udcp;
using namespace udcp::oracle;

namespace {

void check_same(const Mesh& mesh, const Mesh& expected) {
  CHECK(mesh.face_begin == expected.face_begin);
  CHECK(mesh.vertex == expected.vertex);
  CHECK(mesh.twin == expected.twin);
  CHECK(mesh.edge == expected.edge);
  CHECK(mesh.face == expected.face);
  CHECK(mesh.edge_half == expected.edge_half);
  CHECK(mesh.outgoing == expected.outgoing);
  CHECK(mesh.valences == expected.valences);
}

// The arrays of a mesh against those that make_mesh finds from its faces, twins by search.
void check_connectivity(const Mesh& mesh) { check_same(mesh, make_mesh(mesh.vertices(), faces_of(mesh))); }

// The s-th new point from a on the edge a b, of d - 1.
int point_on_edge(const Mesh& mesh, int d, int a, int b, int s) {
  for (int e = 0; e < mesh.edges(); ++e) {
    const int h = mesh.edge_half[Mesh::i(e)], from = mesh.vertex[Mesh::i(h)], to = mesh.tip(h),
              first = mesh.vertices() + (d - 1) * e;
    if (from == a && to == b) return first + s - 1;
    if (from == b && to == a) return first + (d - s) - 1;
  }
  throw std::logic_error("no such edge");
}

// Vertices at the places (x, y) of face f under U[d]: f[0] at (0, 0), f[1] at (d, 0), the last corner at (0, d).
std::map<std::pair<int, int>, int> places_in_face(const Mesh& mesh, int f, int d) {
  const auto c = mesh.corners(f);
  const bool triangle = c.size() == 3;
  std::map<std::pair<int, int>, int> place;
  int inner = mesh.vertices() + (d - 1) * mesh.edges() + (triangle ? (d - 1) * (d - 2) / 2 : (d - 1) * (d - 1)) * f;
  for (int y = 1; y < d; ++y)
    for (int x = 1; x < (triangle ? d - y : d); ++x) place[{x, y}] = inner++;
  const auto side = [&](std::size_t k, int s) {  // s steps along the side from corner k
    const int a = c[k], b = c[(k + 1) % c.size()];
    return s == 0 ? a : point_on_edge(mesh, d, a, b, s);
  };
  for (int s = 0; s < d; ++s) {
    place[{s, 0}] = side(0, s);
    place[triangle ? std::pair{d - s, s} : std::pair{d, s}] = side(1, s);
    place[triangle ? std::pair{0, d - s} : std::pair{d - s, d}] = side(2, s);
    if (!triangle) place[{0, d - s}] = side(3, s);
  }
  return place;
}

Faces grid_by_hand(const Mesh& mesh, int f, int d) {
  const auto place = places_in_face(mesh, f, d);
  const auto at = [&](int x, int y) { return place.at({x, y}); };
  const bool triangle = mesh.size(f) == 3;
  Faces result;
  for (int y = 0; y < d; ++y) {
    for (int x = 0; x < (triangle ? d - y : d); ++x) {
      if (!triangle) result.push_back({at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)});
      if (triangle) result.push_back({at(x, y), at(x + 1, y), at(x, y + 1)});
      if (triangle && x + y < d - 1) result.push_back({at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)});
    }
  }
  return result;
}

// The faces of U[d] as the specification lists them.
Faces split_by_hand(const Mesh& mesh, int d, bool triangles) {
  Faces result;
  for (int f = 0; f < mesh.faces(); ++f) {
    const auto c = mesh.corners(f);
    const auto middle = [&](int a, int b) { return point_on_edge(mesh, 2, a, b, 1); };
    if (d > 2) {
      for (const auto& face : grid_by_hand(mesh, f, d)) result.push_back(face);
    } else if (triangles) {
      const int ab = middle(c[0], c[1]), bc = middle(c[1], c[2]), ca = middle(c[2], c[0]);
      for (const auto& face : Faces{{c[0], ab, ca}, {c[1], bc, ab}, {c[2], ca, bc}, {ab, bc, ca}}) result.push_back(face);
    } else {
      for (std::size_t j = 0; j < c.size(); ++j) {
        const int before = c[(j + c.size() - 1) % c.size()], after = c[(j + 1) % c.size()];
        result.push_back({c[j], middle(c[j], after), mesh.vertices() + mesh.edges() + f, middle(before, c[j])});
      }
    }
  }
  return result;
}

void check_split(const Mesh& mesh, int d, bool triangles) {
  CAPTURE(d);
  const Mesh fine = split_mesh(mesh, {d, triangles});
  check_connectivity(fine);
  CHECK(faces_of(fine) == split_by_hand(mesh, d, triangles));
  const Origin origin = origin_of_split(mesh, {d, triangles});
  CHECK(origin.old_vertices == mesh.vertices());
  CHECK(origin.edge_points == (d - 1) * mesh.edges());
}

// The faces of the dual as the specification lists them.
Faces dual_by_hand(const Mesh& mesh, const Tags& tags) {
  std::map<int, int> row;  // boundary edges
  int rows = mesh.faces();
  for (int e = 0; e < mesh.edges(); ++e)
    if (mesh.is_boundary_edge(e)) row[e] = rows++;
  Faces result;
  for (int v = 0; v < mesh.vertices(); ++v) {
    std::vector<int> face;
    int start = -1;  // lowest half-edge that leaves v, or the boundary one
    for (int h = 0; h < mesh.half_edges(); ++h)
      if (mesh.vertex[Mesh::i(h)] == v && (start < 0 || mesh.twin[Mesh::i(h)] < 0)) start = h;
    const bool boundary = mesh.twin[Mesh::i(start)] < 0;
    if (boundary) face.push_back(row.at(mesh.edge[Mesh::i(start)]));
    for (int h = start;;) {
      face.push_back(mesh.face[Mesh::i(h)]);
      const int arriving = mesh.prev(h);
      h = mesh.twin[Mesh::i(arriving)];
      if (h == start) break;
      if (h < 0) {
        face.push_back(row.at(mesh.edge[Mesh::i(arriving)]));
        break;
      }
    }
    if (tags.is_corner(v)) face.push_back(rows++);
    result.push_back(face);
  }
  return result;
}

std::vector<int> cycle(std::vector<int> face) {
  std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
  return face;
}

EdgeTag tag_between(const Mesh& mesh, const Tags& tags, int a, int b) {
  for (int e = 0; e < mesh.edges(); ++e) {
    const int h = mesh.edge_half[Mesh::i(e)], from = mesh.vertex[Mesh::i(h)], to = mesh.tip(h);
    if (std::minmax(from, to) == std::minmax(a, b)) return tags.of_edge(e);
  }
  throw std::logic_error("no such edge");
}

}  // namespace

TEST_SUITE("operators") {
  TEST_CASE("U splits every mesh as listed and its arrays are those of make_mesh") {
    for (const auto& list : {quad_meshes(), polygon_meshes()}) {
      for (const NamedMesh& named : list) {
        CAPTURE(named.name);
        check_split(named.mesh, 2, false);
        if (named.mesh.all_faces_have(4))
          for (const int d : {3, 4}) check_split(named.mesh, d, false);
      }
    }
    for (const NamedMesh& named : triangle_meshes()) {
      CAPTURE(named.name);
      for (const int d : {2, 3, 4}) check_split(named.mesh, d, true);
    }
    Dice dice(71);
    for (int trial = 0; trial < 40; ++trial) {
      CAPTURE(trial);
      check_split(random_mesh(dice), 2, false);
      check_split(random_mesh(dice, true), 3, false);
    }
  }

  TEST_CASE("the dual of every mesh is as listed and its arrays are those of make_mesh") {
    Dice dice(72);
    for (const auto& list : {quad_meshes(), polygon_meshes(), triangle_meshes()}) {
      for (const NamedMesh& named : list) {
        CAPTURE(named.name);
        const Tags tags = random_corners(dice, named.mesh, 2);
        const DualMesh dual = dual_mesh(named.mesh, tags);
        CHECK(faces_of(dual.mesh) == dual_by_hand(named.mesh, tags));
        CHECK(dual.mesh.vertices() == dual_rows(named.mesh, tags));
        check_connectivity(dual.mesh);
        CHECK(std::count(dual.tags.corner.begin(), dual.tags.corner.end(), 1) ==
              std::count(tags.corner.begin(), tags.corner.end(), 1));
      }
    }
    for (int trial = 0; trial < 60; ++trial) {
      CAPTURE(trial);
      const Mesh mesh = random_mesh(dice);
      const Tags tags = random_corners(dice, mesh, 3);
      const DualMesh dual = dual_mesh(mesh, tags);
      CHECK(faces_of(dual.mesh) == dual_by_hand(mesh, tags));
      check_connectivity(dual.mesh);
    }
  }

  TEST_CASE("the dual of the dual of a closed mesh is the same mesh") {
    for (const auto& list : {quad_meshes(), polygon_meshes(), triangle_meshes()}) {
      for (const NamedMesh& named : list) {
        const Mesh& mesh = named.mesh;
        if (std::count(mesh.twin.begin(), mesh.twin.end(), -1) > 0) continue;
        CAPTURE(named.name);
        const Mesh twice = dual_mesh(dual_mesh(mesh, {}).mesh, {}).mesh;
        CHECK(twice.vertices() == mesh.vertices());
        CHECK(twice.edges() == mesh.edges());
        REQUIRE(twice.faces() == mesh.faces());
        // vertices of the first dual are faces, so face f of the second is face f, turned
        const Faces a = faces_of(mesh), b = faces_of(twice);
        for (std::size_t f = 0; f < a.size(); ++f) CHECK(cycle(a[f]) == cycle(b[f]));
      }
    }
  }

  TEST_CASE("children keep the tag of their edge and edges into faces get the opposite one") {
    Surface<Rational> surface = grid<Rational>(2, 1);
    surface.tags.edge.assign(Mesh::i(surface.mesh->edges()), EdgeTag::none);
    surface.tags.edge[0] = EdgeTag::latitude;   // 0-1
    surface.tags.edge[1] = EdgeTag::longitude;  // 1-4
    surface.tags.corner = {1, 0, 0, 0, 0, 1};
    const Mesh fine = split_mesh(*surface.mesh, {});
    const Tags tags = split_tags(*surface.mesh, surface.tags, fine, {});
    const int v = surface.mesh->vertices(), face = v + surface.mesh->edges();
    CHECK(tag_between(fine, tags, 0, v) == EdgeTag::latitude);
    CHECK(tag_between(fine, tags, v, 1) == EdgeTag::latitude);
    CHECK(tag_between(fine, tags, v, face) == EdgeTag::longitude);
    CHECK(tag_between(fine, tags, v + 1, face) == EdgeTag::latitude);
    CHECK(tag_between(fine, tags, v + 1, face + 1) == EdgeTag::latitude);
    CHECK(tag_between(fine, tags, v + 2, face) == EdgeTag::none);
    std::vector<char> corners(Mesh::i(fine.vertices()), 0);
    corners[0] = corners[5] = 1;
    CHECK(tags.corner == corners);
  }

  TEST_CASE("U[3] hands tags to all three children and to the parallel inner edges") {
    const Surface<double> shape = tube<double>(4, Points<double>::Ones(2, 2));
    const Mesh& mesh = *shape.mesh;
    const Mesh fine = split_mesh(mesh, {3, false});
    const Tags tags = split_tags(mesh, shape.tags, fine, {3, false});
    int latitudes = 0, longitudes = 0;
    for (const EdgeTag tag : tags.edge) tag == EdgeTag::latitude ? ++latitudes : ++longitudes;
    CHECK(latitudes == 12 * 4);   // 4 rings of 12
    CHECK(longitudes == 12 * 3);  // 12 spokes of 3
    const int a = mesh.vertex[0], inner = mesh.vertices() + 2 * mesh.edges();
    CHECK(tag_between(fine, tags, a, mesh.vertices()) == EdgeTag::latitude);
    CHECK(tag_between(fine, tags, mesh.vertices(), mesh.vertices() + 1) == EdgeTag::latitude);
    CHECK(tag_between(fine, tags, mesh.vertices(), inner) == EdgeTag::longitude);
    CHECK(tag_between(fine, tags, inner, inner + 1) == EdgeTag::latitude);
    // a face that is not tagged alternately: its inner edges have none
    Tags other = shape.tags;
    other.edge[0] = EdgeTag::none;
    CHECK(tag_between(fine, split_tags(mesh, other, fine, {3, false}), inner, inner + 1) == EdgeTag::none);
  }

  TEST_CASE("on triangles all children of a tagged edge are tagged and nothing else") {
    const Mesh mesh = make_mesh(4, Faces{{0, 1, 2}, {2, 1, 3}});
    Tags tags;
    tags.edge.assign(5, EdgeTag::none);
    tags.edge[1] = EdgeTag::latitude;  // 1-2, between the two
    for (const int d : {2, 3, 4}) {
      CAPTURE(d);
      const Mesh fine = split_mesh(mesh, {d, true});
      const Tags found = split_tags(mesh, tags, fine, {d, true});
      std::vector<int> path{1};
      for (int s = 0; s < d - 1; ++s) path.push_back(4 + (d - 1) * 1 + s);
      path.push_back(2);
      for (int s = 0; s < d; ++s) CHECK(tag_between(fine, found, path[Mesh::i(s)], path[Mesh::i(s + 1)]) == EdgeTag::latitude);
      CHECK(std::count(found.edge.begin(), found.edge.end(), EdgeTag::latitude) == d);
    }
  }

  TEST_CASE("dual edges get the opposite tag and boundary ones the common tag") {
    Surface<Rational> surface = grid<Rational>(2, 1);
    surface.tags.edge.assign(Mesh::i(surface.mesh->edges()), EdgeTag::none);
    const auto edge_of = [&](int a, int b) {
      for (int e = 0;; ++e) {
        const int h = surface.mesh->edge_half[Mesh::i(e)];
        if (std::minmax({surface.mesh->vertex[Mesh::i(h)], surface.mesh->tip(h)}) == std::minmax({a, b})) return e;
      }
    };
    for (const auto& [a, b] : {std::pair{0, 1}, {1, 2}}) surface.tags.edge[Mesh::i(edge_of(a, b))] = EdgeTag::latitude;
    surface.tags.edge[Mesh::i(edge_of(1, 4))] = EdgeTag::longitude;
    surface.tags.edge[Mesh::i(edge_of(2, 5))] = EdgeTag::longitude;
    surface.tags.corner = {0, 0, 1, 0, 0, 0};
    const DualMesh dual = dual_mesh(*surface.mesh, surface.tags);
    std::map<int, int> row;
    int next = 2;
    for (int e = 0; e < surface.mesh->edges(); ++e)
      if (surface.mesh->is_boundary_edge(e)) row[e] = next++;
    const int corner = next;
    CHECK(tag_between(dual.mesh, dual.tags, 0, 1) == EdgeTag::latitude);                                          // crosses 1-4
    CHECK(tag_between(dual.mesh, dual.tags, 0, row.at(edge_of(0, 1))) == EdgeTag::longitude);                     // crosses 0-1
    CHECK(tag_between(dual.mesh, dual.tags, row.at(edge_of(0, 1)), row.at(edge_of(1, 2))) == EdgeTag::latitude);  // past 1
    CHECK(tag_between(dual.mesh, dual.tags, row.at(edge_of(0, 3)), row.at(edge_of(0, 1))) == EdgeTag::none);      // past 0
    CHECK(tag_between(dual.mesh, dual.tags, corner, row.at(edge_of(1, 2))) == EdgeTag::latitude);
    CHECK(tag_between(dual.mesh, dual.tags, corner, row.at(edge_of(2, 5))) == EdgeTag::longitude);
    CHECK(dual.tags.corner[Mesh::i(corner)] == 1);
  }

  TEST_CASE("what cannot be split or has no dual is named") {
    CHECK(refusal([] { split_mesh(prism(5), {3, false}); }) == "E_USPLIT: face 0 has 5 corners; U[3] splits quads only");
    CHECK(refusal([] {
            split_mesh(*cube<Rational>().mesh, {2, true});
          }) == "E_NOT_TRIANGLES: face 0 has 4 corners; a word `on triangles` needs a mesh of triangles");
    CHECK(refusal([] {
            split_mesh(*grid<Rational>(200, 200).mesh, {1000, false});
          }) == "E_TOO_LARGE: splitting 40000 faces gives 160000000000 half-edges; a mesh holds at most 2^30");
    const Mesh two = make_mesh(3, Faces{{0, 1, 2}, {2, 1, 0}});
    CHECK(refusal([&] { dual_mesh(two, {}); }) ==
          "E_VALENCE2: vertex 0 lies inside and has valence 2, so its face in the dual mesh would have two corners");
    Tags tags;
    tags.corner.assign(8, 0);
    tags.corner[5] = 1;
    CHECK(refusal([&] { dual_mesh(*cube<Rational>().mesh, tags); }) ==
          "E_CORNER: vertex 5 is a corner inside the mesh; a dual mesh has corners on its boundary only");
  }
}
