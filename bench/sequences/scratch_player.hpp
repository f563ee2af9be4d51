#pragma once

#include "bench/frames/frame_timing.hpp"
#include "libdepixel/pipeline/vectorizer.hpp"
#include "libdepixel/raster/cpu_raster.hpp"

namespace depixel::bench {

/// Vectorizes and draws each frame as if there had been none before it, at kTimingScale; warm after the
/// first.
class ScratchPlayer {
 public:
  ScratchPlayer(int width, int height, int threads) : out_(width * kTimingScale, height * kTimingScale) {
    options_.threads = threads;
  }

  void vectorize(const FrameView& frame) { vectorizer_.vectorize_by_edge(frame, options_); }
  /// Draws all of the frame vectorized last.
  void draw() {
    const View view = View::fit(vectorizer_.cells().lattice, out_.width(), out_.height());
    raster_.draw(vectorizer_.by_edge(), view, options_.linear_light, options_.threads, out_.target());
  }

 private:
  Options options_;
  Vectorizer vectorizer_;
  CpuRaster raster_;
  Picture out_;
};

}  // namespace depixel::bench
