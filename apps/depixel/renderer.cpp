#include "apps/depixel/renderer.hpp"

#include <fmt/core.h>

#include <cmath>
#include <string>

#include "apps/common/draw_kept.hpp"
#include "apps/common/encode_png.hpp"
#include "apps/common/files.hpp"
#include "apps/common/limits.hpp"
#include "libdepixel/core/stopwatch.hpp"
#include "libdepixel/svg/svg_writer.hpp"

namespace depixel {
namespace {

constexpr double kDefaultScale = 4, kDefaultStageScale = 16;

using File = std::vector<std::uint8_t>;

}  // namespace

tl::expected<OutputSize, Error> output_size(const Arguments& arguments, int width, int height) {
  const double scale = arguments.scale.value_or(arguments.stage ? kDefaultStageScale : kDefaultScale);
  const double out_width = arguments.size ? arguments.size->width : std::round(width * scale);
  const double out_height = arguments.size ? arguments.size->height : std::round(height * scale);
  if (out_width < 1 || out_height < 1) {
    return tl::unexpected(
        Error{fmt::format("A picture of {} x {} pixels has none left at scale {}.", width, height, scale)});
  }
  if (out_width > kMaxSide || out_height > kMaxSide || out_width * out_height > double(kMaxOutputPixels)) {
    return tl::unexpected(Error{fmt::format(
        "An output of {} x {} pixels is too large: at most {} a side and {} in all; choose a smaller "
        "--scale or write SVG.",
        out_width, out_height, kMaxSide, kMaxOutputPixels)});
  }
  return OutputSize{static_cast<int>(out_width), static_cast<int>(out_height)};
}

tl::expected<Renderer, Error> Renderer::create(const Arguments& arguments) {
  Renderer renderer(arguments);
  if (arguments.backend == Backend::cpu) {
    renderer.filter_ = FrameFilter::cpu();
  } else if (auto started = renderer.start_gl(); !started) {
    return tl::unexpected(started.error());
  }
  renderer.filter_->check_incremental(arguments.check_incremental);
  return renderer;
}

tl::expected<void, Error> Renderer::start_gl() {
  auto context = create_headless_context(arguments_->context);
  if (!context) return tl::unexpected(context.error());
  context_ = std::move(*context);
  auto filter = FrameFilter::gl(context_->loader());
  if (!filter) return tl::unexpected(filter.error());
  filter_ = std::move(*filter);
  return {};
}

tl::expected<File, Error> Renderer::render(const FrameView& frame, Format format, RunStats& stats) {
  const auto size = output_size(*arguments_, frame.width, frame.height);
  if (format == Format::png && !size) return tl::unexpected(size.error());

  if (auto submitted = filter_->submit(frame, arguments_->options); !submitted) {
    return tl::unexpected(submitted.error());
  }
  stats.add_vectorized(filter_->vectorizer().stats());
  if (format == Format::svg) {
    const Stopwatch drawing(stats.draw_ns);
    const std::string svg = draw_svg(frame);
    const auto bytes = bytes_of(svg);
    return File(bytes.begin(), bytes.end());
  }
  {
    const Stopwatch drawing(stats.draw_ns);
    if (auto drawn = draw_picture(frame, *size); !drawn) return tl::unexpected(drawn.error());
  }
  stats.work.add_drawn(filter_->stats());
  const Stopwatch writing(stats.write_ns);
  File png = encode_png(picture_.view());
  if (png.empty()) return tl::unexpected(Error{"There is not enough memory to write the picture."});
  return png;
}

std::string Renderer::draw_svg(const FrameView& frame) const {
  if (arguments_->stage) {
    return write_stage_svg(make_stage_drawing(*arguments_->stage, frame, arguments_->options));
  }
  return write_svg(filter_->vectorizer().map(), filter_->vectorizer().graph(), arguments_->svg_tolerance_px);
}

tl::expected<void, Error> Renderer::draw_picture(const FrameView& frame, OutputSize size) {
  if (arguments_->stage) {
    picture_.resize(size.width, size.height);
    paint_stage(make_stage_drawing(*arguments_->stage, frame, arguments_->options), picture_.target());
    return {};
  }
  // Where no stage is drawn, nobody but the filter writes to the picture.
  return draw_kept(*filter_, picture_, size.width, size.height);
}

}  // namespace depixel
