// Neighbourhoods of an extraordinary vertex or face as labelled lattices, and the rows of one round on them, from unit vectors
// run through the word. Knows symmetry and places, no spectrum.
#pragma once

#include <algorithm>
#include <compare>
#include <map>

#include "operators/matrix.h"

namespace udcp {

/// A place in the frame of one sector, in half steps: x along spoke s, y along spoke s + 1. Odd for the points of dual words.
struct Place {
  int x = 0, y = 0;
  friend auto operator<=>(const Place&, const Place&) = default;
};
/// A point of the lattice: sector s, a > 0 half steps along its first spoke and b >= 0 along the second; the centre is {0, 0, 0}.
struct Label {
  int s = 0, a = 0, b = 0;
  [[nodiscard]] bool is_centre() const { return a == 0 && b == 0; }
  friend auto operator<=>(const Label&, const Label&) = default;
};

/// `valence` sectors of a quad or triangle lattice around a vertex, or of a quad lattice around a face (dual).
struct Sectors {
  int valence = 4;
  bool triangles = false;
  bool dual = false;

  [[nodiscard]] int regular_valence() const { return triangles ? 6 : 4; }
  /// The point at a place of the frame of sector s, which may lie in another sector.
  [[nodiscard]] Label label(int s, Place place) const;
  /// The place of a point in the frame of sector s; it must lie in sector s or one of its two neighbours.
  [[nodiscard]] Place seen_from(int s, const Label& label) const;
  [[nodiscard]] Label rotated(const Label& label, int sectors) const;
  /// The mirror image in spoke 0.
  [[nodiscard]] Label mirrored(const Label& label) const;
  /// Distance from the centre in half steps: max(a, b), on triangles a + b.
  [[nodiscard]] int radius(const Label& label) const { return triangles ? label.a + label.b : std::max(label.a, label.b); }
  /// A quarter turn of the lattice (60 degrees on triangles) and back: the change from one frame to the next.
  [[nodiscard]] Place turned(Place p) const { return {-p.y, triangles ? p.x + p.y : p.x}; }
  [[nodiscard]] Place turned_back(Place p) const { return {triangles ? p.x + p.y : p.y, -p.x}; }
};

/// new point = sum of weight * old point; no zero weights.
template <class S>
using Row = std::map<Label, S>;

/// Rows of the centre and of sector 0; those of the other sectors are rotated copies. A new label and the old label of the same
/// name are the same place: labels of old points are doubled by U.
template <class S>
struct Patch {
  Sectors sectors;
  int reach = 0;   // a new point at l is influenced by old points within radius (radius(l) + reach)/2 only, by the atoms alone
  int radius = 0;  // rows up to this radius are here
  std::map<Label, Row<S>> rows;

  /// Points of sector 0 within a radius, rising.
  [[nodiscard]] std::vector<Label> orbits(int within) const;
};

/// Whether the theorems on extraordinary points speak of this word: a scheme with exactly one U[2] per round. `why` says why not.
bool has_one_split(const Word& word, std::string* why = nullptr);
/// The lattice that the rounds of the word live on around a vertex (or face, for an odd number of D) of this valence.
Sectors sectors_of(const Word& word, int valence);

/// The rows of round 0 within `radius` half steps around a point of valence >= 3. The patch is large enough that by the reach of
/// the atoms no row can see its rim. Throws Error{limit, "E_TOO_LARGE"}, what run() throws, and Error{not_exact} for parameters
/// that S cannot hold.
template <class S>
Patch<S> patch(const Word& word, int valence, int radius);

/// All rows sum to 1.
template <class S>
bool reproduces_constants(const Patch<S>& patch);
/// The mirror image of a row is the row of the mirror image.
template <class S>
bool is_mirror_symmetric(const Patch<S>& patch);
/// Smallest radius r such that rows within r use radius <= r only and all others smaller radii than their own, so that the points
/// beyond r add nothing but the eigenvalue 0. Needs rows up to reach + 2. Throws Error{internal} if there is none.
template <class S>
int invariant_radius(const Patch<S>& patch);
/// Smallest radius r > 0 such that rows within r use radius <= r only.
template <class S>
int closed_radius(const Patch<S>& patch);

/// The same rows in another number type.
template <class T, class S>
Patch<T> converted(const Patch<S>& patch);

}  // namespace udcp
