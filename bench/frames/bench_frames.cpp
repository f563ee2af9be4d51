/// Times vectorizing and drawing of frames against libavfilter's xbr, on one core.

#include <fmt/core.h>

#include <algorithm>
#include <cstdio>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>

#include "bench/common/generated.hpp"
#include "bench/common/inputs.hpp"
#include "bench/common/option_variants.hpp"
#include "bench/common/program.hpp"
#include "bench/frames/frame_timing.hpp"

namespace depixel::bench {
namespace {

constexpr double kWantedVectorize = 2.0, kWantedBoth = 3.6, kWantedGenerated = 5.0, kWantedSizes = 1.3;
constexpr int kGeneratedWidth = 256, kGeneratedHeight = 224;
constexpr int kSmallSize = 64, kLargeSize = 1024;
/// The frame that generated pictures are compared with, by a part of its path, unless one is given.
constexpr std::string_view kYardstick = "snes_platformer";

struct Settings {
  std::vector<std::filesystem::path> inputs;
  std::filesystem::path yardstick;
  int every = 1;
  double seconds = 0.3;
  bool json = false, stages = false, generated = false, options = false;
};

void print_timing(const FrameTiming& timing, bool stages) {
  constexpr std::size_t kNameColumns = 36;
  std::string name = timing.name;
  if (name.size() > kNameColumns) name = "..." + name.substr(name.size() - kNameColumns + 3);
  fmt::print("{:<36} {:>9.3f} {:>9.3f} {:>9.3f} {:>8.2f} {:>8.2f}", name, median(timing.vectorize),
             median(timing.raster), median(timing.xbr4), timing.vectorize_ratio(), timing.both_ratio());
  for (std::size_t i = 0; stages && i < timing.stages.size(); ++i) {
    fmt::print(" {:>10.3f}", median(timing.stages[i]));
  }
  fmt::print("\n");
  std::fflush(stdout);
}

void print_header(bool stages) {
  fmt::print("{:<36} {:>9} {:>9} {:>9} {:>8} {:>8}", "frame, ms", "vectorize", "raster 4x", "xbr 4x",
             "vec/xbr", "both/xbr");
  if (stages) {
    for (std::string_view name : VectorizeStats::kStageNames) fmt::print(" {:>10}", name);
  }
  fmt::print("\n");
}

std::string_view verdict(double value, double wanted) {
  return value <= wanted ? "reached" : "missed";
}

void print_worst(const std::vector<FrameTiming>& timings, std::string_view what, double wanted,
                 double (FrameTiming::*ratio)() const) {
  const auto worst = std::max_element(timings.begin(), timings.end(), [&](const auto& a, const auto& b) {
    return (a.*ratio)() < (b.*ratio)();
  });
  fmt::print("worst {}/xbr {:.2f} ({}), wanted at most {}: {}\n", what, ((*worst).*ratio)(), worst->name,
             wanted, verdict(((*worst).*ratio)(), wanted));
}

/// Times each file by itself, so that no more than one picture and its buffers are held.
std::vector<FrameTiming> time_files(const std::vector<std::filesystem::path>& files,
                                    const Settings& settings) {
  std::vector<FrameTiming> timings;
  for (const auto& file : files) {
    const NamedPicture frame{file.string(), read_picture(file)};
    timings.push_back(time_frames({&frame, 1}, settings.seconds).front());
    if (!settings.json) print_timing(timings.back(), settings.stages);
  }
  return timings;
}

void print_json(const std::vector<FrameTiming>& timings) {
  using Json = nlohmann::ordered_json;
  Json frames = Json::array();
  for (const FrameTiming& timing : timings) {
    frames.push_back({{"name", timing.name},
                      {"vectorize_ms", median(timing.vectorize)},
                      {"raster_ms", median(timing.raster)},
                      {"both_ms", median(timing.both)},
                      {"xbr4_ms", median(timing.xbr4)},
                      {"scale", kTimingScale}});
  }
  fmt::print("{}\n", Json{{"frames", std::move(frames)}}.dump());
}

std::filesystem::path choose_yardstick(const std::vector<std::filesystem::path>& files,
                                       const Settings& settings) {
  if (!settings.yardstick.empty()) return settings.yardstick;
  const auto found = std::find_if(files.begin(), files.end(), [](const auto& file) {
    return file.string().find(kYardstick) != std::string::npos;
  });
  return found != files.end() ? *found : files.front();
}

/// Generated pictures against a real frame.
void print_generated(const std::filesystem::path& yardstick, const Settings& settings) {
  constexpr int kWidth = kGeneratedWidth, kHeight = kGeneratedHeight;
  const std::vector<NamedPicture> pictures{{yardstick.string(), read_picture(yardstick)},
                                           {"checkerboard", checkerboard(kWidth, kHeight)},
                                           {"noise", colour_noise(kWidth, kHeight)},
                                           {"two-colour noise", two_colour_noise(kWidth, kHeight)},
                                           {"dithered gradient", dithered_gradient(kWidth, kHeight)}};
  const std::vector<FrameTiming> timings = time_frames(pictures, settings.seconds);
  fmt::print("\n");
  print_header(settings.stages);
  for (const FrameTiming& timing : timings) print_timing(timing, settings.stages);
  const FrameTiming& real = timings.front();
  for (auto timing = std::next(timings.begin()); timing != timings.end(); ++timing) {
    const double vectorize = median_ratio(timing->vectorize, real.vectorize),
                 both = median_ratio(timing->both, real.both);
    fmt::print("{}: vectorize {:.2f}, both {:.2f} times the real frame, wanted at most {}: {}\n",
               timing->name, vectorize, both, kWantedGenerated,
               verdict(std::max(vectorize, both), kWantedGenerated));
  }
}

/// Time a pixel of a large picture against that of small ones with the same content.
void print_sizes(const std::vector<std::filesystem::path>& files, const Settings& settings) {
  std::vector<Picture> frames;
  std::transform(files.begin(), files.end(), std::back_inserter(frames), read_picture);
  const SizeTiming timing = time_sizes(tile(frames, kLargeSize, kLargeSize), kSmallSize, settings.seconds);
  fmt::print(
      "\nvectorize at {0}x{0} {1:.1f} ns a pixel, at {2}x{2} {3:.1f}: {4:.2f} times, wanted at most {5}: "
      "{6}\n",
      kLargeSize, timing.whole_ns, kSmallSize, timing.cropped_ns, timing.ratio, kWantedSizes,
      verdict(timing.ratio, kWantedSizes));
}

/// What options cost on each frame.
void print_options(const std::vector<std::filesystem::path>& files, const Settings& settings) {
  std::vector<Options> options;
  fmt::print("{:<36}", "vectorize and draw / the defaults'");
  for (const OptionVariant& variant : kOptionVariants) {
    options.push_back(variant.options());
    fmt::print(" {:>17}", variant.name);
  }
  for (const auto& file : files) {
    fmt::print("\n{:<36}", file.filename().string());
    for (const double ratio : time_options(read_picture(file), options, settings.seconds))
      fmt::print(" {:>17.2f}", ratio);
    std::fflush(stdout);
  }
  fmt::print("\n");
}

void run(Settings settings) {
  if (settings.inputs.empty()) {
    settings.inputs.push_back(shipped_data() / "frames");
    settings.generated = true;
  }
  const auto files = list_pictures(settings.inputs, settings.every);
  if (settings.options) {
    print_options(files, settings);
    return;
  }
  if (!settings.json) print_header(settings.stages);
  const std::vector<FrameTiming> timings = time_files(files, settings);
  if (settings.json) {
    print_json(timings);
    return;
  }
  print_worst(timings, "vectorize", kWantedVectorize, &FrameTiming::vectorize_ratio);
  print_worst(timings, "vectorize and raster", kWantedBoth, &FrameTiming::both_ratio);
  if (settings.generated) {
    print_generated(choose_yardstick(files, settings), settings);
    print_sizes(files, settings);
  }
}

void add_options(CLI::App& app, Settings& settings) {
  app.description(
      "Times vectorizing and drawing at 4x against libavfilter's xbr=n=4, on one core; medians of runs taken "
      "in turns.");
  app.add_option("INPUT", settings.inputs,
                 "pictures, and folders of them; the shipped frames if none is given");
  app.add_option("--every", settings.every, "take each n-th picture of a folder")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--seconds", settings.seconds, "how long a frame is repeated")->capture_default_str();
  app.add_flag("--stages", settings.stages, "show the time of each stage");
  app.add_flag("--generated", settings.generated,
               "time generated and cropped pictures too, as without INPUT");
  app.add_flag("--options", settings.options, "print what options cost instead");
  app.add_option("--yardstick", settings.yardstick, "frame that generated pictures are compared with");
  app.add_flag("--json", settings.json, "print the times of the frames as one JSON object, and nothing else");
}

}  // namespace
}  // namespace depixel::bench

int main(int argc, char** argv) {
  using namespace depixel::bench;
  return run_program<Settings>("bench_frames", argc, argv, add_options, run);
}
