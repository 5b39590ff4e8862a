// Catmull-Clark surfaces through given points with given normals, as functions of the language.
#include "interpreter/interpolation.h"
#include "operators/schemes.h"

namespace udcp {
namespace {

std::vector<std::string_view> arguments(std::vector<std::string_view> more = {}) {
  more.insert(more.begin(), interpolation_arguments.begin(), interpolation_arguments.end());
  return more;
}

bool wants_normals(const Arguments& a) {
  const Value* value = a.get(1, "normals");
  const auto* flag = value ? value->as<Boolean>() : nullptr;
  return value && !(flag && !flag->value);
}

/// Without normals one refinement is enough, and exact meshes stay exact.
Value interpolate_only_points(CallContext& context, const Arguments& a) {
  const MeshValue& mesh = need_mesh(a, 0);
  return std::visit(
      [&](const auto& surface) {
        const InterpolateOptions options = interpolation_options(a, surface.mesh->vertices(), context);
        if (options.method != InterpolationMethod::two_level)
          throw Error(ErrorKind::word, "E_ARGUMENTS", "the methods literal and kkt are about normals, but there are none",
                      "add normals = yes, or leave 'method' away");
        if (options.flip)
          throw Error(ErrorKind::word, "E_ARGUMENTS", "'flip' is about the side of normals, but there are none",
                      "add normals = yes, or leave 'flip' away");
        const PointOptions points{options.step1, options.lambda, options.skipped_points, options.control};
        return Value{MeshValue{interpolate_points(surface, points), "interpolate", nullptr}};
      },
      mesh.shape);
}

Value make_interpolation(CallContext& context, const Arguments& a) {
  if (!wants_normals(a)) return interpolate_only_points(context, a);
  if (std::holds_alternative<Surface<Algebraic>>(need_mesh(a, 0).shape))
    throw Error(ErrorKind::not_exact, "E_NOT_EXACT",
                "the weights of tangents are irrational, so normals are met in floating point",
                "write interpolate(approximate(mesh), ...), or prove interpolates(mesh, ...) for an exact statement");
  InterpolationRun run = run_interpolation(a, context);
  return Value{MeshValue{std::move(run.result.control), "interpolate", nullptr}};
}

Value show_report(CallContext& context, const Arguments& a) { return Value{interpolation_table(run_interpolation(a, context))}; }

Value make_figure(CallContext& context, const Arguments& a) {
  const InterpolationRun run = run_interpolation(a, context);
  const int rounds = whole_or(a, a.positional.size(), "rounds", 3, 0, 8);
  const double length = a.find("length") ? number_as<double>(need_number(a, a.positional.size(), "length")) : 0;
  return Value{MeshValue{interpolation_figure(run, rounds, length, run_control(context, "figure")), "", nullptr}};
}

Value attribute_prefix(CallContext&, const Arguments& a) { return Value{TextValue{need_text(a, 0, "attribute")}}; }

}  // namespace

std::vector<Builtin> builtins_interpolation() {
  return {
      {"interpolate",
       "interpolate(mesh, normals = no | yes | from(\"n\") | list | function, lambda = 7/10, step1 = global | local | plain, "
       "step2 = "
       "auto | free | tied | rotate, method = two_level | literal | kkt, order = jacobi | gauss | average, sweeps = 5, flip = "
       "no, "
       "free_points = [], free_normals = [])",
       "A control mesh whose Catmull-Clark limit passes through the vertices, with the normals; the vertices come first in it.",
       1, 2, arguments(), make_interpolation},
      {"interpolation_report", "interpolation_report(mesh, normals = yes, ...)",
       "What interpolate does at each vertex: angle before, correction, displacement; arguments as for interpolate.", 1, 2,
       arguments(), show_report},
      {"interpolation_figure", "interpolation_figure(mesh, normals = yes, ..., rounds = 3, length = ...)",
       "Cage, plain Catmull-Clark and the interpolating surface with its normals, side by side; attribute part.", 1, 2,
       arguments({"rounds", "length"}), make_figure},
      {"interpolates", "interpolates(mesh, normals = yes, step1 = global | local, lambda = 7/10, step2 = free | tied)",
       "Claim: interpolate meets all points and normals exactly, side included.", 1, 2, arguments(), claim_interpolates},
      {"iteration_converges",
       "iteration_converges(mesh, lambda = 7/10)",
       "Claim: the progressive iteration of interpolate converges; without a mesh, for 7/20 < lambda <= 1 at the valences N.",
       0,
       1,
       {"lambda", "N"},
       claim_iteration_converges},
      {"from", "from(\"n\")", "Normals from the attributes nx, ny, nz, for interpolate.", 1, 1, {"attribute"}, attribute_prefix},
  };
}

}  // namespace udcp
