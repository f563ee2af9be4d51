#include "bench/frames/frame_timing.hpp"

#include <deque>

#include "bench/common/median.hpp"
#include "bench/peers/libav_scaler.hpp"
#include "libdepixel/raster/cpu_raster.hpp"

namespace depixel::bench {
namespace {

constexpr int kMinRounds = 9;
constexpr int kWarmUpRounds = 2;
constexpr double kMsPerNs = 1e-6;
const Options kOptions;  // the defaults, one thread

/// All that takes turns on one frame.
class FrameTimer {
 public:
  explicit FrameTimer(const NamedPicture& frame, const Options& options = {})
      : options_(options),
        view_(frame.picture.view()),
        out_(view_.width * kTimingScale, view_.height * kTimingScale),
        xbr_("xbr", kTimingScale, view_.width, view_.height) {
    xbr_.load(view_);
    for (int i = 0; i < kWarmUpRounds; ++i) round();
    timing_ = {};
    timing_.name = frame.name;
  }

  void round() {
    const double vectorize = time_ms([&] { vectorizer_.vectorize(view_, options_); });
    const MapByEdge map = vectorizer_.by_edge();
    const View view = View::fit(map.edges.lattice, out_.width(), out_.height());
    const double raster =
        time_ms([&] { raster_.draw(map, view, options_.linear_light, options_.threads, out_.target()); });
    const auto& stages_ns = vectorizer_.stats().stage_ns;
    for (std::size_t i = 0; i < stages_ns.size(); ++i)
      timing_.stages[i].push_back(kMsPerNs * double(stages_ns[i]));
    timing_.vectorize.push_back(vectorize);
    timing_.raster.push_back(raster);
    timing_.both.push_back(vectorize - timing_.stages.back().back() + raster);
    timing_.xbr4.push_back(time_ms([&] { xbr_.run(); }));
  }

  const FrameTiming& timing() const { return timing_; }

 private:
  Options options_;
  FrameView view_;
  Vectorizer vectorizer_;
  CpuRaster raster_;
  Picture out_;
  LibavScaler xbr_;
  FrameTiming timing_;
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
  for (const FrameTimer& timer : timers) timings.push_back(timer.timing());
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
  std::vector<double> ratios;
  for (std::size_t i = 1; i < timers.size(); ++i)
    ratios.push_back(median_ratio(timers[i].timing().both, timers[0].timing().both));
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
  return {median(whole_ms) * ns_a_pixel, median(cropped_ms) * ns_a_pixel, median_ratio(whole_ms, cropped_ms)};
}

}  // namespace depixel::bench
