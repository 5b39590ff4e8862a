// Scenes of lines and filled polygons for files/svg.h.
#include "interpreter/pictures.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "files/svg.h"
#include "operators/matrix.h"
#include "operators/run.h"

namespace udcp {
namespace {

constexpr std::array<const char*, 6> colours = {"#1f4e79", "#b5482a", "#3c7a3b", "#7a4d8f", "#8a6d1d", "#4b7f86"};

SvgLayer line(Points<double> points, const std::string& colour, double width, const std::string& label = {}) {
  SvgLayer layer;
  layer.points = std::move(points);
  layer.stroke = colour;
  layer.width = width;
  layer.label = label;
  return layer;
}

SvgLayer rectangle(double x0, double y0, double x1, double y1, const std::string& fill, const std::string& stroke) {
  SvgLayer layer;
  layer.points.resize(4, 2);
  layer.points << x0, y0, x1, y0, x1, y1, x0, y1;
  layer.closed = true;
  layer.fill = fill;
  layer.stroke = stroke;
  layer.width = 0.4;
  return layer;
}

Points<double> segment(double x0, double y0, double x1, double y1) {
  Points<double> points(2, 2);
  points << x0, y0, x1, y1;
  return points;
}

/// A number as a column of one-column points, for run().
Points<double> column(const std::vector<double>& values) {
  Points<double> points(static_cast<Eigen::Index>(values.size()), 1);
  for (std::size_t k = 0; k < values.size(); ++k) points(static_cast<Eigen::Index>(k), 0) = values[k];
  return points;
}

const char* colour_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::proved:
      return "#7fb77e";
    case Verdict::refuted:
      return "#d98880";
    case Verdict::undecided:
      break;
  }
  return "#c8c8c8";
}

double plain(const Rational& x) { return x.to_double(); }

}  // namespace

std::string picture_of_basic_function(const Word& word, int derivatives) {
  const Mask<double> m = mask<double>(word);
  const double below = static_cast<double>(m.first) / (m.arity - 1),
               above = static_cast<double>(m.first + static_cast<int>(m.coefficients.size()) - 1) / (m.arity - 1);
  const int reach = static_cast<int>(std::ceil(std::max(-below, above))) + 3;
  int rounds = 1;
  for (double points = m.arity; points < 200; points *= m.arity) ++rounds;
  std::vector<double> data(static_cast<std::size_t>(2 * reach + 1), 0.0);
  data[static_cast<std::size_t>(reach)] = 1;
  Polyline<double> curve;
  curve.points = column(data);
  curve.closed = true;  // wide enough that the ends never meet
  const Polyline<double> fine = run(word, curve, rounds);
  const double scale = std::pow(static_cast<double>(m.arity), rounds);
  double shift = 0;  // new point k lies at (k + shift)/arity in every round
  for (int r = 0; r < rounds; ++r) shift = (shift + m.shift.to_double()) / m.arity;
  std::vector<double> values(fine.points.data(), fine.points.data() + fine.points.size());
  const double left = below - 0.5, right = above + 0.5, height = 0.5 * (right - left);
  std::vector<SvgLayer> layers{line(segment(left, 0, right, 0), "#909090", 0.6)};
  for (int k = static_cast<int>(std::ceil(left)); k <= right; ++k)
    layers.push_back(line(segment(k, -0.015 * height, k, 0.015 * height), "#909090", 0.6));
  static constexpr std::array<const char*, 3> names = {"basic limit function", "its derivative, scaled",
                                                       "its second derivative, scaled"};
  for (int d = 0; d <= std::min(derivatives, 2); ++d) {
    double most = 1e-300;
    for (const double v : values) most = std::max(most, std::abs(v));
    std::vector<std::array<double, 2>> inside;
    for (std::size_t k = 0; k < values.size(); ++k) {
      const double x = (static_cast<double>(k) + 0.5 * d) / scale + shift - reach;
      if (x >= left && x <= right) inside.push_back({x, height * values[k] / most});
    }
    Points<double> points(static_cast<Eigen::Index>(inside.size()), 2);
    for (std::size_t k = 0; k < inside.size(); ++k) points.row(static_cast<Eigen::Index>(k)) << inside[k][0], inside[k][1];
    layers.push_back(
        line(std::move(points), colours[static_cast<std::size_t>(d)], d == 0 ? 2 : 1.2, names[static_cast<std::size_t>(d)]));
    for (std::size_t k = 0; k + 1 < values.size(); ++k) values[k] = (values[k + 1] - values[k]) * scale;
    values.pop_back();
  }
  SvgOptions options;
  options.background = "#ffffff";
  return svg(layers, options);
}

std::string picture_of_mask(const Word& word) {
  const Mask<double> m = mask<double>(word);
  std::vector<SvgLayer> layers;
  const auto n = static_cast<double>(m.coefficients.size());
  for (std::size_t k = 0; k < m.coefficients.size(); ++k) {
    const double x = static_cast<double>(m.first) + static_cast<double>(k), y = 0.4 * n * m.coefficients[k];
    const int residue = ((m.first + static_cast<int>(k)) % m.arity + m.arity) % m.arity;
    layers.push_back(rectangle(x - 0.35, std::min(y, 0.0), x + 0.35, std::max(y, 0.0),
                               colours[static_cast<std::size_t>(residue % 6)], "#303030"));
  }
  layers.push_back(line(segment(m.first - 1, 0, m.first + n, 0), "#303030", 0.8));
  SvgOptions options;
  options.background = "#ffffff";
  return svg(layers, options);
}

std::string picture_of_region(const std::vector<RegionCell>& cells, const ParameterBox& box, const std::string& title) {
  std::vector<SvgLayer> layers;
  const auto share = [&](std::size_t v, const Rational& x) {
    return plain((x - *box[v].lower) / (*box[v].upper - *box[v].lower));
  };
  for (const RegionCell& cell : cells) {
    const double y0 = box.size() > 1 ? share(1, cell.lower[1]) : 0, y1 = box.size() > 1 ? share(1, cell.upper[1]) : 0.12;
    layers.push_back(rectangle(share(0, cell.lower[0]), y0, share(0, cell.upper[0]), y1, colour_of(cell.verdict), "none"));
  }
  const double top = box.size() > 1 ? 1 : 0.12;
  layers.push_back(line(segment(0, top + 0.22, 0, top + 0.22), "none", 0));  // room for the legend
  layers.push_back(rectangle(0, 0, 1, top, "none", "#303030"));
  const auto legend = [&](Verdict verdict, const char* text) {
    SvgLayer sample = line(segment(0, 0, 0, 0), colour_of(verdict), 4, text);
    layers.push_back(std::move(sample));
  };
  legend(Verdict::proved, "proved");
  legend(Verdict::refuted, "refuted");
  legend(Verdict::undecided, "undecided");
  SvgOptions options;
  options.title = title;
  options.background = "#ffffff";
  for (std::size_t v = 0; v < box.size() && v < 2; ++v)
    layers.push_back(line(segment(0, 0, 0, 0), "#303030", 0.5,
                          std::string(v == 0 ? "right: " : "up: ") + box[v].name + " from " + box[v].lower->to_string() + " to " +
                              box[v].upper->to_string()));
  return svg(layers, options);
}

std::string picture_of_eigenvalues(const std::vector<EigenvalueColumn>& columns) {
  std::vector<SvgLayer> layers;
  if (columns.empty()) return svg(layers);
  const double height = 0.8 * static_cast<double>(columns.size()) + 2;
  layers.push_back(line(segment(columns.front().valence - 1, 0, columns.back().valence + 1, 0), "#909090", 0.8));
  for (std::size_t frequency = 0;; ++frequency) {
    std::vector<std::array<double, 2>> dots;
    for (const EigenvalueColumn& column : columns) {
      if (frequency >= column.by_frequency.size()) continue;
      for (const std::complex<double>& value : column.by_frequency[frequency]) {
        if (std::abs(value) > 1e-6) dots.push_back({static_cast<double>(column.valence), height * std::abs(value)});
      }
    }
    if (dots.empty() || frequency > 60) break;
    SvgLayer layer;
    layer.points.resize(static_cast<Eigen::Index>(dots.size()), 2);
    for (std::size_t k = 0; k < dots.size(); ++k) layer.points.row(static_cast<Eigen::Index>(k)) << dots[k][0], dots[k][1];
    layer.width = 0;
    layer.markers = true;
    layer.stroke = colours[frequency % colours.size()];
    if (frequency < 6) layer.label = "frequency " + std::to_string(frequency);
    layers.push_back(std::move(layer));
  }
  SvgOptions options;
  options.background = "#ffffff";
  return svg(layers, options);
}

}  // namespace udcp
