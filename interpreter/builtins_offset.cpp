// Offsets of Loop surfaces, their errors and self-intersections, and claims about them: functions of the language.
#include <cmath>

#include "interpreter/claims.h"
#include "interpreter/offset_values.h"
#include "operators/methods/offset/loop_limit.h"
#include "proofs/offset_proofs.h"

namespace udcp {
namespace {

const std::vector<std::string_view> offset_arguments{"distance", "tolerance", "max_level", "solver",
                                                     "fit",      "local",     "pad",       "samples"};

std::vector<std::string_view> with(std::vector<std::string_view> more) {
  more.insert(more.begin(), offset_arguments.begin(), offset_arguments.end());
  return more;
}

Surface<double> mesh_of(const Arguments& a) {
  const MeshValue& mesh = need_mesh(a, 0);
  if (!mesh.isolated.empty())
    throw Error(ErrorKind::input, "E_ISOLATED", mesh.isolated + "; an offset has a vertex for each vertex of the mesh",
                "remove the vertices without faces from the file");
  return three_columns(as_double(mesh));
}

OffsetResult run_offset(CallContext& context, const Arguments& a, const OffsetOptions& options) {
  const Surface<double> surface = mesh_of(a);
  OffsetResult result = offset(surface, options);
  warn_of_folds(surface, options.distance, context);
  return result;
}

Value make_offset(CallContext& context, const Arguments& a) {
  const OffsetOptions options = offset_options(a, context);
  OffsetResult result = run_offset(context, a, options);
  if (!flag_or(a, a.positional.size(), "shell", false)) return control_mesh(result.surface);
  OffsetOptions back = options;
  back.distance = -options.distance;
  warn_of_folds(mesh_of(a), back.distance, context);
  OffsetResult other = offset(result.base, back);
  // Each side may need more levels than the other; both meet the tolerance on the finer mesh.
  while (other.base.mesh->faces() != result.base.mesh->faces()) {
    result = offset(other.base, options);
    if (result.base.mesh->faces() != other.base.mesh->faces()) other = offset(result.base, back);
  }
  return options.distance > 0 ? control_mesh(shell(result.surface, other.surface))
                              : control_mesh(shell(other.surface, result.surface));
}

Value show_offset(CallContext& context, const Arguments& a) {
  const OffsetOptions options = offset_options(a, context);
  return Value{offset_table(run_offset(context, a, options), options)};
}

Value show_error(CallContext& context, const Arguments& a) { return Value{error_report(offset_pair(a, context), a, context)}; }

Value make_error_colours(CallContext& context, const Arguments& a) {
  const OffsetPair pair = offset_pair(a, context);
  const double distance = number_as<double>(need_number(a, 2, "distance"));
  const std::string name = choice_or(a, "measure", {"eps", "E", "En", "Et"});
  const OffsetMeasure measure = name == "E"    ? OffsetMeasure::full
                                : name == "En" ? OffsetMeasure::normal
                                : name == "Et" ? OffsetMeasure::slip
                                               : OffsetMeasure::eps;
  const OffsetSamples samples = sample_offset(pair.surface, pair.d, whole_or(a, a.positional.size(), "samples", 2, 0, 6),
                                              run_control(context, "offset_colours"));
  Surface<double> limit{samples.surface.mesh, samples.position + samples.delta, samples.surface.tags, {}};
  const LoopLimit<double> limit_of(samples.surface.mesh, samples.surface.tags);
  const Points<double> f = samples.surface.points + samples.control;
  std::vector<double> values = measure_offset(samples, distance, measure);
  for (double& value : values) value = std::abs(value);
  return coloured_surface(limit, limit_normals(limit_of, f), "error", std::move(values));
}

Value show_intersections(CallContext& context, const Arguments& a) {
  return Value{intersection_report(offset_pair(a, context), whole_or(a, a.positional.size(), "rounds", 1, 0, 6), context)};
}

Value make_intersection_colours(CallContext& context, const Arguments& a) {
  const OffsetPair pair = offset_pair(a, context);
  const SelfIntersection found = find_self_intersections(
      pair.surface, pair.d, whole_or(a, a.positional.size(), "rounds", 1, 0, 6), run_control(context, "self_intersections"));
  // A folded surface has no useful normals: those of its faces serve, which the writer makes.
  MeshValue result{found.surface, "limit of loop", nullptr};
  std::get<Surface<double>>(result.shape).attributes["hit"] = marks(found);
  result.colour = "hit";
  return Value{std::move(result)};
}

Value show_fold_distances(CallContext& context, const Arguments& a) {
  const CurvatureRange range = curvature_range(mesh_of(a), run_control(context, "curvature"));
  const auto number = [](double x) { return std::isfinite(x) ? Json(x) : Json(nullptr); };
  ReportValue report;
  report.text = "curvatures from " + short_number(range.least) + " (face " + std::to_string(range.least_face) + ") to " +
                short_number(range.greatest) + " (face " + std::to_string(range.greatest_face) +
                "): exact offsets do not fold for distances between " +
                (std::isfinite(range.lowest_distance()) ? short_number(range.lowest_distance()) : "-infinity") + " and " +
                (std::isfinite(range.highest_distance()) ? short_number(range.highest_distance()) : "infinity") + " (sampled" +
                (range.excluded > 0 ? ", without the neighbourhoods of " + std::to_string(range.excluded) +
                                          " vertices where curvature is unbounded)"
                                    : ")");
  report.json = {{"kind", "fold_distances"},
                 {"least", range.least},
                 {"greatest", range.greatest},
                 {"lowest_distance", number(range.lowest_distance())},
                 {"highest_distance", number(range.highest_distance())},
                 {"excluded", range.excluded}};
  report.parts = {number_of(range.least), number_of(range.greatest)};
  return Value{std::move(report)};
}

/// What a claim says of a number must hold for the number itself: rational ones and doubles as they are, no others.
Rational exact_number(const Arguments& a, std::size_t position, std::string_view name) {
  const NumberValue value = need_number(a, position, name);
  if (const auto* x = std::get_if<double>(&value.value)) return Rational::from_double(*x);
  return number_as<Rational>(value);
}

/// The claim at the argument N, or at every valence of the domain.
template <class F>
Value at_valences(CallContext& context, const Arguments& a, F prove) {
  if (a.get(0, "valence")) return claim_value(prove(need_whole(a, 0, "valence", 3, 200)));
  if (!context.domain || context.domain->valences.empty())
    throw Error(ErrorKind::word, "E_DOMAIN", "the claim speaks of a valence", "add: for N in 3 .. 8");
  std::vector<Result> results;
  for (const int n : context.domain->valences) results.push_back(prove(n));
  return claim_value(all_of(std::move(results)));
}

}  // namespace

Value claim_offset_contracts(CallContext& context, const Arguments& a) {
  const std::string rule = choice_or(a, "rule", {"paper", "pair", "star"});
  return at_valences(context, a, [&](int n) {
    const bool star = rule == "star" || (rule == "paper" && n <= 4);
    return prove_offset_contraction(n, star ? LocalSet::star : LocalSet::pair);
  });
}

Value claim_offset_definite(CallContext& context, const Arguments& a) { return at_valences(context, a, prove_offset_definite); }

Value claim_offset_within(CallContext& context, const Arguments& a) {
  const OffsetPair pair = offset_pair(a, context);
  const Rational distance = exact_number(a, 2, "distance");
  std::optional<Rational> bound;
  if (a.get(3, "bound")) bound = exact_number(a, 3, "bound");
  const bool full = choice_or(a, "measure", {"E", "eps"}) == "E";
  return claim_value(prove_offset_error(pair.surface, pair.d, distance, full, bound, search_limits(context)));
}

Value claim_embedded(CallContext& context, const Arguments& a) {
  return claim_value(prove_embedded(three_columns(as_rational(need_mesh(a, 0))), search_limits(context)));
}

std::vector<Builtin> builtins_offset() {
  return {
      {"offset",
       "offset(mesh, distance = d, tolerance = ..., max_level = 5, solver = automatic | direct | edge | star | gauss_seidel | "
       "richardson | cg "
       "| jacobi, fit = no, local = no, pad = 1, samples = 2, shell = no)",
       "The control mesh of a Loop surface at a distance from the one of the mesh; a tolerance refines it; shell = yes makes a "
       "closed body.",
       1, 2, with({"shell"}), make_offset},
      {"offset_report", "offset_report(mesh, distance = d, ...)",
       "What offset does: levels, unknowns, solver, errors and bounds; arguments as for offset.", 1, 2, offset_arguments,
       show_offset},
      {"offset_error",
       "offset_error(mesh, offset, distance, samples = 3, foot = no, certified = no)",
       "How far the Loop surface of the second mesh is from the offset of the first: sampled errors and upper bounds.",
       2,
       3,
       {"distance", "samples", "foot", "certified"},
       show_error},
      {"offset_colours",
       "offset_colours(mesh, offset, distance, measure = eps | E | En | Et, samples = 2)",
       "The offset surface with the modulus of its error as the attribute error.",
       2,
       3,
       {"distance", "measure", "samples"},
       make_error_colours},
      {"self_intersections",
       "self_intersections(mesh, offset, rounds = 1)",
       "Does an offset of the mesh meet or fold over itself? Verdict, counts and pairs of faces; approximate.",
       2,
       2,
       {"rounds"},
       show_intersections},
      {"self_intersection_colours",
       "self_intersection_colours(mesh, offset, rounds = 1)",
       "The offset surface with the attribute hit: 1 where faces meet, 0.5 where it folds.",
       2,
       2,
       {"rounds"},
       make_intersection_colours},
      {"fold_distances",
       "fold_distances(mesh)",
       "Between which distances exact offsets of the Loop surface do not fold, by its sampled curvatures.",
       1,
       1,
       {},
       show_fold_distances},
      {"offset_contracts",
       "offset_contracts(valence, rule = paper | pair | star)",
       "Claim: the edge iteration for offsets contracts at vertices of this valence, or of all in: for N in 3 .. 8.",
       0,
       1,
       {"valence", "rule"},
       claim_offset_contracts},
      {"offset_definite",
       "offset_definite(valence)",
       "Claim: the system for offsets is positive definite at vertices of this valence, or of all in: for N in 3 .. 8.",
       0,
       1,
       {"valence"},
       claim_offset_definite},
      {"offset_within",
       "offset_within(mesh, offset, distance, bound, measure = E | eps)",
       "Claim: the offset surface is everywhere within the bound of the exact offset; closed meshes, their points as doubles.",
       2,
       4,
       {"distance", "bound", "measure"},
       claim_offset_within},
      {"embedded",
       "embedded(mesh)",
       "Claim: the Loop surface of the closed mesh does not meet itself.",
       1,
       1,
       {},
       claim_embedded},
  };
}

}  // namespace udcp
