// The G2 fill of one valence as a matrix: from the two rings around a vertex to the Bezier points of patch 0. Solved frequency by
// frequency in double; made once per valence.
#pragma once

#include <map>
#include <mutex>
#include <vector>

#include "operators/methods/filling/fill_system.h"

namespace udcp {

inline constexpr int largest_fill_valence = 100;

struct FillMask {
  int valence = 0;
  /// 64 x (6 n + 1). Patch i: the ring turned by i sectors. Rows sum to 1.
  Points<double> weights;
  std::vector<int> ranks;  // at the frequencies 0 .. floor(n/2)
  int freedom = 0;         // degrees of freedom that the fairness decides
  /// Of the singular values, relative to the largest one of their frequency: the smallest that counts and the largest that does
  /// not.
  double least_kept = 1, most_dropped = 0;
};

/// Throws Error{input, "E_FILL_VALENCE"} below 3, Error{limit, "E_FILL_VALENCE"} above largest_fill_valence, and Error{internal,
/// "E_INTERNAL"} if a rank is not that of fill_rank or the equations come out inconsistent.
FillMask make_fill_mask(int valence);

/// Masks that were made, for use from several threads.
class FillMasks {
 public:
  const FillMask& of(int valence);

 private:
  std::mutex mutex_;
  std::map<int, FillMask> masks_;
};

/// All n patches from the two rings (a row per point, in the numbers of ring_number): 64 n rows, patch by patch.
Points<double> apply(const FillMask& mask, const Points<double>& ring);

}  // namespace udcp
