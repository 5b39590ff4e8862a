// A reader for the reference files, independent of files/: v, vn and f lines of numbers.
#pragma once

#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "operators/surface.h"

namespace udcp::oracle {

struct ObjLines {
  std::vector<std::vector<double>> points, normals;
  std::vector<std::vector<int>> faces;
};

inline ObjLines read_obj_lines(const std::string& file) {
  ObjLines result;
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    std::string key;
    words >> key;
    if (key == "v" || key == "vn") {
      std::vector<double> row(3);
      for (double& x : row) words >> x;
      (key == "v" ? result.points : result.normals).push_back(row);
    } else if (key == "f") {
      result.faces.emplace_back();
      for (std::string corner; words >> corner;) result.faces.back().push_back(std::stoi(corner) - 1);
    }
  }
  return result;
}

inline Surface<double> as_surface(const ObjLines& lines) {
  Surface<double> result;
  result.mesh = std::make_shared<const Mesh>(make_mesh(static_cast<int>(lines.points.size()), lines.faces));
  result.points.resize(static_cast<Eigen::Index>(lines.points.size()), 3);
  for (std::size_t v = 0; v < lines.points.size(); ++v)
    for (std::size_t c = 0; c < 3; ++c)
      result.points(static_cast<Eigen::Index>(v), static_cast<Eigen::Index>(c)) = lines.points[v][c];
  return result;
}

}  // namespace udcp::oracle
