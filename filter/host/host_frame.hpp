#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "libdepixel/core/frame_view.hpp"

namespace depixel {

/// How a host stores a pixel: a native word of 16 or 32 bits.
enum class HostFormat { rgb565, xrgb8888 };

constexpr std::size_t bytes_a_pixel(HostFormat format) {
  return format == HostFormat::rgb565 ? 2 : 4;
}

/// A frame in a host's memory, top row first. Nothing is owned.
struct HostFrame {
  const void* pixels = nullptr;
  int width = 0, height = 0;  ///< pixels
  std::size_t pitch = 0;      ///< bytes from one row to the next
  HostFormat format = HostFormat::xrgb8888;

  std::size_t row_bytes() const { return static_cast<std::size_t>(width) * bytes_a_pixel(format); }
};

/// Copies a frame to opaque RGBA pixels without gaps. Five or six bits of a channel become the nearest of 256
/// levels, as where the host shows such frames itself.
/// \param rgba  is given room for the frame.
/// \return the copy.
FrameView to_rgba(const HostFrame& frame, std::vector<std::uint8_t>& rgba);

}  // namespace depixel
