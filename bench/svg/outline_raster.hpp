#pragma once

#include "apps/common/picture.hpp"
#include "libdepixel/stages/outlines.hpp"

namespace depixel::bench {

/// Output pixels to a source pixel.
constexpr int kOutlineScale = 8;

/// Draws the outlines of a map's components with the exact rasteriser.
Picture draw_outlines(const PlanarMap& map, const Components& components, const Outlines& outlines);

/// The mean of the absolute differences of the channels of two pictures of the same size, premultiplied; of
/// 0..255, and of alpha only where there is any.
double mean_difference(const Picture& a, const Picture& b);

}  // namespace depixel::bench
