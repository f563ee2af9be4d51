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

/// Curves of an SVG file stray from those of the map by at most this much, in source pixels, unless another
/// tolerance is asked for: half an output pixel at 8x. Below 1/16 pixel, kCentreClearance, every pixel keeps
/// its colour at its centre.
constexpr double kSvgTolerance = 0.06, kMaxSvgTolerance = 0.5;

/// What it costs to leave a square pixel between the curve of an SVG file and those that it replaces, in
/// characters, where the colours on both sides are black and white; less where they are nearer to each other.
/// So what is seen most strays least: at 8x black and white icons differ by less than 0.3 of 255 on average.
constexpr double kSvgPrice = 2000;

/// Where two curves of a contour turn by more than this (20 degrees; the sine), that is a corner, and no
/// curve of an SVG file goes round it.
constexpr double kSvgCorner = 0.35;

/// Lines and quadratic curves that replace others turn away from these at their ends by no more than this (6
/// degrees; the sine), so that what is smooth looks smooth.
constexpr double kSvgKink = 0.1;

}  // namespace depixel
