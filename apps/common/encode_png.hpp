#pragma once

#include <cstdint>
#include <vector>

#include "libdepixel/core/frame_view.hpp"

namespace depixel {

/// Encodes a picture as a PNG file of 8-bit RGBA pixels. \return the file; empty only if memory ran out.
std::vector<std::uint8_t> encode_png(const FrameView& picture);

}  // namespace depixel
