// SVG text from layers and meshes: projection, view box, painter's algorithm.
#include "files/svg.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "files/colour_map.h"
#include "files/mesh_view.h"

namespace udcp {
namespace {

/// Coordinate c of a point; missing coordinates are 0.
double coordinate(const Points<double>& points, Eigen::Index row, Eigen::Index c) {
  return c < points.cols() ? points(row, c) : 0.0;
}

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
  [[nodiscard]] std::pair<std::string, std::string> place_apart(double x, double y) const {
    return {pixels((x - low_x_) * scale_ + margin_), pixels((high_y_ - y) * scale_ + margin_)};
  }
  [[nodiscard]] std::string place(double x, double y) const {
    const auto [right, down] = place_apart(x, y);
    return right + "," + down;
  }
  /// Room for a column of the width beside what is drawn, at least so high; returns where it begins.
  double add_column(double width, double height) {
    const double start = width_;
    width_ += width;
    height_ = std::max(height_, height);
    return start;
  }
  [[nodiscard]] double height() const { return height_; }
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

void draw_text(Writer& out, const SvgLayer& layer, const Points<double>& plane, const Frame& frame) {
  const auto [x, y] = frame.place_apart(plane(0, 0), plane(0, 1));
  out << "<text x=\"" << x << "\" y=\"" << y << "\" font-family=\"sans-serif\" font-size=\"" << pixels(layer.text_size)
      << "\" text-anchor=\"" << escaped(layer.anchor) << "\" fill=\"" << escaped(layer.stroke) << "\">" << escaped(layer.text)
      << "</text>\n";
}

void draw_segments(Writer& out, const Points<double>& plane, const Frame& frame) {
  out << " d=\"";
  for (Eigen::Index k = 0; k + 1 < plane.rows(); k += 2)
    out << 'M' << frame.place(plane(k, 0), plane(k, 1)) << 'L' << frame.place(plane(k + 1, 0), plane(k + 1, 1));
  out << "\"/>\n";
}

void draw_line(Writer& out, const SvgLayer& layer, const Points<double>& plane, const Frame& frame) {
  out << (layer.segments ? "<path"
          : layer.closed ? "<polygon"
                         : "<polyline")
      << " fill=\"" << escaped(layer.fill) << "\" stroke=\"" << escaped(layer.stroke) << "\" stroke-width=\""
      << pixels(layer.width) << "\" stroke-linejoin=\"round\"";
  if (!layer.dash.empty()) out << " stroke-dasharray=\"" << escaped(layer.dash) << '"';
  if (layer.opacity < 1) out << " opacity=\"" << pixels(layer.opacity) << '"';
  if (layer.segments) return draw_segments(out, plane, frame);
  out << " points=\"";
  for (Eigen::Index k = 0; k < plane.rows(); ++k) out << (k > 0 ? " " : "") << frame.place(plane(k, 0), plane(k, 1));
  out << "\"/>\n";
}

void draw_layer(Writer& out, const SvgLayer& layer, const Points<double>& plane, const Frame& frame) {
  if (!layer.text.empty() && plane.rows() > 0) return draw_text(out, layer, plane, frame);
  if (layer.width > 0 && plane.rows() > 1) draw_line(out, layer, plane, frame);
  if (!layer.markers) return;
  out << "<g fill=\"" << escaped(layer.stroke) << '"';
  if (layer.opacity < 1) out << " opacity=\"" << pixels(layer.opacity) << '"';
  out << ">\n";
  for (Eigen::Index k = 0; k < plane.rows(); ++k) {
    const auto [x, y] = frame.place_apart(plane(k, 0), plane(k, 1));
    out << "<circle cx=\"" << x << "\" cy=\"" << y << "\" r=\""
        << pixels(layer.marker_size > 0 ? layer.marker_size : 1.2 + layer.width) << "\"/>\n";
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

const std::vector<double>& colour_values(const Surface<double>& surface, const SvgMeshOptions& options) {
  const auto found = surface.attributes.find(options.colour_attribute);
  if (found == surface.attributes.end()) {
    throw Error(ErrorKind::input, "E_ATTRIBUTE",
                "the surface has no attribute '" + options.colour_attribute + "' to show as colour");
  }
  return found->second;
}

/// A bar of colours from the least to the greatest value, with zero inside where it matters.
class ColourBar {
 public:
  /// x: its left side; height: of the picture.
  ColourBar(const ColourScale& scale, double x, double height)
      : scale_(scale),
        low_(scale.zero_matters ? std::min(scale.low, 0.0) : scale.low),
        high_(scale.zero_matters ? std::max(scale.high, 0.0) : scale.high),
        x_(x),
        bottom_(height - 20) {}

  void draw(Writer& out, const std::string& name) const {
    constexpr int steps = 48;
    const double step = (bottom_ - top) / steps;
    out << "<g font-family=\"sans-serif\" font-size=\"12\" fill=\"#202020\">\n";
    write(out, x_, 14, name);
    for (int k = 0; k < steps; ++k) {
      const double share = k == 0 && scale_.low == 0 ? 0 : (k + 0.5) / steps;  // so that a least value of 0 shows
      out << "<rect x=\"" << pixels(x_) << "\" y=\"" << pixels(bottom_ - (k + 1) * step) << "\" width=\"" << pixels(width)
          << "\" height=\"" << pixels(step + 0.6) << "\" fill=\"" << hex(scale_.at(low_ * (1 - share) + high_ * share), 1)
          << "\"/>\n";
    }
    mark(out, scale_.high, place(scale_.high), "max ");
    const bool crowded = std::abs(place(scale_.low) - place(0)) < spacing;
    if (scale_.low < scale_.high)
      mark(out, scale_.low, crowded && scale_.low > 0 ? place(0) - spacing : place(scale_.low), "min ");
    if (scale_.zero_matters && scale_.low != 0 && scale_.high != 0)
      mark(out, 0, crowded && scale_.low < 0 ? place(scale_.low) - spacing : place(0), "");
    out << "</g>\n";
  }

 private:
  static constexpr double top = 36, width = 14, spacing = 14;
  [[nodiscard]] double place(double value) const {
    const double t = (value / 2 - low_ / 2) / (high_ / 2 - low_ / 2);
    return bottom_ - (bottom_ - top) * (std::isfinite(t) ? t : 0.5);
  }
  static void write(Writer& out, double x, double y, const std::string& text) {
    out << "<text x=\"" << pixels(x) << "\" y=\"" << pixels(y + 4) << "\">" << escaped(text) << "</text>\n";
  }
  void mark(Writer& out, double value, double text_at, const char* label) const {
    char digits[40];
    const auto end = std::to_chars(digits, digits + sizeof digits, value, std::chars_format::general, 4).ptr;
    out << "<path stroke=\"#202020\" d=\"M" << pixels(x_) << ',' << pixels(place(value)) << "h" << pixels(width + 5) << "\"/>\n";
    write(out, x_ + width + 8, text_at, label + std::string(digits, end));
  }

  ColourScale scale_;
  double low_, high_, x_, bottom_;
};

/// Colour per face before shading, and the faces that must not be hidden where several lie in one plane.
struct FaceColours {
  std::vector<Colour> colour;
  std::vector<char> warned;
};
FaceColours face_colours(const Surface<double>& surface, const SvgMeshOptions& options) {
  const Mesh& mesh = *surface.mesh;
  const auto faces = static_cast<std::size_t>(mesh.faces());
  FaceColours result{std::vector<Colour>(faces, parse_colour(options.fill)), std::vector<char>(faces, 0)};
  if (options.colour_attribute.empty()) return result;
  const std::vector<double>& values = colour_values(surface, options);
  const ColourScale scale = colour_scale(values, options.zero_matters);
  for (int f = 0; f < mesh.faces(); ++f) {
    double sum = 0, least = std::numeric_limits<double>::infinity();
    for (const int v : mesh.corners(f)) {
      sum += values[Mesh::i(v)];
      least = std::min(least, values[Mesh::i(v)]);
    }
    const bool warned = options.zero_matters && least <= 0;  // a mean would hide a corner that is not positive
    result.warned[Mesh::i(f)] = warned ? 1 : 0;
    result.colour[Mesh::i(f)] = scale.at(warned ? least : sum / mesh.size(f));
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
  Writer out(1000);
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
  const FaceColours colours = face_colours(surface, options);
  std::ranges::stable_sort(order, [&](int a, int b) {
    return std::pair(depth[Mesh::i(a)], colours.warned[Mesh::i(a)]) < std::pair(depth[Mesh::i(b)], colours.warned[Mesh::i(b)]);
  });
  const auto axis = [&](const Vector& direction) {
    return Vector(direction.dot(eye.right), direction.dot(eye.up), direction.dot(eye.towards));
  };
  const Vector seen_light = axis(light);
  Writer out(static_cast<std::size_t>(mesh.half_edges()) * 16 + 1000);
  const bool legend = options.legend && !options.colour_attribute.empty();
  const double column = legend ? frame.add_column(115, 160) : 0;
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
    const std::string fill = hex(colours.colour[Mesh::i(f)], 0.45 + 0.65 * std::max(0.0, std::isfinite(cosine) ? cosine : 0.0));
    out << "<polygon fill=\"" << fill << '"';
    if (!options.edges) out << " stroke=\"" << fill << '"';  // covers the hair lines between neighbours
    out << " points=\"";
    for (std::size_t k = 0; k < corners.size(); ++k)
      out << (k > 0 ? " " : "") << frame.place(seen(corners[k], 0), seen(corners[k], 1));
    out << "\"/>\n";
  }
  out << "</g>\n";
  if (legend)
    ColourBar(colour_scale(colour_values(surface, options), options.zero_matters), column, frame.height())
        .draw(out, options.colour_attribute);
  out << "</svg>\n";
  return out.take();
}

}  // namespace udcp
