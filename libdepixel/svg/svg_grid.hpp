#pragma once

#include <cstdint>
#include <glm/vec2.hpp>

#include "libdepixel/core/tolerances.hpp"

namespace depixel {

/// The coordinates that SVG files are written in: whole multiples of some thousandths of a pixel.
struct SvgGrid {
  int step = 1;  ///< in thousandths: 1 for three decimals, 10 for two, 100 for one

  /// The coarsest that adds no more than a third to a tolerance; three decimals where it is small.
  static constexpr SvgGrid within(double tolerance_px) {
    constexpr double kPart = 3, kHalfDiagonal = 0.7072 / 1000;
    for (const int step : {100, 10}) {
      if (kPart * kHalfDiagonal * step <= tolerance_px) return {step};
    }
    return {};
  }

  /// The nearest coordinates, in thousandths. They turn and flip as points do, and go along by whole pixels.
  glm::ivec2 thousandths(glm::ivec2 subpixels) const { return {nearest(subpixels.x), nearest(subpixels.y)}; }
  /// The nearest coordinates, in subpixels, as nearly as these can be told; thousandths() finds them again.
  glm::ivec2 snapped(glm::ivec2 subpixels) const {
    return {to_subpixels(nearest(subpixels.x)), to_subpixels(nearest(subpixels.y))};
  }

 private:
  static constexpr int kThousand = 1000;

  static constexpr std::int64_t floor_divided(std::int64_t value, std::int64_t by) {
    return value >= 0 ? value / by : (value - by + 1) / by;
  }
  /// Halves go to the even multiple: a pixel has an even number of them.
  int nearest(int subpixels) const {
    const std::int64_t unit = std::int64_t{kSubpixels} * step,
                       twice = 2 * kThousand * std::int64_t{subpixels};
    const std::int64_t up = floor_divided(twice + unit, 2 * unit);
    const bool is_half = twice + unit == 2 * unit * up;
    return static_cast<int>(is_half && up % 2 != 0 ? up - 1 : up) * step;
  }
  static int to_subpixels(int thousandths) {
    return static_cast<int>(
        floor_divided(2 * kSubpixels * std::int64_t{thousandths} + kThousand, std::int64_t{2} * kThousand));
  }
};

}  // namespace depixel
