// From index cycles to half-edges, in linear time: twins are found by the marks that the half-edges leaving a vertex make at
// their tips. The fast path only notices that something is wrong; which element is to blame is found out afterwards, with the
// edges sorted, in the order of priority that mesh.h promises.
#include "operators/mesh.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <tuple>

namespace udcp {
namespace {

using Ints = std::vector<int>;

std::size_t i(int k) { return static_cast<std::size_t>(k); }

std::string text(int k) { return std::to_string(k); }

/// The mesh under construction and what the messages need. Once something is wrong, `sorted` lists the half-edges, those of one
/// edge next to each other (lowest first); group g is sorted[group[g]] .. sorted[group[g+1]-1].
struct Builder {
  Mesh mesh;
  int vertices = 0;
  int base = 0;  // what the messages call the first vertex and face
  Ints sorted, group;

  [[nodiscard]] int low(int h) const { return std::min(mesh.vertex[i(h)], mesh.tip(h)); }
  [[nodiscard]] int high(int h) const { return std::max(mesh.vertex[i(h)], mesh.tip(h)); }
  [[nodiscard]] bool same_direction(int h, int k) const { return mesh.vertex[i(h)] == mesh.vertex[i(k)]; }
  [[nodiscard]] std::string face_name(int f) const { return "face " + text(f + base); }
  [[nodiscard]] std::string vertex_name(int v) const { return "vertex " + text(v + base); }
  [[nodiscard]] std::string edge_name(int h) const { return "edge " + text(low(h) + base) + "-" + text(high(h) + base); }

  [[nodiscard]] bool faces_are_sound() const;
  [[nodiscard]] bool link_twins();
  void check_fans() const;

  void explain_faces() const;
  [[noreturn]] void explain_edges();
  void group_edges();
  void find_duplicate() const;
  void find_crowded_edge() const;
  [[nodiscard]] Ints neighbours() const;
  Ints faces_to_turn(int start, const Ints& opposite, std::vector<signed char>& turned) const;
  void find_turned_face() const;
  void find_isolated_vertex() const;
};

/// At least one face, and all have three different corners or more.
bool Builder::faces_are_sound() const {
  Ints seen(i(vertices), -1);  // the last face that used the vertex
  for (int f = 0; f < mesh.faces(); ++f) {
    if (mesh.size(f) < 3) return false;
    for (const int v : mesh.corners(f)) {
      if (v < 0 || v >= vertices || seen[i(v)] == f) return false;
      seen[i(v)] = f;
    }
  }
  return mesh.faces() > 0;
}

void Builder::explain_faces() const {
  const int faces = mesh.faces();
  if (faces == 0) throw MeshError("E_NO_FACES", "the mesh has no face", "a mesh needs at least one face of three corners");
  for (int f = 0; f < faces; ++f) {
    for (const int v : mesh.corners(f)) {
      if (v >= 0 && v < vertices) continue;
      const std::string range =
          vertices == 0 ? "there are no vertices"
                        : "there are " + text(vertices) + " vertices (" + text(base) + " to " + text(vertices - 1 + base) + ")";
      throw MeshError("E_INDEX",
                      face_name(f) + " names vertex " + std::to_string(static_cast<long long>(v) + base) + ", but " + range,
                      "correct the index or add the vertex", f);
    }
  }
  for (int f = 0; f < faces; ++f) {
    if (mesh.size(f) >= 3) continue;
    throw MeshError("E_FACE_SIZE",
                    face_name(f) + " has " + text(mesh.size(f)) + (mesh.size(f) == 1 ? " corner" : " corners") +
                        "; faces need at least three",
                    "remove the face", f);
  }
  Ints seen(i(vertices), -1);  // the last face that used the vertex
  for (int f = 0; f < faces; ++f) {
    for (const int v : mesh.corners(f)) {
      if (seen[i(v)] == f) {
        throw MeshError("E_FACE_REPEATS", face_name(f) + " repeats " + vertex_name(v) + "; faces need distinct vertices",
                        "remove the repeated corner, or split the face where it meets itself", f);
      }
      seen[i(v)] = f;
    }
  }
}

/// Twins; false if two half-edges run from one vertex to the same other one, as they do at every edge that is not sound.
bool Builder::link_twins() {
  const int n = mesh.half_edges();
  Ints begin(i(vertices) + 1, 0), leaving(i(n));  // the half-edges that leave v: leaving[begin[v]] .. leaving[begin[v+1]-1]
  for (const int v : mesh.vertex) ++begin[i(v)];
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  for (int h = n - 1; h >= 0; --h) leaving[i(--begin[i(mesh.vertex[i(h)])])] = h;
  mesh.twin.assign(i(n), -1);
  Ints mark(i(vertices), -1);  // the half-edge that was last seen to arrive
  for (int v = 0; v < vertices; ++v) {
    const std::span<const int> here(leaving.data() + begin[i(v)], leaving.data() + begin[i(v) + 1]);
    for (const int h : here) {
      int& last = mark[i(mesh.tip(h))];
      if (last >= 0 && mesh.vertex[i(last)] == v) return false;
      last = h;
    }
    for (const int h : here) {
      const int arriving = mesh.prev(h), back = mark[i(mesh.vertex[i(arriving)])];
      if (back >= 0 && mesh.vertex[i(back)] == v) mesh.twin[i(arriving)] = back;
    }
  }
  return true;
}

/// One walk around each vertex must meet every face there; a second fan would be left over.
void Builder::check_fans() const {
  for (int v = 0; v < vertices; ++v) {
    const int first = mesh.outgoing[i(v)];
    if (first < 0) continue;
    const int faces_here = mesh.valences[i(v)] - (mesh.on_boundary(v) ? 1 : 0);
    int met = 0, h = first;
    do {
      ++met;
      h = mesh.around(h);
    } while (h >= 0 && h != first);
    if (met != faces_here) {
      throw MeshError("E_VERTEX_FANS",
                      "several fans of faces meet in " + vertex_name(v) + ": " + face_name(mesh.face[i(first)]) +
                          " reaches only " + text(met) + " of its " +
                          std::to_string(std::count(mesh.vertex.begin(), mesh.vertex.end(), v)) + " faces across edges",
                      "give each fan a vertex of its own", mesh.face[i(first)]);
    }
  }
}

/// One stable counting sort of `order` by key(h), which lies in 0 .. keys - 1.
template <class Key>
Ints counting_sort(const Ints& order, int keys, Key key) {
  Ints place(i(keys) + 1, 0);
  for (const int h : order) ++place[i(key(h)) + 1];
  std::partial_sum(place.begin(), place.end(), place.begin());
  Ints result(order.size());
  for (const int h : order) result[i(place[i(key(h))]++)] = h;
  return result;
}

void Builder::group_edges() {
  Ints order(mesh.vertex.size());
  std::iota(order.begin(), order.end(), 0);
  order = counting_sort(order, vertices, [this](int h) { return high(h); });
  sorted = counting_sort(order, vertices, [this](int h) { return low(h); });
  for (int k = 0; k < mesh.half_edges(); ++k) {
    const bool first = k == 0 || low(sorted[i(k)]) != low(sorted[i(k - 1)]) || high(sorted[i(k)]) != high(sorted[i(k - 1)]);
    if (first) group.push_back(k);
  }
  group.push_back(mesh.half_edges());
}

void Builder::explain_edges() {
  group_edges();
  find_duplicate();
  find_crowded_edge();
  find_turned_face();
  throw Error(ErrorKind::internal, "E_INTERNAL", "make_mesh found a bad edge and no reason for it");
}

/// Corners from the lowest vertex on, towards the lower neighbour: equal for equal cycles, however they are turned or reversed.
Ints canonical_cycle(std::span<const int> corners, bool& reversed) {
  const auto n = corners.size();
  const auto start = static_cast<std::size_t>(std::min_element(corners.begin(), corners.end()) - corners.begin());
  reversed = corners[(start + n - 1) % n] < corners[(start + 1) % n];
  Ints cycle(n);
  for (std::size_t k = 0; k < n; ++k) cycle[k] = corners[(start + (reversed ? n - k : k)) % n];
  return cycle;
}

void Builder::find_duplicate() const {
  struct Entry {
    Ints cycle;
    int face;
    bool reversed;
  };
  std::vector<Entry> entries;
  for (int f = 0; f < mesh.faces(); ++f) {
    Entry entry{{}, f, false};
    entry.cycle = canonical_cycle(mesh.corners(f), entry.reversed);
    entries.push_back(std::move(entry));
  }
  std::ranges::sort(entries,
                    [](const Entry& a, const Entry& b) { return std::tie(a.cycle, a.face) < std::tie(b.cycle, b.face); });
  Ints crowd(mesh.vertex.size(), 0);  // per half-edge: faces at its edge
  for (std::size_t g = 0; g + 1 < group.size(); ++g) {
    for (int k = group[g]; k < group[g + 1]; ++k) crowd[i(sorted[i(k)])] = group[g + 1] - group[g];
  }
  const auto is_pillow = [&](const Entry& a, const Entry& b) {
    const auto* first = crowd.data() + mesh.face_begin[i(a.face)];
    return a.reversed != b.reversed && std::all_of(first, first + mesh.size(a.face), [](int faces) { return faces == 2; });
  };
  int face = std::numeric_limits<int>::max(), other = -1;
  for (std::size_t k = 1; k < entries.size(); ++k) {
    const Entry &a = entries[k - 1], &b = entries[k];
    if (a.cycle != b.cycle || is_pillow(a, b) || b.face > face) continue;
    face = b.face;
    other = a.face;
  }
  if (other < 0) return;
  throw MeshError("E_DUPLICATE_FACE",
                  face_name(face) + " has the same vertices as " + face_name(other) + "; each face may be given once",
                  "remove one of the two", face, other);
}

void Builder::find_crowded_edge() const {
  int worst = -1;  // the group whose third face comes first
  const auto third = [this](int g) { return sorted[i(group[i(g)] + 2)]; };
  for (int g = 0; g + 1 < static_cast<int>(group.size()); ++g) {
    if (group[i(g) + 1] - group[i(g)] > 2 && (worst < 0 || third(g) < third(worst))) worst = g;
  }
  if (worst < 0) return;
  const int size = group[i(worst) + 1] - group[i(worst)];
  std::string faces;
  for (int k = 0; k < std::min(size, 4); ++k) {
    faces += (k > 0 ? ", " : "") + text(mesh.face[i(sorted[i(group[i(worst)] + k)])] + base);
  }
  throw MeshError("E_EDGE_FACES",
                  edge_name(third(worst)) + " has " + text(size) + " faces (" + faces + (size > 4 ? ", ..." : "") +
                      "); an edge may have at most two",
                  "separate the sheets that meet there", mesh.face[i(third(worst))], mesh.face[i(sorted[i(group[i(worst)])])]);
}

/// Half-edge at the other side of an edge with two faces, whichever way it runs; -1 elsewhere.
Ints Builder::neighbours() const {
  Ints opposite(mesh.vertex.size(), -1);
  for (std::size_t g = 0; g + 1 < group.size(); ++g) {
    if (group[g + 1] - group[g] != 2) continue;
    opposite[i(sorted[i(group[g])])] = sorted[i(group[g] + 1)];
    opposite[i(sorted[i(group[g] + 1)])] = sorted[i(group[g])];
  }
  return opposite;
}

/// Spreads "turned" or "not turned" over the component of `start`, so that neighbours agree, and returns the smaller side: the
/// faces to turn round. A contradiction means that the surface is not orientable.
Ints Builder::faces_to_turn(int start, const Ints& opposite, std::vector<signed char>& turned) const {
  Ints sides[2], queue{start};
  turned[i(start)] = 0;
  for (std::size_t q = 0; q < queue.size(); ++q) {
    const int f = queue[q];
    sides[turned[i(f)]].push_back(f);
    for (int h = mesh.face_begin[i(f)]; h < mesh.face_begin[i(f) + 1]; ++h) {
      const int k = opposite[i(h)];
      if (k < 0) continue;
      const int other = mesh.face[i(k)];
      const auto wanted = static_cast<signed char>(turned[i(f)] ^ (same_direction(h, k) ? 1 : 0));
      if (turned[i(other)] < 0) {
        turned[i(other)] = wanted;
        queue.push_back(other);
      } else if (turned[i(other)] != wanted) {
        const auto [first, second] = std::minmax(f, other);
        throw MeshError(
            "E_NOT_ORIENTABLE",
            "the surface is not orientable: no choice of orientations makes its faces agree (the last conflict is between " +
                face_name(first) + " and " + face_name(second) + " at " + edge_name(h) + ")",
            "cut the surface open; a Moebius strip cannot be subdivided as it is", first, second);
      }
    }
  }
  return std::move(sides[sides[1].size() <= sides[0].size() ? 1 : 0]);
}

void Builder::find_turned_face() const {
  const Ints opposite = neighbours();
  std::vector<signed char> turned(i(mesh.faces()), -1);
  Ints wrong;
  for (int f = 0; f < mesh.faces(); ++f) {
    if (turned[i(f)] >= 0) continue;
    const Ints part = faces_to_turn(f, opposite, turned);
    wrong.insert(wrong.end(), part.begin(), part.end());
  }
  for (int h = 0; h < mesh.half_edges(); ++h) {
    const int k = opposite[i(h)];
    if (k < 0 || !same_direction(h, k)) continue;
    const int f = mesh.face[i(h)], other = mesh.face[i(k)];
    const std::string first = face_name(*std::min_element(wrong.begin(), wrong.end()));
    throw MeshError("E_ORIENTATION",
                    face_name(f) + " and " + face_name(other) + " run along " + edge_name(h) +
                        " in the same direction; neighbours must run along it in opposite directions",
                    wrong.size() == 1 ? "turn one of them round: write the corners of " + first + " in reverse order"
                                      : "turn " + std::to_string(wrong.size()) + " faces round, " + first +
                                            " first: write their corners in reverse order",
                    f, other);
  }
}

void Builder::find_isolated_vertex() const {
  const auto found = std::find(mesh.outgoing.begin(), mesh.outgoing.end(), -1);
  if (found == mesh.outgoing.end()) return;
  const auto count = std::count(found, mesh.outgoing.end(), -1);
  const std::string more = count > 1 ? " (and " + std::to_string(count - 1) + " more)" : "";
  throw MeshError("E_ISOLATED", vertex_name(static_cast<int>(found - mesh.outgoing.begin())) + more + " is used by no face",
                  "remove vertices that no face uses");
}

}  // namespace

int Mesh::boundary_arrival(int v) const {
  int h = outgoing[i(v)];
  while (twin[i(prev(h))] >= 0) h = twin[i(prev(h))];
  return prev(h);
}

bool Mesh::all_faces_have(int count) const {
  for (int f = 0; f < faces(); ++f) {
    if (size(f) != count) return false;
  }
  return true;
}

void complete_mesh(Mesh& mesh, int vertices) {
  const int n = mesh.half_edges();
  mesh.edge.assign(i(n), -1);
  mesh.edge_half.clear();
  mesh.outgoing.assign(i(vertices), -1);
  mesh.valences.assign(i(vertices), 0);
  for (int h = 0; h < n; ++h) {
    const int twin = mesh.twin[i(h)], v = mesh.vertex[i(h)];
    if (twin >= 0 && twin < h) {
      mesh.edge[i(h)] = mesh.edge[i(twin)];
    } else {
      mesh.edge[i(h)] = mesh.edges();
      mesh.edge_half.push_back(h);
    }
    int& first = mesh.outgoing[i(v)];
    if (first < 0 || twin < 0) first = h;
    mesh.valences[i(v)] += twin < 0 && first == h ? 2 : 1;  // on a boundary there is one edge more than faces
  }
}

Mesh make_mesh(int vertices, std::vector<int> begin, std::vector<int> corners, int first_index) {
  if (begin.empty() || begin.front() != 0 || !std::is_sorted(begin.begin(), begin.end()) || vertices < 0 ||
      i(begin.back()) != corners.size()) {
    throw Error(ErrorKind::internal, "E_INTERNAL", "make_mesh needs face offsets from 0 to the number of corners, in order");
  }
  Builder builder;
  builder.vertices = vertices;
  builder.base = first_index;
  Mesh& mesh = builder.mesh;
  mesh.face_begin = std::move(begin);
  mesh.vertex = std::move(corners);
  if (!builder.faces_are_sound()) builder.explain_faces();
  mesh.face.resize(mesh.vertex.size());
  for (int f = 0; f < mesh.faces(); ++f) {
    std::fill(mesh.face.begin() + mesh.face_begin[i(f)], mesh.face.begin() + mesh.face_begin[i(f) + 1], f);
  }
  if (!builder.link_twins()) builder.explain_edges();
  complete_mesh(mesh, vertices);
  builder.check_fans();
  builder.find_isolated_vertex();
  return std::move(mesh);
}

Mesh make_mesh(int vertices, const std::vector<std::vector<int>>& faces) {
  std::vector<int> begin{0}, corners;
  for (const auto& face : faces) {
    corners.insert(corners.end(), face.begin(), face.end());
    if (corners.size() > static_cast<std::size_t>(std::numeric_limits<int>::max())) {
      throw Error(ErrorKind::limit, "E_TOO_LARGE", "the mesh has more than 2^31 - 1 half-edges");
    }
    begin.push_back(static_cast<int>(corners.size()));
  }
  return make_mesh(vertices, std::move(begin), std::move(corners));
}

}  // namespace udcp
