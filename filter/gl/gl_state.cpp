#include "filter/gl/gl_state.hpp"

namespace depixel {
namespace {

/// A capability and whether OpenGL ES has it too; all are off for drawing.
struct Switch {
  GLenum name;
  bool in_es;
};

constexpr std::array<Switch, 12> kSwitches{{
    {GL_BLEND, true},
    {GL_CULL_FACE, true},
    {GL_DEPTH_TEST, true},
    {GL_DITHER, true},
    {GL_RASTERIZER_DISCARD, true},
    {GL_SAMPLE_ALPHA_TO_COVERAGE, true},
    {GL_SAMPLE_COVERAGE, true},
    {GL_SCISSOR_TEST, true},
    {GL_STENCIL_TEST, true},
    {GL_COLOR_LOGIC_OP, false},
    {GL_FRAMEBUFFER_SRGB, false},
    {GL_SAMPLE_MASK, false},
}};

/// A parameter of pixel transfers and its initial value, which transfers here rely on.
struct PixelStore {
  GLenum name;
  GLint value;
  bool in_es;
};

constexpr std::array<PixelStore, 10> kPixelStores{{
    {GL_UNPACK_ALIGNMENT, 4, true},
    {GL_UNPACK_ROW_LENGTH, 0, true},
    {GL_UNPACK_SKIP_ROWS, 0, true},
    {GL_UNPACK_SKIP_PIXELS, 0, true},
    {GL_PACK_ALIGNMENT, 4, true},
    {GL_PACK_ROW_LENGTH, 0, true},
    {GL_PACK_SKIP_ROWS, 0, true},
    {GL_PACK_SKIP_PIXELS, 0, true},
    {GL_UNPACK_SWAP_BYTES, 0, false},
    {GL_PACK_SWAP_BYTES, 0, false},
}};

GLuint name(GLint value) {
  return static_cast<GLuint>(value);
}

}  // namespace

GlStateGuard::GlStateGuard(const GladGLContext& gl) : gl_(gl) {
  const bool is_desktop = gl.VERSION_3_3 != 0;
  gl.GetIntegerv(GL_VIEWPORT, viewport_.data());
  gl.GetIntegerv(GL_SCISSOR_BOX, scissor_box_.data());
  gl.GetBooleanv(GL_COLOR_WRITEMASK, color_mask_.data());
  gl.GetIntegerv(GL_CURRENT_PROGRAM, &program_);
  gl.GetIntegerv(GL_VERTEX_ARRAY_BINDING, &vertex_array_);
  gl.GetIntegerv(GL_RENDERBUFFER_BINDING, &renderbuffer_);
  gl.GetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &draw_framebuffer_);
  gl.GetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &read_framebuffer_);
  gl.GetIntegerv(GL_PIXEL_UNPACK_BUFFER_BINDING, &unpack_buffer_);
  gl.GetIntegerv(GL_PIXEL_PACK_BUFFER_BINDING, &pack_buffer_);
  gl.GetIntegerv(GL_ACTIVE_TEXTURE, &active_unit_);
  for (int i = 0; i < kUnits; ++i) {
    gl.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(i));
    gl.GetIntegerv(GL_TEXTURE_BINDING_2D, &units_[i].texture);
    gl.GetIntegerv(GL_SAMPLER_BINDING, &units_[i].sampler);
    gl.BindSampler(static_cast<GLuint>(i), 0);
  }
  for (std::size_t i = 0; i < kSwitchCount; ++i) {
    const Switch& s = kSwitches[i];
    if (!is_desktop && !s.in_es) continue;
    switches_[i] = gl.IsEnabled(s.name);
    if (switches_[i] == GL_TRUE) gl.Disable(s.name);
  }
  for (std::size_t i = 0; i < kPixelStoreCount; ++i) {
    if (!is_desktop && !kPixelStores[i].in_es) continue;
    gl.GetIntegerv(kPixelStores[i].name, &pixel_stores_[i]);
    gl.PixelStorei(kPixelStores[i].name, kPixelStores[i].value);
  }
  if (is_desktop) {
    gl.GetIntegerv(GL_POLYGON_MODE, polygon_mode_.data());
    gl.PolygonMode(GL_FRONT_AND_BACK, GL_FILL);
  }
  gl.BindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
  gl.BindBuffer(GL_PIXEL_PACK_BUFFER, 0);
  gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

GlStateGuard::~GlStateGuard() {
  const bool is_desktop = gl_.VERSION_3_3 != 0;
  if (is_desktop) gl_.PolygonMode(GL_FRONT_AND_BACK, name(polygon_mode_[0]));
  for (std::size_t i = 0; i < kPixelStoreCount; ++i) {
    if (is_desktop || kPixelStores[i].in_es) gl_.PixelStorei(kPixelStores[i].name, pixel_stores_[i]);
  }
  for (std::size_t i = 0; i < kSwitchCount; ++i) {
    if (switches_[i] == GL_TRUE) gl_.Enable(kSwitches[i].name);
  }
  for (int i = 0; i < kUnits; ++i) {
    gl_.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(i));
    gl_.BindTexture(GL_TEXTURE_2D, name(units_[i].texture));
    gl_.BindSampler(static_cast<GLuint>(i), name(units_[i].sampler));
  }
  gl_.ActiveTexture(name(active_unit_));
  gl_.BindBuffer(GL_PIXEL_UNPACK_BUFFER, name(unpack_buffer_));
  gl_.BindBuffer(GL_PIXEL_PACK_BUFFER, name(pack_buffer_));
  gl_.BindFramebuffer(GL_DRAW_FRAMEBUFFER, name(draw_framebuffer_));
  gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, name(read_framebuffer_));
  gl_.BindRenderbuffer(GL_RENDERBUFFER, name(renderbuffer_));
  gl_.BindVertexArray(name(vertex_array_));
  gl_.UseProgram(name(program_));
  gl_.ColorMask(color_mask_[0], color_mask_[1], color_mask_[2], color_mask_[3]);
  gl_.Scissor(scissor_box_[0], scissor_box_[1], scissor_box_[2], scissor_box_[3]);
  gl_.Viewport(viewport_[0], viewport_[1], viewport_[2], viewport_[3]);
}

}  // namespace depixel
