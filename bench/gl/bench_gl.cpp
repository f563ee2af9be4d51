/// Times drawing by OpenGL, without a display, against a plain textured quad.

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "apps/common/option_flags.hpp"
#include "bench/common/inputs.hpp"
#include "bench/common/program.hpp"
#include "bench/gl/gl_comparison.hpp"
#include "bench/gl/gl_timing.hpp"

namespace depixel::bench {
namespace {

constexpr double kWantedDraw = 6.0, kWantedDetailedDraw = 10.0, kWantedPrepare = 1.5;
/// Differences from the processor's pictures, of 255 levels.
constexpr double kWantedMean = 0.5, kWantedPixel = 4;
/// Frames with more lines than this to a pixel are detailed, as those of 3-D games.
constexpr double kDetailedLines = 1.5;

struct Settings {
  std::vector<std::filesystem::path> inputs;
  std::optional<ContextKind> context;
  std::optional<OutputSize> size;
  int every = 1;
  bool compare = false;
  double seconds = 1.0, scale = 4.0;
};

std::string_view verdict(double value, double wanted) {
  return value <= wanted ? "reached" : "missed";
}

void run(const Settings& settings) {
  GlTimer timer(settings.context);
  auto inputs = settings.inputs;
  if (inputs.empty()) inputs.push_back(shipped_data() / "frames");
  const auto files = list_pictures(inputs, settings.every);
  if (settings.compare) {
    fmt::print("{}\n", timer.renderer());
    const GlComparison c = compare(timer, files);
    fmt::print(
        "{} views of {} frames: mean difference to the processor at most {:.3f}, wanted {}: {}; worst pixel "
        "{}, "
        "wanted {}: {}\n",
        c.views, files.size(), c.worst_mean, kWantedMean, verdict(c.worst_mean, kWantedMean), c.worst_pixel,
        kWantedPixel, verdict(c.worst_pixel, kWantedPixel));
    return;
  }
  fmt::print("{}\n{:<36} {:>11} {:>8} {:>8} {:>8} {:>8} {:>8} {:>9} {:>8} {:>8} {:>7}\n", timer.renderer(),
             "frame, ms", "output", "nearest", "draw", "ratio", "fps", "vector.", "prepare", "ratio",
             "lines/px", "MB sent");
  double worst_plain = 0, worst_detailed = 0, worst_prepare = 0;
  for (const auto& file : files) {
    const Picture frame = read_picture(file);
    const int width = settings.size ? settings.size->width : int(std::lround(frame.width() * settings.scale));
    const int height =
        settings.size ? settings.size->height : int(std::lround(frame.height() * settings.scale));
    const GlTiming t = timer.time(frame.view(), width, height, settings.seconds);
    const double density = double(t.lines) / double(frame.pixel_count());
    double& worst = density > kDetailedLines ? worst_detailed : worst_plain;
    worst = std::max(worst, t.draw_ratio());
    worst_prepare = std::max(worst_prepare, t.prepare_ratio());
    std::string name = file.string();
    if (name.size() > 36) name = "..." + name.substr(name.size() - 33);
    fmt::print(
        "{:<36} {:>11} {:>8.3f} {:>8.3f} {:>8.2f} {:>8.0f} {:>8.3f} {:>9.3f} {:>8.2f} {:>8.2f} {:>7.2f}\n",
        name, fmt::format("{}x{}", width, height), t.nearest_ms, t.draw_ms, t.draw_ratio(), 1000 / t.draw_ms,
        t.vectorize_ms, t.prepare_ms, t.prepare_ratio(), density, double(t.upload_bytes) * 1e-6);
    std::fflush(stdout);
  }
  if (worst_plain > 0) {
    fmt::print("worst draw/nearest {:.2f}, wanted at most {}: {}\n", worst_plain, kWantedDraw,
               verdict(worst_plain, kWantedDraw));
  }
  if (worst_detailed > 0) {
    fmt::print("worst draw/nearest of detailed frames {:.2f}, wanted at most {}: {}\n", worst_detailed,
               kWantedDetailedDraw, verdict(worst_detailed, kWantedDetailedDraw));
  }
  fmt::print("worst prepare/vectorize {:.2f}, wanted at most {}: {}\n", worst_prepare, kWantedPrepare,
             verdict(worst_prepare, kWantedPrepare));
}

void add_options(CLI::App& app, Settings& settings) {
  app.description(
      "Times drawing by OpenGL without a display, against a textured quad without "
      "smoothing; medians of "
      "runs taken in turns.");
  app.add_option("INPUT", settings.inputs,
                 "pictures, and folders of them; the shipped frames if none is given");
  app.add_option("--every", settings.every, "take each n-th picture of a folder")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--seconds", settings.seconds, "how long a frame is repeated")->capture_default_str();
  app.add_option("--scale", settings.scale, "output pixels to a pixel of the frame")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_flag("--compare", settings.compare,
               "measure how far pictures are from the processor's, at several scales, instead of times");
  add_size_flag(app, "--size", settings.size, "output size, instead of a scale");
  add_choice_flag(app, "--context", "where OpenGL comes from; whichever can be had unless given",
                  context_kind_names(),
                  [&](int index) { settings.context = static_cast<ContextKind>(index); });
}

}  // namespace
}  // namespace depixel::bench

int main(int argc, char** argv) {
  using namespace depixel::bench;
  return run_program<Settings>("bench_gl", argc, argv, add_options, run);
}
