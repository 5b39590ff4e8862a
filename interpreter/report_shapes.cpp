// Matrices, curves and meshes as text and JSON. Text sums up; JSON keeps the points while they are few enough to read back.
#include <algorithm>
#include <limits>
#include <numeric>

#include "interpreter/report_parts.h"

namespace udcp {
namespace {

using Index = Eigen::Index;

std::string cell_text(double value) { return double_text(value); }
std::string cell_text(const Interval& value) { return value.to_string(6); }
std::string cell_text(const Algebraic& value) {
  constexpr std::size_t widest = 28;  // a longer exact form makes the columns unreadable; its digits are shown instead
  std::string text = exact_text(Quantity<Algebraic>::of(value));
  return value.is_rational() || text.size() <= widest ? text : decimals(Quantity<Algebraic>::of(value), 12);
}

const char* number_name(const Points<double>&) { return ", double"; }
const char* number_name(const Points<Interval>&) { return ", enclosures"; }
const char* number_name(const Points<Algebraic>&) { return ""; }

std::size_t characters(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

std::string plural(Index count, const char* one, const char* many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

template <class S>
std::string rows_text(const Points<S>& entries, Index rows, Index columns) {
  std::vector<std::string> cells;
  std::vector<std::size_t> width(static_cast<std::size_t>(columns), 0);
  for (Index i = 0; i < rows; ++i) {
    for (Index j = 0; j < columns; ++j) {
      cells.push_back(cell_text(entries(i, j)));
      auto& widest = width[static_cast<std::size_t>(j)];
      widest = std::max(widest, characters(cells.back()));
    }
  }
  std::string text;
  for (std::size_t k = 0; k < cells.size(); ++k) {
    const std::size_t column = k % width.size();
    text += column == 0 ? "\n[ " : "  ";
    text += std::string(width[column] - characters(cells[k]), ' ') + cells[k];
    if (column + 1 == width.size()) text += columns < entries.cols() ? "  … ]" : " ]";
  }
  return text;
}

template <class S>
Json rows_json(const Points<S>& entries) {
  Json rows = Json::array();
  for (Index i = 0; i < entries.rows(); ++i) {
    Json row = Json::array();
    for (Index j = 0; j < entries.cols(); ++j) row.push_back(number_json(entries(i, j)));
    rows.push_back(std::move(row));
  }
  return rows;
}

/// Least and greatest coordinate per column; the exact points are only approximated here, which is enough to place a shape.
template <class S>
std::vector<std::pair<double, double>> bounding_box(const Points<S>& points) {
  std::vector<std::pair<double, double>> box;
  for (Index j = 0; j < points.cols(); ++j) {
    double least = std::numeric_limits<double>::infinity(), greatest = -least;
    for (Index i = 0; i < points.rows(); ++i) {
      const double x = approximate(points(i, j));
      least = std::min(least, x);
      greatest = std::max(greatest, x);
    }
    box.emplace_back(least, greatest);
  }
  return box;
}

template <class S>
std::string box_text(const Points<S>& points) {
  if (points.rows() == 0) return {};
  constexpr int digits = 6;  // enough to place a shape
  std::string text;
  for (const auto& [least, greatest] : bounding_box(points)) {
    text += (text.empty() ? ", box ≈ [" : " x [") + double_text(least, digits) + ", " + double_text(greatest, digits) + "]";
  }
  return text;
}

template <class S>
Json box_json(const Points<S>& points) {
  Json least = Json::array(), greatest = Json::array();
  if (points.rows() > 0) {
    for (const auto& [lower, upper] : bounding_box(points)) {
      least.push_back(number_json(lower));
      greatest.push_back(number_json(upper));
    }
  }
  return Json{{"min", std::move(least)}, {"max", std::move(greatest)}};
}

const char* kind_of(const Points<double>&) { return "double"; }
const char* kind_of(const Points<Algebraic>&) { return "exact"; }

template <class S>
std::string attributes_text(const std::map<std::string, std::vector<S>>& attributes) {
  std::string text;
  for (const auto& attribute : attributes) text += (text.empty() ? ", with v." : ", v.") + attribute.first;
  return text;
}

template <class S>
Json attributes_json(const std::map<std::string, std::vector<S>>& attributes) {
  Json json = Json::object();
  for (const auto& [name, column] : attributes) {
    Json values = Json::array();
    for (const S& value : column) values.push_back(number_json(value));
    json[name] = std::move(values);
  }
  return json;
}

Index count_corners(const std::vector<char>& corner) {
  return std::accumulate(corner.begin(), corner.end(), Index{0}, [](Index sum, char c) { return sum + (c != 0 ? 1 : 0); });
}

Json corner_list(const std::vector<char>& corner) {
  Json list = Json::array();
  for (std::size_t i = 0; i < corner.size(); ++i) {
    if (corner[i] != 0) list.push_back(i);
  }
  return list;
}

int boundary_edges(const Mesh& mesh) { return static_cast<int>(std::count(mesh.twin.begin(), mesh.twin.end(), -1)); }

std::string faces_text(const Mesh& mesh) {
  std::string text = plural(mesh.faces(), "face", "faces");
  if (mesh.faces() > 0 && mesh.all_faces_have(4)) text += " (quads)";
  if (mesh.faces() > 0 && mesh.all_faces_have(3)) text += " (triangles)";
  return text;
}

Json faces_json(const Mesh& mesh) {
  Json faces = Json::array();
  for (int f = 0; f < mesh.faces(); ++f) {
    const auto corners = mesh.corners(f);
    faces.push_back(Json(std::vector<int>(corners.begin(), corners.end())));
  }
  return faces;
}

/// Tagged edges as [from, to, "lat" or "lon"].
Json edge_tags_json(const Mesh& mesh, const Tags& tags) {
  Json list = Json::array();
  for (int e = 0; e < mesh.edges() && !tags.edge.empty(); ++e) {
    if (tags.of_edge(e) == EdgeTag::none) continue;
    const int h = mesh.edge_half[static_cast<std::size_t>(e)];
    list.push_back(Json::array(
        {mesh.vertex[static_cast<std::size_t>(h)], mesh.tip(h), tags.of_edge(e) == EdgeTag::latitude ? "lat" : "lon"}));
  }
  return list;
}

}  // namespace

std::string matrix_text(const MatrixValue& matrix) {
  return std::visit(
      [](const auto& entries) {
        constexpr Index most_rows = 60, most_columns = 30;
        const Index rows = std::min(entries.rows(), most_rows), columns = std::min(entries.cols(), most_columns);
        std::string text =
            std::to_string(entries.rows()) + " x " + std::to_string(entries.cols()) + " matrix" + number_name(entries);
        text += rows_text(entries, rows, columns);
        if (rows < entries.rows() || columns < entries.cols())
          text += "\n… shown in part; |> save \"matrix.mtx\" writes all of it";
        return text;
      },
      matrix.entries);
}

Json matrix_json(const MatrixValue& matrix) {
  return std::visit(
      [](const auto& entries) {
        return Json{{"rows", entries.rows()}, {"cols", entries.cols()}, {"entries", rows_json(entries)}};
      },
      matrix.entries);
}

std::string curve_text(const CurveValue& curve) {
  return std::visit(
      [](const auto& shape) {
        std::string text = std::string(shape.closed ? "closed" : "open") +
                           " curve: " + plural(shape.points.rows(), "point", "points") + " in " +
                           plural(shape.points.cols(), "dimension", "dimensions") + ", " + kind_of(shape.points);
        if (const Index corners = count_corners(shape.corner)) text += ", " + plural(corners, "corner", "corners");
        return text + attributes_text(shape.attributes) + box_text(shape.points);
      },
      curve.shape);
}

std::string mesh_text(const MeshValue& mesh) {
  return std::visit(
      [](const auto& shape) {
        const Mesh& m = *shape.mesh;
        std::string text = "mesh: " + plural(m.vertices(), "vertex", "vertices") + ", " + plural(m.edges(), "edge", "edges") +
                           ", " + faces_text(m) + ", ";
        const int boundary = boundary_edges(m);
        text += boundary == 0 ? "closed" : plural(boundary, "boundary edge", "boundary edges");
        text += " in " + plural(shape.points.cols(), "dimension", "dimensions") + std::string(", ") + kind_of(shape.points);
        if (const Index corners = count_corners(shape.tags.corner)) text += ", " + plural(corners, "corner", "corners");
        return text + attributes_text(shape.attributes) + box_text(shape.points);
      },
      mesh.shape);
}

Json curve_json(const CurveValue& curve) {
  return std::visit(
      [](const auto& shape) {
        return Json{{"closed", shape.closed},
                    {"dimension", shape.points.cols()},
                    {"numbers", kind_of(shape.points)},
                    {"box", box_json(shape.points)},
                    {"points", rows_json(shape.points)},
                    {"corners", corner_list(shape.corner)},
                    {"attributes", attributes_json(shape.attributes)}};
      },
      curve.shape);
}

Json mesh_json(const MeshValue& mesh, int most_vertices) {
  return std::visit(
      [&](const auto& shape) {
        const Mesh& m = *shape.mesh;
        Json json{{"vertices", m.vertices()},
                  {"edges", m.edges()},
                  {"faces", m.faces()},
                  {"boundary_edges", boundary_edges(m)},
                  {"dimension", shape.points.cols()},
                  {"numbers", kind_of(shape.points)},
                  {"box", box_json(shape.points)}};
        if (!mesh.word.empty()) json["word"] = mesh.word;
        if (m.vertices() >= most_vertices) return json;
        json["points"] = rows_json(shape.points);
        json["polygons"] = faces_json(m);
        json["corners"] = corner_list(shape.tags.corner);
        json["tagged_edges"] = edge_tags_json(m, shape.tags);
        json["attributes"] = attributes_json(shape.attributes);
        return json;
      },
      mesh.shape);
}

}  // namespace udcp
