// Cells of the patches, far ones first; in each the bands of light between two lines, cut out exactly along the interpolated
// phase.
#include "interpreter/reflection_lines.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "files/svg.h"

namespace udcp {
namespace {

using Vector = Eigen::Vector3d;

struct Eye {
  Vector right, up, towards;
};
Eye eye_of(const Vector& direction) {
  if (!(direction.norm() > 0) || !direction.allFinite())
    throw Error(ErrorKind::input, "E_VIEW", "the view of a picture has no direction", "");
  Eye eye;
  eye.towards = direction.normalized();
  const Vector above = std::abs(eye.towards.z()) < 0.99 ? Vector::UnitZ() : Vector::UnitY();
  eye.right = above.cross(eye.towards).normalized();
  eye.up = eye.towards.cross(eye.right);
  return eye;
}

/// A corner of a cell in the picture, with the number of the light that it mirrors, as a real number: the lights are parallel
/// circles around the axis to the right, infinitely far away.
struct Corner {
  double x = 0, y = 0, depth = 0, phase = 0;
};
using Polygon = std::vector<Corner>;
struct Cell {
  std::array<Corner, 4> corners;
  double depth = 0;
};

Corner corner_of(const PatchJet& jet, const Eye& eye, int lines) {
  Corner corner{jet.point.dot(eye.right), jet.point.dot(eye.up), jet.point.dot(eye.towards), 0};
  const SurfaceCurvature here = curvature(jet);
  const Vector mirrored = 2 * here.normal.dot(eye.towards) * here.normal - eye.towards;
  corner.phase = lines * (1 + mirrored.dot(eye.right)) / 2;
  return corner;
}

void add_cells(const ReflectionPanel::Part& part, const Eye& eye, int lines, std::vector<Cell>& cells) {
  const int n = part.samples;
  std::vector<Corner> grid;
  for (int j = 0; j <= n; ++j)
    for (int k = 0; k <= n; ++k)
      grid.push_back(corner_of(part.patch.at(static_cast<double>(j) / n, static_cast<double>(k) / n), eye, lines));
  const auto at = [&](int j, int k) { return grid[static_cast<std::size_t>((n + 1) * j + k)]; };
  for (int j = 0; j < n; ++j) {
    for (int k = 0; k < n; ++k) {
      Cell cell{{at(j, k), at(j + 1, k), at(j + 1, k + 1), at(j, k + 1)}, 0};
      for (const Corner& corner : cell.corners) cell.depth += corner.depth / 4;
      cells.push_back(cell);
    }
  }
}

/// The part of a polygon where sign (phase - level) >= 0.
Polygon cut(const Polygon& polygon, double level, double sign) {
  Polygon result;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Corner &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const double da = sign * (a.phase - level), db = sign * (b.phase - level);
    if (da >= 0) result.push_back(a);
    if ((da >= 0) == (db >= 0)) continue;
    const double t = da / (da - db);
    result.push_back({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), 0, level});
  }
  return result;
}

constexpr int most_bands = 40;  // in one triangle; more is noise

class Painter {
 public:
  explicit Painter(double shift) : shift_(shift) {}

  void paint(const Cell& cell) {
    add({cell.corners.begin(), cell.corners.end()}, "#eef3f8", "none");
    for (const auto& [b, c] : {std::pair{1U, 2U}, std::pair{2U, 3U}}) {
      const Polygon triangle{cell.corners[0], cell.corners[b], cell.corners[c]};
      const auto [low, high] = std::minmax({triangle[0].phase, triangle[1].phase, triangle[2].phase});
      if (high - low > most_bands) continue;
      for (double k = std::floor(low); k <= high; ++k) add(cut(cut(triangle, k, 1), k + 0.5, -1), "#24466e", "#24466e");
    }
  }
  std::vector<SvgLayer> layers;

 private:
  void add(const Polygon& polygon, const char* fill, const char* stroke) {
    if (polygon.size() < 3) return;
    SvgLayer layer;
    layer.points.resize(static_cast<Eigen::Index>(polygon.size()), 2);
    for (std::size_t i = 0; i < polygon.size(); ++i)
      layer.points.row(static_cast<Eigen::Index>(i)) << polygon[i].x + shift_, polygon[i].y;
    layer.closed = true;
    layer.fill = fill;
    layer.stroke = stroke;
    layer.width = 0.5;  // covers the hair lines between neighbours
    layers.push_back(std::move(layer));
  }
  double shift_;
};

struct Box {
  double left = 0, right = 0, bottom = 0, top = 0;
};
Box box_of(const std::vector<Cell>& cells) {
  Box box{cells[0].corners[0].x, cells[0].corners[0].x, cells[0].corners[0].y, cells[0].corners[0].y};
  for (const Cell& cell : cells)
    for (const Corner& c : cell.corners)
      box = {std::min(box.left, c.x), std::max(box.right, c.x), std::min(box.bottom, c.y), std::max(box.top, c.y)};
  return box;
}

}  // namespace

std::string picture_of_reflection_lines(const std::vector<ReflectionPanel>& panels, const ReflectionOptions& options) {
  const Eye eye = eye_of(options.eye);
  std::vector<SvgLayer> layers;
  double right = 0;  // of what is drawn
  for (const ReflectionPanel& panel : panels) {
    std::vector<Cell> cells;
    for (const ReflectionPanel::Part& part : panel.parts) add_cells(part, eye, options.lines, cells);
    if (cells.empty()) continue;
    std::stable_sort(cells.begin(), cells.end(), [](const Cell& a, const Cell& b) { return a.depth < b.depth; });
    const Box box = box_of(cells);
    const double width = box.right - box.left;
    Painter painter(right - box.left);
    for (const Cell& cell : cells) painter.paint(cell);
    std::move(painter.layers.begin(), painter.layers.end(), std::back_inserter(layers));
    SvgLayer title;
    title.points.resize(1, 2);
    title.points << right + width / 2, box.top + 0.06 * (box.top - box.bottom);
    title.stroke = "#202020";
    title.text = panel.title;
    title.text_size = 15;
    title.anchor = "middle";
    if (!panel.title.empty()) layers.push_back(std::move(title));
    right += 1.08 * width;
  }
  SvgOptions svg_options;
  svg_options.size = options.size;
  svg_options.background = "#ffffff";
  return svg(layers, svg_options);
}

}  // namespace udcp
