// The characteristic map of an extraordinary point: its control net beyond the eigenvector, the ring of cells that it is looked
// at on, which points a cell depends on, and the Bernstein certificate. Searches for nothing.
#pragma once

#include <optional>

#include "proofs/blocks.h"
#include "proofs/regular_part.h"
#include "proofs/spectrum.h"

namespace udcp {

/// Offsets (half steps from the first corner of a cell) of the points that the limit over the cell depends on, and of the
/// differences that its derivatives depend on: the smallest sets that subdivision does not leave.
struct CellSets {
  std::vector<Place> position, du, dv;
};
template <class S>
CellSets cell_sets(const RegularPart<S>& part, bool dual);

/// The cells (first corners, half steps) with i0 <= max(i, j) < 2 i0 in sector 0, where i0 is the least number such that no cell
/// from there on depends on points beyond both of its spokes.
struct Ring {
  int first = 1;  // i0
  std::vector<Place> cells;
};
/// Nothing if i0 would be above 6.
std::optional<Ring> ring_of(const CellSets& sets);
/// The largest radius of a point of the ring's cells, or of their children, as points after one round.
int rows_needed(const Sectors& sectors, const CellSets& sets, const Ring& ring);
/// The largest radius of a point that the ring's cells depend on.
int net_needed(const Sectors& sectors, const CellSets& sets, const Ring& ring);
/// Whether the rows of the points that the children of the ring's cells depend on are those of the regular mask, and
/// those of all later rounds too, because they are out of reach of the centre.
template <class S>
bool rows_are_regular(const Patch<S>& patch, const LatticeMask<S>& mask, const CellSets& sets, const Ring& ring);

/// The net of the subdominant eigenvector of frequency 1: v at old and new points of one name differ by the factor lambda.
class CharacteristicNet {
 public:
  /// On points within `extent`; beyond the invariant radius, v(l) = row(l) v / lambda.
  CharacteristicNet(const Patch<Interval>& patch, int invariant, const Eigenpair& pair, int extent);
  /// The value at a place of the frame of sector 0.
  [[nodiscard]] const Complex& at(Place place) const;
  [[nodiscard]] const Sectors& sectors() const { return sectors_; }

 private:
  Sectors sectors_;
  std::map<Label, Complex> values_;
};

/// The mask is that of bicubic B-splines.
template <class S>
bool is_bicubic(const LatticeMask<S>& mask);
/// For the bicubic mask: bounds over the Bezier patches of the ring. Both positive: the characteristic map is regular and
/// injective (the coefficients bound the Jacobian, and each sector's part lies in a half plane around its bisector).
struct BernsteinBounds {
  Interval jacobian;    // the least coefficient
  Interval half_plane;  // the least Re(e^{-i pi/n} b) of a Bezier point b, or 1
};
BernsteinBounds bernstein_bounds(const CharacteristicNet& net);

}  // namespace udcp
