#pragma once

#include <glad/gl.h>

#include <utility>

namespace depixel {

/// An object of a context, deleted with its owner; empty by default. Moves, and is never copied.
/// \tparam Delete  gives its name back to the context.
template <void (*Delete)(const GladGLContext&, GLuint)>
class GlObject {
 public:
  GlObject() = default;
  /// \param gl  the context's functions; must outlive the object.
  GlObject(const GladGLContext& gl, GLuint name) : gl_(&gl), name_(name) {}
  GlObject(GlObject&& other) noexcept : gl_(other.gl_), name_(std::exchange(other.name_, 0)) {}
  GlObject& operator=(GlObject&& other) noexcept {
    std::swap(gl_, other.gl_);
    std::swap(name_, other.name_);
    return *this;
  }
  ~GlObject() {
    if (name_ != 0) Delete(*gl_, name_);
  }

  GLuint name() const { return name_; }
  explicit operator bool() const { return name_ != 0; }
  /// Lets go of an object that was lost with its context.
  void forget() { name_ = 0; }

 private:
  const GladGLContext* gl_ = nullptr;
  GLuint name_ = 0;
};

namespace gl_delete {
inline void shader(const GladGLContext& gl, GLuint name) {
  gl.DeleteShader(name);
}
inline void program(const GladGLContext& gl, GLuint name) {
  gl.DeleteProgram(name);
}
inline void texture(const GladGLContext& gl, GLuint name) {
  gl.DeleteTextures(1, &name);
}
inline void vertex_array(const GladGLContext& gl, GLuint name) {
  gl.DeleteVertexArrays(1, &name);
}
inline void buffer(const GladGLContext& gl, GLuint name) {
  gl.DeleteBuffers(1, &name);
}
inline void framebuffer(const GladGLContext& gl, GLuint name) {
  gl.DeleteFramebuffers(1, &name);
}
inline void renderbuffer(const GladGLContext& gl, GLuint name) {
  gl.DeleteRenderbuffers(1, &name);
}
}  // namespace gl_delete

using GlShader = GlObject<gl_delete::shader>;
using GlProgram = GlObject<gl_delete::program>;
using GlTexture = GlObject<gl_delete::texture>;
using GlVertexArray = GlObject<gl_delete::vertex_array>;
using GlBuffer = GlObject<gl_delete::buffer>;
using GlFramebufferObject = GlObject<gl_delete::framebuffer>;
using GlRenderbuffer = GlObject<gl_delete::renderbuffer>;

}  // namespace depixel
