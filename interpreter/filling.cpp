// Patch surfaces as reports, tables of curvature, and the comparison with plain Catmull-Clark.
#include "interpreter/filling.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>

#include "files/geometry_file.h"
#include "interpreter/apply.h"
#include "interpreter/formula.h"
#include "interpreter/reflection_lines.h"
#include "interpreter/report.h"
#include "operators/schemes.h"

namespace udcp {
namespace {

std::size_t at(int k) { return Mesh::i(k); }

std::string plural(std::size_t count, const std::string& noun) {
  return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

std::string padded(std::string text, std::size_t width) {
  if (text.size() < width) text.insert(0, width - text.size(), ' ');
  return text;
}

struct PatchCounts {
  std::size_t all = 0, filled = 0;
  std::map<int, int> by_valence;
};
PatchCounts counts_of(const PatchSurface& surface) {
  PatchCounts counts;
  for (const BezierPatch& patch : surface.patches) {
    counts.all += patch.points.size() != 0;
    counts.filled += patch.degree_u == fill_degree && patch.points.size() != 0;
  }
  for (const int v : surface.filled) ++counts.by_valence[surface.cage.mesh->valence(v)];
  return counts;
}

std::string text_of(const PatchSurface& surface) {
  const PatchCounts counts = counts_of(surface);
  std::string text = "surface of " + plural(counts.all, "patch");
  if (counts.all != 1) text.insert(text.size() - 1, "e");
  text += ": " + std::to_string(counts.all - counts.filled) + " bicubic, " + std::to_string(counts.filled) +
          " of bidegree 7 around " + std::to_string(surface.filled.size()) +
          (surface.filled.size() == 1 ? " vertex" : " vertices");
  std::string list;
  for (const auto& [valence, count] : counts.by_valence)
    list += (list.empty() ? " (" : ", ") + std::to_string(count) + " of valence " + std::to_string(valence);
  text += list.empty() ? "" : list + ")";
  return text + "; " + plural(static_cast<std::size_t>(surface.steps), "step");
}

Json summary_of(const PatchSurface& surface) {
  const PatchCounts counts = counts_of(surface);
  Json valences = Json::object();
  for (const auto& [valence, count] : counts.by_valence) valences[std::to_string(valence)] = count;
  return {{"kind", "surface"},          {"patches", counts.all}, {"bicubic", counts.all - counts.filled},
          {"bidegree7", counts.filled}, {"filled", valences},    {"steps", surface.steps}};
}

}  // namespace

std::string significant(double value, int digits) {
  std::array<char, 40> text{};
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), value == 0 ? 0.0 : value, std::chars_format::general, digits).ptr;
  return {text.data(), end};
}

std::string picture_of_surface(const PatchSurface& surface, int lines, double size) {
  ReflectionPanel panel;
  const double patches = static_cast<double>(std::max<std::size_t>(1, surface.patches.size()));
  const int samples = std::clamp(static_cast<int>(std::sqrt(12'000 / patches)), 2, 16);
  for (const BezierPatch& patch : surface.patches)
    if (patch.points.size() != 0) panel.parts.push_back({patch, samples});
  ReflectionOptions options;
  options.lines = lines;
  options.size = size;
  return picture_of_reflection_lines({panel}, options);
}

Value surface_value(PatchSurface surface) {
  const auto shared = std::make_shared<const PatchSurface>(std::move(surface));
  ReportValue report;
  report.text = text_of(*shared);
  report.json = summary_of(*shared);
  report.surface = shared;
  report.picture = [shared] { return picture_of_surface(*shared, 24, 600); };
  return Value{std::move(report)};
}

const PatchSurface& need_surface(const Arguments& a, std::size_t position) {
  const Value& value = need(a, position, "surface");
  const auto* report = value.as<ReportValue>();
  if (report && report->surface) return *report->surface;
  throw wrong_type("the argument 'surface'", "a surface made by fill_g2", value);
}

Json patches_json(const PatchSurface& surface) {
  const Mesh& mesh = *surface.cage.mesh;
  std::vector<int> around(at(mesh.faces()), -1);
  for (const int v : surface.filled)
    for (const int f : face_rings(mesh, v).inner) around[at(f)] = v;
  Json list = Json::array();
  for (int f = 0; f < mesh.faces(); ++f) {
    if (!surface.has_patch(f)) continue;
    const BezierPatch& patch = surface.patches[at(f)];
    Json points = Json::array();
    for (Eigen::Index i = 0; i < patch.points.rows(); ++i)
      points.push_back(Json::array({patch.points(i, 0), patch.points(i, 1), patch.points(i, 2)}));
    list.push_back({{"degree", Json::array({patch.degree_u, patch.degree_v})},
                    {"points", std::move(points)},
                    {"face", f},
                    {"around", around[at(f)] < 0 ? Json(nullptr) : Json(around[at(f)])}});
  }
  return {{"kind", "patches"}, {"patches", std::move(list)}};
}

Value tessellated(const PatchSurface& surface, int n, const std::string& colour, CallContext& context) {
  Tessellation made = tessellate(surface, n, run_control(context, "tessellation"));
  MeshValue mesh{std::move(made.surface), "", std::make_shared<const Points<double>>(std::move(made.normals))};
  mesh.colour = colour;
  mesh.zero_matters = true;
  return Value{std::move(mesh)};
}

void save_surface(const PatchSurface& surface, const std::filesystem::path& path, const std::string& extension,
                  CallContext& context) {
  if (extension == ".json") return write_file(path, patches_json(surface).dump() + "\n");
  call("save", {tessellated(surface, 8, "gaussian", context), Value{TextValue{path.string()}}}, {}, context);
}

ReportValue range_report(const std::string& title, const std::vector<NamedRange>& ranges) {
  ReportValue report;
  std::size_t width = 0;
  for (const NamedRange& row : ranges) width = std::max(width, row.name.size());
  report.text = title + "\n" + padded("", width) + padded("K least", 14) + padded("greatest", 14) + padded("H least", 14) +
                padded("greatest", 14);
  report.json = {{"kind", "curvature"}, {"title", title}, {"rows", Json::array()}};
  for (const NamedRange& row : ranges) {
    const CurvatureExtrema& r = row.range;
    report.text += "\n" + row.name + std::string(width - row.name.size(), ' ');
    ListValue numbers;
    for (const double value : {r.gaussian_low, r.gaussian_high, r.mean_low, r.mean_high}) {
      report.text += padded(significant(value, 6), 14);
      numbers.items.push_back(number_of(value));
    }
    if (r.irregular > 0)
      report.text += "  (" + plural(static_cast<std::size_t>(r.irregular), "sample") + " without a tangent plane)";
    report.parts.push_back(Value{std::move(numbers)});
    report.json["rows"].push_back({{"name", row.name},
                                   {"K", Json::array({r.gaussian_low, r.gaussian_high})},
                                   {"H", Json::array({r.mean_low, r.mean_high})},
                                   {"irregular", r.irregular}});
  }
  return report;
}

namespace {

/// The mesh after as many steps as two regular rings around the vertex take, at most three.
Surface<double> with_rings(const Surface<double>& mesh, int vertex, const RunControl& control, int& steps) {
  Surface<double> surface = mesh;
  for (steps = 0;; ++steps) {
    try {
      catmull_clark_rings(surface, vertex, 0);
      return surface;
    } catch (const Error& error) {
      if (error.code != "E_FILL_ISOLATED" || steps == 3) throw;
    }
    surface = run(schemes::catmull_clark(), with_corners(std::move(surface)), 1, control);
  }
}

}  // namespace

ReportValue compare_fill(const Surface<double>& mesh, int vertex, int levels, const RunControl& control) {
  int steps = 0;
  const Surface<double> cage = with_rings(mesh, vertex, control, steps);
  FillOptions options;
  options.leave_out = true;
  options.control = control;
  options.steps = fill_steps(*cage.mesh);
  const PatchSurface surface = fill_g2(cage, options);
  std::vector<NamedRange> rows;
  const std::vector<CurvatureExtrema> by_level = catmull_clark_curvature(cage, vertex, levels);
  for (std::size_t m = 0; m < by_level.size(); ++m) rows.push_back({"Catmull-Clark, level " + std::to_string(m), by_level[m]});
  CurvatureExtrema fill;
  ReflectionPanel left{"Catmull-Clark", {}}, right{"fill", {}};
  const std::vector<std::vector<BezierPatch>> rings = catmull_clark_rings(cage, vertex, std::max(levels, 9));
  for (std::size_t m = 0; m < rings.size(); ++m)
    for (const BezierPatch& patch : rings[m]) left.parts.push_back({patch, std::max(2, 10 - 2 * static_cast<int>(m))});
  for (const BezierPatch& patch : rings[0]) right.parts.push_back({patch, 10});
  if (surface.steps > 0)
    throw Error(ErrorKind::internal, "E_INTERNAL", "the rings around a vertex were regular, but its mesh needed another step");
  Eigen::Vector3d eye = Eigen::Vector3d::UnitZ();
  for (const int f : face_rings(*cage.mesh, vertex).inner) {
    const BezierPatch& patch = surface.patches[at(f)];
    fill.include(patch, 9);
    right.parts.push_back({patch, 14});
    eye = curvature(patch.at(0, 0)).normal;
  }
  rows.push_back({"fill", fill});
  const std::string title = "vertex " + std::to_string(vertex) + " of valence " + std::to_string(cage.mesh->valence(vertex)) +
                            " after " + plural(static_cast<std::size_t>(steps), "step");
  ReportValue report = range_report(title, rows);
  report.picture = [left, right, eye] {
    ReflectionOptions picture;
    picture.eye = eye;
    picture.lines = 30;
    return picture_of_reflection_lines({left, right}, picture);
  };
  return report;
}

}  // namespace udcp
