#include "libdepixel/stages/planar_map.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cstdlib>

#include "libdepixel/core/tolerances.hpp"
#include "libdepixel/pipeline/vectorizer.hpp"
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

RC_GTEST_PROP(PlanarMap, SegmentsFollowTheContoursInOrder, (const Picture& picture)) {
  Vectorizer v;
  const PlanarMap& map = v.vectorize(picture.view(), *random_options());
  std::size_t next = 0;
  for (const Contour& contour : v.contours().list) {
    const std::size_t first = next;
    for (int k = 0; k < contour.step_count(); ++k, ++next) {
      RC_ASSERT(next < map.segments.size());
      const Segment& s = map.segments[next];
      if (k > 0) RC_ASSERT(map.segments[next - 1].p3 == s.p0);
      // The pixels on both sides of the step, from the step's middle in half pixels.
      const int node = contour.first + k;
      const auto heading = static_cast<Direction>(v.contours().heading[node]);
      const glm::ivec2 middle = 2 * map.lattice.corner_position(v.contours().corner[node]) + kStep[heading];
      const glm::ivec2 left = (middle + kStep[turned(heading, 3)] - 1) / 2;
      const glm::ivec2 right = (middle + kStep[turned(heading, 1)] - 1) / 2;
      RC_ASSERT(map.lattice.pixel_position(s.left) == left);
      RC_ASSERT(map.lattice.pixel_position(s.right) == right);
    }
    if (contour.closed) RC_ASSERT(map.segments[next - 1].p3 == map.segments[first].p0);
  }
  RC_ASSERT(next == map.segments.size());
}

RC_GTEST_PROP(PlanarMap, CurvesStayNearTheirSteps, (Picture picture)) {
  // No node moves farther than half a pixel, so no control point leaves the pixels round its step.
  const PlanarMap map = [&] {
    Vectorizer v;
    return v.vectorize(picture.view(), *random_options());
  }();
  for (const Segment& s : map.segments) {
    const glm::ivec2 sum = map.lattice.pixel_position(s.left) + map.lattice.pixel_position(s.right) + 1;
    const glm::ivec2 middle = sum * (kSubpixels / 2);  // of the lattice edge between the two pixels
    for (const glm::ivec2 p : {s.p0, s.p1, s.p2, s.p3}) {
      RC_ASSERT(std::abs(p.x - middle.x) <= kSubpixels + kSubpixels / 16);
      RC_ASSERT(std::abs(p.y - middle.y) <= kSubpixels + kSubpixels / 16);
    }
  }
}

}  // namespace
}  // namespace depixel::test
