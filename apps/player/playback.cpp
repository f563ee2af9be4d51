#include "apps/player/playback.hpp"

#include <algorithm>

namespace depixel {

void Playback::set_speed(double speed) {
  speed_ = std::clamp(speed, kMinSpeed, kMaxSpeed);
}

void Playback::play(const Extent& extent) {
  if (!loops_ && extent.count && index_ + 1 >= *extent.count) index_ = extent.first;
  shown_ = 0;
  playing_ = true;
}

void Playback::seek(int index, const Extent& extent) {
  playing_ = false;
  shown_ = 0;
  index_ = std::clamp(index, extent.first, std::max(extent.first, extent.arrived - 1));
}

void Playback::step(int by, const Extent& extent) {
  int index = index_ + by;
  if (loops_ && extent.count && *extent.count > extent.first) {
    const int frames = *extent.count - extent.first;
    index = extent.first + ((index - extent.first) % frames + frames) % frames;
  }
  seek(index, extent);
}

void Playback::advance(double seconds, const Extent& extent, const std::function<double(int)>& seconds_of) {
  if (!playing_ || extent.arrived <= extent.first) return;
  index_ = std::clamp(index_, extent.first, extent.arrived - 1);
  // After a long pause, as when the window was moved, frames are not made up for.
  constexpr double kLongest = 0.25;
  shown_ += std::min(seconds, kLongest) * speed_;
  for (double wanted = seconds_of(index_); shown_ >= wanted; wanted = seconds_of(index_)) {
    const bool is_last = extent.count && index_ + 1 >= *extent.count;
    if (is_last && !loops_) {
      playing_ = false;
      return;
    }
    if (!is_last && index_ + 1 >= extent.arrived) {  // the next one has not come yet
      shown_ = wanted;
      return;
    }
    shown_ -= wanted;
    index_ = is_last ? extent.first : index_ + 1;
    if (wanted <= 0) return;
  }
}

std::optional<double> Playback::seconds_left(const Extent& extent,
                                             const std::function<double(int)>& seconds_of) const {
  const bool is_only_one = extent.count && *extent.count <= extent.first + 1;
  if (!playing_ || is_only_one || extent.arrived <= extent.first) return std::nullopt;
  const int index = std::clamp(index_, extent.first, extent.arrived - 1);
  return std::max(0.0, (seconds_of(index) - shown_) / speed_);
}

}  // namespace depixel
