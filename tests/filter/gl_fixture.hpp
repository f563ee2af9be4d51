#pragma once

#include <glad/gl.h>
#include <gtest/gtest.h>

#include "apps/headless/context_kind.hpp"
#include "tests/support/picture.hpp"

namespace depixel {

inline void PrintTo(ContextKind kind, std::ostream* out) {
  *out << context_kind_names()[static_cast<std::size_t>(kind)];
}

}  // namespace depixel

namespace depixel::test {

/// A context, current, and its functions. Fails the test where there is none.
struct GlContext {
  explicit GlContext(std::optional<ContextKind> kind = {}, HeadlessContext::Wanted wanted = {}) {
    auto created = create_headless_context(kind, wanted);
    if (!created) throw std::runtime_error(created.error().message);
    context = std::move(*created);
    if (wanted.es) {
      gladLoadGLES2Context(&gl, context->loader());
    } else {
      gladLoadGLContext(&gl, context->loader());
    }
  }

  std::unique_ptr<HeadlessContext> context;
  GladGLContext gl{};
};

/// A framebuffer with a texture of its own, as a host may have.
class TestFramebuffer {
 public:
  TestFramebuffer(const GladGLContext& gl, int width, int height) : gl_(gl), width_(width), height_(height) {
    gl.GenTextures(1, &texture_);
    gl.BindTexture(GL_TEXTURE_2D, texture_);
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    gl.GenFramebuffers(1, &name_);
    gl.BindFramebuffer(GL_FRAMEBUFFER, name_);
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture_, 0);
    EXPECT_EQ(gl.CheckFramebufferStatus(GL_FRAMEBUFFER), unsigned{GL_FRAMEBUFFER_COMPLETE});
  }
  TestFramebuffer(const TestFramebuffer&) = delete;
  TestFramebuffer& operator=(const TestFramebuffer&) = delete;
  ~TestFramebuffer() {
    gl_.DeleteFramebuffers(1, &name_);
    gl_.DeleteTextures(1, &texture_);
  }

  unsigned name() const { return name_; }

  void clear(float red, float green, float blue, float alpha) const {
    gl_.BindFramebuffer(GL_FRAMEBUFFER, name_);
    gl_.ClearColor(red, green, blue, alpha);
    gl_.Clear(GL_COLOR_BUFFER_BIT);
  }

  /// What it holds, top row first.
  Picture read() const {
    Picture picture(width_, height_);
    gl_.BindFramebuffer(GL_FRAMEBUFFER, name_);
    for (int y = 0; y < height_; ++y) {
      gl_.ReadPixels(0, height_ - 1 - y, width_, 1, GL_RGBA, GL_UNSIGNED_BYTE, &picture.at(0, y));
    }
    return picture;
  }

 private:
  const GladGLContext& gl_;
  int width_, height_;
  GLuint texture_ = 0, name_ = 0;
};

}  // namespace depixel::test
