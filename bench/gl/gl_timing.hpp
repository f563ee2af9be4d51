#pragma once

#include <glad/gl.h>

#include <cstdint>
#include <memory>

#include "apps/headless/context_kind.hpp"
#include "bench/common/picture.hpp"
#include "filter/frame_filter.hpp"
#include "filter/gl/gl_object.hpp"

namespace depixel::bench {

/// Medians of one frame's times, milliseconds.
struct GlTiming {
  double nearest_ms = 0;    ///< a textured quad of the frame, without smoothing: the yardstick
  double draw_ms = 0;       ///< the filter, of a frame that is prepared
  double vectorize_ms = 0;  ///< the filter's submit()
  double prepare_ms = 0;    ///< lines, tiles and uploads, by the processor
  std::int64_t lines = 0;
  std::size_t upload_bytes = 0;

  double draw_ratio() const { return draw_ms / nearest_ms; }
  double prepare_ratio() const { return prepare_ms / vectorize_ms; }
};

/// Draws frames to a framebuffer in memory, by the filter and by a plain quad in turns.
class GlTimer {
 public:
  /// Throws std::runtime_error where there is no context.
  explicit GlTimer(std::optional<ContextKind> kind);
  GlTimer(const GlTimer&) = delete;
  GlTimer& operator=(const GlTimer&) = delete;
  ~GlTimer();

  /// Draws a view to memory. \param picture  holds the result.
  void draw(const FrameView& frame, const View& view, Picture& picture);

  const char* renderer() const { return reinterpret_cast<const char*>(gl_.GetString(GL_RENDERER)); }

  /// \param seconds  how long the frame is drawn over and over; nothing is read back.
  GlTiming time(const FrameView& frame, int out_width, int out_height, double seconds);

 private:
  void resize(int width, int height);
  void upload(const FrameView& frame);
  void draw_nearest(int width, int height);
  void draw_filtered(const FrameView& frame, int width, int height);

  std::unique_ptr<HeadlessContext> context_;
  GladGLContext gl_{};
  std::unique_ptr<FrameFilter> filter_;
  GlProgram program_;
  GLuint vertices_ = 0, texture_ = 0, framebuffer_ = 0, colours_ = 0;
};

}  // namespace depixel::bench
