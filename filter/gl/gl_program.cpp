#include "filter/gl/gl_program.hpp"

#include <fmt/core.h>

#include <array>
#include <string>

namespace depixel {
namespace {

constexpr std::string_view kDesktopHead = "#version 330 core\n";
constexpr std::string_view kEsHead = "#version 300 es\nprecision highp float;\nprecision highp int;\n";

using GetParameter = PFNGLGETSHADERIVPROC;
using GetLog = PFNGLGETSHADERINFOLOGPROC;

/// What the driver says of a shader or a program, on one line.
std::string driver_text(GetParameter get, GetLog get_log, GLuint name) {
  GLint length = 0;
  get(name, GL_INFO_LOG_LENGTH, &length);
  std::string text(static_cast<std::size_t>(std::max(length, 1)), '\0');
  GLsizei written = 0;
  get_log(name, length, &written, text.data());
  text.resize(static_cast<std::size_t>(written));
  while (!text.empty() && (text.back() == '\n' || text.back() == ' ')) text.pop_back();
  for (char& c : text) {
    if (c == '\n') c = ' ';
  }
  return text.empty() ? "no reason given" : text;
}

tl::expected<GlShader, Error> compile(const GladGLContext& gl, GLenum kind, std::string_view head,
                                      std::string_view source) {
  GlShader shader(gl, gl.CreateShader(kind));
  const std::array<const GLchar*, 2> texts{head.data(), source.data()};
  const std::array<GLint, 2> lengths{static_cast<GLint>(head.size()), static_cast<GLint>(source.size())};
  gl.ShaderSource(shader.name(), 2, texts.data(), lengths.data());
  gl.CompileShader(shader.name());
  GLint compiled = 0;
  gl.GetShaderiv(shader.name(), GL_COMPILE_STATUS, &compiled);
  if (compiled == GL_TRUE) return shader;
  return tl::unexpected(Error{fmt::format("OpenGL does not compile the {} shader: {}.",
                                          kind == GL_VERTEX_SHADER ? "vertex" : "fragment",
                                          driver_text(gl.GetShaderiv, gl.GetShaderInfoLog, shader.name()))});
}

}  // namespace

tl::expected<GlProgram, Error> link_program(const GladGLContext& gl, std::string_view vertex_source,
                                            std::string_view fragment_source) {
  const std::string_view head = gl.VERSION_3_3 != 0 ? kDesktopHead : kEsHead;
  const auto vertex = compile(gl, GL_VERTEX_SHADER, head, vertex_source);
  if (!vertex) return tl::unexpected(vertex.error());
  const auto fragment = compile(gl, GL_FRAGMENT_SHADER, head, fragment_source);
  if (!fragment) return tl::unexpected(fragment.error());
  GlProgram program(gl, gl.CreateProgram());
  gl.AttachShader(program.name(), vertex->name());
  gl.AttachShader(program.name(), fragment->name());
  gl.LinkProgram(program.name());
  GLint linked = 0;
  gl.GetProgramiv(program.name(), GL_LINK_STATUS, &linked);
  if (linked == GL_TRUE) return program;
  return tl::unexpected(
      Error{fmt::format("OpenGL does not link the shaders: {}.",
                        driver_text(gl.GetProgramiv, gl.GetProgramInfoLog, program.name()))});
}

}  // namespace depixel
