#pragma once

#include <cstdint>

namespace depixel {

/// Linear light has this many levels above black: fine enough that every sRGB value survives the way there
/// and back, small enough that sums of areas fit 32 bits.
constexpr int kLightLevels = 8191;

/// The linear light, 0..kLightLevels, of an sRGB value. Source: IEC 61966-2-1.
int to_light(std::uint8_t srgb);
/// The sRGB value nearest to a linear light.
std::uint8_t from_light(int light);

}  // namespace depixel
