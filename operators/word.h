// Words: sequences of atoms with their parameters, checked before they run. Knows no points.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "operators/kernel.h"
#include "operators/mesh.h"
#include "operators/tags.h"

namespace udcp {

enum class Atom : char { up = 'U', average = 'D', convolve = 'C', push_back = 'P' };

/// f, f@lat, f@lon: `plain` serves untagged edges, and any direction that has none of its own.
template <class T>
struct Directional {
  T plain{}, latitude{}, longitude{};
  [[nodiscard]] const T& at(EdgeTag tag) const {
    return tag == EdgeTag::latitude ? latitude : tag == EdgeTag::longitude ? longitude : plain;
  }
  static Directional all(const T& value) { return {value, value, value}; }
};

/// The edge points next to a face that was not a quad: from the sub-quads (C is exactly D D), or from the face points themselves,
/// which is textbook Catmull-Clark.
enum class Ngon { dual, classic };
/// The second pass on rings of tagged edges after P, which keeps circles (push-back, surfaces of revolution).
enum class Rings { off, latitude, longitude, both };

/// A null kernel means the default: f = 1, omega = 1, delta = 1.
struct Item {
  Atom atom = Atom::up;
  int sections = 2;           // U
  Directional<KernelPtr> f;   // D, C
  bool f_everywhere = false;  // an explicit D[f = ...]: acts on every such D in the primal state, not only on the first after U
  Ngon ngon = Ngon::dual;     // C
  Directional<KernelPtr> omega;  // P
  KernelPtr omega_face;          // P; null: omega_lat * omega_lon, or omega^2
  KernelPtr delta;               // P
};

struct Word {
  std::vector<Item> head;  // once
  std::vector<Item> tail;  // for ever; empty: a finite operator
  Directional<KernelPtr> alpha0;
  Rings rings = Rings::off;
  bool triangles = false;

  [[nodiscard]] bool is_scheme() const { return !tail.empty(); }
  /// Item i, counted over head then tail then tail again (a finite operator: head, then head again).
  [[nodiscard]] const Item& item(int i) const;
  /// Number of items that `rounds` rounds run through. Throws Error{limit, "E_TOO_MANY_ROUNDS"}.
  [[nodiscard]] int items(int rounds) const;
};

/// "UCUCP UCP": the atoms of head and `rounds` tails, a blank between rounds, section numbers as in U3.
std::string atoms(const Word& word, int rounds);

/// Static checks. Throws Error{word} with `item` set: E_P_NO_U, E_P_DUAL (odd number of D since the last U, also when the tail
/// comes round again), E_TRI_D, E_SECTIONS (U[d] with d < 2 or d > 1000), E_EMPTY, E_RINGS (rings with U[d > 2] or on triangles).
void validate(const Word& word);
/// The same for use on curves (no rings, not on triangles: E_CURVE_WORD; ngon and directions mean nothing there and are ignored).
void validate_for_curve(const Word& word);

/// Sizes of a complex; what a word makes of them is exact and costs nothing.
struct Counts {
  std::int64_t vertices = 0, edges = 0, faces = 0, half_edges = 0, boundary_edges = 0, corners = 0;
  bool all_quads = false, all_triangles = false;
  friend bool operator==(const Counts&, const Counts&) = default;
};
Counts counts(const Mesh& mesh, const Tags& tags);
/// The counts after `rounds` rounds, the dual realised at the end. Throws what validate throws, E_USPLIT, and Error{limit,
/// "E_COUNT_OVERFLOW"} past 2^62.
Counts counts(const Word& word, const Counts& start, int rounds);
/// The same, handing on the counts after each atom (the complex that the atom leaves).
Counts counts(const Word& word, const Counts& start, int rounds, const std::function<void(const Counts&)>& after_each_atom);
/// Points of a curve after `rounds` rounds.
std::int64_t count_points(const Word& word, std::int64_t points, bool closed, int corners, int rounds);

}  // namespace udcp
