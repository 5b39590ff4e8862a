// run: a word on a shape. Holds the execution state (dual or primal, number of D, alpha, reference of
// P).
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>

#include "operators/polyline.h"
#include "operators/surface.h"
#include "operators/word.h"

namespace udcp {

struct RunControl {
  int first_item = 0;                             // so many items count as applied before (alpha, h): the start of a round
  std::int64_t max_faces = 50'000'000;            // faces of the result (points, for curves); checked before any work
  std::int64_t max_bytes = 0;                     // estimated memory of the result; 0: no limit
  const std::atomic<bool>* stop = nullptr;        // set: Error{interrupted} at the next atom
  std::function<void(double fraction)> progress;  // called after each atom with the share of faces made so far
};

/// Applies the head and `rounds` tails (the tails only if first_item > 0); for a finite operator, the operator `rounds` times.
/// Throws what validate throws, Error{limit, "E_MAX_FACES"} or "E_MAX_MEMORY" before allocating, and the geometry errors of the
/// atoms.
template <class S>
Polyline<S> run(const Word& word, Polyline<S> curve, int rounds, const RunControl& control = {});
template <class S>
Surface<S> run(const Word& word, Surface<S> surface, int rounds, const RunControl& control = {});

}  // namespace udcp
