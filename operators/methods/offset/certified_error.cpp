// Branch and bound over patches: those whose bound is above the target are split by a Loop step of their control points.
#include <algorithm>
#include <cmath>
#include <map>
#include <queue>
#include <string>

#include "operators/interrupt.h"
#include "operators/methods/offset/offset_error.h"
#include "operators/methods/offset/patch_bounds.h"

namespace udcp {
namespace {

constexpr int most_patches = 1'000'000;

using Vector = Eigen::RowVector3d;

/// Control points of S and of delta, side by side, with the bounds over the patch.
struct Piece {
  Points<double> net;
  double bound = 0;
  int depth = 0;
};
bool operator<(const Piece& a, const Piece& b) { return a.bound < b.bound; }

class Search {
 public:
  Search(double distance, bool full, int deepest, const RunControl& control)
      : distance_(distance), full_(full), deepest_(deepest), control_(control) {}

  CertifiedError run(std::vector<Piece> pieces, double sampled) {
    result_.lower = sampled;
    for (Piece& piece : pieces) push(std::move(piece));
    double settled = 0;  // the largest bound of pieces that may not be split further
    while (!queue_.empty()) {
      if (queue_.top().bound <= 1.1 * result_.lower) {
        settled = std::max(settled, queue_.top().bound);
        break;
      }
      Piece piece = queue_.top();
      queue_.pop();
      if (piece.depth >= deepest_) {
        settled = std::max(settled, piece.bound);
        continue;
      }
      split(piece);
    }
    result_.upper = std::max(settled, result_.lower);
    return result_;
  }

 private:
  const CornerAnalysis<double>& corner(int valence) {
    const auto found = corners_.find(valence);
    return found != corners_.end() ? found->second : corners_.emplace(valence, CornerAnalysis<double>(valence)).first->second;
  }
  const PatchStep<double>& step(int valence) {
    const auto found = steps_.find(valence);
    return found != steps_.end() ? found->second : steps_.emplace(valence, patch_step<double>(valence)).first->second;
  }

  double bound(const Points<double>& net) {
    const Points<double> s = net.leftCols(3), d = net.rightCols(3);
    const bool regular = net.rows() == 12;
    if (!full_) return length_error(regular ? length_by_bernstein(d) : length_by_hull(d), distance_);
    if (regular) return regular_error(s, d, distance_).value_or(HUGE_VAL);
    const std::optional<NormalCone<double>> cone = corner(static_cast<int>(net.rows()) - 6).cone(s);
    return cone ? error_in_cone(*cone, d, distance_) : HUGE_VAL;
  }

  /// The measure at the middle of a regular patch.
  void sample(const Points<double>& net) {
    const Points<double> values = evaluate_regular(net, 1.0 / 3, 1.0 / 3);
    const Vector delta = values.row(0).tail(3);
    double error = std::abs(delta.norm() - std::abs(distance_));
    if (full_) {
      const Vector a = values.row(1).head(3), b = values.row(2).head(3);
      const Vector n(a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]);
      if (n.norm() > 0) error = (delta - distance_ * n.normalized()).norm();
    }
    result_.lower = std::max(result_.lower, error);
  }

  void push(Piece piece) {
    throw_if_stopped(control_.stop);
    if (++result_.patches > most_patches)
      throw Error(ErrorKind::limit, "E_MAX_PATCHES",
                  "the error is bounded on " + std::to_string(most_patches) + " patches without an end", "refine the mesh first");
    piece.bound = bound(piece.net);
    result_.depth = std::max(result_.depth, piece.depth);
    if (piece.net.rows() == 12) sample(piece.net);
    queue_.push(std::move(piece));
  }

  void split(const Piece& piece) {
    const PatchStep<double>& matrices = step(static_cast<int>(piece.net.rows()) - 6);
    push({matrices.inner * piece.net, 0, piece.depth + 1});
    for (const Points<double>& child : matrices.regular) push({child * piece.net, 0, piece.depth + 1});
  }

  double distance_;
  bool full_;
  int deepest_;
  const RunControl& control_;
  std::map<int, CornerAnalysis<double>> corners_;
  std::map<int, PatchStep<double>> steps_;
  std::priority_queue<Piece> queue_;
  CertifiedError result_;
};

}  // namespace

CertifiedErrors certified_offset_errors(const Surface<double>& surface, const Points<double>& d, double distance, int deepest,
                                        const RunControl& control) {
  Surface<double> both{surface.mesh, Points<double>(d.rows(), 6), surface.tags, {}};
  both.points << surface.points, d;
  both = separated(both, control);
  std::vector<Piece> pieces;
  for (int f = 0; f < both.mesh->faces(); ++f) {
    const std::optional<LoopPatch> patch = loop_patch(*both.mesh, both.tags, f);
    if (!patch)
      throw Error(ErrorKind::input, "E_NEEDS_REFINEMENT",
                  "face " + std::to_string(f) + " has an irregular vertex on the boundary, where errors have no certified bound",
                  "the hull bound holds there too");
    pieces.push_back({patch_net(*patch, both.points), 0, 0});
  }
  const OffsetErrors sampled = offset_errors(sample_offset(surface, d, 3, control), distance);
  return {Search(distance, false, deepest, control).run(pieces, sampled.eps),
          Search(distance, true, deepest, control).run(pieces, sampled.full)};
}

}  // namespace udcp
