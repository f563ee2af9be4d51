#pragma once

#include <functional>
#include <optional>

namespace depixel {

/// Which frame of a clip is shown, by the time that passes and by what a viewer asks for. Has no clock of its
/// own.
class Playback {
 public:
  static constexpr double kMinSpeed = 0.1, kMaxSpeed = 8;

  /// The frames that there are: from `first` on, up to `arrived`; `count` is known once no more can come.
  struct Extent {
    int first = 0;
    int arrived = 0;  ///< one past the last frame that can be shown now
    std::optional<int> count;
  };

  bool is_playing() const { return playing_; }
  bool loops() const { return loops_; }
  double speed() const { return speed_; }
  int index() const { return index_; }

  void set_loop(bool loops) { loops_ = loops; }
  void set_speed(double speed);
  /// At the last frame of a clip that does not loop, playing starts again from the first.
  void play(const Extent& extent);
  void pause() { playing_ = false; }
  void toggle(const Extent& extent) { playing_ ? pause() : play(extent); }

  /// Stops and shows another frame, as near as there is one.
  void seek(int index, const Extent& extent);
  /// Stops and goes so many frames on, or back; round the ends of a clip that loops.
  void step(int by, const Extent& extent);
  /// Lets time pass. \param seconds_of  how long a frame is shown at speed 1.
  void advance(double seconds, const Extent& extent, const std::function<double(int)>& seconds_of);
  /// Time until another frame is due; none while paused, or where there is no other.
  std::optional<double> seconds_left(const Extent& extent,
                                     const std::function<double(int)>& seconds_of) const;

 private:
  bool playing_ = true, loops_ = true;
  double speed_ = 1;
  int index_ = 0;
  double shown_ = 0;  ///< seconds that the frame has been shown, at speed 1
};

}  // namespace depixel
