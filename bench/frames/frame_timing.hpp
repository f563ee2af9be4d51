#pragma once

#include <array>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "bench/common/median.hpp"
#include "bench/common/picture.hpp"
#include "libdepixel/pipeline/vectorizer.hpp"

namespace depixel::bench {

/// Everything is drawn at this scale: xbr's largest.
constexpr int kTimingScale = 4;

struct NamedPicture {
  std::string name;
  Picture picture;
};

/// What a frame takes on one core, in milliseconds: a sample a round.
struct FrameTiming {
  std::string name;
  std::vector<double> vectorize;
  std::vector<double> raster;  ///< at kTimingScale
  /// From frame to pixels, which takes all stages but the last: the list of segments is for other readers.
  std::vector<double> both;
  std::vector<double> xbr4;  ///< libavfilter's xbr=n=4
  std::array<std::vector<double>, VectorizeStats::kStages> stages;

  double vectorize_ratio() const { return median_ratio(vectorize, xbr4); }
  double both_ratio() const { return median_ratio(both, xbr4); }
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
  double ratio = 0;  ///< of whole to cropped
};

/// \param crop_size  side of the squares; divides the picture's.
SizeTiming time_sizes(const Picture& picture, int crop_size, double seconds);

}  // namespace depixel::bench
