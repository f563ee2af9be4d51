#include "apps/depixel/convert.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstdio>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "apps/common/about_frame.hpp"
#include "apps/common/exit_codes.hpp"
#include "apps/common/files.hpp"
#include "apps/common/frame_source.hpp"
#include "apps/depixel/outputs.hpp"
#include "apps/depixel/progress_bar.hpp"
#include "apps/depixel/renderer.hpp"
#include "libdepixel/core/stopwatch.hpp"

namespace depixel {
namespace {

/// What --verify found in all frames.
struct Verification {
  std::int64_t pixels = 0, lost = 0;
  double nearest_px = std::numeric_limits<double>::infinity();
  std::string first_lost;

  void add(const CentreReport& report, const std::string& name) {
    if (report.lost > 0 && lost == 0) {
      first_lost = fmt::format("({}, {}) of {}", report.first_lost_x, report.first_lost_y, name);
    }
    pixels += report.pixels;
    lost += report.lost;
    nearest_px = std::min(nearest_px, report.nearest);
  }
};

/// Tells an error. \return the exit code that stands for it.
int fail(const Error& error) {
  fmt::print(stderr, "depixel: {}\n", error.message);
  return kExitFailed;
}

/// One run of the program: its frames, where they go, and what is known of them at the end.
class Conversion {
 public:
  Conversion(const Arguments& arguments, Inputs inputs, Renderer renderer)
      : arguments_(arguments), source_(std::move(inputs)), renderer_(std::move(renderer)) {}

  using Frame = std::optional<NamedFrame>;

  tl::expected<Frame, Error> read() {
    const Stopwatch reading(stats_.read_ns);
    return source_.next();
  }
  bool is_sequence() const { return source_.is_sequence(); }

  /// Converts a frame and all that come after it.
  tl::expected<void, Error> convert_from(Frame frame, Outputs& outputs) {
    ProgressBar progress(is_sequence() && !arguments_.quiet);
    while (frame) {
      if (auto done = convert_one(*frame, outputs); !done) return done;
      progress.show(source_.progress());
      auto next = read();
      if (!next) return tl::unexpected(next.error());
      frame = std::move(*next);
    }
    return {};
  }

  int report() const;

 private:
  tl::expected<void, Error> convert_one(const NamedFrame& frame, Outputs& outputs) {
    const auto file = renderer_.render(frame.picture.view(), outputs.format(), stats_);
    if (!file) {
      return tl::unexpected(arguments_.check_incremental ? about_frame(frame.name, file.error())
                                                         : file.error());
    }
    if (arguments_.verify) verification_.add(renderer_.verify(), frame.name);
    const Stopwatch writing(stats_.write_ns);
    return outputs.write(frame.name, *file);
  }

  const Arguments& arguments_;
  FrameSource source_;
  Renderer renderer_;
  RunStats stats_;
  Verification verification_;
};

/// Tells what was asked for. \return the exit code.
int Conversion::report() const {
  if (arguments_.stats == StatsForm::table) fmt::print(stderr, "{}", stats_table(stats_));
  if (arguments_.stats == StatsForm::json) {
    const std::string json = stats_json(stats_);
    if (const auto written = write_standard_output(bytes_of(json)); !written) return fail(written.error());
  }
  const Verification& v = verification_;
  if (v.lost > 0) {
    return fail({fmt::format("{} of {} pixels lost the colour at their centre, the first at {}.", v.lost,
                             v.pixels, v.first_lost)});
  }
  if (arguments_.verify && !arguments_.quiet) {
    fmt::print(
        stderr,
        "All {} pixels kept the colour at their centre; no curve comes nearer to one than {:.4f} pixels.\n",
        v.pixels, v.nearest_px);
  }
  return kExitDone;
}

}  // namespace

int convert(const Arguments& arguments) {
  auto inputs = find_inputs(arguments.inputs);
  if (!inputs) return fail(inputs.error());
  auto renderer = Renderer::create(arguments);
  if (!renderer) return fail(renderer.error());
  Conversion conversion(arguments, *inputs, std::move(*renderer));
  auto first = conversion.read();
  if (!first) return fail(first.error());

  auto outputs = Outputs::plan(arguments, conversion.is_sequence());
  if (!outputs) {
    fmt::print(stderr, "depixel: {}; see depixel --help.\n", outputs.error().message);
    return kExitUsage;
  }
  if (const auto ready = outputs->prepare(inputs->files); !ready) return fail(ready.error());
  if (const auto done = conversion.convert_from(std::move(*first), *outputs); !done)
    return fail(done.error());
  return conversion.report();
}

}  // namespace depixel
