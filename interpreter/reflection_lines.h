// Reflection lines: the image of parallel lights in a polished surface, as SVG text. A kink in a line shows a jump of curvature.
// Floating point throughout: a picture proves nothing.
#pragma once

#include <string>
#include <vector>

#include "operators/methods/filling/bezier_patch.h"

namespace udcp {

/// One view of a surface; several stand side by side.
struct ReflectionPanel {
  std::string title;
  struct Part {
    BezierPatch patch;
    int samples = 8;  // cells along each side
  };
  std::vector<Part> parts;
};
struct ReflectionOptions {
  Eigen::Vector3d eye{1, -1.6, 0.9};  // from the surface to the eye
  int lines = 24;                     // lights from left to right
  double size = 900;                  // longer side in pixels
};
/// Throws Error{input}: E_VIEW for an eye without direction, E_NOT_FINITE.
std::string picture_of_reflection_lines(const std::vector<ReflectionPanel>& panels, const ReflectionOptions& options);

}  // namespace udcp
