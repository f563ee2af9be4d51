#include "apps/player/quad_painter.hpp"

#include <utility>

#include "filter/gl/gl_program.hpp"

namespace depixel {
namespace {

// The viewport is the quad; the texture's first row is its top.
constexpr const char* kVertexShader = R"glsl(uniform vec4 part;  // low, high
out vec2 position;
void main() {
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1);
  position = mix(part.xy, part.zw, vec2(corner.x, 1.0 - corner.y));
  gl_Position = vec4(corner * 2.0 - 1.0, 0.0, 1.0);
}
)glsl";

constexpr const char* kFragmentShader = R"glsl(uniform sampler2D picture;
in vec2 position;
out vec4 colour;
void main() { colour = texture(picture, position); }
)glsl";

}  // namespace

tl::expected<QuadPainter, Error> QuadPainter::make(const GladGLContext& gl) {
  auto program = link_program(gl, kVertexShader, kFragmentShader);
  if (!program) return tl::unexpected(program.error());
  return QuadPainter(gl, std::move(*program));
}

QuadPainter::QuadPainter(const GladGLContext& gl, GlProgram program)
    : gl_(&gl), program_(std::move(program)), part_location_(gl.GetUniformLocation(program_.name(), "part")) {
  unsigned name = 0;
  gl.GenVertexArrays(1, &name);
  no_vertices_ = GlVertexArray(gl, name);
}

void QuadPainter::draw(const Texture& texture, const TexturePart& part, const PixelRect& target,
                       int window_height, bool smooth) const {
  if (target.empty()) return;
  gl_->Viewport(target.x, window_height - target.y - target.height, target.width, target.height);
  gl_->UseProgram(program_.name());
  gl_->BindVertexArray(no_vertices_.name());
  gl_->ActiveTexture(GL_TEXTURE0);
  texture.bind();
  const int filter = smooth ? GL_LINEAR : GL_NEAREST;
  gl_->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
  gl_->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
  const int wrap = part.repeats ? GL_REPEAT : GL_CLAMP_TO_EDGE;
  gl_->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, wrap);
  gl_->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, wrap);
  gl_->Uniform4f(part_location_, float(part.low.x), float(part.low.y), float(part.high.x),
                 float(part.high.y));
  gl_->Enable(GL_BLEND);
  gl_->BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  gl_->DrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  gl_->Disable(GL_BLEND);
  gl_->BindVertexArray(0);
  gl_->UseProgram(0);
}

}  // namespace depixel
