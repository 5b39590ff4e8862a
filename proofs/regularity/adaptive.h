// Whether a Catmull-Clark surface is regular (S_u and S_v independent): the tests T1 to T4 on nets of difference vectors and the
// adaptive decision over a list of patches. "On Regularity of Catmull-Clark Subdivision Surfaces", Theorem 3 in the corrected
// form: neither U, nor V, nor U with V, nor U with -V may have 0 among the convex combinations. The search; its checker is
// check_regularity.cpp.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "proofs/regularity/cone_tests.h"
#include "proofs/verdict.h"

namespace udcp {

/// A witness that the net is regular, if the test finds one: it fails only if there is none.
std::optional<RegularityWitness> find_witness(const BicubicNet& net, RegularityTest test, bool planar);

/// n and m that separate non-zero vectors, conditions (1) to (4) of Theorem 3; nothing if they do not hold.
std::optional<RegularityWitness> separating_pair(const ConeVectors& cones);

/// A net that passed: patch number, path of child digits, witness.
struct RegularLeaf {
  int patch = 0;
  std::string path;
  RegularityWitness witness;
};
/// A point where S_u x S_v vanishes, or two points of one group where its sign differs. u and v in the frame of the patch.
struct SingularPoint {
  int patch = 0;
  Rational u, v;
};
struct AdaptiveResult {
  enum class Status { regular, zero, sign, undecided } status = Status::undecided;
  int depth = 0;                               // the level at which it ended
  std::vector<std::pair<int, int>> per_level;  // tested and passed, per completed level
  std::vector<RegularLeaf> leaves;             // complete if regular
  std::vector<SingularPoint> witness;          // one for `zero`, two for `sign`
  std::vector<int> open;                       // patches not decided
  bool out_of_budget = false;                  // SearchLimits, not the depth, ended it
};
struct AdaptiveOptions {
  RegularityTest test = RegularityTest::t2;
  int depth = 6;
  bool planar = false;
  SearchLimits limits{};                         // nodes: nets looked at
  std::function<void(double share)> progress{};  // of the levels up to `depth`, every few hundred nets
};
/// Breadth first over the patches; `groups` has a number per patch (signs are compared inside a group).
AdaptiveResult decide_patches(const std::vector<BicubicNet>& nets, const std::vector<int>& groups,
                              const AdaptiveOptions& options);

}  // namespace udcp
