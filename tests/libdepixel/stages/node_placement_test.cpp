#include "libdepixel/stages/node_placement.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "libdepixel/raster/cpu_raster.hpp"
#include "tests/support/ascii_picture.hpp"
#include "tests/support/map_segments.hpp"

namespace depixel::test {
namespace {

constexpr int kSamplesAPixel = 16;

Picture drawn(const Picture& frame, const Options& options) {
  Picture out(kSamplesAPixel * frame.width, kSamplesAPixel * frame.height);
  const PlanarMap map = vectorized(frame, options);
  CpuRaster().draw(map, View::fit(map.lattice, out.width, out.height), false, 1, out.target());
  return out;
}

/// How much of a picture is black on white, in source pixels.
double black_area(const Picture& picture) {
  double area = 0;
  for (const Rgba& pixel : picture.pixels) area += 1 - pixel.r / 255.0;
  return area / (kSamplesAPixel * kSamplesAPixel);
}

TEST(NodePlacement, DotsKeepMostOfTheirArea) {
  const std::vector<std::string_view> small{"......", "......", "..##..", "..##..", "......", "......"};
  const std::vector<std::string_view> long_one{"......", "..##..", "..##..", "..##..", "......", "......"};
  for (const Corners corners : {Corners::sharp, Corners::round}) {
    EXPECT_GT(black_area(drawn(ascii_picture(small), {.corners = corners})), 3.2);
    EXPECT_GT(black_area(drawn(ascii_picture(long_one), {.corners = corners})), 4.2);
  }
}

TEST(NodePlacement, DotsAreTextAsAWholeOrNotAtAll) {
  // Only half of the dot on the right is near the bar on the left.
  const Picture frame = ascii_picture({"...........",  //
                                       ".###.......",  //
                                       ".###..##...",  //
                                       ".###..##...",  //
                                       "..........."});
  const Picture picture = drawn(frame, {.text_safe = true});
  const int first = 5 * kSamplesAPixel, last = 9 * kSamplesAPixel - 1;
  int most = 0;  // levels between a pixel and its mirror image; a few come from rounding
  for (int y = 0; y < picture.height; ++y) {
    for (int x = first; x <= last; ++x) {
      most = std::max(most, std::abs(picture.at(x, y).r - picture.at(first + last - x, y).r));
    }
  }
  EXPECT_LE(most, 2);
}

}  // namespace
}  // namespace depixel::test
