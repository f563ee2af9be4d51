#include "libdepixel/stages/planar_map.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cstdlib>

#include "libdepixel/core/tolerances.hpp"
#include "libdepixel/pipeline/vectorizer.hpp"
#include "tests/support/map_splines.hpp"
#include "tests/support/random_pictures.hpp"

namespace depixel::test {
namespace {

glm::ivec2 subpixels(double x, double y) {
  return {static_cast<int>(x * kSubpixels), static_cast<int>(y * kSubpixels)};
}

TEST(PlanarMap, AStraightEdgeIsOneStraightSegmentAStep) {
  Vectorizer vectorizer;
  const PlanarMap& map = vectorizer.vectorize(ascii_picture({"r.",  //
                                                             "r.",  //
                                                             "r."})
                                                  .view(),
                                              {});
  ASSERT_EQ(map.segments.size(), 3u);
  for (int y = 0; y < 3; ++y) {
    const Segment& s = map.segments[y];
    EXPECT_EQ(s.p0, subpixels(1, y));
    EXPECT_EQ(s.p3, subpixels(1, y + 1));
    for (const glm::ivec2 p : {s.p1, s.p2}) EXPECT_EQ(p.x, kSubpixels);
    // Going down, the white pixel lies on the left.
    EXPECT_EQ(s.left, map.lattice.pixel(1, y));
    EXPECT_EQ(s.right, map.lattice.pixel(0, y));
    EXPECT_EQ(map.left_colour(s), palette_colour('.'));
    EXPECT_EQ(map.right_colour(s), palette_colour('r'));
  }
}

TEST(PlanarMap, RegionsHaveTheColourOfTheirPixels) {
  Vectorizer vectorizer;
  const Picture picture = ascii_picture({"rR_",  //
                                         ".kf"});
  const PlanarMap& map = vectorizer.vectorize(picture.view(), {});
  for (int y = 0; y < 2; ++y) {
    for (int x = 0; x < 3; ++x) EXPECT_EQ(map.colours[map.lattice.pixel(x, y)], picture.at(x, y));
  }
}

TEST(PlanarMap, FourMeetInOnePoint) {
  Vectorizer vectorizer;
  for (const Smoothing smoothing : {Smoothing::energy, Smoothing::average, Smoothing::none}) {
    Options options;
    options.smoothing = smoothing;
    const PlanarMap& map = vectorizer.vectorize(ascii_picture({"rrgg",  //
                                                               "rrgg",  //
                                                               "bbyy",  //
                                                               "bbyy"})
                                                    .view(),
                                                options);
    int ends = 0;
    for (const Segment& s : map.segments) ends += (s.p0 == subpixels(2, 2)) + (s.p3 == subpixels(2, 2));
    EXPECT_EQ(ends, 4);
  }
}

RC_GTEST_PROP(PlanarMap, SegmentsChainAlongTheContours, (const Picture& picture)) {
  Vectorizer v;
  const PlanarMap& map = v.vectorize(picture.view(), *random_options());
  std::size_t steps = 0;
  for (const Contour& contour : v.contours().list) {
    std::vector<Segment> chain;
    for (int node = contour.first; node < contour.first + contour.step_count(); ++node, ++steps) {
      const auto heading = static_cast<Direction>(v.contours().heading[node]);
      chain.push_back(segment_along(map, v.contours().corner[node], heading));
      if (chain.size() > 1) RC_ASSERT(chain[chain.size() - 2].p3 == chain.back().p0);
      // The pixels on both sides of the step, from the step's middle in half pixels.
      const glm::ivec2 middle = 2 * map.lattice.corner_position(v.contours().corner[node]) + kStep[heading];
      const glm::ivec2 left = (middle + kStep[turned(heading, 3)] - 1) / 2;
      const glm::ivec2 right = (middle + kStep[turned(heading, 1)] - 1) / 2;
      RC_ASSERT(map.lattice.pixel_position(chain.back().left) == left);
      RC_ASSERT(map.lattice.pixel_position(chain.back().right) == right);
    }
    if (contour.closed) RC_ASSERT(chain.back().p3 == chain.front().p0);
  }
  RC_ASSERT(steps == map.segments.size());
}

RC_GTEST_PROP(PlanarMap, SegmentsComeInRasterOrderOfTheirEdges, (const Picture& picture)) {
  Vectorizer v;
  const PlanarMap& map = v.vectorize(picture.view(), *random_options());
  const int stride = map.lattice.stride();
  int last = -1;
  for (const Segment& s : map.segments) {
    // Going east, the pixel on the right lies below that on the left; going south, west of it.
    const bool southwards = s.right == s.left - 1;
    RC_ASSERT(southwards || s.right == s.left + stride);
    const int slot = 2 * (southwards ? s.right - stride : s.left - 1) + (southwards ? 1 : 0);
    RC_ASSERT(slot > last);
    last = slot;
  }
}

RC_GTEST_PROP(PlanarMap, CurvesStayNearTheirSteps, (Picture picture)) {
  // No point is a pixel away from its lattice edge, so the curve stays in the tiles round the edge's ends.
  const PlanarMap map = [&] {
    Vectorizer v;
    return v.vectorize(picture.view(), *random_options());
  }();
  for (const Segment& s : map.segments) {
    const glm::ivec2 sum = map.lattice.pixel_position(s.left) + map.lattice.pixel_position(s.right) + 1;
    const glm::ivec2 middle = sum * (kSubpixels / 2);  // of the lattice edge between the two pixels
    const bool southwards = std::abs(s.left - s.right) == 1;
    for (const glm::ivec2 p : {s.p0, s.p1, s.p2, s.p3}) {
      const glm::ivec2 reach = southwards ? glm::ivec2(2, 3) : glm::ivec2(3, 2);
      RC_ASSERT(std::abs(p.x - middle.x) < reach.x * kSubpixels / 2);
      RC_ASSERT(std::abs(p.y - middle.y) < reach.y * kSubpixels / 2);
    }
  }
}

}  // namespace
}  // namespace depixel::test
