#include "filter/gl/gl_state.hpp"

#include <map>
#include <vector>

#include "filter/frame_filter.hpp"
#include "tests/filter/gl_fixture.hpp"
#include "tests/support/ascii_picture.hpp"

namespace depixel::test {
namespace {

constexpr GLenum kSwitches[] = {GL_BLEND,
                                GL_CULL_FACE,
                                GL_DEPTH_TEST,
                                GL_DITHER,
                                GL_SAMPLE_ALPHA_TO_COVERAGE,
                                GL_SAMPLE_COVERAGE,
                                GL_SCISSOR_TEST,
                                GL_STENCIL_TEST,
                                GL_COLOR_LOGIC_OP,
                                GL_FRAMEBUFFER_SRGB,
                                GL_POLYGON_OFFSET_FILL,
                                GL_SAMPLE_MASK,
                                GL_RASTERIZER_DISCARD};

/// Everything of a context's state that drawing might touch, by parameter; with several values, all of them.
constexpr std::pair<GLenum, int> kParameters[] = {{GL_VIEWPORT, 4},
                                                  {GL_SCISSOR_BOX, 4},
                                                  {GL_COLOR_WRITEMASK, 4},
                                                  {GL_COLOR_CLEAR_VALUE, 4},
                                                  {GL_CURRENT_PROGRAM, 1},
                                                  {GL_VERTEX_ARRAY_BINDING, 1},
                                                  {GL_ARRAY_BUFFER_BINDING, 1},
                                                  {GL_RENDERBUFFER_BINDING, 1},
                                                  {GL_DRAW_FRAMEBUFFER_BINDING, 1},
                                                  {GL_READ_FRAMEBUFFER_BINDING, 1},
                                                  {GL_PIXEL_UNPACK_BUFFER_BINDING, 1},
                                                  {GL_PIXEL_PACK_BUFFER_BINDING, 1},
                                                  {GL_ACTIVE_TEXTURE, 1},
                                                  {GL_UNPACK_ALIGNMENT, 1},
                                                  {GL_UNPACK_ROW_LENGTH, 1},
                                                  {GL_UNPACK_SKIP_ROWS, 1},
                                                  {GL_UNPACK_SKIP_PIXELS, 1},
                                                  {GL_UNPACK_SWAP_BYTES, 1},
                                                  {GL_PACK_ALIGNMENT, 1},
                                                  {GL_PACK_ROW_LENGTH, 1},
                                                  {GL_PACK_SKIP_ROWS, 1},
                                                  {GL_PACK_SKIP_PIXELS, 1},
                                                  {GL_PACK_SWAP_BYTES, 1},
                                                  {GL_POLYGON_MODE, 1},
                                                  {GL_BLEND_SRC_RGB, 1},
                                                  {GL_BLEND_DST_ALPHA, 1},
                                                  {GL_DEPTH_FUNC, 1},
                                                  {GL_CULL_FACE_MODE, 1}};

std::map<GLenum, std::vector<GLint>> state_of(const GladGLContext& gl) {
  std::map<GLenum, std::vector<GLint>> state;
  for (const GLenum name : kSwitches) state[name] = {gl.IsEnabled(name)};
  for (const auto& [name, count] : kParameters) {
    std::vector<GLint>& values = state[name];
    values.assign(4, 0);
    gl.GetIntegerv(name, values.data());
    values.resize(static_cast<std::size_t>(count));
  }
  GLint active = 0;
  gl.GetIntegerv(GL_ACTIVE_TEXTURE, &active);
  for (GLenum unit = 0; unit < 4; ++unit) {
    gl.ActiveTexture(GL_TEXTURE0 + unit);
    std::vector<GLint> bindings(2);
    gl.GetIntegerv(GL_TEXTURE_BINDING_2D, &bindings[0]);
    gl.GetIntegerv(GL_SAMPLER_BINDING, &bindings[1]);
    state[GL_TEXTURE0 + unit] = bindings;
  }
  gl.ActiveTexture(static_cast<GLenum>(active));
  return state;
}

/// Sets everything to something else than its initial value, and than what drawing needs.
void set_odd_state(const GladGLContext& gl) {
  for (const GLenum name : kSwitches) name == GL_DITHER ? gl.Disable(name) : gl.Enable(name);
  GLuint name = 0;
  for (GLuint unit = 0; unit < 4; ++unit) {
    gl.ActiveTexture(GL_TEXTURE0 + unit);
    gl.GenTextures(1, &name);
    gl.BindTexture(GL_TEXTURE_2D, name);
    gl.GenSamplers(1, &name);
    gl.SamplerParameteri(name, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    gl.BindSampler(unit, name);
  }
  gl.ActiveTexture(GL_TEXTURE3);
  gl.GenVertexArrays(1, &name);
  gl.BindVertexArray(name);
  for (const GLenum target : {GL_ARRAY_BUFFER, GL_PIXEL_PACK_BUFFER, GL_PIXEL_UNPACK_BUFFER}) {
    gl.GenBuffers(1, &name);
    gl.BindBuffer(target, name);
    gl.BufferData(target, 64, nullptr, GL_STATIC_DRAW);
  }
  gl.GenRenderbuffers(1, &name);
  gl.BindRenderbuffer(GL_RENDERBUFFER, name);
  gl.GenFramebuffers(1, &name);
  gl.BindFramebuffer(GL_READ_FRAMEBUFFER, name);
  gl.GenFramebuffers(1, &name);
  gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, name);
  gl.Viewport(3, 4, 5, 6);
  gl.Scissor(1, 1, 2, 2);
  gl.ColorMask(GL_FALSE, GL_TRUE, GL_FALSE, GL_TRUE);
  for (const GLenum pixel_store : {GL_UNPACK_ALIGNMENT, GL_PACK_ALIGNMENT}) gl.PixelStorei(pixel_store, 1);
  for (const GLenum pixel_store : {GL_UNPACK_ROW_LENGTH, GL_UNPACK_SKIP_ROWS, GL_UNPACK_SKIP_PIXELS,
                                   GL_PACK_ROW_LENGTH, GL_PACK_SKIP_ROWS, GL_PACK_SKIP_PIXELS}) {
    gl.PixelStorei(pixel_store, 7);
  }
  gl.PixelStorei(GL_UNPACK_SWAP_BYTES, GL_TRUE);
  gl.PixelStorei(GL_PACK_SWAP_BYTES, GL_TRUE);
  gl.PolygonMode(GL_FRONT_AND_BACK, GL_LINE);
  gl.BlendFuncSeparate(GL_ZERO, GL_ONE, GL_ZERO, GL_ONE);
  gl.DepthFunc(GL_NEVER);
  gl.StencilFunc(GL_NEVER, 0, 0);
  gl.SampleMaski(0, 0);
}

TEST(GlState, IsAsTheHostLeftIt) {
  const GlContext context;
  const GladGLContext& gl = context.gl;
  auto filter = FrameFilter::gl(context.context->loader());
  ASSERT_TRUE(filter) << filter.error().message;
  const TestFramebuffer framebuffer(gl, 16, 16);
  Picture picture(16, 16);
  set_odd_state(gl);
  ASSERT_EQ(gl.GetError(), unsigned{GL_NO_ERROR});
  const auto before = state_of(gl);
  for (const Target& target : {Target(GlFramebuffer{framebuffer.name()}), Target(picture.target())}) {
    ASSERT_TRUE((*filter)->submit(ascii_picture({"#.r.", "..#_", "_#..", "r.#."}).view(), {}));
    const auto drawn = (*filter)->draw(target, {0, 0, 16, 16}, {4, 4, 0, 0});
    ASSERT_TRUE(drawn) << drawn.error().message;
    EXPECT_EQ(state_of(gl), before);
  }
  EXPECT_EQ(gl.GetError(), unsigned{GL_NO_ERROR});

  // And what the host had set did not reach the picture.
  auto cpu = FrameFilter::cpu();
  ASSERT_TRUE(cpu->submit(ascii_picture({"#.r.", "..#_", "_#..", "r.#."}).view(), {}));
  Picture expected(16, 16);
  ASSERT_TRUE(cpu->draw(expected.target(), {0, 0, 16, 16}, {4, 4, 0, 0}));
  for (std::size_t i = 0; i < expected.pixels.size(); ++i) {
    EXPECT_NEAR(expected.pixels[i].a, picture.pixels[i].a, 4) << i;
    EXPECT_NEAR(expected.pixels[i].r * expected.pixels[i].a, picture.pixels[i].r * picture.pixels[i].a,
                4 * 255)
        << i;
  }
}

}  // namespace
}  // namespace depixel::test
