// Pictures as SVG text: curves with markers and a legend, and shaded meshes. A small scene made of layers of lines, filled
// polygons and words; the y axis points up.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "operators/polyline.h"
#include "operators/surface.h"

namespace udcp {

/// One line of points. One column: plotted over the index; two: the plane; three: projected along SvgOptions::view, unless every
/// layer is flat in z.
struct SvgLayer {
  Points<double> points;
  bool closed = false;
  std::string stroke = "#1f4e79";  // any SVG colour
  double width = 1.5;              // of the line in pixels; 0: no line
  bool markers = false;            // a dot at each point
  double marker_size = 0;          // its radius; 0: a little more than the width of the line
  std::string label;               // in the legend; empty: none
  std::string fill = "none";
  std::string dash;              // an SVG dash pattern such as "4 3"
  bool segments = false;         // points 2k and 2k + 1 make a line of their own, all of them one path
  double opacity = 1;            // of line and fill
  std::string text;              // written at the first point in the colour of the stroke; no line then
  double text_size = 12;         // in pixels
  std::string anchor = "start";  // which end of the text is at the point: "start", "middle", "end"
};

struct SvgOptions {
  double size = 600;   // longer side of the picture in pixels
  double margin = 24;  // around the points
  std::string title;
  std::string background;                    // an SVG colour; empty: transparent
  std::array<double, 3> view{1, -1.6, 0.9};  // from the shape to the eye; z is up
};

/// Throws Error{input}: E_NOT_FINITE, E_DIMENSION (layers of more than three columns), E_VIEW (the view direction is no
/// direction).
std::string svg(const std::vector<SvgLayer>& layers, const SvgOptions& options = {});
std::string svg_curve(const Polyline<double>& curve, const SvgOptions& options = {});

struct SvgMeshOptions : SvgOptions {
  std::string fill = "#8fb3d9";  // "#rrggbb", shaded by the direction of the face
  std::string colour_attribute;  // instead of fill: a scalar attribute through the colour map
  bool zero_matters = false;     // of the attribute: positive values through the map from 0 on, others in red
  bool legend = false;           // a bar with the values of the attribute, beside the mesh
  bool edges = true;
  std::string edge_colour = "#25405c";
  double edge_width = 0.6;
};
/// Orthographic projection, faces drawn from the far end to the near one, Lambert shading. Errors as for svg, E_ATTRIBUTE.
std::string svg_mesh(const Surface<double>& surface, const SvgMeshOptions& options = {});

}  // namespace udcp
