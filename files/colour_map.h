// A perceptual colour map from dark violet over green to yellow, for scalar values. Knows no file format.
#pragma once

#include <array>

namespace udcp {

/// Red, green and blue in [0, 1].
using Colour = std::array<double, 3>;

/// t in [0, 1] (clamped) to sRGB.
Colour colour_map(double t);
/// sRGB to linear light, which is what glTF vertex colours are.
Colour linear(const Colour& srgb);

}  // namespace udcp
