// The modified step, its limits, and the system that makes them the given points.
#include "operators/methods/interpolation/interpolate_points.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "operators/interrupt.h"
#include "operators/methods/interpolation/limit_masks.h"
#include "operators/methods/interpolation/mesh_system.h"
#include "operators/methods/interpolation/point_system.h"
#include "operators/methods/interpolation/quad_fans.h"
#include "operators/schemes.h"

namespace udcp {
namespace {

std::size_t at(int k) { return Mesh::i(k); }

bool is_skipped(const std::vector<char>& skipped, int v) { return !skipped.empty() && skipped[at(v)] != 0; }

template <class S>
bool is_finite(const S&) {
  return true;
}
bool is_finite(double value) { return std::isfinite(value); }

// The weights of a mask in the number type, each converted once.
template <class S>
struct Weights {
  explicit Weights(const PointMask& mask)
      : vertex(number<S>(mask.vertex)), edge(number<S>(mask.edge)), face(number<S>(mask.face)) {}
  S vertex, edge, face;
};

// Visits the vertices below `count` with what their limit takes from their fan, without their own share: visit(v, weight of v,
// row 0 of the rest).
template <class S, class Visit>
void for_each_limit(const Surface<S>& fine, int count, Visit visit) {
  LimitMasks masks;
  std::map<int, Weights<S>> inside;
  const Weights<S> boundary(masks.boundary());
  Fan fan;
  Points<S> rest(1, fine.points.cols());
  for (int v = 0; v < count; ++v) {
    rest.setZero();
    if (fine.tags.is_corner(v)) {
      visit(v, S(1), rest);
      continue;
    }
    collect_fan(*fine.mesh, v, fan);
    if (!fan.inside) {
      add(rest, 0, boundary.edge, fine.points, fan.e.front());
      add(rest, 0, boundary.edge, fine.points, fan.e.back());
      visit(v, boundary.vertex, rest);
      continue;
    }
    auto known = inside.find(fan.faces());
    if (known == inside.end()) known = inside.emplace(fan.faces(), Weights<S>(masks.inside(fan.faces()))).first;
    for (const int e : fan.e) add(rest, 0, known->second.edge, fine.points, e);
    for (const int f : fan.f) add(rest, 0, known->second.face, fine.points, f);
    visit(v, known->second.vertex, rest);
  }
}

template <class S>
double largest_difference(const Points<S>& a, const Points<S>& b) {
  double result = 0;
  for (Eigen::Index i = 0; i < a.size(); ++i) result = std::max(result, std::abs(approximate(S(a.data()[i] - b.data()[i]))));
  return result;
}

template <class S>
double size_of(const Points<S>& points) {
  double result = 0;
  for (Eigen::Index i = 0; i < points.size(); ++i) result = std::max(result, std::abs(approximate(points.data()[i])));
  return result;
}

}  // namespace

Word modified_vertex_rule_of(KernelPtr delta) {
  Item split, convolve, push;
  convolve.atom = Atom::convolve;
  convolve.f = Directional<KernelPtr>::all(constant(Rational(1) / Rational(3)));
  push.atom = Atom::push_back;
  push.omega = Directional<KernelPtr>::all(constant(Rational(0)));
  push.delta = std::move(delta);
  Word word;
  word.head = {split, convolve, push};
  return word;
}

Word modified_vertex_rule(const Rational& lambda) {
  return modified_vertex_rule_of(constant((Rational(64) * lambda - Rational(25)) / Rational(39)));
}

template <class S>
Surface<S> modified_step(const Surface<S>& cage, const Rational& lambda, const RunControl& control) {
  Surface<S> fine = run(schemes::catmull_clark(), cage, 1, control);
  const Surface<S> bare{cage.mesh, cage.points, cage.tags, {}};
  RunControl rest = control;
  rest.progress = nullptr;
  const Points<S> vertices = run(modified_vertex_rule(lambda), bare, 1, rest).points;
  fine.points.topRows(cage.mesh->vertices()) = vertices.topRows(cage.mesh->vertices());
  return fine;
}

template <class S>
Points<S> limit_points(const Surface<S>& fine, int count) {
  Points<S> result = Points<S>::Zero(count, fine.points.cols());
  for_each_limit(fine, count, [&](int v, const S& weight, const Points<S>& rest) {
    add(result, v, weight, fine.points, v);
    add(result, v, S(1), rest, 0);
  });
  return result;
}

template <class S>
Surface<S> put_limits(Surface<S> fine, const Points<S>& targets, const std::vector<char>& skipped) {
  Points<S> moved = targets;
  for_each_limit(fine, static_cast<int>(targets.rows()), [&](int v, const S& weight, const Points<S>& rest) {
    const S scale = S(1) / weight;
    moved.row(v).setZero();
    if (is_skipped(skipped, v)) {
      add(moved, v, S(1), fine.points, v);
    } else {
      add(moved, v, scale, targets, v);
      add(moved, v, S(-scale), rest, 0);
    }
  });
  fine.points.topRows(targets.rows()) = moved;
  return fine;
}

void check_lambda(const Rational& lambda) {
  if (lambda > Rational(7) / Rational(20) && lambda <= Rational(1)) return;
  throw Error(ErrorKind::input, "E_LAMBDA",
              "lambda = " + lambda.to_string() +
                  " is outside (7/20, 1]: the eigenvalues of the map from control points to limit points are at least "
                  "n(20 lambda - 7)/(13(n + 5)), attained on two-colourable meshes, so at 7/20 it stops being invertible",
              "7/10 is the usual value; smaller ones inflate, larger ones flatten; step1 = local needs no lambda");
}

template <class S>
void check_cage(const Surface<S>& cage) {
  validate(cage);
  for (int v = 0; v < cage.mesh->vertices(); ++v) {
    if (!cage.mesh->on_boundary(v) && cage.mesh->valence(v) < 3)
      throw Error(ErrorKind::input, "E_VALENCE2",
                  "vertex " + std::to_string(v) + " has two edges and lies inside; interpolation needs three or more there",
                  "merge its two faces, or split them");
    for (Eigen::Index c = 0; c < cage.points.cols(); ++c)
      if (!is_finite(cage.points(v, c)))
        throw Error(ErrorKind::input, "E_NOT_FINITE", "vertex " + std::to_string(v) + " has a coordinate that is not finite", "");
  }
}

template <class S>
Surface<S> interpolate_points(const Surface<S>& cage, const PointOptions& options) {
  check_cage(cage);
  const Word& word = schemes::catmull_clark();
  if (options.step == PointStep::plain) return put_limits(run(word, cage, 2, options.control), cage.points, options.skipped);
  if (options.step == PointStep::local) {
    const bool all = std::none_of(options.skipped.begin(), options.skipped.end(), [](char c) { return c != 0; });
    Surface<S> fine = all ? run(word, cage, 1, options.control) : modified_step(cage, options.lambda, options.control);
    return put_limits(std::move(fine), cage.points, options.skipped);
  }
  check_lambda(options.lambda);
  Surface<S> start = cage;
  start.points = solve_for_limits(cage, options);
  return modified_step(start, options.lambda, options.control);
}

namespace {

template <class S>
void note_difference(Progress<S>& progress, double difference) {
  if (!progress.differences.empty() && progress.differences.back() > 0)
    progress.contraction = difference / progress.differences.back();
  progress.differences.push_back(difference);
}

template <class S>
void correct(Points<S>& points, const Points<S>& targets, const Points<S>& limits, const std::vector<char>& skipped) {
  for (int v = 0; v < static_cast<int>(targets.rows()); ++v) {
    if (is_skipped(skipped, v)) continue;
    add(points, v, S(1), targets, v);
    add(points, v, S(-1), limits, v);
  }
}

// The difference as the iteration sees it: skipped vertices have none.
template <class S>
double difference_of(const Points<S>& targets, Points<S> limits, const std::vector<char>& skipped) {
  for (int v = 0; v < static_cast<int>(targets.rows()); ++v)
    if (is_skipped(skipped, v)) limits.row(v) = targets.row(v);
  return largest_difference(targets, limits);
}

}  // namespace

template <class S>
Progress<S> progress_points(const Surface<S>& cage, const PointOptions& options, int iterations, double tolerance) {
  check_cage(cage);
  if (options.step == PointStep::plain || iterations < 0)
    throw Error(ErrorKind::input, "E_ARGUMENTS", "the iteration exists for global and local, and for 0 or more iterations", "");
  const int count = cage.mesh->vertices();
  const double size = size_of(cage.points);
  Surface<S> start = cage;
  Progress<S> result{modified_step(cage, options.lambda, options.control), {}, 0};
  for (int k = 0; k < iterations; ++k) {
    throw_if_stopped(options.control.stop);
    const Points<S> limits = limit_points(result.control, count);
    note_difference(result, difference_of(cage.points, limits, options.skipped));
    if (result.differences.back() <= tolerance * size || !(result.differences.back() < 1e100)) break;
    if (options.step == PointStep::local) {
      correct(result.control.points, cage.points, limits, options.skipped);
    } else {
      correct(start.points, cage.points, limits, options.skipped);
      result.control = modified_step(start, options.lambda, options.control);
    }
    if (options.control.progress) options.control.progress(static_cast<double>(k + 1) / iterations);
  }
  return result;
}

#define UDCP_INSTANTIATE(S)                                                                 \
  template Surface<S> modified_step(const Surface<S>&, const Rational&, const RunControl&); \
  template Points<S> limit_points(const Surface<S>&, int);                                  \
  template Surface<S> put_limits(Surface<S>, const Points<S>&, const std::vector<char>&);   \
  template void check_cage(const Surface<S>&);                                              \
  template Surface<S> interpolate_points(const Surface<S>&, const PointOptions&);           \
  template Progress<S> progress_points(const Surface<S>&, const PointOptions&, int, double);
UDCP_FOR_EACH_COORDINATE(UDCP_INSTANTIATE)
#undef UDCP_INSTANTIATE

}  // namespace udcp
