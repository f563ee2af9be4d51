#pragma once

#include <array>
#include <bit>
#include <glm/vec2.hpp>

#include "libdepixel/core/simd.hpp"
#include "libdepixel/raster/flatten.hpp"
#include "libdepixel/raster/output_grid.hpp"
#include "libdepixel/stages/edge_curve.hpp"

namespace depixel {

/// Maps the points of curves to output subpixels, for grids with whole output pixels to a source pixel: there
/// they lie alike round whatever corner owns the edge, and all fit 32 bits.
class CurveToOutput {
 public:
  using Points = std::array<glm::ivec2, 4>;

  static bool fits(const OutputGrid& grid) { return grid.has_whole_scales(kLargestScale); }
  explicit CurveToOutput(const OutputGrid& grid)
      : CurveToOutput(glm::ivec2(grid.x.whole_scale(), grid.y.whole_scale())) {}
  /// \param scale  output pixels to a source pixel, by axis.
  explicit CurveToOutput(glm::ivec2 scale) : scale_{scale.x, scale.y, scale.x, scale.y} {}

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
  /// Calls line(from, to) for each of the lines that a curve is drawn as, in order. \param points  its own.
  template <typename Line>
  void flatten(const EdgeCurve& curve, const Points& points, Line line) const {
    const int pieces = flattening_pieces(glm::ivec2(curve.p0), glm::ivec2(curve.p1), glm::ivec2(curve.p2),
                                         glm::ivec2(curve.p3), glm::dvec2(scale_[0], scale_[1]));
    depixel::flatten(points[0], points[1], points[2], points[3], pieces, line);
  }

 private:
  static constexpr int kLargestScale = 1 << 12;

  Int4 scale_;  ///< of both axes, twice
};

}  // namespace depixel
