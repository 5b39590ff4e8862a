// What one round of animate or sweep leaves for the next: the plan of a word on a mesh whose points move. Knows no language.
#pragma once

#include <optional>
#include <vector>

#include "operators/plan/plan.h"

namespace udcp {

/// Results are those of run() up to rounding, in its numbering and on one shared mesh. The first surface goes the general path
/// and is remembered; for the second one on the same connectivity a plan is made, and kept if it makes of the first one what
/// run() made.
class KeptPlan {
 public:
  /// None where the word, the connectivity or the number of rounds are not those remembered, and where no plan applies: small
  /// results, attributes, meshes in the plane. Throws what compile and execute throw.
  std::optional<Surface<double>> refine(const Word& word, const Surface<double>& surface, int rounds, const RunControl& control,
                                        int threads = 1);
  /// `result` is what run() made of the surface.
  void remember(const Word& word, const Surface<double>& surface, int rounds, const Surface<double>& result);

 private:
  [[nodiscard]] bool fits(const Word& word, const Surface<double>& surface, int rounds) const;
  bool make_plan(const PlanControl& control);
  [[nodiscard]] Points<double> frame_points() const;

  Word word_;
  int rounds_ = 0;
  bool is_hopeless_ = false;
  std::shared_ptr<const Mesh> base_, result_;
  Tags base_tags_, result_tags_;
  Points<double> base_points_, result_points_;  // until there is a plan
  std::optional<Plan<double>> plan_;
  FlatMesh<double> frame_;
  std::vector<int> counterpart_;  // per vertex of result_ its number in frame_
};

}  // namespace udcp
