// The map is interpolated between samples of "viridis" (S. van der Walt and N. Smith, CC0), which is even in lightness.
#include "files/colour_map.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace udcp {

Colour colour_map(double t) {
  constexpr std::array<Colour, 9> samples{{{0.267004, 0.004874, 0.329415},
                                           {0.281412, 0.155834, 0.469201},
                                           {0.244972, 0.287675, 0.537260},
                                           {0.190631, 0.407061, 0.556089},
                                           {0.127568, 0.566949, 0.550556},
                                           {0.157851, 0.683765, 0.501686},
                                           {0.477504, 0.821444, 0.318195},
                                           {0.741388, 0.873449, 0.149561},
                                           {0.993248, 0.906157, 0.143936}}};
  const double place = std::clamp(t, 0.0, 1.0) * (samples.size() - 1);
  const auto k = std::min(static_cast<std::size_t>(place), samples.size() - 2);
  const double w = place - static_cast<double>(k);
  Colour result{};
  for (std::size_t c = 0; c < 3; ++c) result[c] = (1 - w) * samples[k][c] + w * samples[k + 1][c];
  return result;
}

Colour ColourScale::at(double value) const {
  if (zero_matters && value <= 0) {
    constexpr Colour at_zero{0.95, 0.45, 0.33}, at_least{0.5, 0.0, 0.05};
    const double t = low < 0 ? std::clamp(value / low, 0.0, 1.0) : 0.0;
    Colour result{};
    for (std::size_t c = 0; c < 3; ++c) result[c] = (1 - t) * at_zero[c] + t * at_least[c];
    return result;
  }
  const double start = zero_matters ? 0 : low;
  const double range = high / 2 - start / 2;  // halves: the difference of two large numbers may overflow
  const double t = (value / 2 - start / 2) / range;
  return colour_map(range > 0 && std::isfinite(t) ? t : 0.5);
}

ColourScale colour_scale(std::span<const double> values, bool zero_matters) {
  const auto [low, high] = std::ranges::minmax(values);
  return {low, high, zero_matters};
}

Colour linear(const Colour& srgb) {
  Colour result{};
  std::ranges::transform(srgb, result.begin(),
                         [](double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); });
  return result;
}

}  // namespace udcp
