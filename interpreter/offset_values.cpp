// Options, refinement of S to the mesh of F, and tables.
#include "interpreter/offset_values.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "interpreter/report_parts.h"
#include "operators/methods/offset/loop_limit.h"
#include "operators/schemes.h"

namespace udcp {
namespace {

std::size_t by_name(const Arguments& a) { return a.positional.size(); }

std::string place(const Eigen::RowVector3d& p) {
  return "(" + short_number(p[0]) + ", " + short_number(p[1]) + ", " + short_number(p[2]) + ")";
}

double real(const Arguments& a, std::size_t position, std::string_view name) {
  return number_as<double>(need_number(a, position, name));
}

OffsetSolver solver_of(const Arguments& a) {
  const std::string name =
      choice_or(a, "solver", {"automatic", "direct", "edge", "star", "gauss_seidel", "richardson", "cg", "jacobi"});
  if (name == "direct") return OffsetSolver::direct;
  if (name == "edge") return OffsetSolver::edge;
  if (name == "star") return OffsetSolver::star;
  if (name == "gauss_seidel") return OffsetSolver::gauss_seidel;
  if (name == "richardson") return OffsetSolver::richardson;
  if (name == "cg") return OffsetSolver::conjugate_gradients;
  return name == "jacobi" ? OffsetSolver::jacobi : OffsetSolver::automatic;
}

/// The value behind a name with an underscore: JSON keys of measures.
Json errors_json(const OffsetErrors& errors) {
  return {{"eps", errors.eps}, {"E", errors.full}, {"En", errors.normal}, {"Et", errors.slip}, {"rms_E", errors.rms}};
}

std::string line(const std::string& name, const std::string& text) {
  return "  " + name + std::string(name.size() < 12 ? 12 - name.size() : 1, ' ') + text + "\n";
}

}  // namespace

std::string short_number(double x) { return double_text(x, 4); }

OffsetOptions offset_options(const Arguments& a, CallContext& context) {
  OffsetOptions options;
  options.distance = real(a, 1, "distance");
  if (a.find("tolerance")) options.tolerance = real(a, by_name(a), "tolerance");
  options.max_level = whole_or(a, by_name(a), "max_level", options.max_level, 0, 12);
  options.sample_rounds = whole_or(a, by_name(a), "samples", options.sample_rounds, 0, 6);
  options.pad = whole_or(a, by_name(a), "pad", options.pad, 0, 100);
  options.fit = flag_or(a, by_name(a), "fit", false);
  options.local = flag_or(a, by_name(a), "local", false);
  options.solve.solver = solver_of(a);
  options.control = run_control(context, "offset");
  options.solve.stop = options.control.stop;
  return options;
}

OffsetPair offset_pair(const Arguments& a, CallContext& context) {
  OffsetPair pair{three_columns(as_double(need_mesh(a, 0, "mesh"))), {}, 0};
  const Surface<double> offset = three_columns(as_double(need_mesh(a, 1, "offset")));
  validate_control_mesh(pair.surface);
  while (pair.surface.mesh->faces() < offset.mesh->faces() && pair.level < 12) {
    pair.surface = run(schemes::loop(), std::move(pair.surface), 1, run_control(context, "offset"));
    ++pair.level;
  }
  if (pair.surface.mesh->vertex != offset.mesh->vertex)
    throw Error(ErrorKind::input, "E_OFFSET_MESH", "the second mesh is no offset of the first: their faces differ",
                "the first argument is the mesh that was offset, the second what offset made of it");
  pair.d = offset.points - pair.surface.points;
  return pair;
}

Value control_mesh(Surface<double> surface) {
  MeshValue value{std::move(surface), "offset", nullptr};
  value.control = true;
  return Value{std::move(value)};
}

MeshValue limit_surface(const MeshValue& control, CallContext& context) {
  constexpr int smooth = 20'000;  // faces
  Surface<double> surface = three_columns(as_double(control));
  int rounds = 0;
  while (rounds < 4 && (surface.mesh->faces() << (2 * rounds)) < smooth) ++rounds;
  surface = run(schemes::loop(), std::move(surface), rounds, run_control(context, "surface"));
  const LoopLimit<double> limit(surface.mesh, surface.tags);
  auto normals = std::make_shared<const Points<double>>(limit_normals(limit, surface.points));
  surface.points = limit.points(surface.points);
  MeshValue result{std::move(surface), "limit of loop", std::move(normals)};
  result.colour = control.colour;
  return result;
}

Value coloured_surface(const Surface<double>& limit, Points<double> normals, const std::string& name,
                       std::vector<double> values) {
  MeshValue result{limit, "limit of loop", std::make_shared<const Points<double>>(std::move(normals))};
  std::get<Surface<double>>(result.shape).attributes[name] = std::move(values);
  result.colour = name;
  return Value{std::move(result)};
}

void warn_of_folds(const Surface<double>& surface, double distance, CallContext& context) {
  constexpr std::int64_t most = 20'000;  // faces; sampling curvature on more takes longer than the offset itself
  if (!context.output.warning || distance == 0) return;
  std::int64_t work = 0;  // a face beside a large valence takes as long as that many others
  for (int f = 0; f < surface.mesh->faces(); ++f) {
    int largest = 1;
    for (const int v : surface.mesh->corners(f)) largest = std::max(largest, surface.mesh->valence(v));
    work += largest > 24 ? largest : 1;
  }
  if (work > most) return;
  const CurvatureRange range = curvature_range(surface, run_control(context, "curvature"));
  const bool below = distance <= range.lowest_distance();
  if (!below && distance < range.highest_distance()) return;
  const double radius = below ? -range.lowest_distance() : range.highest_distance();
  context.output.warning("offset: the distance " + short_number(distance) + " is beyond the radius of curvature " +
                         short_number(radius) + " on face " + std::to_string(below ? range.greatest_face : range.least_face) +
                         " near " + place(below ? range.greatest_place : range.least_place) + ", where the exact offset folds");
}

ReportValue offset_table(const OffsetResult& result, const OffsetOptions& options) {
  ReportValue report;
  const int levels = result.log.back().level;
  const std::string rounds =
      levels == 0 ? "" : " of the mesh refined " + std::to_string(levels) + (levels == 1 ? " time" : " times");
  report.text = "offset by " + short_number(options.distance) + ": max |eps| " + short_number(result.errors.eps) + ", |E| " +
                short_number(result.errors.full) + ", largest on face " + std::to_string(result.worst_face) + rounds + " near " +
                place(result.base.points.row(result.base.mesh->corners(result.worst_face)[0])) + "\n";
  report.json = {{"kind", "offset"},
                 {"distance", options.distance},
                 {"solver", name_of(result.solver)},
                 {"iterations", result.iterations},
                 {"residual", result.residual},
                 {"fit", result.fit_weight},
                 {"errors", errors_json(result.errors)},
                 {"worst_face", result.worst_face},
                 {"levels", Json::array()}};
  for (const OffsetLevel& level : result.log) {
    report.text += line("level " + std::to_string(level.level), std::to_string(level.vertices) + " vertices, " +
                                                                    std::to_string(level.unknowns) + " unknowns, max |eps| " +
                                                                    short_number(level.eps));
    report.json["levels"].push_back(
        {{"level", level.level}, {"vertices", level.vertices}, {"unknowns", level.unknowns}, {"eps", level.eps}});
  }
  for (const OffsetBound kind : {OffsetBound::hull, OffsetBound::bernstein}) {
    const BoundedError bound = bound_offset_error(result.base, result.d, options.distance, kind, 0, options.control);
    report.text += line(std::string(name_of(kind)), "max |eps| <= " + short_number(bound.bound));
    report.json["bounds"][std::string(name_of(kind))] = bound.bound;
  }
  report.text += "  solved by " + std::string(name_of(result.solver)) +
                 (result.iterations > 0 ? " in " + std::to_string(result.iterations) + " iterations" : "") + ", residual " +
                 short_number(result.residual) +
                 (result.fit_weight > 0 ? "; fitted with alpha " + short_number(result.fit_weight) : "");
  report.parts = {number_of(result.errors.eps), number_of(result.errors.full), number_of(result.errors.normal),
                  number_of(result.errors.slip)};
  return report;
}

ReportValue error_report(const OffsetPair& pair, const Arguments& a, CallContext& context) {
  const double distance = real(a, 2, "distance");
  const RunControl control = run_control(context, "offset_error");
  const int rounds = whole_or(a, by_name(a), "samples", 3, 0, 6);
  const OffsetSamples samples = sample_offset(pair.surface, pair.d, rounds, control);
  const OffsetErrors errors = offset_errors(samples, distance);
  ReportValue report;
  report.text = "sampled after " + std::to_string(rounds) + " rounds:\n" +
                line("|eps|", short_number(errors.eps) + "  (| |delta| - |distance| |, largest near " +
                                  place(samples.position.row(errors.worst)) + ")") +
                line("|E|", short_number(errors.full) + "  (from the corresponding point of the exact offset)") +
                line("|En|", short_number(errors.normal) + "  (across the surface)") +
                line("|Et|", short_number(errors.slip) + "  (slip along it)");
  report.json = {{"kind", "offset_error"}, {"distance", distance}, {"samples", rounds}, {"sampled", errors_json(errors)}};
  if (flag_or(a, by_name(a), "foot", false)) {
    const double foot = foot_error(samples, distance, control);
    report.text += line("foot", short_number(foot) + "  (of the distance to the surface)");
    report.json["foot"] = foot;
  }
  report.text += "upper bounds of |eps|, rounding errors not bounded:\n";
  for (const OffsetBound kind : {OffsetBound::aabb, OffsetBound::hull, OffsetBound::bernstein}) {
    const BoundedError bound =
        bound_offset_error(pair.surface, pair.d, distance, kind, kind == OffsetBound::bernstein ? 1 : 2, control);
    report.text += line(std::string(name_of(kind)), short_number(bound.bound) + " on face " + std::to_string(bound.face));
    report.json["bounds"][std::string(name_of(kind))] = {{"bound", bound.bound}, {"face", bound.face}};
  }
  if (flag_or(a, by_name(a), "certified", false)) {
    const CertifiedErrors certified = certified_offset_errors(pair.surface, pair.d, distance, 14, control);
    report.text +=
        line("branch", "|eps| <= " + short_number(certified.eps.upper) + ", |E| <= " + short_number(certified.full.upper) + " (" +
                           std::to_string(certified.eps.patches + certified.full.patches) + " patches)");
    report.json["branch_and_bound"] = {{"eps", certified.eps.upper}, {"E", certified.full.upper}};
  }
  report.text.pop_back();
  report.parts = {number_of(errors.eps), number_of(errors.full), number_of(errors.normal), number_of(errors.slip)};
  return report;
}

ReportValue intersection_report(const OffsetPair& pair, int rounds, CallContext& context) {
  const SelfIntersection found =
      find_self_intersections(pair.surface, pair.d, rounds, run_control(context, "self_intersections"));
  const std::vector<std::pair<int, int>> pairs = coarse_hits(found);
  ReportValue report;
  report.text = std::string(name_of(found.verdict)) + ": " + std::to_string(found.hits.size()) + " pairs of faces meet, " +
                std::to_string(found.folds.size()) + " vertices are folded, " + std::to_string(found.inverted.size()) +
                " inverted (approximate, on " + std::to_string(found.surface.mesh->faces()) + " triangles)";
  report.json = {{"kind", "self_intersections"}, {"verdict", name_of(found.verdict)}, {"hits", found.hits.size()},
                 {"folds", found.folds},         {"inverted", found.inverted},        {"pairs", Json::array()}};
  ListValue list;
  for (const auto& [f, g] : pairs) {
    report.json["pairs"].push_back(Json::array({f, g}));
    list.items.push_back(Value{ListValue{{whole_value(f), whole_value(g)}}});
  }
  for (std::size_t k = 0; k < std::min<std::size_t>(pairs.size(), 6); ++k)
    report.text += (k == 0 ? "\n  faces " : ", ") + std::to_string(pairs[k].first) + " and " + std::to_string(pairs[k].second);
  if (pairs.size() > 6) report.text += ", and " + std::to_string(pairs.size() - 6) + " more pairs";
  report.parts = {Value{TextValue{std::string(name_of(found.verdict))}},
                  whole_value(static_cast<std::int64_t>(found.hits.size())),
                  whole_value(static_cast<std::int64_t>(found.folds.size())),
                  whole_value(static_cast<std::int64_t>(found.inverted.size())), Value{std::move(list)}};
  return report;
}

}  // namespace udcp
