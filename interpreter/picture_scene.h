// Pictures laid out in pixels, y downwards: lines, areas, dots and words for files/svg.h. Knows nothing of what they show.
#pragma once

#include <string>
#include <vector>

#include "files/svg.h"

namespace udcp {

struct Pixel {
  double x = 0, y = 0;
};
struct Box {
  double x, y, width, height;
  [[nodiscard]] Pixel centre() const { return {x + width / 2, y + height / 2}; }
};

/// On white. What a function returns may be changed until the next one is called.
class Scene {
 public:
  Scene(double width, double height);
  SvgLayer& line(const std::vector<Pixel>& places, const std::string& stroke, double width);
  /// Places 2k and 2k + 1 are the ends of a line.
  SvgLayer& segments(const std::vector<Pixel>& places, const std::string& stroke, double width);
  SvgLayer& polygon(const std::vector<Pixel>& places, const std::string& fill, double opacity = 1);
  SvgLayer& dots(const std::vector<Pixel>& places, const std::string& colour, double radius);
  void text(Pixel place, const std::string& words, const std::string& colour, const std::string& anchor = "start",
            double size = 12);
  void circle(Pixel centre, double radius, const std::string& stroke);
  [[nodiscard]] std::string draw(const std::string& title) const;

 private:
  double longer_;
  std::vector<SvgLayer> layers_;
};

}  // namespace udcp
