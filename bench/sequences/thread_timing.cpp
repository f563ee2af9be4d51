#include "bench/sequences/thread_timing.hpp"

#include "bench/sequences/samples.hpp"
#include "bench/sequences/scratch_player.hpp"

namespace depixel::bench {
namespace {

/// A number of threads, and its times.
struct Contestant {
  Contestant(const Sequence& sequence, int threads)
      : player(sequence.width(), sequence.height(), threads),
        draw(sequence.frames.size()),
        both(sequence.frames.size()) {}

  void time(std::size_t frame, const FrameView& view) {
    both.time(frame, [&] {
      player.vectorize(view);
      draw.time(frame, [&] { player.draw(); });
    });
  }

  ScratchPlayer player;
  Samples draw, both;
};

}  // namespace

ThreadTiming time_threads(const Sequence& sequence, int threads, int playbacks) {
  Contestant one(sequence, 1), several(sequence, threads);
  for (int i = 0; i < playbacks; ++i) {
    for (std::size_t frame = 0; frame < sequence.frames.size(); ++frame) {
      const FrameView view = sequence.frames[frame].view();
      one.time(frame, view);
      several.time(frame, view);
    }
  }
  return {threads, median(ratios(one.draw, several.draw)), median(ratios(one.both, several.both))};
}

}  // namespace depixel::bench
