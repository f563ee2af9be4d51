#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <vector>

namespace depixel::test {

/// Measures how long frames take, from one call of retro_run() to the next: all that the front end does with
/// a frame.
class FrameTimes {
 public:
  static constexpr std::size_t kWarmUpFrames = 60;

  struct Summary {
    std::size_t frames = 0;
    double median_ms = 0, mean_ms = 0;
  };

  FrameTimes() { starts_.reserve(std::size_t{1} << 16); }

  void frame_starts() { starts_.push_back(Clock::now()); }

  /// Of the frames after the warm-up.
  Summary summary() const {
    std::vector<double> times_ms;
    double sum_ms = 0;
    for (std::size_t i = kWarmUpFrames; i + 1 < starts_.size(); ++i) {
      times_ms.push_back(std::chrono::duration<double, std::milli>(starts_[i + 1] - starts_[i]).count());
      sum_ms += times_ms.back();
    }
    if (times_ms.empty()) return {};
    const auto middle = times_ms.begin() + static_cast<std::ptrdiff_t>(times_ms.size() / 2);
    std::nth_element(times_ms.begin(), middle, times_ms.end());
    return {times_ms.size(), *middle, sum_ms / static_cast<double>(times_ms.size())};
  }

 private:
  using Clock = std::chrono::steady_clock;
  std::vector<Clock::time_point> starts_;
};

}  // namespace depixel::test
