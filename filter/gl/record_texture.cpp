#include "filter/gl/record_texture.hpp"

#include <algorithm>

namespace depixel {
namespace {

constexpr std::size_t kRecordBytes = 16;
constexpr int kRowsAtOnce = 64;  ///< a growing texture's height is a multiple of this, and half as much again

void send(const GladGLContext& gl, int x, int y, int width, int height, const std::byte* from) {
  if (width > 0 && height > 0) {
    gl.TexSubImage2D(GL_TEXTURE_2D, 0, x, y, width, height, GL_RGBA_INTEGER, GL_UNSIGNED_INT, from);
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

std::size_t RecordTexture::upload(const GladGLContext& gl, std::span<const std::byte> records,
                                  std::size_t first) {
  const auto count = static_cast<int>(records.size() / kRecordBytes);
  const int rows = (count + kColumns - 1) / kColumns;
  if (rows > height_ || !texture_) {
    const int grown = (rows + rows / 2) / kRowsAtOnce * kRowsAtOnce + kRowsAtOnce;
    reserve(gl, kColumns, std::max(rows, std::min(grown, max_rows_)));
    first = 0;
  } else {
    gl.BindTexture(GL_TEXTURE_2D, texture_.name());
  }
  // The rest of a row, whole rows, the beginning of a row.
  for (int i = static_cast<int>(first); i < count;) {
    const int width = std::min(kColumns - i % kColumns, count - i);
    const int height = width == kColumns ? (count - i) / kColumns : 1;
    send(gl, i % kColumns, i / kColumns, width, height, records.data() + i * kRecordBytes);
    i += width * height;
  }
  return records.size() - first * kRecordBytes;
}

std::size_t RecordTexture::upload(const GladGLContext& gl, std::span<const std::byte> records, int width,
                                  int height) {
  if (height != height_) width_ = 0;  // another picture: the texture is made anew
  reserve(gl, width, height);
  send(gl, 0, 0, width, height, records.data());
  return records.size();
}

std::size_t RecordTexture::upload_box(const GladGLContext& gl, std::span<const std::byte> records,
                                      const TileBox& box) {
  gl.BindTexture(GL_TEXTURE_2D, texture_.name());
  const std::size_t first = std::size_t(box.north) * width_ + box.west;
  gl.PixelStorei(GL_UNPACK_ROW_LENGTH, width_);
  send(gl, box.west, box.north, box.width(), box.height(), records.data() + first * kRecordBytes);
  gl.PixelStorei(GL_UNPACK_ROW_LENGTH, 0);
  return static_cast<std::size_t>(box.area()) * kRecordBytes;
}

}  // namespace depixel
