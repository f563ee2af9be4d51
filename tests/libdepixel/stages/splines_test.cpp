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
  // Everywhere but at ends, and where a spline is broken: there knot and control point coincide.
  Vectorizer v;
  v.vectorize(picture.view(), *random_lossless_options());
  const auto absolute = [&](const std::vector<glm::ivec2>& from_corner, int node) {
    return v.cells().lattice.corner_position(v.contours().corner[node]) * kSubpixels + from_corner[node];
  };
  for (const Contour& c : v.contours().list) {
    for (int k = c.closed ? 0 : 1; k < (c.closed ? c.count : c.count - 1); ++k) {
      const auto control = [&](int offset) {
        return absolute(v.splines().control, c.first + (k + offset + c.count) % c.count);
      };
      const glm::ivec2 six_knots = 6 * absolute(v.splines().knot, c.first + k);
      const glm::ivec2 off = glm::abs(control(-1) + 4 * control(0) + control(1) - six_knots);
      const bool is_smooth =
          off.x <= 9 && off.y <= 9;  // all four points are rounded by up to half a subpixel
      const bool is_broken = six_knots == 6 * control(0);
      RC_ASSERT(is_smooth || is_broken);
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
      for (const Segment& s : vectorizer.map().segments) {
        // The segment that follows leaves in the direction in which this one arrives, and as fast.
        for (const Segment& next : vectorizer.map().segments) {
          if (s.p3 != next.p0) continue;
          const glm::ivec2 kink = (s.p3 - s.p2) - (next.p1 - next.p0);
          EXPECT_LE(std::abs(kink.x) + std::abs(kink.y), 4);
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
