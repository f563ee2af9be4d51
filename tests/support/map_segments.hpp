#pragma once

#include <compare>
#include <ostream>
#include <string>
#include <vector>

#include "libdepixel/core/options.hpp"
#include "libdepixel/stages/planar_map.hpp"
#include "tests/support/picture.hpp"

namespace depixel::test {

/// The map of a picture, made from scratch.
PlanarMap vectorized(const Picture& picture, const Options& options = {});

/// A segment told without regard to its contour's direction: from its smaller end to its larger one, by what
/// lies on its sides.
struct FreeSegment {
  std::array<int, 8> points{};       ///< x and y of p0 .. p3, subpixels
  std::array<int, 4> side_pixels{};  ///< x and y of the pixel on the left and of that on the right
  std::array<std::uint32_t, 2> side_colours{};

  friend auto operator<=>(const FreeSegment&, const FreeSegment&) = default;
};

std::ostream& operator<<(std::ostream& out, const FreeSegment& s);

/// The segments of a map as a sorted list that does not depend on how contours start and run, as they would
/// be if the picture had been laid otherwise, then shifted by whole pixels.
std::vector<FreeSegment> free_segments(const PlanarMap& map, const Symmetry& symmetry = {},
                                       glm::ivec2 shift_px = {0, 0});

/// The first segments that only one of two lists has, as text; empty if they are equal.
std::string difference(const std::vector<FreeSegment>& expected, const std::vector<FreeSegment>& actual);

}  // namespace depixel::test
