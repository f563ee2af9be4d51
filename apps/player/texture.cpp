#include "apps/player/texture.hpp"

namespace depixel {

Texture::Texture(const GladGLContext& gl) : gl_(gl) {
  gl_.GenTextures(1, &name_);
}

Texture::~Texture() {
  gl_.DeleteTextures(1, &name_);
}

void Texture::bind() const {
  gl_.BindTexture(GL_TEXTURE_2D, name_);
}

void Texture::resize(glm::ivec2 size) {
  bind();
  if (size == size_) return;
  size_ = size;
  gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, size.x, size.y, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
}

void Texture::upload(const FrameView& picture) {
  resize({picture.width, picture.height});
  gl_.PixelStorei(GL_UNPACK_ALIGNMENT, 4);
  gl_.PixelStorei(GL_UNPACK_ROW_LENGTH, static_cast<int>(picture.pitch / 4));
  gl_.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, picture.width, picture.height, GL_RGBA, GL_UNSIGNED_BYTE,
                    picture.pixels);
  gl_.PixelStorei(GL_UNPACK_ROW_LENGTH, 0);
}

TextureFramebuffer::TextureFramebuffer(const GladGLContext& gl) : gl_(gl), texture_(gl) {
  gl_.GenFramebuffers(1, &name_);
}

TextureFramebuffer::~TextureFramebuffer() {
  gl_.DeleteFramebuffers(1, &name_);
}

void TextureFramebuffer::resize(glm::ivec2 size) {
  if (size == texture_.size()) return;
  texture_.resize(size);
  gl_.BindFramebuffer(GL_FRAMEBUFFER, name_);
  gl_.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture_.name(), 0);
  gl_.BindFramebuffer(GL_FRAMEBUFFER, 0);
}

}  // namespace depixel
