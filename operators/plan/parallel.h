// Work in equal pieces on a few threads. Knows nothing of what the pieces are.
//
// std::thread, as every piece is independent, all take about the same time, and there are a few hundred of them at most: a pool
// or OpenMP would add a dependency and save nothing that can be measured. Threads that are done with
// their share help the others, so a busy machine does not make them wait for one another.
#pragma once

#include <cstdint>
#include <functional>

namespace udcp {

struct RunControl;

/// Calls work(piece) for pieces 0 .. pieces - 1 on `threads` threads, the caller among them; control.progress from the caller
/// only. Throws Error{interrupted} soon after control.stop is set, and the first exception of `work`.
void for_each_piece(std::int64_t pieces, int threads, const RunControl& control, const std::function<void(std::int64_t)>& work);

}  // namespace udcp
