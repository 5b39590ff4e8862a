// make_mesh: the half-edge identities, an oracle that finds twins by a map, and every error text.
#include "operators/mesh.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <random>

using udcp::make_mesh;
using udcp::Mesh;
using udcp::MeshError;
using Faces = std::vector<std::vector<int>>;

namespace {

const Faces cube{{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};

/// nx by ny quads without those in `holes`; unused vertices are dropped.
std::pair<int, Faces> grid(int nx, int ny, const std::vector<int>& holes = {}) {
  Faces faces;
  std::map<int, int> index;
  for (int f = 0; f < nx * ny; ++f) {
    if (std::ranges::find(holes, f) != holes.end()) continue;
    const int v = f / nx * (nx + 1) + f % nx;
    faces.emplace_back();
    for (const int corner : {v, v + 1, v + nx + 2, v + nx + 1}) {
      faces.back().push_back(index.try_emplace(corner, static_cast<int>(index.size())).first->second);
    }
  }
  return {static_cast<int>(index.size()), faces};
}

void check_identities(const Mesh& mesh) {
  std::vector<int> leaving(mesh.outgoing.size(), 0), boundary(mesh.outgoing.size(), 0);
  std::map<std::pair<int, int>, int> directed;
  for (int h = 0; h < mesh.half_edges(); ++h) directed[{mesh.vertex[Mesh::i(h)], mesh.tip(h)}] = h;
  int next_edge = 0;
  for (int h = 0; h < mesh.half_edges(); ++h) {
    CAPTURE(h);
    const int v = mesh.vertex[Mesh::i(h)], twin = mesh.twin[Mesh::i(h)], e = mesh.edge[Mesh::i(h)];
    ++leaving[Mesh::i(v)];
    CHECK(mesh.next(mesh.prev(h)) == h);
    CHECK(mesh.prev(mesh.next(h)) == h);
    CHECK(mesh.face[Mesh::i(mesh.next(h))] == mesh.face[Mesh::i(h)]);
    const auto found = directed.find({mesh.tip(h), v});
    CHECK(twin == (found == directed.end() ? -1 : found->second));
    if (twin < 0 || twin > h) {
      CHECK(e == next_edge++);
      CHECK(mesh.edge_half[Mesh::i(e)] == h);
    } else {
      CHECK(e == mesh.edge[Mesh::i(twin)]);
    }
    if (twin < 0) {
      ++boundary[Mesh::i(v)];
      CHECK(mesh.outgoing[Mesh::i(v)] == h);
      CHECK(mesh.is_boundary_edge(e));
      CHECK(mesh.vertex[Mesh::i(mesh.next(mesh.boundary_arrival(v)))] == v);
      CHECK(mesh.twin[Mesh::i(mesh.boundary_arrival(v))] == -1);
    }
  }
  CHECK(mesh.edges() == next_edge);
  for (int v = 0; v < mesh.vertices(); ++v) {
    CAPTURE(v);
    const int first = mesh.outgoing[Mesh::i(v)];
    CHECK(mesh.vertex[Mesh::i(first)] == v);
    CHECK(mesh.on_boundary(v) == (boundary[Mesh::i(v)] == 1));
    CHECK(mesh.valence(v) == leaving[Mesh::i(v)] + boundary[Mesh::i(v)]);
    if (!mesh.on_boundary(v)) CHECK(first == std::ranges::find(mesh.vertex, v) - mesh.vertex.begin());
    int met = 0, h = first;
    do {
      ++met;
      h = mesh.around(h);
    } while (h >= 0 && h != first);
    CHECK(met == leaving[Mesh::i(v)]);
  }
}

/// The error of a list of faces as "code: message (help)".
std::string refusal(int vertices, const Faces& faces, int first_index = 0) {
  try {
    std::vector<int> begin{0}, corners;
    for (const auto& face : faces) {
      corners.insert(corners.end(), face.begin(), face.end());
      begin.push_back(static_cast<int>(corners.size()));
    }
    make_mesh(vertices, begin, corners, first_index);
  } catch (const MeshError& error) {
    CHECK(error.kind == udcp::ErrorKind::input);
    return error.code + ": " + error.what() + " (" + error.help + ")";
  }
  return "accepted";
}

}  // namespace

TEST_SUITE("operators") {
  TEST_CASE("a cube has the half-edges of a cube") {
    const Mesh mesh = make_mesh(8, cube);
    check_identities(mesh);
    CHECK(mesh.vertices() - mesh.edges() + mesh.faces() == 2);
    CHECK(std::ranges::all_of(mesh.valences, [](int n) { return n == 3; }));
    CHECK(std::ranges::count(mesh.twin, -1) == 0);
    CHECK(mesh.all_faces_have(4));
    CHECK_FALSE(mesh.all_faces_have(3));
    CHECK(std::ranges::equal(mesh.corners(2), cube[2]));
  }

  TEST_CASE("an open grid has one boundary loop and Euler number 1") {
    const auto [vertices, faces] = grid(5, 4);
    const Mesh mesh = make_mesh(vertices, faces);
    check_identities(mesh);
    CHECK(mesh.vertices() - mesh.edges() + mesh.faces() == 1);
    const int start = mesh.vertex[static_cast<std::size_t>(std::ranges::find(mesh.twin, -1) - mesh.twin.begin())];
    int steps = 0, v = start;
    do {
      v = mesh.tip(mesh.outgoing[Mesh::i(v)]);
      ++steps;
    } while (v != start);
    CHECK(steps == 18);
  }

  TEST_CASE("random grids with holes agree with a map of directed edges") {
    std::mt19937 random(1);
    int accepted = 0;
    for (int trial = 0; trial < 60; ++trial) {
      CAPTURE(trial);
      std::vector<int> holes(static_cast<std::size_t>(trial % 6));
      for (int& hole : holes) hole = static_cast<int>(random() % 30);
      auto [vertices, faces] = grid(6, 5, holes);
      std::ranges::shuffle(faces, random);
      for (auto& face : faces) std::rotate(face.begin(), face.begin() + random() % 4, face.end());
      const std::string answer = refusal(vertices, faces);
      if (answer != "accepted") {  // holes that touch in a corner leave two fans there
        CHECK(answer.starts_with("E_VERTEX_FANS"));
        continue;
      }
      ++accepted;
      check_identities(make_mesh(vertices, faces));
    }
    CHECK(accepted > 20);
  }

  TEST_CASE("a pillow of two quads is closed and every vertex has valence 2") {
    const Mesh mesh = make_mesh(4, Faces{{0, 1, 2, 3}, {3, 2, 1, 0}});
    check_identities(mesh);
    CHECK(mesh.edges() == 4);
    CHECK(std::ranges::count(mesh.twin, -1) == 0);
    CHECK(mesh.valences == std::vector<int>{2, 2, 2, 2});
  }

  TEST_CASE("a fan of many triangles is matched in linear time") {
    const int n = 300000;
    std::vector<int> begin{0}, corners;
    for (int k = 0; k < n; ++k) {
      corners.insert(corners.end(), {0, 1 + k, 1 + (k + 1) % n});
      begin.push_back(3 * k + 3);
    }
    const Mesh mesh = make_mesh(n + 1, begin, corners);
    CHECK(mesh.valence(0) == n);
    CHECK(mesh.valence(n) == 3);
    CHECK(mesh.edges() == 2 * n);
  }

  TEST_CASE("faces with bad corners are refused by name") {
    CHECK(refusal(3, {}) == "E_NO_FACES: the mesh has no face (a mesh needs at least one face of three corners)");
    CHECK(refusal(8, {{0, 1, 2}, {0, 2, 8}}) ==
          "E_INDEX: face 1 names vertex 8, but there are 8 vertices (0 to 7) (correct the index or add the vertex)");
    CHECK(refusal(8, {{0, 1, 2}, {0, 2, 8}}, 1) ==
          "E_INDEX: face 2 names vertex 9, but there are 8 vertices (1 to 8) (correct the index or add the vertex)");
    CHECK(refusal(3, {{0, 1, -1}}) ==
          "E_INDEX: face 0 names vertex -1, but there are 3 vertices (0 to 2) (correct the index or add the vertex)");
    CHECK(refusal(0, {{0, 1, 2}}) ==
          "E_INDEX: face 0 names vertex 0, but there are no vertices (correct the index or add the vertex)");
    CHECK(refusal(3, {{0, 1, 2}, {0, 1}}) == "E_FACE_SIZE: face 1 has 2 corners; faces need at least three (remove the face)");
    CHECK(refusal(3, {{0, 1, 2}, {0}}) == "E_FACE_SIZE: face 1 has 1 corner; faces need at least three (remove the face)");
    CHECK(refusal(5, {{0, 1, 2, 1, 4}}) ==
          "E_FACE_REPEATS: face 0 repeats vertex 1; faces need distinct vertices (remove the repeated corner, or split the face "
          "where it "
          "meets itself)");
  }

  TEST_CASE("a face given twice is refused however it is turned") {
    const std::string answer =
        "E_DUPLICATE_FACE: face 6 has the same vertices as face 0; each face may be given once (remove one of the two)";
    for (const auto& copy : Faces{{0, 3, 2, 1}, {2, 1, 0, 3}, {1, 2, 3, 0}, {0, 1, 2, 3}}) {
      Faces faces = cube;
      faces.push_back(copy);
      CHECK(refusal(8, faces) == answer);
    }
    CHECK(refusal(3, {{0, 1, 2}, {1, 2, 0}}) ==
          "E_DUPLICATE_FACE: face 1 has the same vertices as face 0; each face may be given once (remove one of the two)");
    CHECK(refusal(3, {{0, 1, 2}, {2, 1, 0}}) == "accepted");
    CHECK(refusal(4, {{0, 1, 2, 3}, {0, 2, 1, 3}})
              .starts_with("E_NOT_ORIENTABLE"));  // the same set in another order is another face
  }

  TEST_CASE("an edge with three faces is refused by name") {
    CHECK(refusal(5, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}, 1) ==
          "E_EDGE_FACES: edge 1-2 has 3 faces (1, 2, 3); an edge may have at most two (separate the sheets that meet there)");
    CHECK(refusal(7, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}, {1, 0, 5}, {0, 1, 6}}) ==
          "E_EDGE_FACES: edge 0-1 has 5 faces (0, 1, 2, 3, ...); an edge may have at most two (separate the sheets that meet "
          "there)");
  }

  TEST_CASE("a turned face is told from a surface that is not orientable") {
    Faces faces = cube;
    std::ranges::reverse(faces[4]);
    CHECK(refusal(8, faces) ==
          "E_ORIENTATION: face 0 and face 4 run along edge 2-3 in the same direction; neighbours must run along it in opposite "
          "directions "
          "(turn one of them round: write the corners of face 4 in reverse order)");
    std::ranges::reverse(faces[1]);
    const std::string two = refusal(8, faces);
    CHECK(two.find("(turn 2 faces round, face 1 first: write their corners in reverse order)") != std::string::npos);
    Faces strip;
    for (int k = 0; k < 4; ++k) strip.push_back({2 * k, 2 * k + 2, 2 * k + 3, 2 * k + 1});
    strip.push_back({8, 1, 0, 9});  // closes with half a turn
    const std::string answer = refusal(10, strip);
    CHECK(answer.starts_with("E_NOT_ORIENTABLE: the surface is not orientable: no choice of orientations makes its faces agree"));
  }

  TEST_CASE("the faces that the help names mend the orientation") {
    std::mt19937 random(2);
    auto [vertices, faces] = grid(4, 4);
    for (int trial = 0; trial < 16; ++trial) {
      Faces turned = faces;
      auto& face = turned[static_cast<std::size_t>(trial)];
      std::ranges::reverse(face);
      const std::string answer = refusal(vertices, turned);
      CAPTURE(answer);
      CHECK(answer.starts_with("E_ORIENTATION"));
      CHECK(answer.find("corners of face " + std::to_string(trial) + " in reverse") != std::string::npos);
      std::ranges::reverse(face);
      CHECK(refusal(vertices, turned) == "accepted");
    }
  }

  TEST_CASE("fans that meet in a vertex and vertices without a face are refused by name") {
    CHECK(refusal(5, {{0, 1, 2}, {0, 3, 4}}) ==
          "E_VERTEX_FANS: several fans of faces meet in vertex 0: face 1 reaches only 1 of its 2 faces across edges "
          "(give each fan a vertex of its own)");
    CHECK(refusal(4, {{0, 1, 3}}) == "E_ISOLATED: vertex 2 is used by no face (remove vertices that no face uses)");
    CHECK(refusal(6, {{0, 1, 3}}, 1) ==
          "E_ISOLATED: vertex 3 (and 2 more) is used by no face (remove vertices that no face uses)");
  }

  TEST_CASE("errors come in order of priority") {
    CHECK(refusal(3, {{0, 0, 1}, {0, 1, 9}}).starts_with("E_INDEX"));
    CHECK(refusal(3, {{0, 0, 1}, {0, 1}}).starts_with("E_FACE_SIZE"));
    CHECK(refusal(5, {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}, {1, 2, 0}}).starts_with("E_DUPLICATE_FACE"));
    CHECK(refusal(6, {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}}).starts_with("E_EDGE_FACES"));
    CHECK(refusal(6, {{0, 1, 2}, {0, 1, 3}, {0, 4, 5}}).starts_with("E_ORIENTATION"));
  }

  TEST_CASE("offsets that do not fit the corners are our own mistake") {
    CHECK_THROWS_AS(make_mesh(3, std::vector<int>{0, 4}, std::vector<int>{0, 1, 2}), udcp::Error);
    CHECK_THROWS_AS(make_mesh(3, std::vector<int>{}, std::vector<int>{}), udcp::Error);
  }
}
