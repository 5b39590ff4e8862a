// Layers in pixels; the white ground makes svg() draw them in scale 1.
#include "interpreter/picture_scene.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace udcp {

Scene::Scene(double width, double height) : longer_(std::max(width, height)) {
  polygon({{0, 0}, {width, 0}, {width, height}, {0, height}}, "#ffffff");
}

SvgLayer& Scene::line(const std::vector<Pixel>& places, const std::string& stroke, double width) {
  SvgLayer layer;
  layer.points.resize(static_cast<Eigen::Index>(places.size()), 2);
  for (std::size_t k = 0; k < places.size(); ++k) layer.points.row(static_cast<Eigen::Index>(k)) << places[k].x, -places[k].y;
  layer.stroke = stroke;
  layer.width = width;
  layers_.push_back(std::move(layer));
  return layers_.back();
}

SvgLayer& Scene::segments(const std::vector<Pixel>& places, const std::string& stroke, double width) {
  SvgLayer& layer = line(places, stroke, width);
  layer.segments = true;
  return layer;
}

SvgLayer& Scene::polygon(const std::vector<Pixel>& places, const std::string& fill, double opacity) {
  SvgLayer& layer = line(places, "none", 0.5);
  layer.closed = true;
  layer.fill = fill;
  layer.opacity = opacity;
  return layer;
}

SvgLayer& Scene::dots(const std::vector<Pixel>& places, const std::string& colour, double radius) {
  SvgLayer& layer = line(places, colour, 0);
  layer.markers = true;
  layer.marker_size = radius;
  return layer;
}

void Scene::text(Pixel place, const std::string& words, const std::string& colour, const std::string& anchor, double size) {
  SvgLayer& layer = line({place}, colour, 0);
  layer.text = words;
  layer.anchor = anchor;
  layer.text_size = size;
}

void Scene::circle(Pixel centre, double radius, const std::string& stroke) {
  std::vector<Pixel> rim;
  for (int k = 0; k < 72; ++k) {
    const double angle = k * std::numbers::pi / 36;
    rim.push_back({centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle)});
  }
  line(rim, stroke, 0.8).closed = true;
}

std::string Scene::draw(const std::string& title) const {
  SvgOptions options;
  options.size = longer_;
  options.margin = 0;
  options.title = title;
  return svg(layers_, options);
}

}  // namespace udcp
