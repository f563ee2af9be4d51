#pragma once

#include <algorithm>
#include <vector>

#include "bench/common/median.hpp"

namespace depixel::bench {

/// The times that one contestant took for the frames of a sequence, over several playbacks.
class Samples {
 public:
  explicit Samples(std::size_t frames) : ms_(frames) {}

  /// Calls work() and notes the milliseconds that it takes.
  template <typename Work>
  void time(std::size_t frame, Work&& work) {
    ms_[frame].push_back(time_ms(work));
  }

  /// The median of the playbacks of each frame but the first, which warms up.
  std::vector<double> medians() const {
    std::vector<double> result;
    for (std::size_t frame = 1; frame < ms_.size(); ++frame) result.push_back(median(ms_[frame]));
    return result;
  }

  /// One contestant's times divided by another's in the same playback: of each frame but the first, the
  /// median of the playbacks.
  friend std::vector<double> ratios(const Samples& of, const Samples& to) {
    std::vector<double> result;
    for (std::size_t frame = 1; frame < of.ms_.size(); ++frame) {
      result.push_back(median_ratio(of.ms_[frame], to.ms_[frame]));
    }
    return result;
  }

 private:
  std::vector<std::vector<double>> ms_;  ///< by frame, then by playback
};

/// The largest of some values. At least one value.
inline double worst(const std::vector<double>& values) {
  return *std::max_element(values.begin(), values.end());
}

/// The smallest value that at least 99 of 100 do not exceed. At least one value.
inline double percentile_99(std::vector<double> values) {
  const std::size_t rank = (99 * values.size() + 99) / 100;
  const auto nth = values.begin() + static_cast<std::ptrdiff_t>(rank) - 1;
  std::nth_element(values.begin(), nth, values.end());
  return *nth;
}

}  // namespace depixel::bench
