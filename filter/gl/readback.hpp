#pragma once

#include <tl/expected.hpp>

#include "filter/gl/gl_object.hpp"
#include "libdepixel/core/error.hpp"
#include "libdepixel/core/frame_view.hpp"

namespace depixel {

/// A framebuffer of its own, to draw to what a picture in memory is to hold.
class Readback {
 public:
  /// Binds the framebuffer for drawing and reading, at least as large as asked for.
  tl::expected<void, Error> bind(const GladGLContext& gl, int width, int height);
  /// Copies its bottom left to a picture, whose top row is the framebuffer's top one.
  void read(const GladGLContext& gl, const PictureView& picture);

  void forget();

 private:
  GlFramebufferObject framebuffer_;
  GlRenderbuffer colours_;
  int width_ = 0, height_ = 0;
};

}  // namespace depixel
