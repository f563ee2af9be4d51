#include "filter/gl/record_texture.hpp"

#include <algorithm>

namespace depixel {
namespace {

constexpr std::size_t kRecordBytes = 16;
constexpr int kRowsAtOnce = 64;  ///< a growing texture's height is a multiple of this, and half as much again

void send(const GladGLContext& gl, int y, int width, int height, const std::byte* from) {
  if (width > 0 && height > 0) {
    gl.TexSubImage2D(GL_TEXTURE_2D, 0, 0, y, width, height, GL_RGBA_INTEGER, GL_UNSIGNED_INT, from);
  }
}

}  // namespace

void RecordTexture::reserve(const GladGLContext& gl, int width, int height) {
  if (!texture_) {
    GLuint name = 0;
    gl.GenTextures(1, &name);
    texture_ = GlTexture(gl, name);
    width_ = height_ = 0;
  }
  gl.BindTexture(GL_TEXTURE_2D, texture_.name());
  if (width == width_ && height <= height_) return;
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32UI, width, height, 0, GL_RGBA_INTEGER, GL_UNSIGNED_INT, nullptr);
  width_ = width;
  height_ = height;
}

std::size_t RecordTexture::upload(const GladGLContext& gl, std::span<const std::byte> records) {
  const auto count = static_cast<int>(records.size() / kRecordBytes);
  const int full_rows = count / kColumns, rest = count % kColumns;
  const int rows = full_rows + (rest > 0 ? 1 : 0);
  if (rows > height_ || !texture_) {
    const int grown = (rows + rows / 2) / kRowsAtOnce * kRowsAtOnce + kRowsAtOnce;
    reserve(gl, kColumns, std::max(rows, std::min(grown, max_rows_)));
  } else {
    gl.BindTexture(GL_TEXTURE_2D, texture_.name());
  }
  send(gl, 0, kColumns, full_rows, records.data());
  send(gl, full_rows, rest, 1, records.data() + std::size_t(full_rows) * kColumns * kRecordBytes);
  return records.size();
}

std::size_t RecordTexture::upload(const GladGLContext& gl, std::span<const std::byte> records, int width,
                                  int height) {
  if (height != height_) width_ = 0;  // another picture: the texture is made anew
  reserve(gl, width, height);
  send(gl, 0, width, height, records.data());
  return records.size();
}

}  // namespace depixel
