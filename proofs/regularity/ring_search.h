// The search for a proof that a Catmull-Clark surface is regular around one vertex: the level at which its rings close, and
// witnesses for the rings up to there. What is proved then is said in ring_certificate.h.
#pragma once

#include "proofs/regularity/adaptive.h"
#include "proofs/regularity/ring_certificate.h"

namespace udcp {

/// regular: the rings close at `level`, and all up to it are regular. zero, sign: the last ring is not, with its witness.
/// undecided: with the reason.
struct RingResult {
  AdaptiveResult::Status status = AdaptiveResult::Status::undecided;
  int level = 0;
  std::vector<AdaptiveResult> rings;  // of ring 1, 2, ..; patches in the order of ring_net
  std::string reason;
};
/// Ring by ring, at most largest_ring_level of them; the options hold for each ring.
RingResult decide_rings(VertexRings& rings, const AdaptiveOptions& options);

}  // namespace udcp
