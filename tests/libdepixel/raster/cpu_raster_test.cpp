#include "libdepixel/raster/cpu_raster.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <glm/common.hpp>
#include <ostream>

#include "libdepixel/core/tolerances.hpp"
#include "libdepixel/pipeline/vectorizer.hpp"
#include "tests/support/map_sampler.hpp"
#include "tests/support/map_segments.hpp"
#include "tests/support/random_pictures.hpp"
#include "tests/support/test_pictures.hpp"

namespace depixel {

/// As RapidCheck shows it.
void showValue(const View& view, std::ostream& out) {
  out << "View{" << view.scale_x << ", " << view.scale_y << ", " << view.origin_x << ", " << view.origin_y
      << '}';
}

namespace test {
namespace {

Picture draw(const PlanarMap& map, const View& view, int width, int height, bool linear_light = false,
             int threads = 1) {
  Picture out(width, height, {1, 2, 3, 4});
  CpuRaster raster;
  raster.draw(map, view, linear_light, threads, out.target());
  return out;
}

/// A map without curves: every region is one pixel of the picture, told apart by axis-parallel lines.
PlanarMap square_map(const Picture& picture) {
  PlanarMap map;
  map.lattice = Lattice(picture.width, picture.height);
  map.colours.assign(map.lattice.size(), Rgba{});
  const auto line = [&](glm::ivec2 from, glm::ivec2 to, int left, int right) {
    from *= kSubpixels;
    to *= kSubpixels;
    map.segments.push_back({from, from + (to - from) / 3, to - (to - from) / 3, to, left, right});
  };
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      const int pixel = map.lattice.pixel(x, y);
      map.colours[pixel] = normalized(picture.at(x, y));
      if (x > 0) line({x, y}, {x, y + 1}, pixel, pixel - 1);
      if (y > 0) line({x, y}, {x + 1, y}, pixel - map.lattice.stride(), pixel);
    }
  }
  return map;
}

/// The map's curves replaced by their chords: still watertight, and nothing is left to flatten.
PlanarMap straightened(PlanarMap map) {
  for (Segment& s : map.segments) {
    s.p1 = s.p0 + (s.p3 - s.p0) / 3;
    s.p2 = s.p3 - (s.p3 - s.p0) / 3;
  }
  return map;
}

rc::Gen<View> random_view() {
  const auto scale = rc::gen::element(0.5, 1.0, 1.37, 2.0, 3.0, 4.25, 6.0);
  const auto origin = rc::gen::element(-2.5, 0.0, 0.125, 1.0, 3.3);
  return rc::gen::build<View>(rc::gen::set(&View::scale_x, scale), rc::gen::set(&View::scale_y, scale),
                              rc::gen::set(&View::origin_x, origin), rc::gen::set(&View::origin_y, origin));
}

struct SampleDifference {
  double largest = 0, mean = 0;
};

SampleDifference difference_from_samples(const Picture& drawn, const PlanarMap& map, const View& view,
                                         bool linear_light) {
  const std::vector<glm::dvec4> expected = sampled(map, view, linear_light, drawn.width, drawn.height);
  SampleDifference result;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const glm::dvec4 d = glm::abs(sample_of(drawn.pixels[i], linear_light) - expected[i]);
    for (int c = 0; c < 4; ++c) {
      result.largest = std::max(result.largest, d[c]);
      result.mean += d[c] / (4.0 * double(expected.size()));
    }
  }
  return result;
}

TEST(CpuRaster, SquarePixelsAtWholeScalesAreExact) {
  const Picture picture = ascii_picture({"r.R",  //
                                         "_#w",  //
                                         "gfk"});
  for (const int scale : {1, 3, 5}) {
    const Picture out = draw(square_map(picture), {double(scale), double(scale), 0, 0}, 3 * scale, 3 * scale);
    for (int y = 0; y < out.height; ++y) {
      for (int x = 0; x < out.width; ++x) {
        EXPECT_EQ(out.at(x, y), normalized(picture.at(x / scale, y / scale)))
            << scale << ": " << x << ',' << y;
      }
    }
  }
}

TEST(CpuRaster, HalfAPixelIsHalfTheColour) {
  // Black and white at 1.5: the middle of three pixels is half of each.
  const PlanarMap map = square_map(ascii_picture({"#."}));
  const Picture plain = draw(map, {1.5, 1, 0, 0}, 3, 1);
  EXPECT_EQ(plain.at(0, 0), (Rgba{0, 0, 0, 255}));
  EXPECT_EQ(plain.at(1, 0), (Rgba{128, 128, 128, 255}));
  EXPECT_EQ(plain.at(2, 0), (Rgba{255, 255, 255, 255}));
  EXPECT_EQ(draw(map, {1.5, 1, 0, 0}, 3, 1, true).at(1, 0), (Rgba{188, 188, 188, 255}));
}

TEST(CpuRaster, ACutCornerWeighsWhatItCovers) {
  // A white corner cut from a black pixel by a line through two sides' middles covers an eighth.
  PlanarMap map = square_map(ascii_picture({"#."}));
  map.segments.clear();
  const int half = kSubpixels / 2, black = map.lattice.pixel(0, 0), white = map.lattice.pixel(1, 0);
  const auto line = [&](glm::ivec2 from, glm::ivec2 to) {
    map.segments.push_back({from, from + (to - from) / 3, to - (to - from) / 3, to, white, black});
  };
  line({half, 0}, {kSubpixels, half});
  line({kSubpixels, half}, {kSubpixels, kSubpixels});
  const Picture out = draw(map, {1, 1, 0, 0}, 2, 1);
  EXPECT_EQ(out.at(0, 0), (Rgba{32, 32, 32, 255}));
  EXPECT_EQ(out.at(1, 0), (Rgba{255, 255, 255, 255}));
}

TEST(CpuRaster, TransparentPixelsHaveNoWeight) {
  // Red beside transparency: the pixel between has half the alpha and all the red.
  const Picture out = draw(square_map(ascii_picture({"r_"})), {1.5, 1, 0, 0}, 3, 1);
  EXPECT_EQ(out.at(0, 0), palette_colour('r'));
  EXPECT_EQ(out.at(1, 0), (Rgba{220, 30, 30, 128}));
  EXPECT_EQ(out.at(2, 0), Rgba{});
}

TEST(CpuRaster, SemiTransparencyIsKept) {
  const PlanarMap map = square_map(Picture(2, 2, palette_colour('R')));
  for (const bool linear_light : {false, true}) {
    const Picture out = draw(map, View::fit(map.lattice, 7, 5), 7, 5, linear_light);
    EXPECT_EQ(out, Picture(7, 5, palette_colour('R')));
  }
}

TEST(CpuRaster, AllTransparentIsAllZero) {
  EXPECT_EQ(draw(vectorized(Picture(5, 4, {9, 8, 7, 0})), {3, 3, 0, 0}, 15, 12), Picture(15, 12));
}

TEST(CpuRaster, OutsideTheFrameIsTransparent) {
  const Picture out = draw(square_map(Picture(2, 2, palette_colour('g'))), {2, 2, -1, -1}, 8, 8);
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 8; ++x) {
      const bool inside = x >= 2 && x < 6 && y >= 2 && y < 6;
      EXPECT_EQ(out.at(x, y), inside ? palette_colour('g') : Rgba{}) << x << ',' << y;
    }
  }
}

TEST(CpuRaster, ViewsWithoutAnyFrameAreEmpty) {
  const PlanarMap map = vectorized(ascii_picture({"#.",  //
                                                  ".#"}));
  for (const double away : {-100.0, 100.0}) {
    EXPECT_EQ(draw(map, {4, 4, away, 0}, 6, 6), Picture(6, 6));
    EXPECT_EQ(draw(map, {4, 4, 0, away}, 6, 6), Picture(6, 6));
  }
}

TEST(CpuRaster, PitchLeavesTheRestAlone) {
  const PlanarMap map = square_map(Picture(2, 2, palette_colour('g')));
  Picture wide(6, 2, palette_colour('b'));
  PictureView target = wide.target();
  target.width = 2;
  CpuRaster().draw(map, {1, 1, 0, 0}, false, 1, target);
  EXPECT_EQ(wide.at(1, 1), palette_colour('g'));
  EXPECT_EQ(wide.at(2, 0), palette_colour('b'));
  EXPECT_EQ(wide.at(5, 1), palette_colour('b'));
}

RC_GTEST_PROP(CpuRaster, RowsCloseOnAllSides, (const Picture& picture)) {
  // Colour changes of every row sum to zero, whatever was vectorized.
  const Options options = *random_options();
  const PlanarMap map = vectorized(picture, options);
  const double scale = *rc::gen::element(1.0, 2.0, 3.7);
  const int width = int(std::ceil((picture.width + 2) * scale)) + 2;
  const int height = int(std::ceil((picture.height + 2) * scale)) + 2;
  const Picture out = draw(map, {scale, scale, -1, -1}, width, height, options.linear_light);
  const int inner_right = int(std::ceil((picture.width + 1) * scale));
  const int inner_bottom = int(std::ceil((picture.height + 1) * scale));
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const bool outside = x + 1 <= scale || y + 1 <= scale || x >= inner_right || y >= inner_bottom;
      if (outside) RC_ASSERT(out.at(x, y) == Rgba{});
    }
  }
}

/// What straight lines may differ by: their ends are rounded to 1/256 pixel, twice where a row or column cuts
/// them, and the samples' lines lie 1/64 pixel apart; in levels, and one for rounding colours.
constexpr double kStraightTolerance = 255 * (4.0 / kRasterSubpixels + 0.5 / 64) + 1;
/// What a curve adds: it may stray from its flattened self; where every pixel holds a curve, an eighth of
/// that on average.
constexpr double kCurveTolerance = 255.0 * kFlatteningTolerance;

RC_GTEST_PROP(CpuRaster, StraightLinesEqualSamples, (const Picture& picture)) {
  const View view = *random_view();
  const bool linear_light = *rc::gen::arbitrary<bool>();
  const PlanarMap map = straightened(vectorized(picture));
  const Picture drawn = draw(map, view, 37, 29, linear_light);
  const SampleDifference difference = difference_from_samples(drawn, map, view, linear_light);
  const double lines_in_a_pixel = std::max(1.0, 2 / std::min(view.scale_x, view.scale_y));
  RC_LOG() << "largest " << difference.largest << " mean " << difference.mean << '\n';
  RC_ASSERT(difference.largest <= kStraightTolerance * lines_in_a_pixel);
  RC_ASSERT(difference.mean <= 1);
}

RC_GTEST_PROP(CpuRaster, CurvesEqualSamples, (const Picture& picture)) {
  const View view = *random_view();
  const Options options = *random_options();
  PlanarMap map = vectorized(picture, options);
  map.shading = {};
  const Picture drawn = draw(map, view, 37, 29, options.linear_light);
  const SampleDifference difference = difference_from_samples(drawn, map, view, options.linear_light);
  const double lines_in_a_pixel = std::max(1.0, 2 / std::min(view.scale_x, view.scale_y));
  RC_LOG() << "largest " << difference.largest << " mean " << difference.mean << '\n';
  RC_ASSERT(difference.largest <= (kStraightTolerance + kCurveTolerance) * lines_in_a_pixel);
  RC_ASSERT(difference.mean <= kCurveTolerance / 8);
}

TEST(CpuRaster, AlphaDoesNotWrapWhereCurvesOverlap) {
  const PlanarMap map = vectorized(ascii_picture({".........", "..._###_.", "...#...#.", "........."}),
                                   {.spline = SplineKind::adaptive});
  const View view{0.5, 5.75, -5, -5};
  const Picture drawn = draw(map, view, 9, 40);
  const auto samples = sampled(map, view, false, 9, 40);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    EXPECT_NEAR(drawn.pixels[i].a, std::min(samples[i].a, 255.0), kStraightTolerance + kCurveTolerance) << i;
  }
}

RC_GTEST_PROP(CpuRaster, AViewIsACropOfTheWhole, (const Picture& picture)) {
  // At a whole scale, views that start at whole output pixels show the same as the whole picture does there.
  const int scale = *rc::gen::element(1, 2, 4);
  const bool linear_light = *rc::gen::arbitrary<bool>();
  const PlanarMap map = vectorized(picture);
  const Picture whole = draw(map, {double(scale), double(scale), 0, 0}, picture.width * scale,
                             picture.height * scale, linear_light);
  const int x0 = *rc::gen::inRange(0, picture.width), y0 = *rc::gen::inRange(0, picture.height);
  const Picture part = draw(map, {double(scale), double(scale), double(x0), double(y0)}, 9, 7, linear_light);
  Picture expected(9, 7);
  paste(expected, whole, -x0 * scale, -y0 * scale);
  // Where the view cuts a line, its crossing is rounded to 1/256 pixel.
  RC_ASSERT(compare(expected, part).largest <= (linear_light ? 16 : 2));
}

RC_GTEST_PROP(CpuRaster, FourPixelsAddUpToOne, (const Picture& picture)) {
  // Box filtering is additive: the mean of 2x2 pixels at twice the scale is the pixel at the scale.
  const PlanarMap map = straightened(vectorized(picture));
  const Picture fine = draw(map, {6, 6, 0, 0}, 6 * picture.width, 6 * picture.height);
  const Picture coarse = draw(map, {3, 3, 0, 0}, 3 * picture.width, 3 * picture.height);
  for (int y = 0; y < coarse.height; ++y) {
    for (int x = 0; x < coarse.width; ++x) {
      glm::dvec4 sum(0);
      for (const auto& [dx, dy] : {std::pair{0, 0}, {1, 0}, {0, 1}, {1, 1}}) {
        sum += sample_of(fine.at(2 * x + dx, 2 * y + dy), false);
      }
      const glm::dvec4 d = glm::abs(sum / 4.0 - sample_of(coarse.at(x, y), false));
      RC_ASSERT(std::max(std::max(d.x, d.y), std::max(d.z, d.w)) <= 4);
    }
  }
}

RC_GTEST_PROP(CpuRaster, ThreadsAndBuffersLeaveNoTrace, (const Picture& picture, const Picture& other)) {
  const PlanarMap map = vectorized(picture), other_map = vectorized(other);
  const View view = *random_view();
  const bool linear_light = *rc::gen::arbitrary<bool>();
  const Picture expected = draw(map, view, 41, 70, linear_light);
  for (const int threads : {2, 3, 16}) RC_ASSERT(draw(map, view, 41, 70, linear_light, threads) == expected);
  CpuRaster reused;
  Picture scratch(90, 20), again(41, 70);
  reused.draw(other_map, {4, 4, 0, 0}, false, 1, scratch.target());
  reused.draw(map, view, linear_light, 1, again.target());
  RC_ASSERT(again == expected);
}

RC_GTEST_PROP(CpuRaster, DrawsTheSameByEdgeAsFromAList, (const Picture& picture)) {
  Vectorizer vectorizer;
  const PlanarMap& list = vectorizer.vectorize(picture.view(), *random_options());
  View view = *random_view();
  view.scale_y *= *rc::gen::element(1.0, 0.01, 20.0);
  const bool linear_light = *rc::gen::arbitrary<bool>();
  Picture by_edge(41, 70, {1, 2, 3, 4});
  CpuRaster().draw(vectorizer.by_edge(), view, linear_light, 1, by_edge.target());
  RC_ASSERT(by_edge == draw(list, view, 41, 70, linear_light));
}

TEST(CpuRaster, EmptyTargetsAreLeftAlone) {
  const PlanarMap map = square_map(Picture(2, 2, palette_colour('g')));
  CpuRaster().draw(map, {1, 1, 0, 0}, false, 1, {nullptr, 0, 5, 0});
  CpuRaster().draw(map, {1, 1, 0, 0}, false, 1, {nullptr, 5, 0, 0});
}

}  // namespace
}  // namespace test
}  // namespace depixel
