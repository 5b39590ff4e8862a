// SVG text from layers and meshes: projection, view box, painter's algorithm.
#include "files/svg.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "files/colour_map.h"
#include "files/text_writer.h"

namespace udcp {
namespace {

using Vector = Eigen::Vector3d;

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '<') {
      result += "&lt;";
    } else if (c == '>') {
      result += "&gt;";
    } else if (c == '&') {
      result += "&amp;";
    } else if (c == '"') {
      result += "&quot;";
    } else {
      result += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
    }
  }
  return result;
}

/// Hundredths of a pixel are enough; "-0" would only be noise.
std::string pixels(double value) {
  char digits[64];
  const double rounded = std::round(value * 100) / 100;
  const auto end = std::to_chars(digits, digits + sizeof digits, rounded == 0 ? 0.0 : rounded).ptr;
  return {digits, end};
}

/// Right, up and towards the eye, for a picture with z upwards.
struct Camera {
  Vector right, up, towards;
};

Camera camera(const std::array<double, 3>& view) {
  Camera result;
  result.towards = Vector(view[0], view[1], view[2]);
  if (!result.towards.allFinite() || !(result.towards.stableNorm() > 0)) {
    throw Error(ErrorKind::input, "E_VIEW", "the view direction must be a vector that is not zero");
  }
  result.towards.stableNormalize();
  const Vector pole = std::abs(result.towards.z()) > 0.999 ? Vector::UnitY() : Vector::UnitZ();
  result.right = pole.cross(result.towards).normalized();
  result.up = result.towards.cross(result.right);
  return result;
}

/// From plane coordinates to pixels: one scale for both axes, y downwards.
class Frame {
 public:
  void include(double x, double y) {
    if (!std::isfinite(x) || !std::isfinite(y)) {
      throw Error(ErrorKind::input, "E_NOT_FINITE", "a point of the picture is not finite; nothing was drawn");
    }
    low_x_ = std::min(low_x_, x);
    high_x_ = std::max(high_x_, x);
    low_y_ = std::min(low_y_, y);
    high_y_ = std::max(high_y_, y);
  }
  void fit(const SvgOptions& options) {
    if (!(low_x_ <= high_x_)) low_x_ = high_x_ = low_y_ = high_y_ = 0;
    const double width = high_x_ - low_x_, height = high_y_ - low_y_, longer = std::max(width, height);
    const double inner = std::max(1.0, options.size - 2 * options.margin);
    const bool usable = longer > 0 && std::isfinite(longer) && std::isfinite(inner / longer);
    scale_ = usable ? inner / longer : 1;
    margin_ = options.margin;
    width_ = (usable ? width * scale_ : 1) + 2 * margin_;
    height_ = (usable ? height * scale_ : 1) + 2 * margin_;
  }
  [[nodiscard]] std::string place(double x, double y) const {
    return pixels((x - low_x_) * scale_ + margin_) + "," + pixels((high_y_ - y) * scale_ + margin_);
  }
  [[nodiscard]] std::string open(const SvgOptions& options) const {
    const std::string size = " width=\"" + pixels(width_) + "\" height=\"" + pixels(height_) + "\"";
    std::string text =
        "<svg xmlns=\"http://www.w3.org/2000/svg\"" + size + " viewBox=\"0 0 " + pixels(width_) + " " + pixels(height_) + "\">\n";
    if (!options.title.empty()) text += "<title>" + escaped(options.title) + "</title>\n";
    if (!options.background.empty()) text += "<rect" + size + " fill=\"" + escaped(options.background) + "\"/>\n";
    return text;
  }

 private:
  double low_x_ = std::numeric_limits<double>::infinity(), high_x_ = -low_x_, low_y_ = low_x_, high_y_ = -low_x_;
  double scale_ = 1, margin_ = 0, width_ = 0, height_ = 0;
};

/// All layers in the plane of the picture, two columns each.
std::vector<Points<double>> project(const std::vector<SvgLayer>& layers, const SvgOptions& options) {
  bool flat = true;
  for (const SvgLayer& layer : layers) {
    if (layer.points.cols() > 3)
      throw Error(ErrorKind::input, "E_DIMENSION", "a picture shows points with one to three coordinates");
    if (layer.points.cols() == 3 && layer.points.rows() > 0) flat = flat && layer.points.col(2).isConstant(layer.points(0, 2), 0);
  }
  const Camera eye = camera(options.view);
  std::vector<Points<double>> result;
  for (const SvgLayer& layer : layers) {
    Points<double> plane(layer.points.rows(), 2);
    for (Eigen::Index k = 0; k < plane.rows(); ++k) {
      const Vector p(coordinate(layer.points, k, 0), coordinate(layer.points, k, 1), coordinate(layer.points, k, 2));
      if (layer.points.cols() == 1) {
        plane.row(k) << static_cast<double>(k), p.x();
      } else if (flat) {
        plane.row(k) << p.x(), p.y();
      } else {
        plane.row(k) << p.dot(eye.right), p.dot(eye.up);
      }
    }
    result.push_back(std::move(plane));
  }
  return result;
}

void draw_layer(TextWriter& out, const SvgLayer& layer, const Points<double>& plane, const Frame& frame) {
  const std::string stroke = escaped(layer.stroke);
  if (layer.width > 0 && plane.rows() > 1) {
    out << (layer.closed ? "<polygon" : "<polyline") << " fill=\"" << escaped(layer.fill) << "\" stroke=\"" << stroke
        << "\" stroke-width=\"" << pixels(layer.width) << "\" stroke-linejoin=\"round\"";
    if (!layer.dash.empty()) out << " stroke-dasharray=\"" << escaped(layer.dash) << '"';
    out << " points=\"";
    for (Eigen::Index k = 0; k < plane.rows(); ++k) out << (k > 0 ? " " : "") << frame.place(plane(k, 0), plane(k, 1));
    out << "\"/>\n";
  }
  if (!layer.markers) return;
  out << "<g fill=\"" << stroke << "\">\n";
  for (Eigen::Index k = 0; k < plane.rows(); ++k) {
    const std::string place = frame.place(plane(k, 0), plane(k, 1));
    const auto comma = place.find(',');
    out << "<circle cx=\"" << place.substr(0, comma) << "\" cy=\"" << place.substr(comma + 1) << "\" r=\""
        << pixels(1.2 + layer.width) << "\"/>\n";
  }
  out << "</g>\n";
}

Colour parse_colour(const std::string& text) {
  Colour result{0.56, 0.7, 0.85};
  if (text.size() != 7 || text[0] != '#') return result;
  for (std::size_t c = 0; c < 3; ++c) {
    int value = 0;
    std::from_chars(text.data() + 1 + 2 * c, text.data() + 3 + 2 * c, value, 16);
    result[c] = value / 255.0;
  }
  return result;
}

std::string hex(const Colour& colour, double light) {
  constexpr const char* digits = "0123456789abcdef";
  std::string text = "#";
  for (const double channel : colour) {
    const auto value = static_cast<unsigned>(std::lround(255 * std::clamp(channel * light, 0.0, 1.0)));
    text += digits[value / 16];
    text += digits[value % 16];
  }
  return text;
}

/// Colour per face before shading.
std::vector<Colour> face_colours(const Surface<double>& surface, const SvgMeshOptions& options) {
  const Mesh& mesh = *surface.mesh;
  std::vector<Colour> result(static_cast<std::size_t>(mesh.faces()), parse_colour(options.fill));
  if (options.colour_attribute.empty()) return result;
  const auto found = surface.attributes.find(options.colour_attribute);
  if (found == surface.attributes.end()) {
    throw Error(ErrorKind::input, "E_ATTRIBUTE",
                "the surface has no attribute '" + options.colour_attribute + "' to show as colour");
  }
  const auto [low, high] = std::ranges::minmax(found->second);
  for (int f = 0; f < mesh.faces(); ++f) {
    double sum = 0;
    for (const int v : mesh.corners(f)) sum += found->second[Mesh::i(v)];
    const double t = (sum / mesh.size(f) - low) / (high - low);
    result[Mesh::i(f)] = colour_map(std::isfinite(t) ? t : 0.5);
  }
  return result;
}

}  // namespace

std::string svg(const std::vector<SvgLayer>& layers, const SvgOptions& options) {
  const auto planes = project(layers, options);
  Frame frame;
  for (const auto& plane : planes) {
    for (Eigen::Index k = 0; k < plane.rows(); ++k) frame.include(plane(k, 0), plane(k, 1));
  }
  frame.fit(options);
  TextWriter out(1000);
  out << frame.open(options);
  for (std::size_t k = 0; k < layers.size(); ++k) draw_layer(out, layers[k], planes[k], frame);
  double line = 16;
  for (const SvgLayer& layer : layers) {
    if (layer.label.empty()) continue;
    out << "<text x=\"8\" y=\"" << pixels(line) << "\" font-family=\"sans-serif\" font-size=\"12\" fill=\""
        << escaped(layer.stroke) << "\">" << escaped(layer.label) << "</text>\n";
    line += 15;
  }
  out << "</svg>\n";
  return out.take();
}

std::string svg_curve(const Polyline<double>& curve, const SvgOptions& options) {
  validate(curve);
  SvgLayer layer;
  layer.points = curve.points;
  layer.closed = curve.closed;
  return svg({layer}, options);
}

std::string svg_mesh(const Surface<double>& surface, const SvgMeshOptions& options) {
  check_for_writing(surface);
  const Mesh& mesh = *surface.mesh;
  const Camera eye = camera(options.view);
  const Vector light = (eye.towards + 0.6 * eye.up - 0.5 * eye.right).normalized();
  Points<double> seen(mesh.vertices(), 3);  // right, up, towards the eye
  Frame frame;
  for (int v = 0; v < mesh.vertices(); ++v) {
    const Vector p(coordinate(surface.points, v, 0), coordinate(surface.points, v, 1), coordinate(surface.points, v, 2));
    seen.row(v) << p.dot(eye.right), p.dot(eye.up), p.dot(eye.towards);
    frame.include(seen(v, 0), seen(v, 1));
  }
  frame.fit(options);
  std::vector<double> depth(static_cast<std::size_t>(mesh.faces()), 0);
  std::vector<int> order(depth.size());
  std::iota(order.begin(), order.end(), 0);
  for (int f = 0; f < mesh.faces(); ++f) {
    for (const int v : mesh.corners(f)) depth[Mesh::i(f)] += seen(v, 2) / mesh.size(f);
  }
  std::ranges::stable_sort(order, [&](int a, int b) { return depth[Mesh::i(a)] < depth[Mesh::i(b)]; });
  const auto colours = face_colours(surface, options);
  const auto axis = [&](const Vector& direction) {
    return Vector(direction.dot(eye.right), direction.dot(eye.up), direction.dot(eye.towards));
  };
  const Vector seen_light = axis(light);
  TextWriter out(static_cast<std::size_t>(mesh.half_edges()) * 16 + 1000);
  out << frame.open(options) << "<g stroke-width=\"" << pixels(options.edges ? options.edge_width : 0.4)
      << "\" stroke-linejoin=\"round\"";
  if (options.edges) out << " stroke=\"" << escaped(options.edge_colour) << '"';
  out << ">\n";
  for (const int f : order) {
    const auto corners = mesh.corners(f);
    Vector normal = Vector::Zero();
    for (std::size_t k = 1; k + 1 < corners.size(); ++k) {
      const Vector a = (seen.row(corners[k]) - seen.row(corners[0])).transpose(),
                   b = (seen.row(corners[k + 1]) - seen.row(corners[0])).transpose();
      normal += a.cross(b);
    }
    normal.stableNormalize();
    const double cosine = (normal.z() < 0 ? -1.0 : 1.0) * normal.dot(seen_light);
    const std::string fill = hex(colours[Mesh::i(f)], 0.45 + 0.65 * std::max(0.0, std::isfinite(cosine) ? cosine : 0.0));
    out << "<polygon fill=\"" << fill << '"';
    if (!options.edges) out << " stroke=\"" << fill << '"';  // covers the hair lines between neighbours
    out << " points=\"";
    for (std::size_t k = 0; k < corners.size(); ++k)
      out << (k > 0 ? " " : "") << frame.place(seen(corners[k], 0), seen(corners[k], 1));
    out << "\"/>\n";
  }
  out << "</g>\n</svg>\n";
  return out.take();
}

}  // namespace udcp
