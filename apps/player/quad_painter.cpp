#include "apps/player/quad_painter.hpp"

#include <fmt/format.h>

#include <array>
#include <string>

namespace depixel {
namespace {

// The viewport is the quad; the texture's first row is its top.
constexpr const char* kVertexShader = R"glsl(#version 330 core
uniform vec4 part;  // low, high
out vec2 position;
void main() {
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1);
  position = mix(part.xy, part.zw, vec2(corner.x, 1.0 - corner.y));
  gl_Position = vec4(corner * 2.0 - 1.0, 0.0, 1.0);
}
)glsl";

constexpr const char* kFragmentShader = R"glsl(#version 330 core
uniform sampler2D picture;
in vec2 position;
out vec4 colour;
void main() { colour = texture(picture, position); }
)glsl";

void attach(const GladGLContext& gl, unsigned program, GLenum kind, const char* source) {
  const unsigned shader = gl.CreateShader(kind);
  gl.ShaderSource(shader, 1, &source, nullptr);
  gl.CompileShader(shader);
  gl.AttachShader(program, shader);
  gl.DeleteShader(shader);  // once the program is
}

}  // namespace

tl::expected<std::unique_ptr<QuadPainter>, Error> QuadPainter::make(const GladGLContext& gl) {
  std::unique_ptr<QuadPainter> painter(new QuadPainter(gl));
  if (auto linked = painter->link(); !linked) return tl::unexpected(linked.error());
  return painter;
}

tl::expected<void, Error> QuadPainter::link() {
  gl_.GenVertexArrays(1, &vertex_array_);
  program_ = gl_.CreateProgram();
  attach(gl_, program_, GL_VERTEX_SHADER, kVertexShader);
  attach(gl_, program_, GL_FRAGMENT_SHADER, kFragmentShader);
  gl_.LinkProgram(program_);
  int linked = 0;
  gl_.GetProgramiv(program_, GL_LINK_STATUS, &linked);
  part_location_ = gl_.GetUniformLocation(program_, "part");
  if (linked == GL_TRUE) return {};
  std::array<char, 512> log{};
  gl_.GetProgramInfoLog(program_, static_cast<int>(log.size()) - 1, nullptr, log.data());
  std::string text(log.data());
  return tl::unexpected(Error{fmt::format("OpenGL refuses a shader: {}.", text.substr(0, text.find('\n')))});
}

QuadPainter::~QuadPainter() {
  gl_.DeleteProgram(program_);
  gl_.DeleteVertexArrays(1, &vertex_array_);
}

void QuadPainter::draw(const Texture& texture, const TexturePart& part, const PixelRect& target,
                       int window_height, bool smooth) const {
  if (target.empty()) return;
  gl_.Viewport(target.x, window_height - target.y - target.height, target.width, target.height);
  gl_.UseProgram(program_);
  gl_.BindVertexArray(vertex_array_);
  gl_.ActiveTexture(GL_TEXTURE0);
  texture.bind();
  const int filter = smooth ? GL_LINEAR : GL_NEAREST;
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
  const int wrap = part.repeats ? GL_REPEAT : GL_CLAMP_TO_EDGE;
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, wrap);
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, wrap);
  gl_.Uniform4f(part_location_, float(part.low.x), float(part.low.y), float(part.high.x), float(part.high.y));
  gl_.Enable(GL_BLEND);
  gl_.BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  gl_.DrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  gl_.Disable(GL_BLEND);
  gl_.BindVertexArray(0);
  gl_.UseProgram(0);
}

}  // namespace depixel
