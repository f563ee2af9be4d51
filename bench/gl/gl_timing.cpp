#include "bench/gl/gl_timing.hpp"

#include <stdexcept>
#include <vector>

#include "bench/common/median.hpp"
#include "filter/gl/gl_program.hpp"

namespace depixel::bench {
namespace {

constexpr const char* kVertexShader =
    "out vec2 place;\n"
    "void main() {\n"
    "  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1);\n"
    "  place = vec2(2.0 * corner.x, 1.0 - 2.0 * corner.y);\n"
    "  gl_Position = vec4(4.0 * corner - 1.0, 0.0, 1.0);\n"
    "}\n";
constexpr const char* kFragmentShader =
    "in vec2 place;\n"
    "uniform sampler2D frame;\n"
    "out vec4 colour;\n"
    "void main() { colour = texture(frame, place); }\n";

void check(const tl::expected<void, Error>& result) {
  if (!result) throw std::runtime_error(result.error().message);
}

}  // namespace

GlTimer::GlTimer(std::optional<ContextKind> kind) {
  auto context = create_headless_context(kind);
  if (!context) throw std::runtime_error(context.error().message);
  context_ = std::move(*context);
  gladLoadGLContext(&gl_, context_->loader());
  auto filter = FrameFilter::gl(context_->loader());
  if (!filter) throw std::runtime_error(filter.error().message);
  filter_ = std::move(*filter);

  auto program = link_program(gl_, kVertexShader, kFragmentShader);
  if (!program) throw std::runtime_error(program.error().message);
  program_ = std::move(*program);
  gl_.GenVertexArrays(1, &vertices_);
  gl_.GenTextures(1, &texture_);
  gl_.GenFramebuffers(1, &framebuffer_);
  gl_.GenRenderbuffers(1, &colours_);
}

GlTimer::~GlTimer() {
  gl_.DeleteVertexArrays(1, &vertices_);
  gl_.DeleteTextures(1, &texture_);
  gl_.DeleteFramebuffers(1, &framebuffer_);
  gl_.DeleteRenderbuffers(1, &colours_);
}

void GlTimer::resize(int width, int height) {
  gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  gl_.BindRenderbuffer(GL_RENDERBUFFER, colours_);
  gl_.RenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, width, height);
  gl_.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, colours_);
  if (gl_.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
    throw std::runtime_error("There is no framebuffer of that size.");
  }
}

void GlTimer::upload(const FrameView& frame) {
  gl_.BindTexture(GL_TEXTURE_2D, texture_);
  gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, frame.width, frame.height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 frame.pixels);
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
}

void GlTimer::draw_nearest(int width, int height) {
  gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  gl_.Viewport(0, 0, width, height);
  gl_.UseProgram(program_.name());
  gl_.BindVertexArray(vertices_);
  gl_.BindTexture(GL_TEXTURE_2D, texture_);
  gl_.DrawArrays(GL_TRIANGLES, 0, 3);
  gl_.Finish();
}

void GlTimer::draw_filtered(const FrameView& frame, int width, int height) {
  const View view{double(width) / frame.width, double(height) / frame.height, 0, 0};
  check(filter_->draw(GlFramebuffer{framebuffer_}, {0, 0, width, height}, view));
  gl_.Finish();
}

void GlTimer::draw(const FrameView& frame, const View& view, Picture& picture) {
  check(filter_->submit(frame, {}));
  check(filter_->draw(picture.target(), {0, 0, picture.width(), picture.height()}, view));
}

GlTiming GlTimer::time(const FrameView& frame, int out_width, int out_height, double seconds) {
  constexpr int kMinRounds = 5;
  resize(out_width, out_height);
  upload(frame);
  check(filter_->submit(frame, {}));
  draw_filtered(frame, out_width, out_height);
  draw_nearest(out_width, out_height);

  std::vector<double> nearest, draw, vectorize, prepare;
  GlTiming timing;
  // A frame of another size in between: nothing is known then of the one before.
  constexpr Rgba kPixel{};
  const FrameView other{reinterpret_cast<const std::uint8_t*>(&kPixel), 1, 1, sizeof kPixel};
  repeat_for(seconds, kMinRounds, [&] {
    check(filter_->submit(other, {}));
    check(filter_->submit(frame, {}));
    vectorize.push_back(double(filter_->stats().submit_ns) * 1e-6);
    draw_filtered(frame, out_width, out_height);
    const FilterStats& stats = filter_->stats();
    prepare.push_back(double(stats.prepare_ns) * 1e-6);
    timing.lines = stats.lines;
    timing.upload_bytes = stats.upload_bytes;
    draw.push_back(time_ms([&] { draw_filtered(frame, out_width, out_height); }));
    nearest.push_back(time_ms([&] { draw_nearest(out_width, out_height); }));
  });
  timing.nearest_ms = median(nearest);
  timing.draw_ms = median(draw);
  timing.vectorize_ms = median(vectorize);
  timing.prepare_ms = median(prepare);
  return timing;
}

}  // namespace depixel::bench
