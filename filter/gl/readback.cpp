#include "filter/gl/readback.hpp"

#include <fmt/core.h>

#include <algorithm>

namespace depixel {

tl::expected<void, Error> Readback::bind(const GladGLContext& gl, int width, int height) {
  if (!framebuffer_) {
    GLuint name = 0;
    gl.GenFramebuffers(1, &name);
    framebuffer_ = GlFramebufferObject(gl, name);
    gl.GenRenderbuffers(1, &name);
    colours_ = GlRenderbuffer(gl, name);
    width_ = height_ = 0;
  }
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
  if (width <= width_ && height <= height_) return {};

  GLint max_size = 0;
  gl.GetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &max_size);
  if (width > max_size || height > max_size) {
    return tl::unexpected(
        Error{fmt::format("An output of {} x {} pixels is too large for this OpenGL, which draws {} a side.",
                          width, height, max_size)});
  }
  width_ = std::max(width_, width);
  height_ = std::max(height_, height);
  gl.BindRenderbuffer(GL_RENDERBUFFER, colours_.name());
  gl.RenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, width_, height_);
  gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, colours_.name());
  const GLenum status = gl.CheckFramebufferStatus(GL_FRAMEBUFFER);
  if (status == GL_FRAMEBUFFER_COMPLETE) return {};
  width_ = height_ = 0;
  return tl::unexpected(Error{
      fmt::format("OpenGL gives no framebuffer of {} x {} pixels (status {:#x}).", width, height, status)});
}

void Readback::read(const GladGLContext& gl, const PictureView& picture) {
  gl.PixelStorei(GL_PACK_ALIGNMENT, 4);
  gl.PixelStorei(GL_PACK_ROW_LENGTH, static_cast<GLint>(picture.pitch / 4));
  gl.ReadPixels(0, 0, picture.width, picture.height, GL_RGBA, GL_UNSIGNED_BYTE, picture.pixels);
  for (int y = 0; y < picture.height / 2; ++y) {
    std::uint8_t* upper = picture.pixels + y * picture.pitch;
    std::uint8_t* lower = picture.pixels + (picture.height - 1 - y) * picture.pitch;
    std::swap_ranges(upper, upper + std::ptrdiff_t{4} * picture.width, lower);
  }
}

void Readback::forget() {
  framebuffer_.forget();
  colours_.forget();
}

}  // namespace depixel
