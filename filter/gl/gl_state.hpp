#pragma once

#include <glad/gl.h>

#include <array>

namespace depixel {

/// Keeps what the filter changes of a context's state, sets it to what drawing needs, and puts it back at the
/// end of its own life.
class GlStateGuard {
 public:
  explicit GlStateGuard(const GladGLContext& gl);
  GlStateGuard(const GlStateGuard&) = delete;
  GlStateGuard& operator=(const GlStateGuard&) = delete;
  ~GlStateGuard();

  static constexpr int kUnits = 3;  ///< texture units that the filter uses, from 0 on

 private:
  static constexpr std::size_t kSwitchCount = 12;
  static constexpr std::size_t kPixelStoreCount = 10;

  struct Unit {
    GLint texture = 0, sampler = 0;
  };

  const GladGLContext& gl_;
  std::array<GLboolean, kSwitchCount> switches_{};
  std::array<GLint, kPixelStoreCount> pixel_stores_{};
  std::array<Unit, kUnits> units_;
  std::array<GLint, 4> viewport_{}, scissor_box_{};
  std::array<GLboolean, 4> color_mask_{};
  std::array<GLint, 2> polygon_mode_{};
  GLint active_unit_ = 0, program_ = 0, vertex_array_ = 0, renderbuffer_ = 0;
  GLint draw_framebuffer_ = 0, read_framebuffer_ = 0;
  GLint unpack_buffer_ = 0, pack_buffer_ = 0;
};

}  // namespace depixel
