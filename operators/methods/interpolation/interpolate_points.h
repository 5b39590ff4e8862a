// Step 1 of interpolation: control points whose Catmull-Clark limit passes through the vertices of a mesh. "Catmull-Clark
// Subdivision Interpolation Based on Vertex Normal Vector Constraint", equations (1) and (3), with the corrections that
// interpolation.h tells. Refinement is run() of words; knows no normals.
#pragma once

#include <vector>

#include "operators/run.h"

namespace udcp {

/// global: the modified step of a mesh W that a linear system (or the paper's iteration over the whole mesh) finds; lambda shapes
/// the result. local: one step of the mesh itself, then each vertex is put where its own limit is right; the limit of the paper's
/// iteration at one vertex, whatever lambda. plain: two steps, then the same.
enum class PointStep { global, local, plain };

struct PointOptions {
  PointStep step = PointStep::global;
  Rational lambda = Rational(7) / Rational(10);
  std::vector<char> skipped;  // per vertex, 1: its position is not prescribed; empty: all are. Left to the rule (3) or W = V
  RunControl control;
};

/// The vertex rule (3) as a word: U C P where f = 1/3, omega = 0, delta = (64 lambda - 25)/39. On quads the new vertex is
/// lambda v + (1 - lambda) (10/13 E + 3/13 F) with the means E, F of e_j, f_j; on the boundary the curve rule of the same word.
/// Its edge and face points are not used.
Word modified_vertex_rule(const Rational& lambda);
Word modified_vertex_rule_of(KernelPtr delta);  // the same for any delta

/// One Catmull-Clark step with the vertices of modified_vertex_rule.
template <class S>
Surface<S> modified_step(const Surface<S>& cage, const Rational& lambda, const RunControl& control = {});

/// Catmull-Clark limits of the vertices 0 .. count - 1, around which all faces must be quads: (1); on the boundary those of its
/// curve; corners stay.
template <class S>
Points<S> limit_points(const Surface<S>& fine, int count);

/// `fine` with the vertices 0 .. (rows of targets) - 1 moved so that their limits are the targets: (4). No two of them may have
/// points of their fans in common; skipped as in PointOptions.
template <class S>
Surface<S> put_limits(Surface<S> fine, const Points<S>& targets, const std::vector<char>& skipped = {});

/// The control mesh after one step of `cage` (two steps for plain); its first vertices are those of the cage. Exact in exact
/// types, where global solves a linear system of limited size. Closed or open, quads or not: the system stays symmetric and its
/// eigenvalues positive, as faces enter by their means. Throws Error{input}: "E_LAMBDA" for lambda outside (7/20, 1] in global,
/// "E_VALENCE2" naming a vertex inside with two edges, "E_NOT_FINITE" naming a vertex; what run and solve throw.
template <class S>
Surface<S> interpolate_points(const Surface<S>& cage, const PointOptions& options = {});

/// The paper's progressive iteration. local: v1 += v0 - limit(v1) on the modified step, the differences shrinking by 5/(n + 5).
/// global: W += V - limits(modified step of W).
template <class S>
struct Progress {
  Surface<S> control;               // after the last iteration, one step fine
  std::vector<double> differences;  // per iteration the largest |V - limit| before it, approximately
  double contraction = 0;           // the last ratio of two of them
};
/// `iterations` times, or until the largest difference is at most `tolerance` times the size of the mesh. Throws as
/// interpolate_points, but takes any lambda: outside (7/20, 1] global may diverge, which `differences` shows.
template <class S>
Progress<S> progress_points(const Surface<S>& cage, const PointOptions& options, int iterations, double tolerance = 0);

/// Why lambda is refused, naming the theorem: Error{input, "E_LAMBDA"} unless 7/20 < lambda <= 1.
void check_lambda(const Rational& lambda);
/// Error{input} for a vertex inside with two edges (E_VALENCE2), points that are not finite (E_NOT_FINITE), or what validate
/// says.
template <class S>
void check_cage(const Surface<S>& cage);

}  // namespace udcp
