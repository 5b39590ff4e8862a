// Applying words to shapes. The atoms are in operators/; here is only what a program adds: limits, progress, the record of the
// word.
#include "interpreter/apply.h"

#include "files/geometry_file.h"

#include <unistd.h>

#include <algorithm>
#include <thread>

#include "interpreter/formula.h"
#include "interpreter/kept_plan.h"
#include "interpreter/words.h"
#include "operators/limit.h"

namespace udcp {

namespace {

/// Triangle words need triangles; said here, where the step can be named, before any work.
template <class S>
void check_triangles(const Word& word, const Surface<S>& surface) {
  if (!word.triangles) return;
  for (int f = 0; f < surface.mesh->faces(); ++f) {
    if (surface.mesh->size(f) == 3) continue;
    throw Error(
        ErrorKind::input, "E_NOT_TRIANGLES",
        "this word is on triangles, but face " + std::to_string(f) + " has " + std::to_string(surface.mesh->size(f)) + " corners",
        "cut the faces with triangulate(mesh) first");
  }
}

Surface<double> refine(const Word& word, Surface<double> surface, int rounds, const RunControl& control, CallContext& context) {
  KeptPlan* const kept = context.kept;
  if (kept == nullptr) return run(word, std::move(surface), rounds, control);
  if (std::optional<Surface<double>> result = kept->refine(word, surface, rounds, control, thread_count(context.settings)))
    return std::move(*result);
  Surface<double> result = run(word, surface, rounds, control);
  kept->remember(word, surface, rounds, result);
  return result;
}
template <class S>
Surface<S> refine(const Word& word, Surface<S> surface, int rounds, const RunControl& control, CallContext&) {
  return run(word, std::move(surface), rounds, control);
}

Value apply_to_mesh(const WordValue& word, MeshValue mesh, int rounds, const RunControl& control, CallContext& context) {
  MeshValue result{{}, word.source, nullptr};
  if (word.rounds) result.scheme = std::make_shared<const WordValue>(word);
  std::visit(
      [&](auto& surface) {
        check_triangles(word.word, surface);
        result.shape = refine(word.word, std::move(surface), rounds, control, context);
      },
      mesh.shape);
  return Value{std::move(result)};
}

Value apply_to_curve(const WordValue& word, CurveValue curve, int rounds, const RunControl& control) {
  validate_for_curve(word.word);
  CurveValue result;
  result.control = curve.control ? curve.control : std::make_shared<const Polyline<double>>(as_double(curve));
  std::visit([&](auto& line) { result.shape = run(word.word, std::move(line), rounds, control); }, curve.shape);
  return Value{std::move(result)};
}

/// A formula without an exact value on an exact shape: say what to do about it.
[[noreturn]] void explain_not_exact(const Error& error) {
  Error better = error;
  if (better.help.empty()) better.help = "this shape is exact; approximate(shape) makes it double";
  throw better;
}

}  // namespace

/// Three quarters of the physical memory.
static std::int64_t default_max_bytes() {
  const long pages = sysconf(_SC_PHYS_PAGES), size = sysconf(_SC_PAGESIZE);
  return pages > 0 && size > 0 ? static_cast<std::int64_t>(pages) / 4 * 3 * size : 0;
}

int thread_count(const Settings& settings) {
  return settings.threads > 0 ? settings.threads : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

RunControl run_control(const CallContext& context, const std::string& what) {
  RunControl control;
  control.max_faces = context.settings.max_faces;
  control.max_bytes = context.settings.max_bytes > 0 ? context.settings.max_bytes : default_max_bytes();
  control.stop = context.stop.get();
  if (context.output.progress && !context.settings.quiet)
    control.progress = [&output = context.output, what](double fraction) { output.progress(what, fraction); };
  return control;
}

Value apply(const WordValue& word, Value shape, CallContext& context) {
  if (auto* list = std::get_if<ListValue>(&shape.data)) {
    for (Value& item : list->items) item = apply(word, std::move(item), context);
    return shape;
  }
  if (!shape.as<MeshValue>() && !shape.as<CurveValue>())
    throw wrong_type("what a word is applied to", "a curve or a mesh", shape);
  if (word.word.is_scheme() && !word.rounds)
    throw Error(ErrorKind::word, "E_ROUNDS", "this word repeats for ever, so it needs a number of rounds here",
                "write (" + word.source + ")^4 for four rounds, or limit(" + word.source + ") for the limit points");
  const RunControl control = run_control(context, word.source);
  const int rounds = word.rounds.value_or(1);
  try {
    if (auto* mesh = std::get_if<MeshValue>(&shape.data)) return apply_to_mesh(word, std::move(*mesh), rounds, control, context);
    return apply_to_curve(word, std::move(std::get<CurveValue>(shape.data)), rounds, control);
  } catch (const Located& error) {
    if (error.kind != ErrorKind::not_exact || !error.help.empty()) throw;
    Located better = error;
    better.help = "if the shape is exact, approximate(shape) makes it double";
    throw better;
  } catch (const Error& error) {
    if (error.kind == ErrorKind::not_exact) explain_not_exact(error);
    throw;
  }
}

std::shared_ptr<const Points<double>> limit_normals(const WordValue& word, int rounds, const Surface<double>& surface,
                                                    RunControl control) {
  constexpr int most = 250'000;  // vertices; beyond it a viewer sees no difference to the normals of the faces
  if (!word.word.is_scheme() || surface.mesh->vertices() > most) return nullptr;
  control.first_item = word.word.items(rounds);
  try {
    return std::make_shared<const Points<double>>(limit(word.word, surface, control).normals);
  } catch (const Error& error) {
    if (error.kind == ErrorKind::interrupted) throw;
    return nullptr;  // a scheme without limit normals: dual, varying from point to point, or divergent
  }
}

namespace {

/// The points as the file has them, if the file still holds the points that the mesh has in double.
std::optional<Points<Rational>> decimals_of(const MeshValue& mesh) {
  if (mesh.file.empty()) return std::nullopt;
  try {
    Points<Rational> points = load<Rational>(mesh.file).points;
    const Points<double>& rounded = std::get<Surface<double>>(mesh.shape).points;
    if (points.rows() != rounded.rows() || points.cols() != rounded.cols()) return std::nullopt;
    for (Eigen::Index k = 0; k < points.size(); ++k)
      if (points.data()[k].to_double() != rounded.data()[k]) return std::nullopt;
    return points;
  } catch (const Error&) {
    return std::nullopt;  // gone or changed
  }
}

}  // namespace

Surface<double> as_double(const MeshValue& mesh) {
  if (const auto* surface = std::get_if<Surface<double>>(&mesh.shape)) return *surface;
  return convert<double>(std::get<Surface<Algebraic>>(mesh.shape));
}

Surface<Rational> as_rational(const MeshValue& mesh) {
  if (const auto* exact = std::get_if<Surface<Algebraic>>(&mesh.shape))
    return convert<Rational>(Surface<Algebraic>{exact->mesh, exact->points, exact->tags, {}});
  const auto& surface = std::get<Surface<double>>(mesh.shape);
  if (std::optional<Points<Rational>> decimals = decimals_of(mesh)) return {surface.mesh, std::move(*decimals), surface.tags, {}};
  Surface<Rational> result{surface.mesh, Points<Rational>(surface.points.rows(), surface.points.cols()), surface.tags, {}};
  for (Eigen::Index k = 0; k < result.points.size(); ++k)
    result.points.data()[k] = Rational::from_double(surface.points.data()[k]);
  return result;
}

Polyline<double> as_double(const CurveValue& curve) {
  if (const auto* line = std::get_if<Polyline<double>>(&curve.shape)) return *line;
  return convert<double>(std::get<Polyline<Algebraic>>(curve.shape));
}

}  // namespace udcp
