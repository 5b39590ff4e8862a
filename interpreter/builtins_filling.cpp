// Filling of surfaces with curvature continuity, adjustable Catmull-Clark, and how such surfaces look: functions of the language.
#include "interpreter/builtins.h"

#include "interpreter/apply.h"
#include "interpreter/claims.h"
#include "interpreter/filling.h"
#include "interpreter/formula.h"
#include "interpreter/shape_parts.h"
#include "operators/schemes.h"
#include "proofs/g2_fill.h"

namespace udcp {
namespace {

std::size_t by_name(const Arguments& a) { return a.positional.size(); }

/// c: a number, a list with a number per vertex, a function of the coordinates, or the name of an attribute.
std::vector<double> parameters_of(const Surface<double>& surface, const Value& c, CallContext& context) {
  if (const auto* number = c.as<NumberValue>()) return {number_as<double>(*number)};
  const auto* text = c.as<TextValue>();
  if (text == nullptr) return attribute_column(surface.points, c, context);
  const auto found = surface.attributes.find(text->value);
  if (found == surface.attributes.end())
    throw Error(ErrorKind::input, "E_ATTRIBUTE", "the mesh has no attribute '" + text->value + "'",
                "attribute(mesh, \"" + text->value + "\", values) adds it");
  return found->second;
}

int steps_of(const Arguments& a) {
  const Value* value = a.get(by_name(a), "steps");
  if (value == nullptr) return -1;
  if (const auto* text = value->as<TextValue>(); text && text->value == "auto") return -1;
  return whole_number(*value, "the argument 'steps'", 0, 20);
}

TangentFactor tangents_of(const Arguments& a) {
  if (!a.find("tangents")) return TangentFactor::paper;
  const std::string name = need_text(a, by_name(a), "tangents");
  if (name == "paper") return TangentFactor::paper;
  if (name == "limit") return TangentFactor::limit;
  throw Error(ErrorKind::word, "E_TYPE", "the argument 'tangents' must be \"paper\" or \"limit\", but it is '" + name + "'");
}

Value make_fill(CallContext& context, const Arguments& a) {
  const Surface<double> mesh = as_double(need_mesh(a, 0));
  FillOptions options;
  if (const Value* c = a.get(by_name(a), "c")) options.c = parameters_of(mesh, *c, context);
  options.steps = steps_of(a);
  options.tangents = tangents_of(a);
  options.leave_out = flag_or(a, by_name(a), "leave_out", false);
  options.control = run_control(context, "fill");
  return surface_value(fill_g2(mesh, options));
}

Value make_tessellation(CallContext& context, const Arguments& a) {
  const std::string colour = a.find("colour") ? need_text(a, by_name(a), "colour") : "gaussian";
  if (colour != "gaussian" && colour != "mean" && colour != "none")
    throw Error(ErrorKind::word, "E_TYPE", "the argument 'colour' must be gaussian, mean or none, but it is '" + colour + "'");
  return tessellated(need_surface(a, 0), whole_or(a, 1, "n", 8, 1, 1000), colour == "none" ? "" : colour, context);
}

Value show_joins(CallContext&, const Arguments& a) {
  const PatchSurface& surface = need_surface(a, 0);
  const JoinDefects defects = join_defects(surface, whole_or(a, by_name(a), "samples", 11, 2, 1000));
  ReportValue report;
  report.text = std::to_string(defects.edges) + " edges between patches: largest gap " + significant(defects.gap, 3) +
                ", of unit normals " + significant(defects.normal, 3) + ", of curvature tensors (relative) " +
                significant(defects.curvature, 3);
  if (defects.irregular > 0) report.text += "; " + std::to_string(defects.irregular) + " samples without a tangent plane";
  report.json = {{"kind", "joins"},          {"edges", defects.edges},         {"gap", defects.gap},
                 {"normal", defects.normal}, {"curvature", defects.curvature}, {"irregular", defects.irregular}};
  report.parts = {number_of(defects.gap), number_of(defects.normal), number_of(defects.curvature)};
  return Value{std::move(report)};
}

int vertex_of(const Arguments& a, const Mesh& mesh) {
  const int v = need_whole(a, by_name(a), "vertex", std::numeric_limits<int>::min(), std::numeric_limits<int>::max());
  if (v < 0 || v >= mesh.vertices())
    throw Error(
        ErrorKind::input, "E_INDEX",
        "there is no vertex " + std::to_string(v) + "; the mesh has the vertices 0 .. " + std::to_string(mesh.vertices() - 1));
  return v;
}

/// Of a surface, whole or around a vertex; of a mesh, Catmull-Clark level by level near a vertex.
Value show_curvature(CallContext&, const Arguments& a) {
  if (const auto* mesh = need(a, 0, "surface").as<MeshValue>()) {
    const Surface<double> surface = as_double(*mesh);
    const int v = vertex_of(a, *surface.mesh);
    std::vector<NamedRange> rows;
    for (const CurvatureExtrema& range : catmull_clark_curvature(surface, v, whole_or(a, by_name(a), "levels", 6, 0, 12)))
      rows.push_back({"level " + std::to_string(rows.size()), range});
    return Value{range_report("Catmull-Clark near vertex " + std::to_string(v), rows)};
  }
  const PatchSurface& surface = need_surface(a, 0);
  const int samples = whole_or(a, by_name(a), "samples", 9, 2, 1000);
  CurvatureExtrema range;
  if (!a.find("vertex")) {
    for (const BezierPatch& patch : surface.patches)
      if (patch.points.size() != 0) range.include(patch, samples);
    return Value{range_report("curvature", {{"surface", range}})};
  }
  const int v = vertex_of(a, *surface.cage.mesh);
  for (const int f : face_rings(*surface.cage.mesh, v).inner)
    if (surface.has_patch(f)) range.include(surface.patches[Mesh::i(f)], samples);
  return Value{range_report("curvature around vertex " + std::to_string(v), {{"patches", range}})};
}

Value show_comparison(CallContext& context, const Arguments& a) {
  const Surface<double> mesh = as_double(need_mesh(a, 0));
  const int v = vertex_of(a, *mesh.mesh);
  return Value{compare_fill(mesh, v, whole_or(a, by_name(a), "levels", 6, 0, 12), run_control(context, "fill"))};
}

Value show_reflection(CallContext&, const Arguments& a) {
  const auto* report = need(a, 0, "surface").as<ReportValue>();
  const auto surface = std::make_shared<const PatchSurface>(need_surface(a, 0));
  const int lines = whole_or(a, by_name(a), "lines", 24, 2, 500), size = whole_or(a, by_name(a), "size", 600, 10, 20'000);
  ReportValue result;
  result.text = "reflection lines of a " + report->text;
  result.json = {{"kind", "reflection_lines"}, {"lines", lines}};
  result.picture = [surface, lines, size] { return picture_of_surface(*surface, lines, size); };
  return Value{std::move(result)};
}

Value make_hybrid(CallContext& context, const Arguments& a) {
  MeshValue result = need_mesh(a, 0);
  Surface<double> surface = as_double(result);
  const std::vector<double> c = parameters_of(surface, need(a, 1, "c"), context);
  surface.attributes["c"] = c.size() == 1 ? std::vector<double>(Mesh::i(surface.mesh->vertices()), c[0]) : c;
  surface = with_corners(std::move(surface));
  const int steps = whole_or(a, by_name(a), "steps", 1, 0, 20);
  for (int k = 0; k < steps; ++k) surface = hybrid_step(surface, "c", run_control(context, "hybrid step"));
  return Value{MeshValue{std::move(surface), "", nullptr}};
}

Result g2_result(const Arguments& a, int valence, const CallContext& context) {
  const SearchLimits limits = search_limits(context);
  if (a.find("printed")) {
    const std::string name = need_text(a, by_name(a), "printed");
    const std::optional<Print> print = print_named(name);
    if (print) return prove_g2_as_printed(valence, *print, limits);
    std::string list;
    for (const std::string& known : print_names()) list += (list.empty() ? "" : ", ") + known;
    throw Error(ErrorKind::word, "E_TYPE", "there is no printed formula '" + name + "'", "one of " + list);
  }
  return prove_g2(a.find("word") ? need_word(a, by_name(a), "word").word : schemes::catmull_clark(), valence, limits);
}

}  // namespace

Value claim_g2(CallContext& context, const Arguments& a) {
  std::vector<int> valences;
  if (!a.positional.empty()) valences = {need_whole(a, 0, "valence", 3, 1000)};
  if (valences.empty() && context.domain) valences = context.domain->valences;
  if (valences.empty())
    throw Error(ErrorKind::word, "E_ARGUMENTS", "the claim g2 needs a valence", "prove g2(5), or prove g2(n) for n in 3 .. 8");
  std::vector<Result> results;
  for (const int n : valences) results.push_back(g2_result(a, n, context));
  return claim_value(all_of(std::move(results)));
}

std::vector<Builtin> builtins_filling() {
  return {
      {"fill_g2",
       "fill_g2(mesh, c = 1/2, steps = auto, tangents = \"paper\", leave_out = no)",
       "The mesh as patches that join with continuous curvature, also at extraordinary vertices.",
       1,
       1,
       {"c", "steps", "tangents", "leave_out"},
       make_fill},
      {"tessellate",
       "tessellate(surface, n = 8, colour = gaussian | mean | none)",
       "n x n quads per patch, with normals and curvature.",
       1,
       2,
       {"n", "colour"},
       make_tessellation},
      {"joins",
       "joins(surface, samples = 11)",
       "Gaps and defects of G1 and G2 along the edges of patches.",
       1,
       1,
       {"samples"},
       show_joins},
      {"curvature",
       "curvature(surface | mesh, vertex = v, samples = 9, levels = 6)",
       "Ranges of curvature: of patches, or of Catmull-Clark near a vertex of a mesh, by level.",
       1,
       1,
       {"vertex", "samples", "levels"},
       show_curvature},
      {"compare_fill",
       "compare_fill(mesh, vertex = v, levels = 6)",
       "Curvature of plain Catmull-Clark and of the fill at a vertex; plot draws reflection lines.",
       1,
       1,
       {"vertex", "levels"},
       show_comparison},
      {"reflection_lines",
       "reflection_lines(surface, lines = 24, size = 600)",
       "Parallel lights mirrored in the surface; plot draws them.",
       1,
       1,
       {"lines", "size"},
       show_reflection},
      {"hybrid",
       "hybrid(mesh, c, steps = 1)",
       "Adjustable Catmull-Clark with a parameter per vertex: a list, a function, or the name of an attribute.",
       2,
       2,
       {"steps"},
       make_hybrid},
      {"g2",
       "g2(valence, word = catmull_clark, printed = \"psi_y_uu\")",
       "Claim: the fill of a valence joins with G2; or does with a formula as printed.",
       0,
       1,
       {"word", "printed"},
       claim_g2},
  };
}

}  // namespace udcp
