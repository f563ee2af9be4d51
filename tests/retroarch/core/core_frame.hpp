#pragma once

#include "apps/common/picture.hpp"
#include "tests/retroarch/core/script.hpp"

namespace depixel::test {

/// Bytes of a pixel.
constexpr std::size_t pixel_bytes(PixelFormat format) {
  return format == PixelFormat::xrgb8888 ? 4 : 2;
}

/// Converts a picture; alpha is dropped, and so are the low bits that the format has no room for. The bits
/// that a format leaves open, and the padding, differ from pixel to pixel: a reader must not mind them.
/// \param padding  bytes after each row
CoreFrame core_frame(const Picture& picture, PixelFormat format, std::size_t padding);

}  // namespace depixel::test
