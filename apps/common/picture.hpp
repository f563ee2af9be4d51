#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "libdepixel/core/frame_view.hpp"

namespace depixel {

/// A picture in memory of its own: RGBA pixels, straight alpha, rows from the top, without gaps between them.
class Picture {
 public:
  Picture() = default;
  /// A transparent picture.
  Picture(int width, int height) { resize(width, height); }

  /// Changes the size and keeps the memory; the pixels are left unspecified.
  void resize(int width, int height) {
    width_ = width;
    height_ = height;
    pixels_.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  }

  int width() const { return width_; }
  int height() const { return height_; }
  std::ptrdiff_t pitch() const { return std::ptrdiff_t{4} * width_; }
  std::size_t pixel_count() const { return pixels_.size(); }
  Rgba& at(int x, int y) { return pixels_[index(x, y)]; }
  Rgba at(int x, int y) const { return pixels_[index(x, y)]; }
  std::uint8_t* row(int y) { return target().pixels + y * pitch(); }

  FrameView view() const {
    return {reinterpret_cast<const std::uint8_t*>(pixels_.data()), width_, height_, pitch()};
  }
  PictureView target() { return {reinterpret_cast<std::uint8_t*>(pixels_.data()), width_, height_, pitch()}; }

 private:
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
  }

  int width_ = 0, height_ = 0;
  std::vector<Rgba> pixels_;
};

}  // namespace depixel
