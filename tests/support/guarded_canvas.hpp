#pragma once

#include <algorithm>
#include <cstring>
#include <vector>

#include "tests/support/picture.hpp"

namespace depixel::test {

/// A picture in larger memory: rows with room after them, and rows before and after, none of which may be
/// written to.
class GuardedCanvas {
 public:
  GuardedCanvas(int width, int height)
      : width_(width),
        height_(height),
        bytes_(static_cast<std::size_t>(pitch()) * (height + 2 * kGuardRows), kGuard) {}

  PictureView target() { return {row(0), width_, height_, pitch()}; }

  /// Fills the picture with what was never drawn.
  void scribble() {
    for (int y = 0; y < height_; ++y) std::memset(row(y), 0x3c + y % 7, 4 * std::size_t(width_));
  }

  Picture picture() const {
    Picture copy(width_, height_);
    for (int y = 0; y < height_; ++y) {
      std::memcpy(&copy.at(0, y), const_cast<GuardedCanvas*>(this)->row(y), 4 * std::size_t(width_));
    }
    return copy;
  }

  bool is_guard_whole() const {
    const auto is_guard = [](std::uint8_t byte) { return byte == kGuard; };
    for (int y = -kGuardRows; y < height_ + kGuardRows; ++y) {
      const std::uint8_t* begin = const_cast<GuardedCanvas*>(this)->row(y);
      const bool is_picture = y >= 0 && y < height_;
      if (!std::all_of(begin + (is_picture ? 4 * std::ptrdiff_t(width_) : 0), begin + pitch(), is_guard)) {
        return false;
      }
    }
    return true;
  }

 private:
  static constexpr std::uint8_t kGuard = 0xa5;
  static constexpr int kGuardRows = 2, kGuardPixels = 5;

  std::ptrdiff_t pitch() const { return 4 * std::ptrdiff_t(width_ + kGuardPixels); }
  std::uint8_t* row(int y) { return bytes_.data() + (y + kGuardRows) * pitch(); }

  int width_, height_;
  std::vector<std::uint8_t> bytes_;
};

}  // namespace depixel::test
