#include "apps/player/canvas.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "libdepixel/core/color.hpp"

namespace depixel {
namespace {

constexpr std::array<float, 3> kBackground{0.07f, 0.07f, 0.075f};
constexpr Rgba kLightChequer{58, 58, 62, 255}, kDarkChequer{44, 44, 48, 255};
constexpr int kChequerPx = 8;

bool is_opaque(const FrameView& frame) {
  for (int y = 0; y < frame.height; ++y) {
    const std::uint8_t* row = frame.pixels + y * frame.pitch;
    for (int x = 0; x < frame.width; ++x) {
      if (row[4 * x + 3] != 255) return false;
    }
  }
  return true;
}

}  // namespace

SplitParts split_parts(const PixelRect& visible, double divider) {
  const int left = static_cast<int>(std::lround(visible.width * divider));
  return {{visible.x, visible.y, left, visible.height},
          {visible.x + left, visible.y, visible.width - left, visible.height}};
}

Canvas::Canvas(const GladGLContext& gl, std::unique_ptr<FrameFilter> filter, QuadPainter quads)
    : gl_(gl),
      filter_(std::move(filter)),
      quads_(std::move(quads)),
      stage_texture_(gl),
      raw_texture_(gl),
      chequers_(gl),
      offscreen_(gl) {
  const std::array<Rgba, 4> pattern{kLightChequer, kDarkChequer, kDarkChequer, kLightChequer};
  chequers_.upload({reinterpret_cast<const std::uint8_t*>(pattern.data()), 2, 2, 8});
}

tl::expected<std::unique_ptr<Canvas>, Error> Canvas::make(const GladGLContext& gl, GlLoader loader) {
  auto filter = FrameFilter::gl(loader);
  if (!filter) return tl::unexpected(filter.error());
  auto quads = QuadPainter::make(gl);
  if (!quads) return tl::unexpected(quads.error());
  return std::unique_ptr<Canvas>(new Canvas(gl, std::move(*filter), std::move(*quads)));
}

void Canvas::clear() {
  frame_ = {};
}

tl::expected<void, Error> Canvas::submit(const FrameView& frame, std::uint64_t serial,
                                         const Options& options) {
  const bool is_new = frame_.pixels == nullptr || serial != serial_;
  if (!is_new && options == options_) return {};
  if (is_new) {
    raw_is_uploaded_ = false;
    is_opaque_ = is_opaque(frame);
  }
  frame_ = frame;
  serial_ = serial;
  options_ = options;
  ++submissions_;
  auto submitted = filter_->submit(frame, options);
  counts_.add_vectorized(filter_->vectorizer().stats());
  return submitted;
}

tl::expected<void, Error> Canvas::draw(glm::ivec2 window, const ViewControl& control,
                                       const LookSettings& look, std::optional<StageView> stage) {
  window_height_ = window.y;
  stage_ns_ = 0;
  gl_.BindFramebuffer(GL_FRAMEBUFFER, 0);
  gl_.Disable(GL_SCISSOR_TEST);
  gl_.ClearColor(kBackground[0], kBackground[1], kBackground[2], 1);
  gl_.Clear(GL_COLOR_BUFFER_BIT);
  if (frame_.pixels == nullptr) return {};

  const auto [left, right] = split_parts(control.visible(), look.split ? look.divider : 1);
  if (!is_opaque_) draw_chequers(control.visible());
  if (!right.empty()) draw_raw(right, control.view_of(right), look.raw);
  if (left.empty()) return {};
  if (!stage) return draw_filter(left, control.view_of(left));
  draw_stage(left, control.view_of(left), *stage);
  return {};
}

tl::expected<void, Error> Canvas::draw_filter(const PixelRect& part, const View& view) {
  if (is_opaque_) {
    const Viewport viewport{part.x, window_height_ - part.y - part.height, part.width, part.height};
    return draw_by_filter({0}, viewport, view);
  }
  offscreen_.resize({part.width, part.height});
  auto drawn = draw_by_filter({offscreen_.name()}, {0, 0, part.width, part.height}, view);
  // A framebuffer's first row is its lowest.
  quads_.draw(offscreen_.texture(), {{0, 1}, {1, 0}}, part, window_height_, false);
  return drawn;
}

tl::expected<void, Error> Canvas::draw_by_filter(GlFramebuffer target, const Viewport& viewport,
                                                 const View& view) {
  auto drawn = filter_->draw(target, viewport, view);
  const FilterStats& stats = filter_->stats();
  counts_.add_drawn(stats);
  if (stats.prepare_ns > 0) prepared_ = stats;
  return drawn;
}

void Canvas::draw_stage(const PixelRect& part, const View& view, StageView stage) {
  if (stages_.paint(frame_, serial_, options_, stage, view, part.width, part.height)) {
    stage_texture_.upload(stages_.picture().view());
  }
  stage_ns_ = stages_.paint_ns();
  quads_.draw(stage_texture_, {}, part, window_height_, false);
}

void Canvas::draw_raw(const PixelRect& part, const View& view, RawSampling sampling) {
  if (!std::exchange(raw_is_uploaded_, true)) raw_texture_.upload(frame_);
  const glm::dvec2 size(frame_.width, frame_.height), origin(view.origin_x, view.origin_y);
  const glm::dvec2 shown(part.width / view.scale_x, part.height / view.scale_y);
  quads_.draw(raw_texture_, {origin / size, (origin + shown) / size}, part, window_height_,
              sampling == RawSampling::bilinear);
}

void Canvas::draw_chequers(const PixelRect& part) {
  const glm::dvec2 periods = glm::dvec2(part.width, part.height) / (2.0 * kChequerPx);
  quads_.draw(chequers_, {{0, 0}, periods, /*repeats=*/true}, part, window_height_, false);
}

}  // namespace depixel
