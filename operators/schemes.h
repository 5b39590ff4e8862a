// Classical schemes as words, for the methods and theorems that speak of one scheme.
#pragma once

#include "operators/word.h"

namespace udcp::schemes {

/// Catmull and Clark (1978): (U C[ngon = classic] P)* where omega = 0, delta(N) = (N-4)/N.
const Word& catmull_clark();
/// Loop (1987): (UCP)* on triangles where omega = 0, delta(N) = 1 - 8/3 (5/8 - (3/8 + cos(2 pi/N)/4)^2).
const Word& loop();

}  // namespace udcp::schemes
