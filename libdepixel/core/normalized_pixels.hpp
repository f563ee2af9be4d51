#pragma once

#include <bit>
#include <cstdint>
#include <cstring>

#include "libdepixel/core/color.hpp"
#include "libdepixel/core/simd.hpp"

namespace depixel {

/// Four pixels of a frame at once, each as normalized() makes it: those of alpha 0 are one colour.
inline Word4 load_normalized(const void* pixels) {
  constexpr auto kAlpha = std::bit_cast<std::uint32_t>(Rgba{0, 0, 0, 255});
  const auto four = load_vector<Word4>(pixels);
  const Word4 visible = (four & kAlpha) != 0;
  return four & visible;
}

/// Copies a row of a frame's pixels, each as normalized() makes it.
inline void take_normalized(const std::uint8_t* row, int count, Rgba* to) {
  int x = 0;
  for (; x + kWordLanes <= count; x += kWordLanes) {
    store_vector(to + x, load_normalized(row + sizeof(Rgba) * x));
  }
  for (; x < count; ++x) {
    std::memcpy(to + x, row + sizeof(Rgba) * x, sizeof(Rgba));
    to[x] = normalized(to[x]);
  }
}

}  // namespace depixel
