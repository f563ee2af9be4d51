#include "libdepixel/pipeline/vectorizer.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <map>

#include "libdepixel/core/tolerances.hpp"
#include "libdepixel/pipeline/verify.hpp"
#include "libdepixel/raster/cpu_raster.hpp"
#include "tests/support/map_segments.hpp"
#include "tests/support/random_pictures.hpp"

namespace depixel::test {
namespace {

RC_GTEST_PROP(Vectorizer, FlipsAndTurnsCommute, (const Picture& picture)) {
  const Options options = *random_options();
  const PlanarMap map = vectorized(picture, options);
  for (const Symmetry& symmetry : kSymmetries) {
    const auto expected = free_segments(map, symmetry);
    const auto actual = free_segments(vectorized(symmetry(picture), options));
    if (expected == actual) continue;
    RC_LOG() << (symmetry.mirrored ? "mirrored, " : "") << symmetry.quarter_turns << " quarter turns\n"
             << difference(expected, actual);
    RC_FAIL("the turned picture's map is not the map turned");
  }
}

RC_GTEST_PROP(Vectorizer, TranslationsCommute, (Picture picture)) {
  const Options options = *random_options();
  // Away from the border: nothing that votes or joins may see where the picture ends.
  constexpr int kMargin = 9, kRoom = 7;
  const Rgba background = palette_colour(*rc::gen::element('.', 'r', '_', '4'));
  const Picture canvas(picture.width + 2 * kMargin + kRoom, picture.height + 2 * kMargin + kRoom, background);
  const auto placed = [&](glm::ivec2 offset) {
    Picture whole = canvas;
    paste(whole, picture, kMargin + offset.x, kMargin + offset.y);
    return vectorized(whole, options);
  };
  const glm::ivec2 shift(*rc::gen::inRange(0, kRoom + 1), *rc::gen::inRange(0, kRoom + 1));
  const auto expected = free_segments(placed({0, 0}), {}, shift);
  const auto actual = free_segments(placed(shift));
  if (expected != actual) {
    RC_LOG() << "moved by " << shift.x << ',' << shift.y << '\n' << difference(expected, actual);
    RC_FAIL("the moved picture's map is not the map moved");
  }
}

RC_GTEST_PROP(Vectorizer, EveryCentreKeepsItsColour, (const Picture& picture)) {
  // Exact similarity, whatever the spline and the smoothing.
  const Options options = *random_lossless_options();
  Vectorizer vectorizer;
  const PlanarMap& map = vectorizer.vectorize(picture.view(), options);
  const CentreReport report = verify_centres(map, vectorizer.graph());
  RC_LOG() << "first lost " << report.first_lost_x << ',' << report.first_lost_y << '\n';
  RC_ASSERT(report.lost == 0);
  // Control points and knots are rounded to whole subpixels.
  constexpr double kClearance = (kCentreClearance - 1.0) / kSubpixels;
  RC_ASSERT(report.nearest >= kClearance);
}

/// The colour changes of all segments that leave a point, less those of the ones that arrive, by point.
std::map<std::pair<int, int>, std::array<int, 4>> changes_by_point(const PlanarMap& map) {
  std::map<std::pair<int, int>, std::array<int, 4>> changes;
  for (const Segment& s : map.segments) {
    const Rgba l = map.left_colour(s), r = map.right_colour(s);
    const std::array<int, 4> change{l.r - r.r, l.g - r.g, l.b - r.b, l.a - r.a};
    for (int c = 0; c < 4; ++c) {
      changes[{s.p0.x, s.p0.y}][c] += change[c];
      changes[{s.p3.x, s.p3.y}][c] -= change[c];
    }
  }
  return changes;
}

RC_GTEST_PROP(Vectorizer, SegmentsMeetInPointsWhereColoursClose, (const Picture& picture)) {
  // Going round any point inside, one comes back to the colour one started from: so all segments of a node
  // share it.
  const Options options = *random_options();
  const PlanarMap map = vectorized(picture, options);
  const int right = picture.width * kSubpixels, bottom = picture.height * kSubpixels;
  for (const auto& [point, change] : changes_by_point(map)) {
    const auto& [x, y] = point;
    if (x == 0 || y == 0 || x == right || y == bottom) continue;
    if (change == std::array<int, 4>{}) continue;
    RC_LOG() << "at " << double(x) / kSubpixels << ',' << double(y) / kSubpixels << '\n';
    RC_FAIL("colours do not close round a point");
  }
}

RC_GTEST_PROP(Vectorizer, SegmentsStayWithinTheFrame, (const Picture& picture)) {
  const PlanarMap map = vectorized(picture, *random_options());
  const glm::ivec2 limit = glm::ivec2(picture.width, picture.height) * kSubpixels;
  for (const Segment& s : map.segments) {
    for (const glm::ivec2 p : {s.p0, s.p3}) {
      RC_ASSERT(p.x >= 0);
      RC_ASSERT(p.y >= 0);
      RC_ASSERT(p.x <= limit.x);
      RC_ASSERT(p.y <= limit.y);
    }
  }
}

RC_GTEST_PROP(Vectorizer, SidesOfASegmentDiffer, (const Picture& picture)) {
  const Options options = *random_options();
  Vectorizer vectorizer;
  const PlanarMap& map = vectorizer.vectorize(picture.view(), options);
  const bool merges = options.similarity == Similarity::merge || options.connect_lines;
  for (const Segment& s : map.segments) {
    const glm::ivec2 apart = map.lattice.pixel_position(s.left) - map.lattice.pixel_position(s.right);
    RC_ASSERT(apart.x * apart.x + apart.y * apart.y == 1);
    if (merges) {
      RC_ASSERT(vectorizer.components().label[s.left] != vectorizer.components().label[s.right]);
    } else {
      RC_ASSERT(!(map.left_colour(s) == map.right_colour(s)));
    }
  }
}

RC_GTEST_PROP(Vectorizer, FramesBeforeLeaveNoTrace, (const Picture& first, const Picture& second)) {
  const Options options = *random_options();
  Vectorizer reused;
  reused.vectorize(first.view(), *random_options());
  const auto actual = free_segments(reused.vectorize(second.view(), options));
  RC_ASSERT(actual == free_segments(vectorized(second, options)));
}

RC_GTEST_PROP(Vectorizer, SameSizedFramesBeforeLeaveNoTrace, (const Picture& first)) {
  Picture second(first.width, first.height, palette_colour('b'));
  paste(second, *random_picture(), 0, 0);
  const Options options = *random_options();
  Vectorizer reused;
  reused.vectorize(first.view(), *random_options());
  const auto actual = free_segments(reused.vectorize(second.view(), options));
  RC_ASSERT(actual == free_segments(vectorized(second, options)));
}

TEST(Vectorizer, CountsWhatItMade) {
  Vectorizer vectorizer;
  const Picture picture = ascii_picture({"....",  //
                                         ".#..",  //
                                         "..#.",  //
                                         "...."});
  vectorizer.vectorize(picture.view(), {});
  EXPECT_EQ(vectorizer.stats().pixels, 16);
  EXPECT_EQ(vectorizer.stats().crossings, 1);
  EXPECT_EQ(vectorizer.stats().contours, 1);
  EXPECT_EQ(vectorizer.stats().nodes, 8);
  EXPECT_EQ(vectorizer.stats().segments, 8);
}

TEST(Vectorizer, CountsTheMemoryItHolds) {
  Vectorizer vectorizer;
  const Picture picture = ascii_picture({"....",  //
                                         ".#..",  //
                                         "..#.",  //
                                         "...."});
  vectorizer.vectorize(picture.view(), {});
  const std::size_t bytes = vectorizer.stats().memory_bytes;
  EXPECT_GT(bytes, sizeof(Rgba) * picture.pixels.size());
  for (int frame = 0; frame < 3; ++frame) {
    vectorizer.vectorize(picture.view(), {});
    EXPECT_EQ(vectorizer.stats().memory_bytes, bytes);
  }
}

/// Frames of awkward sizes: noise of two colours, drawn at twice the size, must keep centres and not crash.
class HostileSizes : public testing::TestWithParam<std::pair<int, int>> {};

TEST_P(HostileSizes, AreVectorizedAndDrawn) {
  const auto& [width, height] = GetParam();
  Picture picture(width, height);
  std::uint32_t state = 1;
  for (Rgba& c : picture.pixels) {
    state = state * 1664525 + 1013904223;
    c = palette_colour(".#_r"[state >> 30]);
  }
  for (const SplineKind spline : {SplineKind::adaptive, SplineKind::approximate, SplineKind::interpolate}) {
    for (const Smoothing smoothing : {Smoothing::energy, Smoothing::average, Smoothing::none}) {
      Options options;
      options.spline = spline;
      options.smoothing = smoothing;
      Vectorizer vectorizer;
      const PlanarMap& map = vectorizer.vectorize(picture.view(), options);
      const CentreReport report = verify_centres(map, vectorizer.graph());
      EXPECT_EQ(report.pixels, width * height);
      EXPECT_EQ(report.lost, 0) << "first at " << report.first_lost_x << ',' << report.first_lost_y;
      Picture out(2 * width, 2 * height);
      CpuRaster().draw(map, View::fit(map.lattice, out.width, out.height), false, 1, out.target());
      EXPECT_EQ(out.at(0, 0).a == 0, normalized(picture.at(0, 0)).a == 0);
    }
  }
  Options merging;
  merging.similarity = Similarity::merge;
  merging.connect_lines = true;
  EXPECT_EQ(vectorized(picture, merging).lattice.width(), width);
}

INSTANTIATE_TEST_SUITE_P(Vectorizer, HostileSizes,
                         testing::Values(std::pair{1, 1}, std::pair{1, 2}, std::pair{2, 1}, std::pair{1, 77},
                                         std::pair{77, 1}, std::pair{2, 2}, std::pair{2, 99}, std::pair{3, 3},
                                         std::pair{16384, 1}, std::pair{1, 16384}, std::pair{8192, 2}));

TEST(Vectorizer, AllTransparentIsAnEmptyMap) {
  const PlanarMap map = vectorized(Picture(9, 5, {200, 100, 7, 0}), {});
  EXPECT_TRUE(map.segments.empty());
  EXPECT_EQ(map.colours[map.lattice.pixel(4, 2)], Rgba{});
}

}  // namespace
}  // namespace depixel::test
