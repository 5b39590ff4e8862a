// A perceptual colour map from dark violet over green to yellow, for scalar values, and scales that lead into it. Knows no file
// format.
#pragma once

#include <array>
#include <span>

namespace udcp {

/// Red, green and blue in [0, 1].
using Colour = std::array<double, 3>;

/// t in [0, 1] (clamped) to sRGB.
Colour colour_map(double t);

/// Values to colours. Plain: least to greatest through the map. Where zero matters: 0 to the greatest through the map, and
/// everything that is not positive in reds that no other value has, darker with the distance from 0.
struct ColourScale {
  double low = 0, high = 0;  // least and greatest value
  bool zero_matters = false;
  [[nodiscard]] Colour at(double value) const;
};
/// Of at least one value.
ColourScale colour_scale(std::span<const double> values, bool zero_matters);

/// sRGB to linear light, which is what glTF vertex colours are.
Colour linear(const Colour& srgb);

}  // namespace udcp
