#pragma once

#include <cstddef>
#include <cstdint>

#include "libdepixel/core/color.hpp"

namespace depixel {

/// A picture in somebody else's memory: rows of RGBA pixels, top row first. Nothing is owned.
struct FrameView {
  const std::uint8_t* pixels = nullptr;  ///< 4 bytes a pixel: red, green, blue, straight alpha
  int width = 0;                         ///< pixels
  int height = 0;                        ///< pixels
  std::ptrdiff_t pitch = 0;              ///< bytes from one row to the next
  /// Pixels at each side that continue the picture beyond its border: they are vectorized, and not shown.
  int margin = 0;
};

/// The order of a pixel's bytes in memory.
enum class ChannelOrder {
  rgba,
  bgra  ///< on little-endian machines, words of 0xAARRGGBB
};

/// Like FrameView, to be written to, in an order of its own.
struct PictureView {
  std::uint8_t* pixels = nullptr;
  int width = 0;
  int height = 0;
  std::ptrdiff_t pitch = 0;
  ChannelOrder order = ChannelOrder::rgba;

  friend bool operator==(const PictureView&, const PictureView&) = default;
};

}  // namespace depixel
