#include "apps/player/frame_history.hpp"

#include <algorithm>
#include <numeric>

namespace depixel {
namespace {

constexpr std::size_t kKept = 100'000;        ///< frames that the median is of: half an hour
constexpr std::size_t kRecentIntervals = 60;  ///< frames that the rate is of

template <typename Value>
void push(std::vector<Value>& values, Value value, std::size_t most) {
  if (values.size() == most) values.erase(values.begin());
  values.push_back(value);
}

}  // namespace

void FrameHistory::add(double work_ms, double interval_ms) {
  push(plot_, static_cast<float>(work_ms), kLength);
  if (all_work_ms_.size() < kKept) all_work_ms_.push_back(work_ms);
  push(recent_intervals_, interval_ms, kRecentIntervals);
}

double FrameHistory::frames_a_second() const {
  const double sum = std::accumulate(recent_intervals_.begin(), recent_intervals_.end(), 0.0);
  return sum > 0 ? 1000 * double(recent_intervals_.size()) / sum : 0;
}

double FrameHistory::median(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace depixel
