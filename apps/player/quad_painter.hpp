#pragma once

#include <glad/gl.h>

#include <glm/vec2.hpp>
#include <tl/expected.hpp>

#include "apps/player/texture.hpp"
#include "apps/player/view_control.hpp"
#include "filter/gl/gl_object.hpp"
#include "libdepixel/core/error.hpp"

namespace depixel {

/// A rectangle of a texture, 0..1 from its first row on.
struct TexturePart {
  glm::dvec2 low{0, 0}, high{1, 1};
  bool repeats = false;  ///< beyond 1; else the last pixels go on
};

/// Draws textures of straight alpha over rectangles of the window.
class QuadPainter {
 public:
  static tl::expected<QuadPainter, Error> make(const GladGLContext& gl);

  /// \param target  in the window's framebuffer; y counts from the top.
  /// \param window_height  of that framebuffer.
  /// \param smooth  bilinear instead of nearest.
  void draw(const Texture& texture, const TexturePart& part, const PixelRect& target, int window_height,
            bool smooth) const;

 private:
  QuadPainter(const GladGLContext& gl, GlProgram program);

  const GladGLContext* gl_;
  GlProgram program_;
  GlVertexArray no_vertices_;
  int part_location_;
};

}  // namespace depixel
