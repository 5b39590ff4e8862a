// Legends of coloured shapes.
#include "interpreter/colour_bar.h"

#include <algorithm>
#include <array>
#include <charconv>

namespace udcp {
namespace {

constexpr int steps = 32;

std::string digits(double value) {
  std::array<char, 40> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, 5).ptr;
  return {text.data(), end};
}

const std::vector<double>& values_of(const Surface<double>& surface, const std::string& attribute) {
  const auto found = surface.attributes.find(attribute);
  if (found == surface.attributes.end() || found->second.empty())
    throw Error(ErrorKind::input, "E_ATTRIBUTE", "the surface has no attribute '" + attribute + "' to show as colour");
  return found->second;
}

}  // namespace

Surface<double> colour_bar(const Surface<double>& surface, const std::string& attribute) {
  const auto [low, high] = std::ranges::minmax(values_of(surface, attribute));
  Eigen::RowVector3d least = Eigen::RowVector3d::Zero(), most = least;
  least.head(surface.points.cols()) = surface.points.colwise().minCoeff();
  most.head(surface.points.cols()) = surface.points.colwise().maxCoeff();
  const double size = (most - least).norm(), height = std::max(most[2] - least[2], 0.4 * size), left = most[0] + 0.08 * size;
  Surface<double> bar;
  bar.points.resize(2 * (steps + 1), 3);
  std::vector<std::vector<int>> faces;
  for (int k = 0; k <= steps; ++k) {
    const double t = static_cast<double>(k) / steps;
    for (int side = 0; side < 2; ++side) {
      bar.points.row(2 * k + side) << left + 0.04 * size * side, (least[1] + most[1]) / 2, least[2] + t * height;
      bar.attributes[attribute].push_back((1 - t) * low + t * high);
    }
    if (k < steps) faces.push_back({2 * k, 2 * k + 1, 2 * k + 3, 2 * k + 2});
  }
  bar.mesh = std::make_shared<const Mesh>(make_mesh(2 * (steps + 1), faces));
  return bar;
}

void save_with_legend(const Surface<double>& surface, const std::filesystem::path& file, const SaveOptions& options) {
  const std::vector<double>& values = values_of(surface, options.colour_attribute);
  const auto [low, high] = std::ranges::minmax(values);
  const Surface<double> bar = colour_bar(surface, options.colour_attribute);
  SaveOptions of_bar;
  of_bar.colour_attribute = options.colour_attribute;
  of_bar.zero_matters = options.zero_matters;
  of_bar.parameters = {{"attribute", options.colour_attribute}, {"least", digits(low)}, {"greatest", digits(high)}};
  save_scene({{&surface, "surface", {0, 0, 0}, options},
              {&bar, "legend: " + options.colour_attribute + " from " + digits(low) + " to " + digits(high), {0, 0, 0}, of_bar}},
             file);
}

}  // namespace udcp
