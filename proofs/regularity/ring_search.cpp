// The search around one vertex: one ring more until the rings close.
#include "proofs/regularity/ring_search.h"

namespace udcp {

RingResult decide_rings(VertexRings& rings, const AdaptiveOptions& options) {
  RingResult result;
  if (!rings.has_normal()) {
    result.reason = "the tangent plane at the vertex may be degenerate";
    return result;
  }
  const std::vector<int> groups(static_cast<std::size_t>(3 * rings.valence()), 0);
  while (!rings.closes_at(result.level)) {
    if (result.level == largest_ring_level) {
      result.reason = "the rings do not close within " + std::to_string(largest_ring_level) + " levels";
      return result;
    }
    ++result.level;
    const AdaptiveResult& ring = result.rings.emplace_back(decide_patches(rings.nets(result.level), groups, options));
    if (ring.status == AdaptiveResult::Status::regular) continue;
    result.status = ring.status;
    if (ring.status == AdaptiveResult::Status::undecided)
      result.reason = "ring " + std::to_string(result.level) + " is undecided";
    return result;
  }
  result.status = AdaptiveResult::Status::regular;
  return result;
}

}  // namespace udcp
