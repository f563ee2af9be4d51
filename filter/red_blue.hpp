#pragma once

#include <cstdint>

namespace depixel {

/// A pixel's word with red and blue swapped, in whichever order they were; green and alpha stay.
constexpr std::uint32_t swap_red_and_blue(std::uint32_t word) {
  return (word & 0xff00ff00U) | (word >> 16 & 0xff) | (word & 0xff) << 16;
}

}  // namespace depixel
