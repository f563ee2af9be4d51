#pragma once

#include <filesystem>
#include <vector>

#include "bench/gl/gl_timing.hpp"

namespace depixel::bench {

/// How far OpenGL's pictures are from the processor's, of 255 levels; colours are weighted by their alpha.
struct GlComparison {
  int views = 0;
  double worst_mean = 0;  ///< of a picture
  int worst_pixel = 0;    ///< of a channel of a pixel
};

/// Draws files at several scales, and views that cut through them, both ways. Throws std::runtime_error where
/// one cannot be drawn.
GlComparison compare(GlTimer& timer, const std::vector<std::filesystem::path>& files);

}  // namespace depixel::bench
