#include "libdepixel/pipeline/verify.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <glm/common.hpp>

#include "libdepixel/core/tolerances.hpp"
#include "libdepixel/pipeline/vectorizer.hpp"
#include "libdepixel/raster/cpu_raster.hpp"
#include "tests/support/map_sampler.hpp"
#include "tests/support/random_pictures.hpp"

namespace depixel::test {
namespace {

constexpr int kPixelSide = kSubpixels, kHalf = kSubpixels / 2;

/// A map of a two-coloured picture, 3x2 pixels, whose regions are divided by curves that a test draws: east
/// of them, when they go down, lies what pixel (2, 0) shows, west of them what pixel (0, 0) shows.
struct HandMade {
  SimilarityGraph graph;
  PlanarMap map;

  HandMade() {
    build_similarity_graph(ascii_picture({"##.",  //
                                          "##."})
                               .view(),
                           {}, graph);
    map.lattice = graph.lattice;
    map.colours = graph.pixels;
  }
  void curve(glm::ivec2 p0, glm::ivec2 p1, glm::ivec2 p2, glm::ivec2 p3) {
    map.segments.push_back({p0, p1, p2, p3, map.lattice.pixel(2, 0), map.lattice.pixel(0, 0)});
  }
  void line(glm::ivec2 from, glm::ivec2 to) { curve(from, from + (to - from) / 3, to - (to - from) / 3, to); }

  CentreReport verify() const { return verify_centres(map, graph); }
};

TEST(VerifyCentres, AStraightEdgeLosesNothing) {
  HandMade made;
  made.line({2 * kPixelSide, 0}, {2 * kPixelSide, 2 * kPixelSide});
  const CentreReport report = made.verify();
  EXPECT_EQ(report.pixels, 6);
  EXPECT_EQ(report.lost, 0);
  EXPECT_EQ(report.first_lost_x, -1);
  EXPECT_DOUBLE_EQ(report.nearest, 0.5);
}

TEST(VerifyCentres, DirectionDoesNotMatter) {
  HandMade made;
  made.line({2 * kPixelSide, 2 * kPixelSide}, {2 * kPixelSide, 0});
  std::swap(made.map.segments[0].left, made.map.segments[0].right);
  EXPECT_EQ(made.verify().lost, 0);
}

TEST(VerifyCentres, AMissingEdgeLosesWhatItHid) {
  const CentreReport report = HandMade().verify();
  EXPECT_EQ(report.lost, 2);
  EXPECT_EQ(report.first_lost_x, 2);
  EXPECT_EQ(report.first_lost_y, 0);
  EXPECT_EQ(report.nearest, std::numeric_limits<double>::infinity());
}

TEST(VerifyCentres, AnEdgeThatPassesACentreLosesIt) {
  HandMade made;
  made.line({2 * kPixelSide, 0}, {2 * kPixelSide, kPixelSide});
  made.line({2 * kPixelSide, kPixelSide},
            {kPixelSide + kPixelSide / 4, kPixelSide});  // level: between two rows of centres
  made.line({kPixelSide + kPixelSide / 4, kPixelSide},
            {kPixelSide + kPixelSide / 4, 2 * kPixelSide});  // a quarter west of centre (1, 1)
  const CentreReport report = made.verify();
  EXPECT_EQ(report.lost, 1);
  EXPECT_EQ(report.first_lost_x, 1);
  EXPECT_EQ(report.first_lost_y, 1);
  EXPECT_DOUBLE_EQ(report.nearest, 0.25);
}

TEST(VerifyCentres, NearestIsMeasuredToTheCurveNotToItsControlPoints) {
  // The arch x = 1.75 + 3 t (1 - t) / 4 .. reaches x = 1.5 + 1/16 in its middle, 1/16 east of centre (1, 0).
  HandMade made;
  const int edge = 2 * kPixelSide, middle = kPixelSide + kHalf + kPixelSide / 16;
  const int control = edge - (edge - middle) * 4 / 3;
  made.curve({edge, 0}, {control, kPixelSide / 3}, {control, kPixelSide - kPixelSide / 3},
             {edge, kPixelSide});
  made.line({edge, kPixelSide}, {edge, 2 * kPixelSide});
  const CentreReport report = made.verify();
  EXPECT_EQ(report.lost, 0);
  EXPECT_NEAR(report.nearest, 1 / 16.0, 1.0 / kSubpixels);
}

TEST(VerifyCentres, EndsOnACentreLineCountOnce) {
  // Knots exactly at the height of the centres, reached from above and from below.
  HandMade made;
  const int x = 2 * kPixelSide;
  made.line({x, 0}, {x, kHalf});
  made.line({x, kHalf}, {x + kPixelSide / 8, kHalf});
  made.line({x + kPixelSide / 8, kHalf}, {x + kPixelSide / 8, kPixelSide + kHalf});
  made.line({x + kPixelSide / 8, kPixelSide + kHalf}, {x, 2 * kPixelSide});
  EXPECT_EQ(made.verify().lost, 0);
}

TEST(VerifyCentres, ATouchOfACentreLineChangesNothing) {
  // From both sides: a curve that comes down to the centre line and goes back up, and one that comes up to
  // it.
  for (const int away : {-kHalf, kHalf}) {
    HandMade made;
    made.line({2 * kPixelSide, 0}, {2 * kPixelSide, 2 * kPixelSide});
    const glm::ivec2 touch(kPixelSide, kHalf);
    // The middle of the cubic lies three quarters of the way to the inner control points.
    made.curve(touch + glm::ivec2(-kHalf / 2, away), touch + glm::ivec2(-kHalf / 4, -away / 3),
               touch + glm::ivec2(kHalf / 4, -away / 3), touch + glm::ivec2(kHalf / 2, away));
    made.line(touch + glm::ivec2(kHalf / 2, away), touch + glm::ivec2(-kHalf / 2, away));
    EXPECT_EQ(made.verify().lost, 0) << away;
  }
}

TEST(VerifyCentres, AnSCurveCrossesALineThreeTimes) {
  // Down past the line, up over it, and down again, all between two centres.
  HandMade made;
  const glm::ivec2 top(2 * kPixelSide - kPixelSide / 4, 0),
      bottom(2 * kPixelSide + kPixelSide / 4, kPixelSide);
  made.curve(top, {2 * kPixelSide, 3 * kPixelSide}, {2 * kPixelSide, -2 * kPixelSide}, bottom);
  made.line(bottom, {2 * kPixelSide, 2 * kPixelSide});
  EXPECT_EQ(made.verify().lost, 0);
}

TEST(VerifyCentres, CurvesOutsideTheFrameAreHarmless) {
  HandMade made;
  made.line({2 * kPixelSide, 0}, {2 * kPixelSide, 2 * kPixelSide});
  made.line({9 * kPixelSide, -5 * kPixelSide}, {9 * kPixelSide, 7 * kPixelSide});
  made.line({0, -5 * kPixelSide}, {3 * kPixelSide, -5 * kPixelSide});
  EXPECT_EQ(made.verify().lost, 0);
}

TEST(VerifyCentres, MergingLosesWhatItRepaints) {
  Vectorizer vectorizer;
  Options options;
  options.similarity = Similarity::merge;
  options.merge_luma = 48;
  const PlanarMap& map = vectorizer.vectorize(ascii_picture({"555",  //
                                                             "545",  //
                                                             "555"})
                                                  .view(),
                                              options);
  const CentreReport report = verify_centres(map, vectorizer.graph());
  EXPECT_EQ(report.lost, 1);
  EXPECT_EQ(report.first_lost_x, 1);
  EXPECT_EQ(report.first_lost_y, 1);
}

TEST(VerifyCentres, GradientsShowWhatMergingRepaints) {
  const Picture picture = ascii_picture({"555",  //
                                         "545",  //
                                         "555"});
  Options options{.similarity = Similarity::merge, .merge_luma = 48};
  const auto lost = [&](ShadingKind shading) {
    options.shading = shading;
    Vectorizer vectorizer;
    return verify_centres(vectorizer.vectorize(picture.view(), options), vectorizer.graph()).lost;
  };
  EXPECT_EQ(lost(ShadingKind::gradient), 0);
  EXPECT_EQ(lost(ShadingKind::blur), 1);  // the regions' colours are judged
}

/// Gradients or not: curves that come to centres lose them. Draws each centre alone, much enlarged.
RC_GTEST_PROP(VerifyCentres, CountsWhatGradientsShow, (Picture picture)) {
  Options options{.similarity = Similarity::merge, .merge_luma = 48, .shading = ShadingKind::gradient};
  options.connect_lines = *rc::gen::arbitrary<bool>();
  options.soft_contours = *rc::gen::element(0, 30);
  Vectorizer vectorizer;
  PlanarMap map = vectorizer.vectorize(picture.view(), options);
  const int shift = *rc::gen::element(0, kPixelSide / 3, kPixelSide * 2 / 3);
  for (Segment& s : map.segments) {
    for (glm::ivec2* p : {&s.p0, &s.p1, &s.p2, &s.p3}) p->x += shift;
  }
  const CentreReport report = verify_centres(map, vectorizer.graph());
  constexpr double kScale = 2048;
  RC_PRE(report.nearest >= 1 / kScale);
  int lost = 0;
  CpuRaster raster;
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      Picture seen(1, 1);
      raster.draw(map, View{kScale, kScale, x + 0.5, y + 0.5}, false, 1, seen.target());
      lost += seen.at(0, 0) != normalized(picture.at(x, y)) ? 1 : 0;
    }
  }
  RC_ASSERT(report.lost == lost);
}

TEST(VerifyCentres, TransparentPixelsHaveAColourToo) {
  Vectorizer vectorizer;
  const Picture picture = ascii_picture({"_r_",  //
                                         "R_k"});
  EXPECT_EQ(verify_centres(vectorizer.vectorize(picture.view(), {}), vectorizer.graph()).lost, 0);
}

/// Moves all curves of a random map aside and looks at the same centres by sampling.
RC_GTEST_PROP(VerifyCentres, CountsWhatSamplingSees, (Picture picture)) {
  Vectorizer vectorizer;
  PlanarMap map = vectorizer.vectorize(picture.view(), *random_lossless_options());
  const int shift = *rc::gen::element(0, kPixelSide / 3, kPixelSide * 2 / 3, kPixelSide);
  for (Segment& s : map.segments) {
    for (glm::ivec2* p : {&s.p0, &s.p1, &s.p2, &s.p3}) p->x += shift;
  }
  const CentreReport report = verify_centres(map, vectorizer.graph());
  // Output pixels of 1/64 source pixel round each centre; each all of one colour if no curve is that near.
  constexpr double kScale = 64;
  RC_PRE(report.nearest >= 1 / kScale);
  int lost = 0;
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      const View view{kScale, kScale, x + 0.5 - 0.5 / kScale, y + 0.5 - 0.5 / kScale};
      const glm::dvec4 seen = sampled(map, view, false, 1, 1)[0];
      const glm::dvec4 d = glm::abs(seen - sample_of(normalized(picture.at(x, y)), false));
      const double difference = d.x + d.y + d.z + d.w;
      lost += difference > 1e-6 ? 1 : 0;
    }
  }
  RC_ASSERT(report.lost == lost);
}

}  // namespace
}  // namespace depixel::test
