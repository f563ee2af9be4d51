#pragma once

#include "bench/sequences/sequence.hpp"

namespace depixel::bench {

/// How many times as fast several threads are as one, from scratch at kTimingScale; medians over frames.
struct ThreadTiming {
  int threads = 1;
  double draw_speed_up = 1;
  double both_speed_up = 1;  ///< vectorizing and drawing
};

/// Vectorizes and draws the frames of a sequence from scratch with one and with several threads, in turns.
ThreadTiming time_threads(const Sequence& sequence, int threads, int playbacks);

}  // namespace depixel::bench
