// Pictures of proofs and schemes as SVG text: regions, basic limit functions, masks, eigenvalues, characteristic maps. Floating
// point throughout: a picture proves nothing.
#pragma once

#include <complex>
#include <string>
#include <vector>

#include "operators/word.h"
#include "proofs/parameter_box.h"

namespace udcp {

/// The limit of the data 0 .. 0 1 0 .. 0 and its first derivatives (up to two), each scaled to height 1, in units of old points.
std::string picture_of_basic_function(const Word& word, int derivatives);
/// The coefficients of a mask as bars over their offsets; negative ones hang down.
std::string picture_of_mask(const Word& word);
/// Cells over one or two parameters: green proved, red refuted, grey undecided.
std::string picture_of_region(const std::vector<RegionCell>& cells, const ParameterBox& box, const std::string& title);

/// Moduli of eigenvalues (up) by valence (right), a colour per frequency.
struct EigenvalueColumn {
  int valence = 0;
  std::vector<std::vector<std::complex<double>>> by_frequency;
};
std::string picture_of_eigenvalues(const std::vector<EigenvalueColumn>& columns);

}  // namespace udcp
