// Static checks and counts of words.
#include "operators/word.h"

#include <limits>

#include "operators/error.h"

namespace udcp {
namespace {

__extension__ typedef __int128 Wide;  // the largest count times a squared section number fits

constexpr std::int64_t largest_count = std::int64_t{1} << 62;

Error item_error(const std::string& code, int item, const std::string& message, const std::string& help) {
  Error error(ErrorKind::word, code, message, help);
  error.item = item;
  return error;
}

// The part of the execution state that depends on the word alone.
struct Parity {
  bool split = false;  // an earlier U
  int averages = 0;    // number of D since
};

Error dual_error(int index, int averages) {
  Error error = item_error("E_P_DUAL", index, "P needs the points to correspond to the vertices before U, but here they are dual",
                           "write (UDDP)* or (UCP)*");
  error.label = (averages == 1 ? std::string("one") : std::to_string(averages)) + " D since the last U; P needs an even number";
  return error;
}

void check_item(const Item& item, int index, const Word& word, Parity& state) {
  switch (item.atom) {
    case Atom::up:
      if (item.sections < 2 || item.sections > 1000)
        throw item_error("E_SECTIONS", index, "U[" + std::to_string(item.sections) + "]: the section number is from 2 to 1000",
                         "write U for U[2]");
      if (word.rings != Rings::off && item.sections != 2)
        throw item_error("E_RINGS", index, "rings need U[2]; here it is U[" + std::to_string(item.sections) + "]",
                         "leave out rings, or the section number");
      state = {true, 0};
      return;
    case Atom::average:
      if (word.triangles)
        throw item_error("E_TRI_D", index, "D leaves triangle meshes, so a word `on triangles` cannot use it",
                         "use C, or leave out `on triangles`");
      ++state.averages;
      return;
    case Atom::convolve:
      state.averages += 2;
      return;
    case Atom::push_back:
      if (!state.split)
        throw item_error("E_P_NO_U", index, "P pushes back to the points before U, but no U stands before it",
                         "words are read from left to right: UCP starts with U; written as an operator product it is P . C . U");
      if (state.averages % 2 != 0) throw dual_error(index, state.averages);
      return;
  }
}

std::int64_t checked(Wide value) {
  if (value > largest_count)
    throw Error(ErrorKind::limit, "E_COUNT_OVERFLOW", "the result would have more than 2^62 elements", "apply fewer rounds");
  return static_cast<std::int64_t>(value);
}

Counts split_counts(const Counts& c, int d, bool triangles) {
  Counts n;
  const Wide D = d;
  n.corners = c.corners;
  n.boundary_edges = checked(D * c.boundary_edges);
  if (triangles) {
    n.vertices = checked(c.vertices + (D - 1) * c.edges + (D - 1) * (D - 2) / 2 * c.faces);
    n.edges = checked(D * c.edges + 3 * D * (D - 1) / 2 * c.faces);
    n.faces = checked(D * D * c.faces);
    n.half_edges = checked(D * D * c.half_edges);
    n.all_triangles = c.all_triangles;
    return n;
  }
  n.all_quads = true;
  n.vertices = checked(c.vertices + (D - 1) * c.edges + (d == 2 ? Wide{c.faces} : (D - 1) * (D - 1) * c.faces));
  n.edges = checked(D * c.edges + (d == 2 ? Wide{c.half_edges} : 2 * D * (D - 1) * c.faces));
  n.faces = checked(d == 2 ? Wide{c.half_edges} : D * D * c.faces);
  n.half_edges = checked(D * D * c.half_edges);
  return n;
}

// The faces of a dual may or may not be quads; U[d > 2] finds out when it runs.
Counts dual_counts(const Counts& c) {
  Counts n;
  n.vertices = checked(Wide{c.faces} + c.boundary_edges + c.corners);
  n.edges = checked(Wide{c.edges} + c.boundary_edges + c.corners);
  n.faces = c.vertices;
  n.boundary_edges = checked(Wide{c.boundary_edges} + c.corners);
  n.half_edges = checked(2 * Wide{n.edges} - n.boundary_edges);
  n.corners = c.corners;
  n.all_quads = n.all_triangles = true;
  return n;
}

int total_items(const Word& word, int rounds) {
  const auto size = static_cast<std::int64_t>(word.head.size()) * (word.is_scheme() ? 1 : rounds) +
                    static_cast<std::int64_t>(word.tail.size()) * rounds;
  if (size > std::numeric_limits<int>::max())
    throw Error(ErrorKind::limit, "E_TOO_MANY_ROUNDS", std::to_string(rounds) + " rounds make a word of more than 2^31 atoms",
                "apply fewer rounds");
  return static_cast<int>(size);
}

}  // namespace

const Item& Word::item(int i) const {
  const auto k = static_cast<std::size_t>(i);
  if (tail.empty()) return head[k % head.size()];
  return k < head.size() ? head[k] : tail[(k - head.size()) % tail.size()];
}

int Word::items(int rounds) const { return total_items(*this, rounds); }

std::string atoms(const Word& word, int rounds) {
  std::string text;
  const int total = word.items(rounds), head = static_cast<int>(word.head.size());
  for (int i = 0; i < total; ++i) {
    const Item& item = word.item(i);
    const bool next_round =
        word.is_scheme() ? i > head && (i - head) % static_cast<int>(word.tail.size()) == 0 : i > 0 && i % head == 0;
    if (next_round) text += ' ';
    text += static_cast<char>(item.atom);
    if (item.atom == Atom::up && item.sections != 2) text += std::to_string(item.sections);
  }
  return text;
}

void validate(const Word& word) {
  if (word.head.empty() && word.tail.empty())
    throw Error(ErrorKind::word, "E_EMPTY", "the word has no atom", "write for example (UCP)*");
  if (word.rings != Rings::off && word.triangles)
    throw Error(ErrorKind::word, "E_RINGS", "rings are made of quads; the word is `on triangles`",
                "leave out rings or `on triangles`");
  Parity state;
  const auto head = static_cast<int>(word.head.size()), tail = static_cast<int>(word.tail.size());
  for (int i = 0; i < head + 2 * tail; ++i) check_item(word.item(i), i < head + tail ? i : i - tail, word, state);
}

void validate_for_curve(const Word& word) {
  validate(word);
  const auto refuse = [](const std::string& what) {
    throw Error(ErrorKind::word, "E_CURVE_WORD", what + " has no meaning on curves", "apply the word to a mesh, or leave it out");
  };
  if (word.triangles) refuse("`on triangles`");
  if (word.rings != Rings::off) refuse("rings");
}

Counts counts(const Mesh& mesh, const Tags& tags) {
  Counts c;
  c.vertices = mesh.vertices();
  c.edges = mesh.edges();
  c.faces = mesh.faces();
  c.half_edges = mesh.half_edges();
  c.boundary_edges = 2 * c.edges - c.half_edges;
  for (const char corner : tags.corner) c.corners += corner != 0;
  c.all_quads = mesh.all_faces_have(4);
  c.all_triangles = mesh.all_faces_have(3);
  return c;
}

Counts counts(const Word& word, const Counts& start, int rounds) {
  return counts(word, start, rounds, [](const Counts&) {});
}

Counts counts(const Word& word, const Counts& start, int rounds, const std::function<void(const Counts&)>& after_each_atom) {
  Counts c = start;
  bool dual = false;
  const int total = word.items(rounds);
  for (int i = 0; i < total; ++i) {
    const Item& item = word.item(i);
    if (item.atom == Atom::average) dual = !dual;
    if (item.atom == Atom::up) {
      if (dual) c = dual_counts(c);
      dual = false;
      if (word.triangles ? !c.all_triangles : item.sections != 2 && !c.all_quads) {
        if (word.triangles)
          throw Error(ErrorKind::input, "E_NOT_TRIANGLES", "a word `on triangles` needs a mesh of triangles",
                      "triangulate(mesh) cuts the faces, or leave out `on triangles`");
        throw Error(ErrorKind::input, "E_USPLIT",
                    "U[" + std::to_string(item.sections) + "] splits quads only, and the mesh has other faces",
                    "apply U once first, or use U without a section number");
      }
      c = split_counts(c, item.sections, word.triangles);
    }
    after_each_atom(c);
  }
  return dual ? dual_counts(c) : c;
}

std::int64_t count_points(const Word& word, std::int64_t points, bool closed, int corners, int rounds) {
  const auto realise = [&](std::int64_t n) { return checked(Wide{closed ? n : n - 1} + corners); };
  bool dual = false;
  const int total = word.items(rounds);
  for (int i = 0; i < total; ++i) {
    const Item& item = word.item(i);
    if (item.atom == Atom::average) dual = !dual;
    if (item.atom != Atom::up) continue;
    if (dual) points = realise(points);
    dual = false;
    points = closed ? checked(Wide{points} * item.sections) : checked(Wide{points - 1} * item.sections + 1);
  }
  return dual ? realise(points) : points;
}

}  // namespace udcp
