#pragma once

#include <glad/gl.h>

#include <glm/vec2.hpp>

#include "libdepixel/core/frame_view.hpp"

namespace depixel {

/// A texture of RGBA pixels on the current context, which must outlive it. Empty until uploaded or resized.
class Texture {
 public:
  explicit Texture(const GladGLContext& gl);
  Texture(const Texture&) = delete;
  Texture& operator=(const Texture&) = delete;
  ~Texture();

  /// Replaces the texture by a picture. Leaves it bound to the active unit.
  void upload(const FrameView& picture);
  /// Makes it that large; what it holds is left open. Leaves it bound to the active unit.
  void resize(glm::ivec2 size);
  void bind() const;
  unsigned name() const { return name_; }
  glm::ivec2 size() const { return size_; }

 private:
  const GladGLContext& gl_;
  unsigned name_ = 0;
  glm::ivec2 size_{0, 0};
};

/// A framebuffer that draws to a texture.
class TextureFramebuffer {
 public:
  explicit TextureFramebuffer(const GladGLContext& gl);
  TextureFramebuffer(const TextureFramebuffer&) = delete;
  TextureFramebuffer& operator=(const TextureFramebuffer&) = delete;
  ~TextureFramebuffer();

  void resize(glm::ivec2 size);
  unsigned name() const { return name_; }
  const Texture& texture() const { return texture_; }

 private:
  const GladGLContext& gl_;
  unsigned name_ = 0;
  Texture texture_;
};

}  // namespace depixel
