#pragma once

#include <cstdint>

namespace depixel {

/// Geometry of the planar map is in fixed point: this many units to a source pixel.
constexpr int kSubpixels = 4096;

/// No contour comes nearer to a pixel centre than this, in subpixels (1/16 pixel): so every pixel keeps its
/// colour at its centre whatever is smoothed.
constexpr int kCentreClearance = kSubpixels / 16;

/// Output coordinates of the rasterisers are in fixed point: this many units to an output pixel.
constexpr int kRasterSubpixels = 256;

/// Curves are flattened so finely that a line strays from its curve by at most this much, in output pixels.
constexpr double kFlatteningTolerance = 1.0 / 8;

}  // namespace depixel
