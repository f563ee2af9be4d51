#include "libdepixel/stages/smoothing.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <glm/geometric.hpp>

#include "tests/support/ascii_picture.hpp"
#include "tests/support/map_splines.hpp"

namespace depixel::test {
namespace {

std::vector<ReadCurve> smoothed_curves(const Picture& picture, Smoothing smoothing,
                                       SplineKind spline = SplineKind::approximate) {
  Options options;
  options.smoothing = smoothing;
  options.spline = spline;
  Vectorizer vectorizer;
  vectorizer.vectorize(picture.view(), options);
  return read_curves(vectorizer);
}

/// Black on white: a square on its corner, less its tips: an outline of staircases of single steps and four
/// level stretches.
Picture diamond(int radius) {
  Picture picture(2 * radius + 5, 2 * radius + 5, palette_colour('.'));
  const int centre = radius + 2;
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      const int dx = std::abs(x - centre), dy = std::abs(y - centre);
      if (dx + dy <= radius && std::max(dx, dy) < radius - 1) picture.at(x, y) = palette_colour('#');
    }
  }
  return picture;
}

Picture disc(int diameter) {
  Picture picture(diameter + 4, diameter + 4, palette_colour('.'));
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      const int dx = 2 * x + 1 - picture.width, dy = 2 * y + 1 - picture.height;
      if (dx * dx + dy * dy < diameter * diameter) picture.at(x, y) = palette_colour('#');
    }
  }
  return picture;
}

/// A line that falls by one pixel every third one.
Picture slope() {
  Picture picture(30, 14, palette_colour('.'));
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      if (y >= 2 + x / 3) picture.at(x, y) = palette_colour('#');
    }
  }
  return picture;
}

/// Sum of squared second differences of a curve's control points.
double bending(const ReadCurve& curve) {
  const auto n = static_cast<int>(curve.controls.size());
  double sum = 0;
  for (int k = curve.closed ? 0 : 1; k < (curve.closed ? n : n - 1); ++k) {
    const glm::dvec2 d =
        curve.controls[(k + n - 1) % n] - 2.0 * curve.controls[k] + curve.controls[(k + 1) % n];
    sum += glm::dot(d, d);
  }
  return sum;
}

TEST(Smoothing, NoneLeavesNodesWhereTheCellGraphHasThem) {
  for (const Picture& picture : {diamond(5), disc(9), slope()}) {
    for (const ReadCurve& curve : smoothed_curves(picture, Smoothing::none)) {
      for (std::size_t k = 0; k < curve.nodes.size(); ++k) {
        EXPECT_LE(glm::distance(curve.controls[k], curve.nodes[k]), kReadBackTolerance) << k;
      }
    }
  }
}

TEST(Smoothing, StraightLinesStayWhereTheyAre) {
  const Picture picture = ascii_picture({"rrr...",  //
                                         "rrr...",  //
                                         "rrr...",  //
                                         "rrr...",  //
                                         "rrr...",  //
                                         "rrr..."});
  for (const Smoothing smoothing : {Smoothing::energy, Smoothing::average, Smoothing::none}) {
    for (const ReadCurve& curve : smoothed_curves(picture, smoothing)) {
      for (const glm::dvec2 knot : curve.knots) EXPECT_EQ(knot.x, 3);
    }
  }
}

TEST(Smoothing, StaircasesBendLess) {
  for (const Picture& picture : {disc(8), disc(13), disc(20), slope()}) {
    const auto none = smoothed_curves(picture, Smoothing::none);
    for (const Smoothing smoothing : {Smoothing::energy, Smoothing::average}) {
      const auto smoothed = smoothed_curves(picture, smoothing);
      ASSERT_EQ(smoothed.size(), 1u);
      EXPECT_LT(bending(smoothed[0]), 0.6 * bending(none[0]));
    }
  }
}

TEST(Smoothing, OpenContoursForgetTheContoursBefore) {
  // The bending of a square in a frame seen before must not bow the only contour of this one.
  const Picture before = ascii_picture({".....",  //
                                        ".##..",  //
                                        ".##..",  //
                                        ".....",  //
                                        "....."});
  Vectorizer vectorizer;
  vectorizer.vectorize(before.view(), {});
  vectorizer.vectorize(ascii_picture({"#.",  //
                                      "#."})
                           .view(),
                       {});
  const auto curves = read_curves(vectorizer);
  ASSERT_EQ(curves.size(), 1u);
  for (const glm::dvec2 knot : curves[0].knots) EXPECT_EQ(knot.x, 1);
}

TEST(Smoothing, ASlopeBecomesAStraightLine) {
  // Away from the ends, the curve keeps within a tenth of a pixel of the line through the middles of the
  // steps.
  const auto curves = smoothed_curves(slope(), Smoothing::energy);
  ASSERT_EQ(curves.size(), 1u);
  for (const glm::dvec2 knot : curves[0].knots) {
    if (knot.x < 6 || knot.x > 24) continue;
    EXPECT_NEAR(knot.y, 1.5 + knot.x / 3, 0.1) << knot.x;
  }
}

TEST(Smoothing, LeastBendingRestoresTheCornersOfASquare) {
  Picture picture(12, 12, palette_colour('.'));
  paste(picture, Picture(6, 6, palette_colour('#')), 3, 3);
  const auto curves = smoothed_curves(picture, Smoothing::energy);
  ASSERT_EQ(curves.size(), 1u);
  for (const glm::dvec2 corner : {glm::dvec2(3, 3), glm::dvec2(9, 3), glm::dvec2(9, 9), glm::dvec2(3, 9)}) {
    const auto& knots = curves[0].knots;
    EXPECT_NE(std::find(knots.begin(), knots.end(), corner), knots.end()) << corner.x << ',' << corner.y;
  }
}

TEST(Smoothing, AveragingIsTheThesissFormula) {
  // No right angle here has two arms of two steps or more: every control point is averaged in every round.
  const auto none = smoothed_curves(diamond(7), Smoothing::none),
             averaged = smoothed_curves(diamond(7), Smoothing::average);
  ASSERT_EQ(averaged.size(), 1u);
  std::vector<glm::dvec2> expected = none[0].nodes;
  const std::size_t n = expected.size();
  const int rounds = std::min(1 + static_cast<int>(n) / 20, 10);
  EXPECT_EQ(rounds, 3);
  for (int round = 0; round < rounds; ++round) {
    std::vector<glm::dvec2> next(n);
    for (std::size_t k = 0; k < n; ++k) {
      next[k] = 0.25 * expected[(k + n - 1) % n] + 0.5 * expected[k] + 0.25 * expected[(k + 1) % n];
    }
    expected = next;
  }
  for (std::size_t k = 0; k < n; ++k) {
    EXPECT_LE(glm::distance(averaged[0].controls[k], expected[k]), kReadBackTolerance) << k;
  }
}

TEST(Smoothing, AveragingKeepsTheCornersOfASquare) {
  Picture picture(12, 12, palette_colour('.'));
  paste(picture, Picture(6, 6, palette_colour('#')), 3, 3);
  const auto none = smoothed_curves(picture, Smoothing::none),
             averaged = smoothed_curves(picture, Smoothing::average);
  ASSERT_EQ(averaged.size(), 1u);
  for (std::size_t k = 0; k < none[0].nodes.size(); ++k) {
    const glm::dvec2 node = none[0].nodes[k];
    if ((node.x != 3.25 && node.x != 8.75) || (node.y != 3.25 && node.y != 8.75)) continue;
    EXPECT_LE(glm::distance(averaged[0].controls[k], node), kReadBackTolerance) << k;
  }
}

}  // namespace
}  // namespace depixel::test
