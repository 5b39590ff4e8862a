// Between values and files: the extension decides. Paths are relative to the folder of the running program.
#include <algorithm>

#include "files/geometry_file.h"
#include "files/matrix_market.h"
#include "files/svg.h"
#include "interpreter/apply.h"
#include "interpreter/arguments.h"
#include "interpreter/colour_bar.h"
#include "interpreter/filling.h"
#include "interpreter/formula.h"
#include "interpreter/offset_values.h"
#include "interpreter/report.h"

namespace udcp {

namespace {

std::filesystem::path path_argument(const CallContext& context, const Arguments& a, std::size_t position) {
  const std::string text = need_text(a, position, "file");
  if (text.empty()) throw Error(ErrorKind::file, "E_FILE_OPEN", "the name of the file is empty");
  return context.folder / std::filesystem::path(text);
}

std::string extension_of(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

void report_warnings(const CallContext& context, const Warnings& warnings) {
  if (!context.output.warning) return;
  for (const std::string& warning : warnings) context.output.warning(warning);
}

Value load_mesh(CallContext& context, const Arguments& a) {
  const std::filesystem::path path = path_argument(context, a, 0);
  Warnings warnings;
  MeshValue mesh{with_number_type(flag_or(a, a.positional.size(), "exact", false),
                                  [&]<class S>(std::type_identity<S>) { return load<S>(path, &warnings); }),
                 "", nullptr};
  mesh.file = path.string();
  if (const auto lost = std::ranges::find_if(warnings, says_unused); lost != warnings.end()) mesh.isolated = *lost;
  report_warnings(context, warnings);
  return Value{std::move(mesh)};
}

Value load_line(CallContext& context, const Arguments& a) {
  const std::filesystem::path path = path_argument(context, a, 0);
  Warnings warnings;
  CurveValue curve{with_number_type(flag_or(a, a.positional.size(), "exact", false),
                                    [&]<class S>(std::type_identity<S>) { return load_curve<S>(path, &warnings); })};
  report_warnings(context, warnings);
  return Value{std::move(curve)};
}

bool is_flat(const MeshValue& mesh) {
  const Points<double> points = as_double(mesh).points;
  return points.cols() < 3 || points.col(2).isZero(0);
}

/// Arguments, and where they leave it open what the mesh itself brings.
SvgMeshOptions picture_options(const Arguments& a, const MeshValue* mesh = nullptr) {
  SvgMeshOptions options;
  const std::size_t by_name = a.positional.size();
  options.size = whole_or(a, by_name, "size", 600, 10, 20'000);
  if (a.find("title")) options.title = need_text(a, by_name, "title");
  if (a.find("colour")) options.colour_attribute = need_text(a, by_name, "colour");
  if (mesh && options.colour_attribute.empty()) options.colour_attribute = mesh->colour;
  options.legend = mesh && !mesh->colour.empty() && options.colour_attribute == mesh->colour;
  options.zero_matters = options.legend && mesh->zero_matters;
  if (options.legend) options.background = "#ffffff";
  if (options.legend && is_flat(*mesh)) options.view = {0, 0, 1};
  options.edges = flag_or(a, by_name, "edges", !options.legend);  // they would hide the colours of a fine mesh
  return options;
}

/// The curve over the polygon it came from.
void add_layers(const CurveValue& curve, std::vector<SvgLayer>& layers) {
  if (curve.control) {
    SvgLayer control;
    control.points = curve.control->points;
    control.closed = curve.control->closed;
    control.stroke = "#b0b0b0";
    control.width = 1;
    control.markers = true;
    control.dash = "4 3";
    layers.push_back(std::move(control));
  }
  const Polyline<double> line = as_double(curve);
  SvgLayer layer;
  layer.points = line.points;
  layer.closed = line.closed;
  static const char* const colours[] = {"#1f4e79", "#b5482a", "#3c7a3b", "#7a4d8f", "#8a6d1d"};
  layer.stroke = colours[layers.size() % 5];
  layers.push_back(std::move(layer));
}

void save_picture(const Value& value, const std::filesystem::path& path, const Arguments& a) {
  if (const auto* mesh = value.as<MeshValue>()) return write_file(path, svg_mesh(as_double(*mesh), picture_options(a, mesh)));
  if (const auto* report = value.as<ReportValue>(); report && report->picture) return write_file(path, report->picture());
  std::vector<SvgLayer> layers;
  if (const auto* curve = value.as<CurveValue>()) {
    add_layers(*curve, layers);
  } else {
    for (const Value& item : list_items(value, "what is plotted")) {
      const auto* part = item.as<CurveValue>();
      if (!part) throw wrong_type("an item of the list", "a curve", item);
      add_layers(*part, layers);
    }
  }
  write_file(path, svg(layers, picture_options(a)));
}

Value plot_value(CallContext& context, const Arguments& a) {
  const std::filesystem::path path = path_argument(context, a, 1);
  if (extension_of(path) != ".svg")
    throw Error(ErrorKind::file, "E_FORMAT", "plot writes .svg files, but the name is '" + path.filename().string() + "'",
                "save writes the other formats");
  save_picture(a.positional[0], path, a);
  return Value{};
}

void save_mesh(CallContext& context, const MeshValue& mesh, const std::filesystem::path& path, const Arguments& a) {
  if (context.animation) {
    (*context.animation)[path].push_back(as_double(mesh));
    return;
  }
  const bool in_scene = extension_of(path) == ".glb" || extension_of(path) == ".gltf";
  if (mesh.control && in_scene) return save_mesh(context, limit_surface(mesh, context), path, a);
  SaveOptions options;
  options.word = mesh.word;
  options.stop = context.stop.get();
  const Surface<double> surface = as_double(mesh);
  auto normals = mesh.normals;
  if (!normals && mesh.scheme && in_scene)
    normals = limit_normals(*mesh.scheme, *mesh.scheme->rounds, surface, run_control(context, "limit normals"));
  options.normals = normals.get();
  if (a.find("colour")) options.colour_attribute = need_text(a, a.positional.size(), "colour");
  if (options.colour_attribute.empty()) options.colour_attribute = mesh.colour;
  options.zero_matters = mesh.zero_matters && options.colour_attribute == mesh.colour;
  if (a.find("format")) options.format = need_text(a, a.positional.size(), "format");
  if (in_scene && options.format.empty() && !mesh.colour.empty() && options.colour_attribute == mesh.colour)
    return save_with_legend(surface, path, options);
  save(surface, path, options);
}

void save_matrix(const MatrixValue& matrix, const std::filesystem::path& path) {
  if (extension_of(path) != ".mtx")
    throw Error(ErrorKind::input, "E_FORMAT", "a matrix is saved as .mtx or .json, not as '" + path.filename().string() + "'");
  write_file(path, std::visit([](const auto& m) { return matrix_market(m); }, matrix.entries));
}

Value save_value(CallContext& context, const Arguments& a) {
  const Value& value = a.positional[0];
  const std::filesystem::path path = path_argument(context, a, 1);
  const std::string extension = extension_of(path);
  const auto* filled = value.as<ReportValue>();
  if (filled && filled->surface && extension != ".svg" && extension != ".txt") {
    save_surface(*filled->surface, path, extension, context);
  } else if (extension == ".svg") {
    save_picture(value, path, a);
  } else if (extension == ".json") {
    write_file(path, to_json(value).dump(2) + "\n");
  } else if (const auto* mesh = value.as<MeshValue>()) {
    save_mesh(context, *mesh, path, a);
  } else if (const auto* curve = value.as<CurveValue>()) {
    save(as_double(*curve), path);
  } else if (const auto* matrix = value.as<MatrixValue>()) {
    save_matrix(*matrix, path);
  } else if (const auto* report = value.as<ReportValue>(); report && report->latex && extension == ".tex") {
    write_file(path, report->latex());
  } else if (extension == ".txt") {
    write_file(path, to_text(value) + "\n");
  } else {
    throw Error(ErrorKind::input, "E_FORMAT",
                with_article(type_name(value)) + " can be saved as .json or .txt, not as '" + path.filename().string() + "'");
  }
  return Value{};
}

}  // namespace

std::vector<Builtin> builtins_files() {
  return {
      {"load", "load(\"file\", exact = no)", "A mesh from OBJ, OFF, PLY, STL, glTF or GLB.", 1, 1, {"exact"}, load_mesh},
      {"load_curve", "load_curve(\"file\", exact = no)", "A curve from an OBJ file with one l line.", 1, 1, {"exact"}, load_line},
      {"save",
       "save(value, \"file\", colour = \"attribute\", format = \"ply-ascii\")",
       "Writes a shape, a matrix or any value; the extension decides.",
       2,
       2,
       {"colour", "format", "size", "title", "edges"},
       save_value},
      {"plot",
       "plot(shape, \"file.svg\", size = 600, title = \"\", colour = \"attribute\", edges = yes)",
       "Draws curves or a shaded mesh.",
       2,
       2,
       {"size", "title", "colour", "edges"},
       plot_value},
  };
}

}  // namespace udcp
