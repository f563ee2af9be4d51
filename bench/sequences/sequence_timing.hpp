#pragma once

#include <span>
#include <string>
#include <vector>

#include "bench/peers/softfilter.hpp"
#include "bench/sequences/sequence.hpp"

namespace depixel::bench {

/// What a softfilter takes, and the size of what it makes: the frame's where it passes frames of this size on
/// unchanged.
struct SoftFilterTiming {
  std::string name;
  int out_width = 0, out_height = 0;
  std::vector<double> ms;
};

/// What the frames of a sequence take on one core, in milliseconds: the median over playbacks of each frame
/// but the first. Ours and libavfilter's are at kTimingScale.
struct SequenceTiming {
  std::string name;
  std::vector<double> incremental_ms;  ///< submitted and drawn by a filter that saw the frames before
  std::vector<double> scratch_ms;      ///< vectorized and drawn as if there had been none before
  std::vector<double> xbr4_ms, hqx4_ms;
  std::vector<double> compare_ms;             ///< memcmp() with the frame before
  std::vector<bool> is_repeat;                ///< the same, pixel by pixel, as the frame before
  std::vector<SoftFilterTiming> softfilters;  ///< each at its own scale
  double bytes_per_pixel = 0;  ///< most that the incremental vectorizer held, to a source pixel
};

/// Plays a sequence several times, each time with a new filter for the incremental path. On each frame all
/// run in turns, so that whatever else the machine does hits all of them alike. The incremental path comes
/// first, when caches hold the least of the frame and of our code, which costs it a few per cent.
///
/// \param softfilters  to be timed too; one that refuses the sequence's size is left out, with a line on
///                     standard error.
SequenceTiming time_sequence(const Sequence& sequence, std::span<const SoftFilterLibrary> softfilters,
                             int playbacks);

}  // namespace depixel::bench
