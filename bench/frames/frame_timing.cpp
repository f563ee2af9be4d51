#include "bench/frames/frame_timing.hpp"

#include <deque>

#include "bench/common/median.hpp"
#include "bench/peers/libav_scaler.hpp"
#include "libdepixel/raster/cpu_raster.hpp"

namespace depixel::bench {
namespace {

constexpr int kMinRounds = 9;
constexpr int kWarmUpRounds = 2;
const Options kOptions;  // the defaults, one thread

/// All that is timed on one frame, and the samples.
class FrameTimer {
 public:
  explicit FrameTimer(const NamedPicture& frame, const Options& options = {})
      : name_(frame.name),
        options_(options),
        view_(frame.picture.view()),
        out_(view_.width * kTimingScale, view_.height * kTimingScale),
        xbr_("xbr", kTimingScale, view_.width, view_.height) {
    xbr_.load(view_);
    for (int i = 0; i < kWarmUpRounds; ++i) round();
    vectorize_.clear();
    draw_.clear();
    scale_.clear();
    for (auto& samples : stages_) samples.clear();
  }

  void round() {
    vectorize_.push_back(time_ms([&] { vectorizer_.vectorize(view_, options_); }));
    const MapByEdge map = vectorizer_.by_edge();
    const View view = View::fit(map.edges.lattice, out_.width(), out_.height());
    draw_.push_back(
        time_ms([&] { raster_.draw(map, view, options_.linear_light, options_.threads, out_.target()); }));
    scale_.push_back(time_ms([&] { xbr_.run(); }));
    for (std::size_t i = 0; i < stages_.size(); ++i) {
      stages_[i].push_back(1e-6 * double(vectorizer_.stats().stage_ns[i]));
    }
  }

  FrameTiming result() const {
    FrameTiming timing{name_, median(vectorize_), median(draw_), median(scale_), {}};
    for (std::size_t i = 0; i < stages_.size(); ++i) timing.stage_ms[i] = median(stages_[i]);
    return timing;
  }

 private:
  std::string name_;
  Options options_;
  FrameView view_;
  Vectorizer vectorizer_;
  CpuRaster raster_;
  Picture out_;
  LibavScaler xbr_;
  std::vector<double> vectorize_, draw_, scale_;
  std::array<std::vector<double>, VectorizeStats::kStages> stages_;
};

}  // namespace

std::vector<FrameTiming> time_frames(std::span<const NamedPicture> frames, double seconds) {
  std::deque<FrameTimer> timers;
  for (const NamedPicture& frame : frames) timers.emplace_back(frame);
  repeat_for(seconds * double(frames.size()), kMinRounds, [&] {
    for (FrameTimer& timer : timers) timer.round();
  });
  std::vector<FrameTiming> timings;
  timings.reserve(timers.size());
  for (const FrameTimer& timer : timers) timings.push_back(timer.result());
  return timings;
}

std::vector<double> time_options(const Picture& frame, std::span<const Options> options, double seconds) {
  std::deque<FrameTimer> timers;
  const NamedPicture named{"", frame};
  timers.emplace_back(named);
  for (const Options& changed : options) timers.emplace_back(named, changed);
  repeat_for(seconds * double(timers.size()), kMinRounds, [&] {
    for (FrameTimer& timer : timers) timer.round();
  });
  const double of_defaults = timers.front().result().both_ms();
  timers.pop_front();
  std::vector<double> ratios;
  ratios.reserve(timers.size());
  for (const FrameTimer& timer : timers) ratios.push_back(timer.result().both_ms() / of_defaults);
  return ratios;
}

SizeTiming time_sizes(const Picture& picture, int crop_size, double seconds) {
  Vectorizer whole, cropped;
  std::vector<double> whole_ms, cropped_ms;
  const auto round = [&] {
    whole_ms.push_back(time_ms([&] { whole.vectorize(picture.view(), kOptions); }));
    cropped_ms.push_back(time_ms([&] {
      for (int y = 0; y < picture.height(); y += crop_size) {
        for (int x = 0; x < picture.width(); x += crop_size) {
          cropped.vectorize(crop(picture.view(), x, y, crop_size, crop_size), kOptions);
        }
      }
    }));
  };
  repeat_for(seconds, kMinRounds, round);
  const double ns_a_pixel = 1e6 / double(picture.pixel_count());
  return {median(whole_ms) * ns_a_pixel, median(cropped_ms) * ns_a_pixel};
}

}  // namespace depixel::bench
