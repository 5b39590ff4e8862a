// The characteristic map as a picture: cells of the limit surface with the size of the Jacobian, in double. Decides nothing.
#pragma once

#include <array>
#include <complex>
#include <string>
#include <vector>

#include "operators/word.h"

namespace udcp {

/// A cell of the image: corners counter-clockwise from the one nearest to the centre, and the Jacobian about its middle with
/// respect to the coordinates of the cell of the coarse lattice that it came from.
struct CharacteristicCell {
  int sector = 0;
  std::array<std::complex<double>, 4> corners;
  double jacobian = 0;
};
/// The ring of all sectors, each cell split `depth` times (0 to 6), and `rings` - 1 copies inside, each smaller by lambda. The
/// point 1 is a place on spoke 0 (around faces: on the direction of the bisector, the first point). Empty, with the reason in
/// `why`, for words that the theorem does not cover and where frequency 1 has no simple real dominant eigenvalue. Throws
/// Error{not_exact}.
std::vector<CharacteristicCell> characteristic_cells(const Word& word, int valence, int depth = 2, int rings = 1,
                                                     std::string* why = nullptr);

}  // namespace udcp
