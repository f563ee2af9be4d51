#include "libdepixel/stages/splines.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "tests/support/map_segments.hpp"
#include "tests/support/map_splines.hpp"
#include "tests/support/random_pictures.hpp"

namespace depixel::test {
namespace {

std::vector<FreeSegment> segments_of(const Picture& picture, SplineKind spline, Smoothing smoothing) {
  Options options;
  options.spline = spline;
  options.smoothing = smoothing;
  Vectorizer vectorizer;
  return free_segments(vectorizer.vectorize(picture.view(), options));
}

/// A black bar of this length on white, one pixel high: a closed contour of 2 * length + 2 nodes.
Picture bar(int length) {
  Picture picture(length + 6, 7, palette_colour('.'));
  paste(picture, Picture(length, 1, palette_colour('#')), 3, 3);
  return picture;
}

TEST(Splines, AdaptiveInterpolatesClosedContoursOfFewerThanThirtyNodes) {
  for (const Smoothing smoothing : {Smoothing::average, Smoothing::none}) {
    const auto with = [&](int length, SplineKind kind) { return segments_of(bar(length), kind, smoothing); };
    EXPECT_EQ(with(13, SplineKind::adaptive), with(13, SplineKind::interpolate));  // 28 nodes
    EXPECT_NE(with(13, SplineKind::adaptive), with(13, SplineKind::approximate));
    EXPECT_EQ(with(14, SplineKind::adaptive), with(14, SplineKind::approximate));  // 30 nodes
    EXPECT_NE(with(14, SplineKind::adaptive), with(14, SplineKind::interpolate));
  }
}

TEST(Splines, AdaptiveApproximatesOpenContours) {
  const Picture picture = ascii_picture({"r....",  //
                                         "rr...",  //
                                         "rrr..",  //
                                         "rrr..",  //
                                         "rrrr."});
  EXPECT_EQ(segments_of(picture, SplineKind::adaptive, Smoothing::none),
            segments_of(picture, SplineKind::approximate, Smoothing::none));
  EXPECT_NE(segments_of(picture, SplineKind::adaptive, Smoothing::none),
            segments_of(picture, SplineKind::interpolate, Smoothing::none));
}

/// Figure pictures whose curves keep clear of all centres without help.
std::vector<Picture> calm_pictures() {
  return {bar(3), bar(9),
          ascii_picture({"......",  //
                         "..##..",  //
                         ".####.",  //
                         ".####.",  //
                         "..##..",  //
                         "......"})};
}

TEST(Splines, InterpolationGoesThroughTheNodes) {
  for (const Picture& picture : calm_pictures()) {
    Options options;
    options.spline = SplineKind::interpolate;
    options.smoothing = Smoothing::none;
    Vectorizer vectorizer;
    vectorizer.vectorize(picture.view(), options);
    for (const ReadCurve& curve : read_curves(vectorizer)) {
      for (std::size_t k = 0; k < curve.nodes.size(); ++k) {
        EXPECT_LE(glm::distance(curve.knots[k], curve.nodes[k]), 1.5 / 4096) << k;
      }
    }
  }
}

RC_GTEST_PROP(Splines, KnotsAreOneFourOneOfControlPoints, (const Picture& picture)) {
  // So a knot lies half-way between the inner points next to it: two thirds of the way from one control point
  // to its own, and one third from its own to the other. Not where a spline is broken: on the lattice corner,
  // where corners are round; sharp ones are Corners' own. And not at retracted segments.
  Options options = *random_lossless_options();
  options.corners = Corners::round;
  Vectorizer v;
  v.vectorize(picture.view(), options);
  const Contours& contours = v.contours();
  const auto segment_after = [&](int node) {
    return segment_along(v.map(), contours.corner[node], static_cast<Direction>(contours.heading[node]));
  };
  for (const Contour& c : contours.list) {
    for (int k = c.closed ? 0 : 1; k < c.step_count(); ++k) {
      const Segment before = segment_after(c.first + (k + c.count - 1) % c.count);
      const Segment after = segment_after(c.first + k);
      const glm::ivec2 corner = v.map().lattice.corner_position(contours.corner[c.first + k]) * kSubpixels;
      const glm::ivec2 off = glm::abs(before.p2 + after.p1 - 2 * after.p0);
      // All three points are rounded, control points before the inner ones.
      const bool is_smooth = off.x <= 4 && off.y <= 4;
      const bool is_retracted = before.p1 == before.p2 || after.p1 == after.p2;
      RC_ASSERT(is_smooth || is_retracted || after.p0 == corner);
    }
  }
}

TEST(Splines, CalmCurvesAreSmoothEverywhere) {
  for (const Picture& picture : calm_pictures()) {
    for (const SplineKind kind : {SplineKind::approximate, SplineKind::interpolate}) {
      Options options;
      options.spline = kind;
      options.smoothing = Smoothing::none;
      Vectorizer vectorizer;
      vectorizer.vectorize(picture.view(), options);
      for (const ReadCurve& curve : read_curves(vectorizer)) {
        // Where a segment arrives, the next one leaves in the same direction, and as fast.
        const std::size_t count = curve.knots.size();
        ASSERT_TRUE(curve.closed);
        for (std::size_t k = 0; k < count; ++k) {
          const auto control = [&](std::size_t i) { return curve.controls[(k + count + i) % count]; };
          const glm::dvec2 mean = (control(count - 1) + 4.0 * control(0) + control(1)) / 6.0;
          EXPECT_LE(glm::distance(curve.knots[k], mean), 6.0 / 4096);
        }
      }
    }
  }
}

TEST(Splines, ATJunctionEndsOnTheCurveThatGoesThrough) {
  // A staircase goes through; the line between r and g ends on it where the spline has moved off the corner.
  const Picture picture = ascii_picture({"rrrrrrr",  //
                                         "rrrrr##",  //
                                         "rrr####",  //
                                         "ggg####",  //
                                         "gg#####",  //
                                         "gg#####"});
  for (const SplineKind kind : {SplineKind::adaptive, SplineKind::approximate, SplineKind::interpolate}) {
    for (const Smoothing smoothing : {Smoothing::energy, Smoothing::average, Smoothing::none}) {
      Options options;
      options.spline = kind;
      options.smoothing = smoothing;
      Vectorizer v;
      v.vectorize(picture.view(), options);
      const auto curves = read_curves(v);
      int joined = 0;
      for (std::size_t c = 0; c < curves.size(); ++c) {
        if (curves[c].closed) continue;
        for (const glm::dvec2 end : {curves[c].knots.front(), curves[c].knots.back()}) {
          if (end.x == 0 || end.y == 0 || end.x == picture.width || end.y == picture.height) continue;
          for (std::size_t other = 0; other < curves.size(); ++other) {
            if (other == c) continue;
            const auto& knots = curves[other].knots;
            joined += static_cast<int>(std::count(knots.begin() + 1, knots.end() - 1, end));
          }
        }
      }
      EXPECT_EQ(joined, 1);
    }
  }
}

}  // namespace
}  // namespace depixel::test
