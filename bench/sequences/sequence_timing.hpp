#pragma once

#include <span>
#include <string>
#include <vector>

#include "bench/peers/softfilter.hpp"
#include "bench/sequences/samples.hpp"
#include "bench/sequences/sequence.hpp"

namespace depixel::bench {

/// What a softfilter takes, and the size of what it makes: the frame's where it passes frames of this size on
/// unchanged.
struct SoftFilterTiming {
  std::string name;
  int out_width = 0, out_height = 0;
  Samples samples;
};

/// What the frames of a sequence take on one core. Ours and libavfilter's are at kTimingScale.
struct SequenceTiming {
  std::string name;
  Samples incremental;  ///< submitted and drawn by a filter that saw the frames before
  Samples scratch;      ///< vectorized and drawn as if there had been none before
  Samples xbr4, hqx4;
  Samples compare;              ///< memcmp() with the frame before
  std::vector<bool> is_repeat;  ///< of each frame but the first: it is, pixel by pixel, the one before
  std::vector<SoftFilterTiming> softfilters;  ///< each at its own scale
  double bytes_per_pixel = 0;  ///< most that the filter held from frame to frame, to a source pixel
};

/// Plays a sequence several times, each time with a new filter for the incremental path. All take turns, a
/// few frames each, so that whatever else the machine does hits all of them alike, and that each has the
/// caches to itself for most frames, as a filter in an emulator has. Which frames come first in a turn, when
/// caches hold the least of them and of the code, differs from playback to playback.
///
/// \param softfilters  to be timed too; one that refuses the sequence's size is left out, with a line on
///                     standard error.
SequenceTiming time_sequence(const Sequence& sequence, std::span<const SoftFilterLibrary> softfilters,
                             int playbacks);

}  // namespace depixel::bench
