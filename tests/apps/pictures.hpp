#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "apps/common/picture.hpp"
#include "libdepixel/core/color.hpp"

namespace depixel::test {

/// A picture of some colours that differs everywhere from its own flips and turns.
Picture sample_picture(int width, int height);
/// Frames of a game: a world that scrolls, and a disc that moves over it; now and then nothing does.
std::vector<Picture> sample_frames(int width, int height, int count);
/// A picture of one colour.
Picture plain_picture(int width, int height, Rgba colour);

/// The picture as a PNG file.
std::string png_of(const Picture& picture);
/// The picture as a BMP file of 24 bits a pixel.
std::string bmp_of(const Picture& picture);
/// Frames as an animated GIF of few colours; a single one is a still GIF.
std::string gif_of(const std::vector<Picture>& frames);

/// Decodes a PNG, BMP or JPEG file; an empty picture if that fails.
Picture decoded(std::string_view file);
Rgba pixel(const Picture& picture, int x, int y);

}  // namespace depixel::test
