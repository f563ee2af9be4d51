#pragma once

#include <span>

#include "bench/common/picture.hpp"

namespace depixel::bench {

/// Hostile pictures: what real frames hold in patches, over the whole screen. All are the same on every run.
Picture checkerboard(int width, int height);
Picture colour_noise(int width, int height);
Picture two_colour_noise(int width, int height);
/// A diagonal gradient in black and white by Floyd and Steinberg's error diffusion.
Picture dithered_gradient(int width, int height);

/// A picture of any size laid out from frames, side by side and without resampling, in turn.
Picture tile(std::span<const Picture> frames, int width, int height);

}  // namespace depixel::bench
