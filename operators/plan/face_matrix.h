// The matrix of every kind of face: the points of its block after some rounds, from the points of its neighbourhood.
//
// One round is run() on the sheet of all kinds with unit vectors as points. The faces that it makes have kinds again, a round
// later; so the kinds of all rounds are found going forward, and going backward a matrix is put together from those of the
// children, each times one round. Nothing is computed but one round per kind and level, and nothing is defined but the atoms.
#pragma once

#include <atomic>

#include "operators/number.h"
#include "operators/plan/face_kinds.h"
#include "operators/plan/rounds_ahead.h"

namespace udcp {

/// What a matrix makes of a neighbourhood: the points after the rounds or their limits, and two tangents below them or not.
struct BlockContent {
  bool limit_points = false;
  bool tangents = false;
};

/// Per kind a matrix: a column per vertex of the neighbourhood, a row per point in the order of Block<N>; with tangents the same
/// number of rows twice more. Throws what run() and limit_stencil throw, E_INTERRUPTED.
template <int N>
std::vector<Points<double>> face_matrices(const FaceKinds<N>& kinds, const RoundsAhead& ahead, BlockContent content,
                                          const std::atomic<bool>* stop);

}  // namespace udcp
