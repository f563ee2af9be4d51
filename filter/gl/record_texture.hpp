#pragma once

#include <cstddef>
#include <span>

#include "filter/gl/gl_object.hpp"
#include "libdepixel/raster/tile_box.hpp"

namespace depixel {

/// A texture of records of four 32-bit words each, in rows of a power of two, which grows as needed: a list
/// that shaders read by number. (Buffer textures would be one, but OpenGL ES 3.0 has none.)
class RecordTexture {
 public:
  /// \param max_rows  of a texture of the context.
  explicit RecordTexture(int max_rows) : max_rows_(max_rows) {}

  static constexpr int kColumnBits = 11;
  static constexpr int kColumns = 1 << kColumnBits;

  /// Copies records to the texture, which is bound to the active unit.
  /// \param first  those before it are what the texture holds; it is sent them all the same if it has to
  /// grow. \return the bytes that were sent.
  std::size_t upload(const GladGLContext& gl, std::span<const std::byte> records, std::size_t first = 0);
  /// The same for rows of a width of their own, as of a picture.
  std::size_t upload(const GladGLContext& gl, std::span<const std::byte> records, int width, int height);
  /// Copies a box of such rows to the texture, which is bound to the active unit and holds the others.
  std::size_t upload_box(const GladGLContext& gl, std::span<const std::byte> records, const TileBox& box);

  GLuint name() const { return texture_.name(); }
  void forget() { texture_.forget(); }

 private:
  void reserve(const GladGLContext& gl, int width, int height);

  int max_rows_;
  GlTexture texture_;
  int width_ = 0, height_ = 0;
};

}  // namespace depixel
