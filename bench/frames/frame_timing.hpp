#pragma once

#include <array>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "bench/common/picture.hpp"
#include "libdepixel/pipeline/vectorizer.hpp"

namespace depixel::bench {

/// Everything is drawn at this scale: xbr's largest.
constexpr int kTimingScale = 4;

struct NamedPicture {
  std::string name;
  Picture picture;
};

/// What a frame takes on one core; medians, in milliseconds.
struct FrameTiming {
  std::string name;
  double vectorize_ms = 0;
  double raster_ms = 0;  ///< at kTimingScale
  double xbr4_ms = 0;    ///< libavfilter's xbr=n=4
  std::array<double, VectorizeStats::kStages> stage_ms{};

  /// From frame to pixels, which takes all stages but the last: the list of segments is for other readers.
  double both_ms() const { return vectorize_ms - stage_ms.back() + raster_ms; }
  double vectorize_ratio() const { return vectorize_ms / xbr4_ms; }
  double both_ratio() const { return both_ms() / xbr4_ms; }
};

/// Times vectorizing, the raster and xbr on frames, warm. All run in turns, frame by frame, so that whatever
/// else the machine does hits all of them alike. \param seconds  how long each frame is repeated for, at
/// least.
std::vector<FrameTiming> time_frames(std::span<const NamedPicture> frames, double seconds);

/// What some options take on a frame, as ratios to the defaults' time to vectorize and draw; all in turns.
std::vector<double> time_options(const Picture& frame, std::span<const Options> options, double seconds);

/// Vectorizing time in nanoseconds a pixel for one square picture: as a whole, and cut in small squares.
struct SizeTiming {
  double whole_ns = 0, cropped_ns = 0;
  double ratio() const { return whole_ns / cropped_ns; }
};

/// \param crop_size  side of the squares; divides the picture's.
SizeTiming time_sizes(const Picture& picture, int crop_size, double seconds);

}  // namespace depixel::bench
