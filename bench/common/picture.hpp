#pragma once

#include <filesystem>

#include "apps/common/picture.hpp"

namespace depixel::bench {

/// A part of a frame; shares its pixels.
FrameView crop(const FrameView& frame, int x, int y, int width, int height);

/// Reads a PNG, BMP or JPEG file. Throws std::runtime_error with a sentence that names the file.
Picture read_picture(const std::filesystem::path& path);
/// Writes a PNG. Throws like read_picture.
void write_png(const Picture& picture, const std::filesystem::path& path);

/// Every pixel as a square of scale x scale.
Picture enlarge_nearest(const Picture& picture, int scale);

}  // namespace depixel::bench
