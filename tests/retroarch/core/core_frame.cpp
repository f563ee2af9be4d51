#include "tests/retroarch/core/core_frame.hpp"

#include <cstring>

namespace depixel::test {
namespace {

constexpr std::uint8_t kPadding = 0xa5;

std::uint32_t encoded(Rgba c, PixelFormat format, std::uint32_t open_bits) {
  switch (format) {
    case PixelFormat::rgb565:
      return std::uint32_t{c.r} >> 3 << 11 | std::uint32_t{c.g} >> 2 << 5 | std::uint32_t{c.b} >> 3;
    case PixelFormat::xrgb1555:
      return (open_bits & 1) << 15 | std::uint32_t{c.r} >> 3 << 10 | std::uint32_t{c.g} >> 3 << 5 |
             std::uint32_t{c.b} >> 3;
    default:
      return open_bits << 24 | std::uint32_t{c.r} << 16 | std::uint32_t{c.g} << 8 | c.b;
  }
}

}  // namespace

CoreFrame core_frame(const Picture& picture, PixelFormat format, std::size_t padding) {
  const std::size_t size = pixel_bytes(format),
                    pitch = static_cast<std::size_t>(picture.width()) * size + padding;
  CoreFrame frame{std::vector<std::uint8_t>(pitch * static_cast<std::size_t>(picture.height()), kPadding),
                  static_cast<unsigned>(picture.width()), static_cast<unsigned>(picture.height()), pitch};
  for (int y = 0; y < picture.height(); ++y) {
    std::uint8_t* to = frame.bytes.data() + static_cast<std::size_t>(y) * pitch;
    for (int x = 0; x < picture.width(); ++x, to += size) {
      const std::uint32_t value =
          encoded(picture.at(x, y), format, static_cast<std::uint32_t>(5 * x + 3 * y));
      std::memcpy(to, &value, size);  // little-endian: the low bytes come first
    }
  }
  return frame;
}

}  // namespace depixel::test
