#pragma once

#include <cstddef>
#include <cstdint>

namespace depixel {

/// Longest side of a picture, read or drawn, in pixels.
constexpr int kMaxSide = 16384;

/// Largest picture that is read, in pixels: as 4096 x 4096. Vectorizing takes memory in proportion, at worst
/// (noise) some 170 bytes a pixel, so that the largest picture takes less than 3 GiB.
constexpr std::int64_t kMaxPixels = std::int64_t{4096} * 4096;

/// Largest picture that is drawn, in pixels: as 16384 x 8192, or 512 MiB.
constexpr std::int64_t kMaxOutputPixels = std::int64_t{16384} * 8192;

/// Largest file that is read, in bytes. It bounds what endless inputs, such as devices, can take.
constexpr std::size_t kMaxFileBytes = std::size_t{256} << 20;

}  // namespace depixel
