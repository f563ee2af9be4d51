#pragma once

#include <string>

#include "apps/common/picture.hpp"
#include "libdepixel/core/options.hpp"
#include "tests/retroarch/core/script.hpp"

namespace depixel::test {

/// A picture of as many colours as can be: small areas, each of another colour.
Picture colourful_picture(int width, int height);

/// What RetroArch shows of a picture that comes in a format: channels of 5 and 6 bits as OpenGL reads them.
Picture in_format(const Picture& picture, PixelFormat format);

/// Nearest neighbour: every pixel becomes a square.
Picture enlarged(const Picture& picture, int factor);

/// Turned by a quarter, counter-clockwise.
Picture turned_left(const Picture& picture);

/// The size of a side of the filter's picture.
int scaled(int side, double scale);

/// What the filter is to make of a frame, drawn by the processor from scratch.
Picture depixelled(const Picture& frame, double scale, const Options& options = {});

/// Empty if both pictures have the same size and no channel differs by more than the tolerance, else what
/// differs. The pictures are then left on disk, named after the test.
std::string mismatch(const Picture& expected, const Picture& actual, int tolerance = 0);

}  // namespace depixel::test
