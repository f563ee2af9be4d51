#pragma once

#include <array>
#include <bit>
#include <glm/vec2.hpp>

#include "libdepixel/core/simd.hpp"
#include "libdepixel/raster/output_grid.hpp"
#include "libdepixel/stages/edge_curve.hpp"

namespace depixel {

/// Maps the points of curves to output subpixels, for grids with whole output pixels to a source pixel: there
/// they lie alike round whatever corner owns the edge, and all fit 32 bits.
class CurveToOutput {
 public:
  using Points = std::array<glm::ivec2, 4>;

  static bool fits(const OutputGrid& grid) {
    const int x = grid.x.whole_scale(), y = grid.y.whole_scale();
    return x > 0 && y > 0 && x <= kLargestScale && y <= kLargestScale;
  }
  explicit CurveToOutput(const OutputGrid& grid)
      : scale_{grid.x.whole_scale(), grid.y.whole_scale(), grid.x.whole_scale(), grid.y.whole_scale()} {}

  /// The points, from where the edge's owner lies: to the bit what an OutputGrid makes of them.
  Points operator()(const EdgeCurve& curve) const {
    constexpr int kBits = 4;
    static_assert(kSubpixels >> kBits == kRasterSubpixels);
    using Short4 = std::int16_t __attribute__((vector_size(8)));
    const auto halves = std::bit_cast<std::array<Short4, 2>>(curve);
    const auto mapped = [&](Short4 two_points) {
      return (__builtin_convertvector(two_points, Int4) * scale_ + (1 << kBits) / 2) >> kBits;
    };
    return std::bit_cast<Points>(std::array<Int4, 2>{mapped(halves[0]), mapped(halves[1])});
  }

 private:
  static constexpr int kLargestScale = 1 << 12;

  Int4 scale_;  ///< of both axes, twice
};

}  // namespace depixel
