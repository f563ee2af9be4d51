#pragma once

#include <glad/gl.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <tl/expected.hpp>

#include "apps/common/work_counts.hpp"
#include "apps/player/quad_painter.hpp"
#include "apps/player/settings.hpp"
#include "apps/player/stage_painter.hpp"
#include "apps/player/texture.hpp"
#include "apps/player/view_control.hpp"
#include "filter/frame_filter.hpp"
#include "libdepixel/core/error.hpp"
#include "libdepixel/core/frame_view.hpp"
#include "libdepixel/core/options.hpp"
#include "libdepixel/views/stage_view.hpp"

namespace depixel {

/// Draws what lies under the panels: the filtered frame or a step on the way, and the raw frame beside it.
class Canvas {
 public:
  /// On the current context, which must outlive the canvas.
  static tl::expected<std::unique_ptr<Canvas>, Error> make(const GladGLContext& gl, GlLoader loader);

  /// Takes a frame, which must stay until the next one is taken; does nothing if neither it nor the options
  /// changed. \param serial  another one for every other frame.
  tl::expected<void, Error> submit(const FrameView& frame, std::uint64_t serial, const Options& options);
  /// Whether what is made of a frame is compared with what is made from scratch; a difference is an error of
  /// submit() or draw(), after which all goes on.
  void check_incremental(bool wanted) { filter_->check_incremental(wanted); }
  /// Forgets the frame.
  void clear();

  /// Draws the frame over the window's framebuffer, or only the background if there is none.
  /// \param stage  none: the filter.
  tl::expected<void, Error> draw(glm::ivec2 window, const ViewControl& control, const LookSettings& look,
                                 std::optional<StageView> stage);

  /// Of the frame that was submitted last.
  const FrameFilter& filter() const { return *filter_; }
  /// How often a frame was vectorized: tells whether what was made from one is still true.
  std::uint64_t submissions() const { return submissions_; }
  std::int64_t stage_paint_ns() const { return stage_ns_; }
  /// Of the last drawing for which lines and tiles were made and sent.
  const FilterStats& prepared() const { return prepared_; }
  /// Of all frames so far.
  const WorkCounts& counts() const { return counts_; }

 private:
  Canvas(const GladGLContext& gl, std::unique_ptr<FrameFilter> filter, QuadPainter quads);

  tl::expected<void, Error> draw_filter(const PixelRect& part, const View& view);
  tl::expected<void, Error> draw_by_filter(GlFramebuffer target, const Viewport& viewport, const View& view);
  void draw_stage(const PixelRect& part, const View& view, StageView stage);
  void draw_raw(const PixelRect& part, const View& view, RawSampling sampling);
  void draw_chequers(const PixelRect& part);

  const GladGLContext& gl_;
  std::unique_ptr<FrameFilter> filter_;
  QuadPainter quads_;
  StagePainter stages_;
  Texture stage_texture_, raw_texture_, chequers_;
  TextureFramebuffer offscreen_;  ///< for pictures that something shines through

  FrameView frame_;
  std::uint64_t serial_ = 0, submissions_ = 0;
  Options options_;
  bool is_opaque_ = true;
  bool raw_is_uploaded_ = false;
  int window_height_ = 0;
  std::int64_t stage_ns_ = 0;
  FilterStats prepared_;
  WorkCounts counts_;
};

/// Where the divider of a split view stands: the visible part's left side and right side of it.
struct SplitParts {
  PixelRect left, right;
};
SplitParts split_parts(const PixelRect& visible, double divider);

}  // namespace depixel
