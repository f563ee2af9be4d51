#include "filter/gl/readback.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstdint>
#include <cstring>

#include "filter/red_blue.hpp"

namespace depixel {
namespace {

constexpr GLuint64 kLongestWaitNs = 5'000'000'000;

void copy_row(const std::uint8_t* rgba, int width, ChannelOrder order, std::uint8_t* to) {
  if (order == ChannelOrder::rgba) {
    std::memcpy(to, rgba, 4 * static_cast<std::size_t>(width));
    return;
  }
  for (int x = 0; x < width; ++x, rgba += 4, to += 4) {
    std::uint32_t pixel;
    std::memcpy(&pixel, rgba, sizeof pixel);
    pixel = swap_red_and_blue(pixel);
    std::memcpy(to, &pixel, sizeof pixel);
  }
}

}  // namespace

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

void Readback::restrict_to(const GladGLContext& gl, const PictureView& picture, Rows rows) {
  gl.Enable(GL_SCISSOR_TEST);
  gl.Scissor(0, picture.height - rows.end, picture.width, rows.end - rows.first);
}

void Readback::request(const GladGLContext& gl, const PictureView& picture, Rows rows) {
  const std::size_t row_bytes = 4 * static_cast<std::size_t>(picture.width);
  const std::size_t size = row_bytes * static_cast<std::size_t>(picture.height);
  if (!bytes_) {
    GLuint name = 0;
    gl.GenBuffers(1, &name);
    bytes_ = GlBuffer(gl, name);
    capacity_ = 0;
  }
  gl.BindBuffer(GL_PIXEL_PACK_BUFFER, bytes_.name());
  if (size > capacity_) {
    gl.BufferData(GL_PIXEL_PACK_BUFFER, static_cast<GLsizeiptr>(size), nullptr, GL_STREAM_READ);
    capacity_ = size;
  }
  const int bottom = picture.height - rows.end;
  gl.ReadPixels(0, bottom, picture.width, rows.end - rows.first, GL_RGBA, GL_UNSIGNED_BYTE,
                reinterpret_cast<void*>(row_bytes * static_cast<std::size_t>(bottom)));
  bands_.push_back({rows, gl.FenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0)});
}

tl::expected<void, Error> Readback::take(const GladGLContext& gl, const PictureView& picture) {
  const std::size_t row_bytes = 4 * static_cast<std::size_t>(picture.width);
  bool has_all = true;
  for (const Band& band : bands_) {
    gl.ClientWaitSync(band.drawn, GL_SYNC_FLUSH_COMMANDS_BIT, kLongestWaitNs);
    gl.DeleteSync(band.drawn);
    const int rows = band.rows.end - band.rows.first;
    const auto* bytes = static_cast<const std::uint8_t*>(gl.MapBufferRange(
        GL_PIXEL_PACK_BUFFER,
        static_cast<GLintptr>(row_bytes * static_cast<std::size_t>(picture.height - band.rows.end)),
        static_cast<GLsizeiptr>(row_bytes * static_cast<std::size_t>(rows)), GL_MAP_READ_BIT));
    if (bytes == nullptr) {
      has_all = false;
      continue;
    }
    for (int y = band.rows.end - 1; y >= band.rows.first; --y, bytes += row_bytes) {
      copy_row(bytes, picture.width, picture.order, picture.pixels + y * picture.pitch);
    }
    has_all = gl.UnmapBuffer(GL_PIXEL_PACK_BUFFER) == GL_TRUE && has_all;
  }
  bands_.clear();
  if (!has_all) return tl::unexpected(Error{"OpenGL does not give back what it has drawn."});
  return {};
}

void Readback::forget() {
  framebuffer_.forget();
  colours_.forget();
  bytes_.forget();
  bands_.clear();
}

}  // namespace depixel
