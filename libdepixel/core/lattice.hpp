#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>

namespace depixel {

/// Compass directions along lattice edges, clockwise. As bits of a mask: 1 << direction.
enum Direction : std::uint8_t { kNorth = 0, kEast = 1, kSouth = 2, kWest = 3 };

constexpr std::array<Direction, 4> kDirections{kNorth, kEast, kSouth, kWest};

constexpr Direction turned(Direction d, int quarter_turns_clockwise) {
  return static_cast<Direction>((d + quarter_turns_clockwise) & 3);
}
constexpr Direction opposite(Direction d) {
  return turned(d, 2);
}

/// Unit steps of the four directions, x right and y down.
constexpr std::array<glm::ivec2, 4> kStep{{{0, -1}, {1, 0}, {0, 1}, {-1, 0}}};

/// Index arithmetic shared by all stages.
///
/// Pixels live in an array with kPad empty pixels on every side, so that 8x8 windows need no bounds checks,
/// and vectors of sixteen bytes that are written beyond the end of a row do not reach the next. A lattice
/// corner and the 2x2 block of pixels round it carry the index of the block's north-west pixel, so one index
/// names a pixel, the corner at its south-east, and the block centred there.
class Lattice {
 public:
  static constexpr int kPad = 8;

  constexpr Lattice() = default;
  constexpr Lattice(int width, int height, int margin = 0)
      : width_(width), height_(height), margin_(margin) {}

  constexpr int width() const { return width_; }
  constexpr int height() const { return height_; }
  /// Pixels at each side that are beyond the border of the picture shown; see FrameView.
  constexpr int margin() const { return margin_; }
  constexpr int shown_width() const { return width_ - 2 * margin_; }
  constexpr int shown_height() const { return height_ - 2 * margin_; }
  constexpr int stride() const { return width_ + 2 * kPad; }
  constexpr int size() const { return stride() * (height_ + 2 * kPad); }  ///< entries of a padded array

  constexpr int pixel(int x, int y) const { return (y + kPad) * stride() + x + kPad; }
  /// The lattice point at (x, y), 0 <= x <= width, 0 <= y <= height.
  constexpr int corner(int x, int y) const { return pixel(x - 1, y - 1); }
  constexpr glm::ivec2 pixel_position(int index) const {
    return {index % stride() - kPad, index / stride() - kPad};
  }
  constexpr glm::ivec2 corner_position(int index) const { return pixel_position(index) + 1; }

  /// Index offset to the next corner in a direction.
  constexpr std::array<int, 4> step_offsets() const { return {-stride(), 1, stride(), -1}; }
  /// Index offset from a corner to the pixel on the left of the edge that leaves it in a direction; the pixel
  /// on the right of direction d is the one on the left of turned(d, 1).
  constexpr std::array<int, 4> left_offsets() const { return {0, 1, stride() + 1, stride()}; }

  friend constexpr bool operator==(const Lattice&, const Lattice&) = default;

 private:
  int width_ = 0, height_ = 0, margin_ = 0;
};

}  // namespace depixel
