// Solve, sample, refine, repeat.
#include "operators/methods/offset/offset.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>

#include "operators/methods/offset/offset_fit.h"
#include "operators/schemes.h"

namespace udcp {
namespace {

std::size_t at(int k) { return static_cast<std::size_t>(k); }

[[noreturn]] void refuse(const char* code, const std::string& message) { throw Error(ErrorKind::input, code, message, ""); }

void check(const OffsetOptions& options) {
  if (!std::isfinite(options.distance)) refuse("E_NOT_FINITE", "the distance of the offset is not finite");
  const double size = std::abs(options.distance);
  if (size > 1e100 || (size > 0 && size < 1e-100))  // squares of errors must neither overflow nor vanish
    refuse("E_OPTION", "distances of offsets are 0 or from 1e-100 to 1e100 in modulus, not " + to_text(options.distance));
  if (options.tolerance && !(std::isfinite(*options.tolerance) && *options.tolerance > 0))
    refuse("E_TOLERANCE", "the tolerance must be a positive number, not " + to_text(*options.tolerance));
  if (options.max_level < 0 || options.max_level > 12)
    refuse("E_OPTION", "max_level must be from 0 to 12, not " + std::to_string(options.max_level));
  if (options.sample_rounds < 0 || options.sample_rounds > 6)
    refuse("E_OPTION", "errors are sampled after 0 to 6 rounds, not " + std::to_string(options.sample_rounds));
  if (options.pad < 0 || options.pad > 100) refuse("E_OPTION", "pad must be from 0 to 100, not " + std::to_string(options.pad));
}

/// The state of the loop over levels.
class Approximation {
 public:
  Approximation(const Surface<double>& surface, const OffsetOptions& options) : options_(options) {
    result_.base = surface;
    result_.base.attributes.clear();
    solve_ = options.solve;
    if (solve_.stop == nullptr) solve_.stop = options.control.stop;
  }

  void solve() {
    const LoopLimit<double> limit(result_.base.mesh, result_.base.tags);
    const Points<double> wanted = options_.distance * limit_normals(limit, result_.base.points);
    note(solve_offset(limit, wanted, solve_), false);
    finish(result_.base.mesh->vertices());
  }

  /// After a refinement of S and d: imposes the interpolation at active vertices again.
  void correct(const std::vector<char>& active) {
    const LoopLimit<double> limit(result_.base.mesh, result_.base.tags);
    const Points<double> wanted = options_.distance * limit_normals(limit, result_.base.points) - limit.points(result_.d);
    note(solve_offset(limit, wanted, solve_, &active), true);
    finish(static_cast<int>(std::ranges::count(active, 1)));
  }

  /// One Loop step of S and d together; with `local`, the vertices to solve for again.
  std::vector<char> refine() {
    std::vector<char> active;
    Surface<double> both{result_.base.mesh, Points<double>(result_.d.rows(), 6), result_.base.tags, {}};
    both.points << result_.base.points, result_.d;
    both = run(schemes::loop(), std::move(both), 1, options_.control);
    if (options_.local) active = active_vertices(*both.mesh);
    result_.base = {both.mesh, both.points.leftCols(3), both.tags, {}};
    result_.d = both.points.rightCols(3);
    return active;
  }

  void keep_best_fit() {
    double best = result_.errors.eps;
    for (const double alpha : {0.1, 0.01}) {
      Points<double> d = fit_offset(result_.base, options_.distance, alpha, options_.control);
      const OffsetErrors errors =
          offset_errors(sample_offset(result_.base, d, options_.sample_rounds, options_.control), options_.distance);
      if (!(errors.eps < best)) continue;
      best = errors.eps;
      result_.d = std::move(d);
      result_.fit_weight = alpha;
    }
    if (result_.fit_weight > 0) measure();
  }

  [[nodiscard]] double eps() const { return result_.errors.eps; }
  /// Faces on which the next level would be sampled.
  [[nodiscard]] std::int64_t next_faces() const {
    return std::int64_t{result_.base.mesh->faces()} << (2 * (1 + options_.sample_rounds));
  }
  [[nodiscard]] int level() const { return static_cast<int>(result_.log.size()) - 1; }

  [[nodiscard]] OffsetResult result() const {
    OffsetResult result = result_;
    result.surface = result.base;
    result.surface.points += result.d;
    return result;
  }

 private:
  void note(OffsetSolution solution, bool add) {
    result_.d = add ? Points<double>(result_.d + solution.d) : std::move(solution.d);
    result_.solver = solution.solver;
    result_.iterations = solution.iterations;
    result_.residual = solution.residual;
    result_.fit_weight = 0;
  }

  void measure() {
    const OffsetSamples samples = sample_offset(result_.base, result_.d, options_.sample_rounds, options_.control);
    result_.errors = offset_errors(samples, options_.distance);
    by_face_ = errors_by_face(samples, options_.distance, options_.sample_rounds);
    result_.worst_face = static_cast<int>(std::ranges::max_element(by_face_) - by_face_.begin());
  }

  void finish(int unknowns) {
    measure();
    if (options_.fit) keep_best_fit();
    result_.log.push_back({level() + 1, result_.base.mesh->vertices(), unknowns, result_.errors.eps});
  }

  /// Of the refined mesh: vertices of the children of faces with a large error, and `pad` rings around.
  [[nodiscard]] std::vector<char> active_vertices(const Mesh& fine) const {
    std::vector<char> active(at(fine.vertices()), 0);
    for (int h = 0; h < fine.half_edges(); ++h)
      if (by_face_[at(fine.face[at(h)] / 4)] > *options_.tolerance) active[at(fine.vertex[at(h)])] = 1;
    for (int ring = 0; ring < options_.pad; ++ring) {
      const std::vector<char> before = active;
      for (int f = 0; f < fine.faces(); ++f) {
        const auto corners = fine.corners(f);
        if (std::ranges::any_of(corners, [&](int v) { return before[at(v)] != 0; }))
          for (const int v : corners) active[at(v)] = 1;
      }
    }
    return active;
  }

  const OffsetOptions& options_;
  SolveOptions solve_;
  OffsetResult result_;
  std::vector<double> by_face_;
};

}  // namespace

OffsetResult offset(const Surface<double>& surface, const OffsetOptions& options) {
  validate_control_mesh(surface);
  validate_boundary_normals(*surface.mesh, surface.tags);
  check(options);
  Approximation state(surface, options);
  state.solve();
  if (!options.tolerance) return state.result();
  OffsetResult best = state.result();
  while (state.eps() > *options.tolerance) {
    const bool too_large = state.next_faces() > options.control.max_faces;
    if (state.level() >= options.max_level || too_large) {
      std::string message = "after " + std::to_string(state.level()) + " refinements the error is " + to_text(state.eps()) +
                            ", above the tolerance " + to_text(*options.tolerance) + "; the best was " +
                            to_text(best.errors.eps) + " at level " + std::to_string(best.log.back().level);
      if (too_large)
        message += "; one more would be sampled on " + std::to_string(state.next_faces()) + " faces, and the limit is " +
                   std::to_string(options.control.max_faces);
      throw ToleranceError(message, std::make_shared<const OffsetResult>(std::move(best)));
    }
    const std::vector<char> active = state.refine();
    options.local ? state.correct(active) : state.solve();
    if (options.control.progress) options.control.progress(static_cast<double>(state.level()) / (options.max_level + 1));
    if (state.eps() < best.errors.eps) best = state.result();
  }
  return state.result();
}

Surface<double> shell(const Surface<double>& outer, const Surface<double>& inner) {
  const Mesh& mesh = *outer.mesh;
  const int n = mesh.vertices();
  if (inner.mesh->vertex != mesh.vertex)
    throw Error(ErrorKind::input, "E_POINTS", "the two sides of a shell must have the same faces", "");
  std::vector<int> begin{0}, corners;
  const auto add = [&](std::array<int, 3> face) {
    corners.insert(corners.end(), face.begin(), face.end());
    begin.push_back(static_cast<int>(corners.size()));
  };
  for (int f = 0; f < mesh.faces(); ++f) add({mesh.corners(f)[0], mesh.corners(f)[1], mesh.corners(f)[2]});
  for (int f = 0; f < mesh.faces(); ++f) add({n + mesh.corners(f)[0], n + mesh.corners(f)[2], n + mesh.corners(f)[1]});
  for (int h = 0; h < mesh.half_edges(); ++h) {
    if (mesh.twin[at(h)] >= 0) continue;
    const int a = mesh.vertex[at(h)], b = mesh.tip(h);
    add({b, a, n + a});
    add({b, n + a, n + b});
  }
  Surface<double> body;
  body.mesh = std::make_shared<const Mesh>(make_mesh(2 * n, std::move(begin), std::move(corners)));
  body.points.resize(2 * n, 3);
  body.points << outer.points, inner.points;
  return body;
}

}  // namespace udcp
