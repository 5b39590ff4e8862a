// The split of U in closed formulas on half-edges, and the dual of D. Integers only.
#include "operators/topology.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "operators/error.h"
#include "operators/huge_pages.h"

namespace udcp {
namespace {

std::size_t at(int k) { return Mesh::i(k); }

void check_size(const Mesh& mesh, std::int64_t half_edges) {
  if (half_edges > std::numeric_limits<int>::max() / 2) {
    throw Error(ErrorKind::limit, "E_TOO_LARGE",
                "splitting " + std::to_string(mesh.faces()) + " faces gives " + std::to_string(half_edges) +
                    " half-edges; a mesh holds at most 2^30",
                "apply fewer rounds");
  }
}

// next and prev of a mesh: in general, and by arithmetic where all faces have n corners.
struct AnyFaces {
  const Mesh& mesh;
  [[nodiscard]] int next(int h) const { return mesh.next(h); }
  [[nodiscard]] int prev(int h) const { return mesh.prev(h); }
};
template <int n>
struct EqualFaces {
  [[nodiscard]] static int next(int h) { return h % n == n - 1 ? h - (n - 1) : h + 1; }
  [[nodiscard]] static int prev(int h) { return h % n == 0 ? h + (n - 1) : h - 1; }
};

// The mesh of a split, written half-edge by half-edge in their order; edges get their numbers when they first appear.
class FineMesh {
 public:
  FineMesh(int corners, int faces, int edges, int vertices) {
    for (std::vector<int>* column : {&mesh_.vertex, &mesh_.twin, &mesh_.edge, &mesh_.face})
      make(*column, at(corners) * at(faces));
    make(mesh_.edge_half, at(edges));
    make(mesh_.outgoing, at(vertices));
    make(mesh_.valences, at(vertices));
    make(mesh_.face_begin, at(faces) + 1);
    for (int f = 0; f <= faces; ++f) mesh_.face_begin[at(f)] = corners * f;
  }

  void half_edge(int face, int vertex, int twin) {
    const auto h = at(half_edges_);
    mesh_.face[h] = face;
    mesh_.vertex[h] = vertex;
    mesh_.twin[h] = twin;
    const bool known = twin >= 0 && twin < half_edges_;
    if (!known) mesh_.edge_half[at(edges_)] = half_edges_;
    mesh_.edge[h] = known ? mesh_.edge[at(twin)] : edges_++;
    ++half_edges_;
  }

  // The vertices, in their order too: the half-edge that Mesh::outgoing asks for.
  void vertex(int outgoing, int valence) {
    mesh_.outgoing[at(vertices_)] = outgoing;
    mesh_.valences[at(vertices_)] = valence;
    ++vertices_;
  }

  // The old vertices, then the points on edges. corner(h) is the half-edge that leaves the old vertex in the face at the corner
  // of h; the one after it leaves the point on h, and `last` places on is the one that arrives from the point on prev(h).
  template <class Faces, class Corner>
  void old_and_edge_vertices(const Mesh& mesh, Faces faces, Corner corner, int last, int valence_on_edges) {
    for (int v = 0; v < mesh.vertices(); ++v) vertex(corner(mesh.outgoing[at(v)]), mesh.valence(v));
    for (const int h : mesh.edge_half) {
      const int behind = corner(h) + 1, ahead = corner(faces.next(h)) + last;
      if (mesh.twin[at(h)] < 0) {
        vertex(ahead, valence_on_edges / 2 + 1);
      } else {
        vertex(std::min(behind, ahead), valence_on_edges);
      }
    }
  }

  Mesh mesh() { return std::move(mesh_); }

 private:
  static void make(std::vector<int>& column, std::size_t size) {
    column.reserve(size);
    prefer_huge_pages(column.data(), size * sizeof(int));
    column.resize(size);
  }

  Mesh mesh_;
  int half_edges_ = 0, edges_ = 0, vertices_ = 0;
};

// Every face of n corners into n quads; half-edge h becomes the quad at its corner, with half-edges 4h .. 4h+3:
// vertex -> edge point -> face point -> edge point of prev(h) -> vertex.
template <class Faces>
Mesh split_into_quads(const Mesh& mesh, Faces faces) {
  const int n = mesh.half_edges(), first_edge_point = mesh.vertices(), first_face_point = first_edge_point + mesh.edges();
  check_size(mesh, 4LL * n);
  FineMesh fine(4, n, 2 * mesh.edges() + n, first_face_point + mesh.faces());
  for (int h = 0; h < n; ++h) {
    const int prev = faces.prev(h), twin = mesh.twin[at(h)], twin_of_prev = mesh.twin[at(prev)];
    fine.half_edge(h, mesh.vertex[at(h)], twin < 0 ? -1 : 4 * faces.next(twin) + 3);
    fine.half_edge(h, first_edge_point + mesh.edge[at(h)], 4 * faces.next(h) + 2);
    fine.half_edge(h, first_face_point + mesh.face[at(h)], 4 * prev + 1);
    fine.half_edge(h, first_edge_point + mesh.edge[at(prev)], twin_of_prev < 0 ? -1 : 4 * twin_of_prev);
  }
  fine.old_and_edge_vertices(
      mesh, faces, [](int h) { return 4 * h; }, 3, 4);
  for (int f = 0; f < mesh.faces(); ++f) fine.vertex(4 * mesh.face_begin[at(f)] + 2, mesh.size(f));
  return fine.mesh();
}

// Every triangle (a, b, c) into (a, ab, ca), (b, bc, ab), (c, ca, bc), (ab, bc, ca): corner j of face f becomes face 4f + j, and
// the middle one is 4f + 3, its half-edge j leaving the point on half-edge j.
Mesh split_into_four_triangles(const Mesh& mesh) {
  const int n = mesh.half_edges(), first_edge_point = mesh.vertices();
  check_size(mesh, 4LL * n);
  const EqualFaces<3> faces;
  const auto corner = [](int h) { return 3 * (4 * (h / 3) + h % 3); };
  const auto middle = [](int h) { return 3 * (4 * (h / 3) + 3) + h % 3; };
  FineMesh fine(3, 4 * mesh.faces(), 2 * mesh.edges() + n, first_edge_point + mesh.edges());
  for (int f = 0; f < mesh.faces(); ++f) {
    for (int h = 3 * f; h < 3 * f + 3; ++h) {
      const int face = 4 * f + h % 3, prev = faces.prev(h), twin = mesh.twin[at(h)], twin_of_prev = mesh.twin[at(prev)];
      fine.half_edge(face, mesh.vertex[at(h)], twin < 0 ? -1 : corner(faces.next(twin)) + 2);
      fine.half_edge(face, first_edge_point + mesh.edge[at(h)], middle(prev));
      fine.half_edge(face, first_edge_point + mesh.edge[at(prev)], twin_of_prev < 0 ? -1 : corner(twin_of_prev));
    }
    for (int h = 3 * f; h < 3 * f + 3; ++h)
      fine.half_edge(4 * f + 3, first_edge_point + mesh.edge[at(h)], corner(faces.next(h)) + 1);
  }
  fine.old_and_edge_vertices(mesh, faces, corner, 2, 6);
  return fine.mesh();
}

// The s-th of the d - 1 points on half-edge h, counted from the vertex it leaves; the ends for s = 0 and s = d.
int point_on(const Mesh& mesh, int h, int s, int d) {
  if (s == 0) return mesh.vertex[at(h)];
  if (s == d) return mesh.tip(h);
  const int e = mesh.edge[at(h)];
  const bool along = mesh.edge_half[at(e)] == h;
  return mesh.vertices() + (d - 1) * e + (along ? s : d - s) - 1;
}

// Vertex at the grid place (x, y) of face f; places on the border belong to the half-edges.
int quad_place(const Mesh& mesh, int f, int x, int y, int d) {
  const int h = mesh.face_begin[at(f)];
  if (y == 0) return point_on(mesh, h, x, d);
  if (x == d) return point_on(mesh, h + 1, y, d);
  if (y == d) return point_on(mesh, h + 2, d - x, d);
  if (x == 0) return point_on(mesh, h + 3, d - y, d);
  return mesh.vertices() + (d - 1) * mesh.edges() + (d - 1) * (d - 1) * f + (y - 1) * (d - 1) + x - 1;
}

int triangle_place(const Mesh& mesh, int f, int x, int y, int d) {
  const int h = mesh.face_begin[at(f)];
  if (y == 0) return point_on(mesh, h, x, d);
  if (x + y == d) return point_on(mesh, h + 1, y, d);
  if (x == 0) return point_on(mesh, h + 2, d - y, d);
  const int row_begin = (y - 1) * (d - 1) - y * (y - 1) / 2;  // rows 1 .. y-1 hold d-2, d-3, ... inner points
  return mesh.vertices() + (d - 1) * mesh.edges() + (d - 1) * (d - 2) / 2 * f + row_begin + x - 1;
}

[[noreturn]] void cannot_split(const Mesh& mesh, int f, int d, const char* wanted) {
  throw Error(ErrorKind::input, "E_USPLIT",
              "face " + std::to_string(f) + " has " + std::to_string(mesh.size(f)) + " corners; U[" + std::to_string(d) +
                  "] splits " + wanted + " only",
              "apply U once first, or use U without a section number");
}

Mesh split_grid(const Mesh& mesh, int d) {
  check_size(mesh, 4LL * d * d * mesh.faces());
  std::vector<int> begin{0}, corners;
  begin.reserve(at(d * d * mesh.faces()) + 1);
  corners.reserve(4 * at(d * d * mesh.faces()));
  for (int f = 0; f < mesh.faces(); ++f) {
    if (mesh.size(f) != 4) cannot_split(mesh, f, d, "quads");
    for (int y = 0; y < d; ++y) {
      for (int x = 0; x < d; ++x) {
        for (const auto& [i, j] : {std::pair{x, y}, {x + 1, y}, {x + 1, y + 1}, {x, y + 1}})
          corners.push_back(quad_place(mesh, f, i, j, d));
        begin.push_back(static_cast<int>(corners.size()));
      }
    }
  }
  return make_mesh(mesh.vertices() + (d - 1) * mesh.edges() + (d - 1) * (d - 1) * mesh.faces(), std::move(begin),
                   std::move(corners));
}

Mesh split_triangle_grid(const Mesh& mesh, int d) {
  check_size(mesh, 3LL * d * d * mesh.faces());
  std::vector<int> begin{0}, corners;
  for (int f = 0; f < mesh.faces(); ++f) {
    const auto push = [&](std::initializer_list<std::pair<int, int>> places) {
      for (const auto& [i, j] : places) corners.push_back(triangle_place(mesh, f, i, j, d));
      begin.push_back(static_cast<int>(corners.size()));
    };
    for (int y = 0; y < d; ++y) {
      for (int x = 0; x + y < d; ++x) {
        push({{x, y}, {x + 1, y}, {x, y + 1}});
        if (x + y < d - 1) push({{x + 1, y}, {x + 1, y + 1}, {x, y + 1}});
      }
    }
  }
  return make_mesh(mesh.vertices() + (d - 1) * mesh.edges() + (d - 1) * (d - 2) / 2 * mesh.faces(), std::move(begin),
                   std::move(corners));
}

void require_triangles(const Mesh& mesh) {
  for (int f = 0; f < mesh.faces(); ++f) {
    if (mesh.size(f) == 3) continue;
    throw Error(ErrorKind::input, "E_NOT_TRIANGLES",
                "face " + std::to_string(f) + " has " + std::to_string(mesh.size(f)) +
                    " corners; a word `on triangles` needs a mesh of triangles",
                "triangulate(mesh) cuts the faces, or leave out `on triangles`");
  }
}

}  // namespace

EdgeTag opposite(EdgeTag tag) {
  if (tag == EdgeTag::longitude) return EdgeTag::latitude;
  if (tag == EdgeTag::latitude) return EdgeTag::longitude;
  return EdgeTag::none;
}

Origin origin_of_split(const Mesh& before, Split split) { return {before.vertices(), (split.sections - 1) * before.edges()}; }

Mesh split_mesh(const Mesh& mesh, Split split) {
  if (split.triangles) {
    require_triangles(mesh);
    return split.sections == 2 ? split_into_four_triangles(mesh) : split_triangle_grid(mesh, split.sections);
  }
  if (split.sections > 2) return split_grid(mesh, split.sections);
  return mesh.all_faces_have(4) ? split_into_quads(mesh, EqualFaces<4>{}) : split_into_quads(mesh, AnyFaces{mesh});
}

bool is_alternately_tagged(const Mesh& mesh, const Tags& tags, int face) {
  if (tags.edge.empty() || mesh.size(face) != 4) return false;
  const int h = mesh.face_begin[at(face)];
  const auto tag = [&](int k) { return tags.of_edge(mesh.edge[at(h + k)]); };
  return tag(0) != EdgeTag::none && tag(1) == opposite(tag(0)) && tag(2) == tag(0) && tag(3) == tag(1);
}

Tags split_tags(const Mesh& mesh, const Tags& tags, const Mesh& refined, Split split) {
  Tags fine;
  if (!tags.corner.empty()) {
    fine.corner = tags.corner;
    fine.corner.resize(at(refined.vertices()), 0);
  }
  if (tags.edge.empty()) return fine;
  fine.edge.assign(at(refined.edges()), EdgeTag::none);
  const int d = split.sections, sides = split.triangles ? 3 : 4;
  const Origin origin = origin_of_split(mesh, split);
  const auto old_edge_of_point = [&](int v) { return (v - mesh.vertices()) / (d - 1); };
  for (int e = 0; e < refined.edges(); ++e) {
    const int h = refined.edge_half[at(e)], a = refined.vertex[at(h)], b = refined.tip(h);
    if (origin.is_in_face(a) || origin.is_in_face(b)) continue;
    const int old_edge = old_edge_of_point(origin.is_old(a) ? b : a);
    const bool crosses = !origin.is_old(a) && !origin.is_old(b) && old_edge_of_point(b) != old_edge;  // inside a triangle
    if (!crosses) fine.edge[at(e)] = tags.of_edge(old_edge);
  }
  if (split.triangles) return fine;
  for (int h = 0; h < refined.half_edges(); ++h) {
    const int a = refined.vertex[at(h)], b = refined.tip(h);
    if (!origin.is_in_face(a) && !origin.is_in_face(b)) continue;
    EdgeTag& tag = fine.edge[at(refined.edge[at(h)])];
    if (d == 2) {
      tag = opposite(tags.of_edge(old_edge_of_point(origin.is_in_face(a) ? b : a)));
    } else if (const int f = refined.face[at(h)] / (d * d); is_alternately_tagged(mesh, tags, f)) {
      tag = tags.of_edge(mesh.edge[at(mesh.face_begin[at(f)] + h % sides % 2)]);
    }
  }
  return fine;
}

namespace {

int count_corners(const Tags& tags) {
  return static_cast<int>(std::ranges::count_if(tags.corner, [](char corner) { return corner != 0; }));
}

}  // namespace

int dual_rows(const Mesh& mesh, const Tags& tags) {
  const int boundary_edges = 2 * mesh.edges() - mesh.half_edges();
  return mesh.faces() + boundary_edges + count_corners(tags);
}

namespace {

// Builds the faces of the dual, one per vertex, and their twins in closed form.
class DualBuilder {
 public:
  DualBuilder(const Mesh& mesh, const Tags& tags)
      : mesh_(mesh), tags_(tags), edge_row_(at(mesh.edges()), -1), half_(at(mesh.half_edges())) {
    rows_ = mesh.faces();
    for (int e = 0; e < mesh.edges(); ++e)
      if (mesh.is_boundary_edge(e)) edge_row_[at(e)] = rows_++;
  }

  DualMesh build() {
    for (int v = 0; v < mesh_.vertices(); ++v) add_face(v);
    dual_.face_begin.push_back(static_cast<int>(dual_.vertex.size()));
    dual_.twin.assign(dual_.vertex.size(), -1);
    for (int h = 0; h < mesh_.half_edges(); ++h) set_twin(h);
    complete_mesh(dual_, rows_);
    Tags dual_tags = tags();  // before the mesh that it looks at moves away
    return {std::move(dual_), std::move(dual_tags)};
  }

 private:
  void add_face(int v) {
    const bool boundary = mesh_.on_boundary(v), corner = tags_.is_corner(v);
    if (!boundary && mesh_.valence(v) == 2) {
      throw Error(
          ErrorKind::input, "E_VALENCE2",
          "vertex " + std::to_string(v) + " lies inside and has valence 2, so its face in the dual mesh would have two corners",
          "use a word with an even number of D per round, or a mesh without interior vertices of valence 2");
    }
    if (!boundary && corner) {
      throw Error(ErrorKind::input, "E_CORNER",
                  "vertex " + std::to_string(v) + " is a corner inside the mesh; a dual mesh has corners on its boundary only",
                  "untag it, or use a word with an even number of D per round");
    }
    const int f = static_cast<int>(dual_.face_begin.size());
    dual_.face_begin.push_back(static_cast<int>(dual_.vertex.size()));
    const auto push = [&](int row) {
      dual_.vertex.push_back(row);
      dual_.face.push_back(f);
    };
    int h = mesh_.outgoing[at(v)];
    if (boundary) push(edge_row_[at(mesh_.edge[at(h)])]);
    for (const int first = h;;) {
      half_[at(h)] = static_cast<int>(dual_.vertex.size());
      push(mesh_.face[at(h)]);
      const int arriving = mesh_.prev(h);
      h = mesh_.twin[at(arriving)];
      if (h == first) break;
      if (h < 0) {
        push(edge_row_[at(mesh_.edge[at(arriving)])]);
        break;
      }
    }
    if (corner) push(rows_++);
  }

  // Dual half-edge of h: from its face to the next one around the vertex that h leaves, across the edge of prev(h).
  void set_twin(int h) {
    const int mine = half_[at(h)], next = mesh_.around(h);
    if (next >= 0) {
      dual_.twin[at(mine)] = half_[at(mesh_.next(next))];
      return;
    }
    const int other =
        dual_.face_begin[at(mesh_.vertex[at(mesh_.prev(h))])];  // the edge row of prev(h), first corner of that face
    dual_.twin[at(mine)] = other;
    dual_.twin[at(other)] = mine;
  }

  [[nodiscard]] Tags tags() const {
    Tags result;
    if (!tags_.corner.empty()) {
      result.corner.assign(at(rows_), 0);
      std::fill(result.corner.end() - count_corners(tags_), result.corner.end(), char{1});
    }
    if (tags_.edge.empty()) return result;
    result.edge.assign(at(dual_.edges()), EdgeTag::none);
    for (int h = 0; h < mesh_.half_edges(); ++h)
      result.edge[at(dual_.edge[at(half_[at(h)])])] = opposite(tags_.of_edge(mesh_.edge[at(mesh_.prev(h))]));
    for (int v = 0; v < mesh_.vertices(); ++v)
      if (mesh_.on_boundary(v)) tag_boundary(v, result);
    return result;
  }

  void tag_boundary(int v, Tags& result) const {
    const EdgeTag out = tags_.of_edge(mesh_.edge[at(mesh_.outgoing[at(v)])]);
    const EdgeTag in = tags_.of_edge(mesh_.edge[at(mesh_.boundary_arrival(v))]);
    const int last = dual_.face_begin[at(v) + 1] - 1;  // the half-edge that closes the face towards the row of the leaving edge
    if (!tags_.is_corner(v)) {
      result.edge[at(dual_.edge[at(last)])] = in == out ? in : EdgeTag::none;
      return;
    }
    result.edge[at(dual_.edge[at(last)])] = out;
    result.edge[at(dual_.edge[at(last - 1)])] = in;
  }

  const Mesh& mesh_;
  const Tags& tags_;
  std::vector<int> edge_row_;  // per edge: its row if it is on the boundary
  std::vector<int> half_;      // per half-edge: its half-edge in the dual
  int rows_ = 0;
  Mesh dual_;
};

}  // namespace

DualMesh dual_mesh(const Mesh& mesh, const Tags& tags) { return DualBuilder(mesh, tags).build(); }

}  // namespace udcp
