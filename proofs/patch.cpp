// Labelled lattices around extraordinary points, labels of new points, rows by unit vectors.
#include "proofs/patch.h"

#include <algorithm>
#include <numeric>

#include "operators/topology.h"

namespace udcp {

Label Sectors::label(int s, Place place) const {
  while (place.x <= 0 || place.y < 0) {
    if (place.x == 0 && place.y == 0) return {};
    if (place.y < 0) {
      place = turned(place);
      --s;
    } else {
      place = turned_back(place);
      ++s;
    }
  }
  return {((s % valence) + valence) % valence, place.x, place.y};
}

Place Sectors::seen_from(int s, const Label& label) const {
  const Place place{label.a, label.b};
  const int distance = (((label.s - s) % valence) + valence) % valence;
  if (label.is_centre() || distance == 0) return place;
  return distance == 1 ? turned(place) : turned_back(place);
}

Label Sectors::rotated(const Label& label, int by) const {
  if (label.is_centre()) return label;
  return {(((label.s + by) % valence) + valence) % valence, label.a, label.b};
}

Label Sectors::mirrored(const Label& label) const { return this->label(-label.s - 1, {label.b, label.a}); }

namespace {

struct Lattice {
  Sectors sectors;
  std::vector<Label> labels;
  std::map<Label, int> index;
  std::vector<int> begin{0}, corners;

  Lattice(const Sectors& around, int radius) : sectors(around) {
    const int first = sectors.dual ? 1 : 0;
    if (!sectors.dual) add_label({});
    for (int s = 0; s < sectors.valence; ++s)
      for (int a = sectors.dual ? 1 : 2; a <= radius; a += 2)
        for (int b = first; b <= (sectors.triangles ? radius - a : radius); b += 2) add_label({s, a, b});
    for (int s = 0; s < sectors.valence; ++s)
      for (int x = first; x + 2 <= radius; x += 2)
        for (int y = sectors.dual ? -1 : 0; y + 2 <= (sectors.triangles ? radius - x : radius); y += 2) add_cell(s, x, y, radius);
    if (!sectors.dual) return;
    for (int s = 0; s < sectors.valence; ++s) corners.push_back(index.at({s, 1, 1}));
    begin.push_back(static_cast<int>(corners.size()));
  }

  [[nodiscard]] Mesh mesh() const { return make_mesh(static_cast<int>(labels.size()), begin, corners); }

 private:
  void add_label(const Label& label) {
    index.emplace(label, static_cast<int>(labels.size()));
    labels.push_back(label);
  }
  void add_face(int s, std::initializer_list<Place> places) {
    for (const Place& place : places) corners.push_back(index.at(sectors.label(s, place)));
    begin.push_back(static_cast<int>(corners.size()));
  }
  void add_cell(int s, int x, int y, int radius) {
    if (!sectors.triangles) return add_face(s, {{x, y}, {x + 2, y}, {x + 2, y + 2}, {x, y + 2}});
    add_face(s, {{x, y}, {x + 2, y}, {x, y + 2}});
    if (x + y + 4 <= radius) add_face(s, {{x + 2, y}, {x + 2, y + 2}, {x, y + 2}});
  }
};

/// `numerator`/size times the mean of the corners, taken in the frame of the first of them that has a sector. All corners of the
/// central face give the centre.
Label middle(const Sectors& sectors, const std::vector<Label>& corners, int numerator) {
  const auto same = [&](const Label& l) { return l.a == corners[0].a && l.b == corners[0].b && l.a == l.b; };
  if (static_cast<int>(corners.size()) == sectors.valence && std::all_of(corners.begin(), corners.end(), same)) return {};
  const auto found = std::find_if(corners.begin(), corners.end(), [](const Label& l) { return !l.is_centre(); });
  const int s = found == corners.end() ? 0 : found->s;
  Place sum;
  for (const Label& corner : corners) {
    const Place place = sectors.seen_from(s, corner);
    sum = {sum.x + place.x, sum.y + place.y};
  }
  const int size = static_cast<int>(corners.size());
  return sectors.label(s, {sum.x * numerator / size, sum.y * numerator / size});
}

std::vector<Label> middles_of_faces(const Sectors& sectors, const Mesh& mesh, const std::vector<Label>& labels, int numerator) {
  std::vector<Label> result;
  for (int f = 0; f < mesh.faces(); ++f) {
    std::vector<Label> corners;
    for (const int v : mesh.corners(f)) corners.push_back(labels[Mesh::i(v)]);
    result.push_back(middle(sectors, corners, numerator));
  }
  return result;
}

/// Labels after U, in the order of split_mesh: old points, edge points, face points.
std::vector<Label> split_labels(const Sectors& sectors, const Mesh& mesh, const std::vector<Label>& old) {
  std::vector<Label> result;
  for (const Label& label : old) result.push_back({label.s, 2 * label.a, 2 * label.b});
  for (int e = 0; e < mesh.edges(); ++e) {
    const int h = mesh.edge_half[Mesh::i(e)];
    result.push_back(middle(sectors, {old[Mesh::i(mesh.vertex[Mesh::i(h)])], old[Mesh::i(mesh.tip(h))]}, 2));
  }
  if (sectors.triangles) return result;
  const std::vector<Label> faces = middles_of_faces(sectors, mesh, old, 2);
  result.insert(result.end(), faces.begin(), faces.end());
  return result;
}

/// Labels of the points after one round: those of U, or of the faces of the split mesh, whose points come first in a dual.
std::vector<Label> new_labels(const Lattice& lattice, const Mesh& mesh) {
  std::vector<Label> labels = split_labels(lattice.sectors, mesh, lattice.labels);
  if (!lattice.sectors.dual) return labels;
  return middles_of_faces(lattice.sectors, split_mesh(mesh, Split{2, false}), labels, 1);
}

int averages(const Word& word) {
  return static_cast<int>(
      std::count_if(word.tail.begin(), word.tail.end(), [](const Item& i) { return i.atom == Atom::average; }));
}

}  // namespace

bool has_one_split(const Word& word, std::string* why) {
  const auto refuse = [&](const char* reason) {
    if (why != nullptr) *why = reason;
    return false;
  };
  if (!word.is_scheme()) return refuse("a finite operator has no limit");
  if (std::count_if(word.tail.begin(), word.tail.end(), [](const Item& i) { return i.atom == Atom::up; }) != 1)
    return refuse("a round with more than one U is not covered");
  const auto up = std::find_if(word.tail.begin(), word.tail.end(), [](const Item& i) { return i.atom == Atom::up; });
  if (up->sections != 2) return refuse("U[d] with d > 2 is not covered");
  if (up != word.tail.begin()) return refuse("a round that does not begin with U is not covered");
  return true;
}

Sectors sectors_of(const Word& word, int valence) { return {valence, word.triangles, averages(word) % 2 != 0}; }

template <class S>
std::vector<Label> Patch<S>::orbits(int within) const {
  std::vector<Label> result;
  for (const auto& [label, row] : rows)
    if (!label.is_centre() && sectors.radius(label) <= within) result.push_back(label);
  return result;
}

namespace {

/// One round on the unit vectors of the centre and of sector 0: a row per new point, a column per entry of `columns`.
template <class S>
Points<S> round_on_units(const Word& word, const Lattice& lattice, std::shared_ptr<const Mesh> mesh,
                         const std::vector<int>& columns) {
  const auto old = static_cast<Eigen::Index>(lattice.labels.size()), width = static_cast<Eigen::Index>(columns.size());
  Surface<S> surface;
  surface.mesh = std::move(mesh);
  surface.points = Points<S>::Zero(old, width);
  for (Eigen::Index c = 0; c < width; ++c) surface.points(columns[static_cast<std::size_t>(c)], c) = S(1);
  return run(word, std::move(surface), 1).points;
}

/// Adds what the unit vectors say of a new point at `label`: by symmetry, sector 0 seen from sector s is sector -s seen from 0.
template <class S, class Weights>
void add_weights(std::map<Label, Row<S>>& rows, const Sectors& sectors, const Label& label, const std::vector<Label>& columns,
                 const Weights& weights) {
  Row<S>& row = rows[label.is_centre() ? label : Label{0, label.a, label.b}];
  for (std::size_t c = 0; c < columns.size(); ++c) {
    const S& weight = weights[static_cast<Eigen::Index>(c)];
    if (is_zero(weight)) continue;
    if (label.is_centre() && !columns[c].is_centre()) {
      for (int s = 0; s < sectors.valence; ++s) row.emplace(sectors.rotated(columns[c], s), weight);
    } else if (!columns[c].is_centre()) {
      row.emplace(sectors.rotated(columns[c], -label.s), weight);
    } else if (label.s == 0) {
      row.emplace(Label{}, weight);
    }
  }
}

}  // namespace

template <class S>
Patch<S> patch(const Word& word, int valence, int radius) {
  Patch<S> result;
  result.sectors = sectors_of(word, valence);
  const Reach reach = reach_of_round(word);
  result.reach = reach.high - reach.low;
  result.radius = radius;
  int rim = (radius + result.reach) / 2 + 2;  // one step beyond what the rows can see
  if (rim % 2 == (result.sectors.dual ? 0 : 1)) ++rim;
  const double points = static_cast<double>(valence) * rim * rim, units = static_cast<double>(rim) * rim / 4;
  if (valence < 3 || points * units > 3e7)
    throw Error(ErrorKind::limit, "E_TOO_LARGE",
                "the neighbourhood that one round needs around a point of valence " + std::to_string(valence) + " is too large",
                "use a valence from 3 on, or a word with fewer averages per round");
  const Lattice lattice(result.sectors, rim);
  const auto mesh = std::make_shared<const Mesh>(lattice.mesh());
  std::vector<int> columns;
  std::vector<Label> column_labels;
  for (std::size_t v = 0; v < lattice.labels.size(); ++v) {
    if (lattice.labels[v].s != 0 || result.sectors.radius(lattice.labels[v]) > rim - 2) continue;
    columns.push_back(static_cast<int>(v));
    column_labels.push_back(lattice.labels[v]);
  }
  const Points<S> fine = round_on_units<S>(word, lattice, mesh, columns);
  const std::vector<Label> labels = new_labels(lattice, *mesh);
  for (std::size_t k = 0; k < labels.size(); ++k) {
    if (result.sectors.radius(labels[k]) <= radius)
      add_weights(result.rows, result.sectors, labels[k], column_labels, fine.row(static_cast<Eigen::Index>(k)));
  }
  return result;
}

template <class S>
bool reproduces_constants(const Patch<S>& patch) {
  return std::all_of(patch.rows.begin(), patch.rows.end(), [](const auto& entry) {
    S sum(-1);
    for (const auto& [label, weight] : entry.second) sum += weight;
    return is_zero(sum);
  });
}

template <class S>
bool is_mirror_symmetric(const Patch<S>& patch) {
  return std::all_of(patch.rows.begin(), patch.rows.end(), [&](const auto& entry) {
    // The image of (0, a, b) lies in sector -1 (or 0, on the spoke); its row is a rotated row of sector 0.
    const Label image = patch.sectors.mirrored(entry.first);
    const auto found = patch.rows.find(patch.sectors.rotated(image, -image.s));
    if (found == patch.rows.end() || found->second.size() != entry.second.size()) return false;
    return std::all_of(entry.second.begin(), entry.second.end(), [&](const auto& weight) {
      const auto other = found->second.find(patch.sectors.rotated(patch.sectors.mirrored(weight.first), -image.s));
      return other != found->second.end() && is_zero(S(other->second - weight.second));
    });
  });
}

namespace {

template <class S>
int farthest(const Patch<S>& patch, const Row<S>& row) {
  int result = 0;
  for (const auto& [label, weight] : row) result = std::max(result, patch.sectors.radius(label));
  return result;
}

template <class S>
int smallest_radius(const Patch<S>& patch, bool beyond_too) {
  for (int r = patch.sectors.dual ? 1 : 2; r <= patch.radius; r += 2) {
    const bool closed = std::all_of(patch.rows.begin(), patch.rows.end(), [&](const auto& entry) {
      const int own = patch.sectors.radius(entry.first), used = farthest(patch, entry.second);
      return own <= r ? used <= r : !beyond_too || used < own;
    });
    if (closed) return r;
  }
  throw Error(ErrorKind::internal, "E_INTERNAL", "a neighbourhood that does not close");
}

}  // namespace

template <class S>
int invariant_radius(const Patch<S>& patch) {
  return smallest_radius(patch, true);
}

template <class S>
int closed_radius(const Patch<S>& patch) {
  return smallest_radius(patch, false);
}

template <class T, class S>
Patch<T> converted(const Patch<S>& patch) {
  Patch<T> result{patch.sectors, patch.reach, patch.radius, {}};
  for (const auto& [label, row] : patch.rows) {
    Row<T>& target = result.rows[label];
    for (const auto& [place, weight] : row) target.emplace(place, number<T>(weight));
  }
  return result;
}

#define UDCP_INSTANTIATE(S)                            \
  template struct Patch<S>;                            \
  template Patch<S> patch(const Word&, int, int);      \
  template bool reproduces_constants(const Patch<S>&); \
  template bool is_mirror_symmetric(const Patch<S>&);  \
  template int invariant_radius(const Patch<S>&);      \
  template int closed_radius(const Patch<S>&);
UDCP_FOR_EACH_NUMBER(UDCP_INSTANTIATE)
#undef UDCP_INSTANTIATE
#define UDCP_INSTANTIATE(S)                            \
  template Patch<S> converted(const Patch<Rational>&); \
  template Patch<S> converted(const Patch<Algebraic>&);
UDCP_FOR_EACH_NUMBER(UDCP_INSTANTIATE)
#undef UDCP_INSTANTIATE

}  // namespace udcp
